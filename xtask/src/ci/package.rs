//! The Python package: a wheel, installed into a fresh environment; its tests, its types, its notebooks, its reference.
//!
//! The wheel is built in the dev profile, whose results are those of a release build bit for bit: it takes the crates
//! that the tests have built. Skipped where there is no Python from 3.9 on, or no package index.

use super::Outcome;
use crate::built;
use crate::error::Failure;
use crate::python::{environment, quiet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tribodyn_paper::{PaperError, files};

/// Packages that build the wheel.
const BUILD: [&str; 1] = ["maturin>=1.9,<2"];
/// Packages that the tests need besides the wheel.
const TEST: [&str; 22] = [
    "numpy>=1.22",
    "pandas>=1.5",
    "pandas-stubs",
    "xarray",
    "pyarrow",
    "scipy",
    "SALib",
    "distributed",
    "joblib",
    "pytest",
    "pytest-xdist>=3",
    "mypy",
    "ruff",
    "nbclient",
    "ipykernel",
    "matplotlib",
    "ross-rotordynamics>=2.3,<4",
    // What ROSS asks of it is gone from 7 on.
    "plotly<7",
    "FMPy>=0.3.20",
    "k3d>=2.16",
    "sphinx>=7",
    "furo>=2024.1",
];
/// First release of Python that the wheel is for.
const OLDEST: (u32, u32) = (3, 9);
/// A wheel in an environment of its own: three lines to a table.
const FIRST_STEPS: &str = "import tribodyn
case = tribodyn.Case.new('7210', angle=40)
frame = tribodyn.solve(case).to_pandas()
assert len(frame) == 15 and (frame.load_inner_n > 0).all(), frame
print(tribodyn.__version__, len(frame), 'balls')";

pub fn check() -> Result<Outcome, Failure> {
    let folder = files::root().join("target/python-package");
    let tools = match tools(&folder) {
        Ok(tools) => tools,
        Err(reason) => return Ok(Outcome::Skipped(reason)),
    };
    let wheel = wheel(&folder, &tools.maturin)?;
    fresh(&folder, &wheel)?;
    let mut install = Command::new(&tools.tests);
    install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--force-reinstall", "--no-deps"]);
    shown(install.arg(&wheel), "pip install of the wheel")?;
    let package = files::root().join("crates/python");
    for arguments in [&["-m", "ruff", "format", "--check", "-q", "."][..], &["-m", "ruff", "check", "-q", "."]] {
        shown(Command::new(&tools.tests).current_dir(&package).args(arguments), "ruff")?;
    }
    let mut types = Command::new(&tools.tests);
    shown(types.current_dir(&package).args(["-m", "mypy", "--config-file", "pyproject.toml"]), "mypy")?;
    // Tests that go by the clock have the machine to themselves.
    for (marked, workers) in [("not alone", "auto"), ("alone", "0")] {
        let mut tests = Command::new(&tools.tests);
        tests.current_dir(&package).args(["-m", "pytest", "-q", "-p", "no:cacheprovider", "--durations=8"]);
        tests.args(["-m", marked, "-n", workers, "--dist", "worksteal"]);
        tests.env("TRIBODYN_COMMAND", built::programs()?.join("tribodyn")).env("PYTHONDONTWRITEBYTECODE", "1");
        shown(&mut tests, "pytest")?;
    }
    Ok(Outcome::Done)
}

/// Pythons with what builds and what tests.
struct Tools {
    maturin: PathBuf,
    tests: PathBuf,
}

fn tools(folder: &Path) -> Result<Tools, String> {
    let version = quiet(Command::new("python3").args(["-c", "import sys; print(*sys.version_info[:2])"]))
        .map_err(|reason| format!("no Python: {reason}"))?;
    let numbers: Vec<u32> = version.split_whitespace().filter_map(|number| number.parse().ok()).collect();
    match numbers[..] {
        [major, minor] if (major, minor) >= OLDEST => {}
        _ => return Err(format!("Python {} is older than {}.{}", version.trim(), OLDEST.0, OLDEST.1)),
    }
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let build = environment(&folder.join("build"), &BUILD)?;
    let tests = environment(&folder.join("tests"), &TEST)?;
    Ok(Tools { maturin: build.with_file_name("maturin"), tests })
}

/// Builds the one wheel.
fn wheel(folder: &Path, maturin: &Path) -> Result<PathBuf, Failure> {
    let wheels = folder.join("wheels");
    if wheels.exists() {
        fs::remove_dir_all(&wheels).map_err(|source| PaperError::Write { path: wheels.clone(), source })?;
    }
    let mut build = Command::new(maturin);
    build.current_dir(files::root().join("crates/python"));
    build.args(["build", "--profile", "dev", "--compatibility", "linux", "--locked", "--out"]).arg(&wheels);
    shown(&mut build, "maturin build")?;
    let found = fs::read_dir(&wheels).map_err(|source| PaperError::Read { path: wheels.clone(), source })?;
    let mut found: Vec<PathBuf> = found.filter_map(|entry| entry.ok().map(|entry| entry.path())).collect();
    match (found.pop(), found.is_empty()) {
        (Some(wheel), true) => Ok(wheel),
        _ => Err(Failure::Check { what: "maturin build", findings: vec!["not one wheel".to_owned()] }),
    }
}

/// The wheel with what it asks for, and nothing else.
fn fresh(folder: &Path, wheel: &Path) -> Result<(), Failure> {
    let fresh = folder.join("fresh");
    shown(Command::new("python3").args(["-m", "venv", "--clear"]).arg(&fresh), "python3 -m venv")?;
    let python = fresh.join("bin/python");
    let mut install = Command::new(&python);
    shown(install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]).arg(wheel), "pip install")?;
    // Not from the folder of the sources.
    shown(Command::new(&python).current_dir(folder).args(["-c", FIRST_STEPS]), "the package in a fresh environment")
}

/// Runs a command, its output shown.
fn shown(command: &mut Command, name: &str) -> Result<(), Failure> {
    let status = command.status().map_err(|source| Failure::Start { program: name.to_owned(), source })?;
    if status.success() { Ok(()) } else { Err(Failure::Command { command: name.to_owned(), status }) }
}
