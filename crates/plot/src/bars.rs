//! Bar charts: values of groups side by side or stacked.

use crate::axes::{AREA_PX, Area, RIGHT, Ruler, head, steps};
use crate::book::Drawn;
use crate::chart::{Chart, Spot};
use crate::error::PlotError;
use crate::references::Reference;
use crate::series::{Axis, Series, check_all};
use crate::style::{HEADING_PX, TICK_PX};
use crate::svg::{Anchor, Svg, Type};
use crate::text::{axis_title, short_number, width};
use crate::ticks::Scale;

/// Bars over named groups, from zero, with their values written at their ends.
#[derive(Debug, Clone, PartialEq)]
pub struct BarChart {
    /// Heading of the panel.
    pub title: String,
    /// The vertical axis; zero is always on it.
    pub y: Axis,
    /// Names of the groups, from left to right; long ones are broken at spaces.
    pub groups: Vec<String>,
    /// Bars ([`Series::bars`]), each with the index of its group as abscissa.
    pub series: Vec<Series>,
    /// True if the bars of a group stand on each other: positive values upwards from zero, negative ones downwards.
    pub stacked: bool,
    /// Width and height of the area between the axes, px; wider where the names of the groups need it.
    pub area_px: [f64; 2],
}

/// Height of a line of a group's name, px.
const LINE: f64 = 16.0;
/// Part of a group's width that its bars take.
const FILLED: f64 = 0.78;
/// Distance between the end of a bar and its value, px.
const OFF: f64 = 4.0;
/// Least height of a stacked bar that has its value inside, px.
const TALL: f64 = 19.0;

/// Format of written values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Values {
    Lying,
    Standing,
    /// The bars are too narrow.
    Absent,
}

/// A value to be written at the end of a bar or stack.
struct Label {
    x: f64,
    value: f64,
    text: String,
}

impl BarChart {
    /// Bars side by side in the usual size.
    pub fn new(title: impl Into<String>, y: Axis, groups: Vec<String>, series: Vec<Series>) -> Self {
        Self { title: title.into(), y, groups, series, stacked: false, area_px: AREA_PX }
    }

    /// The same bars stacked.
    #[must_use]
    pub fn stacked(mut self) -> Self {
        self.stacked = true;
        self
    }

    /// Width of the area, px.
    fn wide(&self) -> f64 {
        let words = self.groups.iter().flat_map(|g| g.split_whitespace());
        let longest = words.fold(0.0, |most: f64, word| most.max(width(word, TICK_PX, false)));
        self.area_px[0].max((longest + 12.0) * self.groups.len() as f64)
    }

    /// Width of a group, px.
    fn slot(&self) -> f64 {
        self.wide() / self.groups.len() as f64
    }

    /// Width of a bar, px.
    fn bar(&self) -> f64 {
        FILLED * self.slot() / if self.stacked { 1.0 } else { self.series.len() as f64 }
    }

    /// Heights of the positive and negative stack of a group.
    fn stack(&self, group: usize) -> [f64; 2] {
        let values = self.series.iter().flat_map(|s| &s.points).filter(|(x, _)| *x as usize == group);
        values.fold([0.0; 2], |[up, down], (_, v)| [up + v.max(0.0), down + v.min(0.0)])
    }

    /// Values to write, their numbers in the unit of the axis; `left` is the left edge of the area.
    fn labels(&self, left: f64, exponent: i32) -> Vec<Label> {
        let unit = 10f64.powi(exponent);
        let label = |x: f64, value: f64| Label { x, value, text: short_number(value / unit) };
        let mut labels = Vec::new();
        if self.stacked {
            for group in 0..self.groups.len() {
                let x = left + (group as f64 + 0.5) * self.slot();
                let [up, down] = self.stack(group);
                labels.extend((up > 0.0).then(|| label(x, up)));
                labels.extend((down < 0.0).then(|| label(x, down)));
            }
            return labels;
        }
        for (k, series) in self.series.iter().enumerate() {
            labels.extend(
                series.points.iter().map(|(group, v)| label(left + self.bar_left(*group, k) + 0.5 * self.bar(), *v)),
            );
        }
        labels
    }

    /// Left edge of a bar in the area, px.
    fn bar_left(&self, group: f64, series: usize) -> f64 {
        let first = (group + 0.5 - 0.5 * FILLED) * self.slot();
        if self.stacked { first } else { first + series as f64 * self.bar() }
    }

