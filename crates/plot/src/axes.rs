//! The rectangle between two axes: where values lie in it, its ticks, grid and titles.

use crate::style::{GREY, GRID, HEADING_PX, INK, LABEL_PX, TICK_PX};
use crate::svg::{Anchor, Svg, Type};
use crate::text::width;
use crate::ticks::{Scale, engineering_exponent, linear, logarithmic, spread};

/// Width and height of an area in the usual size, px.
pub(crate) const AREA_PX: [f64; 2] = [380.0, 270.0];
/// Room below the axis for tick labels and title, px.
pub(crate) const FOOT: f64 = 50.0;
/// Room at the left for the title and its distance from the tick labels, px.
const SIDE: f64 = 38.0;
/// Room at the right for half a tick label, px.
pub(crate) const RIGHT: f64 = 26.0;

/// Least distance between the labels of a level axis, px.
const LABELS_APART: f64 = 6.0;

/// Room above an area, less with an empty heading, px.
pub(crate) fn head(heading: &str) -> f64 {
    if heading.is_empty() { 10.0 } else { 30.0 }
}

/// Strength of the tint of a series' band.
pub(crate) const BAND: f64 = 0.25;

/// An axis ready for drawing.
pub(crate) struct Ruler {
    pub scale: Scale,
    pub exponent: i32,
}

impl Ruler {
    /// An axis over a range of values; `snap` moves the ends of a linear one out to the next mark.
    pub fn new((low, high): (f64, f64), log: bool, intervals: usize, snap: bool) -> Self {
        if log {
            return Self { scale: logarithmic((low, high)), exponent: 0 };
        }
        let (low, high) = spread((low, high));
        let exponent = engineering_exponent(low.abs().max(high.abs()));
        let unit = 10f64.powi(exponent);
        Self { scale: linear((low / unit, high / unit), intervals, snap), exponent }
    }

    /// A level axis of a width, px, over a range of values: as many marks as their labels leave room for.
    pub fn level((low, high): (f64, f64), log: bool, wide: f64) -> Self {
        let mut intervals = steps(wide, 60.0);
        loop {
            let ruler = Self::new((low, high), log, intervals, false);
            if intervals <= 1 || ruler.labels_fit(wide) {
                return ruler;
            }
            intervals -= 1;
        }
    }

    /// True if labels of the marks keep apart along a width, px.
    fn labels_fit(&self, wide: f64) -> bool {
        let apart = |pair: &[(f64, String)]| {
            let room = wide * (self.scale.position(pair[1].0) - self.scale.position(pair[0].0));
            0.5 * (width(&pair[0].1, TICK_PX, false) + width(&pair[1].1, TICK_PX, false)) + LABELS_APART <= room
        };
        self.scale.major.windows(2).all(apart)
    }

    /// The azimuths of one turn.
    pub fn turn() -> Self {
        let major = (0..=6).map(|k| 60.0 * f64::from(k)).map(|phi| (phi, format!("{phi:.0}"))).collect();
        Self { scale: Scale { min: 0.0, max: 360.0, major, minor: Vec::new(), log: false }, exponent: 0 }
    }

    /// Names at 0, 1, 2 and so on.
    pub fn names(names: &[String]) -> Self {
        let major = names.iter().enumerate().map(|(place, name)| (place as f64, name.clone())).collect();
        let max = names.len() as f64 - 0.5;
        Self { scale: Scale { min: -0.5, max, major, minor: Vec::new(), log: false }, exponent: 0 }
    }

    /// Position along the axis, 0 to 1, of a value in the unit of the axis.
    pub fn position(&self, value: f64) -> f64 {
        self.scale.position(value / 10f64.powi(self.exponent))
    }

    /// Room left of an area with this upright axis, px.
    pub fn room(&self) -> f64 {
        SIDE + self.scale.major.iter().fold(0.0, |most: f64, (_, text)| most.max(width(text, TICK_PX, false)))
    }
}

