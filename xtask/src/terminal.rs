//! Lines for whoever watches.

use crate::error::Failure;
use std::io::Write;

/// Prints a result.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = std::io::stdout().lock();
    stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()).map_err(Failure::Print)
}

/// Shows a line of progress beside the result.
pub fn progress(line: &str) {
    eprintln!("{line}");
}

/// Shows what is no failure yet.
pub fn notes(findings: &[String]) {
    findings.iter().for_each(|finding| eprintln!("note: {finding}"));
}
