//! A question about a measured signal in the words of its asker: which bearing, at which speed.

use super::bearing::{deep_groove_bore, numbers};
use super::question::other_rate;
use super::{Analysis, SignalFile, Speed, Window, analysis, bearing_of_case, bearing_of_numbers};
use crate::case_file::read_case;
use crate::error::StudyError;
use std::path::{Path, PathBuf};
use tribodyn::{AnswerError, CaseFile, Limits};
use tribodyn_catalogue::KnownBalls;
use tribodyn_signal::{Kinematics, Search};

/// A signal and the questions about it.
#[derive(Debug, Clone)]
pub struct SignalQuestion {
    /// File with the signal.
    pub file: PathBuf,
    /// Column to evaluate, by its name or number.
    pub channel: Option<String>,
    /// Sampling rate, Hz, where the file does not say it.
    pub rate_hz: Option<f64>,
    /// A case file, a designation, or numbers as [`bearing_of_numbers`] takes them; a recording says its own.
    pub bearing: Option<String>,
    /// Nominal contact angle of an angular-contact designation, degrees.
    pub angle_deg: Option<f64>,
    /// Speed of the shaft in r/min, or the column that holds it.
    pub speed: Option<String>,
    /// Column with the pulses of a key phase, and their number in a turn.
    pub key_phase: Option<(String, f64)>,
    /// The part to evaluate.
    pub window: Window,
    /// How far the true speed may lie from the one given, %.
    pub speed_tolerance_percent: f64,
    /// How far slip and contact angle may move the cage from pure rolling, %.
    pub slip_percent: f64,
}

/// Column of a recording with the speed of the shaft.
const SPEEDS: &str = "inner_speed_rpm";
/// Relative difference of diameters up to which they are those of one bearing: listed ones are rounded.
const SAME: f64 = 1e-3;

/// Diagnosis of a bearing from its signal.
///
/// # Errors
/// A file that cannot be read, a bearing or a speed that is missing, and as [`analysis`].
pub fn diagnosed(question: &SignalQuestion, limits: &Limits) -> Result<Analysis, StudyError> {
    let q = question;
    let speed_share = share("speed-tolerance", q.speed_tolerance_percent)?;
    let search = Search { speed: speed_share, slip: share("slip", q.slip_percent)?, ..Search::default() };
    let file = SignalFile::read(&q.file, limits)?;
    let Asked { bearing, shaft_hz, deep_groove_bore } = bearing(q, &file, limits)?;
    let speed = speed(q, &file, shaft_hz)?;
    let (from, of) = ((q.channel.as_deref(), q.rate_hz), (&bearing, deep_groove_bore));
    let mut answer = analysis(&q.file, &file, from, q.window, &speed, of, search)?;
    let of_recording = file.warnings.iter().map(|warning| format!("in the recorded run: {warning}"));
    answer.diagnosis.warnings.extend(of_recording);
    answer.diagnosis.warnings.extend(q.rate_hz.and_then(|rate| other_rate(&file, rate)));
    answer.diagnosis.warnings.extend(other_recording(q, &file, (&bearing, &speed), limits));
    Ok(answer)
}

/// Warnings where the bearing or the speed that is asked for is not that of the recording.
fn other_recording(
    q: &SignalQuestion,
    file: &SignalFile,
    (bearing, speed): (&Kinematics, &Speed),
    limits: &Limits,
) -> Vec<String> {
    let Some(text) = &file.case_text else { return Vec::new() };
    let mut all = Vec::new();
    let own = || bearing_of_case(&CaseFile::from_text("", text.clone(), &[], limits).ok()?).ok();
    let near = |a: f64, b: f64| (a - b).abs() <= SAME * a.abs().max(b.abs());
    if let Some((own, _)) = q.bearing.as_ref().and_then(|_| own())
        && !(own.ball_count == bearing.ball_count
            && near(own.ball_diameter_m, bearing.ball_diameter_m)
            && near(own.pitch_diameter_m, bearing.pitch_diameter_m))
    {
        let named = |b: &Kinematics| {
            let [ball, pitch] = [b.ball_diameter_m, b.pitch_diameter_m].map(|metres| (1e6 * metres).round() / 1e3);
            format!("{} balls of {ball} mm on {pitch} mm", b.ball_count)
        };
        let (given, own) = (named(bearing), named(&own));
        all.push(format!("the bearing given, {given}, is used, but the recording is of {own}"));
    }
    let speeds = file.column(SPEEDS).map(|column| &column.values[..]).unwrap_or_default();
    let own_hz = speeds.iter().sum::<f64>().abs() / speeds.len() as f64 / 60.0;
    if let Speed::Near(hz) = speed
        && own_hz > 0.0
        && (hz / own_hz - 1.0).abs() > 0.01 * q.speed_tolerance_percent
    {
        let [given, own] = [hz, &own_hz].map(|hz| (600.0 * hz).round() / 10.0);
        all.push(format!("the speed given, {given} r/min, is used, but the recording has {own} r/min"));
    }
    all
}