    /// The vertical axis, high enough for the values at the ends of the bars, and how these are written.
    fn ruler(&self) -> Result<(Ruler, Values), PlotError> {
        let ends: Vec<f64> = if self.stacked {
            (0..self.groups.len()).flat_map(|g| self.stack(g)).collect()
        } else {
            self.series.iter().flat_map(Series::ordinates).collect()
        };
        let (low, high) = self.y.range(ends.into_iter().chain([0.0]))?;
        let up = steps(self.area_px[1], 38.0);
        let first = Ruler::new((low, high), false, up, true);
        let widest =
            self.labels(0.0, first.exponent).iter().fold(0.0, |w: f64, l| w.max(width(&l.text, TICK_PX, false)));
        let (values, room) = if widest + 3.0 <= self.bar() / if self.stacked { FILLED } else { 1.0 } {
            (Values::Lying, TICK_PX + 2.0 * OFF)
        } else if self.bar() >= TICK_PX + 1.0 {
            (Values::Standing, widest + 2.0 * OFF)
        } else {
            return Ok((first, Values::Absent));
        };
        // The values need the same room in px whatever the range: each end that has bars takes its part of the height.
        let parts = if low < 0.0 && high > 0.0 { 2.0 } else { 1.0 };
        let grown = (high - low) * room / (self.area_px[1] - parts * room).max(room);
        let range = (if low < 0.0 { low - grown } else { low }, if high > 0.0 { high + grown } else { high });
        Ok((Ruler::new(range, false, up, true), values))
    }

    /// Names of the groups broken into lines that fit.
    fn names(&self) -> Vec<Vec<String>> {
        self.groups.iter().map(|name| broken(name, self.slot() - 8.0)).collect()
    }

    /// Room below the area, px.
    fn foot(&self) -> f64 {
        14.0 + LINE * self.names().iter().map(Vec::len).max().unwrap_or(0) as f64
    }

    fn draw_bars(&self, svg: &mut Svg, area: &Area, bars: &[Drawn], values: Values) {
        let mut stacks = vec![[0.0; 2]; self.groups.len()];
        let unit = 10f64.powi(area.y.exponent);
        for (series, entry) in bars {
            // The order of the chart, not that of the legend, places bars beside each other.
            let place = self.series.iter().position(|s| std::ptr::eq(s, *series)).unwrap_or(0);
            for &(group, value) in &series.points {
                let side = usize::from(value < 0.0);
                let from = if self.stacked { stacks[group as usize][side] } else { 0.0 };
                stacks[group as usize][side] += value;
                let [start, end] = [from, from + value].map(|v| area.top(area.y.position(v)));
                let (top, high) = (start.min(end), (start - end).abs());
                let left = area.corner[0] + self.bar_left(group, place);
                svg.bar([left, top], [self.bar(), high], &entry.stroke);
                // A stack of one bar has its value at its end already.
                let alone = self.stack(group as usize)[side] == value;
                if self.stacked && values == Values::Lying && high >= TALL && !alone {
                    draw_inside(svg, [left + 0.5 * self.bar(), top + 0.5 * high], &short_number(value / unit));
                }
            }
        }
    }

    fn draw_values(&self, svg: &mut Svg, area: &Area, values: Values) {
        for label in self.labels(area.corner[0], area.y.exponent) {
            let end = area.top(area.y.position(label.value));
            let beyond = if label.value < 0.0 { 1.0 } else { -1.0 };
            match values {
                Values::Absent => return,
                Values::Lying => {
                    let at = [label.x, end + beyond * (OFF + 0.5 * TICK_PX)];
                    svg.text(at, &label.text, Type { size: TICK_PX, anchor: Anchor::Middle, ..Type::default() });
                }
                Values::Standing => {
                    let anchor = if label.value < 0.0 { Anchor::End } else { Anchor::Start };
                    let how = Type { size: TICK_PX, upwards: true, anchor, ..Type::default() };
                    svg.text([label.x, end + beyond * OFF], &label.text, how);
                }
            }
        }
    }
}

impl Chart for BarChart {
    fn title(&self) -> &str {
        &self.title
    }

    fn axes(&self) -> String {
        format!("{} of {}", self.y.label, self.groups.join(", "))
    }

    fn series(&self) -> &[Series] {
        &self.series
    }

    /// The values stand at the bars' ends already.
    fn references(&self) -> &[Reference] {
        &[]
    }

    fn check(&self) -> Result<(), PlotError> {
        check_all(&self.title, &self.series, true)?;
        let groups = self.groups.len();
        for series in &self.series {
            let known = |x: f64| x >= 0.0 && x < groups as f64 && x.fract() == 0.0;
            if let Some((value, _)) = series.points.iter().find(|(x, _)| !known(*x)) {
                return Err(PlotError::NoGroup { series: series.label.clone(), value: *value, groups });
            }
        }
        Ok(())
    }

