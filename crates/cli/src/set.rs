//! `tribodyn set`: bearings side by side, pressed against each other.

use crate::drawn;
use crate::failure::Failure;
use crate::input::{FitArguments, LimitArguments, ReplaceArguments, change};
use crate::table::{self, number};
use crate::units::in_unit;
use std::path::PathBuf;
use tribodyn::Change;
use tribodyn_plot::{Axis, Figure, LineChart, Panel, Series};
use tribodyn_study::StagedFiles;
use tribodyn_study::preload::{SetAnswer, SetPoint, SetPreload, SetQuestion, bearing_set, pressed, sides};
use tribodyn_study::shaft::named_case;

/// Preload, unloading force and axial rigidity of a set of like bearings, and its displacement under axial load.
///
/// Speed, fits and temperatures are those of the case. With radial loads and moments use `pair` or `shaft`.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn set 7012C --arrangement DB --preload 200
  tribodyn set spindle.ron --arrangement QBC --preload 300 --given mounted --loads 0,500,1000
  tribodyn set 7012C/P4 --arrangement DB --preload 200 --shaft-fit h4
  tribodyn set 7012C/P4 --arrangement QBC --preload 300 --shaft-fit js4 --speeds 0,6000,12000 --warmer 0,5,10
  tribodyn set 7210B --sides +-- --offset 5")]
