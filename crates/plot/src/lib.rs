#![doc = include_str!("../README.md")]

mod axes;
mod bars;
mod bearing;
mod book;
mod cartesian;
mod chart;
mod colours;
mod contour;
mod error;
mod figure;
mod legend;
mod map;
mod marks;
mod orbit;
mod polar;
mod quantity;
mod reference_marks;
mod references;
mod run;
mod series;
mod solution;
mod style;
mod svg;
mod symbols;
mod text;
mod ticks;
mod turn;

pub use bars::BarChart;
pub use bearing::{BearingDrawing, bearing_figure};
pub use cartesian::{Abscissas, LineChart};
pub use error::PlotError;
pub use figure::{Figure, Panel};
pub use map::{Cell, MapAxis, MapChart};
pub use marks::Mark;
pub use orbit::{OrbitSamples, orbit_figure, orbit_panels, orbit_polar};
pub use polar::PolarChart;
pub use quantity::Quantity;
pub use references::{Place, Reference};
pub use run::{
    History, Samples, SpectrumView, bars, history_charts, path_figure, spectrum_chart, spectrum_figure, stacked_bars,
    time_history,
};
pub use series::{Absent, Axis, Series, SeriesKind};
pub use solution::{Published, SolutionCharts, solution_charts, solution_figures};
