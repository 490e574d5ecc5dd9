//! A figure: panels side by side under one title, with one legend below, as SVG or PNG.

use std::sync::Arc;

use resvg::{tiny_skia, usvg};

use crate::bars::BarChart;
use crate::book::{StyleBook, absent_entry};
use crate::cartesian::LineChart;
use crate::chart::{Chart, Spot};
use crate::error::PlotError;
use crate::legend::{draw_legend, entry_width};
use crate::map::MapChart;
use crate::polar::PolarChart;
use crate::references::Reference;
use crate::series::Series;
use crate::style::TITLE_PX;
use crate::svg::{Anchor, Svg, Type};
use crate::text::{BOLD, FAMILY, FONT, width};

/// One chart of a figure.
#[derive(Debug, Clone, PartialEq)]
pub enum Panel {
    /// Over the azimuth.
    Polar(PolarChart),
    /// Ordinate against abscissa.
    Cartesian(LineChart),
    /// Bars over groups.
    Bars(BarChart),
    /// Colours over two quantities.
    Map(MapChart),
}

impl Panel {
    fn chart(&self) -> &dyn Chart {
        match self {
            Self::Polar(chart) => chart,
            Self::Cartesian(chart) => chart,
            Self::Bars(chart) => chart,
            Self::Map(chart) => chart,
        }
    }

    /// The series on it; none on a map.
    pub fn series(&self) -> &[Series] {
        self.chart().series()
    }

    /// Adds a published number; bars and maps have no place for one and stay as they are.
    pub fn publish(&mut self, reference: Reference) {
        match self {
            Self::Polar(chart) => chart.references.push(reference),
            Self::Cartesian(chart) => chart.references.push(reference),
            Self::Bars(_) | Self::Map(_) => {}
        }
    }
}

/// A finished figure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Figure {
    /// Short name in lower case and hyphens, fit for a file name.
    pub name: String,
    /// Title, written above the panels too.
    pub title: String,
    svg: String,
}

/// White border, px.
const BORDER: f64 = 14.0;
/// Least width inside the border: a narrow panel has a legend of several entries in a row all the same, px.
const LEAST_WIDTH: f64 = 500.0;
/// Distance between panels, px.
const BETWEEN: f64 = 18.0;
/// Height of the title, px.
const TITLE_HEIGHT: f64 = 34.0;
/// Greatest width of a bitmap, px: a third of a metre at 1200 dots per inch.
const MAX_WIDTH_PX: u32 = 16_384;

/// Widths of the columns and heights of the rows of panels, px.
struct Grid {
    columns: Vec<f64>,
    rows: Vec<f64>,
}

impl Grid {
    fn new(columns: usize, sizes: &[[f64; 2]]) -> Self {
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let column = |k: usize| most(&mut sizes.iter().skip(k).step_by(columns).map(|s| s[0]));
        Self {
            columns: (0..columns.min(sizes.len())).map(column).collect(),
            rows: sizes.chunks(columns).map(|row| most(&mut row.iter().map(|s| s[1]))).collect(),
        }
    }

    fn span(lengths: &[f64]) -> f64 {
        lengths.iter().sum::<f64>() + BETWEEN * lengths.len().saturating_sub(1) as f64
    }

    fn width(&self) -> f64 {
        Self::span(&self.columns)
    }

    fn height(&self) -> f64 {
        Self::span(&self.rows)
    }

    /// Upper left corner of a panel's cell and the width of the cell.
    fn cell(&self, panel: usize) -> ([f64; 2], f64) {
        let (row, column) = (panel / self.columns.len(), panel % self.columns.len());
        let start = |lengths: &[f64]| lengths.iter().map(|l| l + BETWEEN).sum::<f64>();
        ([start(&self.columns[..column]), start(&self.rows[..row])], self.columns[column])
    }
}

impl Figure {
    /// Draws panels side by side. The same label has the same style in all of them and appears once in the legend.
    ///
    /// # Errors
    ///
    /// No panel, a panel without series, a series without points, a number that is not finite, one that is not positive
    /// on a logarithmic axis, or bars that belong to no group.
    pub fn new(name: impl Into<String>, title: impl Into<String>, panels: &[Panel]) -> Result<Self, PlotError> {
        Self::in_columns(name, title, panels.len(), panels)
    }

