//! Line charts: traction curves, convergence, histories.

use crate::error::PlotError;
use crate::series::{Axis, Drawn, Series, SeriesKind, StyleBook, check_all, marked_points};
use crate::style::{GREY, GRID, HEADING_PX, INK, LABEL_PX, TICK_PX};
use crate::svg::{Anchor, Svg, Type};
use crate::text::{axis_title, width};
use crate::ticks::{MAGNITUDES, Scale, engineering_exponent, linear, logarithmic, spread};

/// Ordinates against an abscissa, each axis linear or logarithmic.
#[derive(Debug, Clone, PartialEq)]
pub struct LineChart {
    /// Heading of the panel.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Whether the horizontal axis is logarithmic.
    pub log_x: bool,
    /// Whether the vertical axis is logarithmic.
    pub log_y: bool,
    /// The curves and published points.
    pub series: Vec<Series>,
    /// Width and height of the area between the axes, px.
    pub area_px: [f64; 2],
}

/// Room above the area, without and with a heading, px.
const HEAD: [f64; 2] = [10.0, 30.0];
/// Room below the axis for tick labels and title, px.
const FOOT: f64 = 50.0;
/// Room at the left for the title and its distance from the tick labels, px.
const SIDE: f64 = 38.0;
/// Room at the right for half a tick label, px.
const RIGHT: f64 = 26.0;
/// Width of a column in which a dense line is reduced to its first, least, greatest and last point, px.
const COLUMN: f64 = 0.5;

/// An axis ready for drawing.
struct Ruler {
    scale: Scale,
    exponent: i32,
}

impl Ruler {
    /// Position along the axis, 0 to 1, of a value in the unit of the axis.
    fn position(&self, value: f64) -> f64 {
        self.scale.position(value / 10f64.powi(self.exponent))
    }
}

/// Where values lie on the page.
struct Area {
    corner: [f64; 2],
    size: [f64; 2],
    x: Ruler,
    y: Ruler,
}

impl Area {
    fn place(&self, (x, y): (f64, f64)) -> [f64; 2] {
        [self.left(self.x.position(x)), self.top(self.y.position(y))]
    }

    fn left(&self, position: f64) -> f64 {
        self.corner[0] + self.size[0] * position
    }

    fn top(&self, position: f64) -> f64 {
        self.corner[1] + self.size[1] * (1.0 - position)
    }
}

