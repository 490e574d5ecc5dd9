//! The style that each label keeps through all panels of a figure.

use crate::references::Reference;
use crate::series::{Series, SeriesKind};
use crate::style::{PALETTE, Stroke, dense_stroke, line_stroke, point_stroke, reference_stroke};

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

/// The legend's entry of a reference; `slot` is the style of the line that it belongs to.
fn entry(reference: &Reference, slot: Option<usize>) -> Entry {
    let kind = Kind::Reference { range: reference.place.is_range(), upright: !reference.place.on_ordinate() };
    let stroke = reference_stroke(slot.map(|slot| PALETTE[slot % PALETTE.len()]));
    Entry { label: reference.label.clone(), kind, stroke }
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
