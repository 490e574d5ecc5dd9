//! `cargo xtask`: the study of the paper on the terminal, measurements of speed, and all that continuous integration
//! checks.
//!
//! The study is `tribodyn-paper`; here are arguments, what is printed, and exit codes: 0 done, 1 a check or a
//! calculation failed, 2 wrong input.

mod bench;
mod built;
mod ci;
mod error;
mod faults;
mod figures;
mod fuzz;
mod hypotheses;
mod notices;
mod oil;
mod page;
mod python;
mod quantities;
mod rows;
mod sensitivity;
mod survey;
mod terminal;
mod torque;
mod validate;
mod verdicts;
mod web;

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
    /// Weigh readings of the paper against each other, and rewrite the table of it; ten minutes
    Hypotheses(hypotheses::Arguments),
    /// Draw the paper's result figures from our own runs
    Figures(figures::Arguments),
    /// Rewrite the page of all quantities from their tables
    Quantities,
    /// Work out the friction torque of catalogue bearings beside SKF's model
    Torque(torque::Arguments),
    /// Work out skidding and temperatures in oil beside what was measured
    Oil(oil::Arguments),
    /// Work out what `vibration` says of signals of sound and damaged bearings
    Verdicts(verdicts::Arguments),
    /// Measure kernels, transient schemes and the quasi-static solver
    Bench(bench::Arguments),
    /// Try inputs by the million on everything that reads files and messages from elsewhere
    Fuzz(fuzz::Arguments),
    /// Open a report in headless Chromium and look for what is wrong
    Page(page::Arguments),
    /// Solve and run random bearings, and write a case file for each failure
    Survey(survey::Arguments),
    /// Try kills, full disks, two at once, damaged files, hostile viewers on the built command
    Faults(faults::Arguments),
    /// Write the licences of all that the command and the Python package are linked with
    Notices(notices::Arguments),
    /// Build the page in the browser into target/web, and serve it
    Web(web::Arguments),
    /// Run everything that continuous integration runs
    Ci {
        /// Only this step, by the name that it is reported by; may be given several times.
        #[arg(long = "step", value_name = "NAME", value_parser = clap::builder::PossibleValuesParser::new(ci::names()))]
        steps: Vec<String>,
    },
}

impl Command {
    /// Tasks that run for minutes, or measure: they are worth a build of the release profile. All others share the dev
    /// profile with the tests, so that everything is compiled once.
    fn is_for_release(&self) -> bool {
        use Command::{Bench, Figures, Fixtures, Fuzz, Hypotheses, Oil, Sensitivity, Survey, Torque, Verdicts};
        let working_out = matches!(self, Figures(_) | Fixtures | Hypotheses(_) | Oil(_) | Sensitivity(_) | Torque(_));
        working_out || matches!(self, Bench(_) | Fuzz(_) | Survey(_) | Verdicts(_))
    }
}

fn main() -> ExitCode {
    let command = Arguments::parse().command;
    if cfg!(debug_assertions) && command.is_for_release() {
        return built::this_task().map_or_else(|failure| failed(&failure), ExitCode::from);
    }
    let done = match command {
        Command::Validate(arguments) => validate::run(&arguments),
        Command::Fixtures => validate::rewrite_fixtures(),
        Command::Sensitivity(arguments) => sensitivity::run(&arguments),
        Command::Hypotheses(arguments) => hypotheses::run(&arguments),
        Command::Figures(arguments) => figures::run(&arguments),
        Command::Quantities => quantities::write(),
        Command::Torque(arguments) => torque::run(&arguments),
        Command::Oil(arguments) => oil::run(&arguments),
        Command::Verdicts(arguments) => verdicts::run(&arguments),
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Fuzz(arguments) => fuzz::run(&arguments),
        Command::Page(arguments) => page::run(&arguments),
        Command::Survey(arguments) => survey::run(&arguments),
        Command::Faults(arguments) => faults::run(&arguments),
        Command::Notices(arguments) => notices::run(&arguments),
        Command::Web(arguments) => web::run(&arguments),
        Command::Ci { steps } => ci::run(&steps),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failed(&failure),
    }
}

fn failed(failure: &error::Failure) -> ExitCode {
    eprintln!("error: {failure}");
    ExitCode::from(failure.exit_code())
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
