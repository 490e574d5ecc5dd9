//! Marked places on the horizontal axis, their labels spread above the area so that none covers another.

use crate::axes::Area;
use crate::style::{GREY, INK, TICK_PX};
use crate::svg::{Anchor, Svg, Type};
use crate::text::width_with_subscripts;

/// A marked place of the horizontal axis, such as a cage frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Abscissa in the unit of the axis.
    pub at: f64,
    /// Label above the area; an underscore lowers the letters and digits after it, as in `13 f_c`.
    pub label: String,
}

impl Mark {
    /// A mark with its label.
    pub fn new(at: f64, label: impl Into<String>) -> Self {
        Self { at, label: label.into() }
    }
}

/// Height of the lines that lead from the area to the labels, px.
const LEAD: f64 = 20.0;
/// Least distance between labels, px.
const GAP: f64 = 7.0;
/// Farthest that a lying label may be moved from its mark, px; beyond it the labels stand.
const REACH: f64 = 60.0;
/// Width that a standing label takes, px.
const STANDING: f64 = TICK_PX + 2.5;

/// Labels with their places.
pub(crate) struct Layout<'a> {
    /// Mark, its place and that of its label's middle, px from the left edge of the area; ascending.
    placed: Vec<(&'a Mark, f64, f64)>,
    standing: bool,
    /// Room that the labels and their leads take above the area, px.
    pub height: f64,
}

impl<'a> Layout<'a> {
    /// Places the labels of the marks between the ends of an area of a width, px; `position` gives their places, 0 to 1
    /// inside.
    ///
    /// If even standing labels do not all fit, the first marks keep theirs.
    pub fn new(marks: &'a [Mark], wide: f64, position: impl Fn(f64) -> f64) -> Self {
        let inside =
            |mark: &'a Mark| Some(position(mark.at)).filter(|p| (0.0..=1.0).contains(p)).map(|p| (mark, p * wide));
        let mut shown: Vec<(&Mark, f64)> = marks.iter().filter_map(inside).collect();
        if shown.is_empty() {
            return Self { placed: Vec::new(), standing: false, height: 0.0 };
        }
        shown.truncate((wide / STANDING) as usize);
        shown.sort_by(|a, b| a.1.total_cmp(&b.1));
        let places: Vec<f64> = shown.iter().map(|(_, x)| *x).collect();
        let widths: Vec<f64> = shown.iter().map(|(m, _)| width_with_subscripts(&m.label, TICK_PX)).collect();
        let apart: Vec<f64> = widths.iter().map(|w| w + GAP).collect();
        let lying = Some(spread_out(&places, &apart, wide)).filter(|middles| {
            let near = places.iter().zip(middles).all(|(x, middle)| (x - middle).abs() <= REACH);
            near && apart.iter().sum::<f64>() <= wide
        });
        let standing = lying.is_none();
        let longest = widths.iter().fold(0.0, |most: f64, w| most.max(*w));
        let height = LEAD + 8.0 + if standing { longest } else { TICK_PX };
        let middles = lying.unwrap_or_else(|| spread_out(&places, &vec![STANDING; places.len()], wide));
        let placed = shown.iter().zip(middles).map(|((mark, x), middle)| (*mark, *x, middle)).collect();
        Self { placed, standing, height }
    }

    /// Draws the lines through the area and the labels above it.
    pub fn draw(&self, svg: &mut Svg, area: &Area) {
        let [left, top] = area.corner;
        for (mark, x, middle) in &self.placed {
            svg.dashed_line([left + x, top + area.size[1]], [left + x, top], GREY, 0.9);
            svg.line([left + x, top], [left + middle, top - LEAD], GREY, 0.9);
            let how = Type { size: TICK_PX, colour: INK, subscripts: true, ..Type::default() };
            if self.standing {
                let at = [left + middle, top - LEAD - 4.0];
                svg.text(at, &mark.label, Type { upwards: true, anchor: Anchor::Start, ..how });
            } else {
                let at = [left + middle, top - LEAD - 0.75 * TICK_PX];
                svg.text(at, &mark.label, Type { anchor: Anchor::Middle, ..how });
            }
        }
    }
}

/// Middles of labels of given widths, in the order of their places and without overlap between 0 and `length`, that are
/// nearest to the places in the sum of squares.
///
/// Less the widths before it each middle must not fall: isotonic regression, by merging neighbours that would.
fn spread_out(places: &[f64], widths: &[f64], length: f64) -> Vec<f64> {
    let mut before = 0.0;
    let offsets: Vec<f64> = widths
        .iter()
        .map(|w| {
            before += w;
            before - 0.5 * w
        })
        .collect();
    let mut blocks: Vec<(f64, usize)> = Vec::new();
    for (place, offset) in places.iter().zip(&offsets) {
        let mut block = (place - offset, 1);
        while let Some(last) = blocks.last().copied().filter(|last| last.0 > block.0) {
            let count = last.1 + block.1;
            block = ((last.0 * last.1 as f64 + block.0 * block.1 as f64) / count as f64, count);
            blocks.pop();
        }
        blocks.push(block);
    }
    let most = (length - before).max(0.0);
    let shifts = blocks.iter().flat_map(|(shift, count)| std::iter::repeat_n(shift.clamp(0.0, most), *count));
    shifts.zip(&offsets).map(|(shift, offset)| shift + offset).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_labels_with_room_stay_at_their_places() {
        assert_eq!(spread_out(&[50.0, 200.0, 400.0], &[40.0; 3], 500.0), [50.0, 200.0, 400.0]);
        assert_eq!(spread_out(&[5.0, 495.0], &[40.0; 2], 500.0), [20.0, 480.0]);
    }

    #[test]
    fn identity_labels_keep_order_and_distance_and_stay_inside() {
        for crowd in 0..60 {
            let places: Vec<f64> = (0..12).map(|k| 150.0 + 7.0 * f64::from((k * k + crowd) % 29)).collect();
            let mut places = places;
            places.sort_by(f64::total_cmp);
            let widths: Vec<f64> = (0..12).map(|k| 20.0 + f64::from((k * 13 + crowd) % 17)).collect();
            let middles = spread_out(&places, &widths, 500.0);
            for k in 1..12 {
                let needed = 0.5 * (widths[k - 1] + widths[k]);
                assert!(middles[k] - middles[k - 1] >= needed - 1e-9, "{middles:?}");
            }
            assert!(middles[0] >= 0.5 * widths[0] - 1e-9 && middles[11] <= 500.0 - 0.5 * widths[11] + 1e-9);
        }
    }

    #[test]
    fn limit_a_crowd_stands_and_the_first_marks_keep_their_labels() {
        let marks: Vec<Mark> = (0..100).map(|k| Mark::new(0.01 * f64::from(99 - k), format!("{k} f_c"))).collect();
        let layout = Layout::new(&marks, 300.0, |at| at);
        assert!(layout.standing);
        assert_eq!(layout.placed.len(), 20);
        assert!(layout.placed.iter().all(|(mark, ..)| mark.at > 0.795));
        let outside = [Mark::new(2.0, "out")];
        assert_eq!(Layout::new(&outside, 300.0, |at| at).height, 0.0);
    }
}
