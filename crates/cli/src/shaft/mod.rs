//! `tribodyn shaft`: a shaft in its bearings.

mod cards;
mod figures;
mod print;

use crate::failure::Failure;
use crate::input::{LimitArguments, ReplaceArguments, change};
use crate::orbit::write_table;
use crate::table;
use crate::units::in_unit;
use std::path::PathBuf;
use tribodyn::Change;
use tribodyn_study::shaft::{ShaftFile, shaft_outcome};
use tribodyn_study::{Ours, StagedFiles};

/// A shaft in its bearings: reactions, deflections, stresses, lives, modes, critical speeds, unbalance.
///
/// Bearings are those of the built-in list or of case files, in quasi-static equilibrium (Jones and Harris); at rest
/// they are elastic. docs/shaft.md has every field of the file.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn shaft fixtures/shafts/motor.ron
  tribodyn shaft fixtures/shafts/motor.ron --set 'speed=rpm(1500)' --json
  tribodyn shaft fixtures/shafts/spindle.ron --modes 0,10000,20000 --up-to 3000 --plot figures")]
pub struct Arguments {
    /// The shaft's file (RON)
    #[arg(value_name = "SYSTEM")]
    path: PathBuf,
    /// Replace one value of the file for this run, such as 'speed=rpm(3000)'; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = change)]
    changes: Vec<Change>,
    #[command(flatten)]
    limits: LimitArguments,
    /// Compute modes, critical speeds and response to unbalance at these speeds, r/min, as N,N,…
    #[arg(long, value_name = "RPM", value_delimiter = ',', allow_hyphen_values = true, value_parser = in_unit("rpm"))]
    modes: Vec<f64>,
    /// Highest frequency of the modes that are printed, Hz
    #[arg(long, value_name = "HZ", default_value_t = 2000.0, requires = "modes", value_parser = in_unit("Hz"))]
    up_to: f64,
    /// Write the nodes of the shaft as a table: place, displacements, slopes, forces, moments, stresses (CSV)
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Write each bearing's coefficients over the speeds of --modes, or at the speed of the file, for rotor programs
    /// (CSV)
    #[arg(long, value_name = "FILE.csv")]
    ross: Option<PathBuf>,
    /// Write the bearings as springs for finite-element programs: CalculiX (.inp) or Nastran (.bdf) by the name's
    /// ending
    #[arg(long, value_name = "FILE")]
    springs: Option<PathBuf>,
    /// Write figures into this folder, as SVG and PNG
    #[arg(long, value_name = "FOLDER")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = ShaftFile::read(&arguments.path, &arguments.changes, &arguments.limits.limits())?;
    let springs = arguments.springs.as_ref().map(|path| cards::Format::of(path)).transpose()?;
    for path in [&arguments.csv, &arguments.ross, &arguments.springs].into_iter().flatten() {
        arguments.replace.check(path, &arguments.path, Ours::Table)?;
    }
    let outcome = shaft_outcome(&file, &arguments.modes, arguments.up_to)?;
    let (life, whirl) = (&outcome.life, outcome.whirl.as_ref());
    let staged = match &arguments.plot {
        Some(folder) => {
            let mut staged = StagedFiles::new(folder, arguments.replace.force)?;
            for figure in figures::figures(&file, life, whirl) {
                crate::drawn::stage(&mut staged, &figure?)?;
            }
            Some(staged)
        }
        None => None,
    };
    let write = |path: &PathBuf, text: &str| write_table(path, &arguments.path, text, &arguments.replace);
    if let Some(path) = &arguments.csv {
        write(path, &cards::stations(life))?;
    }
    if let Some(path) = &arguments.ross {
        write(path, &cards::ross(&file, life, &arguments.modes)?)?;
    }
    if let (Some(path), Some(format)) = (&arguments.springs, springs) {
        write(path, &cards::springs(&file, life, format))?;
    }
    staged.map_or(Ok(()), StagedFiles::publish)?;
    if arguments.json {
        return table::print_json(&outcome);
    }
    print::print(&file, life, whirl)
}
