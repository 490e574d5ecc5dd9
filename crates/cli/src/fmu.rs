//! `tribodyn fmu`: a case as a functional mock-up unit for multibody and system simulation.

use crate::failure::Failure;
use crate::input::{CaseArguments, ReplaceArguments};
use crate::search::{Search, TimeArguments};
use crate::table::{self, number};
use std::path::PathBuf;
use tribodyn_study::{FmuAnswer, FmuOptions, export_fmu};

/// Write a bearing as a functional mock-up unit (FMI 2.0, co-simulation and model exchange): forces from displacements,
/// tilts and speeds, by raceway control.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn fmu 7210B.ron -o bearing.fmu
  tribodyn fmu 7210B.ron -o bearing.fmu --set 'ring.z.Force=kN(3)' --no-compile")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// FMU to write
    #[arg(short, long, value_name = "FILE.fmu")]
    output: PathBuf,
    /// Do not compile the C sources; otherwise `cc`, or the compiler that CC names, does
    #[arg(long)]
    no_compile: bool,
    #[command(flatten)]
    replace: ReplaceArguments,
    #[command(flatten)]
    time: TimeArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let options = FmuOptions { compile: !arguments.no_compile, force: arguments.replace.force };
    let search = Search::begin(&file, &arguments.time);
    let question = file.question(search.watch());
    let answer = export_fmu(&question, &arguments.case.path, &arguments.output, &options);
    let answer = answer.map_err(|error| search.failed(error))?;
    drop(search);
    if arguments.json {
        return table::print_json(&answer);
    }
    table::print_head(&file.name, answer.findings())?;
    let FmuAnswer { fmi_version, model_identifier, platforms, ring_displacement_m, ring_tilt_rad, .. } = answer.value();
    let FmuAnswer { force_n, moment_nm, .. } = answer.value();
    let several = |values: &[f64], factor: f64, digits: usize| {
        values.iter().map(|value| number(value * factor, digits)).collect::<Vec<_>>().join("  ")
    };
    table::print_pairs(&[
        ("FMI version", (*fmi_version).to_owned(), ""),
        ("model identifier", model_identifier.clone(), ""),
        ("compiled for", if platforms.is_empty() { "nothing: sources".to_owned() } else { platforms.join(", ") }, ""),
        ("displacement x y z at the start", several(ring_displacement_m, 1e6, 3), "µm"),
        ("tilt about x y", several(ring_tilt_rad, 1e3, 4), "mrad"),
        ("force of the bearing x y z", several(force_n, 1.0, 2), "N"),
        ("moment about x y", several(moment_nm, 1.0, 3), "N m"),
    ])?;
    table::print_warnings(answer.findings().warnings())
}
