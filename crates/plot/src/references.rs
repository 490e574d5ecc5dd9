//! Published numbers that hold for a whole panel: a line or a range across it, the same look on all charts.

use crate::error::PlotError;
use crate::series::{Entry, Kind, StyleBook, drawable};
use crate::style::{PALETTE, Stroke, reference_stroke};
use crate::svg::Svg;

/// A published number drawn across a panel as a thin dash-dotted line, or as a light range between two. Values that
/// belong to single abscissas are points instead ([`crate::Series::points`]).
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Name in the legend, such as `published: 1260 Hz`.
    pub label: String,
    /// Place at which it is drawn; the axes reach it.
    pub place: Place,
    /// Label of the line whose colour it takes; black without it.
    pub of: Option<String>,
}

/// Place of a published number, in the units of the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// An ordinate; on a polar chart a circle.
    Value(f64),
    /// A range of ordinates; on a polar chart a ring.
    Range(f64, f64),
    /// An abscissa; on a polar chart a ray at an azimuth in degrees.
    At(f64),
    /// A range of abscissas; on a polar chart the sector from the first azimuth counter-clockwise to the second,
    /// degrees.
    Between(f64, f64),
}

impl Place {
    /// Both numbers, equal where there is one.
    fn ends(self) -> [f64; 2] {
        match self {
            Self::Value(v) | Self::At(v) => [v, v],
            Self::Range(from, to) | Self::Between(from, to) => [from, to],
        }
    }

    /// True if it is a range, drawn as an area.
    fn is_range(self) -> bool {
        matches!(self, Self::Range(..) | Self::Between(..))
    }

    /// True if the numbers are ordinates.
    fn on_ordinate(self) -> bool {
        matches!(self, Self::Value(_) | Self::Range(..))
    }
}

impl Reference {
    /// A black one.
    pub fn new(label: impl Into<String>, place: Place) -> Self {
        Self { label: label.into(), place, of: None }
    }

    /// The same in the colour of a line.
    #[must_use]
    pub fn of(mut self, line: impl Into<String>) -> Self {
        self.of = Some(line.into());
        self
    }
}

/// The numbers of references that lie on the ordinate, or on the abscissa.
pub(crate) fn numbers(references: &[Reference], ordinate: bool) -> impl Iterator<Item = f64> {
    references.iter().filter(move |r| r.place.on_ordinate() == ordinate).flat_map(|r| r.place.ends())
}

/// Refuses numbers that cannot be drawn.
pub(crate) fn check(references: &[Reference]) -> Result<(), PlotError> {
    for reference in references {
        let [x, y] = reference.place.ends();
        if !(drawable(x) && drawable(y)) {
            return Err(PlotError::NotFinite { series: reference.label.clone(), index: 0, x, y });
        }
    }
    Ok(())
}

/// The legend's entry of a reference; `slot` is the style of the line that it belongs to.
pub(crate) fn entry(reference: &Reference, slot: Option<usize>) -> Entry {
    let kind = Kind::Reference { range: reference.place.is_range(), upright: !reference.place.on_ordinate() };
    let stroke = reference_stroke(slot.map(|slot| PALETTE[slot % PALETTE.len()]));
    Entry { label: reference.label.clone(), kind, stroke }
}

/// Strength of the tint of a range.
const TINT: f64 = 0.13;

/// A published number on the page: outlines of the area of a range, none of a line, and the lines or edges.
pub(crate) struct Shape {
    pub areas: Vec<Vec<[f64; 2]>>,
    pub edges: Vec<Vec<[f64; 2]>>,
}

impl Shape {
    /// Lines alone.
    pub fn line(line: Vec<[f64; 2]>) -> Self {
        Self { areas: Vec::new(), edges: vec![line] }
    }
}

/// The references of a panel on the page.
pub(crate) struct Drawing {
    shapes: Vec<(Shape, Stroke)>,
}

impl Drawing {
    /// `shape` places a number on the page.
    pub fn new(references: &[Reference], book: &StyleBook, shape: impl Fn(Place) -> Shape) -> Self {
        let of = |r: &Reference| book.entries.iter().find(|e| e.kind.is_reference() && e.label == r.label);
        Self { shapes: references.iter().filter_map(|r| Some((shape(r.place), of(r)?.stroke))).collect() }
    }

    /// Tints the ranges: before the lines of the panel, which lie on them.
    pub fn areas(&self, svg: &mut Svg) {
        for (shape, stroke) in self.shapes.iter().filter(|(shape, _)| !shape.areas.is_empty()) {
            svg.tint(&shape.areas, stroke.colour, TINT);
        }
    }

    /// Draws lines and edges: after the lines of the panel, which would hide them.
    pub fn lines(&self, svg: &mut Svg) {
        for (shape, stroke) in &self.shapes {
            shape.edges.iter().for_each(|edge| svg.path(edge, stroke, false));
        }
    }
}

/// Size of the legend's sample, px: edges long enough for a dash, a dot and a dash again.
fn sample_size(range: bool, upright: bool) -> [f64; 2] {
    match (range, upright) {
        (false, false) => [44.0, 0.0],
        (false, true) => [12.0, 18.0],
        (true, false) => [22.0, 13.0],
        (true, true) => [24.0, 18.0],
    }
}

/// Width of the legend's sample, px.
pub(crate) fn sample_width(range: bool, upright: bool) -> f64 {
    sample_size(range, upright)[0]
}

/// The legend's sample, its middle on the left edge at `[x, y]`.
pub(crate) fn draw_sample(svg: &mut Svg, [x, y]: [f64; 2], range: bool, upright: bool, stroke: &Stroke) {
    let size = sample_size(range, upright);
    let across = |v: f64| vec![[x + v * size[0], y - 0.5 * size[1]], [x + v * size[0], y + 0.5 * size[1]]];
    let along = |v: f64| vec![[x, y + (v - 0.5) * size[1]], [x + size[0], y + (v - 0.5) * size[1]]];
    let edge = |v: f64| if upright { across(v) } else { along(v) };
    if !range {
        return svg.path(&edge(0.5), stroke, false);
    }
    let (first, last) = (edge(0.0), edge(1.0));
    let outline = first.iter().chain(last.iter().rev()).copied().collect();
    svg.tint(&[outline], stroke.colour, TINT);
    [first, last].iter().for_each(|edge| svg.path(edge, stroke, false));
}
