//! Markers on lines and published points, for charts of any coordinates.

use crate::book::Drawn;
use crate::series::{Series, SeriesKind};
use crate::svg::Svg;

/// Half the length of the caps of an error bar, px.
const CAP: f64 = 3.5;
/// Width of error bars, px.
const BAR: f64 = 1.4;

/// Draws the markers of marked lines, one for each point, and of points that no line reaches.
///
/// `runs` parts the points of a series where the line does.
pub(crate) fn draw_markers(
    svg: &mut Svg,
    lines: &[Drawn],
    place: impl Fn((f64, f64)) -> [f64; 2],
    runs: impl Fn(&Series) -> Vec<Vec<(f64, f64)>>,
) {
    for (series, entry) in lines {
        if series.kind == SeriesKind::MarkedLine {
            series.points.iter().for_each(|p| svg.marker(place(*p), &entry.stroke, false));
        } else {
            let alone = runs(series).into_iter().filter(|run| run.len() == 1).flatten();
            alone.for_each(|p| svg.marker(place(p), &entry.stroke, false));
        }
    }
}

/// Draws crosses where series have no value; `place` takes the abscissa and the place of the series among those with
/// crosses.
pub(crate) fn draw_absent(svg: &mut Svg, lines: &[Drawn], place: impl Fn(f64, usize) -> [f64; 2]) {
    for (row, (series, entry)) in lines.iter().filter(|(s, _)| s.absent.is_some()).enumerate() {
        series.gaps().iter().for_each(|x| svg.cross(place(*x, row), entry.stroke.colour));
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
