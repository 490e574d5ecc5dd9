//! `cargo xtask sensitivity`.

use crate::error::Failure;
use crate::terminal::{print, progress};
use tribodyn_paper::sensitivity::{self, Searched};

/// Options of `sensitivity`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Only one of the tables
    #[arg(long)]
    part: Option<Part>,
    /// Only the lines of the table of missed rows whose change has this in its name
    #[arg(long, value_name = "TEXT", conflicts_with = "part")]
    change: Option<String>,
    /// The reading whose hidden values are searched for: authors, the one with the most evidence, or classical, the
    /// gyroscopic moment at the outer race
    #[arg(long, value_name = "NAME", default_value = "authors")]
    reading: Searched,
    /// Draws from the priors
    #[arg(long, default_value_t = 200)]
    draws: usize,
    /// Sets that the search begins with
    #[arg(long, default_value_t = 800)]
    sets: usize,
}

/// A table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    /// Hidden parameters halved and doubled, and the grid of the pocket
    Pocket,
    /// Missed rows under changes
    Rows,
    /// Other readings of the missed rows
    Readings,
    /// Size of the defect
    Defect,
    /// All that the paper does not print drawn from its priors; only when asked for
    Prior,
    /// Search for what the paper hides of cage and supports; only when asked for
    Hidden,
}

/// Makes the runs, writes the results and the document's block.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let wanted = |part: Part| arguments.part.is_none_or(|only| only == part) && arguments.change.is_none();
    if wanted(Part::Pocket) {
        print(&format!("{}\n", sensitivity::pocket()?))?;
    }
    if arguments.part == Some(Part::Hidden) {
        return Ok(sensitivity::hidden(arguments.reading, arguments.sets, &progress)?);
    }
    if arguments.part == Some(Part::Prior) {
        return Ok(sensitivity::prior(arguments.draws, &progress)?);
    }
    let base = sensitivity::base()?;
    if wanted(Part::Readings) {
        base.readings()?;
    }
    if wanted(Part::Rows) || arguments.change.is_some() {
        base.rows(arguments.change.as_deref(), &progress)?;
    }
    if wanted(Part::Defect) {
        base.defects()?;
    }
    Ok(sensitivity::rewrite()?)
}
