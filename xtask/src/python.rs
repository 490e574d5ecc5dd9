//! Python packages in folders of their own, for checks and comparisons that another program makes.

use std::path::{Path, PathBuf};
use std::process::Command;

/// A Python with `packages`, in a folder of its own below `environment`; or the reason why there is none.
pub fn environment(environment: &Path, packages: &[&str]) -> Result<PathBuf, String> {
    let python = environment.join("bin/python");
    if !python.exists() {
        quiet(Command::new("python3").args(["-m", "venv"]).arg(environment))
            .map_err(|reason| format!("no Python environment: {reason}"))?;
    }
    let mut install = Command::new(&python);
    install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--retries", "1"]).args(packages);
    quiet(&mut install).map_err(|reason| format!("{} not installed: {reason}", packages.join(", ")))?;
    Ok(python)
}

/// Runs a command without showing what it prints; the error is the last line of its error output.
pub fn quiet(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| error.to_string())?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let text = String::from_utf8_lossy(&output.stderr);
    Err(text.trim().lines().last().unwrap_or("no reason given").to_owned())
}
