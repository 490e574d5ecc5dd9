//! Faults in the data of a figure.

/// Errors of drawing a figure.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// A figure was asked for without a panel.
    #[error("figure {figure:?} has no panel")]
    NoPanel {
        /// Name of the figure.
        figure: String,
    },
    /// A panel has no series.
    #[error("panel {panel:?} has no series")]
    NoSeries {
        /// Title of the panel.
        panel: String,
    },
    /// A series has no points.
    #[error("series {series:?} has no points")]
    EmptySeries {
        /// Label of the series.
        series: String,
    },
    /// A coordinate, an uncertainty or an axis bound is NaN, infinite or so large that differences of it overflow.
    #[error("series {series:?}, point {index}: ({x}, {y}) is not a number below 1e150 in magnitude")]
    NotFinite {
        /// Label of the series, or the label of the axis whose bounds are meant.
        series: String,
        /// Index of the point in the series.
        index: usize,
        /// Abscissa (or azimuth in degrees) in the unit of its axis.
        x: f64,
        /// Ordinate in the unit of its axis.
        y: f64,
    },
    /// A logarithmic axis was given zero, a negative value or one below 1e-150.
    #[error("series {series:?}, point {index}: {value} has no place on the logarithmic axis {axis:?}")]
    NotPositive {
        /// Label of the series, or the label of the axis whose bounds are meant.
        series: String,
        /// Index of the point in the series.
        index: usize,
        /// The value in the unit of the axis.
        value: f64,
        /// Label of the axis.
        axis: String,
    },
    /// A polar chart was given a negative value: on a circle it could not be told from a positive one.
    #[error(
        "series {series:?}, point {index}: {value} at {azimuth_deg}° is negative; over degrees it has a place, on a circle none"
    )]
    Negative {
        /// Label of the series.
        series: String,
        /// Index of the point, those of the band after those of the line.
        index: usize,
        /// Azimuth, degrees.
        azimuth_deg: f64,
        /// The value in the unit of the axis.
        value: f64,
    },
    /// A map whose number of values is not that of its cells.
    #[error("map {panel:?} has {values} values for {columns} × {rows} cells")]
    Cells {
        /// Title of the panel.
        panel: String,
        /// Values given.
        values: usize,
        /// Places on the horizontal axis.
        columns: usize,
        /// Places on the vertical axis.
        rows: usize,
    },
    /// Places of a map that do not ascend.
    #[error("map {panel:?}: place {index} of the axis {axis:?} is not above the one before it")]
    Order {
        /// Title of the panel.
        panel: String,
        /// Label of the axis.
        axis: String,
        /// Index of the place.
        index: usize,
    },
    /// Abscissas and ordinates that do not belong together one by one.
    #[error("series {series:?} has {abscissas} abscissas and {ordinates} ordinates")]
    Lengths {
        /// Label of the series.
        series: String,
        /// Abscissas given.
        abscissas: usize,
        /// Ordinates given.
        ordinates: usize,
    },
    /// A bar that belongs to no group: its abscissa must be the index of a group.
    #[error("series {series:?}: {value} is not the index of one of {groups} groups")]
    NoGroup {
        /// Label of the series.
        series: String,
        /// Abscissa of the bar.
        value: f64,
        /// Number of groups.
        groups: usize,
    },
    /// Bars outside a bar chart, or another kind of series in one.
    #[error("series {series:?} cannot be drawn in panel {panel:?}: bars belong in bar charts and only bars do")]
    WrongKind {
        /// Label of the series.
        series: String,
        /// Title of the panel.
        panel: String,
    },
    /// No run was given.
    #[error("no run to draw")]
    NoRun,
    /// A run has no balls.
    #[error("run {run:?} has no balls")]
    NoBalls {
        /// Label of the run.
        run: String,
    },
    /// Two runs have one label, so that the legend could not tell them apart.
    #[error("two runs are labelled {label:?}")]
    DuplicateLabel {
        /// The label.
        label: String,
    },
    /// Lengths that make no bearing.
    #[error("the lengths make no bearing that can be drawn")]
    NoBearing,
    /// Published points refer to a run that is not drawn.
    #[error("the points {series:?} belong to a run {run:?} that is not among the runs")]
    UnknownRun {
        /// Label of the points.
        series: String,
        /// The run named.
        run: String,
    },
    /// The bitmap would be empty or too large.
    #[error("a bitmap {width_px} px wide is outside 1 px to {max_px} px")]
    BitmapSize {
        /// Width asked for, px.
        width_px: u32,
        /// Greatest width, px.
        max_px: u32,
    },
    /// The SVG text could not be read back for drawing the bitmap.
    #[error("the SVG text cannot be drawn")]
    Svg(#[from] resvg::usvg::Error),
    /// The bitmap could not be encoded.
    #[error("a bitmap of {width_px} × {height_px} px cannot be encoded as PNG")]
    Encode {
        /// Width, px.
        width_px: u32,
        /// Height, px.
        height_px: u32,
    },
}
