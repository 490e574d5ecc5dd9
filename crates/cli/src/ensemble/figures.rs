//! Figures of an ensemble: the share of the members up to each value.

use crate::drawn::{Plan, plan, stage};
use crate::failure::Failure;
use tribodyn_plot::{Axis, Figure, LineChart, Panel, Series};
use tribodyn_study::StagedFiles;
use tribodyn_study::ensemble::{Ensemble, Outcome};

const PLANS: [Plan; 8] = [
    plan(
        "cage-speed",
        "Cage speed",
        ("Cage speed", "r/min", 1.0),
        &[("mean", "cage_speed_mean_rpm"), ("at the start", "cage_speed_start_rpm")],
    ),
    plan(
        "orbital-speeds",
        "Orbital speeds of the balls",
        ("Orbital speed", "r/min", 1.0),
        &[("slowest ball", "orbital_speed_min_rpm"), ("fastest ball", "orbital_speed_max_rpm")],
    ),
    plan(
        "ring-acceleration",
        "Acceleration of the outer ring, rms",
        ("Acceleration", "m/s²", 1.0),
        &[("along X", "outer_acceleration_x_rms_m_s2"), ("along Y", "outer_acceleration_y_rms_m_s2")],
    ),
    plan(
        "contact-loads",
        "Largest contact loads",
        ("Contact load", "kN", 1e-3),
        &[("inner", "load_inner_max_n"), ("outer", "load_outer_max_n")],
    ),
    plan(
        "peak-pressures",
        "Highest peak pressures",
        ("Peak pressure", "GPa", 1.0),
        &[("inner", "peak_pressure_inner_max_gpa"), ("outer", "peak_pressure_outer_max_gpa")],
    ),
    plan("pocket-force", "Largest pocket force", ("Pocket force", "N", 1.0), &[("largest", "pocket_force_max_n")]),
    plan(
        "powers",
        "Powers",
        ("Power", "kW", 1e-3),
        &[
            ("shaft", "power.shaft_w"),
            ("friction, inner", "power.friction_inner_w"),
            ("friction, outer", "power.friction_outer_w"),
            ("drag", "power.drag_w"),
        ],
    ),
    plan(
        "wear",
        "Worn volumes",
        ("Volume", "µm³", 1.0),
        &[
            ("inner race", "wear.volume_inner_um3"),
            ("outer race", "wear.volume_outer_um3"),
            ("cage pockets", "wear.volume_cage_um3"),
        ],
    ),
];

/// Name of the curves.
const MEMBERS: &str = "members";
/// Most points on a curve that are marked one by one.
const MARKED: usize = 60;

/// The share of the members up to each of some values, %: each member stands in the middle of its part.
fn distribution(mut values: Vec<f64>, unit: f64) -> Vec<(f64, f64)> {
    values.sort_by(f64::total_cmp);
    let count = values.len() as f64;
    values.into_iter().enumerate().map(|(k, value)| (unit * value, 100.0 * (k as f64 + 0.5) / count)).collect()
}

/// Draws all figures into files that get their names when they are published; what has no value is left out.
pub fn draw(staged: &mut StagedFiles, ensemble: &Ensemble, outcome: &Outcome) -> Result<(), Failure> {
    for plan in &PLANS {
        let panels: Vec<Panel> = plan.lines.iter().filter_map(|curve| panel(plan, curve, ensemble, outcome)).collect();
        if panels.is_empty() {
            continue;
        }
        let figure = Figure::in_columns(plan.name, plan.title, 2, &panels)?;
        stage(staged, &figure)?;
    }
    Ok(())
}

/// The distribution of one figure over the members.
fn panel(plan: &Plan, (name, column): &(&str, &str), ensemble: &Ensemble, outcome: &Outcome) -> Option<Panel> {
    let (label, unit, per_unit) = plan.axis;
    if let Some(axis) = ensemble.grid_axis() {
        return over_grid((name, column), Axis::new(label, unit), (axis, per_unit), (ensemble, outcome));
    }
    let points = distribution(ensemble.values(column, &outcome.members), per_unit);
    if points.is_empty() {
        return None;
    }
    let curve = if points.len() > MARKED { Series::line(MEMBERS, points) } else { Series::marked(MEMBERS, points) };
    let share = Axis::new("Members up to it", "%").covering(0.0, 100.0);
    Some(Panel::Cartesian(LineChart::new(*name, Axis::new(label, unit), share, vec![curve])))
}

/// A figure over the first value of a grid, a curve for each choice of the others.
fn over_grid(
    (name, column): (&str, &str),
    axis: Axis,
    (first, per_unit): (&str, f64),
    (ensemble, outcome): (&Ensemble, &Outcome),
) -> Option<Panel> {
    let mut curves: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
    for (member, value) in ensemble.numbered(column, &outcome.members) {
        let (x, others) = ensemble.place(member)?;
        match curves.iter_mut().find(|(label, _)| *label == others) {
            Some((_, points)) => points.push((x, per_unit * value)),
            None => curves.push((others, vec![(x, per_unit * value)])),
        }
    }
    let (path, unit) = first.strip_suffix(']').and_then(|text| text.split_once(" [")).unwrap_or((first, ""));
    let label = |text: String| if text.is_empty() { name.to_owned() } else { text };
    let series: Vec<Series> = curves.into_iter().map(|(text, points)| Series::marked(label(text), points)).collect();
    if series.is_empty() {
        return None;
    }
    Some(Panel::Cartesian(LineChart::new(name, Axis::new(path, unit), axis, series)))
}

#[cfg(test)]
mod tests {
    use super::distribution;

    #[test]
    fn limit_members_stand_in_the_middle_of_their_parts() {
        assert_eq!(distribution(vec![3.0, 1.0], 10.0), [(10.0, 25.0), (30.0, 75.0)]);
        assert_eq!(distribution(Vec::new(), 1.0), []);
    }
}
