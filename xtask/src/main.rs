//! `cargo xtask`: rebuilds the published figures that the model covers, and runs all that continuous integration checks.
//!
//! # Decisions
//! ```text
//! number:        deviation = computed − published,   met if |deviation| ≤ tolerance
//! order, shape:  met if the measured quantity is on the stated side of its limit; the row's note names both
//! regression:    |ours now − ours then| ≤ 1e-6 |ours then|
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | κ, s | traction coefficient, slip | –, unit of the tests |
//! | p, Q | peak contact pressure, contact load | GPa, N |
//! | T, ξ | longitudinal traction, slide-to-roll ratio | N, – |
//! | φ | azimuth; heavy zone −90° to 90°, light zone the rest | ° |
//!
//! Source of the published figures: Zhang, Jia, Zhao, Wei, Zi, Lubricants 2025, 13(8), 352,
//! doi:10.3390/lubricants13080352; they are in `fixtures/reference/zhang2025`.
//!
//! Limits: words such as "about" and "clearly" are given one number for all rows. Nothing here changes a parameter to meet a row.
//!
//! What it does not know: any physics; it asks the crates and compares.

mod bench;
mod ci;
mod error;
mod figures;
mod files;
mod page;
mod sensitivity;
mod table;
mod transient;
mod validate;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

#[derive(Parser)]
#[command(name = "cargo xtask", about = "Validation and continuous integration of tribodyn")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Rebuild every published figure and compare
    Validate(validate::Arguments),
    /// Rewrite the committed results, verdicts and table blocks of the documents
    Fixtures,
    /// Vary what the paper hides of the dynamic model, and rewrite the table of it
    Sensitivity(sensitivity::Arguments),
    /// Draw the paper's result figures from our own runs
    Figures(figures::Arguments),
    /// Measure kernels, transient schemes and the quasi-static solver
    Bench(bench::Arguments),
    /// Open a report in headless Chromium and look for what is wrong
    Page(page::Arguments),
    /// Run everything that continuous integration runs
    Ci,
}

fn main() -> ExitCode {
    let done = match Arguments::parse().command {
        Command::Validate(arguments) => validate::run(&arguments),
        Command::Fixtures => validate::rewrite_fixtures(),
        Command::Sensitivity(arguments) => sensitivity::run(&arguments),
        Command::Figures(arguments) => figures::run(&arguments),
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Page(arguments) => page::run(&arguments),
        Command::Ci => ci::run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::from(failure.exit_code())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn identity_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }
}
