//! Charts over the azimuth: 0° (the direction of the radial load) at the right, counter-clockwise.

use crate::error::PlotError;
use crate::series::{Axis, Drawn, Series, SeriesKind, StyleBook, check_all, marked_points};
use crate::style::{GREY, GRID, HEADING_PX, INK, LABEL_PX, TICK_PX};
use crate::svg::{Anchor, Svg, Type};
use crate::text::{axis_title, width};
use crate::ticks::{Scale, engineering_exponent, linear, spread};

/// Quantities of balls, or of contacts, over the azimuth.
///
/// The centre is the lower end of the radial axis, which is not zero in general: its value is written there.
/// Where the axis crosses zero, the zero circle is drawn darker. Lines are closed; between balls the radial value is
/// interpolated linearly in azimuth, so that a constant is a circle and no value is drawn beyond those of two neighbours.
#[derive(Debug, Clone, PartialEq)]
pub struct PolarChart {
    /// Heading of the panel.
    pub title: String,
    /// The radial quantity.
    pub radial: Axis,
    /// Azimuth in degrees against radial value.
    pub series: Vec<Series>,
}

/// Radius of the outermost circle, px.
const RADIUS: f64 = 128.0;
/// Room for the azimuth labels beside and above the circle, px.
const ROOM: [f64; 2] = [46.0, 28.0];
/// Height of the axis title, and of a heading above it, px.
const HEAD: [f64; 2] = [24.0, 22.0];
/// Greatest number of rings.
const RINGS: usize = 5;
/// Part of the spread of the data that is left free about the centre.
const FREE_CENTRE: f64 = 0.2;
/// Greatest angle between the drawn points of a curve, degrees.
const CHORD_DEG: f64 = 2.0;

/// The points of a closed curve: sorted by azimuth in [0°, 360°), one value for each, the first repeated at the end a turn later.
pub(crate) fn closed(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut turn: Vec<(f64, f64)> = points.iter().map(|(phi, value)| (phi.rem_euclid(360.0) % 360.0, *value)).collect();
    turn.sort_by(|a, b| a.0.total_cmp(&b.0));
    // 0° and 360° may both be given.
    turn.dedup_by(|next, kept| next.0 - kept.0 < 1e-9);
    if let Some(&(phi, value)) = turn.first() {
        turn.push((phi + 360.0, value));
    }
    turn
}