    fn size(&self, heading: &str) -> Result<[f64; 2], PlotError> {
        let (ruler, _) = self.ruler()?;
        let area = ruler.room() + self.wide() + RIGHT;
        Ok([area.max(width(heading, HEADING_PX, true)), head(heading) + self.area_px[1] + self.foot()])
    }

    fn draw(&self, svg: &mut Svg, Spot { at: [x, y], heading, book }: &Spot) -> Result<(), PlotError> {
        let (ruler, values) = self.ruler()?;
        let corner = [x + ruler.room(), y + head(heading)];
        // Groups are not numbers: an axis without marks.
        let scale = Scale { min: 0.0, max: self.groups.len() as f64, major: Vec::new(), minor: Vec::new(), log: false };
        let area = Area { corner, size: [self.wide(), self.area_px[1]], x: Ruler { scale, exponent: 0 }, y: ruler };
        area.draw_heading(svg, *y, heading);
        area.draw(svg);
        let beside = axis_title(&self.y.label, &self.y.unit, area.y.exponent);
        area.draw_titles(svg, *x, "", 0.0, &beside);
        let (bars, _) = book.ordered(&self.series);
        self.draw_bars(svg, &area, &bars, values);
        self.draw_values(svg, &area, values);
        for (group, lines) in self.names().iter().enumerate() {
            let middle = area.left((group as f64 + 0.5) / self.groups.len() as f64);
            for (k, line) in lines.iter().enumerate() {
                let at = [middle, corner[1] + self.area_px[1] + 14.0 + LINE * k as f64];
                svg.text(at, line, Type { size: TICK_PX, anchor: Anchor::Middle, ..Type::default() });
            }
        }
        Ok(())
    }
}

/// A value on a white ground in the middle of a stacked bar.
fn draw_inside(svg: &mut Svg, at: [f64; 2], text: &str) {
    svg.ground(at, [width(text, TICK_PX, false) + 6.0, TICK_PX + 2.0]);
    svg.text(at, text, Type { size: TICK_PX, anchor: Anchor::Middle, ..Type::default() });
}

/// A name broken at spaces into lines of at most `wide` px; a word that is longer has its own line.
fn broken(name: &str, wide: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in name.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), TICK_PX, false) <= wide => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(values: &[&[f64]]) -> BarChart {
        let groups = (0..values[0].len()).map(|g| format!("Group number {g}")).collect();
        let series = values.iter().enumerate().map(|(k, v)| Series::bars(format!("s{k}"), v)).collect();
        BarChart::new("t", Axis::new("P", "W"), groups, series)
    }

    #[test]
    fn identity_stacks_add_up_by_sign() {
        let bars = chart(&[&[3.0, -1.0], &[2.0, 4.0], &[-7.0, -2.0]]).stacked();
        assert_eq!((bars.stack(0), bars.stack(1)), ([5.0, -7.0], [4.0, -3.0]));
        let (ruler, _) = bars.ruler().unwrap();
        assert!(ruler.scale.min < -7.0 && ruler.scale.max > 5.0);
    }

    #[test]
    fn limit_zero_is_always_on_the_axis() {
        let (ruler, _) = chart(&[&[101.0, 102.0]]).ruler().unwrap();
        assert_eq!(ruler.scale.min, 0.0);
        let (ruler, _) = chart(&[&[-101.0, -102.0]]).ruler().unwrap();
        assert_eq!(ruler.scale.max, 0.0);
    }

    #[test]
    fn limit_values_stand_where_bars_are_narrow_and_go_where_they_are_too_narrow() {
        let many = |count: usize| {
            let values = vec![123.0; 6];
            chart(&vec![values.as_slice(); count]).ruler().unwrap().1
        };
        assert_eq!((many(1), many(3), many(12)), (Values::Lying, Values::Standing, Values::Absent));
    }

    #[test]
    fn limit_names_break_at_spaces_only() {
        assert_eq!(broken("Drag and churning", 60.0), ["Drag and", "churning"]);
        assert_eq!(broken("Drag and churning", 5.0), ["Drag", "and", "churning"]);
    }

    #[test]
    fn limit_bars_without_a_group_are_refused() {
        let mut bars = chart(&[&[1.0, 2.0]]);
        bars.groups.pop();
        assert!(matches!(bars.check(), Err(PlotError::NoGroup { value: 1.0, groups: 1, .. })));
        bars.series = vec![Series::line("l", vec![(0.0, 1.0)])];
        assert!(matches!(bars.check(), Err(PlotError::WrongKind { .. })));
    }
}
