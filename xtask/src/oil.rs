//! `cargo xtask oil`: bearings in oil beside what was measured on them, `docs/oil.md`.

use crate::error::Failure;
use crate::terminal::{print, progress};
use std::f64::consts::PI;
use std::fmt::Write;
use tribodyn::answers::{Equations, Surroundings, equilibrium, heat};
use tribodyn::{CaseFile, Change, Limits};
use tribodyn_bearing::SearchWatch;
use tribodyn_catalogue::{NewCase, NewLubricant, find};
use tribodyn_paper::{files, markers};
use tribodyn_quasistatic::{Model, Solution};

const PAGE: &str = "docs/oil.md";
const CASE: &str = "fixtures/cases/skidding-120.ron";
const MARKS: [[&str; 2]; 4] = [
    ["<!-- skidding:begin -->", "<!-- skidding:end -->"],
    ["<!-- knee:begin -->", "<!-- knee:end -->"],
    ["<!-- hybrid:begin -->", "<!-- hybrid:end -->"],
    ["<!-- heat:begin -->", "<!-- heat:end -->"],
];
/// Speeds of the bearing of 120 mm bore, r/min, its thrust loads, N, and shares of oil between its rings.
const SPEEDS: [f64; 5] = [8000.0, 12_000.0, 16_700.0, 20_800.0, 25_000.0];
const LOADS: [f64; 5] = [22_240.0, 13_345.0, 6672.0, 3336.0, 1500.0];
const SHARES: [f64; 3] = [0.01, 0.02, 0.05];
/// Sliding over rolling at the inner race from which balls skid (CONTRIBUTING.md).
const SKIDDING: f64 = 0.05;
/// Halvings of the range of loads.
const HALVINGS: usize = 14;
/// Designation and thermal reference speed, r/min: SKF, Rolling bearings, 17000 EN, 2018.
const REFERENCE_SPEEDS: [(&str, f64); 6] = [
    ("6204", 32_000.0),
    ("6206", 24_000.0),
    ("6208", 18_000.0),
    ("6210", 15_000.0),
    ("6308", 17_000.0),
    ("6310", 13_000.0),
];

/// Options of `cargo xtask oil`.
#[derive(Debug, Clone, clap::Args)]
pub struct Arguments {
    /// Rewrite the tables in docs/oil.md
    #[arg(long)]
    write: bool,
}

/// Prints the tables, and writes them where asked to.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let text = files::read(&files::root().join(CASE))?;
    let tables = [skidding(&text)?, knees(&text)?, hybrid(&text)?, reference_speeds()?];
    tables.iter().try_for_each(|table| print(table))?;
    if arguments.write {
        let path = files::root().join(PAGE);
        let mut page = files::read(&path)?;
        for (table, marks) in tables.iter().zip(MARKS) {
            page = markers::replaced(PAGE, &page, table, marks)?;
        }
        files::write(&path, page.as_bytes())?;
    }
    Ok(())
}

fn failed(error: &dyn std::fmt::Display) -> Failure {
    Failure::Seed(error.to_string())
}

/// A case in oil under a thrust load (N) at a speed (r/min), with other changes.
fn solved(text: &str, (load, rpm): (f64, f64), more: &[(&str, String)], model: Model) -> Result<Solution, Failure> {
    let point = [("ring.z.Force", format!("N({load})")), ("speed.inner", format!("Constant(rpm({rpm}))"))];
    let changes: Vec<Change> =
        point.iter().chain(more).map(|(path, value)| Change::new(format!("{path}={value}"), path, value)).collect();
    let file = CaseFile::from_text(CASE, text.to_owned(), &changes, &Limits::NORMAL).map_err(|e| failed(&e))?;
    let found = equilibrium(&file.question(SearchWatch::default()), model, false);
    found.map(|found| found.solution).map_err(|error| failed(&error))
}

/// Sliding over rolling at the inner race; all balls are alike.
fn sliding(solution: &Solution) -> f64 {
    solution.balls[0].contacts.inner.friction.map_or(0.0, |friction| friction.slide_to_roll[0].abs())
}

