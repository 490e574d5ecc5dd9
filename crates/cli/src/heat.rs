//! `tribodyn heat`: temperatures of a bearing from its friction.

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::search::{Search, TimeArguments};
use crate::solve::FrictionArguments;
use crate::table::{self, number};
use crate::units::in_unit;
use tribodyn::answers::{HeatAnswer, Surroundings, heat};

/// Temperatures of a lubricated bearing in steady state: its friction heats it, and what is warmer has other films,
/// friction and clearance.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn heat 6206-2RS.ron
  tribodyn heat 6206.ron --surroundings 40 --cooling 0.5
  tribodyn heat spindle.ron --oil-flow 0.8 --json")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    #[command(flatten)]
    time: TimeArguments,
    /// Temperature of the surroundings and of the oil that flows in, °C
    #[arg(long, value_name = "DEG_C", default_value_t = 20.0, value_parser = in_unit("degC"))]
    surroundings: f64,
    /// Factor on the conductances of shaft and housing to the surroundings, 1 for the reference of ISO 15312
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    cooling: f64,
    /// Width of the bearing, mm [default: half of D − d]
    #[arg(long, value_name = "MM", value_parser = in_unit("mm"))]
    width: Option<f64>,
    /// Oil that flows through the bearing, l/min
    #[arg(long, value_name = "L_PER_MIN", default_value_t = 0.0)]
    oil_flow: f64,
    #[command(flatten)]
    model: FrictionArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let surroundings = Surroundings {
        temperature_deg_c: arguments.surroundings,
        cooling: arguments.cooling,
        width_mm: arguments.width,
        oil_flow_l_min: arguments.oil_flow,
    };
    let file = arguments.case.read()?;
    let search = Search::begin(&file, &arguments.time);
    let answer = heat(&file.question(search.watch()), arguments.model.equations(), &surroundings)
        .map_err(|error| search.failed(error))?;
    drop(search);
    if arguments.json {
        return table::print_json(&answer);
    }
    let (findings, found) = (answer.findings(), answer.value());
    table::print_head(&format!("{}: {}", file.name, crate::harmless::visible(&file.case.name)), findings)?;
    table::print_pairs(&pairs(found))?;
    for note in &found.notes {
        table::print_line(&format!("note: {note}"))?;
    }
    table::print_warnings(findings.warnings())
}

fn pairs(found: &HeatAnswer) -> [(&'static str, String, &'static str); 13] {
    let ways = [found.heat_shaft_w, found.heat_housing_w, found.heat_oil_w].map(|power| number(power, 2)).join("  ");
    [
        ("inner ring", number(found.inner_temperature_deg_c, 1), "°C"),
        ("balls", number(found.ball_temperature_deg_c, 1), "°C"),
        ("outer ring", number(found.outer_temperature_deg_c, 1), "°C"),
        ("oil or grease", number(found.oil_temperature_deg_c, 1), "°C"),
        ("housing", number(found.housing_temperature_deg_c, 1), "°C"),
        ("films at their inlets", number(found.film_inlet_temperature_deg_c, 1), "°C"),
        ("viscosity there", number(found.kinematic_viscosity_mm2_s, 2), "mm²/s"),
        ("friction torque", number(found.torque_nm * 1e3, 2), "N mm"),
        ("friction power", number(found.friction_power_w, 2), "W"),
        ("heat by shaft, housing, oil flow", ways, "W"),
        ("radial clearance (diametral)", number(found.radial_clearance_m * 1e6, 2), "µm"),
        (
            "ball temperature over outer ring",
            number(found.ball_temperature_deg_c - found.outer_temperature_deg_c, 2),
            "K",
        ),
        ("solutions", found.rounds.to_string(), ""),
    ]
}
