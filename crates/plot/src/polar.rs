//! Charts over the azimuth: 0° (the direction of the radial load) at the right, counter-clockwise.

use crate::axes::BAND;
use crate::book::Drawn;
use crate::chart::{Chart, Spot};
use crate::error::PlotError;
use crate::reference_marks::{Drawing, Shape};
use crate::references::{self, Place, Reference};
use crate::series::{Axis, Series, SeriesKind, check_all};
use crate::style::{GRID, HEADING_PX, INK, LABEL_PX, TICK_PX};
use crate::svg::{Anchor, Svg, Type};
use crate::symbols::{draw_absent, draw_markers, draw_points};
use crate::text::{axis_title, width};
use crate::ticks::{Scale, engineering_exponent, is_zero, linear, spread};
use crate::turn::{CHORD_DEG, bands, filled, runs};

/// Magnitudes of balls, or of contacts, over the azimuth.
///
/// The centre is the lower end of the radial axis, which is not zero in general: its value is written there. Negative
/// values are refused: on a circle they cannot be told from positive ones, and belong over degrees
/// ([`crate::LineChart::over_azimuth`]). Lines are closed except over azimuths without a value; between balls the
/// radial value is interpolated linearly in azimuth, so that a constant is a circle and no value is drawn beyond those
/// of two neighbours.
#[derive(Debug, Clone, PartialEq)]
pub struct PolarChart {
    /// Heading of the panel.
    pub title: String,
    /// The radial quantity.
    pub radial: Axis,
    /// Azimuth in degrees against radial value.
    pub series: Vec<Series>,
    /// Published numbers across the circle.
    pub references: Vec<Reference>,
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
/// Distance of the first series' crosses from the rim and of the others' from each other, px.
const ABSENT: f64 = 9.0;

/// Map from values to places on the page.
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

    /// A published number on the page.
    fn published(&self, place: Place) -> Shape {
        let arc = |value: f64, from: f64, to: f64| {
            let parts = ((to - from) / CHORD_DEG).ceil().max(1.0) as usize;
            let radius = RADIUS * self.scale.position(value / self.unit);
            (0..=parts).map(|k| self.at(from + (to - from) * k as f64 / parts as f64, radius)).collect::<Vec<_>>()
        };
        let circle = |value| arc(value, 0.0, 360.0);
        let ray = |phi| vec![self.centre, self.at(phi, RADIUS)];
        match place {
            Place::Value(value) => Shape::line(circle(value)),
            Place::At(phi) => Shape::line(ray(phi)),
            Place::Range(from, to) => {
                let circles = vec![circle(from), circle(to)];
                Shape { areas: circles.clone(), edges: circles }
            }
            Place::Between(from, to) => {
                let rim = arc(self.scale.max * self.unit, from, from + (to - from).rem_euclid(360.0));
                Shape { areas: vec![[vec![self.centre], rim].concat()], edges: vec![ray(from), ray(to)] }
            }
        }
    }
}

impl PolarChart {
    /// A chart without published numbers.
    pub fn new(title: impl Into<String>, radial: Axis, series: Vec<Series>) -> Self {
        Self { title: title.into(), radial, series, references: Vec::new() }
    }

    /// Height above the circle and its azimuth labels, px.
    fn head(heading: &str) -> f64 {
        HEAD[0] + if heading.is_empty() { 0.0 } else { HEAD[1] }
    }

    /// Radial axis and the power of ten taken out of it.
    fn scale(&self) -> Result<(Scale, i32), PlotError> {
        let values = self.series.iter().flat_map(Series::ordinates);
        let values = values.chain(references::numbers(&self.references, true));
        let (low, high) = spread(self.radial.range(values)?);
        let exponent = engineering_exponent(low.abs().max(high.abs()));
        let unit = 10f64.powi(exponent);
        if is_zero((low, high)) {
            let major = vec![(0.0, "0".to_owned())];
            return Ok((Scale { min: 0.0, max: 1.0, major, minor: Vec::new(), log: false }, 0));
        }
        let mut start = low - FREE_CENTRE * (high - low);
        if low >= 0.0 {
            start = start.max(0.0);
        }
        Ok((linear((start / unit, high / unit), RINGS, true), exponent))
    }
}

impl Chart for PolarChart {
    fn title(&self) -> &str {
        &self.title
    }

    fn axes(&self) -> String {
        format!("{} over the azimuth", self.radial.label)
    }

    fn series(&self) -> &[Series] {
        &self.series
    }

    fn references(&self) -> &[Reference] {
        &self.references
    }