/// The closed curve with points between those given, at most `CHORD_DEG` apart.
fn interpolated(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let turn = closed(points);
    let mut curve: Vec<(f64, f64)> = turn.first().copied().into_iter().collect();
    for pair in turn.windows(2) {
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

/// Where values lie on the page.
struct Dial {
    centre: [f64; 2],
    scale: Scale,
    /// Power of ten taken out of the values.
    unit: f64,
}

impl Dial {
    fn place(&self, (phi_deg, value): (f64, f64)) -> [f64; 2] {
        self.at(phi_deg, RADIUS * self.scale.position(value / self.unit))
    }

    fn at(&self, phi_deg: f64, radius: f64) -> [f64; 2] {
        // Exact at the ends of a turn, so that closed curves close to the last digit.
        let (sin, cos) = phi_deg.rem_euclid(360.0).to_radians().sin_cos();
        [self.centre[0] + radius * cos, self.centre[1] - radius * sin]
    }
}

impl PolarChart {
    pub(crate) fn check(&self) -> Result<(), PlotError> {
        check_all(&self.title, &self.series, false)
    }

    /// Height above the circle and its azimuth labels, px.
    fn head(heading: &str) -> f64 {
        HEAD[0] + if heading.is_empty() { 0.0 } else { HEAD[1] }
    }

    pub(crate) fn size(&self, heading: &str) -> [f64; 2] {
        let circle = 2.0 * (RADIUS + ROOM[0]);
        let title = width(heading, HEADING_PX, true);
        [circle.max(title), Self::head(heading) + 2.0 * (RADIUS + ROOM[1])]
    }

    /// Radial axis and the power of ten taken out of it.
    fn scale(&self) -> Result<(Scale, i32), PlotError> {
        let (low, high) = spread(self.radial.range(self.series.iter().flat_map(Series::ordinates))?);
        let exponent = engineering_exponent(low.abs().max(high.abs()));
        let unit = 10f64.powi(exponent);
        let mut start = low - FREE_CENTRE * (high - low);
        if low >= 0.0 {
            start = start.max(0.0);
        }
        Ok((linear((start / unit, high / unit), RINGS, true), exponent))
    }

    pub(crate) fn draw(
        &self,
        svg: &mut Svg,
        [x, y]: [f64; 2],
        heading: &str,
        book: &StyleBook,
    ) -> Result<(), PlotError> {
        let (scale, exponent) = self.scale()?;
        let centre = [x + 0.5 * self.size(heading)[0], y + Self::head(heading) + ROOM[1] + RADIUS];
        let dial = Dial { centre, scale, unit: 10f64.powi(exponent) };
        let middle = Type { anchor: Anchor::Middle, ..Type::default() };
        if !heading.is_empty() {
            svg.text([centre[0], y + 10.0], heading, Type { size: HEADING_PX, bold: true, ..middle });
        }
        let title = axis_title(&self.radial.label, &self.radial.unit, exponent);
        svg.text([centre[0], y + Self::head(heading) - 15.0], &title, Type { size: LABEL_PX, ..middle });
        draw_grid(svg, &dial);
        let (lines, points) = book.ordered(&self.series);
        draw_lines(svg, &dial, &lines);
        draw_points(svg, &dial, &points);
        draw_ring_labels(svg, &dial, &self.series);
        Ok(())
    }
}

fn draw_grid(svg: &mut Svg, dial: &Dial) {
    let rings: Vec<f64> = dial.scale.major.iter().map(|(value, _)| RADIUS * dial.scale.position(*value)).collect();
    let inner = rings.get(1).copied().unwrap_or(0.0);
    for spoke in 0..12 {
        let phi = 30.0 * f64::from(spoke);
        let from = if spoke % 3 == 0 { 0.0 } else { inner };
        svg.line(dial.at(phi, from), dial.at(phi, RADIUS + 4.0), GRID, 1.0);
        let anchor = match spoke {
            3 | 9 => Anchor::Middle,
            0..3 | 10.. => Anchor::Start,
            _ => Anchor::End,
        };
        let [x, y] = dial.at(phi, RADIUS + 9.0);
        let upright = 5.0 * phi.to_radians().sin();
        svg.text([x, y - upright], &format!("{phi:.0}°"), Type { size: TICK_PX, anchor, ..Type::default() });
    }
    for radius in rings.iter().filter(|r| **r > 0.0 && **r < RADIUS) {
        svg.circle(dial.centre, *radius, GRID, 1.0);
    }
    if dial.scale.min < 0.0 && dial.scale.max > 0.0 {
        svg.circle(dial.centre, RADIUS * dial.scale.position(0.0), GREY, 1.1);
    }
    svg.circle(dial.centre, RADIUS, INK, 1.1);
}

fn draw_lines(svg: &mut Svg, dial: &Dial, lines: &[Drawn]) {
    for (series, entry) in lines {
        if let Some(band) = &series.band {
            let edge = |points: Vec<(f64, f64)>| interpolated(&points).into_iter().map(|p| dial.place(p)).collect();
            let lower = edge(band.iter().map(|(phi, low, _)| (*phi, *low)).collect());
            let upper = edge(band.iter().map(|(phi, _, high)| (*phi, *high)).collect());
            svg.tint(&[lower, upper], entry.stroke.colour);
        }
    }
    for (series, entry) in lines {
        let path: Vec<[f64; 2]> = interpolated(&series.points).into_iter().map(|p| dial.place(p)).collect();
        svg.path(&path, &entry.stroke, true);
    }
    for (place, (series, entry)) in lines.iter().enumerate() {
        if series.kind == SeriesKind::MarkedLine {
            for i in marked_points(series.points.len(), place, lines.len()) {
                svg.marker(dial.place(series.points[i]), &entry.stroke, false);
            }
        }
    }
}

fn draw_points(svg: &mut Svg, dial: &Dial, points: &[Drawn]) {
    for (series, entry) in points {
        for &(phi, value) in &series.points {
            if let Some(bar) = series.uncertainty {
                svg.line(dial.place((phi, value - bar)), dial.place((phi, value + bar)), entry.stroke.colour, 1.4);
            }
            svg.marker(dial.place((phi, value)), &entry.stroke, true);
        }
    }
}

/// Distance that keeps a ring label clear of a curve, px.
const CLEAR: f64 = 3.0;

/// The label of a ring: its text, the radius of the ring and the room that the text takes, px.
struct RingLabel<'a> {
    text: &'a str,
    radius: f64,
    room: [f64; 2],
}

impl RingLabel<'_> {
    /// Distance of the label on a ray from the nearest point of the curves, px; 0 where they cross.
    fn gap(&self, dial: &Dial, curves: &[[f64; 2]], phi_deg: f64) -> f64 {
        let at = dial.at(phi_deg, self.radius);
        curves.iter().fold(f64::INFINITY, |least: f64, p| {
            let beyond = [0, 1].map(|k| ((p[k] - at[k]).abs() - 0.5 * self.room[k]).max(0.0));
            least.min(beyond[0].hypot(beyond[1]))
        })
    }
}

