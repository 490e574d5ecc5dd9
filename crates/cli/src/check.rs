//! `tribodyn check`: is a case file right, and what follows from it.

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::table::{self, number};
use tribodyn_study::answers::{GrowthAnswer, derived};

/// Check a case file and print derived geometry, masses, contact constants and fluid forces.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

fn growth_rows(growth: &GrowthAnswer) -> Vec<(&'static str, String, &'static str)> {
    let row = |values: &[f64], digits| values.iter().map(|v| number(*v, digits)).collect::<Vec<_>>().join("  ");
    let angles = [growth.contact_angle_drawn_deg, growth.contact_angle_mounted_deg, growth.contact_angle_running_deg];
    let clearances =
        [growth.radial_clearance_drawn_m, growth.radial_clearance_mounted_m, growth.radial_clearance_running_m];
    let races = [growth.raceway_growth_inner_m, growth.raceway_growth_outer_m];
    let mut rows = vec![
        ("contact angle, drawn mounted running", row(&angles, 3), "°"),
        ("radial clearance, drawn mounted running", row(&clearances.map(|c| c * 1e6), 2), "µm"),
        ("growth of the races, inner outer", row(&races.map(|g| g * 1e6), 2), "µm"),
    ];
    let pressures = [
        ("pressure in the inner ring's seat", growth.seat_pressure_inner_pa),
        ("pressure in the outer ring's seat", growth.seat_pressure_outer_pa),
    ];
    for (name, pressure) in pressures {
        rows.extend(pressure.map(|pressure| (name, number(pressure * 1e-6, 2), "MPa")));
    }
    rows
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let a = derived(&file)?;
    if arguments.json {
        return table::print_json(&a);
    }
    table::print_line(&format!("{}: {}\n", file.name, crate::harmless::visible(&a.name)))?;
    let mut rows = vec![
        ("free contact angle", number(a.contact_angle_deg, 4), "°"),
        ("radial clearance (diametral)", number(a.radial_clearance_m * 1e6, 2), "µm"),
        ("axial play", number(a.axial_play_m * 1e6, 2), "µm"),
        ("groove coefficient inner", number(a.groove_coefficient_inner, 5), ""),
        ("groove coefficient outer", number(a.groove_coefficient_outer, 5), ""),
        ("distance of groove centres", number(a.groove_centre_distance_m * 1e3, 4), "mm"),
        ("ball mass", number(a.ball_mass_kg * 1e3, 3), "g"),
        ("ball moment of inertia", format!("{:.5e}", a.ball_inertia_kg_m2), "kg m²"),
        ("contact stiffness inner", format!("{:.5e}", a.contact_stiffness_inner_n_per_m_1_5), "N/m^1.5"),
        ("contact stiffness outer", format!("{:.5e}", a.contact_stiffness_outer_n_per_m_1_5), "N/m^1.5"),
        ("ellipticity inner", number(a.ellipticity_inner, 4), ""),
        ("ellipticity outer", number(a.ellipticity_outer, 4), ""),
        ("cage speed, rolling at the free angle", number(a.cage_speed_free_rpm, 1), "r/min"),
    ];
    if let (Some(drag), Some(density)) = (a.drag_per_ball_n, a.effective_fluid_density_kg_m3) {
        rows.push(("effective fluid density", number(density, 2), "kg/m³"));
        rows.push(("drag per ball at that speed", number(drag, 1), "N"));
    }
    rows.extend(a.growth.iter().flat_map(growth_rows));
    table::print_pairs(&rows)?;
    for note in &a.notes {
        table::print_line(&format!("note: {note}"))?;
    }
    for warning in &a.warnings {
        table::print_line(&format!("warning: {warning}"))?;
    }
    Ok(())
}
