//! The one style of all figures: colours, dashes, line widths, markers and type sizes.

/// Okabe and Ito's colours that stay apart under the common forms of colour blindness, darkest contrasts first (M.
/// Okabe, K. Ito, "Color Universal Design", 2008, <https://jfly.uni-koeln.de/color/>). Yellow is last: it is faint on
/// white.
pub(crate) const PALETTE: [&str; 7] = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#F0E442"];

/// Dash patterns, px. Their number is coprime to that of the colours, so that 42 series differ in the pair.
pub(crate) const DASHES: [&str; 6] = ["", "9 4", "2.5 3.5", "11 3.5 2.5 3.5", "5.5 3.5", "11 3 2.5 3 2.5 3"];

/// Text and frames.
pub(crate) const INK: &str = "#1A1A1A";
/// Minor text and the zero line.
pub(crate) const GREY: &str = "#6E6E6E";
/// Grid lines.
pub(crate) const GRID: &str = "#DCDCDC";
/// Background, and the ground of labels on top of grid lines.
pub(crate) const PAPER: &str = "#FFFFFF";

/// Figure titles, px.
pub(crate) const TITLE_PX: f64 = 16.0;
/// Panel headings, px.
pub(crate) const HEADING_PX: f64 = 14.0;
/// Axis titles and legends, px.
pub(crate) const LABEL_PX: f64 = 13.5;
/// Tick labels, px. Above 6 px when a figure is printed at half size.
pub(crate) const TICK_PX: f64 = 12.5;

/// Shapes of markers. No two look alike when filled and small.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Marker {
    Circle,
    Square,
    Triangle,
    Diamond,
    Wedge,
}

const MARKERS: [Marker; 5] = [Marker::Circle, Marker::Square, Marker::Triangle, Marker::Diamond, Marker::Wedge];

/// Size of the marker of the topmost line, and how much larger those of each line below it are, px.
const MARKER: [f64; 2] = [4.2, 1.3];
/// Most lines on top of a line that still widen it and its markers.
const WIDENED: usize = 4;

/// Style of one series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stroke {
    pub colour: &'static str,
    pub dash: &'static str,
    pub width: f64,
    pub marker: Marker,
    /// Size of filled markers, px.
    pub marker_px: f64,
    /// True if bars are hatched: all colours are in use already.
    pub hatched: bool,
}

/// The stroke of line `slot` that has `above` lines drawn on top of it in its panel.
///
/// Later lines are thinner and lie on the earlier ones, so that curves that coincide show as a coloured core in a
/// coloured casing instead of hiding each other.
pub(crate) fn line_stroke(slot: usize, above: usize) -> Stroke {
    Stroke {
        colour: PALETTE[slot % PALETTE.len()],
        dash: DASHES[slot % DASHES.len()],
        width: 1.6 + 0.55 * above.min(WIDENED) as f64,
        marker: MARKERS[slot % MARKERS.len()],
        marker_px: MARKER[0] + MARKER[1] * above.min(WIDENED) as f64,
        hatched: slot >= PALETTE.len(),
    }
}

/// The stroke of published points: the colour of the run that they belong to, or black.
pub(crate) fn point_stroke(index: usize, of_slot: Option<usize>) -> Stroke {
    Stroke {
        colour: of_slot.map_or(INK, |slot| PALETTE[slot % PALETTE.len()]),
        dash: "",
        width: 1.5,
        // Where colour tells them apart the shape is that of all published points.
        marker: if of_slot.is_some() { Marker::Diamond } else { MARKERS[(index + 3) % MARKERS.len()] },
        marker_px: MARKER[0],
        hatched: false,
    }
}

/// The stroke of a published number across a panel: that of no series, in the colour of the line it belongs to, or
/// black.
pub(crate) fn reference_stroke(colour: Option<&'static str>) -> Stroke {
    let colour = colour.unwrap_or(INK);
    Stroke { colour, dash: "7 2.5 1.5 2.5", width: 1.3, marker: MARKERS[0], marker_px: MARKER[0], hatched: false }
}

/// The stroke of a line of so many points that dashes would tear it apart.
pub(crate) fn dense_stroke(slot: usize) -> Stroke {
    Stroke { dash: "", width: 1.1, ..line_stroke(slot, 0) }
}