pub struct Arguments {
    /// Designation from the catalogue, such as 7012C, for a bearing at rest, or a case file (RON)
    #[arg(value_name = "BEARING")]
    bearing: String,
    /// Replace one value of the case, such as 'speed.inner=Constant(rpm(8000))'; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = change)]
    changes: Vec<Change>,
    #[command(flatten)]
    fits: FitArguments,
    #[command(flatten)]
    limits: LimitArguments,
    /// Arrangement: DB, DF, DT, TBT, TFT, TT, QBC, QFC, QBT or QT
    #[arg(long, value_name = "NAME", required_unless_present = "sides")]
    arrangement: Option<String>,
    /// Direction of thrust that each bearing carries, from −z to +z, such as ++- for two against one
    #[arg(long, value_name = "SIGNS", conflicts_with = "arrangement", allow_hyphen_values = true)]
    sides: Option<String>,
    /// Preload, N; a set that carries one way only, as DT, has none
    #[arg(long, value_name = "N", value_parser = in_unit("N"))]
    preload: Option<f64>,
    /// Condition for which the preload is given
    #[arg(long, value_enum, default_value_t = Given::Unmounted, requires = "preload")]
    given: Given,
    /// Axial displacement that preloads each bearing off the shaft, µm
    #[arg(long, value_name = "UM", allow_hyphen_values = true, conflicts_with = "preload", value_parser = in_unit("um"))]
    offset: Option<f64>,
    /// Force of a soft spring in place of the bearings that carry −z, N
    #[arg(long, value_name = "N", conflicts_with_all = ["preload", "offset"], value_parser = in_unit("N"))]
    spring: Option<f64>,
    /// Axial loads along +z, N, as N,N,… [default: up to the unloading force]
    #[arg(long, value_name = "N", value_delimiter = ',', allow_hyphen_values = true, value_parser = in_unit("N"))]
    loads: Vec<f64>,
    /// Speeds of a map of the preload, r/min, as RPM,RPM,…
    #[arg(long, value_name = "RPM", value_delimiter = ',', allow_hyphen_values = true)]
    speeds: Vec<f64>,
    /// Temperatures of shaft and inner ring above those of the case for the map, K, as K,K,…; balls get half of it
    #[arg(long, value_name = "K", value_delimiter = ',', allow_hyphen_values = true)]
    warmer: Vec<f64>,
    /// Write figures of the displacement under load and of the map into this folder, as SVG and PNG
    #[arg(long, value_name = "FOLDER")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
enum Given {
    /// Off the shaft, as catalogues have it
    Unmounted,
    /// Mounted, at rest and cold
    Mounted,
    /// At the speed and the temperatures of the case
    Running,
}

impl Given {
    fn condition(self) -> fn(f64) -> SetPreload {
        match self {
            Self::Unmounted => SetPreload::UnmountedN,
            Self::Mounted => SetPreload::MountedN,
            Self::Running => SetPreload::RunningN,
        }
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let listed = tribodyn_catalogue::Given { fits: arguments.fits.fits(), ..Default::default() };
    let case = named_case(&arguments.bearing, listed, &arguments.changes, &arguments.limits.limits())?;
    let sides = sides(arguments.arrangement.as_deref(), arguments.sides.as_deref())?;
    let force = arguments.preload.map(|force| (force, arguments.given.condition()));
    let question = SetQuestion {
        preload: pressed(&sides, force, arguments.offset, arguments.spring)?,
        sides,
        loads: finite("loads", &arguments.loads, f64::is_finite, "finite loads in N")?,
        speeds_rpm: finite(
            "speeds",
            &arguments.speeds,
            |rpm| rpm.is_finite() && rpm >= 0.0,
            "speeds of 0 r/min or more",
        )?,
        warmer_k: finite("warmer", &arguments.warmer, f64::is_finite, "finite temperatures in K")?,
    };
    let answer = bearing_set(&arguments.bearing, &case, &question)?;
    if let Some(folder) = &arguments.plot {
        let mut staged = StagedFiles::new(folder, arguments.replace.force)?;
        drawn::stage(&mut staged, &figure(&arguments.bearing, &answer)?)?;
        if !answer.map.is_empty() {
            drawn::stage(&mut staged, &map_figure(&arguments.bearing, &answer)?)?;
        }
        staged.publish()?;
    }
    if arguments.json {
        return table::print_json(&answer);
    }
    print(&arguments.bearing, &answer)
}

fn finite(option: &'static str, all: &[f64], rule: fn(f64) -> bool, allowed: &str) -> Result<Vec<f64>, Failure> {
    match all.iter().find(|value| !rule(**value)) {
        Some(value) => {
            let message = format!("allowed are {allowed}");
            Err(Failure::Option { option, value: value.to_string(), message })
        }
        None => Ok(all.to_vec()),
    }
}

fn print(name: &str, answer: &SetAnswer) -> Result<(), Failure> {
    table::print_line(&format!("{name}\n"))?;
    let optional = |value: Option<f64>, digits: usize| value.map_or_else(|| "–".to_owned(), |v| number(v, digits));
    let header = ["condition", "r/min", "preload N", "rigidity N/µm", "unloading +z N", "−z N", "over preload"];
    table::print_rows(
        &header,
        answer.conditions.iter().map(|c| {
            vec![
                c.condition.to_owned(),
                number(c.speed_rpm, 0),
                number(c.preload_n, 1),
                number(c.rigidity_n_per_m * 1e-6, 2),
                optional(c.unloading_force_n[0], 1),
                optional(c.unloading_force_n[1], 1),
                optional(c.unloading_over_preload[0], 3),
            ]
        }),
    )?;
    let offsets = answer.offset_m.iter().map(|offset| number(offset * 1e6, 3)).collect::<Vec<_>>().join("  ");
    table::print_line(&format!("\neach bearing pressed in off the shaft, µm: {offsets}\n"))?;
    if !answer.map.is_empty() {
        let header = ["r/min", "warmer by K", "preload N", "rigidity N/µm", "unloading +z N", "−z N"];
        table::print_rows(
            &header,
            answer.map.iter().map(|p| {
                vec![
                    number(p.speed_rpm, 0),
                    number(p.warmer_k, 1),
                    number(p.preload_n, 1),
                    number(p.rigidity_n_per_m * 1e-6, 2),
                    optional(p.unloading_force_n[0], 1),
                    optional(p.unloading_force_n[1], 1),
                ]
            }),
        )?;
        table::print_line("")?;
    }
    let header = ["load N", "displacement µm", "rigidity N/µm", "axial force on each bearing N"];
    table::print_rows(
        &header,
        answer.states.iter().map(|s| {
            vec![
                number(s.load_n, 1),
                number(s.displacement_m * 1e6, 3),
                number(s.rigidity_n_per_m * 1e-6, 2),
                s.bearing_force_n.iter().map(|force| number(*force, 1)).collect::<Vec<_>>().join("  "),
            ]
        }),
    )?;
    table::print_warnings(&answer.warnings)
}

fn figure(name: &str, answer: &SetAnswer) -> Result<Figure, Failure> {
    let of = |value: &dyn Fn(&tribodyn_study::preload::SetState) -> f64| {
        answer.states.iter().map(|s| (s.load_n, value(s))).collect()
    };
    let load = || Axis::new("Axial load", "N");
    let moved = Series::line("displacement", of(&|s| 1e6 * s.displacement_m));
    let rigid = Series::line("rigidity", of(&|s| 1e-6 * s.rigidity_n_per_m));
    let panels = [
        Panel::Cartesian(LineChart::new("Displacement", load(), Axis::new("Displacement", "µm"), vec![moved])),
        Panel::Cartesian(LineChart::new("Rigidity", load(), Axis::new("Axial rigidity", "N/µm"), vec![rigid])),
    ];
    Ok(Figure::new("set", format!("Set of {name}"), &panels)?)
}

/// Preload and rigidity over speed, a line for each temperature.
fn map_figure(name: &str, answer: &SetAnswer) -> Result<Figure, Failure> {
    let mut rises: Vec<f64> = answer.map.iter().map(|point| point.warmer_k).collect();
    rises.dedup();
    let lines = |value: &dyn Fn(&SetPoint) -> f64| -> Vec<Series> {
        let of = |kelvin: f64| answer.map.iter().filter(move |point| point.warmer_k == kelvin);
        let line = |kelvin: f64| of(kelvin).map(|point| (point.speed_rpm, value(point))).collect();
        rises.iter().map(|&kelvin| Series::line(format!("{} K warmer", number(kelvin, 1)), line(kelvin))).collect()
    };
    let speed = || Axis::new("Speed", "r/min");
    let preload = lines(&|point| point.preload_n);
    let rigidity = lines(&|point| 1e-6 * point.rigidity_n_per_m);
    let panels = [
        Panel::Cartesian(LineChart::new("Preload", speed(), Axis::new("Preload", "N"), preload)),
        Panel::Cartesian(LineChart::new("Rigidity", speed(), Axis::new("Axial rigidity", "N/µm"), rigidity)),
    ];
    Ok(Figure::new("set-map", format!("Preload of {name}"), &panels)?)
}
