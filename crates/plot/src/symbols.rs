//! Markers on lines and published points, for charts of any coordinates.

use crate::series::{Drawn, SeriesKind, marked_points};
use crate::svg::Svg;

/// Half the length of the caps of an error bar, px.
const CAP: f64 = 3.5;
/// Width of error bars, px.
const BAR: f64 = 1.4;

/// Draws the markers of marked lines, staggered.
pub(crate) fn draw_markers(svg: &mut Svg, lines: &[Drawn], place: impl Fn((f64, f64)) -> [f64; 2]) {
    for (order, (series, entry)) in lines.iter().enumerate() {
        if series.kind == SeriesKind::MarkedLine {
            for i in marked_points(series.points.len(), order, lines.len()) {
                svg.marker(place(series.points[i]), &entry.stroke, false);
            }
        }
    }
}

/// Draws open markers with their error bars.
pub(crate) fn draw_points(svg: &mut Svg, points: &[Drawn], place: impl Fn((f64, f64)) -> [f64; 2]) {
    for (series, entry) in points {
        for &(x, y) in &series.points {
            if let Some(bar) = series.uncertainty {
                let [from, to] = [place((x, y - bar)), place((x, y + bar))];
                svg.line(from, to, entry.stroke.colour, BAR);
                let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
                let part = CAP / dx.hypot(dy).max(f64::MIN_POSITIVE);
                for [x, y] in [from, to] {
                    let (across, up) = (part * dy, part * dx);
                    svg.line([x - across, y + up], [x + across, y - up], entry.stroke.colour, BAR);
                }
            }
            svg.marker(place((x, y)), &entry.stroke, true);
        }
    }
}
