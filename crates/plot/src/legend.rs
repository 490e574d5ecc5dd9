//! The legend of a figure: one entry for each label, in centred rows.

use crate::book::{Entry, Kind};
use crate::reference_marks;
use crate::series::SeriesKind;
use crate::style::LABEL_PX;
use crate::svg::{Svg, Type};
use crate::text::width;

/// Height of a row, px.
const ROW: f64 = 22.0;
/// Length of the sample of a line, px.
const SAMPLE: f64 = 44.0;
/// Width and height of the sample of bars, px.
const SWATCH: [f64; 2] = [22.0, 13.0];
/// Distances from sample to text and from text to the next sample, px.
const GAPS: [f64; 2] = [8.0, 26.0];

fn sample_width(entry: &Entry) -> f64 {
    match entry.kind {
        Kind::Series(SeriesKind::Points) | Kind::Absent => 12.0,
        Kind::Series(SeriesKind::Bars) => SWATCH[0],
        Kind::Series(SeriesKind::Line | SeriesKind::MarkedLine | SeriesKind::Dense) => SAMPLE,
        Kind::Reference { range, upright } => reference_marks::sample_width(range, upright),
    }
}

/// Width of an entry, px.
pub(crate) fn entry_width(entry: &Entry) -> f64 {
    sample_width(entry) + GAPS[0] + width(&entry.label, LABEL_PX, false)
}

/// Draws the legend in centred rows and returns its height.
pub(crate) fn draw_legend(svg: &mut Svg, entries: &[Entry], [middle, top]: [f64; 2], inner: f64) -> f64 {
    let mut rows: Vec<(f64, Vec<&Entry>)> = Vec::new();
    for entry in entries {
        let wide = entry_width(entry);
        match rows.last_mut() {
            Some((used, row)) if *used + GAPS[1] + wide <= inner => {
                *used += GAPS[1] + wide;
                row.push(entry);
            }
            _ => rows.push((wide, vec![entry])),
        }
    }
    for (i, (used, row)) in rows.iter().enumerate() {
        let y = top + ROW * (i as f64 + 0.5);
        let mut x = middle - 0.5 * used;
        for entry in row {
            let sample = sample_width(entry);
            draw_sample(svg, entry, [x, y], sample);
            svg.text([x + sample + GAPS[0], y], &entry.label, Type::default());
            x += entry_width(entry) + GAPS[1];
        }
    }
    ROW * rows.len() as f64
}

fn draw_sample(svg: &mut Svg, entry: &Entry, [x, y]: [f64; 2], wide: f64) {
    let middle = [x + 0.5 * wide, y];
    let kind = match entry.kind {
        Kind::Series(kind) => kind,
        Kind::Absent => return svg.cross(middle, entry.stroke.colour),
        Kind::Reference { range, upright } => {
            return reference_marks::draw_sample(svg, [x, y], range, upright, &entry.stroke);
        }
    };
    match kind {
        SeriesKind::Bars => svg.bar([x, y - 0.5 * SWATCH[1]], SWATCH, &entry.stroke),
        SeriesKind::Points => svg.marker(middle, &entry.stroke, true),
        SeriesKind::Line => svg.path(&[[x, y], [x + wide, y]], &entry.stroke, false),
        SeriesKind::Dense => {
            // The line itself is thin: its colour shows in a thicker sample.
            let stroke = crate::style::Stroke { width: 2.2, ..entry.stroke };
            svg.path(&[[x, y], [x + wide, y]], &stroke, false);
        }
        SeriesKind::MarkedLine => {
            svg.path(&[[x, y], [x + wide, y]], &entry.stroke, false);
            svg.marker(middle, &entry.stroke, false);
        }
    }
}
