#![doc = include_str!("../README.md")]

mod catalogue;
mod check;
#[cfg(feature = "parquet")]
mod dataset;
mod drawn;
mod ensemble;
mod excerpt;
mod failure;
mod film;
mod fits;
mod fmu;
mod harmless;
mod heat;
mod hertz;
mod identify;
mod input;
mod layout;
mod life;
mod manual;
mod modes;
mod new;
mod orbit;
mod pair;
mod rating;
mod recover;
mod report;
mod run;
mod search;
mod set;
mod shaft;
mod sheet;
mod solve;
mod stiffness;
mod sweep;
mod table;
mod torque;
mod traction;
mod units;
mod vibration;
mod waiting;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use failure::Failure;
use std::io::Write;
use std::process::ExitCode;

/// Tribo-dynamics of ball bearings.
#[derive(Parser)]
#[command(name = "tribodyn", version, arg_required_else_help = true, after_help = AFTER_HELP)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

const AFTER_HELP: &str = "\
Examples:
  tribodyn sheet 6206 --radial 2000 --axial 300 --speed 3000
  tribodyn new 7210 --angle 40
  tribodyn check 7210B.ron
  tribodyn solve 7210B.ron --plot figures
  tribodyn rating 7210B.ron
  tribodyn stiffness 7210B.ron --speeds 1000,3000,6000
  tribodyn run 7210B.ron -o run.mcap --duration 0.05
  tribodyn report run.mcap -o report
  tribodyn sweep 7210B.ron --set 'ring.z.Force=kN(1..6 by 1)' -o table.parquet
  tribodyn set 7012C --arrangement DB --preload 200
  tribodyn shaft fixtures/shafts/motor.ron
  tribodyn vibration motor.csv --rate 25600 --bearing 6206 --speed 1480

`tribodyn COMMAND --help` has examples of each command. Values of a case have their units, as kN(1), mm(0.2), rpm(3000),
degC(70), also lbf, in, psi, degF; numbers of options may: --radial 450lbf, --bore 1.5in.

Exit codes: 0 done, 1 did not converge or could not be written, 2 bad input.";

#[derive(Subcommand)]
enum Command {
    /// Write a complete case file from a designation or a few catalogue numbers
    New(new::Arguments),
    /// List the bearings of the catalogue
    Catalogue(catalogue::Arguments),
    /// Check a case file and print what follows from it
    Check(check::Arguments),
    /// Compute the Hertz contact of two bodies from their principal radii
    Hertz(hertz::Arguments),
    /// Compute the traction curve of a coating at a contact pressure
    Traction(traction::Arguments),
    /// Solve for the quasi-static equilibrium or the steady orbit of a bearing
    Solve(solve::Arguments),
    /// Compute the stiffness of the inner ring at the operating point
    Stiffness(stiffness::Arguments),
    /// Compute the natural modes of balls, cage and rings in the steady orbit
    Modes(modes::Arguments),
    /// Solve two preloaded bearings on one shaft
    Pair(pair::Arguments),
    /// Print life, safety, stiffness, torque and frequencies of a loaded bearing on one page
    Sheet(sheet::Arguments),
    /// Compute preload, unloading force and axial rigidity of a set of bearings
    Set(set::Arguments),
    /// Solve for a shaft in its bearings: reactions, deflections, lives, modes
    Shaft(shaft::Arguments),
    /// Simulate a bearing in time and record it
    Run(run::Arguments),
    /// Simulate a bearing in time many times, with case values drawn at random
    Ensemble(ensemble::Arguments),
    /// Make labelled vibration signals of bearings with and without spalls
    #[cfg(feature = "parquet")]
    Dataset(dataset::Arguments),
    /// Compute the life of the coatings: wear over many revolutions until one is through
    Life(life::Arguments),
    /// Compute lubricant films: of every contact of a case, or of one contact
    Film(film::Arguments),
    /// Write a bearing as a functional mock-up unit for multibody and system simulation
    Fmu(fmu::Arguments),
    /// Compute the temperatures of a lubricated bearing from its friction
    Heat(heat::Arguments),
    /// Compute the friction torque by cause, beside SKF's and Palmgren's formulas
    Torque(torque::Arguments),
    /// Compute rating life and static safety by ISO 281, ISO/TS 16281 and ISO 76
    Rating(rating::Arguments),
    /// Recover a recording that was cut off or damaged
    Recover(recover::Arguments),
    /// Write figures, spectra and a summary of a recording
    Report(report::Arguments),
    /// Find the faults of a bearing in a measured or recorded vibration signal
    Vibration(vibration::Arguments),
    /// Write the Foxglove layout for viewers of a live run
    Layout(layout::Arguments),
    /// Solve for steady orbits or equilibria over a grid of case values
    Sweep(sweep::Arguments),
    /// Identify unknown parameters of a case from published or measured figures
    Identify(identify::Arguments),
    /// Print a completion script for a shell
    Completions(manual::CompletionArguments),
    /// Write the manual pages
    #[command(hide = true)]
    Man(manual::ManArguments),
}

