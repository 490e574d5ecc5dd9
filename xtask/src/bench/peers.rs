//! Another program on the same bearing, run in turn with ours on the same machine.

use super::catalogue::{USUAL, written};
use super::changed;
use super::refused;
use super::row::{Limit, Row};
use super::speed::{FAST, PAPER_STEP, Prepared, RIG_RATE};
use crate::error::Failure;
use crate::python;
use serde::Deserialize;
use std::f64::consts::TAU;
use std::path::Path;
use std::process::Command;
use tribodyn_case::Case;
use tribodyn_paper::files;

const GROUP: &str = "peers";
/// Exudyn, a program for flexible multibody dynamics (J. Gerstmayr, doi:10.1007/s11044-023-09937-1), pinned.
const PACKAGES: [&str; 2] = ["exudyn==1.13.6", "numpy"];
/// Step of Exudyn, s. A fifth of it takes as long, twice it longer: Newton's iterations fail more often.
const STEP: f64 = 1e-5;
/// Sliding speed at which Exudyn's friction is full, m/s. Below 1 m/s its Newton iterations fail more often.
const FRICTION_ZONE: f64 = 1.0;
/// Samples of ours that are compared: Exudyn's sensors are read at the end only.
const FEW_SAMPLES: &str = "kHz(1)";

/// A bearing for both programs; a revolution of the shaft is simulated.
struct Compared {
    name: &'static str,
    /// Designation of a bearing of the catalogue; none for the case.
    bearing: Option<&'static str>,
    /// Axial and radial, N.
    loads: [f64; 2],
    fast: &'static str,
    explicit: &'static str,
    /// Promise: processor time of Exudyn over that of the fast scheme.
    at_least: f64,
}

const PAPER: Compared = Compared {
    name: "the case's loads",
    bearing: None,
    loads: [54_900.0, 23_000.0],
    fast: FAST,
    explicit: PAPER_STEP,
    at_least: 300.0,
};
/// The last is a deep-groove bearing in oil, as `tribodyn new` writes it.
const ALL: [Compared; 3] = [
    PAPER,
    Compared { name: "a light load", loads: [5_000.0, 0.0], ..PAPER },
    Compared {
        name: "6206",
        bearing: Some("6206"),
        loads: [390.0, 2_000.0],
        fast: "FastTo(accuracy: 0.001)",
        explicit: "RungeKutta4(step: us(0.5))",
        at_least: 200.0,
    },
];

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
    for bearing in &ALL {
        match bearing.in_turn(&python, text, quick)? {
            Ok(measured) => rows.extend(measured),
            Err(reason) => rows.push(Row::skipped(GROUP, format!("Exudyn, {}", bearing.name), reason)),
        }
    }
    Ok(rows)
}

impl Compared {
    /// Both programs in turn; the inner error is Exudyn's own.
    fn in_turn(&self, python: &Path, text: &str, quick: bool) -> Result<Result<[Row; 6], String>, Failure> {
        let written = self.bearing.map(|bearing| written((bearing, None), USUAL)).transpose()?;
        let text = written.as_deref().unwrap_or(text);
        let [axial, radial] = self.loads;
        let changes = [("ring.x", format!("Force(N({radial}))")), ("ring.z", format!("Force(N({axial}))"))];
        let with = |scheme: &str, samples: &str| -> Result<Prepared, Failure> {
            let rates = ["recording.state_rate", "recording.ball_rate"].map(|path| (path, samples));
            let others =
                rates.into_iter().chain([("transient.scheme", scheme)]).map(|(path, value)| (path, value.to_owned()));
            Prepared::new(text, &changes.iter().cloned().chain(others).collect::<Vec<_>>(), false)
        };
        let mut ours = [with(self.fast, FEW_SAMPLES)?, with(self.fast, RIG_RATE)?, with(self.explicit, FEW_SAMPLES)?];
        let case = changed(text, &changes)?.case;
        let revolution = TAU / case.operating_point().inner_speed;
        let mut theirs: Option<Answer> = None;
        for _ in 0..if quick { 1 } else { 3 } {
            let answer = match self.exudyn(python, &case, revolution)? {
                Ok(answer) => answer,
                Err(reason) => return Ok(Err(reason)),
            };
            if theirs.as_ref().is_none_or(|least| answer.processor_s < least.processor_s) {
                theirs = Some(answer);
            }
            for run in &mut ours {
                run.repeat(revolution)?;
            }
        }
        let least = ours.each_ref().map(Prepared::least);
        Ok(theirs.map(|answer| self.rows(&answer, least)).ok_or_else(|| "no run".to_owned()))
    }

    fn rows(&self, theirs: &Answer, [fast, sampled, explicit]: [f64; 3]) -> [Row; 6] {
        let row = |what: &str, value, unit| Row::new(GROUP, format!("{}: {what}", self.name), value, unit);
        let note = format!(
            "{} at {} µs, cage at {:.0} r/min: one point a contact, one coefficient of friction, cage on springs, no \
             fluid, no wear",
            theirs.version,
            STEP * 1e6,
            theirs.cage_speed_rpm
        );
        [
            row("Exudyn, a revolution", theirs.processor_s * 1e3, "ms").note(note),
            row("ours, fast scheme, full patches, samples at 1 kHz, a revolution", fast * 1e3, "ms").note(self.fast),
            row("Exudyn over fast scheme", theirs.processor_s / fast, "times").must_be(Limit::AtLeast(self.at_least)),
            row("ours, the same with samples at 25.6 kHz", sampled * 1e3, "ms"),
            row("ours, RK4, full patches, samples at 1 kHz, a revolution", explicit * 1e3, "ms").note(self.explicit),
            row("Exudyn over RK4", theirs.processor_s / explicit, "times"),
        ]
    }

    /// One run of Exudyn; the inner error is its own.
    fn exudyn(&self, python: &Path, case: &Case, revolution: f64) -> Result<Result<Answer, String>, Failure> {
        let inputs = case.run_inputs().map_err(|error| refused(&error))?;
        let (bearing, ring_mass) = (inputs.bearing, inputs.supports.inner.mass);
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
            ("--axial", self.loads[0]),
            ("--radial", self.loads[1]),
            ("--step", STEP),
            ("--duration", revolution),
            ("--ring-mass", ring_mass),
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
}
