//! `tribodyn check`: is a case file right, and what follows from it.

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::table::{self, number};
use serde::Serialize;
use tribodyn_bearing::{Bearing, BearingError, Geometry, Translation};
use tribodyn_case::{Case, Growths, Source};
use tribodyn_study::{CaseFile, StudyError, plausibility};

/// Check a case file and print derived geometry, masses, contact constants and fluid forces.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Answer {
    name: String,
    contact_angle_deg: f64,
    radial_clearance_m: f64,
    axial_play_m: f64,
    groove_coefficient_inner: f64,
    groove_coefficient_outer: f64,
    groove_centre_distance_m: f64,
    ball_mass_kg: f64,
    ball_inertia_kg_m2: f64,
    contact_stiffness_inner_n_per_m_1_5: f64,
    contact_stiffness_outer_n_per_m_1_5: f64,
    ellipticity_inner: f64,
    ellipticity_outer: f64,
    cage_speed_free_rpm: f64,
    drag_per_ball_n: Option<f64>,
    effective_fluid_density_kg_m3: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    growth: Option<Growth>,
    sources: std::collections::BTreeMap<String, Source>,
    notes: Vec<String>,
    warnings: Vec<String>,
}

/// The bearing of the drawing, mounted and running; the answer's other fields are those of the running one.
#[derive(Serialize)]
struct Growth {
    contact_angle_drawn_deg: f64,
    contact_angle_mounted_deg: f64,
    contact_angle_running_deg: f64,
    radial_clearance_drawn_m: f64,
    radial_clearance_mounted_m: f64,
    radial_clearance_running_m: f64,
    raceway_growth_inner_m: f64,
    raceway_growth_outer_m: f64,
    seat_pressure_inner_pa: Option<f64>,
    seat_pressure_outer_pa: Option<f64>,
}

fn growth(case: &Case) -> Result<Option<Growth>, BearingError> {
    let drawn = case.geometry.resolve()?;
    let Some(Growths { mounted, running }) = case.growths()? else { return Ok(None) };
    let degrees = |geometry: &Geometry| geometry.contact_angle().to_degrees();
    Ok(Some(Growth {
        contact_angle_drawn_deg: degrees(&drawn),
        contact_angle_mounted_deg: degrees(&mounted.geometry),
        contact_angle_running_deg: degrees(&running.geometry),
        radial_clearance_drawn_m: drawn.radial_clearance(),
        radial_clearance_mounted_m: mounted.geometry.radial_clearance(),
        radial_clearance_running_m: running.geometry.radial_clearance(),
        raceway_growth_inner_m: running.raceway_growth.inner,
        raceway_growth_outer_m: running.raceway_growth.outer,
        seat_pressure_inner_pa: running.seat_pressure.inner,
        seat_pressure_outer_pa: running.seat_pressure.outer,
    }))
}

impl Growth {
    fn rows(&self) -> Vec<(&'static str, String, &'static str)> {
        let row = |values: &[f64], digits| values.iter().map(|v| number(*v, digits)).collect::<Vec<_>>().join("  ");
        let angles = [self.contact_angle_drawn_deg, self.contact_angle_mounted_deg, self.contact_angle_running_deg];
        let clearances =
            [self.radial_clearance_drawn_m, self.radial_clearance_mounted_m, self.radial_clearance_running_m];
        let growth = [self.raceway_growth_inner_m, self.raceway_growth_outer_m];
        let mut rows = vec![
            ("contact angle, drawn mounted running", row(&angles, 3), "°"),
            ("radial clearance, drawn mounted running", row(&clearances.map(|c| c * 1e6), 2), "µm"),
            ("growth of the races, inner outer", row(&growth.map(|g| g * 1e6), 2), "µm"),
        ];
        let pressures = [
            ("pressure in the inner ring's seat", self.seat_pressure_inner_pa),
            ("pressure in the outer ring's seat", self.seat_pressure_outer_pa),
        ];
        for (name, pressure) in pressures {
            rows.extend(pressure.map(|pressure| (name, number(pressure * 1e-6, 2), "MPa")));
        }
        rows
    }
}

