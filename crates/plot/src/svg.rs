//! A small writer of SVG text: absolute coordinates in px, two decimals, the same bytes for the same calls.

use crate::style::{INK, LABEL_PX, Marker, PAPER, Stroke, reference_stroke};
use crate::text::{SUBSCRIPT_SIZE, escape, runs};

/// Anchor of a text on its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// Setting of a text.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Type {
    pub size: f64,
    pub bold: bool,
    pub anchor: Anchor,
    pub colour: &'static str,
    /// Turned by a quarter, reading upwards.
    pub upwards: bool,
    /// True if an underscore lowers the letters and digits after it.
    pub subscripts: bool,
}

impl Default for Type {
    fn default() -> Self {
        Self { size: LABEL_PX, bold: false, anchor: Anchor::Start, colour: INK, upwards: false, subscripts: false }
    }
}

/// A coordinate with two decimals, without trailing zeros or a negative zero.
pub(crate) fn px(value: f64) -> String {
    let mut text = format!("{value:.2}");
    let kept = text.trim_end_matches('0').trim_end_matches('.').len();
    text.truncate(kept);
    if text == "-0" { "0".to_owned() } else { text }
}

/// Half the size of a cross, px.
const CROSS: f64 = 3.6;
/// Overlap of the cells of a map with those after them, px.
const OVERLAP: f64 = 0.4;

/// The drawing so far.
#[derive(Debug, Default)]
pub(crate) struct Svg {
    body: String,
    /// Colours whose hatching is defined already.
    hatched: Vec<&'static str>,
}

