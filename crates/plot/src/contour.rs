//! Lines of equal value through a grid of values.

/// A line from one place to another.
pub(crate) type Segment = [[f64; 2]; 2];

/// Pieces of the line of a level through a grid: `x` and `y` are where its columns and rows lie, `value` that of a
/// column and a row.
///
/// Between neighbours values are linear; quadrilaterals with a corner without a value are left out. Where two corners
/// across are above the level and two below, the mean of all four decides which of them belong together.
pub(crate) fn segments(x: &[f64], y: &[f64], value: impl Fn(usize, usize) -> Option<f64>, level: f64) -> Vec<Segment> {
    let mut all = Vec::new();
    for row in 1..y.len() {
        for column in 1..x.len() {
            // Round the quadrilateral.
            let corners = [(column - 1, row - 1), (column, row - 1), (column, row), (column - 1, row)];
            let Some(values) = corners.iter().map(|(i, j)| value(*i, *j)).collect::<Option<Vec<f64>>>() else {
                continue;
            };
            let places = corners.map(|(i, j)| [x[i], y[j]]);
            let crossing = |edge: usize| -> Option<[f64; 2]> {
                let (a, b) = (edge, (edge + 1) % 4);
                let part = (level - values[a]) / (values[b] - values[a]);
                let at = |k: usize| places[a][k] + part * (places[b][k] - places[a][k]);
                ((values[a] >= level) != (values[b] >= level)).then(|| [at(0), at(1)])
            };
            let crossed: Vec<[f64; 2]> = (0..4).filter_map(crossing).collect();
            match crossed[..] {
                [a, b] => all.push([a, b]),
                [a, b, c, d] => {
                    let middle = values.iter().sum::<f64>() / 4.0 >= level;
                    let with_first = middle == (values[0] >= level);
                    all.extend(if with_first { [[a, b], [c, d]] } else { [[d, a], [b, c]] });
                }
                _ => {}
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_plane_has_straight_lines_where_it_takes_the_level() {
        let (x, y) = ([0.0, 1.0, 2.0, 4.0], [0.0, 3.0, 5.0]);
        let found = segments(&x, &y, |i, j| Some(2.0 * x[i] + y[j]), 4.5);
        assert!(!found.is_empty());
        assert!(found.iter().flatten().all(|[x, y]| (2.0 * x + y - 4.5).abs() < 1e-12));
        let length: f64 = found.iter().map(|[a, b]| (a[0] - b[0]).hypot(a[1] - b[1])).sum();
        assert!((length - 2.25f64.hypot(4.5)).abs() < 1e-12, "{length}");
        assert!(segments(&x, &y, |_, _| Some(1.0), 1.0).is_empty());
    }

    #[test]
    fn limit_no_line_beside_a_cell_without_a_value() {
        let grid = [0.0, 1.0, 2.0];
        let found = segments(&grid, &grid, |i, j| ((i, j) != (0, 0)).then_some(i as f64), 0.5);
        assert_eq!(found, [[[0.5, 1.0], [0.5, 2.0]]]);
    }

    #[test]
    fn limit_a_saddle_is_parted_by_its_mean() {
        let unit = [0.0, 1.0];
        let saddle = |low: f64| segments(&unit, &unit, move |i, j| Some(if i == j { 1.0 } else { low }), 0.5);
        for (low, above) in [(0.2, true), (-0.8, false)] {
            let found = saddle(low);
            // Mean above the level: the line cuts off the low corners, (1, 0) and (0, 1).
            let cut = |corner: [f64; 2]| {
                found.iter().any(|[a, b]| [a, b].iter().all(|p| (p[0] - corner[0]).hypot(p[1] - corner[1]) < 0.75))
            };
            assert_eq!((cut([1.0, 0.0]), cut([0.0, 0.0])), (above, !above), "{found:?}");
        }
    }
}
