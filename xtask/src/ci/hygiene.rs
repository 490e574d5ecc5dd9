//! Things that no committed file may hold.

use super::listed::listed;
use super::{Outcome, finish, named};
use crate::error::Failure;
use std::path::Path;
use tribodyn_paper::{PaperError, files};

/// Most lines of a file of Rust.
const LINES: usize = 400;
/// Most lines of a function, its signature and its last bracket included.
const FUNCTION: usize = 60;
/// Most columns of a line.
const COLUMNS: usize = 120;
/// Files whose lines people read and write.
const WRITTEN: [&str; 5] = ["rs", "md", "ron", "toml", "proto"];
/// Largest file, bytes.
const SIZE: u64 = 1_000_000;

/// Leftovers, in pieces so that this file does not hold them.
const LEFTOVERS: [&str; 4] =
    [concat!("todo", "!("), concat!("unimplemented", "!("), concat!("#[", "ignore"), concat!("dbg", "!(")];
/// Words that no source has: where a lint can only deny it, one attribute would lift that.
const UNSAFE: [&str; 4] =
    [concat!("unsafe", " {"), concat!("unsafe", " fn"), concat!("unsafe", " impl"), concat!("(unsafe", "_code")];
/// Output that a core crate leaves to its callers.
const OUTPUT: [&str; 5] = [
    concat!("println", "!("),
    concat!("eprintln", "!("),
    concat!(" print", "!("),
    concat!("eprint", "!("),
    concat!("process", "::exit"),
];
/// Words that no doc comment opens with: after them comes how a thing is used, seldom its name.
const OPENINGS: [&str; 2] = ["What ", "Whether "];
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
    }
    findings.extend(named::missing()?);
    finish("hygiene", findings)
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
            look(&UNSAFE);
        }
        if rust && library {
            look(&OUTPUT);
        }
    }
    let lines = text.lines().count();
    if rust && lines > LINES {
        findings.push(format!("{name}: {lines} lines, above {LINES}"));
    }
    if rust {
        let long = functions(text).into_iter().filter(|(_, length)| *length > FUNCTION);
        findings.extend(
            long.map(|(line, length)| format!("{name}:{line}: a function of {length} lines, above {FUNCTION}")),
        );
    }
    if rust {
        let found = openings(text).into_iter();
        findings.extend(found.map(|line| format!("{name}:{line}: a doc comment opens with What or Whether")));
    }
    findings.extend(wide_lines(name, text));
    findings
}

/// Lines on which a doc comment opens with one of [`OPENINGS`].
fn openings(text: &str) -> Vec<usize> {
    let mut within = false;
    let mut found = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let doc = ["///", "//!"].iter().find_map(|mark| line.trim_start().strip_prefix(mark));
        if !within && doc.is_some_and(|words| OPENINGS.iter().any(|opening| words.trim_start().starts_with(opening))) {
            found.push(number + 1);
        }
        within = doc.is_some();
    }
    found
}

/// Lines above [`COLUMNS`] characters in the files that [`WRITTEN`] names. Exempt is what cannot be broken: rows of
/// Markdown tables, the output of commands in fences, blocks that a command writes, and texts in quotes, which people
/// search for whole.
fn wide_lines(name: &str, text: &str) -> Vec<String> {
    let written = Path::new(name).extension().is_some_and(|e| WRITTEN.iter().any(|written| e == *written));
    if !written || ["/uplot/", "fixtures/fuzz/", "fixtures/survey/"].iter().any(|foreign| name.contains(foreign)) {
        return Vec::new();
    }
    let markdown = name.ends_with(".md");
    // A page that is written whole by a command.
    let mut generated = name == "docs/figures.md";
    let mut fenced = false;
    let mut findings = Vec::new();
    for (number, line) in text.lines().enumerate() {
        fenced ^= markdown && line.trim_start().starts_with("```");
        if markdown && line.starts_with("<!-- ") {
            generated = line.ends_with(":begin -->");
        }
        let whole = if markdown { generated || fenced || line.starts_with('|') } else { line.contains('"') };
        let columns = line.chars().count();
        if columns > COLUMNS && !whole {
            findings.push(format!("{name}:{}: {columns} columns, above {COLUMNS}", number + 1));
        }
    }
    findings
}

/// First line and length of each function that ends on a line of its own. rustfmt puts the closing bracket below the
/// first letter of the signature, so that no parser is needed.
fn functions(text: &str) -> Vec<(usize, usize)> {
    let lines: Vec<&str> = text.lines().collect();
    let begins = |line: &str| {
        let words = line.trim_start().split(' ');
        words.take_while(|word| !word.contains('(') || word.starts_with("pub(")).any(|word| word == "fn")
    };
    let length = |start: usize| {
        let indent = &lines[start][..lines[start].len() - lines[start].trim_start().len()];
        // In macros more may follow the bracket.
        let end = |line: &&str| line.strip_prefix(indent).is_some_and(|rest| rest.starts_with('}'));
        lines[start..].iter().position(end).map(|last| last + 1)
    };
    let starts = (0..lines.len()).filter(|&i| begins(lines[i]) && !lines[i].ends_with(['}', ';']));
    starts.filter_map(|start| length(start).map(|length| (start + 1, length))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_each_leftover_is_found_with_its_line() {
        for word in LEFTOVERS.into_iter().chain(UNSAFE) {
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
    fn limit_doc_comments_open_with_a_name() {
        let text =
            "/// Error of a run.\n/// Whether it counts.\n///\n/// What it is.\nfn f() {}\n    /// What now\n// What\n";
        assert_eq!(openings(text), [6]);
        assert_eq!(inspect("xtask/src/a.rs", "//! Whether it is.\n").len(), 1);
    }

    #[test]
    fn limit_long_files_are_refused() {
        assert!(inspect("crates/wear/src/lib.rs", &"//\n".repeat(LINES)).is_empty());
        assert_eq!(inspect("crates/wear/src/lib.rs", &"//\n".repeat(LINES + 1)).len(), 1);
    }

    #[test]
    fn limit_long_functions_and_wide_lines_are_refused() {
        let function =
            |body: usize| format!("impl A {{\n    pub(crate) fn a() {{\n{}    }}\n}}\n", "x();\n".repeat(body));
        assert!(inspect("crates/wear/src/a.rs", &function(FUNCTION - 2)).is_empty());
        let found = inspect("crates/wear/src/a.rs", &function(FUNCTION - 1));
        assert!(found.len() == 1 && found[0].starts_with("crates/wear/src/a.rs:2: a function of 61"), "{found:?}");
        let wide = "µ".repeat(COLUMNS + 1);
        assert!(inspect("docs/a.md", &wide[..2 * COLUMNS]).is_empty());
        assert_eq!(inspect("docs/a.md", &wide).len(), 1);
        for whole in [format!("|{wide}"), format!("```text\n{wide}\n```")] {
            assert!(inspect("docs/a.md", &whole).is_empty());
        }
        assert!(inspect("crates/wear/src/a.rs", &format!("\"{wide}\"")).is_empty());
    }
}
