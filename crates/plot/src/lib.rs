//! Figures of bearing results as SVG and PNG in one style: solutions over the azimuth, histories, spectra, bars, maps.
//!
//! # Equations
//!
//! Polar charts map azimuth φ and value v to the page, y upwards, with v_min the value at the centre and v_max that of the rim:
//!
//! ```text
//! ρ = ρ_max (v − v_min)/(v_max − v_min),   x = ρ cos φ,   y = ρ sin φ
//! ```
//!
//! The labels of marked frequencies lie above the area at the places x_k nearest to their frequencies m_k at which labels of widths
//! w_k do not overlap (isotonic regression):
//!
//! ```text
//! minimise Σ (x_k − m_k)²   with   x_{k+1} − x_k ≥ (w_k + w_{k+1})/2
//! ```
//!
//! Polar charts are for magnitudes. Signed quantities, and those that are zero at all balls, are drawn over degrees. Every ball is
//! marked; one without contact has no value, is a cross, and no line goes over it.
//!
//! Maps colour a cell for each pair of values, its edges half-way to its neighbours; lines of equal value are linear between cells.
//!
//! Axis steps are 1, 2 or 5 times a power of ten. Powers of ten that are multiples of three are taken out of the numbers of an axis
//! whose greatest magnitude is outside 0.01 to 100 000 and written beside the unit.
//!
//! Published numbers look the same on all charts: open markers where they belong to an abscissa, thin dash-dotted lines and light
//! ranges where they hold for a whole panel, black or in the colour of the line that they are to be compared with.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | φ | azimuth of a ball; 0 in the direction of the radial load, counter-clockwise | ° |
//! | v | the quantity drawn | written on the axis |
//! | ρ | distance from the centre of the chart | px |
//! | x, m, w | place of a label, its mark, its width | px |
//!
//! # Sources
//!
//! - Which quantities are shown follows Figs. 14 to 18 of S. Zhang, S. Jia, Y. Zhao, J. Wei, Y. Zi, Lubricants 2025, 13(8), 352,
//!   doi:10.3390/lubricants13080352.
//! - Colours: M. Okabe, K. Ito, "Color Universal Design", 2008, <https://jfly.uni-koeln.de/color/>.
//! - Colours of maps: S. van der Walt, N. Smith, "A Better Default Colormap for Matplotlib" (viridis), SciPy 2015; CC0.
//! - Font: DejaVu Sans 2.37, reduced; licence in `assets/LICENSE-DejaVu.txt`. Bitmaps use it; SVG text names `sans-serif`.
//!
//! # Limits
//!
//! - Curves over the azimuth are interpolated linearly between balls; nothing between balls is computed.
//! - The centre of a polar chart is zero only where its label says so.
//! - Colour, dash and width tell 42 series apart in principle; about six that coincide stay readable.
//! - Radial axes and the axes of bars are linear.
//! - Lines of 2000 points and more are reduced to the first, least, greatest and last point of each half pixel; what lies between
//!   is the same ink.
//! - Bars have 14 fills: seven colours, plain and hatched.
//!
//! # On dark pages
//!
//! SVG text has the colours of ink `#1A1A1A`, grey `#6E6E6E`, grid `#DCDCDC` and paper `#FFFFFF` in attributes of its elements and
//! nowhere else, so that a page that holds the SVG itself can restyle them: `svg [fill="#1A1A1A"] { fill: #eee }`,
//! `svg [stroke="#1A1A1A"] { stroke: #eee }` and so on.
//!
//! # Why not plotters
//!
//! plotters 0.3.7 with its SVG backend builds in 2 s, resvg for the bitmaps in 18 s, so build time does not decide. It has no polar
//! coordinates, places every point on whole pixels, cuts dashed lines into pieces, puts legends inside the plot area only, and without
//! a font backend takes 0.7 of the type size for the width of every character. What would be left of it is axis ticks; the writer
//! here is 200 lines.
//!
//! # What this crate does not know
//!
//! Files, terminals, and how results come about. It writes no file: [`Figure::svg`] and [`Figure::png`] return the bytes.

mod axes;
mod bars;
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
