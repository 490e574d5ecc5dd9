//! Maps: a quantity over two others as coloured cells, with lines of equal value and a colour bar.

use crate::axes::{AREA_PX, Area, FOOT, Ruler, head, steps};
use crate::chart::{Chart, Spot};
use crate::colours::{SHADES, colour, shade};
use crate::contour::segments;
use crate::error::PlotError;
use crate::references::Reference;
use crate::series::{Axis, Series, drawable};
use crate::style::{GRID, HEADING_PX, INK, LABEL_PX, PAPER, Stroke, TICK_PX, reference_stroke};
use crate::svg::{Anchor, Svg, Type};
use crate::text::{axis_title, width};
use crate::ticks::MAGNITUDES;

/// Places along an axis of a map, a column or row of cells at each.
#[derive(Debug, Clone, PartialEq)]
pub struct MapAxis {
    /// The quantity.
    pub axis: Axis,
    /// Ascending places in the unit of the axis.
    pub at: Vec<f64>,
    /// True if the axis is logarithmic; places are then positive.
    pub log: bool,
    /// Names of the places in place of numbers.
    pub names: Option<Vec<String>>,
}

impl MapAxis {
    /// Numbers on a linear axis.
    pub fn numbers(axis: Axis, at: Vec<f64>) -> Self {
        Self { axis, at, log: false, names: None }
    }

    /// Names, one beside the other.
    pub fn names(axis: Axis, names: Vec<String>) -> Self {
        Self { axis, at: (0..names.len()).map(|k| k as f64).collect(), log: false, names: Some(names) }
    }

    fn check(&self, panel: &str) -> Result<(), PlotError> {
        let (axis, panel) = (self.axis.label.clone(), panel.to_owned());
        if let Some(index) = self.at.iter().position(|v| !drawable(*v)) {
            return Err(PlotError::NotFinite { series: axis, index, x: self.at[index], y: 0.0 });
        }
        if let Some(index) = self.at.iter().position(|v| self.log && *v < MAGNITUDES.start) {
            return Err(PlotError::NotPositive { series: panel, index, value: self.at[index], axis });
        }
        match self.at.windows(2).position(|pair| pair[0] >= pair[1]) {
            Some(before) => Err(PlotError::Order { panel, axis, index: before + 1 }),
            None => Ok(()),
        }
    }

    /// Edges of cells: half-way to the next place, on a logarithmic axis by ratio.
    fn edges(&self) -> Vec<f64> {
        let to = |v: f64| if self.log { v.ln() } else { v };
        let back = |v: f64| if self.log { v.exp() } else { v };
        let at: Vec<f64> = self.at.iter().map(|v| to(*v)).collect();
        let [first, last] = [at[0], at[at.len() - 1]];
        let alone = if first == 0.0 || self.log { 0.5 } else { 0.5 * first.abs() };
        let step = |pair: Option<&[f64]>| pair.map_or(alone, |pair| 0.5 * (pair[1] - pair[0]));
        let mut edges = vec![first - step(at.get(..2))];
        edges.extend(at.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
        edges.push(last + step(at.get(at.len().saturating_sub(2)..).filter(|pair| pair.len() == 2)));
        edges.into_iter().map(back).collect()
    }

    /// The axis from the first edge to the last.
    fn ruler(&self, length: f64, level: bool) -> Ruler {
        if let Some(names) = &self.names {
            return Ruler::names(names);
        }
        let edges = self.edges();
        let ends = (edges[0], edges[edges.len() - 1]);
        let mut ruler = if level {
            Ruler::level(ends, self.log, length)
        } else {
            Ruler::new(ends, self.log, steps(length, 38.0), false)
        };
        if self.log {
            (ruler.scale.min, ruler.scale.max) = ends;
            let inside = |v: f64| (ends.0..=ends.1).contains(&v);
            ruler.scale.major.retain(|(v, _)| inside(*v));
            ruler.scale.minor.retain(|v| inside(*v));
        }
        ruler
    }
}

/// Content of a cell of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cell {
    /// A value in the unit of the quantity.
    Value(f64),
    /// No value, and that is a result: a grey cell with a cross.
    Absent,
    /// Nothing known: left blank.
    Unknown,
}

