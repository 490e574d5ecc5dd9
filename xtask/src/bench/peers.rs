//! Another program on the same bearing, run in turn with ours on the same machine.

use super::changed;
use super::row::{Limit, Row};
use super::speed::{FAST, PAPER_STEP, Prepared, RIG_RATE};
use crate::error::Failure;
use crate::python;
use serde::Deserialize;
use std::path::Path;
use std::process::Command;
use tribodyn_case::Case;
use tribodyn_paper::{PaperError, files};

const GROUP: &str = "peers";
/// Exudyn, a program for flexible multibody dynamics (J. Gerstmayr, doi:10.1007/s11044-023-09937-1), pinned.
const PACKAGES: [&str; 2] = ["exudyn==1.13.6", "numpy"];
/// Simulated, s: a revolution of the shaft at 14 000 r/min.
const REVOLUTION: f64 = 60.0 / 14_000.0;
/// Step of Exudyn, s. A fifth of it takes as long, twice it longer: Newton's iterations fail more often.
const STEP: f64 = 1e-5;
/// Sliding speed at which Exudyn's friction is full, m/s. Below 1 m/s its Newton iterations fail more often.
const FRICTION_ZONE: f64 = 1.0;
/// Samples of ours that are compared: Exudyn's sensors are read at the end only.
const FEW_SAMPLES: &str = "kHz(1)";
/// Loads of the comparison: axial and radial, N.
const LOADS: [(&str, f64, f64); 2] = [("the case's loads", 54_900.0, 23_000.0), ("a light load", 5_000.0, 0.0)];

/// The answer of `xtask/peers/exudyn_bearing.py`.
#[derive(Debug, Deserialize)]
struct Answer {
    version: String,
    processor_s: f64,
    cage_speed_rpm: f64,
}

/// A revolution with Exudyn and with ours, in turn; one row that says why where Python or the package is missing.
pub fn rows(text: &str, quick: bool) -> Result<Vec<Row>, Failure> {
    let python = match python::environment(&files::root().join("target/peers"), &PACKAGES) {
        Ok(python) => python,
        Err(reason) => return Ok(vec![Row::skipped(GROUP, "Exudyn, a revolution", reason)]),
    };
    let mut rows = Vec::new();
    for (name, axial, radial) in LOADS {
        let changes = [("ring.x", format!("Force(N({radial}))")), ("ring.z", format!("Force(N({axial}))"))];
        let with = |scheme: &str, samples: &str| -> Result<Prepared, Failure> {
            let scheme = ("transient.scheme", scheme.to_owned());
            let rates = ["recording.state_rate", "recording.ball_rate"].map(|path| (path, samples.to_owned()));
            let all: Vec<_> = changes.iter().cloned().chain([scheme]).chain(rates).collect();
            Prepared::new(text, &all, false)
        };
        let mut ours = [with(FAST, FEW_SAMPLES)?, with(FAST, RIG_RATE)?, with(PAPER_STEP, FEW_SAMPLES)?];
        let case = changed(text, &changes)?;
        let mut theirs: Option<Answer> = None;
        for _ in 0..if quick { 1 } else { 3 } {
            let answer = match exudyn(&python, &case, axial, radial)? {
                Ok(answer) => answer,
                Err(reason) => return Ok(vec![Row::skipped(GROUP, format!("Exudyn, {name}"), reason)]),
            };
            if theirs.as_ref().is_none_or(|least| answer.processor_s < least.processor_s) {
                theirs = Some(answer);
            }
            for run in &mut ours {
                run.repeat(REVOLUTION)?;
            }
        }
        rows.extend(theirs.iter().flat_map(|answer| compared(name, answer, ours.each_ref().map(Prepared::least))));
    }
    Ok(rows)
}

fn compared(name: &str, theirs: &Answer, [fast, sampled, paper]: [f64; 3]) -> [Row; 6] {
    let row = |what: &str, value, unit| Row::new(GROUP, format!("{name}: {what}"), value, unit);
    let note = format!(
        "{} at {} µs, {:.0} r/min: one point a contact, one coefficient of friction, cage on springs, no fluid, no wear",
        theirs.version,
        STEP * 1e6,
        theirs.cage_speed_rpm
    );
    [
        row("Exudyn, a revolution", theirs.processor_s * 1e3, "ms").note(note),
        row("ours, fast scheme 20 µs, full patches, samples at 1 kHz, a revolution", fast * 1e3, "ms"),
        row("Exudyn over fast scheme", theirs.processor_s / fast, "times").must_be(Limit::AtLeast(300.0)),
        row("ours, the same with samples at 25.6 kHz", sampled * 1e3, "ms"),
        row("ours, RK4 10 µs, full patches, samples at 1 kHz, a revolution", paper * 1e3, "ms"),
        row("Exudyn over RK4", theirs.processor_s / paper, "times"),
    ]
}

/// One run of Exudyn; the inner error is its own.
fn exudyn(python: &Path, case: &Case, axial: f64, radial: f64) -> Result<Result<Answer, String>, Failure> {
    let bearing = case.bearing().map_err(|source| PaperError::Bearing { run: "peers", source })?;
    let geometry = bearing.geometry;
    let values = [
        ("--balls", geometry.ball_count as f64),
        ("--ball-diameter", geometry.ball_diameter),
        ("--pitch-diameter", geometry.pitch_diameter),
        ("--inner-groove", geometry.inner_coefficient),
        ("--outer-groove", geometry.outer_coefficient),
        ("--contact-angle", geometry.contact_angle()),
        ("--stiffness", bearing.races.inner.frozen::<f64>().stiffness()),
        ("--friction-zone", FRICTION_ZONE),
        ("--speed", case.operating_point().inner_speed),
        ("--axial", axial),
        ("--radial", radial),
        ("--step", STEP),
        ("--duration", REVOLUTION),
    ];
    let mut command = Command::new(python);
    command.arg(files::root().join("xtask/peers/exudyn_bearing.py"));
    for (option, value) in values {
        command.arg(option).arg(value.to_string());
    }
    let printed = match python::quiet(&mut command) {
        Ok(printed) => printed,
        Err(reason) => return Ok(Err(reason)),
    };
    let last = printed.trim().lines().last().unwrap_or_default();
    Ok(Ok(serde_json::from_str(last)?))
}
