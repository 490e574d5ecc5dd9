//! `tribodyn solve`: quasi-static equilibrium, or the steady orbit.

use crate::drawn;
use crate::failure::Failure;
use crate::input::{CaseArguments, ReplaceArguments};
use crate::orbit;
use crate::search::{Search, TimeArguments};
use crate::table::{self, number};
use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::{Path, PathBuf};
use tribodyn::answers::{Equations, Equilibrium, OrbitAnswer, equilibrium};
use tribodyn::{CaseFile, Change};
use tribodyn_quasistatic::{BallResult, BallRoots, Model, Root, Solution};
use tribodyn_record::{SolutionRecording, write_solution};
use tribodyn_study::StagedFiles;

/// Solve the quasi-static equilibrium of ring and balls, or their steady orbit.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn solve 7210B.ron
  tribodyn solve 7210B.ron --model jones-harris --plot figures
  tribodyn solve 7210B.ron --set 'ring.z.Force=kN(6)' -o orbit.mcap
  tribodyn solve fixtures/cases/paper-ag.ron --varying false --json")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Equations to solve
    #[arg(long, value_enum, default_value_t)]
    model: ModelName,
    /// Let traction parameters vary with pressure; short for --set traction.varying=…
    #[arg(long, value_name = "BOOL")]
    varying: Option<bool>,
    /// Take differential (Heathcote) slip into account; short for --set traction.differential_slip=…
    #[arg(long, value_name = "BOOL")]
    differential_slip: Option<bool>,
    /// Search each ball for other equilibria too, with the ring fixed; takes as long as a dozen solutions
    #[arg(long)]
    roots: bool,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
    /// Write figures over the azimuth (SVG and PNG) to this folder
    #[arg(long, value_name = "DIR")]
    plot: Option<PathBuf>,
    /// Write a recording (MCAP, opens in Foxglove) of one orbit
    #[arg(short, long, value_name = "RUN.mcap")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    #[command(flatten)]
    time: TimeArguments,
}

/// Equations of an operating point; the steady orbit where nobody asks for others.
#[derive(Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub enum ModelName {
    /// Raceway control, no traction
    JonesHarris,
    /// Traction integrals of both contacts
    Traction,
    /// The periodic motion of balls and cage that a run settles to
    #[default]
    SteadyOrbit,
}

impl ModelName {
    /// The equations as the library knows them.
    pub fn equations(self) -> Equations {
        match self {
            Self::JonesHarris => Equations::JonesHarris,
            Self::Traction => Equations::Traction,
            Self::SteadyOrbit => Equations::SteadyOrbit,
        }
    }
}

/// The equations of an answer that needs friction.
#[derive(clap::Args)]
pub struct FrictionArguments {
    /// Equations to solve
    #[arg(long, value_enum, default_value_t, value_parser = with_friction())]
    model: ModelName,
}

impl FrictionArguments {
    /// The equations as the library knows them.
    pub fn equations(&self) -> Equations {
        self.model.equations()
    }
}

/// Offers the models with friction; the others are read too, so that the answer says what they lack.
fn with_friction() -> impl TypedValueParser<Value = ModelName> {
    let values = ModelName::value_variants().iter().filter_map(|model| {
        let without = model.equations() == Equations::JonesHarris;
        Some(model.to_possible_value()?.hide(without))
    });
    PossibleValuesParser::new(values).try_map(|name| ModelName::from_str(&name, false))
}

impl Arguments {
    /// The case with its changes; an option of dry traction is refused where the case has none.
    fn read(&self) -> Result<CaseFile, Failure> {
        let own = [("varying", self.varying), ("differential-slip", self.differential_slip)];
        if let Some((option, value)) = own.into_iter().find_map(|(option, value)| Some((option, value?))) {
            let plain = self.case.read()?.case;
            if plain.traction.is_none() {
                let is = if plain.lubricant.is_some() { "is lubricated and " } else { "" };
                let message = format!("the case {is}has no coating, and this is a choice of solid films (`traction`)");
                return Err(Failure::Option { option, value: value.to_string(), message });
            }
        }
        Ok(self.case.read_with(&self.changes())?)
    }

