//! Signals read from files by the ending of their names.

use super::signal_file::{SignalFile, damaged};
use super::{csv, mat, recording, wav};
use crate::error::StudyError;
use crate::files::read_at_most;
use std::path::Path;
use tribodyn::Limits;

impl SignalFile {
    /// Reads a file by the ending of its name: `.csv`, `.txt`, `.tsv`, `.dat`, `.wav`, `.mat`, `.parquet`, and `.mcap`
    /// for the recording of a run.
    ///
    /// # Errors
    /// A file that cannot be read or is longer than the limit, of another kind, damaged, or with something in it that
    /// is no number.
    pub fn read(path: &Path, limits: &Limits) -> Result<Self, StudyError> {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_lowercase();
        if ending == "mcap" || ending == "active" {
            return recording::read(path, limits);
        }
        let bytes = || {
            read_at_most(path, limits.recording_bytes)
                .map_err(|source| StudyError::Read { path: path.to_owned(), source })
        };
        match ending.as_str() {
            "csv" | "txt" | "tsv" | "dat" => csv::read(path, &bytes()?),
            "wav" => wav::read(path, &bytes()?),
            "mat" => mat::read(path, &bytes()?, limits),
            #[cfg(feature = "parquet")]
            "parquet" => super::parquet::read(path),
            _ => Err(damaged(path, format!("allowed is a name that ends in {ENDINGS}"))),
        }
    }
}

#[cfg(feature = "parquet")]
const ENDINGS: &str = ".csv, .txt, .tsv, .dat, .wav, .mat, .parquet or .mcap";
#[cfg(not(feature = "parquet"))]
const ENDINGS: &str = ".csv, .txt, .tsv, .dat, .wav, .mat or .mcap";
