#![doc = include_str!("../README.md")]

mod error;
mod file;
mod layout;
#[cfg(feature = "live")]
mod live;
mod messages;
mod run;
mod scene;
mod solution;
#[cfg(test)]
mod tests;

pub use messages::wire;
// Within the crate a module goes by its own name, whatever folder it lies in.
use file::{held, output, scan};
use messages::{ball, units};
use scene::{colour, contacts, frames, guide, mesh, quaternion, raceway, trail};
use solution::{timeline, write};

pub use ball::read_ball;
pub use error::RecordError;
pub use file::messages::read_messages;
pub use file::output::Channel;
pub use file::read::{AttachmentSummary, RecordingSummary, TopicSummary, read_summary};
pub use file::recover::{RECOVERY_METADATA, Recovered, recover, recover_stream};
pub use file::replay::{
    BallRow, LogRow, OrbitRow, Run, RunItem, RunReader, SolutionRow, SpectrumRow, StateRow, WearRow, read_recording,
    read_recording_within, read_run,
};
pub use file::scan::Damage;
pub use file::temporary::TemporaryFile;
pub use layout::{Layout, LayoutKind};
#[cfg(feature = "live")]
#[doc(hidden)]
pub use live::is_live_request;
#[cfg(feature = "live")]
pub use live::{LIVE_ADDRESS, LiveName, LiveServer, LiveSummary, LiveWarning};
pub use run::{FileSink, Overview, Preamble, RecorderMemory, RunRecorder, RunRecording, RunRows, Sink, StreamSink};
pub use solution::messages::read_state;
pub use solution::write::{CASE_ATTACHMENT, LAYOUT_ATTACHMENT, SolutionRecording, write_solution};
