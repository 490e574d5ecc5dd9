//! `tribodyn recover`: a whole recording from one that was cut off or damaged.

use crate::failure::Failure;
use crate::input::ReplaceArguments;
use crate::table::{number, print_json, print_pairs};
use std::path::PathBuf;
use tribodyn_study::recover;

/// Make a whole recording of one that was cut off or damaged.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn recover run.mcap.active -o run.mcap")]
pub struct Arguments {
    /// Recording, complete or not: RUN.mcap or RUN.mcap.active
    #[arg(value_name = "RUN.mcap")]
    recording: PathBuf,
    /// Recording to write; may be the damaged one
    #[arg(short, long, value_name = "OUT.mcap")]
    output: PathBuf,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let answer = recover(&arguments.recording, &arguments.output, arguments.replace.force)?;
    if arguments.json {
        return print_json(&answer);
    }
    let (damage, said) = (&answer.damage, |yes: bool| if yes { "yes" } else { "no" }.to_owned());
    print_pairs(&[
        ("messages saved", answer.messages.to_string(), ""),
        ("of these without a checksum", damage.messages_unchecked.to_string(), ""),
        ("messages of unknown topics", answer.messages_lost.to_string(), ""),
        ("damaged chunks", damage.chunks_bad.to_string(), ""),
        ("bytes lost", damage.bytes_lost.to_string(), ""),
        ("simulated time of the last message", number(answer.simulated_s, 6), "s"),
        ("cut off before its end", said(damage.truncated), ""),
        ("summary damaged", said(damage.summary_bad), ""),
        ("checksum of all data wrong", said(damage.checksum_bad), ""),
    ])
}
