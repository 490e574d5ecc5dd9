//! `cargo xtask figures`.

use crate::error::Failure;
use crate::terminal::progress;
use std::path::PathBuf;
use tribodyn_paper::figures::{self, Options};

/// Options of `figures`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Only figures whose names begin so, as `fig19`; makes only the runs that they need and leaves the page as it is
    #[arg(long, value_name = "PREFIX")]
    only: Option<String>,
    /// Transient runs just long enough for one orbit after the start: every figure, in a folder of its own
    #[arg(long)]
    quick: bool,
    /// Folder for the figures [default: docs/figures, or target/figures with --quick]
    #[arg(short, long, visible_alias = "out", value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Makes the runs and writes the figures.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { only, quick, output } = arguments;
    Ok(figures::run(&Options { only: only.clone(), quick: *quick, output: output.clone() }, &progress)?)
}
