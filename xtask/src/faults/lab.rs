//! The command under test, a folder to work in, and recordings as lists of messages.

use super::random::Random;
use crate::error::Failure;
use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use tribodyn_paper::{PaperError, files};

/// Where all runs take their bearing from.
const CASE: &str = "fixtures/cases/paper-ag.ron";
/// A cheap patch rule and fewer samples: faults are about files, not about physics.
const CHANGES: [&str; 3] = [
    "traction.patch=SplitStrip(across: 5, along: 3)",
    "recording.state_rate=kHz(12.8)",
    "recording.ball_rate=kHz(2.56)",
];

/// A run that faults are tried on.
#[derive(Debug, Clone, Copy)]
pub struct Plan {
    pub name: &'static str,
    pub scheme: &'static str,
    pub duration_s: f64,
}

/// Runs of some seconds of wall time, one for each scheme.
pub const PLANS: [Plan; 3] = [
    Plan { name: "rk4", scheme: "RungeKutta4(step: us(10))", duration_s: 0.12 },
    Plan { name: "dp54", scheme: "DormandPrince(tolerance: 1e-5, longest: us(10))", duration_s: 0.08 },
    Plan { name: "fast", scheme: "Fast(step: us(5))", duration_s: 0.3 },
];

/// A run that is short enough to be damaged hundreds of times.
pub const SHORT: Plan = Plan { name: "short", scheme: "Fast(step: us(10))", duration_s: 0.03 };

/// A message of a recording: topic, sequence, times and bytes.
pub type Message = (String, u32, [u64; 2], Vec<u8>);

/// A run that nothing disturbed.
pub struct Reference {
    pub plan: Plan,
    pub recording: PathBuf,
    pub messages: Vec<Message>,
    /// Wall time of the run.
    pub wall: Duration,
}

/// The command, its folder, and the random numbers of a trial.
pub struct Lab {
    pub program: PathBuf,
    pub folder: PathBuf,
    pub random: Random,
    case: PathBuf,
    made: usize,
}

impl Lab {
    /// Copies the command into a new folder, which everybody may read.
    pub fn new(program: &Path, seed: u64) -> Result<Self, Failure> {
        let folder = std::env::temp_dir().join(format!("tribodyn-faults-{}", std::process::id()));
        fs::create_dir_all(&folder).map_err(|source| PaperError::Write { path: folder.clone(), source })?;
        let copy = folder.join("tribodyn");
        fs::copy(program, &copy).map_err(|source| PaperError::Read { path: program.to_owned(), source })?;
        let case = folder.join("case.ron");
        files::write(&case, files::read(&files::root().join(CASE))?.as_bytes())?;
        Ok(Self { program: copy, folder, random: Random::new(seed), case, made: 0 })
    }

    /// A folder of its own for one trial.
    pub fn scratch(&mut self) -> Result<PathBuf, Failure> {
        self.made += 1;
        let folder = self.folder.join(format!("trial-{}", self.made));
        fs::create_dir_all(&folder).map_err(|source| PaperError::Write { path: folder.clone(), source })?;
        Ok(folder)
    }

    pub fn case(&self) -> &Path {
        &self.case
    }

    /// The words of `run` for a plan, with others after them.
    pub fn run_words(&self, plan: Plan, recording: &Path, rest: &[&str]) -> Vec<OsString> {
        let mut words: Vec<OsString> = vec!["run".into(), self.case.clone().into(), "-o".into(), recording.into()];
        words.extend(["--duration".into(), plan.duration_s.to_string().into()]);
        let scheme = format!("transient.scheme={}", plan.scheme);
        for change in CHANGES.iter().copied().chain([scheme.as_str()]) {
            words.extend(["--set".into(), change.into()]);
        }
        words.extend(rest.iter().map(OsString::from));
        words
    }

    pub fn command(&self, words: &[OsString]) -> Command {
        let mut command = Command::new(&self.program);
        command.args(words).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    pub fn spawn(&self, words: &[OsString]) -> Result<Child, Failure> {
        self.command(words).spawn().map_err(|source| self.no_start(source))
    }

    pub fn output(&self, words: &[OsString]) -> Result<Output, Failure> {
        self.command(words).output().map_err(|source| self.no_start(source))
    }

    pub fn no_start(&self, source: std::io::Error) -> Failure {
        Failure::Start { program: self.program.display().to_string(), source }
    }

    /// A run without a fault.
    pub fn reference(&mut self, plan: Plan) -> Result<Reference, Failure> {
        let recording = self.folder.join(format!("{}.mcap", plan.name));
        let begun = Instant::now();
        let output = self.output(&self.run_words(plan, &recording, &[]))?;
        let wall = begun.elapsed();
        if !output.status.success() {
            let command = format!("tribodyn run ({}): {}", plan.name, text(&output.stderr));
            return Err(Failure::Command { command, status: output.status });
        }
        let messages = messages(&recording).map_err(|findings| Failure::Check {
            what: "the recording of an undisturbed run cannot be read",
            findings: vec![findings],
        })?;
        Ok(Reference { plan, recording, messages, wall })
    }
}

impl Drop for Lab {
    fn drop(&mut self) {
        // What stays is in the folder for temporary files.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// Words for [`Lab::output`].
pub fn words<const N: usize>(words: [&dyn AsRef<OsStr>; N]) -> Vec<OsString> {
    words.iter().map(|word| word.as_ref().to_owned()).collect()
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).trim().to_owned()
}

/// The code and the last line of a failed command.
pub fn told(output: &Output) -> String {
    format!("{}: {}", output.status, text(&output.stderr).lines().last().unwrap_or("nothing said"))
}

/// All messages of a whole recording, in the order of the file.
pub fn messages(recording: &Path) -> Result<Vec<Message>, String> {
    let said = |error: &dyn std::fmt::Display| format!("{}: {error}", recording.display());
    let bytes = fs::read(recording).map_err(|error| said(&error))?;
    let stream = mcap::MessageStream::new(&bytes).map_err(|error| said(&error))?;
    let one =
        |m: mcap::Message| (m.channel.topic.clone(), m.sequence, [m.log_time, m.publish_time], m.data.into_owned());
    stream.map(|message| message.map(one).map_err(|error| said(&error))).collect()
}

/// Checks that two lists of messages are the same; the second may go on where `begins` is set.
pub fn same(found: &[Message], expected: &[Message], begins: bool) -> Result<(), String> {
    if let Some(at) = found.iter().zip(expected).position(|(a, b)| a != b) {
        let (topic, number, [time, _], _) = &found[at];
        return Err(format!("message {at}, number {number} of {topic} at {time} ns, is another one"));
    }
    let enough = if begins { found.len() <= expected.len() } else { found.len() == expected.len() };
    if enough { Ok(()) } else { Err(format!("{} messages instead of {}", found.len(), expected.len())) }
}

/// Names in a folder, sorted.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// The path with something after its whole name.
pub fn beside(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(suffix);
    PathBuf::from(name)
}

/// Sends a signal by its name; false where the process is gone.
pub fn signal(child: &Child, name: &str) -> Result<bool, Failure> {
    let mut command = Command::new("kill");
    command.args([&format!("-{name}"), &child.id().to_string()]).stderr(Stdio::null());
    let status = command.status().map_err(|source| Failure::Start { program: "kill".to_owned(), source })?;
    Ok(status.success())
}
