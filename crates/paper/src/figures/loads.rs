//! Figures 20 to 24: what the balls go through in an orbit, for coatings and for axial loads, and how the inner ring
//! shakes.

use super::runs::Made;
use super::spec::Spec;
use super::steady::twice_the_least;
use crate::error::PaperError;
use crate::transient::{RPM, Transient};
use tribodyn_bearing::{BallResult, ContactResult};
use tribodyn_plot::{Axis, Figure, OrbitSamples, Panel, Place, Reference, bars, orbit_panels};

/// A number of a ball; `None` where it has none, as the angle of a contact without load.
type Quantity = fn(&BallResult) -> Option<f64>;
/// Label and unit of an axis.
type Unit = (&'static str, &'static str);
/// Heading of a panel, its axis and values.
type Plan<'a> = (&'a str, Unit, Quantity);

const ANGLE: Unit = ("Contact angle", "°");
const LOAD: Unit = ("Contact load", "kN");
const SLIP: Unit = ("Slide-to-roll ratio", "10⁻³");
const SPIN: Unit = ("Spin ratio", "1/m");
const WEAR: Unit = ("Wear rate", "10⁻¹² m³/s");
const FORCE: Unit = ("Pocket force", "N");

/// A value of a contact that carries load.
fn loaded(contact: &ContactResult, value: f64) -> Option<f64> {
    (contact.load_n > 0.0).then_some(value)
}

pub const ANGLES: [Plan; 2] = [
    ("Inner contact", ANGLE, |b| loaded(&b.contacts.inner, b.contacts.inner.angle_rad.to_degrees())),
    ("Outer contact", ANGLE, |b| loaded(&b.contacts.outer, b.contacts.outer.angle_rad.to_degrees())),
];
pub const LOADS: [Plan; 2] = [
    ("Inner contact", LOAD, |b| loaded(&b.contacts.inner, 1e-3 * b.contacts.inner.load_n)),
    ("Outer contact", LOAD, |b| loaded(&b.contacts.outer, 1e-3 * b.contacts.outer.load_n)),
];
pub const SLIPS: [Plan; 2] = [
    ("Inner contact", SLIP, |b| loaded(&b.contacts.inner, 1e3 * b.contacts.inner.friction_or_nan().slide_to_roll[0])),
    ("Outer contact", SLIP, |b| loaded(&b.contacts.outer, 1e3 * b.contacts.outer.friction_or_nan().slide_to_roll[0])),
];
pub const SPINS: [Plan; 2] = [
    ("Inner contact", SPIN, |b| loaded(&b.contacts.inner, b.contacts.inner.spin_ratio_per_m)),
    ("Outer contact", SPIN, |b| loaded(&b.contacts.outer, b.contacts.outer.spin_ratio_per_m)),
];
pub const RACE_WEAR: [Plan; 1] = [("", WEAR, |b| {
    Some(1e12 * (b.contacts.inner.friction_or_nan().wear_rate_m3_s + b.contacts.outer.friction_or_nan().wear_rate_m3_s))
})];
const POCKET_WEAR: Plan = ("", WEAR, |b| Some(1e12 * b.pocket.unwrap_or_default().wear_rate_m3_s));
const POCKET_FORCE: Plan = ("", FORCE, |b| Some(b.pocket.unwrap_or_default().force_n.abs()));
/// Fig. 21b: what goes with the wear of a pocket.
pub const POCKET: [Plan; 3] = [
    ("Wear of the pocket", POCKET_WEAR.1, POCKET_WEAR.2),
    ("Force of the pocket", FORCE, POCKET_FORCE.2),
    ("Longitudinal traction, both races", ("Force on the ball", "N"), |b| {
        Some(b.contacts.inner.friction_or_nan().traction_n[0] + b.contacts.outer.friction_or_nan().traction_n[0])
    }),
];
pub const FORCES: [Plan; 1] = [POCKET_FORCE];
pub const CAGE_WEAR: [Plan; 1] = [POCKET_WEAR];
/// Orbital speed of the balls.
pub const SPEEDS: Plan = ("", ("Orbital speed", "r/min"), |b| Some(b.orbital_speed_rad_s / RPM));

