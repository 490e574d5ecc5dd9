//! Reading a run back: its case, its numbers in the recorded units, its log; from whole and from torn files.

use super::numbers::Numbers;
use crate::RecordError;
use crate::output::{file_error, open};
use crate::scan::{Damage, Piece, Record, Scanner};
use crate::wire::{foxglove, tribodyn};
use crate::write::{CASE_ATTACHMENT, LAYOUT_ATTACHMENT};
use prost::Message;
use std::collections::{BTreeMap, VecDeque};
use std::fs::File;
use std::io::{Read, Seek};
use std::path::{Path, PathBuf};

/// Rings, cage and powers at one time, in the units of the field names.
pub type StateRow = tribodyn::TransientState;
/// Ring, cage and sums over all balls of a quasi-static solution at one time of its orbit, in the units of the field
/// names.
pub type SolutionRow = tribodyn::BearingState;
/// A ball at one time, in the units of the field names, single precision.
pub type BallRow = tribodyn::Ball;
/// Wear up to one time, in the units of the field names.
pub type WearRow = tribodyn::Wear;
/// A spectrum as it was shown during the run.
pub type SpectrumRow = tribodyn::Spectrum;
/// The path of the inner ring over one turn.
pub type OrbitRow = tribodyn::Orbit;

/// A line of the log.
#[derive(Debug, Clone, PartialEq)]
pub struct LogRow {
    /// Simulated time of what it tells, s.
    pub time_s: f64,
    /// True if the reader of a report must know of it.
    pub warning: bool,
    /// Kind of event: `impact`, `contact-lost`, `contact-made`, `coating-through`, `warning`, or `start` for a warning
    /// of the state that the run starts from.
    pub kind: String,
    /// The text; of frequent kinds it tells how many more there were.
    pub message: String,
}

impl LogRow {
    /// True if it is a warning of the state that the run starts from.
    pub fn is_of_start(&self) -> bool {
        self.kind == crate::run::START
    }
}

/// Longest message with numbers, bytes: five thousand balls. A message of empty balls takes a hundred times its length
/// in memory.
const LONGEST_MESSAGE: usize = 1 << 20;

/// A part of a run, in the order of the file.
#[derive(Debug, Clone, PartialEq)]
#[allow(clippy::large_enum_variant)] // most items are states, the largest
pub enum RunItem {
    /// The text of the case file.
    Case(String),
    /// The Foxglove layout for this recording.
    Layout(String),
    /// A metadata record: its name, keys and values.
    Metadata(String, BTreeMap<String, String>),
    /// Rings, cage and powers.
    State(StateRow),
    /// Ring, cage and sums over all balls of a quasi-static solution.
    Solution(SolutionRow),
    /// All balls at a simulated time, s.
    Balls(f64, Vec<BallRow>),
    /// Wear up to a time.
    Wear(WearRow),
    /// A spectrum.
    Spectrum(SpectrumRow),
    /// A path of the inner ring.
    Orbit(OrbitRow),
    /// A line of the log.
    Log(LogRow),
}

/// Decodes messages of a type.
type Decoder = fn(&[u8]) -> Result<RunItem, prost::DecodeError>;

const STATE: &str = "tribodyn.v1.TransientState";
const SOLUTION: &str = "tribodyn.v1.BearingState";
const BALLS: &str = "tribodyn.v1.Balls";
const WEAR: &str = "tribodyn.v1.Wear";
impl RunItem {
    /// The item that an encoded message of a type is; none for messages for the eye only.
    ///
    /// # Errors
    /// Bytes that are no message of that type.
    pub fn decode(schema: &str, data: &[u8]) -> Result<Option<Self>, prost::DecodeError> {
        Self::decoder(schema).map(|decode| decode(data)).transpose()
    }

    /// The decoder of a type; none for messages for the eye only.
    fn decoder(schema: &str) -> Option<Decoder> {
        let decode: Decoder = match schema {
            STATE => |data| StateRow::decode(data).map(Self::State),
            SOLUTION => |data| SolutionRow::decode(data).map(Self::Solution),
            BALLS => |data| tribodyn::Balls::decode(data).map(|balls| Self::Balls(balls.time_s, balls.balls)),
            WEAR => |data| WearRow::decode(data).map(Self::Wear),
            "tribodyn.v1.Spectrum" => |data| SpectrumRow::decode(data).map(Self::Spectrum),
            "tribodyn.v1.Orbit" => |data| OrbitRow::decode(data).map(Self::Orbit),
            "foxglove.Log" => |data| foxglove::Log::decode(data).map(|line| Self::Log(log_row(line))),
            _ => return None,
        };
        Some(decode)
    }

    /// True of the messages that every sample has: [`crate::Sink`] takes their numbers besides their bytes.
    pub fn is_of_samples(schema: &str) -> bool {
        [STATE, BALLS].contains(&schema)
    }

    /// Simulated time of what comes in order of time, s, with a number for its kind.
    fn time(&self) -> Option<(usize, f64)> {
        match self {
            Self::State(row) => Some((0, row.time_s)),
            Self::Solution(row) => Some((1, row.time_s)),
            Self::Balls(time_s, _) => Some((2, *time_s)),
            Self::Wear(row) => Some((3, row.time_s)),
            _ => None,
        }
    }

