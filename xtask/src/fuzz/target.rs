//! The readers that are tried.

use super::mutate::Form;

/// A reader of input from elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Target {
    /// The text of a case file, within the limits
    Case,
    /// A change of `--set`, PATH=VALUE
    Set,
    /// An identification problem
    Problem,
    /// A table of published figures
    Figures,
    /// The values of a sweep, and the grid that they make
    Grid,
    /// A recording, read by `report`
    Reader,
    /// A recording, recovered
    Recovery,
    /// A checkpoint, and a run that goes on from it
    Checkpoint,
    /// A message of a live viewer
    Live,
}

impl Target {
    pub const ALL: [Self; 9] = [
        Self::Case,
        Self::Set,
        Self::Problem,
        Self::Figures,
        Self::Grid,
        Self::Reader,
        Self::Recovery,
        Self::Checkpoint,
        Self::Live,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Self::Case => "case",
            Self::Set => "set",
            Self::Problem => "problem",
            Self::Figures => "figures",
            Self::Grid => "grid",
            Self::Reader => "reader",
            Self::Recovery => "recovery",
            Self::Checkpoint => "checkpoint",
            Self::Live => "live",
        }
    }

    pub fn form(self) -> Form {
        if matches!(self, Self::Reader | Self::Recovery) { Form::Binary } else { Form::Text }
    }

    /// Longest input, bytes: no system hands a program an argument that is longer than 128 KiB (MAX_ARG_STRLEN of Linux).
    pub fn longest(self) -> usize {
        if matches!(self, Self::Set | Self::Grid) { 128 << 10 } else { 2 << 20 }
    }
}
