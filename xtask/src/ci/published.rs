//! The crates as registries would have them: each can be packed, with what its page there needs.

use super::metadata::Metadata;
use super::{Outcome, cargo, finish};
use crate::error::Failure;

/// Packs every crate that is to be published, without building it: that its files and dependencies are found, and that
/// those of the workspace are published too. Release builds compile them from these packages.
pub fn check() -> Result<Outcome, Failure> {
    let packages = Metadata::read(&["--no-deps", "--offline"])?.packages;
    let mut arguments = vec!["package", "--workspace", "--no-verify", "--allow-dirty", "--offline", "--quiet"];
    let mut findings = Vec::new();
    for package in &packages {
        if package.publish.as_ref().is_some_and(Vec::is_empty) {
            arguments.extend(["--exclude", &package.name]);
            continue;
        }
        let missing = [
            ("description", package.description.is_none()),
            ("license", package.license.is_none()),
            ("readme", package.readme.is_none()),
            ("keywords", package.keywords.is_empty()),
            ("categories", package.categories.is_empty()),
            ("metadata.docs.rs", package.metadata.pointer("/docs/rs").is_none()),
        ];
        let missing = missing.into_iter().filter(|(_, missing)| *missing);
        findings.extend(missing.map(|(name, _)| format!("{}: no {name} in its Cargo.toml", package.name)));
    }
    if !findings.is_empty() {
        return finish("crates cannot be published", findings);
    }
    // It warns of each crate that there is no repository: CONTRIBUTING.md says who fills that in.
    cargo(&arguments, &[])
}
