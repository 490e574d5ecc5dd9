//! Tables 2, 4 and 5.

use super::published::{CurveRow, PressureRow, Published, SpeedRow};
use super::row::{Evidence, Row, Stated, Verdict};
use super::runs::{Run, Runs};
use crate::error::PaperError;
use tribodyn_quasistatic::{AzimuthRule, OverAzimuth};
use tribodyn_traction::{Coating, CoatingLaw, TractionLaw};

/// Relative tolerance of the curve parameters that come back at the test pressures.
const CURVE: f64 = 1e-9;
/// Relative tolerance of cage speeds: 0.1 % (DESIGN.md, "Numbers that must come out").
const SPEED: f64 = 1e-3;
/// Tolerance of pressures, GPa.
const PRESSURE: f64 = 0.02;
/// Degree of the paper's fits: parabolas (Fig. 15).
pub const PARABOLA: usize = 2;

/// T2: the varying-parameter model gives Table 2 back at the test pressures.
pub fn table_2(published: &Published) -> Result<Vec<Row>, PaperError> {
    let mut rows = Vec::new();
    for CurveRow { coating, pressure_label, pressure, parameters } in &published.curves {
        let law = CoatingLaw::varying(&Coating::library(coating)?, PARABOLA)?;
        let curve = law.at(pressure * 1e9);
        let computed = [curve.a, curve.b, curve.c, curve.d()];
        for ((name, published), computed) in ["A", "B", "C", "D"].iter().zip(parameters).zip(computed) {
            let id = format!("T2.{coating}.{pressure_label}.{name}");
            let quantity = format!("{name} of {coating} at {pressure_label} GPa");
            let row = Row::number(id, quantity, [*published, computed, CURVE * published.abs()]);
            rows.push(Row { evidence: Evidence::Verification, ..row });
        }
    }
    Ok(rows)
}

/// T4 and T4.err: cage speeds, and their errors against the test.
pub fn table_4(published: &Published, runs: &Runs) -> Vec<Row> {
    // The dynamic model's row comes from its own runs.
    let printed = published.speeds.iter().filter(|row| row.id != "test" && row.id != "dyn");
    let pairs: Vec<(&SpeedRow, Option<&Run>)> =
        printed.map(|row| (row, runs.all().find(|run| run.id == row.id))).collect();
    let speeds = pairs.iter().map(|(row, run)| speed(row, *run, runs));
    let errors = pairs.iter().filter_map(|(row, run)| error(row, *run, published.tested_speed, runs));
    speeds.chain(errors).collect()
}

fn speed(printed: &SpeedRow, run: Option<&Run>, runs: &Runs) -> Row {
    let (id, quantity) = (format!("T4.{}", printed.id), format!("cage speed, {}", printed.model));
    let row = match run {
        None => not_yet(id, quantity, printed.cage_speed),
        Some(run) => {
            let speed = run.solution.cage_speed_rpm;
            explained(Row::number(id, quantity, [printed.cage_speed, speed, SPEED * printed.cage_speed]), runs)
        }
    };
    Row { unit: "r/min", decimals: 1, ..row }
}

fn error(printed: &SpeedRow, run: Option<&Run>, tested: f64, runs: &Runs) -> Option<Row> {
    let published = printed.error?;
    let id = format!("T4.err.{}", printed.id);
    let quantity = format!("error against the test, {}", printed.model);
    let row = match run {
        None => not_yet(id, quantity, published),
        Some(run) => {
            let computed = (run.solution.cage_speed_rpm / tested - 1.0).abs() * 100.0;
            // The speed's tolerance, in percent of the tested speed.
            let tolerance = 100.0 * SPEED * printed.cage_speed / tested;
            explained(Row::number(id, quantity, [published, computed, tolerance]), runs)
        }
    };
    // The speed once more, in percent of the tested one.
    Some(Row { unit: "%", decimals: 2, evidence: Evidence::Beside, ..row })
}

fn not_yet(id: String, quantity: String, published: f64) -> Row {
    Row {
        computed: None,
        deviation: None,
        tolerance: None,
        verdict: Verdict::NotYet,
        evidence: Evidence::Validation,
        published: Stated::Number(published),
        note: "dynamic model".to_owned(),
        ..Row::number(id, quantity, [published; 3])
    }
}

/// A missed figure of Tables 4 and 5 says how its parameters were found.
fn explained(row: Row, runs: &Runs) -> Row {
    let note = if row.verdict == Verdict::Missed { runs.provenance() } else { String::new() };
    Row { note, ..row }
}

/// T5: pressures of case 1 at the printed azimuths.
pub fn table_5(published: &Published, runs: &Runs) -> Vec<Row> {
    let pressures = PressuresOver::new(&runs.cases[0]);
    let mut rows = Vec::new();
    for PressureRow { azimuth, pressure, .. } in &published.pressures {
        for (side, name, published, computed) in [
            ("i", "inner", pressure[0], pressures.at(*azimuth)[0]),
            ("o", "outer", pressure[1], pressures.at(*azimuth)[1]),
        ] {
            let id = format!("T5.{azimuth}.{side}");
            let quantity = format!("{name} peak pressure at {azimuth}°");
            let row = explained(Row::number(id, quantity, [published, computed, PRESSURE]), runs);
            rows.push(Row { unit: "GPa", ..row });
        }
    }
    rows
}

/// Pressures of a run at any azimuth: the balls are not at those of Table 5.
pub struct PressuresOver<'a> {
    over: OverAzimuth<'a>,
    rule: AzimuthRule,
    count: usize,
}

impl<'a> PressuresOver<'a> {
    pub fn new(run: &'a Run) -> Self {
        let solution = &run.solution;
        Self { over: OverAzimuth::new(solution), rule: AzimuthRule::of(solution), count: solution.balls.len() }
    }

    /// Inner and outer peak pressure, GPa, at an azimuth in degrees.
    pub fn at(&self, azimuth: f64) -> [f64; 2] {
        let ball = self.over.at(azimuth.to_radians());
        [ball.contacts.inner.peak_pressure_pa * 1e-9, ball.contacts.outer.peak_pressure_pa * 1e-9]
    }

    /// Rule for values between balls.
    pub fn explanation(&self) -> String {
        let rule = self.rule.name();
        format!(
            "the {0} equispaced balls are at Table 5's azimuth 0° only: at the others {rule} interpolation over the \
            {0} balls of case 1",
            self.count
        )
    }
}
