//! Line charts: traction curves, convergence, histories.

use crate::axes::{AREA_PX, Area, BAND, FOOT, RIGHT, Ruler, head, steps};
use crate::book::Drawn;
use crate::chart::{Chart, Spot};
use crate::error::PlotError;
use crate::marks::{Layout, Mark};
use crate::reference_marks::{Drawing, Shape};
use crate::references::{self, Place, Reference};
use crate::series::{Axis, Series, check_all};
use crate::style::HEADING_PX;
use crate::svg::Svg;
use crate::symbols::{draw_absent, draw_markers, draw_points};
use crate::text::{axis_title, width};
use crate::ticks::MAGNITUDES;
use crate::turn::{bands, unrolled, within};

/// Ordinates against an abscissa, each axis linear or logarithmic.
#[derive(Debug, Clone, PartialEq)]
pub struct LineChart {
    /// Heading of the panel.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// True if the horizontal axis is logarithmic.
    pub log_x: bool,
    /// True if the vertical axis is logarithmic.
    pub log_y: bool,
    /// The curves and published points.
    pub series: Vec<Series>,
    /// Marked places of the horizontal axis; those that it does not reach are not shown.
    pub marks: Vec<Mark>,
    /// Published numbers across the area.
    pub references: Vec<Reference>,
    /// True if a length on both axes is the same number, as for paths in a plane; linear axes of one unit only. The
    /// horizontal axis is then widened or the vertical one heightened.
    pub equal_scales: bool,
    /// Width and height of the area between the axes, px.
    pub area_px: [f64; 2],
    /// Kind of the abscissas.
    pub abscissas: Abscissas,
}

/// Kinds of abscissas of a chart.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Abscissas {
    /// Numbers in the unit of the axis.
    #[default]
    Numbers,
    /// Azimuths in degrees, from 0° to 360°; lines go on over the ends.
    Azimuths,
    /// Names, the first at abscissa 0, the next at 1 and so on; no line joins them.
    Names(Vec<String>),
}

/// Size of the area of a chart over the azimuth, px.
const AZIMUTH_PX: [f64; 2] = [300.0, 240.0];
/// Distance of the first series' crosses from the lower axis and of the others' from each other, px.
const ABSENT: f64 = 9.0;

/// Width of a column in which a dense line is reduced to its first, least, greatest and last point, px.
const COLUMN: f64 = 0.5;

