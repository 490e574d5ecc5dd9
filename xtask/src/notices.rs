//! `cargo xtask notices`: the licences of all that is linked into the command and the Python package, for releases.

use crate::ci::metadata::Metadata;
use crate::error::Failure;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, process};
use tribodyn_paper::{PaperError, files};

/// Write the licences and notices of all packages that are linked into the command and the Python package
#[derive(clap::Args)]
pub struct Arguments {
    /// File to write
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// Packages whose dependencies are handed on.
const PUBLISHED: [&str; 2] = ["tribodyn-cli", "tribodyn-python"];
/// Third-party parts of the sources, with their licence files.
const EMBEDDED: [(&str, &str); 2] =
    [("uPlot", "crates/report/assets/uplot/LICENSE"), ("DejaVu fonts", "crates/plot/assets/LICENSE-DejaVu.txt")];
/// Names of licence files begin with one of these.
const NAMES: [&str; 4] = ["LICENSE", "LICENCE", "COPYING", "NOTICE"];

const HEAD: &str =
    "What tribodyn is linked with, with its licences and notices. tribodyn itself is under the licence in LICENSE.\n";

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let linked = linked()?;
    // The same text is given once, for all packages that have it.
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut missing = Vec::new();
    for package in Metadata::read(&["--locked"])?.packages {
        if package.source.is_none() || !linked.contains(&(package.name.clone(), package.version.clone())) {
            continue;
        }
        let licence = package.license.as_deref().unwrap_or("no licence stated");
        let title = format!("{} {} ({licence})", package.name, package.version);
        let folder = Path::new(&package.manifest_path).parent().map_or_else(PathBuf::new, Path::to_owned);
        let found = licence_files(&folder)?;
        if found.is_empty() {
            missing.push(title.clone());
        }
        for text in found {
            texts.entry(text).or_default().push(title.clone());
        }
    }
    for (name, path) in EMBEDDED {
        texts.entry(read(&files::root().join(path))?).or_default().push(name.to_owned());
    }
    let mut notices = HEAD.to_owned();
    let mut groups: Vec<_> = texts.into_iter().map(|(text, titles)| (titles, text)).collect();
    groups.sort();
    for (titles, text) in groups {
        // Writing to a string does not fail.
        let _ = write!(notices, "\n{}\n{}\n\n{}\n", "=".repeat(80), titles.join("\n"), text.trim_end());
    }
    if !missing.is_empty() {
        let said = "These come without a licence file; their licences are named beside them:";
        let _ = write!(notices, "\n{}\n{said}\n\n{}\n", "=".repeat(80), missing.join("\n"));
    }
    let path = &arguments.output;
    fs::write(path, notices).map_err(|source| PaperError::Write { path: path.clone(), source }.into())
}

/// Names and versions of what the published packages are linked with.
fn linked() -> Result<Vec<(String, String)>, Failure> {
    let mut found = Vec::new();
    for package in PUBLISHED {
        let program = env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
        let mut tree = process::Command::new(program);
        tree.current_dir(files::root());
        tree.args([
            "tree",
            "--locked",
            "--edges",
            "normal",
            "--prefix",
            "none",
            "--format",
            "{p}",
            "--package",
            package,
        ]);
        let output = tree.output().map_err(|source| Failure::Start { program: "cargo".to_owned(), source })?;
        if !output.status.success() {
            return Err(Failure::Command { command: "cargo tree".to_owned(), status: output.status });
        }
        for line in String::from_utf8_lossy(&output.stdout).lines() {
            let mut words = line.split_whitespace();
            if let (Some(name), Some(version)) = (words.next(), words.next()) {
                found.push((name.to_owned(), version.trim_start_matches('v').to_owned()));
            }
        }
    }
    Ok(found)
}

/// Texts of the licence files of a package.
fn licence_files(folder: &Path) -> Result<Vec<String>, Failure> {
    let unread = |source| PaperError::Read { path: folder.to_owned(), source };
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(unread)? {
        let path = entry.map_err(unread)?.path();
        let name = path.file_name().map(|name| name.to_string_lossy().to_uppercase()).unwrap_or_default();
        if path.is_file() && NAMES.iter().any(|begin| name.starts_with(begin)) {
            paths.push(path);
        }
    }
    paths.sort();
    paths.iter().map(|path| read(path)).collect()
}

fn read(path: &Path) -> Result<String, Failure> {
    let bytes = fs::read(path).map_err(|source| PaperError::Read { path: path.to_owned(), source })?;
    Ok(String::from_utf8_lossy(&bytes).replace("\r\n", "\n"))
}
