//! Evaluation of a signal of a file: which column, which part of it, at which speed.

use super::signal_file::{Column, SignalFile, damaged};
use crate::error::StudyError;
use serde::Serialize;
use std::f64::consts::TAU;
use std::path::Path;
use tribodyn_signal::{
    BandVelocity, Diagnosis, Kinematics, Search, Shaft, SignalError, Statistics, TESTER_BANDS_HZ, VibrationClass,
    band_velocities, diagnose, speed_by_pulses, vibration_class,
};

/// Where the speed of the shaft is known from.
#[derive(Debug, Clone, PartialEq)]
pub enum Speed {
    /// A speed, Hz, about which the true one lies.
    Near(f64),
    /// A column of the file: speeds in r/min, in Hz where its name ends in `_hz`, in rad/s where it ends in `_rad_s`.
    /// One number alone is a speed near the true one.
    Column(String),
    /// A column with pulses, and their number in a turn.
    KeyPhase(String, f64),
}

/// A part of a signal, s from its beginning.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Window {
    /// Its beginning.
    pub from_s: Option<f64>,
    /// Its end.
    pub to_s: Option<f64>,
}

/// A signal and what it says.
#[derive(Debug, Clone, Serialize)]
pub struct Analysis {
    /// Name of the column.
    pub channel: String,
    /// Sampling rate, Hz.
    pub rate_hz: f64,
    /// Beginning of the part that was evaluated, s.
    pub from_s: f64,
    /// Length of that part, s.
    pub duration_s: f64,
    /// Moments and extremes of that part, in the unit of the file.
    pub statistics: Statistics,
    /// Velocities in the bands of bearing testers: of a column of accelerations, whose name ends in `_m_s2`.
    pub velocity_bands: Vec<BandVelocity>,
    /// Quality class by them, of a deep groove bearing with a known bore that turns as on a tester.
    pub velocity_class: Option<VibrationClass>,
    /// The bearing.
    pub bearing: Kinematics,
    /// Its diagnosis from the signal.
    #[serde(flatten)]
    pub diagnosis: Diagnosis,
    /// Samples of that part.
    #[serde(skip)]
    pub samples: Vec<f64>,
    /// Speed of the shaft at each of them, rad/s, where it is known.
    #[serde(skip)]
    pub speeds_rad_s: Option<Vec<f64>>,
}

impl Analysis {
    /// True if the samples are accelerations in m/s².
    pub fn is_in_m_s2(&self) -> bool {
        is_in_m_s2(&self.channel)
    }
}

/// True if the name of a column says that it holds accelerations in m/s².
fn is_in_m_s2(column: &str) -> bool {
    column.ends_with("_m_s2")
}

/// Rates of columns of time have this relative unevenness at most.
const UNEVEN: f64 = 1e-2;
/// Fewest samples of a signal; a shorter column is a number beside it.
const SHORTEST: usize = 64;

/// Acceleration of blows over the speed of the shaft, m/s² over Hz, up to which they are those of balls that enter the
/// load zone of a sound bearing: half the acceleration of free fall at 3000 r/min. In runs of a sound 6206 without
/// clearance they have up to 2 m/s².
pub const QUIET: f64 = 0.1;

/// Evaluates a signal of a file. The bore, m, of a deep groove bearing gives its class, where it is known.
///
/// # Errors
/// A column that is missing, a rate or a part that is not possible, what [`diagnose`] refuses.
pub fn analysis(
    path: &Path,
    file: &SignalFile,
    (channel, rate_hz): (Option<&str>, Option<f64>),
    window: Window,
    speed: &Speed,
    (bearing, deep_groove_bore): (&Kinematics, Option<f64>),
    search: Search,
) -> Result<Analysis, StudyError> {
    let column = signal(path, file, channel, speed)?;
    let rate_hz = rate(path, file, rate_hz)?;
    let count = column.values.len();
    let place = |name: &'static str, at: Option<f64>, otherwise: usize| match at {
        None => Ok(otherwise),
        Some(s) if (0.0..=count as f64 / rate_hz).contains(&s) => Ok(((s * rate_hz).round() as usize).min(count)),
        Some(s) => {
            let message = format!("allowed is 0 to {} s, the length of the signal", count as f64 / rate_hz);
            Err(StudyError::argument(name, s, message))
        }
    };
    let (from, to) = (place("from", window.from_s, 0)?, place("to", window.to_s, count)?);
    if to <= from {
        return Err(StudyError::argument("to", to as f64 / rate_hz, "it must be after --from"));
    }
    let samples = &column.values[from..to];
    let speeds = speeds(path, file, speed, rate_hz, count)?;
    let (shaft, speeds) = match &speeds {
        Known::Near(hz) => (Shaft::Near(*hz), None),
        Known::At(all) => (Shaft::At(&all[from..to]), Some(all[from..to].to_vec())),
    };
    let refused = |error: SignalError| match (&error, file.first_line) {
        (SignalError::NotFinite { index, value }, line) => {
            let line = line.map_or(String::new(), |line| format!(", line {}", line + from + index));
            let why =
                format!("sample {}{line} of `{}` is {value}: allowed is a finite number", from + index, column.name);
            damaged(path, why)
        }
        _ => damaged(path, error.to_string()),
    };
    let in_m_s2 = is_in_m_s2(&column.name);
    // Of a machine's signal noise hides the soft blows of a sound bearing, and low blows may be of early damage.
    let is_recording = in_m_s2 && file.case_text.is_some();
    let search = Search { quiet: if is_recording { QUIET } else { search.quiet }, ..search };
    let diagnosis = diagnose(samples, rate_hz, shaft, bearing, search).map_err(refused)?;
    let velocity_bands = if in_m_s2 { band_velocities(samples, rate_hz, &TESTER_BANDS_HZ)? } else { Vec::new() };
    let class = |bore| vibration_class(bore, diagnosis.shaft.frequency_hz, &velocity_bands);
    Ok(Analysis {
        channel: column.name.clone(),
        rate_hz,
        from_s: from as f64 / rate_hz,
        duration_s: samples.len() as f64 / rate_hz,
        statistics: Statistics::of(samples)?,
        velocity_class: deep_groove_bore.and_then(class),
        velocity_bands,
        bearing: *bearing,
        diagnosis,
        samples: samples.to_vec(),
        speeds_rad_s: speeds,
    })
}

