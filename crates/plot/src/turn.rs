//! Values over one turn of the azimuth: closed curves, parted where there is no value.

use crate::series::Series;

/// Greatest angle between the drawn points of a curve, degrees.
pub(crate) const CHORD_DEG: f64 = 2.0;

/// An azimuth within [0°, 360°).
pub(crate) fn within(phi_deg: f64) -> f64 {
    phi_deg.rem_euclid(360.0) % 360.0
}

/// The points of a closed curve: sorted by azimuth in [0°, 360°), one value for each, the first repeated at the end a
/// turn later.
pub(crate) fn closed(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut turn: Vec<(f64, f64)> = points.iter().map(|(phi, value)| (within(*phi), *value)).collect();
    turn.sort_by(|a, b| a.0.total_cmp(&b.0));
    // 0° and 360° may both be given.
    turn.dedup_by(|next, kept| next.0 - kept.0 < 1e-9);
    if let Some(&(phi, value)) = turn.first() {
        turn.push((phi + 360.0, value));
    }
    turn
}

/// A closed curve in runs that go over no azimuth of `gaps`; one run that ends where it starts if there is none.
///
/// A run may begin before the end of a turn and end after it.
pub(crate) fn runs(points: &[(f64, f64)], gaps: &[f64]) -> Vec<Vec<(f64, f64)>> {
    let turn = closed(points);
    if gaps.is_empty() || turn.is_empty() {
        return if turn.is_empty() { Vec::new() } else { vec![turn] };
    }
    let gaps: Vec<f64> = gaps.iter().map(|phi| within(*phi)).collect();
    let parted = |from: f64, to: f64| gaps.iter().any(|g| [*g, g + 360.0].iter().any(|g| *g > from && *g < to));
    let mut all: Vec<Vec<(f64, f64)>> = Vec::new();
    for (k, point) in turn.iter().enumerate() {
        match all.last_mut() {
            Some(run) if !parted(turn[k - 1].0, point.0) => run.push(*point),
            _ => all.push(vec![*point]),
        }
    }
    // The last point is the first one a turn later: what follows it continues there.
    if all.len() > 1 {
        let first = all.remove(0);
        if let Some(last) = all.last_mut() {
            last.extend(first.into_iter().skip(1).map(|(phi, value)| (phi + 360.0, value)));
        }
    }
    all
}

/// A run with points between those given, at most `CHORD_DEG` apart.
pub(crate) fn filled(run: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut curve: Vec<(f64, f64)> = run.first().copied().into_iter().collect();
    for pair in run.windows(2) {
        let ((from, a), (to, b)) = (pair[0], pair[1]);
        let parts = ((to - from) / CHORD_DEG).ceil().max(1.0) as usize;
        curve.extend((1..parts).map(|k| {
            let t = k as f64 / parts as f64;
            (from + t * (to - from), a + t * (b - a))
        }));
        curve.push((to, b));
    }
    curve
}

/// The runs of a series as they lie between 0° and 360°: cut there, with the value between neighbours on both sides.
pub(crate) fn unrolled(points: &[(f64, f64)], gaps: &[f64]) -> Vec<Vec<(f64, f64)>> {
    let mut all = Vec::new();
    for run in runs(points, gaps) {
        let (mut before, mut after) = (Vec::new(), Vec::new());
        for (k, &(phi, value)) in run.iter().enumerate() {
            let crossed = k > 0 && run[k - 1].0 < 360.0 && phi > 360.0;
            if crossed {
                let (from, a) = run[k - 1];
                let end = a + (360.0 - from) / (phi - from) * (value - a);
                before.push((360.0, end));
                after.push((0.0, end));
            }
            match phi {
                _ if phi < 360.0 => before.push((phi, value)),
                // Both ends of the axis, where the run has more on both sides.
                _ if phi == 360.0 => {
                    before.extend((k > 0).then_some((360.0, value)));
                    after.extend((k + 1 < run.len() || k == 0).then_some((0.0, value)));
                }
                _ => after.push((phi - 360.0, value)),
            }
        }
        let closes = run.len() > 1 && run[run.len() - 1].0 - run[0].0 >= 360.0;
        if closes && !after.is_empty() {
            // The last point is the first one again.
            after.pop();
            after.append(&mut before);
        }
        all.extend([after, before].into_iter().filter(|part| !part.is_empty()));
    }
    all
}

