//! Licences, sources and second versions of all dependencies by `cargo deny`, on every platform, where it is installed.
//! Advisories need a database that changes by the day: they are checked by hand.

use super::{Outcome, cargo};
use crate::built::cargo_program;
use crate::error::Failure;
use std::process::{Command, Stdio};

pub fn check() -> Result<Outcome, Failure> {
    let mut version = Command::new(cargo_program());
    version.args(["deny", "--version"]).stdout(Stdio::null()).stderr(Stdio::null());
    if !version.status().is_ok_and(|status| status.success()) {
        return Ok(Outcome::Skipped("cargo-deny is not installed".to_owned()));
    }
    cargo(&["deny", "check", "--hide-inclusion-graph", "licenses", "sources", "bans"], &[])
}