/// The ray, degrees, on which the curves leave most ring labels free.
fn clearest_ray(dial: &Dial, curves: &[[f64; 2]], labels: &[RingLabel]) -> f64 {
    // Half-way between spokes first, then a little beside; the upper half first, where a reader looks.
    let middles = [75.0, 45.0, 105.0, 135.0, 15.0, 165.0, 285.0, 255.0, 315.0, 225.0, 345.0, 195.0];
    let rays = [0.0, -4.0, 4.0].into_iter().flat_map(|beside| middles.map(|phi| phi + beside));
    let score = |phi: f64| {
        let gaps = labels.iter().skip(1).map(|label| label.gap(dial, curves, phi));
        // One label more counts for more than any clearance; whole pixels keep rounding from deciding between equal rays.
        gaps.filter(|g| *g >= CLEAR).fold(0.0, |sum, g| sum + 100.0 + g.min(10.0).floor())
    };
    let best = rays.fold((75.0, f64::NEG_INFINITY), |(kept, most), phi| {
        let here = score(phi);
        if here > most { (phi, here) } else { (kept, most) }
    });
    best.0
}

/// Writes the values of the rings along the clearest ray.
///
/// Labels between centre and rim that a curve would cross are left out: the rings are equidistant, so that centre and rim tell
/// the rest.
fn draw_ring_labels(svg: &mut Svg, dial: &Dial, series: &[Series]) {
    let shown = |s: &Series| {
        if s.kind == SeriesKind::Points { s.points.clone() } else { interpolated(&s.points) }
    };
    let curves: Vec<[f64; 2]> = series.iter().flat_map(shown).map(|p| dial.place(p)).collect();
    let labels: Vec<RingLabel> = dial
        .scale
        .major
        .iter()
        .map(|(value, text)| RingLabel {
            text,
            radius: RADIUS * dial.scale.position(*value),
            room: [width(text, TICK_PX, false) + 5.0, TICK_PX + 1.0],
        })
        .collect();
    let ray = clearest_ray(dial, &curves, &labels);
    for (i, label) in labels.iter().enumerate() {
        let needed = i == 0 || i + 1 == labels.len();
        if needed || label.gap(dial, &curves, ray) >= CLEAR {
            let at = dial.at(ray, label.radius);
            svg.ground(at, label.room);
            svg.text(at, label.text, Type { size: TICK_PX, anchor: Anchor::Middle, ..Type::default() });
        }
    }
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
        let curve = interpolated(&balls(13).iter().map(|(phi, _)| (*phi, 5.0)).collect::<Vec<_>>());
        assert!(curve.iter().all(|(_, value)| *value == 5.0));
        assert!(curve.windows(2).all(|pair| pair[1].0 - pair[0].0 <= CHORD_DEG + 1e-9));
    }

    #[test]
    fn limit_azimuth_zero_is_at_the_right_and_turns_counter_clockwise() {
        let scale = linear((0.0, 10.0), RINGS, true);
        let dial = Dial { centre: [200.0, 100.0], scale, unit: 1.0 };
        assert_eq!(dial.place((0.0, 10.0)), [200.0 + RADIUS, 100.0]);
        let top = dial.place((90.0, 10.0));
        assert!((top[0] - 200.0).abs() < 1e-9 && (top[1] - (100.0 - RADIUS)).abs() < 1e-9);
        assert_eq!(dial.place((360.0, 7.0)), dial.place((0.0, 7.0)));
    }

    #[test]
    fn limit_radial_axis_is_offset_below_the_data_and_not_below_zero_for_positive_quantities() {
        let chart = |values: &[f64]| PolarChart {
            title: "t".into(),
            radial: Axis::new("q", "N"),
            series: vec![Series::line("a", values.iter().enumerate().map(|(i, v)| (60.0 * i as f64, *v)).collect())],
        };
        let (scale, exponent) = chart(&[6.0, 12.0, 9.0]).scale().unwrap();
        assert_eq!((scale.min, scale.max, exponent), (4.0, 12.0, 0));
        let (scale, exponent) = chart(&[-0.002, 0.001]).scale().unwrap();
        assert_eq!((scale.min, scale.max, exponent), (-3.0, 1.0, -3));
        let (scale, _) = chart(&[0.0, 0.0, 3.0]).scale().unwrap();
        assert_eq!(scale.min, 0.0);
    }
}