impl LineChart {
    /// A chart with linear axes in the usual size.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis, series: Vec<Series>) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            log_x: false,
            log_y: false,
            series,
            marks: Vec::new(),
            references: Vec::new(),
            equal_scales: false,
            area_px: AREA_PX,
            abscissas: Abscissas::Numbers,
        }
    }

    /// Values over azimuths in degrees, for signed quantities, which have no place on a circle.
    pub fn over_azimuth(title: impl Into<String>, y: Axis, series: Vec<Series>) -> Self {
        let chart = Self::new(title, Axis::new("Azimuth", "°"), y, series);
        Self { abscissas: Abscissas::Azimuths, area_px: AZIMUTH_PX, ..chart }
    }

    /// The same chart with both axes logarithmic, as for convergence.
    #[must_use]
    pub fn log_log(mut self) -> Self {
        (self.log_x, self.log_y) = (true, true);
        self
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
            let lower = series.band.iter().flatten().map(|(x, low, _)| if vertical { *low } else { *x });
            let values = series.points.iter().map(|(x, y)| if vertical { y - bar } else { *x }).chain(lower);
            if let Some((index, value)) = values.enumerate().find(|(_, v)| *v < MAGNITUDES.start) {
                return refuse(&series.label, index, value);
            }
        }
        let mut published = references::numbers(&self.references, vertical);
        if let Some(value) = published.find(|v| *v < MAGNITUDES.start) {
            return refuse(&axis.label, 0, value);
        }
        Ok(())
    }

    fn rulers(&self) -> Result<[Ruler; 2], PlotError> {
        let x = self.series.iter().flat_map(|s| s.points.iter().map(|(x, _)| x).chain(s.gaps()).copied());
        let x = self.x.range(x.chain(references::numbers(&self.references, false)))?;
        let y = self.series.iter().flat_map(Series::ordinates);
        let y = self.y.range(y.chain(references::numbers(&self.references, true)))?;
        let (x, y) = if self.equal_scales { self.equal(x, y) } else { (x, y) };
        let across = match &self.abscissas {
            Abscissas::Numbers => Ruler::level(x, self.log_x, self.area_px[0]),
            Abscissas::Azimuths => Ruler::turn(),
            Abscissas::Names(names) => Ruler::names(names),
        };
        // Marks at least 38 px apart upwards.
        Ok([across, Ruler::new(y, self.log_y, steps(self.area_px[1], 38.0), true)])
    }

    /// Points of a series in runs that a line joins.
    fn runs(&self, points: &[(f64, f64)], gaps: &[f64]) -> Vec<Vec<(f64, f64)>> {
        match self.abscissas {
            Abscissas::Numbers => parted(points, gaps),
            Abscissas::Azimuths => unrolled(points, gaps),
            Abscissas::Names(_) => points.iter().map(|p| vec![*p]).collect(),
        }
    }

    /// A point where the axis has it.
    fn on_axis(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let turned = self.abscissas == Abscissas::Azimuths && !(0.0..=360.0).contains(&x);
        (if turned { within(x) } else { x }, y)
    }

    /// Ranges that make the scales equal: that of y such that its axis ends on marks, and that of x of the same scale.
    fn equal(&self, x: (f64, f64), y: (f64, f64)) -> ((f64, f64), (f64, f64)) {
        let [wide, high] = self.area_px;
        let span = ((x.1 - x.0) * high / wide).max(y.1 - y.0);
        let about = |(low, high): (f64, f64), span: f64| (0.5 * (low + high - span), 0.5 * (low + high + span));
        let ruler = Ruler::new(about(y, span), false, steps(high, 38.0), true);
        let unit = 10f64.powi(ruler.exponent);
        let [low, top] = [ruler.scale.min, ruler.scale.max].map(|v| v * unit);
        (about(x, (top - low) * wide / high), (low, top))
    }

    fn marks(&self, x: &Ruler) -> Layout<'_> {
        Layout::new(&self.marks, self.area_px[0], |at| x.position(at))
    }

    /// A published number on the page.
    fn published(&self, area: &Area, place: Place) -> Shape {
        let ([left, top], [wide, high]) = (area.corner, area.size);
        let upright = |x: f64| vec![[area.left(area.x.position(x)), top], [area.left(area.x.position(x)), top + high]];
        let level = |y: f64| vec![[left, area.top(area.y.position(y))], [left + wide, area.top(area.y.position(y))]];
        let outline = |a: &[[f64; 2]], b: &[[f64; 2]]| a.iter().chain(b.iter().rev()).copied().collect();
        let between = |a: Vec<[f64; 2]>, b: Vec<[f64; 2]>| Shape { areas: vec![outline(&a, &b)], edges: vec![a, b] };
        match place {
            Place::Value(y) => Shape::line(level(y)),
            Place::At(x) => Shape::line(upright(self.on_axis((x, 0.0)).0)),
            Place::Range(from, to) => between(level(from), level(to)),
            Place::Between(from, to) if self.abscissas == Abscissas::Azimuths => {
                let [from, to] = [within(from), within(to)];
                if from <= to {
                    return between(upright(from), upright(to));
                }
                // Over 0°: both ends of the axis.
                let [a, b] = [upright(from), upright(to)];
                let areas = vec![outline(&a, &upright(360.0)), outline(&upright(0.0), &b)];
                Shape { areas, edges: vec![a, b] }
            }
            Place::Between(from, to) => between(upright(from), upright(to)),
        }
    }

    fn draw_lines(&self, svg: &mut Svg, area: &Area, lines: &[Drawn]) {
        let place = |run: &[(f64, f64)]| -> Vec<[f64; 2]> { run.iter().map(|p| area.place(*p)).collect() };
        for (series, entry) in lines {
            for [lower, mut upper] in bands(series, |points| self.runs(points, series.gaps())) {
                upper.reverse();
                svg.tint(&[place(&[lower, upper].concat())], entry.stroke.colour, BAND);
            }
        }
        for (series, entry) in lines {
            for run in self.runs(&series.points, series.gaps()).iter().filter(|run| run.len() > 1) {
                // A path turns back: its points are thinned by distance, not by column.
                let shown = if self.equal_scales { thinned(place(run)) } else { reduced(place(run)) };
                svg.path(&shown, &entry.stroke, false);
            }
        }
        let at = |p| area.place(self.on_axis(p));
        draw_markers(svg, lines, at, |series| self.runs(&series.points, series.gaps()));
        let bottom = area.corner[1] + area.size[1];
        draw_absent(svg, lines, |x, row| [at((x, 0.0))[0], bottom - ABSENT * (row + 1) as f64]);
    }
}

impl Chart for LineChart {
    fn title(&self) -> &str {
        &self.title
    }

    fn axes(&self) -> String {
        format!("{} against {}", self.y.label, self.x.label)
    }

    fn series(&self) -> &[Series] {
        &self.series
    }

    fn references(&self) -> &[Reference] {
        &self.references
    }

