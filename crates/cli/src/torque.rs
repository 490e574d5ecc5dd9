//! `tribodyn torque`: friction torque by cause.

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::search::{Search, TimeArguments};
use crate::solve::FrictionArguments;
use crate::table::{self, number};
use tribodyn::answers::{TorqueAnswer, torque};

/// Friction torque of a bearing by cause, beside SKF's model and Palmgren's formula.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn torque 6206.ron
  tribodyn torque fixtures/cases/oil-6206.ron --json")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    #[command(flatten)]
    time: TimeArguments,
    #[command(flatten)]
    model: FrictionArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let search = Search::begin(&file, &arguments.time);
    let answer =
        torque(&file.question(search.watch()), arguments.model.equations()).map_err(|error| search.failed(error))?;
    drop(search);
    if arguments.json {
        return table::print_json(&answer);
    }
    let (findings, found) = (answer.findings(), answer.value());
    table::print_head(&format!("{}: {}", file.name, crate::harmless::visible(&file.case.name)), findings)?;
    let loads = format!("{}  {}", number(found.radial_load_n, 1), number(found.axial_load_n, 1));
    table::print_pairs(&[
        ("speed", number(found.speed_rpm, 1), "r/min"),
        ("loads, radial axial", loads, "N"),
        ("friction power", number(found.torque_nm * found.speed_rpm * std::f64::consts::PI / 30.0, 2), "W"),
    ])?;
    table::print_line("")?;
    table::print_rows(&["torque, N mm", "tribodyn", "SKF", "Palmgren"], rows(found).into_iter())?;
    for note in &found.notes {
        table::print_line(&format!("note: {note}"))?;
    }
    table::print_warnings(findings.warnings())
}

fn rows(t: &TorqueAnswer) -> Vec<Vec<String>> {
    let shown = |torque: Option<f64>| torque.map_or_else(|| "-".to_owned(), |torque| number(torque * 1e3, 3));
    let row = |name: &str, ours: Option<f64>, skf: Option<f64>, palmgren: Option<f64>| {
        vec![name.to_owned(), shown(ours), shown(skf), shown(palmgren)]
    };
    vec![
        row("rolling; of the lubricant", Some(t.rolling_nm), t.skf_rolling_nm, t.palmgren_viscous_nm),
        row("hysteresis of the steel", Some(t.hysteresis_nm), None, None),
        row(
            "sliding; of the load",
            Some(t.sliding_inner_nm + t.sliding_outer_nm),
            t.skf_sliding_nm,
            t.palmgren_load_nm,
        ),
        row("  at the inner race", Some(t.sliding_inner_nm), None, None),
        row("  at the outer race", Some(t.sliding_outer_nm), None, None),
        row("drag and churning", Some(t.fluid_nm), None, None),
        row("cage", Some(t.cage_nm), None, None),
        row("sum", Some(t.torque_nm), t.skf_torque_nm, t.palmgren_torque_nm),
    ]
}