/// The band of a series as outlines of areas in runs: lower edge there, upper edge back.
pub(crate) fn bands(
    series: &Series,
    part: impl Fn(&[(f64, f64)]) -> Vec<Vec<(f64, f64)>>,
) -> Vec<[Vec<(f64, f64)>; 2]> {
    let edge =
        |of: fn(&(f64, f64, f64)) -> f64| part(&series.band.iter().flatten().map(|e| (e.0, of(e))).collect::<Vec<_>>());
    edge(|e| e.1).into_iter().zip(edge(|e| e.2)).map(|(lower, upper)| [lower, upper]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn balls(count: usize) -> Vec<(f64, f64)> {
        (0..count)
            .map(|k| 360.0 * k as f64 / count as f64)
            .map(|phi| (phi, 9.0 + 3.0 * phi.to_radians().cos()))
            .collect()
    }

    #[test]
    fn identity_closed_curve_ends_where_it_starts() {
        let mut given = balls(13);
        given.rotate_left(5);
        given.push((360.0, 12.0));
        let turn = closed(&given);
        assert_eq!(turn.len(), 14);
        assert_eq!(turn[0].1, turn[13].1);
        assert_eq!(turn[13].0 - turn[0].0, 360.0);
        assert!(turn.windows(2).all(|pair| pair[0].0 < pair[1].0));
    }

    #[test]
    fn limit_a_constant_is_a_circle() {
        let turn = closed(&balls(13).iter().map(|(phi, _)| (*phi, 5.0)).collect::<Vec<_>>());
        let curve = filled(&turn);
        assert!(curve.iter().all(|(_, value)| *value == 5.0));
        assert!(curve.windows(2).all(|pair| pair[1].0 - pair[0].0 <= CHORD_DEG + 1e-9));
    }

    #[test]
    fn limit_no_run_goes_over_a_gap() {
        let azimuths = |runs: Vec<Vec<(f64, f64)>>| -> Vec<Vec<f64>> {
            runs.into_iter().map(|run| run.into_iter().map(|p| p.0).collect()).collect()
        };
        let points: Vec<(f64, f64)> = [0.0, 60.0, 300.0].map(|phi| (phi, 1.0)).to_vec();
        assert_eq!(azimuths(runs(&points, &[120.0, 180.0, 240.0])), [[300.0, 360.0, 420.0]]);
        assert_eq!(azimuths(runs(&points, &[])), [[0.0, 60.0, 300.0, 360.0]]);
        assert_eq!(azimuths(runs(&points, &[30.0, 330.0])), [vec![60.0, 300.0], vec![360.0]]);
        assert_eq!(azimuths(runs(&points[1..2], &[0.0])), [[420.0]]);
        assert_eq!(azimuths(unrolled(&points, &[180.0])), [vec![0.0, 60.0], vec![300.0, 360.0]]);
        assert_eq!(azimuths(unrolled(&points[..2], &[180.0])), [[0.0, 60.0]]);
        assert!(runs(&[], &[10.0]).is_empty());
    }

    #[test]
    fn identity_an_unrolled_curve_has_one_value_at_both_ends() {
        let shifted: Vec<(f64, f64)> = balls(13).into_iter().map(|(phi, v)| (phi + 11.0, v)).collect();
        let all = unrolled(&shifted, &[]);
        assert_eq!(all.len(), 1);
        let (first, last) = (all[0][0], all[0][all[0].len() - 1]);
        assert_eq!((first.0, last.0), (0.0, 360.0));
        assert_eq!(first.1, last.1);
        assert!(all[0].windows(2).all(|pair| pair[0].0 < pair[1].0) && all[0].len() == 15);
    }
}