    fn check(&self) -> Result<(), PlotError> {
        check_all(&self.title, &self.series, false)?;
        references::check(&self.references)?;
        for (axis, log, vertical) in [(&self.x, self.log_x, false), (&self.y, self.log_y, true)] {
            if log {
                self.check_positive(axis, vertical)?;
            }
        }
        Ok(())
    }

    fn size(&self, heading: &str) -> Result<[f64; 2], PlotError> {
        let [x, y] = self.rulers()?;
        let area = y.room() + self.area_px[0] + RIGHT;
        let title = width(heading, HEADING_PX, true);
        Ok([area.max(title), self.marks(&x).height + head(heading) + self.area_px[1] + FOOT])
    }

    fn draw(&self, svg: &mut Svg, Spot { at: [x, y], heading, book }: &Spot) -> Result<(), PlotError> {
        let [ruler_x, ruler_y] = self.rulers()?;
        let marks = self.marks(&ruler_x);
        let corner = [x + ruler_y.room(), y + marks.height + head(heading)];
        let area = Area { corner, size: self.area_px, x: ruler_x, y: ruler_y };
        area.draw_heading(svg, *y, heading);
        area.draw(svg);
        let below = axis_title(&self.x.label, &self.x.unit, area.x.exponent);
        let beside = axis_title(&self.y.label, &self.y.unit, area.y.exponent);
        area.draw_titles(svg, *x, &below, FOOT, &beside);
        marks.draw(svg, &area);
        let published = Drawing::new(&self.references, book, |place| self.published(&area, place));
        published.areas(svg);
        let (lines, points) = book.ordered(&self.series);
        self.draw_lines(svg, &area, &lines);
        published.lines(svg);
        draw_points(svg, &points, |p| area.place(self.on_axis(p)));
        Ok(())
    }
}

/// Points in runs between whose neighbours there is no gap.
fn parted(points: &[(f64, f64)], gaps: &[f64]) -> Vec<Vec<(f64, f64)>> {
    let joined = |a: &(f64, f64), b: &(f64, f64)| {
        let (low, high) = (a.0.min(b.0), a.0.max(b.0));
        !gaps.iter().any(|gap| *gap > low && *gap < high)
    };
    points.chunk_by(joined).map(<[_]>::to_vec).collect()
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

/// A line without the points that are nearer than half a column to the last one kept, its end always kept.
fn thinned(path: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let end = path.last().copied();
    let mut kept: Vec<[f64; 2]> = Vec::new();
    for p in path {
        if kept.last().is_none_or(|q| (p[0] - q[0]).hypot(p[1] - q[1]) >= 0.5 * COLUMN) {
            kept.push(p);
        }
    }
    if kept.last().copied() != end {
        kept.extend(end);
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
    fn identity_equal_scales_are_equal_and_hold_the_data() {
        for (wide, high) in [(3.0, 1.0), (0.2, 7.0), (1e-6, 1e-6)] {
            let series = vec![Series::dense("p", vec![(10.0, -5.0), (10.0 + wide, -5.0 + high)])];
            let chart = LineChart::new("c", Axis::new("x", "µm"), Axis::new("y", "µm"), series);
            let chart = LineChart { equal_scales: true, area_px: [300.0, 200.0], ..chart };
            let [x, y] = chart.rulers().unwrap();
            let [x, y] = [&x.scale, &y.scale];
            let ratio = (x.max - x.min) / 300.0 / ((y.max - y.min) / 200.0);
            assert!((ratio - 1.0).abs() < 1e-6, "{wide} {high} {ratio}");
            assert!(x.min <= 10.0 && x.max >= 10.0 + wide && y.min <= -5.0 && y.max >= -5.0 + high);
        }
    }

    #[test]
    fn identity_thinning_keeps_the_ends_and_stays_near() {
        let path: Vec<[f64; 2]> =
            (0..50_000).map(|i| 1e-3 * i as f64).map(|a| [90.0 * a.cos(), 90.0 * (1.1 * a).sin()]).collect();
        let short = thinned(path.clone());
        assert!(short.len() < path.len() / 2 && short[0] == path[0] && short.last() == path.last());
        let near = |p: &[f64; 2]| short.iter().any(|q| (p[0] - q[0]).hypot(p[1] - q[1]) <= 0.5 * COLUMN);
        assert!(path.iter().step_by(501).all(near));
    }

    #[test]
    fn limit_logarithmic_axes_refuse_zero() {
        let series = vec![Series::line("error", vec![(1.0, 1e-3), (2.0, 0.0)])];
        let chart = LineChart::new("c", Axis::new("n", ""), Axis::new("error", "N"), series).log_log();
        assert!(matches!(chart.check(), Err(PlotError::NotPositive { index: 1, value: 0.0, .. })));
    }
}
