//! The report of a recorded quasi-static solution.

use super::content::{Content, damage, values};
use super::page_table::Table;
use super::values::CaseValue;
use super::{figures, tables};
use crate::ReportError;
use crate::words::number;
use crate::words::shown;
use serde::{Serialize, Serializer};
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use tribodyn::CaseFile;
use tribodyn::answers::Equations;
use tribodyn_bearing::quantities::{Fields, OfBall, Over, RPM_PER_RAD_S, Scope};
use tribodyn_bearing::{BallResult, Side};
use tribodyn_plot::Figure;
use tribodyn_quasistatic::{Model, Solution};
use tribodyn_record::{Damage, Run, SolutionRow, read_ball, read_state};
use tribodyn_signal::BearingFrequencies;
use tribodyn_study::evaluation::facts::{self, Rolling, said};
use tribodyn_study::evaluation::quantities::{self, Quantities};
use tribodyn_study::run::warnings::at_start;

/// Contents of `summary.json` and of `--json` for a solution.
#[derive(Debug, Serialize)]
pub struct SolutionAnswer {
    pub recording: PathBuf,
    kind: &'static str,
    pub bearing: String,
    generator: String,
    model: String,
    converged: bool,
    #[serde(flatten)]
    damage: Damage,
    pub cage_speed_rpm: f64,
    pub operation: Quantities,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub power: Option<SolutionPower>,
    pub frequencies: BearingFrequencies,
    pub rolling: Option<Rolling>,
    #[serde(serialize_with = "as_fields")]
    balls: Vec<BallResult>,
    pub case_values: Vec<CaseValue>,
    pub warnings: Vec<String>,
    pub figures: Vec<String>,
    pub notes: Vec<String>,
}

/// Powers of a solution with traction, W.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct SolutionPower {
    pub shaft_w: f64,
    pub friction_inner_w: f64,
    pub friction_outer_w: f64,
    pub fluid_w: f64,
}

impl SolutionPower {
    /// None where the model has no friction.
    fn of(solution: &Solution) -> Option<Self> {
        let sum = |q: Option<OfBall>| q?.over(Over::Sum, &solution.balls);
        Some(Self {
            shaft_w: solution.shaft_torque_nm? * solution.inner_speed_rad_s,
            friction_inner_w: sum(OfBall::contact(Side::Inner, "power_loss"))?,
            friction_outer_w: sum(OfBall::contact(Side::Outer, "power_loss"))?,
            fluid_w: sum(OfBall::ball("power_loss_fluid"))?,
        })
    }
}

/// Evaluates the recording of a solution.
pub fn evaluate(
    path: &Path,
    run: &Run,
    row: &SolutionRow,
    (case, case_values): (Option<&CaseFile>, Vec<CaseValue>),
) -> Result<(SolutionAnswer, Vec<Figure>), ReportError> {
    let solution = solved(run, row);
    let mut figures: Vec<Figure> = figures::bearing(run, solution.ring_load_n).into_iter().collect();
    figures.extend(tribodyn_plot::solution_figures(&[("solution", &solution)], &[])?);
    let operation = quantities::of_solution(run, row, facts::ball_radius_m(run));
    let speeds = [solution.inner_speed_rad_s, solution.outer_speed_rad_s];
    let text = |key: &str| said(run, key).unwrap_or_default().to_owned();
    let mut warnings = at_start(solution.warnings.clone());
    warnings.extend(case.iter().flat_map(|file| facts::untested(&file.case, run)));
    let answer = SolutionAnswer {
        recording: path.to_owned(),
        kind: "solution",
        bearing: text("bearing"),
        generator: text("generator"),
        model: text("model"),
        converged: solution.converged,
        damage: run.damage,
        cage_speed_rpm: row.cage_speed_rpm,
        rolling: facts::rolling(run, &operation, speeds),
        operation,
        power: SolutionPower::of(&solution),
        frequencies: facts::frequencies(run, 0.0, row.cage_speed_rpm * TAU / 60.0, speeds)?,
        balls: solution.balls,
        case_values,
        warnings,
        figures: figures.iter().map(|figure| figure.name.clone()).collect(),
        notes: Vec::new(),
    };
    Ok((answer, figures))
}

/// The solution from the first sample of its orbit, where the balls stand at their solved azimuths.
fn solved(run: &Run, row: &SolutionRow) -> Solution {
    let (model, scope) = match said(run, "model") {
        Some(name) if name == Model::JonesHarris.name() => (Model::JonesHarris, Scope::All),
        _ => (Model::Traction, Scope::Traction),
    };
    let number = |key: &str| said(run, key).and_then(|text| text.parse().ok());
    let first = run.balls.first().map(|(_, balls)| balls.iter().map(|ball| read_ball(ball, scope)).collect());
    let mut solution = Solution {
        converged: said(run, "converged") == Some("true"),
        residual: number("residual").unwrap_or_default(),
        iterations: number("iterations").map_or(0, |steps| steps as usize),
        warnings: run.events.iter().filter(|row| row.warning).map(|row| row.message.clone()).collect(),
        ..Solution::of_balls(model, first.unwrap_or_default())
    };
    read_state(&mut solution, row);
    solution
}

