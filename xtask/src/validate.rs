//! `cargo xtask validate` and `cargo xtask fixtures`.

use crate::error::Failure;
use crate::terminal::{notes, print, progress};
use std::path::PathBuf;
use tribodyn::path_and_value;
use tribodyn_paper::hypotheses;
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
    /// Replace one value of the case in all runs, such as 'cage.pocket_gap=mm(0.5)'; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = change, conflicts_with = "check")]
    changes: Vec<(String, String)>,
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
    let validation = Validation::new(&case, &arguments.changes, Some(&arguments.output), &progress)?;
    validation.write(&arguments.output)?;
    print(&if arguments.json { validation.json()? } else { validation.text() })?;
    if arguments.case.is_some() || !arguments.changes.is_empty() {
        return Ok(());
    }
    compare(&validation, arguments.check)
}

fn change(text: &str) -> Result<(String, String), String> {
    path_and_value(text).map(|[path, value]| (path.to_owned(), value.to_owned()))
}

/// Regressions and declared verdicts; with `check` also whether documents are current.
fn compare(validation: &Validation, check: bool) -> Result<(), Failure> {
    let differences = validation.compare()?;
    let mut findings = differences.broken;
    if check {
        findings.extend(differences.outdated);
        findings.extend(validation.outdated_documents()?);
        findings.extend(sensitivity::outdated()?);
        findings.extend(hypotheses::outdated()?);
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
    run(&Arguments { json: false, case: None, changes: Vec::new(), output, check: true })
}

/// Rewrites fixtures, declared verdicts and the documents' blocks.
pub fn rewrite_fixtures() -> Result<(), Failure> {
    let validation = Validation::new(&paper_case(), &[], None, &progress)?;
    notes(&validation.rewrite()?);
    sensitivity::rewrite()?;
    hypotheses::rewrite()?;
    print(&format!("{}\n", validation.summary()))
}

#[cfg(test)]
mod tests {
    use super::change;

    #[test]
    fn limit_a_change_has_a_path_and_a_value() {
        let tuple = change("supports.outer.stiffness = (N_per_um(1), N_per_um(1))").unwrap();
        assert_eq!(tuple, ("supports.outer.stiffness".to_owned(), "(N_per_um(1), N_per_um(1))".to_owned()));
        assert!(change("cage.pocket_gap").is_err() && change("=1").is_err() && change("cage.pocket_gap=").is_err());
    }
}
