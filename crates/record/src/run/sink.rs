//! Where the messages of a run go: a file, a stream in memory, a server, or several of them.

use crate::held::Held;
use crate::output::{Channel, Entries, Output, QUICK, active_path, file_error, mcap_error};
use crate::{BallRow, RecordError, RecordingSummary, StateRow, read_summary};
use std::fs::{self, File};
use std::io::{ErrorKind, Seek, Write};
use std::path::{Path, PathBuf};

/// Contents of a recording before its first message.
#[derive(Debug, Clone, Copy)]
pub struct Preamble<'a> {
    /// The topics; messages name theirs by its place here.
    pub channels: &'static [Channel],
    /// Program and version.
    pub generator: &'a str,
    /// The text of the case file.
    pub case_text: &'a str,
    /// The Foxglove layout that fits the run.
    pub layout: &'a str,
    /// Keys and values of the metadata record `simulation`.
    pub entries: &'a [(&'static str, String)],
}

/// Takes the messages of a run.
pub trait Sink {
    /// Result of [`Sink::finish`], once all is written.
    type Output;

    /// Takes topics, metadata and attachments; called once, before all messages.
    ///
    /// # Errors
    /// [`RecordError`] if they cannot be stored.
    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError>;

    /// Takes an encoded message of the channel at place `channel`, log time in ns since the Unix epoch, never falling.
    ///
    /// # Errors
    /// [`RecordError`] if it cannot be stored, for instance on a full disk.
    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError>;

    /// Takes the numbers of the state whose message comes next: nobody has to decode what was just encoded.
    fn state(&mut self, _row: &StateRow) {}

    /// Takes the numbers of the balls whose message comes next.
    fn balls(&mut self, _rows: &[BallRow]) {}

    /// Takes what is known only at the end of a run, as keys and values of the metadata record `outcome`; once, after
    /// all messages. Whoever has no use for it needs not take it.
    ///
    /// # Errors
    /// [`RecordError`] if it cannot be stored.
    fn outcome(&mut self, _entries: &[(&'static str, String)]) -> Result<(), RecordError> {
        Ok(())
    }

    /// Makes what was taken so far survive an end of the program.
    ///
    /// # Errors
    /// [`RecordError`] if it cannot be stored.
    fn flush(&mut self) -> Result<(), RecordError>;

    /// Ends the recording.
    ///
    /// # Errors
    /// [`RecordError`] if it cannot be stored in full.
    fn finish(self) -> Result<Self::Output, RecordError>;
}

/// An MCAP recording on any stream that can seek.
pub struct StreamSink<W: Write + Seek> {
    stream: Option<W>,
    output: Option<Output<W>>,
    /// The name of the stream in errors.
    name: PathBuf,
}

impl<W: Write + Seek> std::fmt::Debug for StreamSink<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("StreamSink").field("name", &self.name).finish_non_exhaustive()
    }
}

impl<W: Write + Seek> StreamSink<W> {
    /// Records to `stream`; errors call it `name`.
    pub fn new(stream: W, name: &Path) -> Self {
        Self { stream: Some(stream), output: None, name: name.to_owned() }
    }

    fn output(&mut self) -> Result<&mut Output<W>, RecordError> {
        self.output.as_mut().ok_or(RecordError::NotBegun)
    }
}

