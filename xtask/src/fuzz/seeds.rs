//! Inputs to begin with: the files of the project, recordings and a checkpoint of a short run, and what is kept in
//! `fixtures/fuzz`.

use super::target::Target;
use crate::error::Failure;
use std::fs;
use std::io::Cursor;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use tribodyn::{CaseFile, Limits};
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::Run;
use tribodyn_paper::{PaperError, files};
use tribodyn_record::{Preamble, RecordError, RunRecorder, RunRecording, Sink, StreamSink};
use tribodyn_study::run::{Beginning, PreparedRun};

/// The case whose recording and checkpoint are seeds, and in which values are changed: it can run. Neither comments nor
/// sources but one, and a cheap patch rule: what is not under trial takes no time.
pub static RUN_CASE: LazyLock<String> = LazyLock::new(|| {
    let brief = brief(include_str!("../../../fixtures/cases/paper-ag-worn.ron"));
    let cheap = set_value(&brief, "traction.patch", "SplitStrip(across: 5, along: 3)");
    cheap.unwrap_or(brief)
});

const SETTINGS: [&str; 6] = [
    "ring.z.Force=kN(30)",
    "geometry.ball_count=12",
    "coatings.inner=(curve: Library(\"ag\"), thickness: um(2))",
    "transient.scheme=DormandPrince(tolerance: 1e-7, longest: us(10))",
    "defects=[(ring: Inner, azimuth: deg(90), width: deg(1), depth: um(1), bare: 0)]",
    "ring.x.ForceTable[0][1]=kN(1)",
];
const SWEPT: [&str; 5] = [
    "ring.z.Force=kN(10..60 by 5)",
    "ring.z.Force=kN(10..60 in 3)",
    "ring.z.Force=kN(1..100 log 4)",
    "geometry.ball_count=10,11,12",
    "coatings.inner.curve=Library(\"ag\"),Library(\"ptfe\")",
];
const FIGURES: [&str; 2] = [
    "id,quantity,published,tolerance,source\nA,cage_speed_mean_rpm,5799,6,\"a paper, page 3\"\n",
    "# speeds\nid,quantity,published,tolerance,source\n\"A, \"\"B\"\"\",frequencies.ball_pass_outer_hz,1.5e3,0,one, two\n",
];
const REQUESTS: [&str; 4] = [
    r#"{"op":"subscribe","subscriptions":[{"id":1,"channelId":3},{"id":2,"channelId":0}]}"#,
    r#"{"op":"unsubscribe","subscriptionIds":[1,2]}"#,
    r#"{"op":"getParameters","parameterNames":["a"],"id":"x"}"#,
    r#"{"op":"advertise","channels":[{"id":1,"topic":"/a","encoding":"json","schemaName":"b"}]}"#,
];

/// A case without comments and with the first of its sources only.
fn brief(case: &str) -> String {
    let (head, sources) = case.split_once("    sources: {").unwrap_or((case, ""));
    let first = sources.lines().nth(1).map_or(String::new(), |line| format!("    sources: {{\n{line}\n    }},\n"));
    let end = if sources.is_empty() { "" } else { ")\n" };
    let lines = head.lines().filter(|line| !line.trim().is_empty() && !line.trim_start().starts_with("//"));
    lines.flat_map(|line| [line, "\n"]).collect::<String>() + &first + end
}

pub fn refused(error: tribodyn_case::CaseError) -> Failure {
    Failure::Seed(error.to_string())
}

pub fn failed(error: impl std::fmt::Display) -> Failure {
    Failure::Seed(error.to_string())
}

/// The inputs that a target begins with.
pub fn of(target: Target) -> Result<Vec<Vec<u8>>, Failure> {
    let texts = |all: &[&str]| all.iter().map(|text| text.as_bytes().to_vec()).collect::<Vec<_>>();
    let mut seeds = match target {
        Target::Case => {
            let mut all = folder(&files::root().join("fixtures/cases"), "ron")?;
            // One as it is; long comments and lists of sources are the same everywhere.
            all.iter_mut().skip(1).for_each(|case| *case = brief(&String::from_utf8_lossy(case)).into_bytes());
            all
        }
        Target::Problem => folder(&files::root().join("fixtures/identify"), "ron")?,
        Target::Set => texts(&SETTINGS),
        Target::Figures => texts(&FIGURES),
        Target::Grid => texts(&SWEPT),
        Target::Live => texts(&REQUESTS),
        Target::Reader | Target::Recovery => recordings()?,
        Target::Checkpoint => vec![checkpoint()?],
    };
    seeds.extend(kept(target)?);
    Ok(seeds)
}

/// The inputs of a target in `fixtures/fuzz`: the smallest inputs of each kind that once did harm, or could.
pub fn kept(target: Target) -> Result<Vec<Vec<u8>>, Failure> {
    let path = files::root().join("fixtures/fuzz").join(target.name());
    if path.exists() { folder(&path, "") } else { Ok(Vec::new()) }
}

/// The files of a folder, by name, all of them or those with an ending.
fn folder(path: &Path, extension: &str) -> Result<Vec<Vec<u8>>, Failure> {
    let read = |path: &Path| {
        let path = path.to_owned();
        move |source| PaperError::Read { path, source }
    };
    let entries = fs::read_dir(path).map_err(read(path))?;
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.retain(|path| extension.is_empty() || path.extension().is_some_and(|found| found == extension));
    paths.sort();
    Ok(paths.iter().map(|path| fs::read(path).map_err(read(path))).collect::<Result<_, _>>()?)
}

