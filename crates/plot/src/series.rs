//! Axes, and series of points.

use crate::error::PlotError;
use crate::ticks::MAGNITUDES;

/// Quantity and unit of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The quantity, such as `Contact load`.
    pub label: String,
    /// Unit of the numbers, such as `kN`; empty for a ratio.
    pub unit: String,
    /// A range that the axis covers at least, in the unit; the data extend it.
    pub at_least: Option<(f64, f64)>,
}

impl Axis {
    /// An axis that the data alone scale.
    pub fn new(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { label: label.into(), unit: unit.into(), at_least: None }
    }

    /// The same axis covering a range at least, in its unit.
    #[must_use]
    pub fn covering(mut self, low: f64, high: f64) -> Self {
        self.at_least = Some((low.min(high), low.max(high)));
        self
    }

    /// The least range that holds the bounds and some values; 0 to 1 where there is neither.
    pub(crate) fn range(&self, values: impl Iterator<Item = f64>) -> Result<(f64, f64), PlotError> {
        let start = self.at_least.unwrap_or((f64::INFINITY, f64::NEG_INFINITY));
        if let Some((x, y)) = self.at_least
            && !(drawable(x) && drawable(y))
        {
            return Err(PlotError::NotFinite { series: self.label.clone(), index: 0, x, y });
        }
        let (low, high) = values.fold(start, |(low, high), v| (low.min(v), high.max(v)));
        Ok(if low <= high { (low, high) } else { (0.0, 1.0) })
    }
}

/// True if an axis can show a number: not NaN and small enough.
pub(crate) fn drawable(value: f64) -> bool {
    value.abs() < MAGNITUDES.end
}

/// Style of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeriesKind {
    /// A line.
    Line,
    /// A line with a marker on each of its points: balls, solved rows. Markers of earlier series are larger, so that
    /// those that coincide show as rings about each other.
    MarkedLine,
    /// Open markers only: published or measured values.
    Points,
    /// A thin line without dashes, for histories and spectra: dashes would tear apart what goes up and down many times.
    Dense,
    /// Bars; on a [`crate::BarChart`] only, and the only kind there.
    Bars,
}

/// Treatment of places without a value: balls without contact, rows without a solution.
#[derive(Debug, Clone, PartialEq)]
pub struct Absent {
    /// Name in the legend, such as `no contact`.
    pub label: String,
    /// Abscissas without a value; on a polar chart azimuths in degrees. The line does not go over them, and a cross on
    /// the rim or the lower axis marks each.
    pub at: Vec<f64>,
}

/// A named set of points.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend; the same label has the same style in all panels of a figure.
    pub label: String,
    /// Abscissa and ordinate in the units of the axes; on a polar chart azimuth in degrees and radial value.
    pub points: Vec<(f64, f64)>,
    /// Its style.
    pub kind: SeriesKind,
    /// Place in the order of styles; by default the order in which labels appear in the figure.
    pub slot: Option<usize>,
    /// For points: the label of the line whose colour they take; black without it.
    pub of: Option<String>,
    /// For points: half-width of an error bar on the ordinate, in its unit.
    pub uncertainty: Option<f64>,
    /// A light band behind the line: abscissa, lower and upper edge in the units of the axes; on a polar chart azimuth
    /// in degrees.
    pub band: Option<Vec<(f64, f64, f64)>>,
    /// Abscissas without a value.
    pub absent: Option<Absent>,
}

impl Series {
    /// A line.
    pub fn line(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self {
            label: label.into(),
            points,
            kind: SeriesKind::Line,
            slot: None,
            of: None,
            uncertainty: None,
            band: None,
            absent: None,
        }
    }

    /// The same without values at some abscissas, if there are any.
    #[must_use]
    pub fn without(mut self, label: impl Into<String>, at: Vec<f64>) -> Self {
        self.absent = (!at.is_empty()).then(|| Absent { label: label.into(), at });
        self
    }

    /// Abscissas without a value.
    pub(crate) fn gaps(&self) -> &[f64] {
        self.absent.as_ref().map_or(&[], |absent| &absent.at)
    }

    /// A line with markers.
    pub fn marked(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { kind: SeriesKind::MarkedLine, ..Self::line(label, points) }
    }

    /// Published or measured points.
    pub fn points(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { kind: SeriesKind::Points, ..Self::line(label, points) }
    }

    /// A thin line through many points.
    pub fn dense(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { kind: SeriesKind::Dense, ..Self::line(label, points) }
    }

    /// Bars, one value for each group.
    pub fn bars(label: impl Into<String>, values: &[f64]) -> Self {
        let points = values.iter().enumerate().map(|(group, value)| (group as f64, *value)).collect();
        Self { kind: SeriesKind::Bars, ..Self::line(label, points) }
    }

    pub(crate) fn check(&self) -> Result<(), PlotError> {
        if self.points.is_empty() && self.gaps().is_empty() {
            return Err(PlotError::EmptySeries { series: self.label.clone() });
        }
        if let Some(index) = self.gaps().iter().position(|x| !drawable(*x)) {
            return Err(PlotError::NotFinite { series: self.label.clone(), index, x: self.gaps()[index], y: 0.0 });
        }
        for (index, &(x, low, high)) in self.band.iter().flatten().enumerate() {
            if let Some(&y) = [low, high].iter().find(|y| !(drawable(x) && drawable(**y))) {
                return Err(PlotError::NotFinite { series: self.label.clone(), index, x, y });
            }
        }
        let bar = self.uncertainty.unwrap_or(0.0);
        match self.points.iter().position(|(x, y)| !(drawable(*x) && drawable(y.abs() + bar.abs()))) {
            Some(index) => {
                let (x, y) = self.points[index];
                Err(PlotError::NotFinite { series: self.label.clone(), index, x, y })
            }
            None => Ok(()),
        }
    }

    /// All ordinates with the ends of their error bars and the edges of the band.
    pub(crate) fn ordinates(&self) -> impl Iterator<Item = f64> {
        let bar = self.uncertainty.unwrap_or(0.0).abs();
        let edges = self.band.iter().flatten().flat_map(|(_, low, high)| [*low, *high]);
        self.points.iter().flat_map(move |(_, y)| [y - bar, y + bar]).chain(edges)
    }
}

/// Refuses a panel without series, with a series that cannot be drawn, or with bars where there are none (`bars`
/// false).
pub(crate) fn check_all(panel: &str, series: &[Series], bars: bool) -> Result<(), PlotError> {
    if series.is_empty() {
        return Err(PlotError::NoSeries { panel: panel.to_owned() });
    }
    if let Some(other) = series.iter().find(|s| (s.kind == SeriesKind::Bars) != bars) {
        return Err(PlotError::WrongKind { series: other.label.clone(), panel: panel.to_owned() });
    }
    series.iter().try_for_each(Series::check)
}
