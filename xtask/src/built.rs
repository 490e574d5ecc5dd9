//! Programs and examples of the workspace, built once for all checks.

use crate::error::Failure;
use std::path::PathBuf;
use std::process::Command;
use tribodyn_paper::files;

/// Builds the programs and the examples of the dev profile all at once, with the features that the tests are built
/// with: each by itself would build the crates below it once more. Returns the folder of the programs.
pub fn programs() -> Result<PathBuf, Failure> {
    built(&["build", "--workspace", "--bins", "--examples"], "debug")
}

/// Builds the command of the release profile, for what runs long. Returns its path.
pub fn command() -> Result<PathBuf, Failure> {
    Ok(built(&["build", "--release", "--bin", "tribodyn"], "release")?.join("tribodyn"))
}

/// Builds an example of a package in the release profile. Returns its path.
pub fn example(package: &str, name: &str) -> Result<PathBuf, Failure> {
    let folder = built(&["build", "--release", "--package", package, "--example", name], "release")?;
    Ok(folder.join("examples").join(name))
}

/// The same task with the same arguments from `cargo run --release`, which builds it where needed. Returns its exit
/// code: it has said itself what failed.
pub fn this_task() -> Result<u8, Failure> {
    let mut cargo = Command::new(cargo_program());
    cargo.args(["run", "--release", "--bin", "xtask", "--manifest-path"]).arg(files::root().join("Cargo.toml"));
    let start = |source| Failure::Start { program: "cargo run --release --bin xtask".to_owned(), source };
    let status = cargo.arg("--").args(std::env::args_os().skip(1)).status().map_err(start)?;
    Ok(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1))
}

fn built(arguments: &[&str], profile: &str) -> Result<PathBuf, Failure> {
    let cargo = cargo_program();
    run(Command::new(&cargo).current_dir(files::root()).args(arguments), &format!("cargo {}", arguments.join(" ")))?;
    // This program is in a profile's folder of the target folder, too.
    let start = |source| Failure::Start { program: "xtask".to_owned(), source };
    let own = std::env::current_exe().map_err(start)?;
    Ok(own.ancestors().nth(2).unwrap_or(&own).join(profile))
}

/// Runs a program to its end.
pub fn run(program: &mut Command, words: &str) -> Result<(), Failure> {
    let start = |source| Failure::Start { program: words.to_owned(), source };
    let status = program.status().map_err(start)?;
    if status.success() { Ok(()) } else { Err(Failure::Command { command: words.to_owned(), status }) }
}

/// The Cargo that started this program.
pub fn cargo_program() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}
