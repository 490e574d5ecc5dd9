//! The layers of the workspace: the table of docs/architecture.md, held against `cargo metadata`, and against
//! re-exports that would hand on a whole crate behind it.

use super::listed::listed;
use super::metadata::{Dependency, Metadata};
use super::{Outcome, finish};
use crate::error::Failure;
use tribodyn_paper::files;

/// Crates from the bottom up, each with what it may use; tests and build scripts included.
const LAYERS: [(&str, &[&str]); 24] = [
    // Knows no bearing.
    ("tribodyn-numerics", &[]),
    ("tribodyn-contact", &[]),
    ("tribodyn-lubricant", &[]),
    // Nodes and conductances alone.
    ("tribodyn-thermal", &[]),
    // Films under shear.
    ("tribodyn-traction", &["tribodyn-contact", "tribodyn-lubricant"]),
    ("tribodyn-wear", &["tribodyn-contact", "tribodyn-traction"]),
    ("tribodyn-fluid", &[]),
    ("tribodyn-signal", &[]),
    // The standards' formulas; static ratings are Hertz contacts.
    ("tribodyn-rating", &["tribodyn-contact"]),
    // Balls from load ratings.
    ("tribodyn-catalogue", &["tribodyn-rating"]),
    (
        "tribodyn-bearing",
        &["tribodyn-contact", "tribodyn-lubricant", "tribodyn-traction", "tribodyn-wear", "tribodyn-fluid"],
    ),
    (
        "tribodyn-case",
        &[
            "tribodyn-contact",
            "tribodyn-lubricant",
            "tribodyn-traction",
            "tribodyn-wear",
            "tribodyn-fluid",
            "tribodyn-rating",
            "tribodyn-bearing",
        ],
    ),
    ("tribodyn-quasistatic", &["tribodyn-traction", "tribodyn-bearing"]),
    // Samples are filtered before they are thinned out.
    (
        "tribodyn-dynamics",
        &[
            "tribodyn-numerics",
            "tribodyn-traction",
            "tribodyn-wear",
            "tribodyn-fluid",
            "tribodyn-bearing",
            "tribodyn-quasistatic",
            "tribodyn-signal",
        ],
    ),
    // Identification writes its candidates into the case file, solves it and runs it.
    ("tribodyn-identify", &["tribodyn-bearing", "tribodyn-case", "tribodyn-quasistatic", "tribodyn-dynamics"]),
    // The orbit that a run settles to, and its linearisation.
    (
        "tribodyn-orbit",
        &[
            "tribodyn-numerics",
            "tribodyn-contact",
            "tribodyn-traction",
            "tribodyn-wear",
            "tribodyn-fluid",
            "tribodyn-bearing",
            "tribodyn-quasistatic",
            "tribodyn-dynamics",
        ],
    ),
    // Shafts on bearings.
    ("tribodyn-shaft", &["tribodyn-contact", "tribodyn-bearing", "tribodyn-quasistatic"]),
    // Recordings of runs hold spectra that a viewer cannot compute.
    ("tribodyn-record", &["tribodyn-bearing", "tribodyn-quasistatic", "tribodyn-dynamics", "tribodyn-signal"]),
    ("tribodyn-plot", &["tribodyn-bearing", "tribodyn-quasistatic"]),
    // C sources that solve the same equations, and the numbers of a bearing for them.
    ("tribodyn-fmu", &["tribodyn-bearing"]),
    // The front door: answers about a case, without files.
    (
        "tribodyn",
        &[
            "tribodyn-contact",
            "tribodyn-lubricant",
            "tribodyn-traction",
            "tribodyn-fluid",
            "tribodyn-signal",
            "tribodyn-rating",
            "tribodyn-thermal",
            "tribodyn-catalogue",
            "tribodyn-bearing",
            "tribodyn-case",
            "tribodyn-quasistatic",
            "tribodyn-orbit",
        ],
    ),
    // What runs in the page.
    ("tribodyn-web", &["tribodyn", "tribodyn-signal"]),
    // Procedures as a library: all physics, and recordings.
    (
        "tribodyn-study",
        &[
            "tribodyn",
            "tribodyn-contact",
            "tribodyn-lubricant",
            "tribodyn-traction",
            "tribodyn-wear",
            "tribodyn-fluid",
            "tribodyn-signal",
            "tribodyn-bearing",
            "tribodyn-case",
            "tribodyn-quasistatic",
            "tribodyn-dynamics",
            "tribodyn-orbit",
            "tribodyn-record",
            "tribodyn-fmu",
            "tribodyn-rating",
            "tribodyn-catalogue",
            "tribodyn-shaft",
        ],
    ),
    // Pages of recordings.
    (
        "tribodyn-report",
        &[
            "tribodyn",
            "tribodyn-signal",
            "tribodyn-bearing",
            "tribodyn-case",
            "tribodyn-quasistatic",
            "tribodyn-record",
            "tribodyn-plot",
            "tribodyn-study",
        ],
    ),
];
/// Crates that may use every other one, each with its exceptions: the published command not the study of the paper,
/// which is not published, the Python package neither of both, and the study no program.
const TOP: [(&str, &[&str]); 4] = [
    ("tribodyn-paper", &["tribodyn-cli", "tribodyn-python", "xtask"]),
    ("tribodyn-cli", &["tribodyn-paper", "tribodyn-python", "xtask"]),
    ("tribodyn-python", &["tribodyn-paper", "tribodyn-cli", "xtask"]),
    ("xtask", &["tribodyn-python"]),
];
/// Crates that tests and benches may use besides: those of the solvers read the case files of `fixtures`.
const IN_TESTS: [(&str, &str); 4] = [
    ("tribodyn-quasistatic", "tribodyn-case"),
    ("tribodyn-dynamics", "tribodyn-case"),
    ("tribodyn-orbit", "tribodyn-case"),
    ("tribodyn-record", "tribodyn-case"),
];

