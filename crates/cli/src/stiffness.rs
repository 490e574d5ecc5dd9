//! `tribodyn stiffness`: the 5 × 5 stiffness of the inner ring at the operating point.

use crate::failure::Failure;
use crate::input::{CaseArguments, ReplaceArguments};
use crate::orbit::{Problem, write_table};
use crate::solve::ModelName;
use crate::table;
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;
use tribodyn_case::Purpose;
use tribodyn_orbit::{OrbitStart, orbit_stiffness, steady_orbit, steady_orbit_from};
use tribodyn_quasistatic::{Model, StiffnessMatrix, compliance, jones_harris_stiffness, solve, traction_stiffness};
use tribodyn_study::{CaseFile, StudyError};

/// Stiffness of the inner ring: forces and moments against displacements and tilts, balls and cage in balance.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Equations of the operating point
    #[arg(long, value_enum, default_value_t = ModelName::SteadyOrbit)]
    model: ModelName,
    /// Speeds of the inner ring, r/min, as N,N,…; that of the case without it
    #[arg(long, value_name = "RPM", value_delimiter = ',', allow_hyphen_values = true)]
    speeds: Vec<f64>,
    /// Write the matrices as a table, one row a speed (CSV)
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Write the bearing coefficients over speed for rotor programs: frequency in rad/s, kxx … kzz in N/m (CSV)
    #[arg(long, value_name = "FILE.csv")]
    ross: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Print JSON, and nothing else, to standard output
    #[arg(long)]
    json: bool,
}

/// One speed.
#[derive(Serialize)]
struct Answer {
    inner_speed_rpm: f64,
    /// By rows: forces along x, y, z (N) and moments about x, y (N m) against x, y, z (m) and tilts about x, y (rad).
    stiffness: StiffnessMatrix,
    /// Its inverse; absent where a displacement meets no resistance.
    #[serde(skip_serializing_if = "Option::is_none")]
    compliance: Option<StiffnessMatrix>,
}

const RPM_PER_RAD_S: f64 = 30.0 / std::f64::consts::PI;
const AXES: [&str; 5] = ["x", "y", "z", "tilt_x", "tilt_y"];

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    if let Some(speed) = arguments.speeds.iter().find(|speed| !speed.is_finite()) {
        let message = "allowed are finite speeds in r/min".to_owned();
        return Err(Failure::Option { option: "speeds", value: speed.to_string(), message });
    }
    let answers = answers(arguments, &file)?;
    for (path, text) in [(&arguments.csv, csv(&answers)), (&arguments.ross, ross(&answers))] {
        if let Some(path) = path {
            write_table(path, &arguments.case.path, &text, &arguments.replace)?;
        }
    }
    if arguments.json {
        return table::print_json(&answers);
    }
    table::print_line(&format!("{}\n", file.name))?;
    for answer in &answers {
        print(answer)?;
    }
    Ok(())
}

fn answers(arguments: &Arguments, file: &CaseFile) -> Result<Vec<Answer>, Failure> {
    let given = file.case.operating_point().inner_speed;
    let speeds: Vec<f64> = if arguments.speeds.is_empty() {
        vec![given]
    } else {
        arguments.speeds.iter().map(|rpm| rpm / RPM_PER_RAD_S).collect()
    };
    let mut start = None;
    let mut answers = Vec::with_capacity(speeds.len());
    for speed in speeds {
        let stiffness = at_speed(arguments.model, file, speed, &mut start)?;
        let compliance = compliance(&stiffness);
        answers.push(Answer { inner_speed_rpm: speed * RPM_PER_RAD_S, stiffness, compliance });
    }
    Ok(answers)
}

fn at_speed(
    model: ModelName,
    file: &CaseFile,
    speed: f64,
    start: &mut Option<OrbitStart>,
) -> Result<StiffnessMatrix, Failure> {
    let failed = |source| StudyError::Solver { file: file.name.clone(), source };
    let no_orbit = |source| StudyError::Orbit { file: file.name.clone(), source };
    let mut point = file.case.operating_point();
    point.inner_speed = speed;
    match model {
        ModelName::JonesHarris => {
            let bearing = file.bearing_for(Purpose::JonesHarris)?;
            Ok(jones_harris_stiffness(&bearing, &point).map_err(failed)?)
        }
        ModelName::Traction => {
            let bearing = file.bearing_for(Purpose::Traction)?;
            let solved = solve(&bearing, &point, Model::Traction).map_err(failed)?;
            // A traction solution always comes with its unknowns.
            let Some(at) = solved.warm_start else { unreachable!("a traction solution has unknowns") };
            Ok(traction_stiffness(&bearing, &point, &at).map_err(failed)?)
        }
        ModelName::SteadyOrbit => {
            let Problem { bearing, cage, settings, .. } = Problem::new(file)?;
            let solved = match start.as_ref() {
                Some(near) => steady_orbit_from(&bearing, &point, &cage, &settings, near),
                None => steady_orbit(&bearing, &point, &cage, &settings),
            };
            *start = solved.map_err(no_orbit)?.start;
            match start.as_ref() {
                Some(at) => Ok(orbit_stiffness(&bearing, &point, &cage, &settings, at).map_err(no_orbit)?),
                // A bearing at rest: the elastic equilibrium.
                None => Ok(jones_harris_stiffness(&file.bearing_for(Purpose::JonesHarris)?, &point).map_err(failed)?),
            }
        }
    }
}

fn print(answer: &Answer) -> Result<(), Failure> {
    table::print_line(&format!("stiffness at {} r/min", table::number(answer.inner_speed_rpm, 1)))?;
    let header = ["", "x m", "y m", "z m", "tilt x rad", "tilt y rad"];
    let names = ["F_x N", "F_y N", "F_z N", "M_x N m", "M_y N m"];
    let rows = answer.stiffness.iter().zip(names).map(|(row, name)| {
        std::iter::once(name.to_owned()).chain(row.iter().map(|k| format!("{k:.4e}"))).collect::<Vec<_>>()
    });
    table::print_rows(&header, rows)?;
    table::print_line("")
}

/// One row a speed: the speed, then the matrix by rows.
fn csv(answers: &[Answer]) -> String {
    let mut text = "inner_speed_rpm".to_owned();
    for row in AXES {
        for column in AXES {
            let _ = write!(text, ",k_{row}_{column}");
        }
    }
    text.push('\n');
    for answer in answers {
        let _ = write!(text, "{}", answer.inner_speed_rpm);
        answer.stiffness.iter().flatten().for_each(|k| _ = write!(text, ",{k}"));
        text.push('\n');
    }
    text
}

/// Bearing coefficients over speed, under the names of the arguments of ROSS's `BearingElement`.
fn ross(answers: &[Answer]) -> String {
    let mut text = "frequency,kxx,kxy,kyx,kyy,kzz\n".to_owned();
    for Answer { inner_speed_rpm, stiffness: k, .. } in answers {
        let speed = inner_speed_rpm / RPM_PER_RAD_S;
        let _ = writeln!(text, "{speed},{},{},{},{},{}", k[0][0], k[0][1], k[1][0], k[1][1], k[2][2]);
    }
    text
}