/// Published azimuths of first impacts, section 5.2.2, degrees.
const FIRST_IMPACTS: [f64; 4] = [310.0, 290.0, 260.0, 240.0];

/// Values of all balls over the azimuth in the settled orbits, each plan with its runs.
pub fn over_orbits(plans: &[(Plan, &[(&str, &Transient)])]) -> Result<Vec<Panel>, PaperError> {
    let azimuths = |run: &Transient, get: Quantity| -> (Vec<f64>, Vec<Option<f64>>) {
        run.settled().all_balls().map(|ball| (ball.azimuth_rad, get(ball))).unzip()
    };
    let columns = |((_, _, get), runs): &(Plan, &[(&str, &Transient)])| {
        runs.iter().map(|(_, run)| azimuths(run, *get)).collect::<Vec<_>>()
    };
    let columns: Vec<_> = plans.iter().map(columns).collect();
    let samples: Vec<Vec<OrbitSamples>> = plans
        .iter()
        .zip(&columns)
        .map(|((_, runs), columns)| {
            let made = runs.iter().zip(columns);
            made.map(|((label, _), (azimuth_rad, values))| OrbitSamples { label, azimuth_rad, values }).collect()
        })
        .collect();
    let panel = |((title, (label, unit), _), samples)| (title, Axis::new(label, unit), samples);
    let made = plans.iter().map(|(plan, _)| *plan).zip(samples.iter().map(Vec::as_slice));
    Ok(orbit_panels(&made.map(panel).collect::<Vec<_>>())?)
}

fn panels(plans: &[Plan], runs: &[(&str, &Transient)]) -> Result<Vec<Panel>, PaperError> {
    over_orbits(&plans.iter().map(|plan| (*plan, runs)).collect::<Vec<_>>())
}

fn side_by_side(spec: &Spec, panels: &[Panel]) -> Result<Figure, PaperError> {
    Ok(Figure::new(spec.name, spec.title, panels)?)
}

/// Silver against PTFE.
pub fn by_coating(plans: &[Plan], spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    side_by_side(spec, &panels(plans, &made.coatings()?)?)
}

/// Fig. 21a: a panel for each coating, whose hardness parts their wear by a factor of ten.
pub fn race_wear_by_coating(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let [(_, unit, get)] = RACE_WEAR;
    let runs = made.coatings()?;
    let plans: Vec<_> = runs.iter().map(|run| ((run.0, unit, get), std::slice::from_ref(run))).collect();
    side_by_side(spec, &over_orbits(&plans)?)
}

/// Fig. 20b.
pub fn loads_by_coating(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let mut panels = panels(&LOADS, &made.coatings()?)?;
    if let Some(outer) = panels.last_mut() {
        outer.publish(twice_the_least(outer));
    }
    side_by_side(spec, &panels)
}

/// 25 to 100 % of the axial load.
pub fn by_load(plans: &[Plan], spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    side_by_side(spec, &panels(plans, &made.loads()?)?)
}

/// Fig. 22b with the azimuths of the first impacts.
pub fn speeds_by_load(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let loads = made.loads()?;
    let mut panels = panels(&[SPEEDS], &loads)?;
    for ((load, _), azimuth) in loads.iter().zip(FIRST_IMPACTS) {
        let percent = load.trim_end_matches(" axial load");
        let label = format!("published first impact, {percent}: {azimuth}°");
        panels[0].publish(Reference::new(label, Place::At(azimuth)).of(*load));
    }
    side_by_side(spec, &panels)
}

/// Fig. 22a: root mean square of the inner ring's accelerations.
pub fn vibration(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let loads = made.loads()?;
    let rms = |k: usize| loads.iter().map(|(_, run)| run.settled().rms(|s| s.inner_acceleration[k])).collect();
    let values = [("x, along the radial load", rms(0)), ("y", rms(1)), ("z, axial", rms(2))];
    let axis = Axis::new("rms acceleration, inner ring", "m/s²");
    Ok(bars(spec.name, spec.title, axis, &loads.map(|(label, _)| label), &values)?)
}
