//! `tribodyn life`: how long a coating lasts.

mod acting;

use crate::failure::Failure;
use crate::input::{CaseArguments, ReplaceArguments};
use crate::search::Search;
use crate::solve::ModelName;
use crate::table::{self, number};
use std::ops::ControlFlow;
use std::path::PathBuf;
use tribodyn_study::{Life, LifeEnd, LifeOptions, LifeStride, LifeTable, Ours, wear_life};

/// Wear the raceways of a bearing until a coating is through, or wear has added a clearance that is given.
///
/// The fatigue life of its steel is another question: `tribodyn rating` answers it.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn life 7210B.ron -o life.csv
  tribodyn life 6206.ron --model traction --strides 10 --until 5000")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Equations to solve at each stride
    #[arg(long, value_enum, default_value_t)]
    model: ModelName,
    /// Number of strides until a new coating is worn through, or the clearance limit reached; the error falls in
    /// proportion
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    strides: u32,
    /// End after this running time, h
    #[arg(long, value_name = "HOURS", value_parser = hours)]
    until: Option<f64>,
    /// End when wear has added this much radial internal clearance, µm, on the diameter as in ISO 5753; for races
    /// without coating
    #[arg(long, value_name = "UM", value_parser = micrometres)]
    clearance_limit: Option<f64>,
    /// Let wear act on the bearing: clearance, curvature, traction, transfer, separated by commas, or none. Keeps the
    /// depth over azimuth and across the groove; the life ends when bare steel carries a part of the load
    #[arg(long, value_name = "EFFECTS", value_delimiter = ',', conflicts_with_all = ["clearance_limit", "restart"])]
    acting: Option<Vec<String>>,
    /// Repeat the phases of this table (with --acting): durations in a column s, min or h, then values of the case by
    /// their paths
    #[arg(long, value_name = "TABLE", requires = "acting")]
    mission: Option<PathBuf>,
    /// With --acting: part of a race's load on bare steel at which the life ends [default: 0.5]
    #[arg(long, value_name = "PART", requires = "acting", value_parser = part)]
    bare_limit: Option<f64>,
    /// Write a table of the worn cells of both grooves at the end, .parquet or .csv (with --acting)
    #[arg(long, value_name = "TABLE", requires = "acting")]
    map: Option<PathBuf>,
    /// Table to write, .parquet or .csv by its name: a row for each stride. The same command continues a stopped one
    #[arg(short, long, value_name = "TABLE")]
    output: Option<PathBuf>,
    /// Discard the finished strides of a stopped life
    #[arg(long, requires = "output")]
    restart: bool,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

fn hours(text: &str) -> Result<f64, String> {
    above_0(text).ok_or_else(|| "allowed is a number of hours above 0".to_owned())
}

fn micrometres(text: &str) -> Result<f64, String> {
    above_0(text).ok_or_else(|| "allowed is a number of um above 0".to_owned())
}

fn part(text: &str) -> Result<f64, String> {
    above_0(text).filter(|part| *part <= 1.0).ok_or_else(|| "allowed is a number above 0, at most 1".to_owned())
}

fn above_0(text: &str) -> Option<f64> {
    text.parse().ok().filter(|value: &f64| *value > 0.0 && value.is_finite())
}

const HOUR: f64 = 3600.0;

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    if let Some(effects) = &arguments.acting {
        return acting::run(arguments, effects, &file);
    }
    let search = Search::of_strides(&file);
    let options = LifeOptions {
        strides: arguments.strides,
        until_s: arguments.until.map(|hours| hours * HOUR),
        clearance_limit_m: arguments.clearance_limit.map(|um| um * 1e-6),
        equations: arguments.model.equations(),
        watch: search.watch(),
    };
    let stride = |_: &LifeStride| {
        search.stride();
        ControlFlow::Continue(())
    };
    let life = match &arguments.output {
        None => wear_life(&file, options, stride)?,
        Some(path) => {
            arguments.replace.check(path, &arguments.case.path, Ours::Table)?;
            let mut table = LifeTable::open(&file, options, path, arguments.restart)?;
            let life = table.wear(stride)?;
            table.write(&life)?;
            life
        }
    };
    drop(search);
    if arguments.json {
        return table::print_json(&life);
    }
    print(&life)?;
    arguments.output.as_ref().map_or(Ok(()), |path| table::print_line(&format!("\n{} is written", path.display())))
}

const HEADER: [&str; 11] = [
    "turns",
    "h_i µm",
    "h_o µm",
    "ΔP_d µm",
    "α_0 °",
    "α_i °",
    "α_o °",
    "p_i GPa",
    "ω_c r/min",
    "w_i µm³/s",
    "w_o µm³/s",
];

fn print(a: &Life) -> Result<(), Failure> {
    table::print_line(&format!("{}: {}\n", a.case, crate::harmless::visible(&a.bearing)))?;
    // Lives go from seconds to months.
    let (unit, per_hour) = if a.end_h < 1.0 { ("s", HOUR) } else { ("h", 1.0) };
    let time = |hours: f64| number(hours * per_hour, 2);
    let range = |least: f64, most: f64| format!("{} – {}", number(least, 2), number(most, 2));
    let row = |r: &LifeStride| {
        vec![
            time(r.time_h),
            format!("{:.4e}", r.revolutions),
            number(r.coating_inner_min_um, 3),
            number(r.coating_outer_min_um, 3),
            number(r.clearance_growth_um, 3),
            number(r.contact_angle_free_deg, 3),
            range(r.contact_angle_inner_min_deg, r.contact_angle_inner_max_deg),
            range(r.contact_angle_outer_min_deg, r.contact_angle_outer_max_deg),
            number(r.peak_pressure_inner_max_gpa, 3),
            number(r.cage_speed_rpm, 2),
            format!("{:.4e}", r.wear_rate_inner_um3_s),
            format!("{:.4e}", r.wear_rate_outer_um3_s),
        ]
    };
    let first = format!("time {unit}");
    let header: Vec<&str> = std::iter::once(first.as_str()).chain(HEADER).collect();
    table::print_rows(&header, a.strides.iter().map(row))?;
    table::print_line("")?;
    let end = ending(a);
    if let Some(hours) = a.steel_shows_h {
        table::print_line(&format!("after {} {unit} steel shows in the middle of a track", time(hours)))?;
    }
    table::print_line(&format!("after {} {unit}, {:.4e} turns: {end}", time(a.end_h), a.end_revolutions))?;
    for warning in &a.warnings {
        table::print_line(&format!("warning: {warning}"))?;
    }
    Ok(())
}

fn ending(a: &Life) -> String {
    let growth = a.strides.last().map_or(0.0, |end| end.clearance_growth_um);
    match (a.ended_by, &a.worn_through[..]) {
        (LifeEnd::ClearanceLimit, _) => format!("wear has added the clearance limit of {} µm", number(growth, 2)),
        (LifeEnd::Grooves, _) => format!("wear has added {} µm of clearance", number(growth, 2)),
        (_, []) => "no coating is through".to_owned(),
        (_, [race]) => format!("the coating of the {race} race is through"),
        _ => "both coatings are through".to_owned(),
    }
}
