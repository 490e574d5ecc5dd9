//! `--live`: viewers that watch a run as it goes.

use crate::failure::Failure;
use std::io::Write;
use tribodyn_record::{LIVE_ADDRESS, LiveName, LiveServer, Preamble, RecordError, Sink};
use tribodyn_study::run::Viewers;

/// Where to listen unless an address is given.
pub const ADDRESS: &str = LIVE_ADDRESS;

/// Starts the server, and says on standard error where it listens.
pub fn start(address: &str, allowed: &[LiveName]) -> Result<Box<dyn Viewers>, Failure> {
    let (mut server, warning) = LiveServer::start(address)?;
    server.allow(allowed);
    // If nobody reads the address, nothing is lost.
    let _ = writeln!(std::io::stderr(), "live at ws://{}", server.address());
    if let Some(warning) = warning {
        let _ = writeln!(std::io::stderr(), "warning: {warning}");
    }
    Ok(Box::new(Watched(server)))
}

/// Viewers of a run behind a server.
struct Watched(LiveServer);

impl Viewers for Watched {
    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        Sink::begin(&mut self.0, preamble)
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        Sink::message(&mut self.0, channel, log_time, data)
    }

    fn finish(self: Box<Self>) -> Result<(), RecordError> {
        Sink::finish(self.0).map(|_| ())
    }
}
