//! The report of a recorded quasi-static solution.

use super::content::{Content, Table, damage, values};
use super::tables;
use super::values::CaseValue;
use crate::failure::Failure;
use crate::run::shown;
use crate::table::number;
use serde::Serialize;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use tribodyn_plot::Figure;
use tribodyn_quasistatic::{BallSolution, Model, Solution};
use tribodyn_record::{BallRow, Damage, Run, SolutionRow};
use tribodyn_signal::BearingFrequencies;
use tribodyn_study::CaseFile;
use tribodyn_study::evaluation::facts::{self, Rolling, said};
use tribodyn_study::evaluation::quantities::{self, Quantities};
use tribodyn_study::run::warnings::at_start;

/// What `summary.json` and `--json` say of a solution.
#[derive(Debug, Serialize)]
pub struct SolutionAnswer {
    pub recording: PathBuf,
    kind: &'static str,
    pub bearing: String,
    generator: String,
    model: Model,
    converged: bool,
    #[serde(flatten)]
    damage: Damage,
    pub cage_speed_rpm: f64,
    pub operation: Quantities,
    pub power: SolutionPower,
    pub frequencies: BearingFrequencies,
    pub rolling: Option<Rolling>,
    balls: Vec<BallSolution>,
    pub case_values: Vec<CaseValue>,
    pub warnings: Vec<String>,
    pub figures: Vec<String>,
    pub notes: Vec<String>,
}

/// Powers of a solution, W.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct SolutionPower {
    pub shaft_w: f64,
    pub friction_inner_w: f64,
    pub friction_outer_w: f64,
    pub fluid_w: f64,
}

