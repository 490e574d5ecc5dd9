//! What can go wrong with the command `sweep` beyond what can with a sweep.

use std::path::PathBuf;

/// A sweep that cannot be drawn, or is not content.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// Figures of a sweep that has none.
    #[error("--plot: {why}")]
    Plot { why: String },
    /// The table is written, but not every row is a solution.
    #[error("{failed} of {rows} rows have no solution; the column `error` of {} says why", path.display())]
    Unsolved { failed: usize, rows: usize, path: PathBuf },
}

impl SweepError {
    /// 1 where the calculation is to blame, 2 where the input is.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Unsolved { .. } => 1,
            Self::Plot { .. } => 2,
        }
    }
}