impl LineChart {
    /// A chart with linear axes in the usual size.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis, series: Vec<Series>) -> Self {
        Self { title: title.into(), x, y, log_x: false, log_y: false, series, area_px: [380.0, 270.0] }
    }

    /// The same chart with both axes logarithmic, as for convergence.
    #[must_use]
    pub fn log_log(mut self) -> Self {
        (self.log_x, self.log_y) = (true, true);
        self
    }

    pub(crate) fn check(&self) -> Result<(), PlotError> {
        check_all(&self.title, &self.series)?;
        for (axis, log, vertical) in [(&self.x, self.log_x, false), (&self.y, self.log_y, true)] {
            if log {
                self.check_positive(axis, vertical)?;
            }
        }
        Ok(())
    }

    fn check_positive(&self, axis: &Axis, vertical: bool) -> Result<(), PlotError> {
        let refuse = |series: &str, index, value| {
            Err(PlotError::NotPositive { series: series.to_owned(), index, value, axis: axis.label.clone() })
        };
        if let Some((low, _)) = axis.at_least.filter(|(low, _)| *low < MAGNITUDES.start) {
            return refuse(&axis.label, 0, low);
        }
        for series in &self.series {
            let bar = if vertical { series.uncertainty.unwrap_or(0.0).abs() } else { 0.0 };
            let values = series.points.iter().map(|(x, y)| if vertical { y - bar } else { *x });
            if let Some((index, value)) = values.enumerate().find(|(_, v)| *v < MAGNITUDES.start) {
                return refuse(&series.label, index, value);
            }
        }
        Ok(())
    }

    fn rulers(&self) -> Result<[Ruler; 2], PlotError> {
        let ruler = |range: (f64, f64), log: bool, intervals: usize, snap: bool| {
            if log {
                return Ruler { scale: logarithmic(range), exponent: 0 };
            }
            let (low, high) = spread(range);
            let exponent = engineering_exponent(low.abs().max(high.abs()));
            let unit = 10f64.powi(exponent);
            Ruler { scale: linear((low / unit, high / unit), intervals, snap), exponent }
        };
        let x = self.x.range(self.series.iter().flat_map(|s| s.points.iter().map(|(x, _)| *x)))?;
        let y = self.y.range(self.series.iter().flat_map(Series::ordinates))?;
        // Marks at least 60 px apart across and 38 px apart upwards.
        let most = |length: f64, pitch: f64| (length / pitch).floor().max(2.0) as usize;
        let [across, up] = [most(self.area_px[0], 60.0), most(self.area_px[1], 38.0)];
        Ok([ruler(x, self.log_x, across, false), ruler(y, self.log_y, up, true)])
    }

    /// Room left of the area, px.
    fn left(&self) -> Result<f64, PlotError> {
        let [_, y] = self.rulers()?;
        Ok(SIDE + y.scale.major.iter().fold(0.0, |most: f64, (_, text)| most.max(width(text, TICK_PX, false))))
    }

    /// Height above the area, px.
    fn head(heading: &str) -> f64 {
        if heading.is_empty() { HEAD[0] } else { HEAD[1] }
    }

    pub(crate) fn size(&self, heading: &str) -> Result<[f64; 2], PlotError> {
        let area = self.left()? + self.area_px[0] + RIGHT;
        let title = width(heading, HEADING_PX, true);
        Ok([area.max(title), Self::head(heading) + self.area_px[1] + FOOT])
    }

    pub(crate) fn draw(
        &self,
        svg: &mut Svg,
        [x, y]: [f64; 2],
        heading: &str,
        book: &StyleBook,
    ) -> Result<(), PlotError> {
        let [ruler_x, ruler_y] = self.rulers()?;
        let area =
            Area { corner: [x + self.left()?, y + Self::head(heading)], size: self.area_px, x: ruler_x, y: ruler_y };
        let ([left, top], [wide, high]) = (area.corner, area.size);
        let middle = Type { anchor: Anchor::Middle, ..Type::default() };
        if !heading.is_empty() {
            svg.text([left + 0.5 * wide, y + 10.0], heading, Type { size: HEADING_PX, bold: true, ..middle });
        }
        draw_axes(svg, &area);
        let below = axis_title(&self.x.label, &self.x.unit, area.x.exponent);
        svg.text([left + 0.5 * wide, top + high + 38.0], &below, Type { size: LABEL_PX, ..middle });
        let beside = axis_title(&self.y.label, &self.y.unit, area.y.exponent);
        svg.text([x + 12.0, top + 0.5 * high], &beside, Type { size: LABEL_PX, upwards: true, ..middle });
        let (lines, points) = book.ordered(&self.series);
        draw_lines(svg, &area, &lines);
        draw_points(svg, &area, &points);
        Ok(())
    }
}

