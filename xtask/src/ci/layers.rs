//! Which crate may use which: the table of docs/architecture.md, held against `cargo metadata`.

use super::metadata::Metadata;
use super::{Outcome, finish};
use crate::error::Failure;

/// Crates from the bottom up, each with what it may use; tests and build scripts included.
const LAYERS: [(&str, &[&str]); 12] = [
    ("tribodyn-contact", &[]),
    ("tribodyn-traction", &["tribodyn-contact"]),
    ("tribodyn-wear", &["tribodyn-contact", "tribodyn-traction"]),
    ("tribodyn-fluid", &[]),
    ("tribodyn-signal", &[]),
    ("tribodyn-bearing", &["tribodyn-contact", "tribodyn-traction", "tribodyn-wear", "tribodyn-fluid"]),
    ("tribodyn-quasistatic", &["tribodyn-bearing"]),
    // Identification writes its candidates into the case file, so it knows `bearing` too.
    ("tribodyn-identify", &["tribodyn-bearing", "tribodyn-quasistatic"]),
    // Samples are filtered before they are thinned out.
    ("tribodyn-dynamics", &["tribodyn-bearing", "tribodyn-quasistatic", "tribodyn-signal"]),
    // Recordings of runs hold spectra that a viewer cannot compute.
    ("tribodyn-record", &["tribodyn-bearing", "tribodyn-quasistatic", "tribodyn-dynamics", "tribodyn-signal"]),
    ("tribodyn-plot", &["tribodyn-bearing", "tribodyn-quasistatic"]),
    // Procedures as a library: all physics, and recordings.
    (
        "tribodyn-study",
        &[
            "tribodyn-contact",
            "tribodyn-traction",
            "tribodyn-wear",
            "tribodyn-fluid",
            "tribodyn-signal",
            "tribodyn-bearing",
            "tribodyn-quasistatic",
            "tribodyn-dynamics",
            "tribodyn-record",
        ],
    ),
];
/// Programs that may use every crate.
const TOP: [&str; 2] = ["tribodyn-cli", "xtask"];

pub fn check() -> Result<Outcome, Failure> {
    let metadata = Metadata::read(&["--no-deps"])?;
    let members: Vec<(&str, Vec<&str>)> = metadata
        .packages
        .iter()
        .map(|p| (p.name.as_str(), p.dependencies.iter().map(|d| d.name.as_str()).collect()))
        .collect();
    finish(
        "dependencies between crates (table in xtask/src/ci/layers.rs and docs/architecture.md)",
        violations(&members),
    )
}

/// Dependencies that the table does not have, and members that it does not know.
fn violations(members: &[(&str, Vec<&str>)]) -> Vec<String> {
    let mut findings = Vec::new();
    let is_member = |name: &str| members.iter().any(|(member, _)| *member == name);
    for (name, dependencies) in members {
        if TOP.contains(name) {
            continue;
        }
        let Some((_, allowed)) = LAYERS.iter().find(|(layer, _)| layer == name) else {
            findings.push(format!("{name} is in no layer"));
            continue;
        };
        let own = dependencies.iter().filter(|d| is_member(d) && !allowed.contains(d));
        findings.extend(own.map(|d| {
            let list = if allowed.is_empty() { "no crate of the workspace".to_owned() } else { allowed.join(", ") };
            format!("{name} uses {d}, but may use {list}")
        }));
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_the_table_has_no_cycle() {
        for (place, (name, allowed)) in LAYERS.iter().enumerate() {
            let below = |d: &&str| LAYERS[..place].iter().any(|(layer, _)| layer == d);
            assert!(allowed.iter().all(below), "{name} uses a layer above it");
        }
    }

    #[test]
    fn limit_upward_and_unknown_dependencies_are_named() {
        let members = [
            ("tribodyn-contact", vec!["serde", "tribodyn-traction"]),
            ("tribodyn-traction", vec!["tribodyn-contact"]),
            ("tribodyn-new", vec![]),
            ("xtask", vec!["tribodyn-contact"]),
        ];
        let found = violations(&members);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found[0].contains("tribodyn-contact uses tribodyn-traction"));
        assert!(found[1].contains("tribodyn-new is in no layer"));
    }
}
