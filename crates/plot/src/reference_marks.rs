//! Published numbers on the page: a line or a range across a panel, the same look on all charts.

use crate::book::StyleBook;
use crate::references::{Place, Reference};
use crate::style::Stroke;
use crate::svg::Svg;

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
