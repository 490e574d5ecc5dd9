//! Packages as `cargo metadata` has them.

use super::cargo_program;
use crate::error::Failure;
use serde::Deserialize;
use std::process::Command;
use tribodyn_paper::files;

#[derive(Debug, Deserialize)]
pub struct Metadata {
    pub packages: Vec<Package>,
}

#[derive(Debug, Deserialize)]
pub struct Package {
    pub name: String,
    pub version: String,
    pub license: Option<String>,
    pub description: Option<String>,
    pub readme: Option<String>,
    pub keywords: Vec<String>,
    pub categories: Vec<String>,
    /// Registries that may have it: none for an empty list, all where there is no list.
    pub publish: Option<Vec<String>>,
    /// The tables below `package.metadata`.
    pub metadata: serde_json::Value,
    /// None for packages of the workspace.
    pub source: Option<String>,
    pub dependencies: Vec<Dependency>,
    pub manifest_path: String,
}

#[derive(Debug, Deserialize)]
pub struct Dependency {
    pub name: String,
    /// `dev` or `build`; none for an ordinary dependency.
    pub kind: Option<String>,
    /// Name in the sources, where it is not that of the package.
    pub rename: Option<String>,
}

impl Metadata {
    pub fn read(arguments: &[&str]) -> Result<Self, Failure> {
        let mut command = Command::new(cargo_program());
        command.current_dir(files::root()).args(["metadata", "--format-version", "1"]).args(arguments);
        let output = command.output().map_err(|source| Failure::Start { program: "cargo".to_owned(), source })?;
        if !output.status.success() {
            eprint!("{}", String::from_utf8_lossy(&output.stderr));
            return Err(Failure::Command { command: "cargo metadata".to_owned(), status: output.status });
        }
        Ok(serde_json::from_slice(&output.stdout)?)
    }
}
