//! Programs and examples of the workspace, built once for all checks.

use crate::error::Failure;
use std::path::PathBuf;
use std::process::Command;
use tribodyn_paper::files;

/// Builds the programs and the examples of the dev profile all at once, with the features that the tests are built
/// with: each by itself would build the crates below it once more. Returns the folder of the programs.
pub fn programs() -> Result<PathBuf, Failure> {
    let cargo = cargo_program();
    let start = |program: &str| {
        let program = program.to_owned();
        move |source| Failure::Start { program, source }
    };
    let arguments = ["build", "--workspace", "--bins", "--examples"];
    let status = Command::new(&cargo).current_dir(files::root()).args(arguments).status().map_err(start(&cargo))?;
    if !status.success() {
        return Err(Failure::Command { command: format!("cargo {}", arguments.join(" ")), status });
    }
    // This program is in a profile's folder of the target folder, too.
    let own = std::env::current_exe().map_err(start("xtask"))?;
    Ok(own.ancestors().nth(2).unwrap_or(&own).join("debug"))
}

/// The Cargo that started this program.
pub fn cargo_program() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}