/// Evaluates the recording of a solution.
pub fn evaluate(
    path: &Path,
    run: &Run,
    row: &SolutionRow,
    (case, case_values): (Option<&CaseFile>, Vec<CaseValue>),
) -> Result<(SolutionAnswer, Vec<Figure>), Failure> {
    let solution = solved(run, row);
    let figures = tribodyn_plot::solution_figures(&[("solution", &solution)], &[])?;
    let operation = quantities::of_solution(run, row, facts::ball_radius_m(run));
    let speeds = [solution.inner_speed_rad_s, solution.outer_speed_rad_s];
    let text = |key: &str| said(run, key).unwrap_or_default().to_owned();
    let mut warnings = at_start(solution.warnings.clone());
    warnings.extend(case.iter().flat_map(|file| facts::untested(&file.case, run)));
    let sum = |get: fn(&BallSolution) -> f64| solution.balls.iter().map(get).sum::<f64>();
    let answer = SolutionAnswer {
        recording: path.to_owned(),
        kind: "solution",
        bearing: text("bearing"),
        generator: text("generator"),
        model: solution.model,
        converged: solution.converged,
        damage: run.damage,
        cage_speed_rpm: row.cage_speed_rpm,
        rolling: facts::rolling(run, &operation, speeds),
        operation,
        power: SolutionPower {
            shaft_w: row.shaft_torque_nm * solution.inner_speed_rad_s,
            friction_inner_w: sum(|b| b.power_loss_inner_w),
            friction_outer_w: sum(|b| b.power_loss_outer_w),
            fluid_w: sum(|b| b.power_loss_fluid_w),
        },
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
    let model = if said(run, "model") == Some("JonesHarris") { Model::JonesHarris } else { Model::Traction };
    let number = |key: &str| said(run, key).and_then(|text| text.parse().ok());
    Solution {
        model,
        converged: said(run, "converged") == Some("true"),
        cage_speed_rpm: row.cage_speed_rpm,
        ring_displacement_m: [row.shaft_x_um, row.shaft_y_um, row.shaft_z_um].map(|um| 1e-6 * um),
        ring_tilt_rad: [row.tilt_x_mrad, row.tilt_y_mrad].map(|mrad| 1e-3 * mrad),
        ring_load_n: [row.load_x_n, row.load_y_n, row.load_z_n],
        ring_moment_nm: [row.moment_x_nm, row.moment_y_nm],
        shaft_torque_nm: row.shaft_torque_nm,
        inner_speed_rad_s: row.inner_speed_rpm * TAU / 60.0,
        outer_speed_rad_s: row.outer_speed_rpm * TAU / 60.0,
        residual: number("residual").unwrap_or_default(),
        iterations: number("iterations").map_or(0, |steps| steps as usize),
        patch_error_estimate: None,
        warnings: run.events.iter().filter(|row| row.warning).map(|row| row.message.clone()).collect(),
        balls: run.balls.first().map_or_else(Vec::new, |(_, balls)| balls.iter().map(ball).collect()),
    }
}

/// A ball in the units of solutions.
fn ball(b: &BallRow) -> BallSolution {
    let wide = |value: f32| f64::from(value);
    BallSolution {
        azimuth_deg: wide(b.azimuth_deg),
        contact_angle_inner_deg: wide(b.contact_angle_inner_deg),
        contact_angle_outer_deg: wide(b.contact_angle_outer_deg),
        load_inner_n: wide(b.load_inner_n),
        load_outer_n: wide(b.load_outer_n),
        approach_inner_m: 1e-6 * wide(b.approach_inner_um),
        approach_outer_m: 1e-6 * wide(b.approach_outer_um),
        peak_pressure_inner_pa: 1e9 * wide(b.pressure_inner_gpa),
        peak_pressure_outer_pa: 1e9 * wide(b.pressure_outer_gpa),
        semi_axes_inner_m: [b.semi_axis_across_inner_mm, b.semi_axis_rolling_inner_mm].map(|mm| 1e-3 * wide(mm)),
        semi_axes_outer_m: [b.semi_axis_across_outer_mm, b.semi_axis_rolling_outer_mm].map(|mm| 1e-3 * wide(mm)),
        orbital_speed_rad_s: wide(b.orbital_speed_rpm) * TAU / 60.0,
        axial_displacement_m: 1e-6 * wide(b.axial_displacement_um),
        spin_rad_s: [b.spin_axial_rad_s, b.spin_radial_rad_s, b.spin_tangential_rad_s].map(wide),
        centrifugal_force_n: wide(b.centrifugal_force_n),
        gyroscopic_moment_nm: 1e-3 * wide(b.gyroscopic_moment_nmm),
        drag_n: wide(b.drag_n),
        traction_inner_n: wide(b.traction_inner_n),
        traction_outer_n: wide(b.traction_outer_n),
        lateral_traction_inner_n: wide(b.lateral_traction_inner_n),
        lateral_traction_outer_n: wide(b.lateral_traction_outer_n),
        slide_to_roll_inner: 1e-2 * wide(b.slide_to_roll_inner_percent),
        slide_to_roll_outer: 1e-2 * wide(b.slide_to_roll_outer_percent),
        lateral_slide_to_roll_inner: 1e-2 * wide(b.lateral_slide_to_roll_inner_percent),
        lateral_slide_to_roll_outer: 1e-2 * wide(b.lateral_slide_to_roll_outer_percent),
        spin_ratio_inner: wide(b.spin_ratio_inner_per_m),
        spin_ratio_outer: wide(b.spin_ratio_outer_per_m),
        rolling_speed_inner_m_s: wide(b.rolling_speed_inner_m_s),
        rolling_speed_outer_m_s: wide(b.rolling_speed_outer_m_s),
        power_loss_inner_w: wide(b.power_loss_inner_w),
        power_loss_outer_w: wide(b.power_loss_outer_w),
        power_loss_fluid_w: wide(b.power_loss_fluid_w),
        wear_rate_inner_m3_s: 1e-18 * wide(b.wear_rate_inner_um3_s),
        wear_rate_outer_m3_s: 1e-18 * wide(b.wear_rate_outer_um3_s),
        pocket_lead_rad: 1e-3 * wide(b.pocket_lead_mrad),
        cage_force_n: wide(b.cage_force_n),
        wear_rate_cage_m3_s: 1e-18 * wide(b.wear_rate_cage_um3_s),
        ..BallSolution::default()
    }
}

/// What was solved.
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
    let mut opening = vec![opening(answer, case, run)];
    opening.extend(values(&answer.case_values));
    let text = "Over all balls, where they carry load. The load zone is where the inner race carries a ball with more than 1 % of the highest load.";
    Content {
        title: if answer.bearing.is_empty() { "Solution".to_owned() } else { answer.bearing.clone() },
        subtitle: "Quasi-static solution",
        warnings: shown(&warnings),
        opening,
        tables: vec![
            tables::operation(&answer.operation, text),
            powers(&answer.power),
            tables::frequencies(&answer.frequencies, answer.rolling.as_ref()),
            balls(answer),
        ],
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
    type Column = (&'static str, usize, fn(&BallSolution) -> f64);
    let columns: [Column; 14] = [
        ("φ, °", 1, |b| b.azimuth_deg),
        ("α_i, °", 3, |b| b.contact_angle_inner_deg),
        ("α_o, °", 3, |b| b.contact_angle_outer_deg),
        ("Q_i, N", 1, |b| b.load_inner_n),
        ("Q_o, N", 1, |b| b.load_outer_n),
        ("p_i, GPa", 3, |b| 1e-9 * b.peak_pressure_inner_pa),
        ("p_o, GPa", 3, |b| 1e-9 * b.peak_pressure_outer_pa),
        ("ω_m, r/min", 2, |b| b.orbital_speed_rad_s * 60.0 / TAU),
        ("T_i, N", 2, |b| b.traction_inner_n),
        ("T_o, N", 2, |b| b.traction_outer_n),
        ("ξ_i, %", 4, |b| 100.0 * b.slide_to_roll_inner),
        ("ξ_o, %", 4, |b| 100.0 * b.slide_to_roll_outer),
        ("P_i, W", 2, |b| b.power_loss_inner_w),
        ("P_o, W", 2, |b| b.power_loss_outer_w),
    ];
    let shown = if answer.model == Model::JonesHarris { &columns[..8] } else { &columns[..] };
    let row = |b: &BallSolution| shown.iter().map(|(_, digits, get)| number(get(b), *digits)).collect();
    Table {
        title: "Balls".to_owned(),
        text: "Azimuth φ, contact angles α, loads Q, peak pressures p, orbital speed ω_m, traction along the orbit T, slide-to-roll ratio ξ and frictional power P at the inner (i) and outer (o) race.".to_owned(),
        header: shown.iter().map(|(name, ..)| *name).collect(),
        rows: answer.balls.iter().map(row).collect(),
        numbers: 0..shown.len(),
        wide: true,
    }
}
