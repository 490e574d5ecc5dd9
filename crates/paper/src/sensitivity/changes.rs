//! Changes, one at a time.

use crate::error::PaperError;
use crate::files;
use crate::transient::{Change, Reading};
use std::f64::consts::TAU;
use std::fmt::Write;
use tribodyn_case::locate;

/// Parameters that are halved and doubled.
const HIDDEN: [&str; 11] = [
    "cage.pocket_gap",
    "cage.pocket_stiffness",
    "cage.pocket_friction",
    "cage.pocket_damping",
    "cage.inertia",
    "supports.inner.mass",
    "supports.outer.mass",
    "supports.outer.stiffness",
    "supports.outer.damping",
    "transient.contact_damping",
    "traction.slip_unit",
];

/// Further changes that are one value each: a name, a path, a value. Local pressure is not among them: it leaves the
/// fast scheme without its derivative, and 20 µs are too long without.
const SINGLE: [(&str, &str, &str); 49] = [
    ("step 10 µs", "transient.scheme", "Fast(step: us(10))"),
    ("Runge–Kutta 5 µs", "transient.scheme", "RungeKutta4(step: us(5))"),
    ("0.4 s", "transient.duration", "s(0.4)"),
    ("no cage", "cage.pocket_stiffness", "N_per_um(0)"),
    ("gap 0.12 mm", "cage.pocket_gap", "mm(0.12)"),
    ("gap 0.5 mm", "cage.pocket_gap", "mm(0.5)"),
    ("gap 0.9 mm", "cage.pocket_gap", "mm(0.9)"),
    ("gap 2.5 mm", "cage.pocket_gap", "mm(2.5)"),
    ("pocket 0.5 N/µm", "cage.pocket_stiffness", "N_per_um(0.5)"),
    ("pocket 50 N/µm", "cage.pocket_stiffness", "N_per_um(50)"),
    ("no pocket friction", "cage.pocket_friction", "0"),
    ("pocket friction 0.5", "cage.pocket_friction", "0.5"),
    ("no pocket damping", "cage.pocket_damping", "s_per_m(0)"),
    ("pocket damping 3 s/m", "cage.pocket_damping", "s_per_m(3)"),
    ("cage braked by 1 N m", "cage.drag_torque", "Nm(1)"),
    ("cage braked by 10 N m", "cage.drag_torque", "Nm(10)"),
    ("cage driven by 10 N m", "cage.drag_torque", "Nm(-10)"),
    ("inner ring on 100 N/µm", "supports.inner.stiffness", "(N_per_um(100), N_per_um(100), N_per_um(100))"),
    ("inner ring on 1000 N/µm", "supports.inner.stiffness", "(N_per_um(1000), N_per_um(1000), N_per_um(1000))"),
    ("inner ring softer along x", "supports.inner.stiffness", "(N_per_um(0), N_per_um(500), N_per_um(500))"),
    ("inner ring 2 kg", "supports.inner.mass", "kg(2)"),
    ("inner ring 100 kg", "supports.inner.mass", "kg(100)"),
    ("inner ring's dampers × 10", "supports.inner.damping", "(N_s_per_m(20000), N_s_per_m(20000), N_s_per_m(20000))"),
    ("outer ring on 50 N/µm", "supports.outer.stiffness", "(N_per_um(50), N_per_um(50))"),
    ("outer ring on 10 kN/µm", "supports.outer.stiffness", "(N_per_um(10000), N_per_um(10000))"),
    ("contact damping 0.1", "transient.contact_damping", "0.1"),
    ("rings about the inertial axis", "modelling.ring_centre", "Inertial"),
    ("slip in m/s", "traction.slip_unit", "MeterPerSecond"),
    ("slip in percent of rolling", "traction.slip_unit", "PercentOfRolling"),
    ("λ 5 per m/s", "traction.slip_unit", "Scaled(per_m_s: 5.0)"),
    ("λ 22 per m/s", "traction.slip_unit", "Scaled(per_m_s: 22.0)"),
    ("straight lines", "traction.order", "1"),
    ("fixed traction parameters", "traction.varying", "false"),
    ("no differential slip", "traction.differential_slip", "false"),
    ("drag coefficient 0.1", "fluid.drag_coefficient", "0.1"),
    ("drag coefficient 0.32", "fluid.drag_coefficient", "0.32"),
    ("drag coefficient 0.75", "fluid.drag_coefficient", "0.75"),
    ("no churning", "fluid.churning", "false"),
    ("pitch diameter 167.5 mm", "geometry.pitch_diameter", "mm(167.5)"),
    ("balls of 3200 kg/m³", "materials.ball.density", "kg_per_m3(3200)"),
    ("half of the speed", "speed.inner", "Constant(rpm(7000))"),
    ("Dormand–Prince", "transient.scheme", "DormandPrince(tolerance: 1e-8, longest: us(10))"),
    ("pocket force as printed", "modelling.pocket_force", "AsPrinted"),
    ("rolling radius deformed", "modelling.rolling_radius", "Deformed"),
    ("no gyroscopic moment with traction", "modelling.gyroscopic_moment", "Absent"),
    ("elastic patch", "modelling.patch", "Elastic(strips: 5, cells: 8)"),
    ("tilt of 0.5 mrad about y", "ring.tilt_y", "Held(mrad(0.5))"),
    ("balls 0.5 µm apart in size", "deviations", UNEQUAL),
    ("defect 0.2 µm deep", "defects", "[(race: Outer, azimuth: deg(0), width: deg(4), depth: um(0.2), bare: 0)]"),
];

