//! Disks that are full, and folders in which an ordinary user may not write.

use super::kills::is_whole;
use super::lab::{Lab, Reference, beside, messages, names, same, told, words};
use super::row::{Row, ensure};
use crate::error::Failure;
use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Trials with a full disk.
const DISKS: usize = 20;
/// The user that owns nothing, where the task is run by root.
#[cfg(unix)]
const NOBODY: u32 = 65_534;

/// A small disk, unmounted when it is dropped.
struct Disk<'a>(&'a Path);

impl<'a> Disk<'a> {
    /// None where this user may not mount.
    fn mount(folder: &'a Path, kib: usize) -> Option<Self> {
        let size = format!("size={kib}k");
        run("mount", &["-t", "tmpfs", "-o", &size, "tmpfs"], folder).then_some(Self(folder))
    }

    fn grow(&self) -> bool {
        run("mount", &["-o", "remount,size=512m"], self.0)
    }
}

impl Drop for Disk<'_> {
    fn drop(&mut self) {
        run("umount", &[], self.0);
    }
}

fn run(program: &str, words: &[&str], folder: &Path) -> bool {
    let mut command = Command::new(program);
    command.args(words).arg(folder).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Runs on disks that are too small for them; without the right to mount, under a limit on the size of files.
pub fn full(lab: &mut Lab, references: &[Reference]) -> Result<Vec<Row>, Failure> {
    let mut row = Row::new("full disk: told, recovered, resumed where there is room");
    let mut answers = Row::new("full disk: answers, tables, recordings of solutions, reports");
    let mut real = true;
    for trial in 0..DISKS {
        let reference = &references[trial % references.len()];
        let size = fs::metadata(&reference.recording).map_or(1 << 20, |m| m.len()) as usize / 1024;
        let kib = 64 + lab.random.below(size * 3 / 4);
        let folder = lab.scratch()?;
        let outside = lab.scratch()?;
        let disk = Disk::mount(&folder, kib);
        real &= disk.is_some();
        let recording = folder.join("run.mcap");
        let words = lab.run_words(reference.plan, &recording, &[]);
        let output = if disk.is_some() { lab.output(&words)? } else { limited(lab, kib, &words)? };
        let outcome = is_told(lab, &output, &recording, &outside, reference)?;
        let room = disk.as_ref().is_none_or(Disk::grow);
        row.count(match outcome {
            Ok(()) if room => goes_on(lab, &recording, reference)?,
            other => other,
        });
    }
    row.worst = (if real { "tmpfs" } else { "a limit on files: no right to mount" }).to_owned();
    for words in small_ones(lab, &references[0]) {
        let folder = lab.scratch()?;
        let Some(disk) = Disk::mount(&folder, 8) else { continue };
        let words = with_output(words, &folder);
        let output = lab.output(&words)?;
        answers.count(nothing_is_left(&output, &folder, &[]).map_err(|why| format!("{:?}: {why}", words[0])));
        drop(disk);
    }
    if let Ok(full) = fs::OpenOptions::new().write(true).open("/dev/full") {
        let mut command = lab.command(&words([&"check", &lab.case()]));
        let output = command.stdout(full).output().map_err(|source| lab.no_start(source))?;
        answers.count(ensure(output.status.code() == Some(1), || told(&output)));
    }
    Ok(vec![row, answers])
}

/// A limit on the size of files, the signal that goes with it ignored, fails as a full disk does.
fn limited(lab: &Lab, kib: usize, words: &[OsString]) -> Result<Output, Failure> {
    let line = format!("trap '' XFSZ; ulimit -f {kib}; exec \"$0\" \"$@\"");
    let mut command = Command::new("bash");
    command.arg("-c").arg(line).arg(&lab.program).args(words).stdin(Stdio::null());
    command.output().map_err(|source| Failure::Start { program: "bash".to_owned(), source })
}

/// The run says what it could not write, and what it wrote can be recovered elsewhere.
fn is_told(
    lab: &Lab,
    output: &Output,
    recording: &Path,
    outside: &Path,
    reference: &Reference,
) -> Result<Result<(), String>, Failure> {
    let said = told(output);
    let text = String::from_utf8_lossy(&output.stderr);
    if output.status.code() != Some(1) || !text.contains("cannot") || recording.exists() {
        return Ok(Err(format!("{said}; the recording is {}there", if recording.exists() { "" } else { "not " })));
    }
    let saved = outside.join("saved.mcap");
    let recovered = lab.output(&words([&"recover", &beside(recording, ".active"), &"-o", &saved]))?;
    Ok(match recovered.status.code() {
        Some(0) => messages(&saved).and_then(|found| same(&found, &reference.messages, true)),
        // A disk so small that not even one message is on it.
        Some(1) if !saved.exists() => Ok(()),
        _ => Err(told(&recovered)),
    })
}

/// With room on the disk the run can be brought to its end.
fn goes_on(lab: &Lab, recording: &Path, reference: &Reference) -> Result<Result<(), String>, Failure> {
    let rest = if beside(recording, ".checkpoint").exists() { &["--resume"][..] } else { &["--restart"] };
    let output = lab.output(&lab.run_words(reference.plan, recording, rest))?;
    Ok(ensure(output.status.success(), || told(&output)).and_then(|()| is_whole(recording, reference)))
}

/// Commands that write something, each without the name of its output.
fn small_ones(lab: &Lab, reference: &Reference) -> Vec<Vec<OsString>> {
    let case = lab.case();
    let sweep = "ring.z.Force=kN(40),kN(44)";
    vec![
        words([&"run", &case, &"--duration", &"0.01", &"-o"]),
        words([&"solve", &case, &"-o"]),
        words([&"recover", &reference.recording, &"-o"]),
        words([&"report", &reference.recording, &"-o"]),
        words([&"sweep", &case, &"--set", &sweep, &"-o"]),
    ]
}

/// The words with the output after them; tables are known by their ending.
fn with_output(words: Vec<OsString>, folder: &Path) -> Vec<OsString> {
    let name = if words.first().is_some_and(|word| word == "sweep") { "out.csv" } else { "out.mcap" };
    words.into_iter().chain([folder.join(name).into()]).collect()
}

/// Failed with 1, said so, and wrote nothing under its own name.
fn nothing_is_left(output: &Output, folder: &Path, allowed: &[&str]) -> Result<(), String> {
    ensure(output.status.code() == Some(1) && !output.stderr.is_empty(), || told(output))?;
    let left: Vec<String> = names(folder).into_iter().filter(|name| !allowed.contains(&name.as_str())).collect();
    let whole = left.iter().any(|name| name == "out.mcap" || name == "out.csv");
    ensure(!whole, || format!("left behind: {}", left.join(", ")))
}

/// Commands by a user who may not write into the folder.
#[cfg(unix)]
pub fn read_only(lab: &mut Lab, references: &[Reference]) -> Result<Vec<Row>, Failure> {
    use std::os::unix::fs::{MetadataExt, PermissionsExt};
    use std::os::unix::process::CommandExt;
    let mut row = Row::new("read-only folder, ordinary user: told, folder as it was");
    let folder = lab.scratch()?;
    fs::write(folder.join("there"), "before").map_err(|source| lab.no_start(source))?;
    let may = |mode| fs::set_permissions(&folder, fs::Permissions::from_mode(mode));
    may(0o555).map_err(|source| lab.no_start(source))?;
    let root = fs::metadata("/proc/self").is_ok_and(|own| own.uid() == 0);
    for words in small_ones(lab, &references[0]) {
        let words = with_output(words, &folder);
        let mut command = lab.command(&words);
        if root {
            command.uid(NOBODY).gid(NOBODY);
        }
        let output = command.output().map_err(|source| lab.no_start(source))?;
        let untouched = names(&folder) == ["there"];
        row.count(
            nothing_is_left(&output, &folder, &["there"])
                .and_then(|()| ensure(untouched, || format!("left behind: {}", names(&folder).join(", "))))
                .and_then(|()| ensure(told(&output).contains("ermission denied"), || told(&output)))
                .map_err(|why| format!("{:?}: {why}", words[0])),
        );
    }
    may(0o755).map_err(|source| lab.no_start(source))?;
    Ok(vec![row])
}

#[cfg(not(unix))]
pub fn read_only(_: &mut Lab, _: &[Reference]) -> Result<Vec<Row>, Failure> {
    Ok(vec![Row::skipped("read-only folder, ordinary user: told, folder as it was", "no permissions of Unix here")])
}
