//! The `tribodyn` command: one case file in, tables, figures and recordings out.
//!
//! Exit codes: 0 done, 1 did not converge, 2 bad input.

mod check;
mod failure;
mod hertz;
mod input;
mod solve;
mod table;
mod traction;

use clap::{Parser, Subcommand};
use failure::Failure;
use std::process::ExitCode;

/// Tribo-dynamics of ball bearings.
#[derive(Parser)]
#[command(version, about, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Check a case file; print what follows from it
    Check(check::Arguments),
    /// Hertz contact of two bodies from their principal radii
    Hertz(hertz::Arguments),
    /// Traction curve of a coating at a contact pressure
    Traction(traction::Arguments),
    /// Quasi-static equilibrium of a bearing
    Solve(solve::Arguments),
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Command::Check(arguments) => check::run(&arguments),
        Command::Hertz(arguments) => hertz::run(&arguments),
        Command::Traction(arguments) => traction::run(&arguments),
        Command::Solve(arguments) => solve::run(&arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        // The reader of a pipe may leave early (`tribodyn … | head`): that is not a failure of ours.
        Err(Failure::Output(error)) if error.kind() == std::io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(failure) => {
            let code = failure.exit_code();
            eprintln!("{:?}", miette::Report::new(failure));
            ExitCode::from(code)
        }
    }
}
