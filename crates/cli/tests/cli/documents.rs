//! The examples of the documents are what the command prints, numbers to 1 %: they show what an answer looks like,
//! while the tests beside this one say how good it is.

use super::{Scratch, command, fixture};
use std::ffi::OsStr;
use std::path::Path;

/// Splits a command line at blanks outside single quotes.
fn words(line: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '\'' => quoted = !quoted,
            ' ' if !quoted => words.push(String::new()),
            _ => words.last_mut().unwrap().push(c),
        }
    }
    words
}

/// True if two lines have the same words, and numbers within 1 %.
fn same(a: &str, b: &str) -> bool {
    let same = |a: &str, b: &str| {
        let [x, y] = [a, b].map(|word| word.trim_end_matches(',').parse::<f64>());
        a == b || matches!((x, y), (Ok(x), Ok(y)) if (x - y).abs() <= 0.01 * x.abs().max(y.abs()))
    };
    let (a, b): (Vec<_>, Vec<_>) = (a.split_whitespace().collect(), b.split_whitespace().collect());
    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| same(a, b))
}

/// True if `printed` is `shown`, where a line `…` stands for any number of lines.
fn agrees(shown: &str, printed: &str) -> bool {
    let mut rest: Vec<&str> = printed.trim_end().lines().collect();
    let mut free = false;
    for line in shown.lines() {
        if line.trim() == "…" {
            free = true;
            continue;
        }
        let Some(at) = rest.iter().position(|found| same(found, line)).filter(|at| free || *at == 0) else {
            return false;
        };
        rest.drain(..=at);
        free = false;
    }
    free || rest.is_empty()
}

/// Runs the examples of a text in a folder; their number.
fn run_examples(name: &str, text: &str, folder: &Path) -> usize {
    // Every other part of the text between fences is code.
    let blocks = text.split("```").skip(1).step_by(2);
    let examples = blocks.filter_map(|block| block.split_once("$ tribodyn ")?.1.split_once('\n'));
    let mut count = 0;
    for (line, shown) in examples {
        count += 1;
        let words = words(line);
        let arguments: Vec<&dyn AsRef<OsStr>> = words.iter().map(|word| word as _).collect();
        let output = command(&arguments).current_dir(folder).output().unwrap();
        let printed = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        // On a slow machine a search gives a sign of life.
        let lasting = printed.lines().filter(|line| !line.starts_with("seeking the operating point: "));
        let printed: String = lasting.flat_map(|line| [line, "\n"]).collect();
        assert!(agrees(shown, &printed), "{name}: `tribodyn {line}` now prints\n{printed}");
    }
    count
}

#[test]
fn regress_examples_of_the_documents() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut examples = 0;
    let pages = ["case-file", "sweep", "running", "ensemble", "life", "rating", "shaft", "faults"]
        .map(|page| format!("docs/{page}.md"));
    for name in ["README.md".to_owned()].into_iter().chain(pages) {
        let text = std::fs::read_to_string(root.join(&name)).unwrap();
        examples += run_examples(&name, &text, &root);
    }
    assert!(examples >= 10, "only {examples} examples were found");
}

/// The tutorial works as it is written, with its case and one command after the other in one folder.
#[test]
fn regress_tutorial() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/tutorial.md");
    let text = std::fs::read_to_string(path).unwrap();
    let scratch = Scratch::new();
    let case = std::fs::read_to_string(fixture("pump-7210.ron")).unwrap();
    scratch.file("7210.ron", &case);
    assert!(run_examples("docs/tutorial.md", &text, &scratch.0) >= 5);
    assert!(scratch.0.join("report/foxglove-layout.json").exists());
}

/// The first bearings work as they are written, one command after the other in one folder.
#[test]
fn regress_first_bearing() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/first-bearing.md");
    let text = std::fs::read_to_string(path).unwrap();
    let scratch = Scratch::new();
    assert!(run_examples("docs/first-bearing.md", &text, &scratch.0) >= 9);
    assert!(scratch.0.join("report/foxglove-layout.json").exists());
}

/// The gallery, one command after the other in one folder that has the fixtures.
#[cfg(unix)]
#[test]
fn regress_gallery() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap();
    let text = std::fs::read_to_string(root.join("docs/gallery.md")).unwrap();
    let scratch = Scratch::new();
    std::os::unix::fs::symlink(root.join("fixtures"), scratch.0.join("fixtures")).unwrap();
    assert!(run_examples("docs/gallery.md", &text, &scratch.0) >= 15);
    let sections = text.lines().filter(|line| line.starts_with("## ")).count();
    assert_eq!(sections, 10, "problems of the gallery");
}

/// Each row of the paper's sections has a command that ends well; runs are shorter than the page has them, and the last
/// row, a search, takes too long.
#[cfg(unix)]
#[test]
fn paper_every_section_can_be_done_by_a_command() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap();
    let text = std::fs::read_to_string(root.join("docs/zhang2025/sections.md")).unwrap();
    let rows: Vec<&str> = text.lines().filter(|line| line.starts_with("| ") && line.contains("tribodyn ")).collect();
    assert!(rows.len() > 20 && rows.iter().all(|row| row.ends_with("| yes |")), "{}", rows.len());
    let scratch = Scratch::new();
    std::os::unix::fs::symlink(root.join("fixtures"), scratch.0.join("fixtures")).unwrap();
    for row in &rows[..rows.len() - 1] {
        let line = row.split("`tribodyn ").nth(1).and_then(|rest| rest.split("` |").next()).unwrap();
        let mut words = words(&line.replace("AG", "fixtures/cases/paper-authors-ag.ron"));
        if words[0] == "run" {
            // Eight turns of the shaft are the least that `vibration` asks for.
            let duration = if words.contains(&"run.mcap".to_owned()) { "0.036" } else { "0.004" };
            words.extend(["--set".to_owned(), format!("transient.duration=s({duration})")]);
        }
        let arguments: Vec<&dyn AsRef<OsStr>> = words.iter().map(|word| word as _).collect();
        let output = command(&arguments).current_dir(&scratch.0).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "`tribodyn {line}`: {said}");
        assert!(!output.stdout.is_empty() || words.contains(&"-o".to_owned()), "`tribodyn {line}` prints nothing");
    }
    for made in ["run.mcap", "report/summary.json", "compared", "cases.csv", "loads.csv", "depth.csv", "figures"] {
        assert!(scratch.0.join(made).exists(), "{made}");
    }
}

/// The FMU of a new bearing, in a folder of its own.
#[test]
fn regress_functional_mock_up_unit() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/fmu.md");
    let text = std::fs::read_to_string(path).unwrap();
    let scratch = Scratch::new();
    assert!(run_examples("docs/fmu.md", &text, &scratch.0) == 2);
    assert!(scratch.0.join("7210.fmu").exists());
}

#[test]
fn limit_comparison_of_examples_skips_nothing_else() {
    assert!(agrees("a\n…\nd\n", "a\nb\nc\nd\n") && agrees("a\n…\n", "a\n") && agrees("…\nb\n", "a\nb\n"));
    assert!(agrees("x 1.000,\n", "x  1.001,\n") && !agrees("x 1.00\n", "x 1.02\n") && !agrees("x 0\n", "x 1e-9\n"));
    assert!(!agrees("a\nd\n", "a\nb\nd\n") && !agrees("a\n", "a\nb\n") && !agrees("a\n…\ne\n", "a\nb\n"));
}