fn share(share: f64) -> [(&'static str, String); 1] {
    [("fluid.liquid_fraction", share.to_string())]
}

/// Cage slip against the cage speed of Jones and Harris, and sliding at the inner race.
fn skidding(text: &str) -> Result<String, Failure> {
    progress("skidding of the 120 mm bearing");
    let mut table = "| r/min |".to_owned();
    LOADS.iter().for_each(|load| table += &format!(" {load} N |"));
    table += &format!("\n|---|{}\n", "---|".repeat(LOADS.len()));
    for rpm in SPEEDS {
        let _ = write!(table, "| {rpm} |");
        for load in LOADS {
            let kinematic = solved(text, (load, rpm), &[], Model::JonesHarris)?;
            let found = solved(text, (load, rpm), &[], Model::Traction)?;
            let slip = 1.0 - found.cage_speed_rpm / kinematic.cage_speed_rpm;
            let _ = write!(table, " {:.1}, {:.1} |", 100.0 * slip, 100.0 * sliding(&found));
        }
        table += "\n";
    }
    Ok(table)
}

/// The thrust load below which balls skid, N, and the kinematic cage speed there, rad/s.
fn knee(text: &str, rpm: f64, more: &[(&str, String)]) -> Result<(f64, f64), Failure> {
    let [mut low, mut high] = [20.0_f64, 30_000.0];
    for _ in 0..HALVINGS {
        let load = (low * high).sqrt();
        if sliding(&solved(text, (load, rpm), more, Model::Traction)?) > SKIDDING {
            low = load;
        } else {
            high = load;
        }
    }
    Ok((high, solved(text, (high, rpm), more, Model::JonesHarris)?.cage_speed_rpm * PI / 30.0))
}

/// Knees over speed and share of oil, as thrust load over the centrifugal force of all balls.
fn knees(text: &str) -> Result<String, Failure> {
    progress("knees");
    let file = CaseFile::from_text(CASE, text.to_owned(), &[], &Limits::NORMAL).map_err(|error| failed(&error))?;
    let geometry = &file.case.geometry;
    let mass = file.case.materials.ball.density * PI / 6.0 * geometry.ball_diameter.powi(3);
    let mut table = "| r/min |".to_owned();
    SHARES.iter().for_each(|share| table += &format!(" {:.0} % oil |", 100.0 * share));
    table += &format!("\n|---|{}\n", "---|".repeat(SHARES.len()));
    for rpm in SPEEDS {
        let _ = write!(table, "| {rpm} |");
        for oil in SHARES {
            let (load, speed) = knee(text, rpm, &share(oil))?;
            let force = mass * 0.5 * geometry.pitch_diameter * speed * speed * geometry.ball_count as f64;
            let _ = write!(table, " {load:.0} N, {:.3} |", load / force);
        }
        table += "\n";
    }
    Ok(table)
}

/// A bearing of 35 mm bore with balls of steel and of silicon nitride.
fn hybrid(text: &str) -> Result<String, Failure> {
    progress("steel and silicon nitride");
    let change = |path: &'static str, value: &str| (path, value.to_owned());
    let small = [
        change("geometry.ball_count", "16"),
        change("geometry.ball_diameter", "mm(7.1438)"),
        change("geometry.pitch_diameter", "mm(48.5)"),
        change("geometry.fit", "ContactAngle(deg(24))"),
        change("rating", "(contact_angle: deg(24), bore: mm(35), outside: mm(62))"),
    ];
    let ceramic = change("materials.ball", "(young: GPa(310), poisson: 0.27, density: kg_per_m3(3200))");
    let [steel, nitride] = [small.to_vec(), small.iter().cloned().chain([ceramic]).collect::<Vec<_>>()];
    let rpm = 71_500.0;
    let knees = [knee(text, rpm, &steel)?.0, knee(text, rpm, &nitride)?.0];
    let mut table = "| | steel balls | silicon nitride | ratio |\n|---|---|---|---|\n".to_owned();
    let _ =
        writeln!(table, "| balls skid below | {:.0} N | {:.0} N | {:.2} |", knees[0], knees[1], knees[1] / knees[0]);
    for load in [667.0, 1000.0, 1334.0] {
        let power = |more: &[(&str, String)]| -> Result<f64, Failure> {
            let torque = solved(text, (load, rpm), more, Model::Traction)?.shaft_torque_nm.unwrap_or(f64::NAN);
            Ok(torque.abs() * rpm * PI / 30.0)
        };
        let [steel, nitride] = [power(&steel)?, power(&nitride)?];
        let _ = writeln!(table, "| power at {load} N | {steel:.0} W | {nitride:.0} W | {:.2} |", nitride / steel);
    }
    Ok(table)
}

/// Temperatures at the thermal reference speed, under the conditions of ISO 15312.
fn reference_speeds() -> Result<String, Failure> {
    progress("thermal reference speeds");
    let mut table =
        "| bearing | r/min | load, N | outer ring, °C | inner ring, °C | mean, °C | off 70 °C, K | power, W |\n\
                     |---|---|---|---|---|---|---|---|\n"
            .to_owned();
    for (bearing, rpm) in REFERENCE_SPEEDS {
        let listed = find(bearing, None).map_err(|error| failed(&error))?;
        let load = 0.05 * listed.ratings.map_or(f64::NAN, |ratings| ratings.at_rest);
        let mut case = NewCase::of_listed(listed, bearing);
        case.lubricant = Some(NewLubricant::parse("vg32").map_err(|error| failed(&error))?);
        [case.radial_load, case.axial_load] = [Some(load), Some(0.0)];
        case.speed = Some(rpm * PI / 30.0);
        let text = case.text().map_err(|error| failed(&error))?;
        let file = CaseFile::from_text(bearing, text, &[], &Limits::NORMAL).map_err(|error| failed(&error))?;
        let surroundings = Surroundings { temperature_deg_c: 20.0, cooling: 1.0, width_mm: None, oil_flow_l_min: 0.0 };
        let found = heat(&file.question(SearchWatch::default()), Equations::Traction, &surroundings);
        let found = found.map_err(|error| failed(&error))?;
        let answer = found.value();
        let mean = 0.5 * (answer.outer_temperature_deg_c + answer.inner_temperature_deg_c);
        let _ = writeln!(
            table,
            "| {bearing} | {rpm} | {load:.0} | {:.1} | {:.1} | {mean:.1} | {:.1} | {:.0} |",
            answer.outer_temperature_deg_c,
            answer.inner_temperature_deg_c,
            mean - 70.0,
            answer.friction_power_w,
        );
    }
    Ok(table)
}