    /// Memory that it takes, about.
    fn bytes(&self) -> usize {
        let own = match self {
            Self::State(_) => return size_of::<StateRow>(),
            Self::Solution(_) => return size_of::<SolutionRow>(),
            Self::Balls(_, balls) => balls.len() * size_of::<BallRow>(),
            Self::Case(text) | Self::Layout(text) => text.len(),
            Self::Metadata(_, entries) => entries.iter().map(|(key, value)| key.len() + value.len() + 64).sum(),
            Self::Wear(_) | Self::Log(_) => 512,
            Self::Spectrum(row) => 4 * (row.amplitude.len() + row.frequency_hz.len()),
            Self::Orbit(row) => 8 * row.x_um.len(),
        };
        own + 64
    }
}

/// Goes through a recorded run with the memory of one chunk (about 1 MiB). Of damaged chunks it gives what
/// [`crate::recover()`] saves; messages for the eye only (frames and scene) are left out.
#[derive(Debug)]
pub struct RunReader<R> {
    scanner: Scanner<R>,
    name: PathBuf,
    /// Topics and message types by channel.
    channels: BTreeMap<u16, (String, u16)>,
    schemas: BTreeMap<u16, String>,
    /// Which fields are numbers.
    numbers: Numbers,
    /// True if balls are wanted.
    balls: bool,
    /// Items of the piece that was read last.
    ready: VecDeque<Result<RunItem, RecordError>>,
    failed: bool,
}

impl RunReader<File> {
    /// Opens a recording, whole or not (`<path>.active`).
    ///
    /// # Errors
    /// [`RecordError::File`] if it cannot be opened, [`RecordError::NotMcap`] if it is no MCAP file.
    pub fn open(path: &Path) -> Result<Self, RecordError> {
        Self::new(open(path)?, path)
    }
}

impl<R: Read + Seek> RunReader<R> {
    /// Reads a recording from any stream; errors call it `name`.
    ///
    /// # Errors
    /// As [`RunReader::open`].
    pub fn new(stream: R, name: &Path) -> Result<Self, RecordError> {
        let error = |source| file_error("read", name, source);
        let scanner = Scanner::new(stream).map_err(error)?;
        let mut scanner = scanner.ok_or_else(|| RecordError::NotMcap { path: name.to_owned() })?;
        let summary = scanner.summary().map_err(error)?;
        let (channels, schemas) = (BTreeMap::new(), BTreeMap::new());
        let name = name.to_owned();
        let (numbers, ready) = (Numbers::new(), VecDeque::new());
        let mut reader = Self { scanner, name, channels, schemas, numbers, balls: true, ready, failed: false };
        if let Some(summary) = summary {
            reader.absorb(&summary);
            reader.ready.clear();
        }
        Ok(reader)
    }

    /// Leaves out the balls, most of what is to decode.
    #[must_use]
    pub fn without_balls(self) -> Self {
        Self { balls: false, ..self }
    }

    /// Damage found so far; final once all items are read.
    pub fn damage(&self) -> Damage {
        self.scanner.damage()
    }

    /// Takes in the records of a piece.
    fn absorb(&mut self, piece: &Piece) {
        for record in piece.records() {
            let item = match record {
                Record::Schema(schema) => {
                    self.schemas.insert(schema.id, schema.name.to_owned());
                    None
                }
                Record::Channel(channel) => {
                    self.channels.insert(channel.id, (channel.topic.to_owned(), channel.schema));
                    None
                }
                Record::Metadata { name, entries } => Some(Ok(RunItem::Metadata(name.to_owned(), entries))),
                Record::Attachment { name, data, .. } => {
                    let text = || String::from_utf8_lossy(data).into_owned();
                    match name {
                        CASE_ATTACHMENT => Some(Ok(RunItem::Case(text()))),
                        LAYOUT_ATTACHMENT => Some(Ok(RunItem::Layout(text()))),
                        _ => None,
                    }
                }
                Record::Message { channel, data, .. } => self.message(channel, data).transpose(),
            };
            self.ready.extend(item);
        }
    }

    /// The item that a message is, if it is one.
    fn message(&self, channel: u16, data: &[u8]) -> Result<Option<RunItem>, RecordError> {
        let Some((topic, schema)) = self.channels.get(&channel) else {
            return Ok(None);
        };
        let schema = self.schemas.get(schema).map_or("", String::as_str);
        let Some(decode) = RunItem::decoder(schema) else { return Ok(None) };
        if data.len() > LONGEST_MESSAGE {
            return Err(RecordError::LongMessage { topic: topic.clone(), bytes: data.len(), most: LONGEST_MESSAGE });
        }
        if matches!(schema, STATE | SOLUTION | BALLS | WEAR)
            && (self.balls || schema != BALLS)
            && let Some((field, value)) = self.numbers.not_finite(schema, data)
        {
            return Err(RecordError::NotANumber { topic: topic.clone(), field, value });
        }
        if schema == BALLS && !self.balls {
            return Ok(None);
        }
        decode(data).map(Some).map_err(|source| RecordError::Decode { topic: topic.clone(), source })
    }
}