    fn check(&self) -> Result<(), PlotError> {
        check_all(&self.title, &self.series, false)?;
        references::check(&self.references)?;
        for series in &self.series {
            let edges = series.band.iter().flatten().map(|(phi, low, _)| (*phi, *low));
            let all = series.points.iter().copied().chain(edges);
            if let Some((index, (azimuth_deg, value))) = all.enumerate().find(|(_, (_, value))| *value < 0.0) {
                return Err(PlotError::Negative { series: series.label.clone(), index, azimuth_deg, value });
            }
        }
        Ok(())
    }

    fn size(&self, heading: &str) -> Result<[f64; 2], PlotError> {
        let circle = 2.0 * (RADIUS + ROOM[0]);
        let title = width(heading, HEADING_PX, true);
        Ok([circle.max(title), Self::head(heading) + 2.0 * (RADIUS + ROOM[1])])
    }

    fn draw(&self, svg: &mut Svg, Spot { at: [x, y], heading, book }: &Spot) -> Result<(), PlotError> {
        let (scale, exponent) = self.scale()?;
        let centre = [x + 0.5 * self.size(heading)?[0], y + Self::head(heading) + ROOM[1] + RADIUS];
        let dial = Dial { centre, scale, unit: 10f64.powi(exponent) };
        let middle = Type { anchor: Anchor::Middle, ..Type::default() };
        if !heading.is_empty() {
            svg.text([centre[0], y + 10.0], heading, Type { size: HEADING_PX, bold: true, ..middle });
        }
        let title = axis_title(&self.radial.label, &self.radial.unit, exponent);
        svg.text([centre[0], y + Self::head(heading) - 15.0], &title, Type { size: LABEL_PX, ..middle });
        draw_grid(svg, &dial);
        let published = Drawing::new(&self.references, book, |place| dial.published(place));
        published.areas(svg);
        // Below the lines: the centre's label must not hide the marker of a lightly loaded ball.
        draw_ring_labels(svg, &dial, &self.series);
        let (lines, points) = book.ordered(&self.series);
        draw_lines(svg, &dial, &lines);
        published.lines(svg);
        draw_points(svg, &points, |p| dial.place(p));
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
    svg.circle(dial.centre, RADIUS, INK, 1.1);
}

fn draw_lines(svg: &mut Svg, dial: &Dial, lines: &[Drawn]) {
    let place = |curve: Vec<(f64, f64)>| -> Vec<[f64; 2]> { curve.into_iter().map(|p| dial.place(p)).collect() };
    for (series, entry) in lines {
        let edges = |points: &[(f64, f64)]| runs(points, series.gaps()).iter().map(|run| filled(run)).collect();
        for [lower, mut upper] in bands(series, edges) {
            if closes(&lower) {
                svg.tint(&[place(lower), place(upper)], entry.stroke.colour, BAND);
            } else {
                upper.reverse();
                svg.tint(&[place([lower, upper].concat())], entry.stroke.colour, BAND);
            }
        }
    }
    for (series, entry) in lines {
        for run in runs(&series.points, series.gaps()).iter().filter(|run| run.len() > 1) {
            svg.path(&place(filled(run)), &entry.stroke, closes(run));
        }
    }
    draw_markers(svg, lines, |p| dial.place(p), |series| runs(&series.points, series.gaps()));
    draw_absent(svg, lines, |phi, row| dial.at(phi, RADIUS - ABSENT * (row + 1) as f64));
}

/// True if a run is a whole turn.
fn closes(run: &[(f64, f64)]) -> bool {
    matches!(run, [(from, _), .., (to, _)] if to - from >= 360.0)
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

/// Labels written on a ray: those of centre and rim, and those between that no curve crosses and no other
/// label.
fn written<'a>(dial: &Dial, curves: &[[f64; 2]], labels: &'a [RingLabel<'a>], phi_deg: f64) -> Vec<&'a RingLabel<'a>> {
    let (sin, cos) = phi_deg.to_radians().sin_cos();
    let apart = |a: &RingLabel, b: &RingLabel| {
        let far = [0, 1].map(|k| 0.5 * (a.room[k] + b.room[k]));
        ((a.radius - b.radius) * cos).abs() >= far[0] || ((a.radius - b.radius) * sin).abs() >= far[1]
    };
    let rim = labels.last().filter(|_| labels.len() > 1);
    let mut kept: Vec<&RingLabel> = labels.first().into_iter().chain(rim).collect();
    for label in labels.iter().take(labels.len().saturating_sub(1)).skip(1) {
        if label.gap(dial, curves, phi_deg) >= CLEAR && kept.iter().all(|other| apart(label, other)) {
            kept.push(label);
        }
    }
    kept
}

/// The ray, degrees, on which most ring labels are written, and not that of the rim on a curve.
fn clearest_ray(dial: &Dial, curves: &[[f64; 2]], labels: &[RingLabel]) -> f64 {
    // Half-way between spokes first, then a little beside; the upper half first, where a reader looks.
    let middles = [75.0, 45.0, 105.0, 135.0, 15.0, 165.0, 285.0, 255.0, 315.0, 225.0, 345.0, 195.0];
    let rays = [0.0, -4.0, 4.0].into_iter().flat_map(|beside| middles.map(|phi| phi + beside));
    let score = |phi: f64| {
        let gap = |label: &&RingLabel| label.gap(dial, curves, phi);
        // The centre's label is the same on every ray. One label more counts for more than any clearance; whole pixels
        // keep rounding from deciding between equal rays.
        let rim = labels.last().map_or(0.0, |rim| if gap(&rim) < CLEAR { -1000.0 } else { 0.0 });
        let gaps = written(dial, curves, labels, phi).into_iter().skip(1);
        gaps.fold(rim, |sum, label| sum + 100.0 + gap(&label).min(10.0).floor())
    };
    let best = rays.fold((75.0, f64::NEG_INFINITY), |(kept, most), phi| {
        let here = score(phi);
        if here > most { (phi, here) } else { (kept, most) }
    });
    best.0
}

/// Writes the values of the rings along the clearest ray.
///
/// Labels between centre and rim that a curve would cross are left out: the rings are equidistant, so that centre and
/// rim tell the rest.
fn draw_ring_labels(svg: &mut Svg, dial: &Dial, series: &[Series]) {
    let shown = |s: &Series| {
        if s.kind == SeriesKind::Points {
            return s.points.clone();
        }
        runs(&s.points, s.gaps()).iter().flat_map(|run| filled(run)).collect()
    };
    let curves: Vec<[f64; 2]> = series.iter().flat_map(shown).map(|p| dial.place(p)).collect();
    let major = dial.scale.major.iter();
    let labels: Vec<RingLabel> = major
        .map(|(value, text)| RingLabel {
            text,
            radius: RADIUS * dial.scale.position(*value),
            room: [width(text, TICK_PX, false) + 5.0, TICK_PX + 1.0],
        })
        .collect();
    let ray = clearest_ray(dial, &curves, &labels);
    for label in written(dial, &curves, &labels, ray) {
        let at = dial.at(ray, label.radius);
        svg.ground(at, label.room);
        svg.text(at, label.text, Type { size: TICK_PX, anchor: Anchor::Middle, ..Type::default() });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn limit_radial_axis_is_offset_below_the_data_and_not_below_zero() {
        let chart = |values: &[f64]| {
            let points = values.iter().enumerate().map(|(i, v)| (60.0 * i as f64, *v)).collect();
            PolarChart::new("t", Axis::new("q", "N"), vec![Series::line("a", points)])
        };
        let (scale, exponent) = chart(&[6.0, 12.0, 9.0]).scale().unwrap();
        assert_eq!((scale.min, scale.max, exponent), (4.0, 12.0, 0));
        let (scale, exponent) = chart(&[0.002, 0.001]).scale().unwrap();
        assert_eq!((scale.min, scale.max, exponent), (0.5, 2.0, -3));
        let (scale, _) = chart(&[0.0, 0.0, 3.0]).scale().unwrap();
        assert_eq!(scale.min, 0.0);
        let (scale, exponent) = chart(&[0.0, 0.0]).scale().unwrap();
        assert_eq!((scale.position(0.0), scale.major.len(), exponent), (0.0, 1, 0));
    }

    #[test]
    fn limit_negative_values_are_refused_with_their_azimuth() {
        let points = vec![(0.0, 1.0), (90.0, -2.0)];
        let chart = PolarChart::new("t", Axis::new("q", "N"), vec![Series::line("a", points)]);
        let refused = chart.check();
        assert!(matches!(refused, Err(PlotError::Negative { index: 1, azimuth_deg: 90.0, value: -2.0, .. })));
    }

    #[test]
    fn limit_ring_labels_keep_clear_of_curves_and_of_each_other() {
        let scale = linear((-14_000.0, -4000.0), RINGS, true);
        let dial = Dial { centre: [200.0, 200.0], scale, unit: 1.0 };
        let labels: Vec<RingLabel> = (0..=5)
            .map(|k| RingLabel { text: "−10000", radius: RADIUS * f64::from(k) / 5.0, room: [52.0, 13.5] })
            .collect();
        // On the horizontal labels are wider than rings are apart: not all are written there, on the vertical all are.
        assert!(written(&dial, &[], &labels, 0.0).len() < 6);
        assert_eq!(written(&dial, &[], &labels, 75.0).len(), 6);
        // A curve along the upper half of the rim drives the rim's label to the lower half.
        let arc: Vec<[f64; 2]> = (0..180).map(|phi| dial.at(f64::from(phi), RADIUS - 4.0)).collect();
        let ray = clearest_ray(&dial, &arc, &labels);
        assert!(ray > 180.0, "{ray}");
    }
}