/// Balls as `solve --json` has them.
fn as_fields<S: Serializer>(balls: &[BallResult], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(balls.iter().map(Fields))
}

/// Opening table of a solution.
pub fn opening(answer: &SolutionAnswer, case: Option<&CaseFile>, run: &Run) -> Table {
    let recording = answer.recording.display().to_string();
    super::opening::of_solution(&answer.bearing, case, run, (&answer.generator, &recording))
}

/// The words and tables.
pub fn content(answer: &SolutionAnswer, case: Option<&CaseFile>, run: &Run) -> Content {
    let mut warnings = damage(&answer.damage, run.balls.last().map_or(0.0, |(time, _)| *time));
    if !answer.converged {
        warnings.push("The solution has not converged.".to_owned());
    }
    warnings.extend(answer.warnings.iter().cloned());
    let text = "Over all balls, where they carry load. The load zone is where the inner race carries a ball with more than 1 % of the highest load.";
    Content {
        title: if answer.bearing.is_empty() { "Solution".to_owned() } else { answer.bearing.clone() },
        subtitle: if answer.model == Equations::SteadyOrbit.name() { "Steady orbit" } else { "Quasi-static solution" },
        warnings: shown(&warnings),
        opening: vec![opening(answer, case, run)],
        inputs: values(&answer.case_values),
        tables: [
            Some(tables::operation(&answer.operation, text)),
            answer.power.as_ref().map(powers),
            Some(tables::frequencies(&answer.frequencies, answer.rolling.as_ref())),
            Some(balls(answer)),
        ]
        .into_iter()
        .flatten()
        .collect(),
        notes: answer.notes.clone(),
        case_text: run.case_text.clone(),
    }
}

fn powers(p: &SolutionPower) -> Table {
    let lost = p.friction_inner_w + p.friction_outer_w + p.fluid_w;
    let share = |w: f64| if lost == 0.0 { String::new() } else { number(100.0 * w / lost, 2) };
    let rows = [
        ("shaft", p.shaft_w, String::new()),
        ("friction, inner race", p.friction_inner_w, share(p.friction_inner_w)),
        ("friction, outer race", p.friction_outer_w, share(p.friction_outer_w)),
        ("drag and churning", p.fluid_w, share(p.fluid_w)),
    ];
    Table {
        title: "Powers".to_owned(),
        text: String::new(),
        header: vec!["Power", "W", "% of the losses"],
        rows: rows.map(|(name, w, part)| vec![name.to_owned(), number(w, 1), part]).to_vec(),
        numbers: 1..3,
        wide: false,
    }
}

/// One row for each ball; Jones–Harris says nothing about traction and slip.
fn balls(answer: &SolutionAnswer) -> Table {
    type Column = (&'static str, usize, fn(&BallResult) -> f64);
    let columns: [Column; 14] = [
        ("φ, °", 1, |b| b.azimuth_rad.to_degrees()),
        ("α_i, °", 3, |b| b.contacts.inner.angle_rad.to_degrees()),
        ("α_o, °", 3, |b| b.contacts.outer.angle_rad.to_degrees()),
        ("Q_i, N", 1, |b| b.contacts.inner.load_n),
        ("Q_o, N", 1, |b| b.contacts.outer.load_n),
        ("p_i, GPa", 3, |b| 1e-9 * b.contacts.inner.peak_pressure_pa),
        ("p_o, GPa", 3, |b| 1e-9 * b.contacts.outer.peak_pressure_pa),
        ("ω_m, r/min", 2, |b| b.orbital_speed_rad_s * RPM_PER_RAD_S),
        ("T_i, N", 2, |b| b.contacts.inner.friction_or_nan().traction_n[0]),
        ("T_o, N", 2, |b| b.contacts.outer.friction_or_nan().traction_n[0]),
        ("ξ_i, %", 4, |b| 100.0 * b.contacts.inner.friction_or_nan().slide_to_roll[0]),
        ("ξ_o, %", 4, |b| 100.0 * b.contacts.outer.friction_or_nan().slide_to_roll[0]),
        ("P_i, W", 2, |b| b.contacts.inner.friction_or_nan().power_loss_w),
        ("P_o, W", 2, |b| b.contacts.outer.friction_or_nan().power_loss_w),
    ];
    let shown = if answer.model == Model::JonesHarris.name() { &columns[..8] } else { &columns[..] };
    let row = |b: &BallResult| shown.iter().map(|(_, digits, get)| number(get(b), *digits)).collect();
    Table {
        title: "Balls".to_owned(),
        text: "Azimuth φ, contact angles α, loads Q, peak pressures p, orbital speed ω_m, traction along the orbit T, slide-to-roll ratio ξ and frictional power P at the inner (i) and outer (o) race.".to_owned(),
        header: shown.iter().map(|(name, ..)| *name).collect(),
        rows: answer.balls.iter().map(row).collect(),
        numbers: 0..shown.len(),
        wide: true,
    }
}
