//! Axes, series of points, and the style that each label keeps through all panels of a figure.

use crate::error::PlotError;
use crate::references::{Reference, entry};
use crate::style::{Stroke, dense_stroke, line_stroke, point_stroke};
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

/// An entry of a legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Series(SeriesKind),
    /// Abscissas or cells without a value.
    Absent,
    /// A published number: a line, or a range; upright or level.
    Reference {
        range: bool,
        upright: bool,
    },
}

impl Kind {
    const POINTS: Self = Self::Series(SeriesKind::Points);

    pub fn is_reference(self) -> bool {
        matches!(self, Self::Reference { .. })
    }

    fn is_points(self) -> bool {
        self == Self::POINTS
    }

    fn is_line(self) -> bool {
        matches!(self, Self::Series(_)) && !self.is_points()
    }
}

/// One line of a legend.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Entry {
    pub label: String,
    pub kind: Kind,
    pub stroke: Stroke,
}

/// A series with its style.
pub(crate) type Drawn<'a> = (&'a Series, &'a Entry);

/// The styles of all labels of a figure.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct StyleBook {
    pub entries: Vec<Entry>,
}

impl StyleBook {
    /// The book of a figure with the series of each panel and the published numbers of all.
    pub fn new(panels: &[&[Series]], references: &[&Reference]) -> Self {
        let is_line = |s: &&Series| s.kind != SeriesKind::Points;
        let mut lines: Vec<(&Series, usize)> = Vec::new();
        for series in panels.iter().copied().flatten().filter(is_line) {
            if !lines.iter().any(|(known, _)| known.label == series.label) {
                let next = lines.iter().map(|(_, slot)| slot + 1).max().unwrap_or(0);
                lines.push((series, series.slot.unwrap_or(next)));
            }
        }
        lines.sort_by_key(|(_, slot)| *slot);
        let slot_of = |label: &str| lines.iter().find(|(s, _)| s.label == label).map(|(_, slot)| *slot);
        // Lines drawn after this one in the panel where most of them are.
        let above = |label: &str, slot: usize| {
            let here = panels.iter().filter(|panel| panel.iter().any(|s| is_line(&s) && s.label == label));
            let later = |panel: &&[Series]| {
                panel.iter().filter(is_line).filter(|s| slot_of(&s.label).is_some_and(|other| other > slot)).count()
            };
            here.map(later).max().unwrap_or(0)
        };
        let mut entries: Vec<Entry> = lines
            .iter()
            .map(|(s, slot)| Entry {
                label: s.label.clone(),
                kind: Kind::Series(s.kind),
                stroke: match s.kind {
                    SeriesKind::Dense => dense_stroke(*slot),
                    _ => line_stroke(*slot, above(&s.label, *slot)),
                },
            })
            .collect();
        let first_points = entries.len();
        for series in panels.iter().copied().flatten().filter(|s| s.kind == SeriesKind::Points) {
            if entries[first_points..].iter().all(|e| e.label != series.label) {
                let stroke = point_stroke(entries.len() - first_points, series.of.as_deref().and_then(slot_of));
                entries.push(Entry { label: series.label.clone(), kind: Kind::POINTS, stroke });
            }
        }
        entries.extend(absent_entries(panels));
        let first_references = entries.len();
        for reference in references {
            if entries[first_references..].iter().all(|e| e.label != reference.label) {
                entries.push(entry(reference, reference.of.as_deref().and_then(slot_of)));
            }
        }
        Self { entries }
    }

    /// Lines with their style, widest first, then points.
    pub fn ordered<'a>(&'a self, series: &'a [Series]) -> (Vec<Drawn<'a>>, Vec<Drawn<'a>>) {
        let same = |s: &Series, e: &Entry| {
            s.label == e.label && if s.kind == SeriesKind::Points { e.kind.is_points() } else { e.kind.is_line() }
        };
        let found = self.entries.iter().flat_map(|e| series.iter().filter(move |s| same(s, e)).map(move |s| (s, e)));
        found.partition(|(s, _)| s.kind != SeriesKind::Points)
    }
}

/// One entry for each name of what has no value.
fn absent_entries(panels: &[&[Series]]) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for absent in panels.iter().copied().flatten().filter_map(|s| s.absent.as_ref()) {
        if entries.iter().all(|e| e.label != absent.label) {
            entries.push(absent_entry(absent.label.clone()));
        }
    }
    entries
}

/// The entry of what has no value.
pub(crate) fn absent_entry(label: String) -> Entry {
    Entry { label, kind: Kind::Absent, stroke: point_stroke(0, None) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_a_label_keeps_its_style_in_every_panel() {
        let line = |label: &str| Series::line(label, vec![(0.0, 1.0)]);
        let published = Series { of: Some("b".into()), ..Series::points("b, published", vec![(0.0, 1.0)]) };
        let panels: [&[Series]; 2] = [&[line("a"), line("b"), published], &[line("b"), line("a")]];
        let book = StyleBook::new(&panels, &[]);
        let labels: Vec<_> = book.entries.iter().map(|e| e.label.as_str()).collect();
        assert_eq!(labels, ["a", "b", "b, published"]);
        assert_eq!(book.entries[1].stroke.colour, book.entries[2].stroke.colour);
        assert_ne!(book.entries[0].stroke.colour, book.entries[1].stroke.colour);
        assert_ne!(book.entries[0].stroke.dash, book.entries[1].stroke.dash);
        assert!(book.entries[0].stroke.width > book.entries[1].stroke.width);
    }
}
