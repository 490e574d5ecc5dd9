//! Published numbers that hold for a whole panel.

use crate::error::PlotError;
use crate::series::drawable;

/// A published number drawn across a panel as a thin dash-dotted line, or as a light range between two. Values that
/// belong to single abscissas are points instead ([`crate::Series::points`]).
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Name in the legend, such as `published: 1260 Hz`.
    pub label: String,
    /// Place at which it is drawn; the axes reach it.
    pub place: Place,
    /// Label of the line whose colour it takes; black without it.
    pub of: Option<String>,
}

/// Place of a published number, in the units of the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// An ordinate; on a polar chart a circle.
    Value(f64),
    /// A range of ordinates; on a polar chart a ring.
    Range(f64, f64),
    /// An abscissa; on a polar chart a ray at an azimuth in degrees.
    At(f64),
    /// A range of abscissas; on a polar chart the sector from the first azimuth counter-clockwise to the second,
    /// degrees.
    Between(f64, f64),
}

impl Place {
    /// Both numbers, equal where there is one.
    fn ends(self) -> [f64; 2] {
        match self {
            Self::Value(v) | Self::At(v) => [v, v],
            Self::Range(from, to) | Self::Between(from, to) => [from, to],
        }
    }

    /// True if it is a range, drawn as an area.
    pub(crate) fn is_range(self) -> bool {
        matches!(self, Self::Range(..) | Self::Between(..))
    }

    /// True if the numbers are ordinates.
    pub(crate) fn on_ordinate(self) -> bool {
        matches!(self, Self::Value(_) | Self::Range(..))
    }
}

impl Reference {
    /// A black one.
    pub fn new(label: impl Into<String>, place: Place) -> Self {
        Self { label: label.into(), place, of: None }
    }

    /// The same in the colour of a line.
    #[must_use]
    pub fn of(mut self, line: impl Into<String>) -> Self {
        self.of = Some(line.into());
        self
    }
}

/// The numbers of references that lie on the ordinate, or on the abscissa.
pub(crate) fn numbers(references: &[Reference], ordinate: bool) -> impl Iterator<Item = f64> {
    references.iter().filter(move |r| r.place.on_ordinate() == ordinate).flat_map(|r| r.place.ends())
}

/// Refuses numbers that cannot be drawn.
pub(crate) fn check(references: &[Reference]) -> Result<(), PlotError> {
    for reference in references {
        let [x, y] = reference.place.ends();
        if !(drawable(x) && drawable(y)) {
            return Err(PlotError::NotFinite { series: reference.label.clone(), index: 0, x, y });
        }
    }
    Ok(())
}
