//! `tribodyn modes`: natural modes of balls, cage and rings in the steady orbit.

use crate::failure::Failure;
use crate::input::{CaseArguments, ReplaceArguments};
use crate::orbit::write_table;
use crate::table::{self, number};
use std::fmt::Write;
use std::path::PathBuf;
use tribodyn_orbit::Mode;
use tribodyn_study::answers::{ModesAnswer, modes};

/// Natural modes about the steady orbit: frequencies, damping ratios, shapes; unstable ones are named.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Highest frequency, Hz
    #[arg(long, default_value_t = f64::INFINITY, value_name = "HZ")]
    up_to: f64,
    /// Write the modes as a table (CSV)
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Print JSON, and nothing else, to standard output
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let answer = modes(&file, arguments.up_to)?;
    if let Some(path) = &arguments.csv {
        write_table(path, &arguments.case.path, &csv(&answer.modes), &arguments.replace)?;
    }
    if arguments.json {
        return table::print_json(&answer);
    }
    table::print_line(&format!("{}\n", file.name))?;
    print(&answer)
}

fn print(answer: &ModesAnswer) -> Result<(), Failure> {
    let header = ["Hz", "damping", "1/s", "mostly", "ring x", "ring y", "ring z", "outer x", "outer y", "ball °"];
    let rows = answer.modes.iter().map(|mode| {
        let ball = leading_ball(mode);
        let ring = mode.inner_ring.iter().chain(&mode.outer_ring).map(|a| number(*a, 3));
        [number(mode.frequency_hz, 2), number(mode.damping_ratio, 5), format!("{:.3e}", mode.growth_rate_per_s)]
            .into_iter()
            .chain([mode.energy_shares.leader().to_owned()])
            .chain(ring)
            .chain([number(ball, 1)])
            .collect::<Vec<_>>()
    });
    table::print_rows(&header, rows)?;
    for mode in answer.modes.iter().filter(|mode| mode.growth_rate_per_s > 0.0) {
        let (frequency, rate) = (number(mode.frequency_hz, 2), number(mode.growth_rate_per_s, 3));
        let ball = number(leading_ball(mode), 1);
        let leader = mode.energy_shares.leader();
        let text =
            format!("warning: unstable mode at {frequency} Hz grows with {rate} 1/s, mostly {leader}, most at {ball}°");
        table::print_line(&text)?;
    }
    Ok(())
}

/// Azimuth of the ball that moves most, degrees.
fn leading_ball(mode: &Mode) -> f64 {
    let size = |ball: &[f64; 3]| ball.iter().map(|a| a * a).sum::<f64>();
    let sizes = mode.balls.iter().map(size).enumerate();
    let (index, _) = sizes.fold((0, 0.0), |best, this| if this.1 > best.1 { this } else { best });
    360.0 * index as f64 / mode.balls.len().max(1) as f64
}

fn csv(modes: &[Mode]) -> String {
    let mut text = "frequency_hz,damping_ratio,growth_rate_per_s,energy_inner_ring,energy_outer_ring,energy_balls,\
                    energy_spin,energy_cage,inner_x,inner_y,inner_z,outer_x,outer_y\n"
        .to_owned();
    for mode in modes {
        let e = &mode.energy_shares;
        let numbers = [mode.frequency_hz, mode.damping_ratio, mode.growth_rate_per_s]
            .into_iter()
            .chain([e.inner_ring, e.outer_ring, e.balls, e.spin, e.cage])
            .chain(mode.inner_ring)
            .chain(mode.outer_ring);
        let row: Vec<String> = numbers.map(|number| number.to_string()).collect();
        let _ = writeln!(text, "{}", row.join(","));
    }
    text
}
