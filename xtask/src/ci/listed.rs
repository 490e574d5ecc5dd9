//! The files that checks of sources look at.

use crate::error::Failure;
use std::process::Command;
use tribodyn_paper::files;

/// Tracked files, and new ones that are not excluded.
pub fn listed() -> Result<Vec<String>, Failure> {
    let mut command = Command::new("git");
    command.current_dir(files::root()).args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"]);
    let output = command.output().map_err(|source| Failure::Start { program: "git".to_owned(), source })?;
    if !output.status.success() {
        return Err(Failure::Command { command: "git ls-files".to_owned(), status: output.status });
    }
    let text = String::from_utf8_lossy(&output.stdout);
    Ok(text.split('\0').filter(|name| !name.is_empty()).map(str::to_owned).collect())
}
