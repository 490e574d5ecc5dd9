//! The command as scripts and people meet it: what it answers, what it refuses, and what it leaves on disk.

#[path = "cli/answers.rs"]
mod answers;
#[path = "cli/bad_arguments.rs"]
mod bad_arguments;
#[path = "cli/bad_cases.rs"]
mod bad_cases;
#[path = "cli/cage.rs"]
mod cage;
#[path = "cli/dataset.rs"]
mod dataset;
#[path = "cli/documents.rs"]
mod documents;
#[path = "cli/ensemble.rs"]
mod ensemble;
#[path = "cli/faulty_runs.rs"]
mod faulty_runs;
#[path = "cli/files.rs"]
mod files;
#[path = "cli/findings.rs"]
mod findings;
#[path = "cli/fits.rs"]
mod fits;
#[path = "cli/fmu.rs"]
mod fmu;
#[path = "cli/implausible.rs"]
mod implausible;
#[path = "cli/life.rs"]
mod life;
#[path = "cli/manual.rs"]
mod manual;
#[path = "cli/merge.rs"]
mod merge;
#[path = "cli/new.rs"]
mod new;
#[path = "cli/oil.rs"]
mod oil;
#[path = "cli/oil_measured.rs"]
mod oil_measured;
#[path = "cli/orbit.rs"]
mod orbit;
#[path = "cli/pair.rs"]
mod pair;
#[path = "cli/rating.rs"]
mod rating;
#[path = "cli/report.rs"]
mod report;
#[path = "cli/run.rs"]
mod run;
#[path = "cli/shaft.rs"]
mod shaft;
#[path = "cli/sheet.rs"]
mod sheet;
#[path = "cli/sides.rs"]
mod sides;
#[path = "cli/sweep.rs"]
mod sweep;
#[path = "cli/vibration.rs"]
mod vibration;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};

const AG: &str = include_str!("../../../fixtures/cases/paper-handset.ron");

/// Path of a case file of the fixtures.
fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases").join(name)
}

/// A folder of its own, removed at the end of a test.
struct Scratch(PathBuf);

impl Scratch {
    fn new() -> Self {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let name = format!("tribodyn-cli-{}-{}", std::process::id(), NUMBER.fetch_add(1, Ordering::Relaxed));
        let folder = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn file(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, content).unwrap();
        path
    }

    /// Names in the folder, sorted, hidden ones included.
    fn names(&self) -> Vec<String> {
        names(&self.0)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Exit code and output of a run of the command.
struct Outcome {
    code: i32,
    out: String,
    err: String,
}

fn command(arguments: &[&dyn AsRef<OsStr>]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tribodyn"));
    command.args(arguments.iter().map(|argument| argument.as_ref())).stdin(Stdio::null());
    // A backtrace must not come even where the environment asks for one.
    command.env("RUST_BACKTRACE", "1").env_remove("FORCE_COLOR").env_remove("NO_COLOR");
    command
}

/// Runs the command; whatever comes of it, it is text without escape sequences, panic or backtrace.
fn run(arguments: &[&dyn AsRef<OsStr>]) -> Outcome {
    let output = command(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    let (out, err) = (text(output.stdout), text(output.stderr));
    for stream in [&out, &err] {
        assert!(!stream.contains('\u{1b}'), "{stream}");
        assert!(!stream.contains("panicked") && !stream.contains("backtrace"), "{stream}");
    }
    Outcome { code: output.status.code().unwrap(), out, err }
}

/// Runs words separated by blanks.
fn run_words(line: &str) -> Outcome {
    let words: Vec<&str> = line.split_whitespace().collect();
    let words: Vec<&dyn AsRef<OsStr>> = words.iter().map(|word| word as _).collect();
    run(&words)
}

impl Outcome {
    /// Failed with this code, nothing on standard output, and all of these in the message.
    fn fails(&self, code: i32, parts: &[&str]) {
        assert_eq!(self.code, code, "{}", self.err);
        assert_eq!(self.out, "", "a failed command answered");
        for part in parts {
            assert!(self.err.contains(part), "`{part}` is not in: {}", self.err);
        }
    }

    /// Done; standard output is one JSON value and nothing else.
    fn json(&self) -> serde_json::Value {
        assert_eq!(self.code, 0, "{}", self.err);
        serde_json::from_str(&self.out).unwrap()
    }

    /// Done; the table for people.
    fn table(&self) -> &str {
        assert_eq!(self.code, 0, "{}", self.err);
        &self.out
    }
}

/// Relative deviation within `tolerance`.
#[track_caller]
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} is not {expected} to {tolerance:e}");
}

/// Starts a command that keeps finished rows in a file, and kills it as soon as there are so many.
#[cfg(unix)]
fn kill_after_rows(mut command: Command, rows: &Path, count: usize) {
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    let began = std::time::Instant::now();
    // The first line says what the rows belong to.
    let found = || std::fs::read_to_string(rows).map_or(0, |text| text.matches('\n').count());
    while found() <= count {
        assert!(child.try_wait().unwrap().is_none(), "it ended before it could be killed");
        assert!(began.elapsed() < std::time::Duration::from_secs(300), "no rows");
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
}