/// The column that is evaluated: the one asked for, or the only one that can be meant.
fn signal<'a>(
    path: &Path,
    file: &'a SignalFile,
    channel: Option<&str>,
    speed: &Speed,
) -> Result<&'a Column, StudyError> {
    if let Some(name) = channel {
        return named(path, file, name);
    }
    if file.case_text.is_some() {
        return file.columns.first().ok_or_else(|| damaged(path, "it holds no signal"));
    }
    let taken = match speed {
        Speed::Column(name) | Speed::KeyPhase(name, _) => file.column(name).map(|column| column.name.as_str()),
        Speed::Near(_) => None,
    };
    let possible = |column: &&Column| {
        column.values.len() >= SHORTEST && Some(column.name.as_str()) != taken && !is_time(&column.name)
    };
    let all: Vec<&Column> = file.columns.iter().filter(possible).collect();
    match all[..] {
        [only] => Ok(only),
        [] => Err(damaged(path, format!("it holds no signal of {SHORTEST} samples; it has {}", file.names()))),
        _ => Err(StudyError::argument(
            "channel",
            "",
            format!("{} has several signals: {}", path.display(), file.names()),
        )),
    }
}

fn named<'a>(path: &Path, file: &'a SignalFile, name: &str) -> Result<&'a Column, StudyError> {
    file.column(name).ok_or_else(|| damaged(path, format!("no column `{name}`; it has {}", file.names())))
}

fn is_time(name: &str) -> bool {
    matches!(name.to_lowercase().as_str(), "t" | "time" | "time_s" | "time (s)" | "time [s]" | "seconds")
}

/// The rate that is given, or that the file says, or that its column of time has.
fn rate(path: &Path, file: &SignalFile, given: Option<f64>) -> Result<f64, StudyError> {
    if let Some(rate) = given.or(file.rate_hz) {
        let message = "allowed is a sampling rate in Hz above 0";
        return (rate.is_finite() && rate > 0.0)
            .then_some(rate)
            .ok_or_else(|| StudyError::argument("rate", rate, message));
    }
    match rate_of_times(file) {
        Some(Some(rate)) => Ok(rate),
        Some(None) => Err(damaged(path, "its column of time is not even: give --rate, or resample it first")),
        None => {
            let message = format!("it is missing: {} does not say at which rate it was sampled", path.display());
            Err(StudyError::argument("rate", "", message))
        }
    }
}

/// The rate of a column of time, Hz; none where its times are not even.
fn rate_of_times(file: &SignalFile) -> Option<Option<f64>> {
    let column = file.columns.iter().find(|column| is_time(&column.name) && column.values.len() >= SHORTEST)?;
    let times = &column.values;
    let step = (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64;
    let uneven = |pair: &[f64]| (pair[1] - pair[0] - step).abs() > UNEVEN * step;
    Some((step > 0.0 && !times.windows(2).any(uneven)).then_some(1.0 / step))
}

/// Farthest relative difference of a rate from that of the file that is none.
const SAME_RATE: f64 = 1e-3;

/// A warning where a rate, Hz, is not that of the file.
pub(super) fn other_rate(file: &SignalFile, given_hz: f64) -> Option<String> {
    let own = file.rate_hz.or_else(|| rate_of_times(file).flatten())?;
    let said = (1e3 * own).round() / 1e3;
    ((given_hz / own - 1.0).abs() > SAME_RATE)
        .then(|| format!("the rate given, {given_hz} Hz, is used, but the file says {said} Hz"))
}

enum Known {
    Near(f64),
    At(Vec<f64>),
}

fn speeds(path: &Path, file: &SignalFile, speed: &Speed, rate_hz: f64, count: usize) -> Result<Known, StudyError> {
    let of_length = |column: &Column| {
        let why = format!("column `{}` has {} numbers for {count} samples", column.name, column.values.len());
        (column.values.len() == count).then_some(()).ok_or_else(|| damaged(path, why))
    };
    match speed {
        Speed::Near(hz) => Ok(Known::Near(*hz)),
        Speed::Column(name) => {
            let column = named(path, file, name)?;
            let to_rad_s = match name.as_str() {
                name if name.ends_with("_hz") => TAU,
                name if name.ends_with("_rad_s") => 1.0,
                _ => TAU / 60.0,
            };
            if let [one] = column.values[..] {
                return Ok(Known::Near(one * to_rad_s / TAU));
            }
            of_length(column)?;
            Ok(Known::At(column.values.iter().map(|value| value * to_rad_s).collect()))
        }
        Speed::KeyPhase(name, pulses) => {
            let column = named(path, file, name)?;
            of_length(column)?;
            speed_by_pulses(&column.values, rate_hz, *pulses)
                .map(Known::At)
                .map_err(|error| damaged(path, format!("column `{name}`: {error}")))
        }
    }
}
