//! The process that holds a lock.

use serde::{Deserialize, Serialize};
use std::fmt;

/// The process that writes an output.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Holder {
    /// Number of the process.
    pub pid: u32,
    /// Name of its machine; empty where the system does not tell.
    pub host: String,
    /// Date and time at which it began, UTC.
    pub since: String,
}

impl fmt::Display for Holder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let host = if self.host.is_empty() { String::new() } else { format!(" on {}", self.host) };
        write!(f, "pid {}{host} since {}", self.pid, self.since)
    }
}

/// Who writes an output, after the sentence that somebody does.
pub(crate) fn by(holder: &Option<Holder>) -> String {
    holder.as_ref().map_or_else(String::new, |holder| format!(", {holder}"))
}
