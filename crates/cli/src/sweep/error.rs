//! What can go wrong with a sweep beyond what can with one case.

use std::path::PathBuf;

/// A sweep that cannot start, go on or be content.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// Two lists of values for one place.
    #[error("--set {first} and --set {second} sweep the same value")]
    Overlap { first: String, second: String },
    /// A grid beyond all calculation.
    #[error("the grid has more than {limit} rows")]
    TooManyRows { limit: usize },
    /// Neither Parquet nor CSV.
    #[error("--output {}: allowed is a name that ends in {allowed}", path.display())]
    Format { path: PathBuf, allowed: &'static str },
    /// Finished rows of something else.
    #[error("{}: {difference}; delete it, or use --restart to solve all rows anew", path.display())]
    OtherSweep { path: PathBuf, difference: String },
    /// Figures of a sweep that has none.
    #[error("--plot: {why}")]
    Plot { why: String },
    /// Two processes with one output.
    #[error("{}: another sweep is writing there", path.display())]
    Busy { path: PathBuf },
    /// The table is written, but not every row is a solution.
    #[error("{failed} of {rows} rows have no solution; the column `error` of {} says why", path.display())]
    Unsolved { failed: usize, rows: usize, path: PathBuf },
}

impl SweepError {
    /// 1 where the calculation is to blame, 2 where the input is.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Unsolved { .. } | Self::Busy { .. } => 1,
            _ => 2,
        }
    }
}