/// The command line. A negative number behind an option is its value, and not an option that is unknown: the command
/// says what is allowed.
fn command_line() -> clap::Command {
    fn with_negative_numbers(command: clap::Command) -> clap::Command {
        let option = |arg: clap::Arg| {
            let takes_one = arg.get_action().takes_values() && !arg.is_positional();
            if takes_one { arg.allow_negative_numbers(true) } else { arg }
        };
        command.mut_args(option).mut_subcommands(with_negative_numbers)
    }
    with_negative_numbers(Arguments::command())
}

fn main() -> ExitCode {
    let read = Arguments::from_arg_matches(&command_line().get_matches());
    let outcome = match read.unwrap_or_else(|error| error.exit()).command {
        Command::New(arguments) => new::run(&arguments),
        Command::Catalogue(arguments) => catalogue::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Hertz(arguments) => hertz::run(&arguments),
        Command::Traction(arguments) => traction::run(&arguments),
        Command::Solve(arguments) => solve::run(&arguments),
        Command::Stiffness(arguments) => stiffness::run(&arguments),
        Command::Modes(arguments) => modes::run(&arguments),
        Command::Pair(arguments) => pair::run(&arguments),
        Command::Sheet(arguments) => sheet::run(&arguments),
        Command::Set(arguments) => set::run(&arguments),
        Command::Shaft(arguments) => shaft::run(&arguments),
        Command::Run(arguments) => run::run(&arguments),
        Command::Ensemble(arguments) => ensemble::run(&arguments),
        #[cfg(feature = "parquet")]
        Command::Dataset(arguments) => dataset::run(&arguments),
        Command::Life(arguments) => life::run(&arguments),
        Command::Film(arguments) => film::run(&arguments),
        Command::Fmu(arguments) => fmu::run(&arguments),
        Command::Heat(arguments) => heat::run(&arguments),
        Command::Torque(arguments) => torque::run(&arguments),
        Command::Rating(arguments) => rating::run(&arguments),
        Command::Recover(arguments) => recover::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Vibration(arguments) => vibration::run(&arguments),
        Command::Layout(arguments) => layout::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Identify(arguments) => identify::run(&arguments),
        Command::Completions(arguments) => manual::completions(&arguments, Arguments::command()),
        Command::Man(arguments) => manual::man(&arguments, Arguments::command()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        // The reader of a pipe may leave early (`tribodyn … | head`): that is not a failure of ours.
        Err(Failure::Output(error)) if error.kind() == std::io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(failure) => {
            let code = ExitCode::from(failure.exit_code());
            report(failure);
            code
        }
    }
}

/// Writes a failure to standard error: its message on one line, so that programs can read it too, then the place in the
/// case file where there is one.
fn report(failure: Failure) {
    // Messages hold their causes. Should the hook be set already, it is ours; if nobody listens, nothing can be done.
    let options = || miette::MietteHandlerOpts::new().wrap_lines(false).without_cause_chain().context_lines(1);
    let _ = miette::set_hook(Box::new(move |_| Box::new(options().build())));
    let _ = writeln!(std::io::stderr(), "{:?}", failure.into_report());
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The words of an example, as a shell makes them.
    fn words(line: &str) -> Vec<String> {
        let mut words = vec![String::new()];
        let mut quote = None;
        for c in line.chars() {
            match (c, quote) {
                ('\'' | '"', None) => quote = Some(c),
                (c, Some(end)) if c == end => quote = None,
                (' ', None) => words.push(String::new()),
                (c, _) => words.last_mut().unwrap().push(c),
            }
        }
        words
    }

    /// Every example of the help is a command that is accepted, every command has one, and the first that anybody sees
    /// are of bearings of the catalogue.
    #[test]
    fn limit_examples_of_the_help_are_accepted() {
        let command = Arguments::command();
        let mut all = vec![("tribodyn".to_owned(), AFTER_HELP.to_owned())];
        for part in command.get_subcommands() {
            let help = part.get_after_help().map(ToString::to_string).unwrap_or_default();
            all.push((part.get_name().to_owned(), help));
        }
        for (name, help) in all {
            let lines: Vec<&str> = help.lines().filter_map(|line| line.strip_prefix("  ")).collect();
            assert!(!lines.is_empty() || name == "man", "{name} has no example");
            for line in &lines {
                // What a shell does with the output is its own.
                let line = line.split(" > ").next().unwrap_or_default();
                let parsed = command_line().try_get_matches_from(words(line));
                assert!(parsed.is_ok(), "{line}: {}", parsed.err().map(|e| e.to_string()).unwrap_or_default());
            }
            assert!(!lines.first().is_some_and(|line| line.contains("paper-ag")), "{name} begins with the paper");
        }
    }
}
