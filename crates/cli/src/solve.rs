//! `tribodyn solve`: quasi-static equilibrium.

use crate::failure::Failure;
use crate::input::CaseFile;
use crate::table;
use std::path::{Path, PathBuf};
use tribodyn_quasistatic::{Model, OperatingPoint, Solution, solve};
use tribodyn_record::{SolutionRecording, write_solution};

/// Solve the quasi-static equilibrium of ring and balls.
#[derive(clap::Args)]
pub struct Arguments {
    /// Case file (RON)
    case: PathBuf,
    /// Equations to solve
    #[arg(long, value_enum, default_value_t = ModelName::Traction)]
    model: ModelName,
    /// Traction parameters that vary with pressure, instead of what the case says
    #[arg(long)]
    varying: Option<bool>,
    /// Differential (Heathcote) slip, instead of what the case says
    #[arg(long)]
    differential_slip: Option<bool>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Write polar plots (SVG and PNG) to this folder
    #[arg(long, value_name = "DIR")]
    plot: Option<PathBuf>,
    /// Write a recording (MCAP) of one orbit
    #[arg(short, long, value_name = "RUN.mcap")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum ModelName {
    /// Raceway control, no traction
    JonesHarris,
    /// Traction integrals of both contacts
    Traction,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut file = CaseFile::read(&arguments.case)?;
    let traction = &mut file.case.traction;
    traction.varying = arguments.varying.unwrap_or(traction.varying);
    traction.differential_slip = arguments.differential_slip.unwrap_or(traction.differential_slip);
    let bearing = file.bearing()?;
    let model = match arguments.model {
        ModelName::JonesHarris => Model::JonesHarris,
        ModelName::Traction => Model::Traction,
    };
    let solution = solve(&bearing, &OperatingPoint::new(&file.case), model)?.solution;
    if let Some(folder) = &arguments.plot {
        write_plots(folder, &solution)?;
    }
    if let Some(path) = &arguments.output {
        let recording = SolutionRecording {
            case_text: &file.text,
            case: &file.case,
            solution: &solution,
            generator: concat!("tribodyn ", env!("CARGO_PKG_VERSION")),
        };
        write_solution(path, &recording)?;
    }
    if arguments.json { table::print_json(&solution) } else { print(&file.name, &solution) }
}

fn write_plots(folder: &Path, solution: &Solution) -> Result<(), Failure> {
    let write =
        |path: PathBuf, bytes: &[u8]| std::fs::write(&path, bytes).map_err(|source| Failure::Write { path, source });
    let figures = tribodyn_plot::solution_figures(&[("this case", solution)], &[])?;
    std::fs::create_dir_all(folder).map_err(|source| Failure::Write { path: folder.to_owned(), source })?;
    for figure in figures {
        write(folder.join(format!("{}.svg", figure.name)), figure.svg().as_bytes())?;
        write(folder.join(format!("{}.png", figure.name)), &figure.png(PNG_WIDTH)?)?;
    }
    Ok(())
}

/// Wide enough for a page at 200 dots per inch.
const PNG_WIDTH: u32 = 1600;

fn print(name: &str, s: &Solution) -> Result<(), Failure> {
    let number = |v: f64, digits: usize| format!("{v:.digits$}");
    let triple = |v: [f64; 3], factor: f64, digits: usize| v.map(|c| number(c * factor, digits)).join("  ");
    let mut rows = vec![
        ("cage speed", number(s.cage_speed_rpm, 3), "r/min"),
        ("ring displacement x y z", triple(s.ring_displacement_m, 1e6, 3), "µm"),
        ("ring tilt about x y", s.ring_tilt_rad.map(|t| number(t * 1e3, 4)).join("  "), "mrad"),
        ("ring load x y z", triple(s.ring_load_n, 1.0, 2), "N"),
        ("largest relative residual", format!("{:.1e}", s.residual), ""),
        ("Newton steps", s.iterations.to_string(), ""),
    ];
    if let Some(error) = s.patch_error_estimate {
        rows.push(("shaft torque", number(s.shaft_torque_nm, 3), "N m"));
        rows.push(("patch error estimate (of load)", format!("{error:.1e}"), ""));
    }
    table::print_line(&format!("{name}\n"))?;
    table::print_pairs(&rows)?;
    table::print_line("")?;
    let header = [
        "φ °",
        "α_i °",
        "α_o °",
        "Q_i N",
        "Q_o N",
        "p_i GPa",
        "p_o GPa",
        "ω_m r/min",
        "T_i N",
        "T_o N",
        "ξ_i ‰",
        "ξ_o ‰",
    ];
    let rpm = 30.0 / std::f64::consts::PI;
    table::print_rows(
        &header,
        s.balls.iter().map(|b| {
            vec![
                number(b.azimuth_deg, 1),
                number(b.contact_angle_inner_deg, 3),
                number(b.contact_angle_outer_deg, 3),
                number(b.load_inner_n, 1),
                number(b.load_outer_n, 1),
                number(b.peak_pressure_inner_pa * 1e-9, 3),
                number(b.peak_pressure_outer_pa * 1e-9, 3),
                number(b.orbital_speed_rad_s * rpm, 2),
                number(b.traction_inner_n, 1),
                number(b.traction_outer_n, 1),
                number(b.slide_to_roll_inner * 1e3, 3),
                number(b.slide_to_roll_outer * 1e3, 3),
            ]
        }),
    )?;
    for warning in &s.warnings {
        table::print_line(&format!("warning: {warning}"))?;
    }
    Ok(())
}