/// Balls whose sizes are spread evenly over 0.5 µm, in no order.
const UNEQUAL: &str = "(balls: Excess([um(0.083), um(-0.208), um(0.25), um(-0.042), um(-0.125), um(0.167), um(0), \
    um(-0.25), um(0.208), um(0.042), um(-0.167), um(0.125), um(-0.083)]))";

/// Shaft frequency of the case, Hz, the time step of a rotating force's table, s, and its end, s.
const SHAFT_HZ: f64 = 14_000.0 / 60.0;
const UNBALANCE_STEP: f64 = 2e-4;
const UNBALANCE_END: f64 = 0.2;

/// All of them for a reading's cases, the unchanged one first.
///
/// # Errors
///
/// The reading's case cannot be read.
pub fn all(reading: &Reading) -> Result<Vec<Change>, PaperError> {
    let mut out = vec![Change::none("as identified")];
    let scaled = hidden(reading)?.into_iter();
    out.extend(scaled.map(|(name, path, value)| Change::none(&name).with(path, &value)));
    out.extend(SINGLE.map(|(name, path, value)| Change::none(name).with(path, value)));
    out.extend([guided("Inner", 68.0), guided("Outer", 84.0), churned()]);
    out.extend(loads(reading));
    out.push(unbalance(reading, 1000.0));
    Ok(out)
}

/// Hidden parameters, each halved and doubled: a name, a path, a value.
///
/// # Errors
///
/// The reading's case cannot be read.
pub fn hidden(reading: &Reading) -> Result<Vec<(String, &'static str, String)>, PaperError> {
    let text = files::read(&files::root().join(reading.ag))?;
    let of = |path: &'static str| {
        let value = locate(&text, path).map_or("", |range| &text[range]);
        [("half", 0.5), ("double", 2.0)].map(|(word, factor)| (format!("{path} {word}"), path, scaled(value, factor)))
    };
    Ok(HIDDEN.into_iter().flat_map(of).collect())
}

/// A value of a case with each of its numbers multiplied.
fn scaled(value: &str, factor: f64) -> String {
    let word = |c: char| c.is_alphanumeric() || "_.".contains(c);
    let mut out = String::new();
    let mut rest = value;
    while let Some(first) = rest.chars().next() {
        let length = rest.find(|c| word(c) != word(first)).unwrap_or(rest.len());
        let (part, after) = rest.split_at(length);
        match part.parse::<f64>() {
            Ok(number) => out.push_str(&(factor * number).to_string()),
            Err(_) => out.push_str(part),
        }
        rest = after;
    }
    out
}