/// A quantity over two others.
#[derive(Debug, Clone, PartialEq)]
pub struct MapChart {
    /// Heading of the panel.
    pub title: String,
    /// Columns.
    pub x: MapAxis,
    /// Rows, the first at the bottom.
    pub y: MapAxis,
    /// The quantity shown by colours.
    pub quantity: Axis,
    /// Cells, row by row from the bottom.
    pub cells: Vec<Cell>,
    /// Name of absent cells in the legend, such as `no solution`.
    pub absent: String,
    /// Width and height of the area between the axes, px.
    pub area_px: [f64; 2],
}

/// Distance of the colour bar from the area and its width, px.
const BAR: [f64; 2] = [14.0, 16.0];
/// Room for the title at the right of the bar's labels, px.
const BESIDE: f64 = 36.0;
/// Least size of a cell with a cross, px.
const CROSSED: f64 = 9.0;
/// Least number of places on both axes with lines of equal value.
const LINED: usize = 3;

impl MapChart {
    /// A map in the usual size.
    pub fn new(title: impl Into<String>, x: MapAxis, y: MapAxis, quantity: Axis, cells: Vec<Cell>) -> Self {
        let area_px = [AREA_PX[0] - 60.0, AREA_PX[1]];
        Self { title: title.into(), x, y, quantity, cells, absent: "no value".to_owned(), area_px }
    }

    /// Width of the area, px: wider where names need it.
    fn wide(&self) -> f64 {
        let names = self.x.names.iter().flatten();
        let longest = names.fold(0.0, |most: f64, name| most.max(width(name, TICK_PX, false)));
        self.area_px[0].max((longest + 12.0) * self.x.names.as_ref().map_or(0, Vec::len) as f64)
    }

    fn value(&self, column: usize, row: usize) -> Option<f64> {
        match self.cells[row * self.x.at.len() + column] {
            Cell::Value(value) => Some(value),
            Cell::Absent | Cell::Unknown => None,
        }
    }

    /// The scale of the colours: no wider than the values, marked inside.
    fn colours(&self) -> Result<Ruler, PlotError> {
        let values = self.cells.iter().filter_map(|cell| match cell {
            Cell::Value(value) => Some(*value),
            _ => None,
        });
        Ok(Ruler::new(self.quantity.range(values)?, false, steps(self.area_px[1], 38.0), false))
    }

    fn draw_cells(&self, svg: &mut Svg, area: &Area, colours: &Ruler) {
        let columns: Vec<f64> = self.x.edges().iter().map(|v| area.left(area.x.position(*v))).collect();
        let rows: Vec<f64> = self.y.edges().iter().map(|v| area.top(area.y.position(*v))).collect();
        let shown = |cell: &Cell| match cell {
            Cell::Value(value) => Some(colour(shade(colours.position(*value)))),
            Cell::Absent => Some(GRID.to_owned()),
            Cell::Unknown => None,
        };
        for (row, cells) in self.cells.chunks(self.x.at.len()).enumerate() {
            let (top, high) = (rows[row + 1], rows[row] - rows[row + 1]);
            let shades: Vec<Option<String>> = cells.iter().map(shown).collect();
            let mut column = 0;
            // Neighbours of one colour are one rectangle.
            for run in shades.chunk_by(|a, b| a == b) {
                let (left, right) = (columns[column], columns[column + run.len()]);
                if let Some(colour) = &run[0] {
                    svg.cell([left, top], [right - left, high], colour);
                }
                column += run.len();
            }
            for (column, _) in cells.iter().enumerate().filter(|(_, cell)| **cell == Cell::Absent) {
                let wide = columns[column + 1] - columns[column];
                if wide.min(high) >= CROSSED {
                    svg.cross([columns[column] + 0.5 * wide, top + 0.5 * high], INK);
                }
            }
        }
    }

    /// Lines where the colour bar has its marks, dark on a light casing, so that they show on every colour.
    fn draw_contours(&self, svg: &mut Svg, area: &Area, colours: &Ruler) {
        let named = self.x.names.is_some() || self.y.names.is_some();
        if named || self.x.at.len().min(self.y.at.len()) < LINED {
            return;
        }
        let x: Vec<f64> = self.x.at.iter().map(|v| area.left(area.x.position(*v))).collect();
        let y: Vec<f64> = self.y.at.iter().map(|v| area.top(area.y.position(*v))).collect();
        let unit = 10f64.powi(colours.exponent);
        for (level, _) in &colours.scale.major {
            let pieces = segments(&x, &y, |column, row| self.value(column, row), level * unit);
            for (colour, width) in [(PAPER, 2.4), (INK, 0.9)] {
                svg.pieces(&pieces, &Stroke { colour, width, dash: "", ..reference_stroke(None) });
            }
        }
    }