impl<W: Write + Seek> Sink for StreamSink<W> {
    type Output = W;

    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        let Some(stream) = self.stream.take() else {
            return Err(RecordError::NotBegun);
        };
        let error = |source| mcap_error("write", &self.name, source);
        let mut output = Output::new(stream, preamble.generator, QUICK, preamble.channels).map_err(error)?;
        let entries: Entries = preamble.entries.to_vec();
        output.describe(&entries, preamble.case_text, preamble.layout).map_err(error)?;
        self.output = Some(output);
        Ok(())
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        let output = self.output()?;
        let topics = output.topics();
        if channel >= topics {
            return Err(RecordError::NoTopic { channel, topics });
        }
        let written = output.write(channel, log_time, data);
        written.map_err(|source| mcap_error("write", &self.name, source))
    }

    fn outcome(&mut self, entries: &[(&'static str, String)]) -> Result<(), RecordError> {
        let written = self.output()?.metadata("outcome", entries);
        written.map_err(|source| mcap_error("write", &self.name, source))
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        let flushed = self.output()?.writer.flush();
        flushed.map_err(|source| mcap_error("write", &self.name, source))
    }

    fn finish(mut self) -> Result<W, RecordError> {
        let Some(mut output) = self.output.take() else {
            return Err(RecordError::NotBegun);
        };
        output.writer.finish().map_err(|source| mcap_error("write", &self.name, source))?;
        Ok(output.writer.into_inner())
    }
}

/// An MCAP file, `<path>.active` until it is whole.
#[derive(Debug)]
pub struct FileSink {
    stream: StreamSink<Held<File>>,
    path: PathBuf,
}

impl FileSink {
    /// Creates `<path>.active` exclusively. A file or link of that name is removed first, and nothing is written to
    /// where a link points: what an earlier run left behind should be recovered before its path is used again.
    ///
    /// # Errors
    /// [`RecordError::File`] if that is not possible.
    pub fn create(path: &Path) -> Result<Self, RecordError> {
        let active = active_path(path);
        match fs::remove_file(&active) {
            Err(source) if source.kind() != ErrorKind::NotFound => return Err(file_error("replace", &active, source)),
            _ => {}
        }
        let file = File::create_new(&active).map_err(|source| file_error("create", &active, source))?;
        let held = Held::new(file).map_err(|source| file_error("create", &active, source))?;
        Ok(Self { stream: StreamSink::new(held, &active), path: path.to_owned() })
    }

    /// The name of the file until it is whole.
    pub fn active(&self) -> PathBuf {
        active_path(&self.path)
    }
}

impl Sink for FileSink {
    type Output = RecordingSummary;

    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        self.stream.begin(preamble)
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.stream.message(channel, log_time, data)
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.stream.flush()
    }

    fn outcome(&mut self, entries: &[(&'static str, String)]) -> Result<(), RecordError> {
        self.stream.outcome(entries)
    }

    /// Closes the file and gives it its name. After an error `<path>.active` stays, with what could be written.
    fn finish(self) -> Result<RecordingSummary, RecordError> {
        let active = self.active();
        let held = self.stream.finish()?;
        let file = held.into_inner().map_err(|source| file_error("flush", &active, source))?;
        file.sync_all().map_err(|source| file_error("close", &active, source))?;
        fs::rename(&active, &self.path).map_err(|source| file_error("move into place", &active, source))?;
        read_summary(&self.path)
    }
}

/// Both sinks get everything, the first one first.
impl<A: Sink, B: Sink> Sink for (A, B) {
    type Output = (A::Output, B::Output);

    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        self.0.begin(preamble)?;
        self.1.begin(preamble)
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.0.message(channel, log_time, data)?;
        self.1.message(channel, log_time, data)
    }

    fn state(&mut self, row: &StateRow) {
        self.0.state(row);
        self.1.state(row);
    }

    fn balls(&mut self, rows: &[BallRow]) {
        self.0.balls(rows);
        self.1.balls(rows);
    }

    fn outcome(&mut self, entries: &[(&'static str, String)]) -> Result<(), RecordError> {
        self.0.outcome(entries)?;
        self.1.outcome(entries)
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.0.flush()?;
        self.1.flush()
    }

    fn finish(self) -> Result<Self::Output, RecordError> {
        Ok((self.0.finish()?, self.1.finish()?))
    }
}

/// A sink that may be absent, such as a server that was not asked for.
impl<S: Sink> Sink for Option<S> {
    type Output = Option<S::Output>;

    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        self.as_mut().map_or(Ok(()), |sink| sink.begin(preamble))
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.as_mut().map_or(Ok(()), |sink| sink.message(channel, log_time, data))
    }

    fn state(&mut self, row: &StateRow) {
        self.iter_mut().for_each(|sink| sink.state(row));
    }

    fn balls(&mut self, rows: &[BallRow]) {
        self.iter_mut().for_each(|sink| sink.balls(rows));
    }

    fn outcome(&mut self, entries: &[(&'static str, String)]) -> Result<(), RecordError> {
        self.as_mut().map_or(Ok(()), |sink| sink.outcome(entries))
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.as_mut().map_or(Ok(()), Sink::flush)
    }

    fn finish(self) -> Result<Self::Output, RecordError> {
        self.map(Sink::finish).transpose()
    }
}
