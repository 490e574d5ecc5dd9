//! `cargo xtask hypotheses`.

use crate::error::Failure;
use crate::terminal::progress;
use tribodyn_paper::hypotheses;

/// Options of `hypotheses`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Only the hypotheses that have this in their names; the lines of the others stay
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

/// Fits, counts, writes the result and the page's tables.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    hypotheses::run(arguments.only.as_deref(), &progress)?;
    Ok(hypotheses::rewrite()?)
}
