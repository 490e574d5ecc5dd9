//! `cargo xtask page`: a report in a real browser.

use crate::built;
use crate::error::Failure;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use tribodyn_paper::{PaperError, files};

/// Reports opened in headless Chromium: wide and narrow, light and dark, with scripts and without, and as print
#[derive(clap::Args)]
pub struct Arguments {
    /// Pages to open; without any, that of a short run of the paper's bearing
    #[arg(value_name = "REPORT.html")]
    pages: Vec<PathBuf>,
    /// Folder for a picture of each view
    #[arg(long, value_name = "DIR")]
    pictures: Option<PathBuf>,
    /// Chromium or a browser of its family; without it, the first that is found
    #[arg(long, value_name = "PROGRAM")]
    browser: Option<String>,
}

/// Folder in which the page of the short run is made.
const FOLDER: &str = "target/page";
/// Duration of that run, s: two turns of the cage, so that there are spectra and charts over an orbit.
const DURATION_S: &str = "0.03";
const CASE: &str = "fixtures/cases/paper-ag.ron";
const SCRIPT: &str = "xtask/checks/report_page.py";
/// Names of the browser, usual ones first.
const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// A check that ran, or the reason why it could not.
pub enum Checked {
    Passed,
    Skipped(String),
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Checked::Skipped(reason) = check(arguments)? {
        println!("SKIPPED: {reason}");
    }
    Ok(())
}

/// The page of a short run, for continuous integration.
pub fn check_usual() -> Result<Checked, Failure> {
    check(&Arguments { pages: Vec::new(), pictures: None, browser: None })
}

fn check(arguments: &Arguments) -> Result<Checked, Failure> {
    let browser = match first_of(arguments.browser.as_deref()) {
        Ok(browser) => browser,
        Err(reason) => return Ok(Checked::Skipped(reason)),
    };
    let pages = if arguments.pages.is_empty() { vec![usual_page()?] } else { arguments.pages.clone() };
    let mut command = Command::new("python3");
    command.arg(files::root().join(SCRIPT)).args(["--browser", &browser]);
    if let Some(folder) = &arguments.pictures {
        command.arg("--pictures").arg(folder);
    }
    finished(command.args(&pages), "python3", SCRIPT)?;
    Ok(Checked::Passed)
}

/// A browser that can be driven; the error says what is missing.
pub fn browser() -> Result<String, String> {
    first_of(None)
}

fn first_of(named: Option<&str>) -> Result<String, String> {
    let browsers: Vec<&str> = named.map_or(BROWSERS.to_vec(), |named| vec![named]);
    let Some(browser) = browsers.iter().find(|browser| answers(browser)) else {
        return Err(format!("no browser: none of {} answers --version", browsers.join(", ")));
    };
    if !answers("python3") {
        return Err("no python3, which drives the browser".to_owned());
    }
    Ok((*browser).to_owned())
}

/// True if a program can be started.
pub fn answers(program: &str) -> bool {
    let status = Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    status.is_ok_and(|status| status.success())
}

/// The report of a short run, made by the command as it stands.
fn usual_page() -> Result<PathBuf, Failure> {
    let folder = files::root().join(FOLDER);
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|source| PaperError::Write { path: folder.clone(), source })?;
    }
    fs::create_dir_all(&folder).map_err(|source| PaperError::Write { path: folder.clone(), source })?;
    let [run, report, page] = ["run.mcap", "report", "report/report.html"].map(|name| folder.join(name));
    let case = files::root().join(CASE);
    let texts = |all: &[&str]| all.iter().map(OsString::from).collect::<Vec<_>>();
    let to = OsString::from("-o");
    let program = built::programs()?.join("tribodyn");
    tribodyn(
        &program,
        [texts(&["run", "--quiet", "--duration", DURATION_S]), vec![case.into(), to.clone(), run.clone().into()]],
    )?;
    tribodyn(&program, [texts(&["report"]), vec![run.into(), to, report.into()]])?;
    Ok(page)
}

/// Runs the command as it stands.
fn tribodyn(program: &Path, arguments: [Vec<OsString>; 2]) -> Result<(), Failure> {
    let mut command = Command::new(program);
    command.current_dir(files::root());
    finished(command.args(arguments.concat()).stdout(Stdio::null()), &program.display().to_string(), "tribodyn")
}

/// Runs a command to its end.
pub fn finished(command: &mut Command, program: &str, name: &str) -> Result<(), Failure> {
    let status = command.status().map_err(|source| Failure::Start { program: program.to_owned(), source })?;
    if status.success() { Ok(()) } else { Err(Failure::Command { command: name.to_owned(), status }) }
}