/// Greatest number of steps on an axis of a length, px, with marks at least `pitch` px apart.
pub(crate) fn steps(length: f64, pitch: f64) -> usize {
    (length / pitch).floor().max(2.0) as usize
}

/// Map from values to places on the page.
pub(crate) struct Area {
    pub corner: [f64; 2],
    pub size: [f64; 2],
    pub x: Ruler,
    pub y: Ruler,
}

impl Area {
    pub fn place(&self, (x, y): (f64, f64)) -> [f64; 2] {
        [self.left(self.x.position(x)), self.top(self.y.position(y))]
    }

    pub fn left(&self, position: f64) -> f64 {
        self.corner[0] + self.size[0] * position
    }

    pub fn top(&self, position: f64) -> f64 {
        self.corner[1] + self.size[1] * (1.0 - position)
    }

    /// Grid, tick labels, zero line and frame.
    pub fn draw(&self, svg: &mut Svg) {
        let ([left, top], [wide, high]) = (self.corner, self.size);
        for (value, _) in &self.x.scale.major {
            let x = self.left(self.x.scale.position(*value));
            svg.line([x, top], [x, top + high], GRID, 1.0);
        }
        for (value, _) in &self.y.scale.major {
            let y = self.top(self.y.scale.position(*value));
            svg.line([left, y], [left + wide, y], GRID, 1.0);
        }
        if !self.y.scale.log && self.y.scale.min < 0.0 && self.y.scale.max > 0.0 {
            let y = self.top(self.y.scale.position(0.0));
            svg.line([left, y], [left + wide, y], GREY, 1.1);
        }
        self.draw_frame(svg);
    }

    /// Tick labels and frame.
    pub fn draw_frame(&self, svg: &mut Svg) {
        let ([left, top], [wide, high]) = (self.corner, self.size);
        let bottom = top + high;
        for (value, text) in &self.x.scale.major {
            let x = self.left(self.x.scale.position(*value));
            svg.line([x, bottom], [x, bottom + 5.0], INK, 1.0);
            svg.text([x, bottom + 15.0], text, Type { size: TICK_PX, anchor: Anchor::Middle, ..Type::default() });
        }
        for (value, text) in &self.y.scale.major {
            let y = self.top(self.y.scale.position(*value));
            svg.line([left - 5.0, y], [left, y], INK, 1.0);
            svg.text([left - 9.0, y], text, Type { size: TICK_PX, anchor: Anchor::End, ..Type::default() });
        }
        for value in &self.x.scale.minor {
            let x = self.left(self.x.scale.position(*value));
            svg.line([x, bottom], [x, bottom + 3.0], INK, 0.7);
        }
        for value in &self.y.scale.minor {
            let y = self.top(self.y.scale.position(*value));
            svg.line([left - 3.0, y], [left, y], INK, 0.7);
        }
        svg.frame([left, top], [wide, high], INK);
    }

    /// The heading, at the top edge `y` of the panel.
    pub fn draw_heading(&self, svg: &mut Svg, y: f64, heading: &str) {
        if !heading.is_empty() {
            let at = [self.corner[0] + 0.5 * self.size[0], y + 10.0];
            let how = Type { size: HEADING_PX, bold: true, anchor: Anchor::Middle, ..Type::default() };
            svg.text(at, heading, how);
        }
    }

    /// The titles below the area and, turned, at the left edge `x` of the panel.
    pub fn draw_titles(&self, svg: &mut Svg, x: f64, below: &str, foot: f64, beside: &str) {
        let ([left, top], [wide, high]) = (self.corner, self.size);
        let middle = Type { size: LABEL_PX, anchor: Anchor::Middle, ..Type::default() };
        if !below.is_empty() {
            svg.text([left + 0.5 * wide, top + high + foot - 12.0], below, middle);
        }
        svg.text([x + 12.0, top + 0.5 * high], beside, Type { upwards: true, ..middle });
    }
}