/// Where z = 0 is, and what a held axial position means.
fn notes(case: &Case, bearing: &Bearing) -> Vec<String> {
    let half = 0.5e6 * bearing.geometry.axial_play();
    let datum = format!(
        "axial position z = 0: the balls just touch both races without load, {} µm from the middle of the axial play",
        number(half, 1)
    );
    let mut notes = vec![datum];
    if let Translation::Held(z) = case.ring.z
        && half > 0.0
    {
        notes.push(format!(
            "the ring is held at z = {} µm: from z = 0 on every ball bears on one side; a bearing that floats in its play is held at the middle, z = Held(um({}))",
            number(z * 1e6, 3),
            number(-half, 1)
        ));
    }
    notes
}

fn answer(file: &CaseFile, bearing: &Bearing, growth: Option<Growth>) -> Answer {
    let case = &file.case;
    let g = &bearing.geometry;
    let point = case.operating_point();
    let (inner, outer) = (bearing.races.inner.frozen::<f64>(), bearing.races.outer.frozen::<f64>());
    // No-slip orbit at the free contact angle: the speed at which drag is quoted.
    let gamma = g.ball_diameter * g.cos_contact_angle() / g.pitch_diameter;
    let orbit = 0.5 * (point.inner_speed * (1.0 - gamma) + point.outer_speed * (1.0 + gamma));
    let mut warnings = plausibility::of_case(file, bearing);
    let drag =
        bearing.fluid.as_ref().map(|f| f.drag.force(0.5 * g.pitch_diameter * (orbit - f.swirl * point.inner_speed)));
    if let Some(drag) = drag {
        let power = drag * g.ball_count as f64 * orbit.abs() * 0.5 * g.pitch_diameter;
        if power > 1e5 {
            warnings.push(format!(
                "drag of {drag:.0} N on each ball takes {:.0} kW from the shaft: check drag coefficient and liquid fraction",
                power * 1e-3
            ));
        }
    }
    if g.contact_angle() == 0.0 {
        warnings.push("free contact angle is zero: an axial load needs a contact angle".into());
    }
    Answer {
        name: case.name.clone(),
        contact_angle_deg: g.contact_angle().to_degrees(),
        radial_clearance_m: g.radial_clearance(),
        axial_play_m: g.axial_play(),
        groove_coefficient_inner: g.inner_coefficient,
        groove_coefficient_outer: g.outer_coefficient,
        groove_centre_distance_m: g.centre_distance(),
        ball_mass_kg: bearing.ball_mass,
        ball_inertia_kg_m2: bearing.ball_inertia,
        contact_stiffness_inner_n_per_m_1_5: inner.stiffness(),
        contact_stiffness_outer_n_per_m_1_5: outer.stiffness(),
        ellipticity_inner: inner.ellipticity,
        ellipticity_outer: outer.ellipticity,
        cage_speed_free_rpm: orbit * 30.0 / std::f64::consts::PI,
        drag_per_ball_n: drag,
        effective_fluid_density_kg_m3: bearing.fluid.as_ref().map(|f| f.drag.density_effective),
        growth,
        sources: case.sources.clone(),
        notes: notes(case, bearing),
        warnings,
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let bearing = file.bearing()?;
    let unusable = |source| StudyError::Bearing { file: file.name.clone(), source };
    let a = answer(&file, &bearing, growth(&file.case).map_err(unusable)?);
    if arguments.json {
        return table::print_json(&a);
    }
    table::print_line(&format!("{}: {}\n", file.name, table::visible(&a.name)))?;
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
    rows.extend(a.growth.iter().flat_map(Growth::rows));
    table::print_pairs(&rows)?;
    for note in &a.notes {
        table::print_line(&format!("note: {note}"))?;
    }
    for warning in &a.warnings {
        table::print_line(&format!("warning: {warning}"))?;
    }
    Ok(())
}
