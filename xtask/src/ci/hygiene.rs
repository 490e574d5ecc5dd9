//! Things that no committed file may hold.

use super::{Outcome, finish};
use crate::error::Failure;
use std::path::Path;
use std::process::Command;
use tribodyn_paper::{PaperError, files};

/// Lines of Rust above which a file is named, and above which it is refused.
const LINES: [usize; 2] = [400, 500];
/// Largest file, bytes.
const SIZE: u64 = 1_000_000;

/// Leftovers, in pieces so that this file does not hold them.
const LEFTOVERS: [&str; 4] =
    [concat!("todo", "!("), concat!("unimplemented", "!("), concat!("#[", "ignore"), concat!("dbg", "!(")];
/// Output that a core crate leaves to its callers.
const OUTPUT: [&str; 5] = [
    concat!("println", "!("),
    concat!("eprintln", "!("),
    concat!(" print", "!("),
    concat!("eprint", "!("),
    concat!("process", "::exit"),
];
/// Homes of people and build users.
const HOMES: [&str; 3] = [concat!("/ho", "me/"), concat!("/ro", "ot/"), concat!("/Us", "ers/")];
/// Crates that are programs and may print.
const PROGRAMS: [&str; 2] = ["crates/cli/", "xtask/"];

/// Folders of a crate that are no part of its library.
const ASIDE: [&str; 3] = ["/tests/", "/benches/", "/examples/"];

pub fn check() -> Result<Outcome, Failure> {
    let mut findings = Vec::new();
    for name in listed()? {
        let path = files::root().join(&name);
        // A file that is deleted but not yet committed is listed too.
        let Ok(metadata) = std::fs::metadata(&path) else { continue };
        if metadata.len() > SIZE {
            findings.push(format!("{name}: {} bytes, above {SIZE}", metadata.len()));
        }
        let bytes = std::fs::read(&path).map_err(|source| PaperError::Read { path: path.clone(), source })?;
        let text = String::from_utf8_lossy(&bytes);
        findings.extend(inspect(&name, &text));
        if name.ends_with(".rs") && (LINES[0] + 1..=LINES[1]).contains(&text.lines().count()) {
            println!("note: {name} has {} lines, above {}", text.lines().count(), LINES[0]);
        }
    }
    finish("hygiene", findings)
}

/// Tracked files, and new ones that are not excluded.
pub fn listed() -> Result<Vec<String>, Failure> {
    let mut command = Command::new("git");
    command.current_dir(files::root()).args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"]);
    let output = command.output().map_err(|source| Failure::Start { program: "git".to_owned(), source })?;
    if !output.status.success() {
        return Err(Failure::Command { command: "git ls-files".to_owned(), status: output.status });
    }
    let text = String::from_utf8_lossy(&output.stdout);
    Ok(text.split('\0').filter(|name| !name.is_empty()).map(str::to_owned).collect())
}

fn inspect(name: &str, text: &str) -> Vec<String> {
    let mut findings = Vec::new();
    let rust = Path::new(name).extension().is_some_and(|e| e == "rs");
    let core = name.starts_with("crates/") && !PROGRAMS.iter().any(|p| name.starts_with(p));
    let library = core && !ASIDE.iter().any(|aside| name.contains(aside)) && !name.ends_with("/build.rs");
    for (number, line) in text.lines().enumerate() {
        let mut look = |words: &[&str]| {
            let found = words.iter().filter(|word| line.contains(**word));
            findings.extend(found.map(|word| format!("{name}:{}: `{}`", number + 1, word.trim())));
        };
        look(&HOMES);
        if rust {
            look(&LEFTOVERS);
        }
        if rust && library {
            look(&OUTPUT);
        }
    }
    let lines = text.lines().count();
    if rust && lines > LINES[1] {
        findings.push(format!("{name}: {lines} lines, above {}", LINES[1]));
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_each_leftover_is_found_with_its_line() {
        for word in LEFTOVERS {
            let found = inspect("crates/contact/src/a.rs", &format!("fn f() {{\n    {word}\n}}\n"));
            assert!(found.len() == 1 && found[0].starts_with("crates/contact/src/a.rs:2"), "{word}: {found:?}");
        }
        for home in HOMES {
            assert_eq!(inspect("docs/a.md", &format!("see {home}someone")).len(), 1);
        }
    }

    #[test]
    fn limit_only_core_crates_must_not_print() {
        let line = format!("    {}\"x\");\n", OUTPUT[0]);
        for library in ["crates/wear/src/lib.rs", "crates/paper/src/lib.rs"] {
            assert_eq!(inspect(library, &line).len(), 1, "{library}");
        }
        for program in
            ["crates/cli/src/main.rs", "xtask/src/main.rs", "crates/wear/tests/a.rs", "crates/wear/examples/a.rs"]
        {
            assert!(inspect(program, &line).is_empty(), "{program}");
        }
    }

    #[test]
    fn limit_long_files_are_refused() {
        assert!(inspect("crates/wear/src/lib.rs", &"//\n".repeat(LINES[1])).is_empty());
        assert_eq!(inspect("crates/wear/src/lib.rs", &"//\n".repeat(LINES[1] + 1)).len(), 1);
    }
}
