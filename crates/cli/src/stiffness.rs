//! `tribodyn stiffness`: the 5 × 5 stiffness of the inner ring at the operating point.

use crate::failure::Failure;
use crate::input::{CaseArguments, ReplaceArguments};
use crate::orbit::write_table;
use crate::search::{Search, TimeArguments};
use crate::solve::ModelName;
use crate::table;
use crate::units::in_unit;
use std::fmt::Write;
use std::path::PathBuf;
use tribodyn::answers::{Answer, StiffnessAnswer, stiffness};
use tribodyn_study::Ours;

/// Stiffness of the inner ring: forces and moments against displacements and tilts, balls and cage in balance.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn stiffness 7210B.ron
  tribodyn stiffness 7012C.ron --speeds 1000,8000,16000 --ross coefficients.csv")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Equations of the operating point
    #[arg(long, value_enum, default_value_t)]
    model: ModelName,
    /// Speeds of the inner ring, r/min, as N,N,… [default: that of the case]
    #[arg(long, value_name = "RPM", value_delimiter = ',', allow_hyphen_values = true, value_parser = in_unit("rpm"))]
    speeds: Vec<f64>,
    /// Write the matrices as a table, one row a speed (CSV)
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Write the bearing coefficients over speed for rotor programs: speed in rad/s, kxx … kzz in N/m (CSV)
    #[arg(long, value_name = "FILE.csv")]
    ross: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    #[command(flatten)]
    time: TimeArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

const RPM_PER_RAD_S: f64 = 30.0 / std::f64::consts::PI;
const AXES: [&str; 5] = ["x", "y", "z", "tilt_x", "tilt_y"];

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    for path in [&arguments.csv, &arguments.ross].into_iter().flatten() {
        arguments.replace.check(path, &arguments.case.path, Ours::Table)?;
    }
    let search = Search::begin(&file, &arguments.time);
    let answers = stiffness(&file.question(search.watch()), arguments.model.equations(), &arguments.speeds);
    let answers = answers.map_err(|error| search.failed(error))?;
    drop(search);
    for (path, text) in [(&arguments.csv, csv(&answers)), (&arguments.ross, ross(&answers))] {
        if let Some(path) = path {
            write_table(path, &arguments.case.path, &text, &arguments.replace)?;
        }
    }
    if arguments.json {
        return table::print_json(&answers);
    }
    // The same at all speeds.
    answers.first().map_or(Ok(()), |answer| table::print_head(&file.name, answer.findings()))?;
    for answer in &answers {
        print(answer.value())?;
        table::print_warnings(answer.findings().warnings())?;
        table::print_line("")?;
    }
    Ok(())
}

fn print(answer: &StiffnessAnswer) -> Result<(), Failure> {
    table::print_line(&format!("stiffness at {} r/min", table::number(answer.inner_speed_rpm, 1)))?;
    let header = ["", "x m", "y m", "z m", "tilt x rad", "tilt y rad"];
    let names = ["F_x N", "F_y N", "F_z N", "M_x N m", "M_y N m"];
    let rows = answer.stiffness.iter().zip(names).map(|(row, name)| {
        std::iter::once(name.to_owned()).chain(row.iter().map(|k| format!("{k:.4e}"))).collect::<Vec<_>>()
    });
    table::print_rows(&header, rows)?;
    let error = answer.error_estimate.map(|error| format!("error estimate {error:.1e} of √(K_ii K_jj)"));
    error.map_or(Ok(()), |line| table::print_line(&line))
}

/// One row a speed: the speed, then the matrix by rows, and what must be known of the operating point.
fn csv(answers: &[Answer<StiffnessAnswer>]) -> String {
    let mut text = "inner_speed_rpm".to_owned();
    for row in AXES {
        for column in AXES {
            let _ = write!(text, ",k_{row}_{column}");
        }
    }
    let _ = writeln!(text, "{FINDINGS}");
    for answer in answers {
        let StiffnessAnswer { inner_speed_rpm, stiffness, .. } = answer.value();
        let _ = write!(text, "{inner_speed_rpm}");
        stiffness.iter().flatten().for_each(|k| _ = write!(text, ",{k}"));
        let _ = writeln!(text, "{}", findings(answer));
    }
    text
}

/// Columns of what must be known of the operating point.
const FINDINGS: &str = ",error_estimate,implausible,warnings";

fn findings(answer: &Answer<StiffnessAnswer>) -> String {
    let of = answer.findings();
    let error = answer.value().error_estimate.map_or_else(String::new, |error| error.to_string());
    format!(",{error},{},{}", table::csv_text(&of.implausible()), table::csv_text(&of.warnings().join("; ")))
}

/// Bearing coefficients over speed, under the names of the arguments of the `BearingElement` of ROSS 3, in which
/// `frequency` is that of the whirl.
fn ross(answers: &[Answer<StiffnessAnswer>]) -> String {
    let mut text = format!("speed,kxx,kxy,kyx,kyy,kzz{FINDINGS}\n");
    for answer in answers {
        let StiffnessAnswer { inner_speed_rpm, stiffness: k, .. } = answer.value();
        let speed = inner_speed_rpm / RPM_PER_RAD_S;
        let _ = write!(text, "{speed},{},{},{},{},{}", k[0][0], k[0][1], k[1][0], k[1][1], k[2][2]);
        let _ = writeln!(text, "{}", findings(answer));
    }
    text
}
