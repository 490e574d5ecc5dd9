//! Diagnosis of the bearing of the form from a measured signal.

use crate::question::{Form, Signal};
use serde_json::{Value, json};
use std::f64::consts::TAU;
use tribodyn::AnswerError;
use tribodyn_signal::{Diagnosis, Kinematics, Search, Shaft, diagnose};

/// Highest frequency of the spectrum that is handed over, over the highest of the lines that are looked for.
const SHOWN: f64 = 4.5;

/// The diagnosis and the spectrum of the envelope; the inner ring turns with the shaft.
pub(crate) fn vibration(form: &Form, signal: &Signal) -> Result<Value, AnswerError> {
    let file = form.case()?;
    let geometry = file.bearing()?.geometry;
    let bearing = Kinematics {
        ball_count: geometry.ball_count,
        ball_diameter_m: geometry.ball_diameter,
        pitch_diameter_m: geometry.pitch_diameter,
        contact_angle_rad: geometry.contact_angle(),
        inner_turns: 1.0,
        outer_turns: 0.0,
    };
    let shaft = Shaft::Near(file.case.operating_point().inner_speed.abs() / TAU);
    Ok(match diagnose(&signal.samples, signal.rate, shaft, &bearing, Search::default()) {
        Ok(found) => answer(&found),
        Err(error) => json!({ "error": error.to_string() }),
    })
}

fn answer(found: &Diagnosis) -> Value {
    let highest = found.evidence.iter().fold(0.0, |most: f64, line| most.max(line.expected_hz));
    let lines = found.envelope.frequency_hz.iter().take_while(|hz| **hz <= SHOWN * highest).count();
    json!({
        "diagnosis": found,
        "envelope_hz": found.envelope.frequency_hz[..lines],
        "envelope": found.envelope.amplitude[..lines],
    })
}
