//! Errors of writing and reading a recording.

use std::{io, path::PathBuf};

/// Why a recording was not written or not read.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// Case and solution are of different bearings.
    #[error("the solution has {solution} balls, the case {case}")]
    BallCount {
        /// Balls of the solution.
        solution: usize,
        /// Balls of the case.
        case: usize,
    },
    /// Interpolation over azimuth needs equispaced balls.
    #[error("ball {ball} stands at {found_deg}°, equal spacing from ball 0 puts it at {expected_deg}°")]
    UnevenAzimuth {
        /// Number of the ball.
        ball: usize,
        /// Azimuth at equal spacing, degrees.
        expected_deg: f64,
        /// Azimuth in the solution, degrees.
        found_deg: f64,
    },
    /// One orbit takes forever.
    #[error("a cage speed of {cage_speed_rpm} r/min gives no orbit to record (at least {least_rpm} r/min)")]
    NotOrbiting {
        /// Cage speed of the solution, r/min.
        cage_speed_rpm: f64,
        /// Lowest speed that is recorded, r/min.
        least_rpm: f64,
    },
    /// A recording holds finite numbers only.
    #[error("{field} of the solution is {value}, which cannot be recorded")]
    NotFinite {
        /// Field of the solution, with the ball's index where it has one.
        field: String,
        /// Its value, in the unit of the field.
        value: f64,
    },
    /// The bearing cannot be drawn.
    #[error("{field} = {value} of the case gives no bearing that can be drawn")]
    Geometry {
        /// Field of the case.
        field: &'static str,
        /// Its value, SI.
        value: f64,
    },
    /// A file operation failed; on a full disk this is where it shows.
    #[error("cannot {action} {}: {source}", path.display())]
    File {
        /// The action that failed.
        action: &'static str,
        /// Which file.
        path: PathBuf,
        /// Error of the operating system.
        source: io::Error,
    },
    /// There is no such recording, but one of that name that was not finished.
    #[error(
        "no recording {}, but {} of an unfinished run: name that one, or `recover` it",
        path.display(), active.display()
    )]
    OnlyBegun {
        /// The recording.
        path: PathBuf,
        /// Its beginning.
        active: PathBuf,
    },
    /// The MCAP layer failed, a full disk included.
    #[error("cannot {action} the MCAP file {}: {source}", path.display())]
    Mcap {
        /// The action that failed.
        action: &'static str,
        /// Which file.
        path: PathBuf,
        /// Error of the MCAP layer.
        source: mcap::McapError,
    },
    /// A run hands out samples in order of time.
    #[error("a sample at {time_s} s follows one at {last_s} s")]
    TimeGoesBack {
        /// Time of the sample, s.
        time_s: f64,
        /// Time of the one before, s.
        last_s: f64,
    },
    /// A live server cannot start.
    #[cfg(feature = "live")]
    #[error("cannot serve a live run at {address}: {source}")]
    Listen {
        /// The address as it was given: host and port.
        address: String,
        /// Error of the operating system.
        source: io::Error,
    },
    /// A sink was used before it was begun, or begun twice.
    #[error("a recording begins once, before its first message")]
    NotBegun,
    /// A message for a topic that the recording has not.
    #[error("there is no topic {channel}: the recording has {topics}")]
    NoTopic {
        /// Place of the topic.
        channel: usize,
        /// Topics of the recording.
        topics: usize,
    },
    /// The memory of a recorder, from a file, has values that no recorder has.
    #[error("the recorder's memory is damaged: {field} is {value}, allowed is {allowed}")]
    Memory {
        /// Which value.
        field: &'static str,
        /// The value, SI, or the number of entries of a list.
        value: f64,
        /// The allowed values.
        allowed: String,
    },
    /// A spectrum cannot be computed.
    #[error("no spectrum: {0}")]
    Signal(#[from] tribodyn_signal::SignalError),
    /// The file is no MCAP file.
    #[error("{} is not an MCAP file", path.display())]
    NotMcap {
        /// Which file.
        path: PathBuf,
    },
    /// The file begins as a recording, but no message of it can be read.
    #[error("nothing can be recovered from {}: no message is whole", path.display())]
    NothingToRecover {
        /// Which file.
        path: PathBuf,
    },
    /// A recording with more numbers than wanted.
    #[error("the numbers of {} take more than {most} bytes of memory", path.display())]
    TooLong {
        /// Which file.
        path: PathBuf,
        /// Bytes that are allowed.
        most: u64,
    },
    /// A message that is longer than any of ours.
    #[error("a message on {topic} has {bytes} bytes; allowed are {most}")]
    LongMessage {
        /// Which topic.
        topic: String,
        /// Its length.
        bytes: usize,
        /// Longest that is read.
        most: usize,
    },
    /// A number of a recording is infinite or none.
    #[error("{field} of a message on {topic} is {value}: all numbers of a recording must be finite")]
    NotANumber {
        /// Which topic.
        topic: String,
        /// Which field.
        field: String,
        /// Its value.
        value: f64,
    },
    /// Times of a recording that go back.
    #[error("times of {} go back: {time_s} s follows {last_s} s", path.display())]
    Disordered {
        /// Which file.
        path: PathBuf,
        /// The later message's time, s.
        time_s: f64,
        /// The time before it, s.
        last_s: f64,
    },
    /// A message of a recording is not what its topic says.
    #[error("a message on {topic} cannot be decoded: {source}")]
    Decode {
        /// Which topic.
        topic: String,
        /// Error of the decoder.
        source: prost::DecodeError,
    },
    /// The file was never closed, or is no recording with a summary.
    #[error("{} has no summary: it was not closed", path.display())]
    Unfinished {
        /// Which file.
        path: PathBuf,
    },
}
