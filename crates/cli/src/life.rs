//! `tribodyn life`: how long a coating lasts.

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::solve::ModelName;
use crate::table::{self, number};
use std::ops::ControlFlow;
use tribodyn_study::{Life, LifeOptions, LifeStride, wear_life};

/// Wear the coatings of a bearing until one is through.
///
/// The fatigue life of its steel is another question: `tribodyn rating` answers it.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Equations of each stride
    #[arg(long, value_enum, default_value_t = ModelName::SteadyOrbit)]
    model: ModelName,
    /// Strides in which a new coating is worn away at its fastest spot; the error falls in proportion to their number
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    strides: u32,
    /// End after this running time in h, should the coatings last longer
    #[arg(long, value_name = "HOURS", value_parser = hours, allow_negative_numbers = true)]
    until: Option<f64>,
    /// Print JSON, and nothing else, to standard output
    #[arg(long)]
    json: bool,
}

fn hours(text: &str) -> Result<f64, String> {
    let value = text.parse().ok().filter(|hours: &f64| *hours > 0.0 && hours.is_finite());
    value.ok_or_else(|| "allowed is a number of hours above 0".to_owned())
}

const HOUR: f64 = 3600.0;

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let options = LifeOptions {
        strides: arguments.strides,
        until_s: arguments.until.map(|hours| hours * HOUR),
        equations: arguments.model.equations(),
    };
    let life = wear_life(&file, options, |_| ControlFlow::Continue(()))?;
    if arguments.json { table::print_json(&life) } else { print(&life) }
}

const HEADER: [&str; 10] =
    ["turns", "h_i µm", "h_o µm", "α_0 °", "α_i °", "α_o °", "p_i GPa", "ω_c r/min", "w_i µm³/s", "w_o µm³/s"];

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
    let end = match a.worn_through[..] {
        [] => "no coating is through".to_owned(),
        [race] => format!("the coating of the {race} race is through"),
        _ => "both coatings are through".to_owned(),
    };
    if let Some(hours) = a.steel_shows_h {
        table::print_line(&format!("after {} {unit} steel shows in the middle of a track", time(hours)))?;
    }
    table::print_line(&format!("after {} {unit}, {:.4e} turns: {end}", time(a.end_h), a.end_revolutions))?;
    for warning in &a.warnings {
        table::print_line(&format!("warning: {warning}"))?;
    }
    Ok(())
}
