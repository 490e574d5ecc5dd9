//! The report of a run, as a person reads it.

use super::progress::significant;
use crate::failure::Failure;
use crate::table::{self, number};
use tribodyn_report::words::{acceleration, shown};
use tribodyn_study::run::{CageMotion, RunReport, Summary, imbalance};

/// Prints the report of a run.
pub fn print(r: &RunReport) -> Result<(), Failure> {
    table::print_line(&crate::harmless::visible(&format!("{}: {}", r.case, r.bearing)))?;
    table::print_line("")?;
    let mut rows = Vec::new();
    if let Some(summary) = &r.summary {
        rows.extend(motion_rows(summary, r));
        rows.extend(summary.cage.iter().flat_map(cage_rows));
        rows.extend(power_rows(summary));
        rows.extend(wear_rows(summary));
    }
    rows.extend(solver_rows(r));
    table::print_pairs(&rows)?;
    table::print_line(&format!("\nscheme      {}\npatch rule  {}", r.known.scheme, r.known.patch_rule))?;
    for warning in shown(&r.warnings().cloned().collect::<Vec<_>>()) {
        table::print_line(&format!("warning: {warning}"))?;
    }
    table::print_line(&format!("recording: {}", r.recording.display()))
}

type Row = (&'static str, String, &'static str);

fn pair(a: f64, b: f64, digits: usize) -> String {
    format!("{}  {}", number(a, digits), number(b, digits))
}

fn motion_rows(s: &Summary, r: &RunReport) -> Vec<Row> {
    let of = |x: f64, y: f64| acceleration(pair(x, y, 3), r.accelerations_supported);
    let (rms, rms_unit) = of(s.outer_acceleration_x_rms_m_s2, s.outer_acceleration_y_rms_m_s2);
    let (peak, peak_unit) = of(s.outer_acceleration_x_peak_m_s2, s.outer_acceleration_y_peak_m_s2);
    vec![
        ("simulated time", number(s.simulated_s, 6), "s"),
        ("times real time", significant(r.simulated_per_wall), ""),
        ("cage speed at the start", number(s.cage_speed_start_rpm, 3), "r/min"),
        ("cage speed, mean of last half", number(s.cage_speed_mean_rpm, 3), "r/min"),
        ("orbital speeds, least and most", pair(s.orbital_speed_min_rpm, s.orbital_speed_max_rpm, 2), "r/min"),
        ("outer ring acceleration, rms x y", rms, rms_unit),
        ("outer ring acceleration, peak x y", peak, peak_unit),
        ("peak pressure, inner outer", pair(s.peak_pressure_inner_max_gpa, s.peak_pressure_outer_max_gpa, 3), "GPa"),
        ("pocket force, largest", number(s.pocket_force_max_n, 1), "N"),
        ("pocket impacts, whole run", s.impacts.to_string(), ""),
    ]
}

/// Of a cage that is free to move.
fn cage_rows(c: &CageMotion) -> Vec<Row> {
    let mut rows = vec![
        ("cage", c.sentence(), ""),
        ("cage centre, mean x y", pair(c.mean_x_um, c.mean_y_um, 2), "µm"),
        ("cage centre about it, rms and most", pair(c.radius_rms_um, c.radius_max_um, 2), "µm"),
    ];
    if let (Some(ratio), Some(spread)) = (c.whirl_ratio, c.whirl_ratio_spread) {
        rows.push(("whirl over cage speed, spread", pair(ratio, spread, 3), ""));
    }
    rows.push(("cage tilt, largest", number(c.tilt_max_mrad, 3), "mrad"));
    rows.push(("land force, largest, inner outer", pair(c.land_force_inner_max_n, c.land_force_outer_max_n, 2), "N"));
    rows.push(("land gap, smallest", number(c.land_gap_min_um, 2), "µm"));
    rows
}

fn power_rows(s: &Summary) -> Vec<Row> {
    let p = &s.power;
    let (shaft, loads) = (number(p.mean.shaft_w, 1), number(p.mean.load_w, 1));
    let mut rows = vec![("power in: shaft", shaft, "W"), ("power in: loads", loads, "W")];
    rows.extend(p.out().into_iter().map(|(name, value)| (name, number(value, 1), "W")));
    rows.push(("imbalance of all work done", imbalance(p.imbalance_percent), "%"));
    rows
}

fn wear_rows(s: &Summary) -> Vec<Row> {
    let w = &s.wear;
    vec![
        ("coating left, inner outer", pair(w.coating_inner_min_um, w.coating_outer_min_um, 4), "µm"),
        ("worn off, inner outer", pair(w.volume_inner_um3, w.volume_outer_um3, 0), "µm³"),
        ("worn off, cage", number(w.volume_cage_um3, 0), "µm³"),
    ]
}

fn solver_rows(r: &RunReport) -> Vec<Row> {
    let c = &r.outcome.scheme_statistics;
    let mut rows = vec![
        ("steps kept", c.steps.to_string(), ""),
        ("steps rejected", c.rejected.to_string(), ""),
        ("steps cut at pockets", c.cut_at_pocket.to_string(), ""),
        ("evaluations of all forces", c.evaluations.to_string(), ""),
        ("longest stable fixed step", number(r.outcome.stiffness.runge_kutta_step_s * 1e6, 2), "µs"),
    ];
    if let Some(step) = r.known.step_s {
        rows.push(("step taken", number(step * 1e6, 3), "µs"));
    }
    if let Some(choice) = r.known.step_choice {
        let [asked, found] = [choice.accuracy, choice.errors.worst()].map(|error| format!("{error:.1e}"));
        let scatter = if choice.scatters { ", shorter steps no better" } else { "" };
        rows.push(("accuracy asked for, error found", format!("{asked} {found}{scatter}"), ""));
    }
    if let Some(error) = r.outcome.acceleration_error_m_s2 {
        rows.push(("error of accelerations, rms", format!("{error:.1e}"), "m/s²"));
    }
    if let Some(error) = r.known.patch_error_estimate {
        rows.push(("patch error estimate (of load)", format!("{error:.1e}"), ""));
    }
    rows
}
