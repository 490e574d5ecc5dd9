//! `tribodyn recover`: a whole recording from one that was cut off or damaged.

use crate::failure::Failure;
use crate::solve::check_output;
use crate::table::{number, print_json, print_pairs};
use serde::Serialize;
use std::path::PathBuf;

/// Make a whole recording of one that was cut off or damaged.
#[derive(clap::Args)]
pub struct Arguments {
    /// Recording, whole or not: RUN.mcap or RUN.mcap.active
    #[arg(value_name = "RUN.mcap")]
    recording: PathBuf,
    /// Recording to write; may be the damaged one itself
    #[arg(short, long, value_name = "OUT.mcap")]
    output: PathBuf,
    /// Print JSON, and nothing else, to standard output
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Answer {
    recording: PathBuf,
    output: PathBuf,
    messages: u64,
    messages_lost: u64,
    chunks_bad: u64,
    bytes_lost: u64,
    simulated_s: f64,
    truncated: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.output.exists() {
        // The case is no part of this: nothing but a plain file may be replaced.
        check_output(&arguments.output, &PathBuf::new(), "recording")?;
    }
    let done = tribodyn_record::recover(&arguments.recording, &arguments.output)?;
    let answer = Answer {
        recording: arguments.recording.clone(),
        output: arguments.output.clone(),
        messages: done.messages,
        messages_lost: done.messages_lost,
        chunks_bad: done.chunks_bad,
        bytes_lost: done.bytes_lost,
        simulated_s: done.last_time_s(),
        truncated: done.truncated,
    };
    if arguments.json {
        return print_json(&answer);
    }
    print_pairs(&[
        ("messages saved", answer.messages.to_string(), ""),
        ("messages of unknown topics", answer.messages_lost.to_string(), ""),
        ("damaged chunks", answer.chunks_bad.to_string(), ""),
        ("bytes lost", answer.bytes_lost.to_string(), ""),
        ("simulated time of the last message", number(answer.simulated_s, 6), "s"),
        ("cut off before its end", if answer.truncated { "yes" } else { "no" }.to_owned(), ""),
    ])
}