fn draw_axes(svg: &mut Svg, area: &Area) {
    let ([left, top], [wide, high]) = (area.corner, area.size);
    let (right, bottom) = (left + wide, top + high);
    for (value, text) in &area.x.scale.major {
        let x = area.left(area.x.scale.position(*value));
        svg.line([x, top], [x, bottom], GRID, 1.0);
        svg.line([x, bottom], [x, bottom + 5.0], INK, 1.0);
        svg.text([x, bottom + 15.0], text, Type { size: TICK_PX, anchor: Anchor::Middle, ..Type::default() });
    }
    for (value, text) in &area.y.scale.major {
        let y = area.top(area.y.scale.position(*value));
        svg.line([left, y], [right, y], GRID, 1.0);
        svg.line([left - 5.0, y], [left, y], INK, 1.0);
        svg.text([left - 9.0, y], text, Type { size: TICK_PX, anchor: Anchor::End, ..Type::default() });
    }
    for value in &area.x.scale.minor {
        let x = area.left(area.x.scale.position(*value));
        svg.line([x, bottom], [x, bottom + 3.0], INK, 0.7);
    }
    for value in &area.y.scale.minor {
        let y = area.top(area.y.scale.position(*value));
        svg.line([left - 3.0, y], [left, y], INK, 0.7);
    }
    if !area.y.scale.log && area.y.scale.min < 0.0 && area.y.scale.max > 0.0 {
        let y = area.top(area.y.scale.position(0.0));
        svg.line([left, y], [right, y], GREY, 1.1);
    }
    svg.frame([left, top], [wide, high], INK);
}

fn draw_lines(svg: &mut Svg, area: &Area, lines: &[Drawn]) {
    for (series, entry) in lines {
        let path: Vec<[f64; 2]> = series.points.iter().map(|p| area.place(*p)).collect();
        svg.path(&reduced(path), &entry.stroke, false);
    }
    for (place, (series, entry)) in lines.iter().enumerate() {
        if series.kind == SeriesKind::MarkedLine {
            for i in marked_points(series.points.len(), place, lines.len()) {
                svg.marker(area.place(series.points[i]), &entry.stroke, false);
            }
        }
    }
}

fn draw_points(svg: &mut Svg, area: &Area, points: &[Drawn]) {
    for (series, entry) in points {
        for &(x, y) in &series.points {
            if let Some(bar) = series.uncertainty {
                let ends = [area.place((x, y - bar)), area.place((x, y + bar))];
                svg.line(ends[0], ends[1], entry.stroke.colour, 1.4);
                for [x, y] in ends {
                    svg.line([x - 3.5, y], [x + 3.5, y], entry.stroke.colour, 1.4);
                }
            }
            svg.marker(area.place((x, y)), &entry.stroke, true);
        }
    }
}

/// A dense line with only those points of each pixel column that show: first, least, greatest and last.
fn reduced(path: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    if path.len() < 2000 {
        return path;
    }
    let column = |p: &[f64; 2]| (p[0] / COLUMN).floor();
    let mut kept = Vec::new();
    for run in path.chunk_by(|a, b| column(a) == column(b)) {
        if run.len() <= 4 {
            kept.extend_from_slice(run);
            continue;
        }
        let height = |i: &usize, j: &usize| run[*i][1].total_cmp(&run[*j][1]);
        let mut show = vec![0, run.len() - 1];
        show.extend((0..run.len()).min_by(height));
        show.extend((0..run.len()).max_by(height));
        show.sort_unstable();
        show.dedup();
        kept.extend(show.into_iter().map(|i| run[i]));
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_reduction_keeps_ends_and_extremes() {
        let path: Vec<[f64; 2]> =
            (0..100_000).map(|i| [i as f64 * 4e-3, 100.0 + 50.0 * (i as f64 * 0.37).sin()]).collect();
        let short = reduced(path.clone());
        assert!(short.len() <= 4 * 801, "{}", short.len());
        assert_eq!((short[0], short[short.len() - 1]), (path[0], path[path.len() - 1]));
        let top = |points: &[[f64; 2]]| points.iter().fold(0.0, |most: f64, p| most.max(p[1]));
        assert_eq!(top(&short), top(&path));
        assert!(short.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
    }

    #[test]
    fn limit_logarithmic_axes_refuse_zero() {
        let series = vec![Series::line("error", vec![(1.0, 1e-3), (2.0, 0.0)])];
        let chart = LineChart::new("c", Axis::new("n", ""), Axis::new("error", "N"), series).log_log();
        assert!(matches!(chart.check(), Err(PlotError::NotPositive { index: 1, value: 0.0, .. })));
    }
}