/// A short run as a recording with compressed chunks, and as one whose chunks are neither compressed nor have
/// checksums, so that changed bytes are read.
fn recordings() -> Result<Vec<Vec<u8>>, Failure> {
    let case = Case::from_ron(&RUN_CASE).map_err(refused)?;
    let inputs = &case.run_inputs().map_err(failed)?;
    let mut run = Run::new(inputs.clone()).map_err(failed)?;
    let sink = Thin::new();
    let input = RunRecording::new("(name: \"seed\")", &case.name, inputs, "tribodyn fuzz");
    let mut recorder = RunRecorder::new(sink, &input)?;
    let _ = run.advance(0.002, &mut recorder).map_err(failed)?;
    let (compressed, plain) = recorder.finish()?;
    Ok(vec![compressed, plain])
}

/// A sink that keeps a few short messages of each topic.
struct Thin {
    stream: StreamSink<Cursor<Vec<u8>>>,
    plain: Vec<u8>,
    chunk: Vec<u8>,
    counts: Vec<u32>,
}

/// Messages of a topic, and their longest, bytes.
const MESSAGES: u32 = 6;
const LONGEST_MESSAGE: usize = 3000;

impl Thin {
    fn new() -> Self {
        let stream = StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
        Self { stream, plain: Vec::new(), chunk: Vec::new(), counts: Vec::new() }
    }

    /// Closes the plain chunk.
    fn chunk(&mut self) {
        let size = self.chunk.len() as u64;
        // Times of the first and last message, size, no checksum, no compression, size.
        let head = [&[0; 16], &size.to_le_bytes()[..], &[0; 4], &[0; 4], &size.to_le_bytes()].concat();
        record(&mut self.plain, 0x06, &[&head, &std::mem::take(&mut self.chunk)]);
    }
}

/// A record of the format: opcode, length, content.
fn record(file: &mut Vec<u8>, opcode: u8, parts: &[&[u8]]) {
    file.push(opcode);
    file.extend_from_slice(&(parts.iter().map(|part| part.len()).sum::<usize>() as u64).to_le_bytes());
    parts.iter().for_each(|part| file.extend_from_slice(part));
}

/// A text with its length.
fn text(text: &str) -> Vec<u8> {
    [&(text.len() as u32).to_le_bytes(), text.as_bytes()].concat()
}

impl Sink for Thin {
    type Output = (Vec<u8>, Vec<u8>);

    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        self.plain.extend_from_slice(b"\x89MCAP0\r\n");
        record(&mut self.plain, 0x01, &[&text(""), &text(preamble.generator)]);
        self.counts = vec![0; preamble.channels.len()];
        for (id, channel) in (1_u16..).zip(preamble.channels) {
            // The descriptors are not looked at.
            let schema = [&id.to_le_bytes()[..], &text(channel.schema), &text("protobuf"), &[0; 4]].concat();
            record(&mut self.chunk, 0x03, &[&schema]);
            let id = id.to_le_bytes();
            record(&mut self.chunk, 0x04, &[&id, &id, &text(channel.topic), &text("protobuf"), &[0; 4]]);
        }
        self.chunk();
        self.stream.begin(&Preamble { layout: "{}", ..*preamble })
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        let count = &mut self.counts[channel];
        if *count >= MESSAGES || data.len() > LONGEST_MESSAGE {
            return Ok(());
        }
        *count += 1;
        let (id, times) = ((channel as u16 + 1).to_le_bytes(), log_time.to_le_bytes());
        record(&mut self.chunk, 0x05, &[&id, &count.to_le_bytes(), &times, &times, data]);
        if self.chunk.len() > 8000 {
            self.chunk();
            self.stream.flush()?;
        }
        self.stream.message(channel, log_time, data)
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.stream.flush()
    }

    fn finish(mut self) -> Result<Self::Output, RecordError> {
        self.chunk();
        record(&mut self.plain, 0x0f, &[&[0; 4]]);
        record(&mut self.plain, 0x02, &[&[0; 20]]);
        self.plain.extend_from_slice(b"\x89MCAP0\r\n");
        Ok((self.stream.finish()?.into_inner(), self.plain))
    }
}

/// The checkpoint of a run that was stopped after a millisecond.
fn checkpoint() -> Result<Vec<u8>, Failure> {
    let folder = std::env::temp_dir().join(format!("tribodyn-fuzz-{}", std::process::id()));
    let made = fs::create_dir_all(&folder).map_err(|source| PaperError::Write { path: folder.clone(), source });
    let seed = made.map_err(Failure::from).and_then(|()| {
        let file = CaseFile::from_text("case", RUN_CASE.clone(), &[], &Limits::NORMAL).map_err(failed)?;
        let recording = folder.join("run.mcap");
        let session = PreparedRun::new(&file, &recording, Beginning::New).and_then(|run| run.begin(None));
        session.and_then(|session| session.complete(|_| ControlFlow::Break(()))).map_err(failed)?;
        let path = folder.join("run.mcap.checkpoint");
        Ok(fs::read(&path).map_err(|source| PaperError::Read { path, source })?)
    });
    // The seed counts; a folder that stays behind is in the system's own place for such.
    let _ = fs::remove_dir_all(folder);
    seed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_a_brief_case_is_the_same_case() {
        let text = include_str!("../../../fixtures/cases/paper-ag-worn.ron");
        let [mut whole, mut brief] = [text, &brief(text)].map(|text| Case::from_ron(text).unwrap());
        assert_eq!((whole.sources.len() > 50, brief.sources.len()), (true, 1));
        (whole.sources, brief.sources) = Default::default();
        assert_eq!(format!("{whole:?}"), format!("{brief:?}"));
        assert!(RUN_CASE.contains("across: 5") && Case::from_ron(&RUN_CASE).is_ok());
    }
}