    /// The changes to the case: those of `--set`, then those with an option of their own.
    fn changes(&self) -> Vec<Change> {
        let own = |name: &str, path, value: Option<bool>| {
            value.map(|v| Change::new(format!("--{name} {v}"), path, &v.to_string()))
        };
        let varying = own("varying", "traction.varying", self.varying);
        let slip = own("differential-slip", "traction.differential_slip", self.differential_slip);
        self.case.changes.iter().cloned().chain(varying).chain(slip).collect()
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.read()?;
    if let Some(path) = &arguments.output {
        arguments.replace.check_recording(path, &arguments.case.path, &file)?;
    }
    let Some(model) = arguments.model.equations().equilibrium() else { return orbit(arguments, &file) };
    let search = Search::begin(&file, &arguments.time);
    let answer = equilibrium(&file.question(search.watch()), model, arguments.roots).map_err(|e| search.failed(e))?;
    drop(search);
    let solution = &answer.solution;
    let plots =
        arguments.plot.as_ref().map(|folder| stage_plots(folder, arguments.replace.force, solution)).transpose()?;
    if let Some(path) = &arguments.output {
        record(path, &file, solution)?;
    }
    plots.map_or(Ok(()), StagedFiles::publish)?;
    if arguments.json {
        return table::print_json(&answer);
    }
    print(&file.name, &answer)?;
    answer.roots.as_deref().map_or(Ok(()), print_roots)
}

/// The steady orbit: figures of a ball round it, a recording of the balls where an equilibrium has them.
fn orbit(arguments: &Arguments, file: &CaseFile) -> Result<(), Failure> {
    if arguments.roots {
        let message = "the steady orbit is not searched for other equilibria; `--model traction` is".to_owned();
        return Err(Failure::Option { option: "roots", value: "with --model steady-orbit".to_owned(), message });
    }
    let search = Search::begin(file, &arguments.time);
    let answer = OrbitAnswer::with_sensitivities(&file.question(search.watch()));
    let answer = answer.map_err(|error| search.failed(error))?;
    drop(search);
    let plots = arguments.plot.as_ref();
    let plots = plots.map(|folder| stage_plots(folder, arguments.replace.force, &answer.round)).transpose()?;
    if let Some(path) = &arguments.output {
        record(path, file, &answer.solution)?;
    }
    plots.map_or(Ok(()), StagedFiles::publish)?;
    if arguments.json {
        return table::print_json(&answer);
    }
    let columns = [&HEADER[..], &["F_c N"]].concat();
    orbit::print(&file.name, &answer, |balls| {
        let row = |b: &BallResult| {
            ball_row(b).into_iter().chain([b.pocket.map_or_else(String::new, |p| number(p.force_n, 1))]).collect()
        };
        table::print_rows(&columns, balls.iter().map(row))
    })
}

/// Records one orbit of what was solved.
fn record(path: &Path, file: &CaseFile, solution: &Solution) -> Result<(), Failure> {
    let recording = SolutionRecording {
        case_text: &file.text,
        name: &file.case.name,
        bearing: &file.bearing()?,
        point: &file.case.operating_point(),
        solution,
        generator: concat!("tribodyn ", env!("CARGO_PKG_VERSION")),
    };
    write_solution(path, &recording)?;
    Ok(())
}

fn stage_plots(folder: &Path, force: bool, solution: &Solution) -> Result<StagedFiles, Failure> {
    let figures = tribodyn_plot::solution_figures(&[("this case", solution)], &[])?;
    let mut staged = StagedFiles::new(folder, force)?;
    figures.iter().try_for_each(|figure| drawn::stage(&mut staged, figure))?;
    Ok(staged)
}

fn print(name: &str, answer: &Equilibrium) -> Result<(), Failure> {
    let s = &answer.solution;
    let triple = |v: [f64; 3], factor: f64, digits: usize| v.map(|c| number(c * factor, digits)).join("  ");
    let mut rows = vec![
        ("cage speed", number(s.cage_speed_rpm, 3), "r/min"),
        ("ring displacement x y z", triple(s.ring_displacement_m, 1e6, 3), "µm"),
        ("ring tilt about x y", s.ring_tilt_rad.map(|t| number(t * 1e3, 4)).join("  "), "mrad"),
        ("ring load x y z", triple(s.ring_load_n, 1.0, 2), "N"),
        ("largest relative residual", format!("{:.1e}", s.residual), ""),
        ("Newton steps", s.iterations.to_string(), ""),
    ];
    if let Some(torque) = s.shaft_torque_nm {
        rows.push(("shaft torque", number(torque, 3), "N m"));
    }
    if let Some(error) = s.patch_error_estimate {
        rows.push(("patch error estimate (of load)", format!("{error:.1e}"), ""));
    }
    table::print_head(name, &answer.findings)?;
    table::print_pairs(&rows)?;
    table::print_line("")?;
    // Jones–Harris says nothing about traction and slip.
    let columns = if s.model == Model::JonesHarris { HEADER.len() - 4 } else { HEADER.len() };
    let row = |b| ball_row(b).into_iter().take(columns).collect();
    table::print_rows(&HEADER[..columns], s.balls.iter().map(row))?;
    table::print_warnings(&s.warnings)
}

/// Columns of the table of balls; the last four belong to traction.
const HEADER: [&str; 12] =
    ["φ °", "α_i °", "α_o °", "Q_i N", "Q_o N", "p_i GPa", "p_o GPa", "ω_m r/min", "T_i N", "T_o N", "ξ_i ‰", "ξ_o ‰"];

fn ball_row(b: &BallResult) -> [String; HEADER.len()] {
    [
        number(b.azimuth_rad.to_degrees(), 1),
        number(b.contacts.inner.angle_rad.to_degrees(), 3),
        number(b.contacts.outer.angle_rad.to_degrees(), 3),
        number(b.contacts.inner.load_n, 1),
        number(b.contacts.outer.load_n, 1),
        number(b.contacts.inner.peak_pressure_pa * 1e-9, 3),
        number(b.contacts.outer.peak_pressure_pa * 1e-9, 3),
        number(b.orbital_speed_rad_s * 30.0 / std::f64::consts::PI, 2),
        number(b.contacts.inner.friction_or_nan().traction_n[0], 1),
        number(b.contacts.outer.friction_or_nan().traction_n[0], 1),
        number(b.contacts.inner.friction_or_nan().slide_to_roll[0] * 1e3, 3),
        number(b.contacts.outer.friction_or_nan().slide_to_roll[0] * 1e3, 3),
    ]
}

/// One line for each equilibrium, the solution's first.
fn print_roots(roots: &[BallRoots]) -> Result<(), Failure> {
    let header = ["φ °", "equilibrium", "ω_m r/min", "ξ_i ‰", "ξ_o ‰", "growth 1/s", "stable"];
    let row = |azimuth: f64, name: &str, root: &Root| {
        vec![
            number(azimuth, 1),
            name.to_owned(),
            number(root.orbital_speed_rad_s * 30.0 / std::f64::consts::PI, 2),
            number(root.slide_to_roll_inner * 1e3, 3),
            number(root.slide_to_roll_outer * 1e3, 3),
            root.growth_rate_per_s.map_or_else(|| "–".to_owned(), |rate| format!("{rate:.3e}")),
            if root.stable() { "yes" } else { "no" }.to_owned(),
        ]
    };
    let rows = roots.iter().flat_map(|ball| {
        let name = if ball.solution.driven { "solution" } else { "solution, not driven" };
        let others = ball.others.iter().map(|root| row(ball.azimuth_deg, "other", root));
        std::iter::once(row(ball.azimuth_deg, name, &ball.solution)).chain(others).collect::<Vec<_>>()
    });
    table::print_line("")?;
    table::print_rows(&header, rows)
}