pub fn check() -> Result<Outcome, Failure> {
    let metadata = Metadata::read(&["--no-deps"])?;
    let members: Vec<(&str, Vec<&str>)> = metadata
        .packages
        .iter()
        .map(|p| {
            let in_tests = |d: &&Dependency| {
                d.kind.as_deref() == Some("dev") && IN_TESTS.contains(&(p.name.as_str(), d.name.as_str()))
            };
            let held = p.dependencies.iter().filter(|d| !in_tests(d));
            (p.name.as_str(), held.map(|d| d.name.as_str()).collect())
        })
        .collect();
    let mut findings = violations(&members);
    for name in listed()?.iter().filter(|name| name.starts_with("crates/") && name.ends_with(".rs")) {
        let path = files::root().join(name);
        // A file that is deleted but not yet committed is listed too.
        if path.exists() {
            let found = whole_crates(&files::read(&path)?);
            findings.extend(found.iter().map(|statement| format!("{name}: `{statement}` hands on a whole crate")));
        }
    }
    finish("dependencies between crates (table in xtask/src/ci/layers.rs and docs/architecture.md)", findings)
}

/// Statements of a source that re-export a whole crate of the workspace: who uses them would use that crate past the
/// table. Single items may be handed on.
fn whole_crates(source: &str) -> Vec<String> {
    let statements = source.match_indices("pub ").filter_map(|(at, _)| source[at..].split(';').next());
    let whole = |statement: &&str| {
        let Some(path) = statement.strip_prefix("pub use ").or(statement.strip_prefix("pub extern crate ")) else {
            return false;
        };
        let Some(path) = path.trim_start_matches("::").strip_prefix("tribodyn_") else { return false };
        let items = path.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '_');
        let Some(items) = items.strip_prefix("::") else { return true };
        let mut items = items.split([',', '{', '}']).map(str::trim);
        items.any(|item| item == "*" || item.split(' ').next() == Some("self"))
    };
    statements.filter(whole).map(str::to_owned).collect()
}

/// Dependencies that the table does not have, and members that it does not know.
fn violations(members: &[(&str, Vec<&str>)]) -> Vec<String> {
    let mut findings = Vec::new();
    let is_member = |name: &str| members.iter().any(|(member, _)| *member == name);
    for (name, dependencies) in members {
        if let Some((_, barred)) = TOP.iter().find(|(top, _)| top == name) {
            findings
                .extend(dependencies.iter().filter(|d| barred.contains(d)).map(|d| format!("{name} may not use {d}")));
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
    fn limit_re_exports_of_whole_crates_are_named_and_those_of_items_are_not() {
        let word = concat!("pub", " use tribodyn_");
        for rest in ["wear", "wear as wear", "wear::*", "wear::{self, Archard}", "wear::{self as w}"] {
            assert_eq!(whole_crates(&format!("mod a;\n{word}{rest};\n")), [format!("{word}{rest}")], "{rest}");
        }
        for rest in ["wear::Archard", "wear::{Archard,\n    Defect}", "wear::surface::LocalSurface as Surface"] {
            assert!(whole_crates(&format!("{word}{rest};\n")).is_empty(), "{rest}");
        }
        assert!(whole_crates("use tribodyn_wear as wear;").is_empty());
    }

    #[test]
    fn limit_upward_and_unknown_dependencies_are_named() {
        let members = [
            ("tribodyn-contact", vec!["serde", "tribodyn-traction"]),
            ("tribodyn-traction", vec!["tribodyn-contact"]),
            ("tribodyn-new", vec![]),
            ("tribodyn-paper", vec!["tribodyn-contact"]),
            ("tribodyn-cli", vec!["tribodyn-contact", "tribodyn-paper"]),
            ("xtask", vec!["tribodyn-contact", "tribodyn-paper"]),
        ];
        let found = violations(&members);
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(found[0].contains("tribodyn-contact uses tribodyn-traction"));
        assert!(found[1].contains("tribodyn-new is in no layer"));
        assert!(found[2].contains("tribodyn-cli may not use tribodyn-paper"));
    }
}
