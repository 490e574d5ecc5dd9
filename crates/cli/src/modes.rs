//! `tribodyn modes`: natural modes of balls, cage and rings in the steady orbit.

use crate::failure::Failure;
use crate::input::{CaseArguments, ReplaceArguments};
use crate::orbit::write_table;
use crate::search::{Search, TimeArguments};
use crate::table::{self, number};
use crate::units::in_unit;
use std::fmt::Write;
use std::path::PathBuf;
use tribodyn::answers::{Answer, ModesAnswer, modes};
use tribodyn_orbit::Mode;
use tribodyn_study::Ours;

/// Natural modes about the steady orbit: frequencies, damping ratios, shapes; and whether the orbit is stable.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn modes 7210B.ron --up-to 5000
  tribodyn modes 7210B.ron --all --csv modes.csv")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Highest frequency, Hz
    #[arg(long, default_value_t = f64::INFINITY, value_name = "HZ", value_parser = in_unit("Hz"))]
    up_to: f64,
    /// Print the modes of the balls too, for the instant when pocket 0 is at azimuth 0
    #[arg(long)]
    all: bool,
    /// Write the modes as a table (CSV)
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
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
    if let Some(path) = &arguments.csv {
        arguments.replace.check(path, &arguments.case.path, Ours::Table)?;
    }
    let search = Search::begin(&file, &arguments.time);
    let answer =
        modes(&file.question(search.watch()), arguments.up_to, arguments.all).map_err(|error| search.failed(error))?;
    drop(search);
    if let Some(path) = &arguments.csv {
        write_table(path, &arguments.case.path, &csv(&answer), &arguments.replace)?;
    }
    if arguments.json {
        return table::print_json(&answer);
    }
    table::print_head(&file.name, answer.findings())?;
    print(answer.value())?;
    table::print_warnings(answer.findings().warnings())
}

fn print(answer: &ModesAnswer) -> Result<(), Failure> {
    let translations = ["Hz", "damping", "1/s", "mostly", "ring x", "ring y", "ring z", "outer x", "outer y"];
    let tilts = tilting(answer).flat_map(|tilt| tilt.heads);
    let header: Vec<&str> = translations.into_iter().chain(tilts).chain(["ball °"]).collect();
    let rows = answer.modes.iter().map(|mode| {
        let ball = leading_ball(mode);
        let of_tilts = [mode.inner_tilt, mode.outer_tilt].into_iter().flatten().flatten();
        let ring = mode.inner_ring.into_iter().chain(mode.outer_ring).chain(of_tilts).map(|a| number(a, 3));
        [number(mode.frequency_hz, 2), number(mode.damping_ratio, 5), format!("{:.3e}", mode.growth_rate_per_s)]
            .into_iter()
            .chain([mode.energy_shares.leader().to_owned()])
            .chain(ring)
            .chain([number(ball, 1)])
            .collect::<Vec<_>>()
    });
    table::print_rows(&header, rows)?;
    let left = number(answer.multiplier, 3);
    table::print_line(&format!("\na small disturbance of a ball is {left} times as large a turn of the cage later"))?;
    Ok(())
}

/// Names of the tilts of a ring in a printed table and in a file.
struct OfTilt {
    heads: [&'static str; 2],
    columns: &'static str,
}

/// Rings that are free to tilt.
fn tilting(answer: &ModesAnswer) -> impl Iterator<Item = OfTilt> {
    let first = answer.modes.first();
    let inner = OfTilt { heads: ["tilt x", "tilt y"], columns: ",inner_tilt_x,inner_tilt_y" };
    let outer = OfTilt { heads: ["outer tilt x", "outer tilt y"], columns: ",outer_tilt_x,outer_tilt_y" };
    let inner = first.and_then(|mode| mode.inner_tilt).map(|_| inner);
    inner.into_iter().chain(first.and_then(|mode| mode.outer_tilt).map(|_| outer))
}

/// Azimuth of the ball that moves most, degrees.
fn leading_ball(mode: &Mode) -> f64 {
    let size = |ball: &[f64; 3]| ball.iter().map(|a| a * a).sum::<f64>();
    let sizes = mode.balls.iter().map(size).enumerate();
    let (index, _) = sizes.fold((0, 0.0), |best, this| if this.1 > best.1 { this } else { best });
    360.0 * index as f64 / mode.balls.len().max(1) as f64
}

fn csv(answer: &Answer<ModesAnswer>) -> String {
    let tilts: String = tilting(answer.value()).map(|tilt| tilt.columns).collect();
    let mut text = format!(
        "frequency_hz,damping_ratio,growth_rate_per_s,energy_inner_ring,energy_outer_ring,energy_balls,\
         energy_ball_rotation,energy_cage,inner_x,inner_y,inner_z,outer_x,outer_y{tilts},implausible,warnings\n"
    );
    let of = answer.findings();
    let [implausible, warnings] = [of.implausible(), of.warnings().join("; ")].map(|words| table::csv_text(&words));
    for mode in &answer.value().modes {
        let e = &mode.energy_shares;
        let numbers = [mode.frequency_hz, mode.damping_ratio, mode.growth_rate_per_s]
            .into_iter()
            .chain([e.inner_ring, e.outer_ring, e.balls, e.ball_rotation, e.cage])
            .chain(mode.inner_ring)
            .chain(mode.outer_ring)
            .chain([mode.inner_tilt, mode.outer_tilt].into_iter().flatten().flatten());
        let row: Vec<String> = numbers.map(|number| number.to_string()).collect();
        let _ = writeln!(text, "{},{implausible},{warnings}", row.join(","));
    }
    text
}