impl Svg {
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], colour: &str, width: f64) {
        let ([x1, y1], [x2, y2]) = (from.map(px), to.map(px));
        self.push(&format!(
            r#"<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke="{colour}" stroke-width="{}"/>"#,
            px(width)
        ));
    }

    pub fn dashed_line(&mut self, from: [f64; 2], to: [f64; 2], colour: &'static str, width: f64) {
        self.path(&[from, to], &Stroke { colour, dash: "3 3", width, ..reference_stroke(None) }, false);
    }

    pub fn circle(&mut self, [x, y]: [f64; 2], radius: f64, colour: &str, width: f64) {
        let (x, y, radius, width) = (px(x), px(y), px(radius), px(width));
        self.push(&format!(
            r#"<circle cx="{x}" cy="{y}" r="{radius}" fill="none" stroke="{colour}" stroke-width="{width}"/>"#
        ));
    }

    pub fn frame(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2], colour: &str) {
        let (x, y, width, height) = (px(x), px(y), px(width), px(height));
        self.push(&format!(
            r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" fill="none" stroke="{colour}" stroke-width="1"/>"#
        ));
    }

    /// A white ground for a label on top of curves or grid lines, about a centre.
    pub fn ground(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2]) {
        let (left, top, width, height) = (px(x - 0.5 * width), px(y - 0.5 * height), px(width), px(height));
        self.push(&format!(r#"<rect x="{left}" y="{top}" width="{width}" height="{height}" rx="2" fill="{PAPER}"/>"#));
    }

    /// A polyline; `closed` joins its ends.
    pub fn path(&mut self, points: &[[f64; 2]], stroke: &Stroke, closed: bool) {
        let mut d = String::new();
        for (i, &[x, y]) in points.iter().enumerate() {
            d.push_str(if i == 0 { "M" } else { " L" });
            d.push_str(&format!("{} {}", px(x), px(y)));
        }
        if closed {
            d.push_str(" Z");
        }
        let (colour, width) = (stroke.colour, px(stroke.width));
        let dash =
            if stroke.dash.is_empty() { String::new() } else { format!(r#" stroke-dasharray="{}""#, stroke.dash) };
        self.push(&format!(
            r#"<path d="{d}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round"{dash}/>"#
        ));
    }

    /// Pieces of a line, each by itself.
    pub fn pieces(&mut self, pieces: &[[[f64; 2]; 2]], stroke: &Stroke) {
        if pieces.is_empty() {
            return;
        }
        let piece = |[a, b]: &[[f64; 2]; 2]| format!("M{} {} L{} {}", px(a[0]), px(a[1]), px(b[0]), px(b[1]));
        let d = pieces.iter().map(piece).collect::<Vec<_>>().join(" ");
        let (colour, width) = (stroke.colour, px(stroke.width));
        self.push(&format!(
            r#"<path d="{d}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linecap="round"/>"#
        ));
    }

    /// A light area between closed outlines: inside one and outside the other.
    pub fn tint(&mut self, outlines: &[Vec<[f64; 2]>], colour: &str, opacity: f64) {
        let mut d = String::new();
        for outline in outlines {
            for (i, &[x, y]) in outline.iter().enumerate() {
                d.push_str(if i == 0 { "M" } else { " L" });
                d.push_str(&format!("{} {}", px(x), px(y)));
            }
            d.push_str(" Z ");
        }
        let d = d.trim_end();
        let opacity = px(opacity);
        self.push(&format!(r#"<path d="{d}" fill="{colour}" fill-opacity="{opacity}" fill-rule="evenodd"/>"#));
    }

    /// A filled bar with a thin outline, hatched where its stroke says so.
    pub fn bar(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2], stroke: &Stroke) {
        let colour = stroke.colour;
        let id = format!("hatch-{}", colour.trim_start_matches('#'));
        if stroke.hatched && !self.hatched.contains(&colour) {
            self.hatched.push(colour);
            self.push(&format!(
                r#"<pattern id="{id}" width="6" height="6" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="6" height="6" fill="{colour}"/><rect width="2.4" height="6" fill="{PAPER}"/></pattern>"#
            ));
        }
        let fill = if stroke.hatched { format!("url(#{id})") } else { colour.to_owned() };
        let (x, y, width, height) = (px(x), px(y), px(width), px(height));
        self.push(&format!(
            r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" fill="{fill}" stroke="{INK}" stroke-width="0.8"/>"#
        ));
    }

    /// A marker: filled for computed values, open for published ones.
    pub fn marker(&mut self, at: [f64; 2], stroke: &Stroke, open: bool) {
        let (fill, edge, width) = if open { (PAPER, stroke.colour, 1.6) } else { (stroke.colour, PAPER, 0.8) };
        let paint = format!(r#"fill="{fill}" stroke="{edge}" stroke-width="{}""#, px(width));
        let size = if open { 4.6 } else { stroke.marker_px };
        let [x, y] = at;
        if stroke.marker == Marker::Circle {
            return self.push(&format!(r#"<circle cx="{}" cy="{}" r="{}" {paint}/>"#, px(x), px(y), px(size)));
        }
        let points: Vec<String> = corners(stroke.marker)
            .iter()
            .map(|[dx, dy]| format!("{},{}", px(x + size * dx), px(y + size * dy)))
            .collect();
        self.push(&format!(r#"<polygon points="{}" {paint} stroke-linejoin="round"/>"#, points.join(" ")));
    }

    /// A cross: no value here.
    pub fn cross(&mut self, [x, y]: [f64; 2], colour: &str) {
        let [left, right, top, bottom] = [x - CROSS, x + CROSS, y - CROSS, y + CROSS].map(px);
        self.push(&format!(
            r#"<path d="M{left} {top} L{right} {bottom} M{left} {bottom} L{right} {top}" fill="none" stroke="{colour}" stroke-width="1.5"/>"#
        ));
    }

    /// A cell of a map, without an outline; neighbours overlap by a little, so that no gap shows between them.
    pub fn cell(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2], colour: &str) {
        let (x, y, width, height) = (px(x), px(y), px(width + OVERLAP), px(height + OVERLAP));
        self.push(&format!(r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" fill="{colour}"/>"#));
    }

    /// A line of text whose vertical centre of lower-case letters lies at `at`.
    pub fn text(&mut self, at: [f64; 2], text: &str, how: Type) {
        // Half the height of capitals of a sans-serif face: `dominant-baseline` is not drawn alike everywhere.
        let drop = 0.36 * how.size;
        let ([x, y], turn) = if how.upwards {
            ([at[0] + drop, at[1]], format!(r#" transform="rotate(-90 {} {})""#, px(at[0] + drop), px(at[1])))
        } else {
            ([at[0], at[1] + drop], String::new())
        };
        let anchor = match how.anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let weight = if how.bold { r#" font-weight="bold""# } else { "" };
        let text = if how.subscripts { lowered(text, how.size) } else { escape(text) };
        let (x, y, size, colour) = (px(x), px(y), px(how.size), how.colour);
        let place = format!(r#"x="{x}" y="{y}" font-size="{size}" text-anchor="{anchor}"{weight}{turn}"#);
        self.push(&format!(r#"<text {place} fill="{colour}">{text}</text>"#));
    }

    fn push(&mut self, element: &str) {
        self.body.push_str(element);
        self.body.push('\n');
    }

    /// The whole document.
    pub fn finish(self, [width, height]: [f64; 2], title: &str, description: &str) -> String {
        let (w, h) = (px(width.ceil()), px(height.ceil()));
        let (title, description) = (escape(title), escape(description));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" \
             font-family=\"sans-serif\" role=\"img\">\n<title>{title}</title>\n<desc>{description}</desc>\n\
             <rect width=\"{w}\" height=\"{h}\" fill=\"{PAPER}\"/>\n{}</svg>\n",
            self.body
        )
    }
}

/// Text with its subscripts set smaller and lower.
fn lowered(text: &str, size: f64) -> String {
    let drop = 0.22 * size;
    let mut lower = false;
    let set = runs(text).into_iter().map(|(run, subscript)| {
        let dy = match (lower, subscript) {
            (false, true) => format!(r#" dy="{}""#, px(drop)),
            (true, false) => format!(r#" dy="{}""#, px(-drop)),
            _ => String::new(),
        };
        lower = subscript;
        let scale = if subscript { SUBSCRIPT_SIZE } else { 1.0 };
        match (subscript, dy.is_empty()) {
            (false, true) => escape(run),
            _ => format!(r#"<tspan{dy} font-size="{}">{}</tspan>"#, px(scale * size), escape(run)),
        }
    });
    set.collect()
}

/// Corners of a marker of unit size; sizes chosen so that the areas look equal.
fn corners(marker: Marker) -> &'static [[f64; 2]] {
    match marker {
        Marker::Circle => &[],
        Marker::Square => &[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]],
        Marker::Triangle => &[[0.0, -1.25], [1.15, 0.8], [-1.15, 0.8]],
        Marker::Diamond => &[[0.0, -1.3], [1.3, 0.0], [0.0, 1.3], [-1.3, 0.0]],
        Marker::Wedge => &[[0.0, 1.25], [1.15, -0.8], [-1.15, -0.8]],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_coordinates_are_short_and_never_negative_zero() {
        assert_eq!(px(-0.001), "0");
        assert_eq!(px(12.50), "12.5");
        assert_eq!(px(100.0), "100");
    }
}
