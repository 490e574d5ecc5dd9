//! The answer of an ensemble, as a person reads it.

use super::Answer;
use crate::failure::Failure;
use crate::harmless::visible;
use crate::run::significant;
use crate::table::{number, print_line, print_pairs, print_rows};
use tribodyn_report::words::acceleration;
use tribodyn_study::ensemble::{EnsembleReport, Quantiles, Sampling};
use tribodyn_study::run::{carries_accelerations_of_patch, carries_accelerations_of_scheme};

/// A figure in the table for people: its column, its name, its unit, and decimals.
struct Shown {
    column: &'static str,
    name: &'static str,
    unit: &'static str,
    decimals: usize,
}

const fn line(column: &'static str, name: &'static str, unit: &'static str, decimals: usize) -> Shown {
    Shown { column, name, unit, decimals }
}

/// Names as `run` has them.
const LINES: [Shown; 22] = [
    line("cage_speed_start_rpm", "cage speed at the start", "r/min", 2),
    line("cage_speed_mean_rpm", "cage speed, mean of last half", "r/min", 2),
    line("orbital_speed_min_rpm", "orbital speed, least", "r/min", 1),
    line("orbital_speed_max_rpm", "orbital speed, most", "r/min", 1),
    line("outer_acceleration_x_rms_m_s2", "outer ring acceleration, rms x", "m/s²", 3),
    line("outer_acceleration_y_rms_m_s2", "outer ring acceleration, rms y", "m/s²", 3),
    line("outer_acceleration_x_peak_m_s2", "outer ring acceleration, peak x", "m/s²", 3),
    line("outer_acceleration_y_peak_m_s2", "outer ring acceleration, peak y", "m/s²", 3),
    line("load_inner_max_n", "contact load, inner", "N", 0),
    line("load_outer_max_n", "contact load, outer", "N", 0),
    line("peak_pressure_inner_max_gpa", "peak pressure, inner", "GPa", 3),
    line("peak_pressure_outer_max_gpa", "peak pressure, outer", "GPa", 3),
    line("pocket_force_max_n", "pocket force, largest", "N", 1),
    line("impacts", "pocket impacts, whole run", "", 0),
    line("power.shaft_w", "power in: shaft", "W", 1),
    line("power.friction_inner_w", "friction, inner", "W", 1),
    line("power.friction_outer_w", "friction, outer", "W", 1),
    line("power.drag_w", "drag", "W", 1),
    line("power.churning_w", "churning", "W", 1),
    line("wear.volume_inner_um3", "worn off, inner", "µm³", 0),
    line("wear.volume_outer_um3", "worn off, outer", "µm³", 0),
    line("wear.volume_cage_um3", "worn off, cage", "µm³", 0),
];

/// Members without figures whose reasons are shown.
const MOST_REASONS: usize = 5;

/// Prints the answer.
pub fn print(answer: &Answer) -> Result<(), Failure> {
    let r = &answer.report;
    print_line(&visible(&format!("{}: {}", r.case, r.bearing)))?;
    print_line("")?;
    let varied = |v: &tribodyn_study::ensemble::Varied| vec![v.path.clone(), v.spread.clone()];
    print_rows(&["varied", "spread"], r.varied.iter().map(varied))?;
    if !r.quantiles.is_empty() {
        print_line("")?;
        print_rows(&["quantiles", "5 %", "25 %", "50 %", "75 %", "95 %", ""], quantile_rows(r).into_iter())?;
    }
    print_line("")?;
    print_pairs(&cost_rows(r))?;
    for failure in r.failures.iter().take(MOST_REASONS) {
        print_line(&visible(&format!("member {}: {}", failure.member, failure.error)))?;
    }
    if r.failures.len() > MOST_REASONS {
        print_line(&format!(
            "… and {} more without a result; --json has all of them",
            r.failures.len() - MOST_REASONS
        ))?;
    }
    let table = answer.output.as_ref().map(|path| format!("{} is written", path.display()));
    let plots = answer.plot.as_ref().map(|folder| format!("figures are in {}", folder.display()));
    let files: Vec<String> = table.into_iter().chain(plots).collect();
    if files.is_empty() { Ok(()) } else { print_line(&format!("\n{}", files.join(", "))) }
}

fn quantile_rows(r: &EnsembleReport) -> Vec<Vec<String>> {
    let of = |column: &str| r.quantiles.iter().find(|q| q.quantity == column);
    // An error that is not known does not speak against accelerations.
    let patch = of("patch_error_estimate").is_none_or(|q| carries_accelerations_of_patch(Some(q.p95)));
    let rms = ["x", "y"].map(|axis| of(&format!("outer_acceleration_{axis}_rms_m_s2")).map_or(0.0, |q| q.p50));
    let scheme = of("acceleration_error_m_s2").map(|q| q.p95);
    let carried = patch && carries_accelerations_of_scheme(scheme, rms);
    let row = |shown: &Shown, quantiles: &Quantiles| {
        let value = |v: f64| number(v, shown.decimals);
        let carried = carried || !shown.column.starts_with("outer_acceleration");
        let cell = |v: f64| if carried { value(v) } else { acceleration(value(v), false).0 };
        let unit = if carried { shown.unit } else { acceleration(String::new(), false).1 };
        let cells = quantiles.all().map(cell);
        [shown.name.to_owned()].into_iter().chain(cells).chain([unit.to_owned()]).collect()
    };
    LINES.iter().filter_map(|shown| Some(row(shown, of(shown.column)?))).collect()
}

fn cost_rows(r: &EnsembleReport) -> Vec<(&'static str, String, &'static str)> {
    let cost = &r.cost;
    let mut rows = vec![("members", r.members.to_string(), "")];
    if r.finished < r.members {
        rows.push(("finished", r.finished.to_string(), ""));
    }
    if r.resumed > 0 {
        rows.push(("of an earlier run", r.resumed.to_string(), ""));
    }
    rows.push(("without a result", r.failed.to_string(), ""));
    let drawn = match r.sampling {
        Sampling::Independent => "",
        Sampling::LatinHypercube => "Latin hypercube",
        Sampling::Grid => "grid",
    };
    if r.sampling != Sampling::Grid {
        rows.push(("seed", r.seed.to_string(), drawn));
    }
    rows.push(("threads", cost.threads.to_string(), ""));
    if let Some(seconds) = cost.processor_per_member_s {
        rows.push(("processor time of a member", number(seconds, 3), "s"));
    }
    if let Some(seconds) = cost.wall_per_member_s {
        rows.push(("wall time of a member", number(seconds, 3), "s"));
    }
    rows.push(("wall time of all", number(cost.wall_s, 1), "s"));
    rows.push(("simulated time of all", number(cost.simulated_s, 4), "s"));
    if let Some(ratio) = cost.simulated_per_processor {
        rows.push(("times real time, a thread", significant(ratio), ""));
    }
    rows.push(("times real time, all", significant(cost.simulated_per_wall), ""));
    rows
}