    /// Draws panels row by row in a number of columns (0 counts as 1); with one column, one above the other, their axes
    /// aligned.
    ///
    /// # Errors
    ///
    /// Those of [`Figure::new`].
    pub fn in_columns(
        name: impl Into<String>,
        title: impl Into<String>,
        columns: usize,
        panels: &[Panel],
    ) -> Result<Self, PlotError> {
        let (name, title) = (name.into(), title.into());
        if panels.is_empty() {
            return Err(PlotError::NoPanel { figure: name });
        }
        let charts: Vec<&dyn Chart> = panels.iter().map(Panel::chart).collect();
        charts.iter().try_for_each(|chart| chart.check())?;
        let series: Vec<_> = charts.iter().map(|chart| chart.series()).collect();
        let mut book = StyleBook::new(&series, &charts.iter().flat_map(|chart| chart.references()).collect::<Vec<_>>());
        for absent in charts.iter().filter_map(|chart| chart.absent()) {
            if book.entries.iter().all(|entry| entry.label != absent) {
                book.entries.push(absent_entry(absent.to_owned()));
            }
        }
        let headings: Vec<String> =
            charts.iter().enumerate().map(|(i, chart)| heading(i, charts.len(), chart.title())).collect();
        let drawn = || charts.iter().zip(&headings);
        let sizes = drawn().map(|(chart, heading)| chart.size(heading)).collect::<Result<Vec<_>, _>>()?;
        let grid = Grid::new(columns.max(1), &sizes);
        let widest_entry = book.entries.iter().fold(0.0, |most: f64, e| most.max(entry_width(e)));
        let inner = grid.width().max(width(&title, TITLE_PX, true)).max(widest_entry).max(LEAST_WIDTH);
        let full = (inner + 2.0 * BORDER).ceil();

        let mut svg = Svg::default();
        let head = Type { size: TITLE_PX, bold: true, anchor: Anchor::Middle, ..Type::default() };
        svg.text([0.5 * full, BORDER + 8.0], &title, head);
        let top = BORDER + TITLE_HEIGHT;
        let left = 0.5 * (full - grid.width());
        let mut description = title.clone();
        for (i, ((chart, heading), size)) in drawn().zip(&sizes).enumerate() {
            let ([x, y], wide) = grid.cell(i);
            // Right edges in line put axes of one width in line; circles are centred.
            let inset = (wide - size[0]) * if matches!(panels[i], Panel::Polar(_)) { 0.5 } else { 1.0 };
            chart.draw(&mut svg, &Spot { at: [left + x + inset, top + y], heading, book: &book })?;
            let colon = if heading.is_empty() { "" } else { ": " };
            description.push_str(&format!(". {heading}{colon}{}", chart.axes()));
        }
        let below = top + grid.height() + 12.0;
        let legend = draw_legend(&mut svg, &book.entries, [0.5 * full, below], inner);
        let svg = svg.finish([full, below + legend + BORDER], &title, &description);
        Ok(Self { name, title, svg })
    }

    /// A figure that is drawn already.
    pub(crate) fn drawn(name: &str, title: &str, svg: String) -> Self {
        Self { name: name.to_owned(), title: title.to_owned(), svg }
    }

    /// The figure as SVG text. Text stays text, in the viewer's sans-serif face.
    pub fn svg(&self) -> &str {
        &self.svg
    }

    /// The figure as a PNG bitmap of a given width in px; the height follows. The same bytes on every machine with the
    /// same build: the fonts are part of the crate.
    ///
    /// # Errors
    ///
    /// A width of 0 or above 16 384 px.
    pub fn png(&self, width_px: u32) -> Result<Vec<u8>, PlotError> {
        let out_of_range = PlotError::BitmapSize { width_px, max_px: MAX_WIDTH_PX };
        if !(1..=MAX_WIDTH_PX).contains(&width_px) {
            return Err(out_of_range);
        }
        let tree = usvg::Tree::from_str(&self.svg, &options())?;
        let scale = width_px as f32 / tree.size().width();
        let height_px = ((tree.size().height() * scale).round() as u32).max(1);
        let mut bitmap = tiny_skia::Pixmap::new(width_px, height_px).ok_or(out_of_range)?;
        resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut bitmap.as_mut());
        bitmap.encode_png().map_err(|_| PlotError::Encode { width_px, height_px })
    }
}

/// Reading options with the crate's own fonts and no others.
fn options() -> usvg::Options<'static> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(FONT.to_vec());
    fonts.load_font_data(BOLD.to_vec());
    fonts.set_sans_serif_family(FAMILY);
    usvg::Options { fontdb: Arc::new(fonts), font_family: FAMILY.to_owned(), ..usvg::Options::default() }
}

/// `(a) Inner contact`; without the letter when there is one panel.
fn heading(index: usize, panels: usize, title: &str) -> String {
    match char::from_u32('a' as u32 + index as u32) {
        Some(letter) if panels > 1 => format!("({letter}) {title}"),
        _ => title.to_owned(),
    }
}
