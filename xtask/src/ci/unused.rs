//! Dependencies that no source of their crate names.

use super::listed::listed;
use super::metadata::{Dependency, Metadata, Package};
use super::{Outcome, finish};
use crate::error::Failure;
use std::path::Path;
use tribodyn_paper::files;

/// Dependencies that are there for a feature of theirs, or to build what the tests have built: their `Cargo.toml` says
/// why.
const FOR_FEATURES: [(&str, &str); 4] = [
    ("tribodyn-identify", "argmin_math"),
    ("tribodyn-python", "bitflags"),
    ("tribodyn-python", "either"),
    ("tribodyn-python", "syn"),
];
/// Folders of a package that ordinary dependencies do not serve.
const ASIDE: [&str; 3] = ["tests/", "benches/", "examples/"];

pub fn check() -> Result<Outcome, Failure> {
    let metadata = Metadata::read(&["--no-deps"])?;
    let names = listed()?;
    let mut findings = Vec::new();
    for package in &metadata.packages {
        let sources = sources(package, &names)?;
        let unused = package.dependencies.iter().filter(|d| !is_for_features(package, d) && !is_named(d, &sources));
        findings.extend(unused.map(|d| format!("{} does not use {}", package.name, d.name)));
    }
    finish("dependencies that nothing uses", findings)
}

/// Files of a package that may name a dependency, by their place in it, with their text.
fn sources(package: &Package, names: &[String]) -> Result<Vec<(String, String)>, Failure> {
    let root = files::root();
    let folder = Path::new(&package.manifest_path).parent().and_then(|folder| folder.strip_prefix(&root).ok());
    let prefix = folder.map(|folder| format!("{}/", folder.display())).unwrap_or_default();
    let mut sources = Vec::new();
    for name in names {
        let Some(place) = name.strip_prefix(&prefix) else { continue };
        let path = root.join(name);
        if (place.ends_with(".rs") || place == "README.md") && path.exists() {
            sources.push((place.to_owned(), files::read(&path)?));
        }
    }
    Ok(sources)
}

fn is_for_features(package: &Package, dependency: &Dependency) -> bool {
    let known = (package.name.as_str(), dependency.name.replace('-', "_"));
    FOR_FEATURES.iter().any(|(name, of)| *name == known.0 && *of == known.1)
}

/// True if a source names a dependency: one of the library or the program, or any where it is for tests alone.
fn is_named(dependency: &Dependency, sources: &[(String, String)]) -> bool {
    let name = dependency.rename.as_ref().unwrap_or(&dependency.name).replace('-', "_");
    let for_tests = dependency.kind.as_deref() == Some("dev");
    let aside = |place: &str| ASIDE.iter().any(|folder| place.starts_with(folder)) || place == "README.md";
    sources.iter().filter(|(place, _)| for_tests || !aside(place)).any(|(_, text)| has_word(text, &name))
}

fn has_word(text: &str, word: &str) -> bool {
    let part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.match_indices(word).any(|(at, _)| {
        let (before, after) = (text[..at].chars().next_back(), text[at + word.len()..].chars().next());
        !before.is_some_and(part) && !after.is_some_and(part)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_dependency_counts_where_its_kind_serves() {
        let of = |kind: Option<&str>, rename: Option<&str>| Dependency {
            name: "an-other".to_owned(),
            kind: kind.map(str::to_owned),
            rename: rename.map(str::to_owned),
        };
        let source = |place: &str, text: &str| vec![(place.to_owned(), text.to_owned())];
        assert!(is_named(&of(None, None), &source("src/lib.rs", "use an_other::X;")));
        assert!(!is_named(&of(None, None), &source("src/lib.rs", "use an_others::X; // not_an_other")));
        assert!(!is_named(&of(None, None), &source("tests/a.rs", "use an_other::X;")));
        assert!(is_named(&of(Some("dev"), None), &source("tests/a.rs", "use an_other::X;")));
        assert!(is_named(&of(None, Some("own")), &source("src/lib.rs", "own::f()")));
        assert!(!is_named(&of(None, Some("own")), &source("src/lib.rs", "an_other::f()")));
    }
}
