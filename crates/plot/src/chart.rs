//! The common interface of charts in a figure.

use crate::book::StyleBook;
use crate::error::PlotError;
use crate::references::Reference;
use crate::series::Series;
use crate::svg::Svg;

/// A chart of any kind.
pub(crate) trait Chart {
    fn title(&self) -> &str;

    /// The quantities drawn against each other, in words.
    fn axes(&self) -> String;

    fn series(&self) -> &[Series];

    fn references(&self) -> &[Reference];

    /// Name in the legend of what has no value, where no series says it.
    fn absent(&self) -> Option<&str> {
        None
    }

    /// Refuses what cannot be drawn.
    fn check(&self) -> Result<(), PlotError>;

    /// Width and height with a heading, px.
    fn size(&self, heading: &str) -> Result<[f64; 2], PlotError>;

    fn draw(&self, svg: &mut Svg, spot: &Spot) -> Result<(), PlotError>;
}

/// Place of a chart and its means of drawing.
pub(crate) struct Spot<'a> {
    /// Upper left corner, px.
    pub at: [f64; 2],
    pub heading: &'a str,
    pub book: &'a StyleBook,
}
