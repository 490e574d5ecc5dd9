//! `cargo xtask validate` and `cargo xtask fixtures`.

use crate::error::Failure;
use crate::terminal::{notes, print, progress};
use std::path::PathBuf;
use tribodyn_paper::sensitivity;
use tribodyn_paper::validate::{Validation, paper_case};

/// Options of `validate`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Another case file; committed results and verdicts are those of the paper's case and are not compared then
    #[arg(long, value_name = "FILE")]
    case: Option<PathBuf>,
    /// Folder for tables, recordings and figures
    #[arg(short, long, value_name = "DIR", default_value = "target/validation")]
    output: PathBuf,
    /// Fail where documents or declared verdicts are out of date
    #[arg(long, conflicts_with = "case")]
    check: bool,
}

/// Rebuilds all rows, writes the files and compares with what is committed.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let case = arguments.case.clone().unwrap_or_else(paper_case);
    let validation = Validation::new(&case, Some(&arguments.output), &progress)?;
    validation.write(&arguments.output)?;
    print(&if arguments.json { validation.json()? } else { validation.text() })?;
    if arguments.case.is_some() {
        return Ok(());
    }
    compare(&validation, arguments.check)
}

/// Regressions and declared verdicts; with `check` also whether documents are current.
fn compare(validation: &Validation, check: bool) -> Result<(), Failure> {
    let differences = validation.compare()?;
    let mut findings = differences.broken;
    if check {
        findings.extend(differences.outdated);
        findings.extend(validation.outdated_documents()?);
        findings.extend(sensitivity::outdated()?);
    } else {
        notes(&differences.outdated);
    }
    if findings.is_empty() {
        return Ok(());
    }
    Err(Failure::Check { what: "validation differs from what is committed", findings })
}

/// The same as `cargo xtask validate --check`, into the given folder.
pub fn check(output: PathBuf) -> Result<(), Failure> {
    run(&Arguments { json: false, case: None, output, check: true })
}

/// Rewrites fixtures, declared verdicts and the documents' blocks.
pub fn rewrite_fixtures() -> Result<(), Failure> {
    let validation = Validation::new(&paper_case(), None, &progress)?;
    notes(&validation.rewrite()?);
    sensitivity::rewrite()?;
    print(&format!("{}\n", validation.summary()))
}
