//! `tribodyn check`: is a case file right, and what follows from it.

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::rating::{NOMINAL, frequency_rows};
use crate::table::{self, number};
use tribodyn::answers::{Derived, GrowthAnswer, derived, heated_flow};
use tribodyn_bearing::SearchWatch;

/// Check a case file and print derived geometry, masses, contact constants and fluid forces.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn check 6206.ron
  tribodyn check 7210B.ron --set 'speed.inner.Constant=rpm(9000)' --json")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Print the state of the cryogen after this flow, kg/s, has taken up --power
    #[arg(long, value_name = "KG_S", value_parser = above_0, requires = "power")]
    flow: Option<f64>,
    /// Heat that the flow takes up, W: friction, drag and churning, as `solve` prints them
    #[arg(long, value_name = "W", value_parser = above_0, requires = "flow")]
    power: Option<f64>,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

fn above_0(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|value: &f64| *value > 0.0 && value.is_finite());
    number.ok_or_else(|| "allowed is a number above 0".to_owned())
}

/// The fluid: density, drag, phase, and what heat makes of its flow.
fn fluid_rows(a: &Derived) -> Vec<(&'static str, String, &'static str)> {
    let mut rows = Vec::new();
    if let (Some(drag), Some(density)) = (a.drag_per_ball_n, a.effective_fluid_density_kg_m3) {
        rows.push(("effective fluid density", number(density, 2), "kg/m³"));
        rows.push(("drag per ball at that speed", number(drag, 1), "N"));
    }
    if let Some(moments) = a.cage_churning_nm {
        let [faces, bore, outside] = moments.map(|moment| number(moment, 3));
        let sum = number(moments.iter().sum(), 3);
        rows.push((
            "cage in the fluid: faces, bore, outside, sum",
            format!("{faces}  {bore}  {outside}  {sum}"),
            "N m",
        ));
    }
    rows.extend(a.fluid_phase.iter().map(|phase| ("phase of the fluid", phase.clone(), "")));
    if let Some(flow) = &a.heated_flow {
        let heat = format!("{}  {}", number(flow.flow_kg_s, 3), number(flow.power_w * 1e-3, 2));
        rows.push(("flow, heat taken up", heat, "kg/s, kW"));
        rows.push(("temperature at the outlet", number(flow.outlet_temperature_k, 2), "K"));
        let density = format!("{}  {}", number(flow.inlet_density_kg_m3, 1), number(flow.outlet_density_kg_m3, 1));
        rows.push(("density, inlet outlet", density, "kg/m³"));
        rows.push(("phase at the outlet", flow.outlet_phase.clone(), ""));
        rows.extend(flow.outlet_quality.map(|quality| ("vapour at the outlet, by mass", number(quality, 3), "")));
    }
    rows
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

/// Speed and loads of the case against what the bearing is made for.
fn load_rows(a: &Derived) -> Vec<(&'static str, String, &'static str)> {
    let mut rows = vec![("pitch diameter times speed", number(a.pitch_speed_mm_rpm, 0), "mm r/min")];
    let loads = a.radial_load_n.zip(a.axial_load_n);
    rows.extend(
        loads.map(|(radial, axial)| {
            ("loads, radial axial", format!("{}  {}", number(radial, 1), number(axial, 1)), "N")
        }),
    );
    let mut row = |name, value: Option<f64>, digits, unit| {
        rows.extend(value.map(|value| (name, number(value, digits), unit)));
    };
    row("dynamic load rating C_r", a.dynamic_rating_n, 0, "N");
    row("static load rating C_0r", a.static_rating_n, 0, "N");
    row("least load, by 0.01 C_r", a.minimum_load_n, 0, "N");
    row("static safety s_0", a.static_safety, 2, "");
    row("life of the grease, 9 of 10 (estimate)", a.grease_life_hours, 0, "h");
    let estimate = a.peak_pressure_estimate_pa.filter(|pressure| *pressure > 0.0);
    row("highest peak pressure, first estimate", estimate.map(|pressure| pressure * 1e-9), 2, "GPa");
    rows
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let question = file.question(SearchWatch::default());
    let mut a = derived(&question)?;
    if let (Some(flow), Some(power)) = (arguments.flow, arguments.power) {
        a.heated_flow = Some(heated_flow(&question, flow, power)?);
    }
    if arguments.json {
        return table::print_json(&a);
    }
    let name = crate::harmless::visible(&a.name);
    table::print_line(&format!("{}: {name}\nlubrication: {}\n", file.name, a.lubrication))?;
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
    rows.extend(a.frequencies.iter().flat_map(|found| frequency_rows(found, NOMINAL)));
    rows.extend(fluid_rows(&a));
    rows.extend(load_rows(&a));
    rows.extend(a.growth.iter().flat_map(growth_rows));
    rows.extend(a.fits.iter().flat_map(crate::fits::rows));
    table::print_pairs(&rows)?;
    for note in &a.notes {
        table::print_line(&format!("note: {note}"))?;
    }
    table::print_warnings(&a.warnings)
}
