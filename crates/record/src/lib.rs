#![doc = include_str!("../README.md")]

mod ball;
mod check;
mod colour;
mod contacts;
mod error;
mod frames;
mod guide;
mod layout;
#[cfg(feature = "live")]
mod live;
mod mesh;
mod messages;
mod output;
mod quaternion;
mod raceway;
mod read;
mod recover;
mod replay;
mod run;
mod scan;
mod scene;
#[cfg(test)]
mod tests;
mod timeline;
mod units;
pub mod wire;
mod write;

pub use ball::read_ball;
pub use error::RecordError;
pub use layout::{Layout, LayoutKind};
#[cfg(feature = "live")]
pub use live::{LIVE_ADDRESS, LiveName, LiveServer, LiveSummary, LiveWarning};
pub use messages::read_state;
pub use output::Channel;
pub use read::{AttachmentSummary, RecordingSummary, TopicSummary, read_summary};
pub use recover::{RECOVERY_METADATA, Recovered, recover, recover_stream};
pub use replay::{
    BallRow, LogRow, OrbitRow, Run, RunItem, RunReader, SolutionRow, SpectrumRow, StateRow, WearRow, read_recording,
    read_run,
};
pub use run::{FileSink, Preamble, RecorderMemory, RunRecorder, RunRecording, Sink, StreamSink};
pub use write::{CASE_ATTACHMENT, LAYOUT_ATTACHMENT, SolutionRecording, write_solution};
