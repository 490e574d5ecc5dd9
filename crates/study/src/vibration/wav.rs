//! Signals as WAV: channels over the full scale.

use super::signal_file::{Column, SignalFile, damaged};
use crate::error::StudyError;
use std::path::Path;

/// Reads whole numbers as parts of the full scale, −1 to 1, and floating-point numbers as they are.
pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<SignalFile, StudyError> {
    let refused = |error: hound::Error| damaged(path, error.to_string());
    let mut reader = hound::WavReader::new(bytes).map_err(refused)?;
    let spec = reader.spec();
    let samples: Vec<f64> = match spec.sample_format {
        hound::SampleFormat::Float => reader.samples::<f32>().map(|s| s.map(f64::from)).collect::<Result<_, _>>(),
        hound::SampleFormat::Int => {
            let full = 2f64.powi(i32::from(spec.bits_per_sample) - 1);
            reader.samples::<i32>().map(|s| s.map(|s| f64::from(s) / full)).collect::<Result<_, _>>()
        }
    }
    .map_err(refused)?;
    let channels = usize::from(spec.channels.max(1));
    let column = |channel: usize| Column {
        name: (channel + 1).to_string(),
        values: samples.iter().skip(channel).step_by(channels).copied().collect(),
    };
    Ok(SignalFile::of((0..channels).map(column).collect(), Some(f64::from(spec.sample_rate))))
}