    /// The bar with its labels and title; returns nothing of the area.
    fn draw_bar(&self, svg: &mut Svg, area: &Area, colours: &Ruler) {
        let ([left, top], [_, high]) = ([area.corner[0] + area.size[0] + BAR[0], area.corner[1]], area.size);
        for shade in 0..SHADES {
            let from = top + high * (1.0 - (shade + 1) as f64 / SHADES as f64);
            svg.cell([left, from], [BAR[1], high / SHADES as f64], &colour(shade));
        }
        svg.frame([left, top], [BAR[1], high], INK);
        let right = left + BAR[1];
        for (value, text) in &colours.scale.major {
            let y = top + high * (1.0 - colours.scale.position(*value));
            svg.line([right, y], [right + 5.0, y], INK, 1.0);
            svg.text([right + 9.0, y], text, Type { size: TICK_PX, ..Type::default() });
        }
        let title = axis_title(&self.quantity.label, &self.quantity.unit, colours.exponent);
        let at = [right + labels_width(colours) + BESIDE - 12.0, top + 0.5 * high];
        svg.text(at, &title, Type { size: LABEL_PX, anchor: Anchor::Middle, upwards: true, ..Type::default() });
    }
}

fn labels_width(ruler: &Ruler) -> f64 {
    ruler.scale.major.iter().fold(0.0, |most: f64, (_, text)| most.max(width(text, TICK_PX, false)))
}

impl Chart for MapChart {
    fn title(&self) -> &str {
        &self.title
    }

    fn axes(&self) -> String {
        format!("{} over {} and {}", self.quantity.label, self.x.axis.label, self.y.axis.label)
    }

    fn series(&self) -> &[Series] {
        &[]
    }

    fn references(&self) -> &[Reference] {
        &[]
    }

    fn absent(&self) -> Option<&str> {
        self.cells.contains(&Cell::Absent).then_some(&self.absent)
    }

    fn check(&self) -> Result<(), PlotError> {
        let panel = self.title.clone();
        let (columns, rows, values) = (self.x.at.len(), self.y.at.len(), self.cells.len());
        if values == 0 || values != columns * rows {
            return Err(PlotError::Cells { panel, values, columns, rows });
        }
        self.x.check(&self.title)?;
        self.y.check(&self.title)?;
        let bad = |cell: &Cell| matches!(cell, Cell::Value(value) if !drawable(*value));
        match self.cells.iter().position(bad) {
            Some(index) => {
                let y = self.value(index % columns, index / columns).unwrap_or(f64::NAN);
                Err(PlotError::NotFinite {
                    series: self.quantity.label.clone(),
                    index,
                    x: self.x.at[index % columns],
                    y,
                })
            }
            None => Ok(()),
        }
    }

    fn size(&self, heading: &str) -> Result<[f64; 2], PlotError> {
        let room = self.y.ruler(self.area_px[1], false).room();
        let bar = BAR[0] + BAR[1] + labels_width(&self.colours()?) + BESIDE;
        let title = width(heading, HEADING_PX, true);
        Ok([(room + self.wide() + bar).max(title), head(heading) + self.area_px[1] + FOOT])
    }

    fn draw(&self, svg: &mut Svg, Spot { at: [x, y], heading, .. }: &Spot) -> Result<(), PlotError> {
        let colours = self.colours()?;
        let size = [self.wide(), self.area_px[1]];
        let rulers = [self.x.ruler(size[0], true), self.y.ruler(size[1], false)];
        let corner = [x + rulers[1].room(), y + head(heading)];
        let [x_axis, y_axis] = rulers;
        let area = Area { corner, size, x: x_axis, y: y_axis };
        area.draw_heading(svg, *y, heading);
        self.draw_cells(svg, &area, &colours);
        self.draw_contours(svg, &area, &colours);
        area.draw_frame(svg);
        let below = axis_title(&self.x.axis.label, &self.x.axis.unit, area.x.exponent);
        let beside = axis_title(&self.y.axis.label, &self.y.axis.unit, area.y.exponent);
        area.draw_titles(svg, *x, &below, FOOT, &beside);
        self.draw_bar(svg, &area, &colours);
        Ok(())
    }
}