/// Per cent as a share, from 0 to 20 %.
fn share(name: &'static str, percent: f64) -> Result<f64, StudyError> {
    if (0.0..=20.0).contains(&percent) {
        return Ok(0.01 * percent);
    }
    Err(StudyError::argument(name, percent, "allowed is 0 to 20 %"))
}

/// The bearing of a question.
struct Asked {
    bearing: Kinematics,
    /// Speed of the shaft that its case has, Hz.
    shaft_hz: Option<f64>,
    /// Bore of a deep groove bearing, m, where it is known.
    deep_groove_bore: Option<f64>,
}

impl Asked {
    fn of_case(file: &CaseFile) -> Result<Self, StudyError> {
        let (bearing, shaft_hz) = bearing_of_case(file)?;
        Ok(Self { bearing, shaft_hz, deep_groove_bore: deep_groove_bore(file) })
    }
}

/// The bearing that is asked for, or that of a recording.
fn bearing(q: &SignalQuestion, file: &SignalFile, limits: &Limits) -> Result<Asked, StudyError> {
    let Some(name) = &q.bearing else {
        let Some(text) = &file.case_text else {
            let message =
                "it is missing: the file says no bearing; give a case file, a designation or balls,ball mm,pitch mm";
            return Err(StudyError::argument("bearing", "", message));
        };
        return Asked::of_case(&CaseFile::from_text(&q.file.display().to_string(), text.clone(), &[], limits)?);
    };
    if let Some(bearing) = bearing_of_numbers(name) {
        bearing.per_turn().map_err(|error| StudyError::argument("bearing", name, error.to_string()))?;
        return Ok(Asked { bearing, shaft_hz: None, deep_groove_bore: None });
    }
    if numbers(name).is_some_and(|numbers| numbers.len() > 1) {
        let allowed = "numbers are those of balls, ball diameter in mm, pitch diameter in mm and, where it is not 0, \
                       contact angle in degrees, such as 9,7.94,39.04";
        return Err(StudyError::argument("bearing", name, allowed));
    }
    let path = Path::new(name);
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("ron")) || path.is_file() {
        return Asked::of_case(&read_case(path, &[], limits)?);
    }
    let listed = tribodyn_catalogue::find(name, q.angle_deg).map_err(AnswerError::from)?;
    let known = KnownBalls { published: listed.balls, ..KnownBalls::default() };
    let balls = listed.envelope.ball_set(known, listed.ratings).map_err(AnswerError::from)?;
    let bearing = Kinematics {
        ball_count: balls.ball_count,
        ball_diameter_m: balls.ball_diameter,
        pitch_diameter_m: balls.pitch_diameter,
        contact_angle_rad: listed.envelope.contact_angle,
        inner_turns: 1.0,
        outer_turns: 0.0,
    };
    let is_deep_groove = listed.envelope.contact_angle == 0.0;
    Ok(Asked { bearing, shaft_hz: None, deep_groove_bore: is_deep_groove.then_some(listed.envelope.bore) })
}

/// The speed that is asked for, or that of a recording, or that of the case.
fn speed(q: &SignalQuestion, file: &SignalFile, case_hz: Option<f64>) -> Result<Speed, StudyError> {
    if let Some((column, pulses)) = &q.key_phase {
        return Ok(Speed::KeyPhase(column.clone(), *pulses));
    }
    if let Some(given) = &q.speed {
        let refused = || {
            let allowed = "allowed is a speed in r/min above 0 or below it, or the name of a column";
            StudyError::argument("speed", given, allowed)
        };
        if file.columns.iter().any(|column| column.name == *given) && given.parse::<f64>().is_err() {
            return Ok(Speed::Column(given.clone()));
        }
        let rpm: f64 = given.parse().map_err(|_| refused())?;
        return if rpm.is_finite() && rpm != 0.0 { Ok(Speed::Near(rpm.abs() / 60.0)) } else { Err(refused()) };
    }
    if file.case_text.is_some() {
        return Ok(Speed::Column(SPEEDS.to_owned()));
    }
    let missing = "it is missing: lines are looked for by the speed of the shaft; give r/min or a column";
    case_hz.map(Speed::Near).ok_or_else(|| StudyError::argument("speed", "", missing))
}