/// The case's cage on a land of so many millimetres radius, with the film that drags or brakes it.
fn guided(land: &str, radius_mm: f64) -> Change {
    let guidance = format!("(land: {land}, radius: mm({radius_mm}), width: mm(10), gap: mm(0.4))");
    Change::none(&format!("cage guided by the {} ring", land.to_lowercase())).with("cage.guidance", &guidance)
}

/// The cage braked by the fluid round it in place of a constant torque: the paper's M_c. Dimensions of the catalogue's
/// cage of a 7224.
fn churned() -> Change {
    Change::none("cage's churning by its form")
        .with("cage.drag_torque", "Nm(0)")
        .with("cage.churning", "(bore: mm(149.85), outside: mm(180), width: mm(37.7))")
}

/// Loads that the paper's percentages may refer to.
fn loads(reading: &Reading) -> [Change; 6] {
    let axial = |name: &str, axial_share: f64| Change { axial_share, ..Change::none(name) };
    let drag = "drag coefficient 0.32 and radial load lowered with the axial one";
    let half = format!("Force(N({}))", 0.5 * reading.radial_load);
    [
        axial("half of the axial loads", 0.5),
        axial("axial loads × 2", 2.0),
        Change::none("half of the radial load").with("ring.x", &half),
        Change::none("radial load 2 kN").with("ring.x", "Force(kN(2))"),
        Change { radial_follows: true, ..Change::none("radial load lowered with the axial one") },
        Change { radial_follows: true, ..Change::none(drag).with("fluid.drag_coefficient", "0.32") },
    ]
}

/// A force on the inner ring that turns with the shaft beside the radial load, N.
fn unbalance(reading: &Reading, force: f64) -> Change {
    let rows = (UNBALANCE_END / UNBALANCE_STEP).round() as usize;
    let table = |constant: f64, phase: f64| {
        let mut text = "ForceTable([".to_owned();
        for k in 0..=rows {
            let time = UNBALANCE_STEP * k as f64;
            // The last row is the steady load.
            let turning = if k == rows { 0.0 } else { force * (TAU * SHAFT_HZ * time + phase).cos() };
            let _ = write!(text, "(s({time:.6}), N({:.3})),", constant + turning);
        }
        text + "])"
    };
    let quarter = -0.25 * TAU;
    Change::none("unbalance of 1 kN")
        .with("ring.x", &table(reading.radial_load, 0.0))
        .with("ring.y", &table(0.0, quarter))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transient::{AUTHORS, CLASSICAL};
    use tribodyn_case::{Case, set_value};

    /// Each change leads to a case that can be read and that differs from the one it starts from.
    #[test]
    fn identity_every_change_is_a_case_of_its_own() {
        for reading in [&AUTHORS, &CLASSICAL] {
            let text = files::read(&files::root().join(reading.ag)).unwrap();
            let unchanged = Case::from_ron(&text).unwrap();
            let mut names = std::collections::BTreeSet::new();
            for change in all(reading).unwrap() {
                assert!(names.insert(change.name.clone()) && !change.name.contains(','), "{}", change.name);
                let set = |text: String, (path, value): &(String, String)| set_value(&text, path, value).unwrap();
                let case = change.values.iter().fold(text.clone(), set);
                let case = Case::from_ron(&case).unwrap_or_else(|e| panic!("{}: {e}", change.name));
                let loads = change.axial_share != 1.0 || change.radial_follows;
                assert_eq!(case != unchanged, !change.values.is_empty(), "{}", change.name);
                assert!(loads || !change.values.is_empty() || change.name == "as identified", "{}", change.name);
            }
        }
    }

    #[test]
    fn identity_numbers_are_scaled_and_units_are_not() {
        assert_eq!(scaled("kg_m2(0.002)", 0.5), "kg_m2(0.001)");
        assert_eq!(scaled("(N_per_um(500), N_per_um(4e2))", 2.0), "(N_per_um(1000), N_per_um(800))");
        assert_eq!(scaled("Scaled(per_m_s: 100.0)", 2.0), "Scaled(per_m_s: 200)");
    }
}