pub(crate) fn log_row(line: foxglove::Log) -> LogRow {
    let since_epoch = line.timestamp.map_or(0.0, |t| {
        // Whole seconds first: as one f64 the nanoseconds of a date would be lost.
        (t.seconds - (crate::timeline::EPOCH_NS / 1_000_000_000) as i64) as f64 + f64::from(t.nanos) * 1e-9
    });
    LogRow {
        time_s: since_epoch,
        warning: i32::from(line.level()) >= i32::from(foxglove::log::Level::Warning),
        kind: line.name,
        message: line.message,
    }
}

impl<R: Read + Seek> Iterator for RunReader<R> {
    type Item = Result<RunItem, RecordError>;

    fn next(&mut self) -> Option<Self::Item> {
        while self.ready.is_empty() && !self.failed {
            match self.scanner.next_piece() {
                Ok(Some(piece)) => self.absorb(&piece),
                Ok(None) => return None,
                Err(source) => {
                    self.failed = true;
                    return Some(Err(file_error("read", &self.name, source)));
                }
            }
        }
        self.ready.pop_front()
    }
}

/// A whole run in memory: about 25 MB for each simulated second at 25.6 kHz and 5 kHz with 13 balls.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Run {
    /// The text of the case file; none if that part of the file is damaged.
    pub case_text: Option<String>,
    /// The Foxglove layout for this recording; none if that part of the file is damaged.
    pub layout_text: Option<String>,
    /// Metadata records: name, then keys and values. `simulation` describes the run.
    pub metadata: BTreeMap<String, BTreeMap<String, String>>,
    /// Rings, cage and powers, in order of time.
    pub states: Vec<StateRow>,
    /// Ring and cage of the quasi-static solution whose orbit the file holds instead of a run.
    pub solution: Option<SolutionRow>,
    /// Simulated time (s) and all balls, in order of time.
    pub balls: Vec<(f64, Vec<BallRow>)>,
    /// Wear, in order of time.
    pub wear: Vec<WearRow>,
    /// The log.
    pub events: Vec<LogRow>,
    /// Damage of the file; that of a run that was killed or is still going on is truncated.
    pub damage: Damage,
}

/// Reads a whole run.
///
/// # Errors
/// Those of [`read_recording`]; [`RecordError::NothingToRecover`] also for the recording of a solution.
pub fn read_run(path: &Path) -> Result<Run, RecordError> {
    let run = read_recording(path)?;
    if run.states.is_empty() {
        return Err(RecordError::NothingToRecover { path: path.to_owned() });
    }
    Ok(run)
}

/// Reads a whole recording, of a run or of a solution, whose orbit is then in [`Run::balls`].
///
/// # Errors
/// As [`RunReader::open`]; [`RecordError::Decode`] if a message is not what its topic says, [`RecordError::NotANumber`]
/// if a number of it is none, [`RecordError::Disordered`] if times go back, [`RecordError::NothingToRecover`] if no
/// state of either kind can be read.
pub fn read_recording(path: &Path) -> Result<Run, RecordError> {
    read_recording_within(path, u64::MAX)
}

/// [`read_recording`] for a file from elsewhere, whose content may be a thousand times as long as the file.
///
/// # Errors
/// As [`read_recording`]; [`RecordError::TooLong`] if the numbers take more than `most` bytes of memory.
pub fn read_recording_within(path: &Path, most: u64) -> Result<Run, RecordError> {
    let mut reader = RunReader::open(path)?;
    let (mut taken, mut last) = (0, [f64::NEG_INFINITY; 4]);
    let mut run = Run::default();
    for item in &mut reader {
        let item = item?;
        taken += item.bytes() as u64;
        if taken > most {
            return Err(RecordError::TooLong { path: path.to_owned(), most });
        }
        if let Some((kind, time_s)) = item.time() {
            let last_s = std::mem::replace(&mut last[kind], time_s);
            if time_s < last_s {
                return Err(RecordError::Disordered { path: path.to_owned(), time_s, last_s });
            }
        }
        match item {
            RunItem::Case(text) => run.case_text = Some(text),
            RunItem::Layout(text) => run.layout_text = Some(text),
            RunItem::Metadata(name, entries) => {
                run.metadata.insert(name, entries);
            }
            RunItem::State(row) => run.states.push(row),
            RunItem::Solution(row) => {
                run.solution.get_or_insert(row);
            }
            RunItem::Balls(time, rows) => run.balls.push((time, rows)),
            RunItem::Wear(row) => run.wear.push(row),
            RunItem::Log(row) => run.events.push(row),
            RunItem::Spectrum(_) | RunItem::Orbit(_) => {}
        }
    }
    run.damage = reader.damage();
    if run.states.is_empty() && run.solution.is_none() {
        return Err(RecordError::NothingToRecover { path: path.to_owned() });
    }
    Ok(run)
}
