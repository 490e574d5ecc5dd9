//! Changes, one at a time.

use crate::transient::Change;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Parameter, half and double.
pub const HIDDEN: [(&str, [&str; 2]); 11] = [
    ("cage.pocket_gap", ["mm(0.355)", "mm(1.42)"]),
    ("cage.pocket_stiffness", ["N_per_um(2.5)", "N_per_um(10)"]),
    ("cage.pocket_friction", ["0.05", "0.2"]),
    ("cage.pocket_damping", ["s_per_m(0.15)", "s_per_m(0.6)"]),
    ("cage.inertia", ["kg_m2(0.001)", "kg_m2(0.004)"]),
    ("supports.inner.mass", ["kg(6)", "kg(24)"]),
    ("supports.outer.mass", ["kg(2.5)", "kg(10)"]),
    ("supports.outer.stiffness", ["(N_per_um(250), N_per_um(250))", "(N_per_um(1000), N_per_um(1000))"]),
    ("supports.outer.damping", ["(N_s_per_m(2500), N_s_per_m(2500))", "(N_s_per_m(10000), N_s_per_m(10000))"]),
    ("transient.contact_damping", ["0.01", "0.04"]),
    ("traction.slip_unit", ["Scaled(per_m_s: 50.0)", "Scaled(per_m_s: 200.0)"]),
];

/// Further changes that are one value each: a name, a path, a value. Local pressure is not among them: it leaves the
/// fast scheme without its derivative, and 20 µs are too long without.
const SINGLE: [(&str, &str, &str); 41] = [
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
];

/// Shaft frequency of the case, Hz, the time step of a rotating force's table, s, and its end, s.
const SHAFT_HZ: f64 = 14_000.0 / 60.0;
const UNBALANCE_STEP: f64 = 2e-4;
const UNBALANCE_END: f64 = 0.2;

/// All of them, the unchanged one first.
pub fn all() -> Vec<Change> {
    let mut out = vec![Change::none("as identified")];
    for (path, values) in HIDDEN {
        let both = ["half", "double"].into_iter().zip(values);
        out.extend(both.map(|(word, value)| Change::none(&format!("{path} {word}")).with(path, value)));
    }
    out.extend(SINGLE.map(|(name, path, value)| Change::none(name).with(path, value)));
    out.extend([guided("Inner", 68.0), guided("Outer", 84.0)]);
    out.extend(loads());
    out.push(unbalance(1000.0));
    out
}

/// The case's cage on a land of so many millimetres radius, with the film that drags or brakes it.
fn guided(land: &str, radius_mm: f64) -> Change {
    let cage = format!(
        "(pocket_gap: mm(0.71), pocket_stiffness: N_per_um(5), pocket_friction: 0.1, drag_torque: Nm(0), inertia: \
        kg_m2(0.002), pocket_damping: s_per_m(0.3), guidance: (land: {land}, radius: mm({radius_mm}), width: mm(10), \
        gap: mm(0.4)))"
    );
    Change::none(&format!("cage guided by the {} ring", land.to_lowercase())).with("cage", &cage)
}

/// Loads that the paper's percentages may refer to.
fn loads() -> [Change; 6] {
    let axial = |name: &str, axial_share: f64| Change { axial_share, ..Change::none(name) };
    let drag = "drag coefficient 0.32 and radial load lowered with the axial one";
    [
        axial("half of the axial loads", 0.5),
        axial("axial loads × 2", 2.0),
        Change::none("half of the radial load").with("ring.x", "Force(kN(11.49))"),
        Change::none("radial load 2 kN").with("ring.x", "Force(kN(2))"),
        Change { radial_follows: true, ..Change::none("radial load lowered with the axial one") },
        Change { radial_follows: true, ..Change::none(drag).with("fluid.drag_coefficient", "0.32") },
    ]
}

/// A force on the inner ring that turns with the shaft beside the radial load, N.
fn unbalance(force: f64) -> Change {
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
    Change::none("unbalance of 1 kN").with("ring.x", &table(22_980.0, 0.0)).with("ring.y", &table(0.0, quarter))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files;
    use tribodyn_case::{Case, set_value};

    /// Each change leads to a case that can be read and that differs from the one it starts from.
    #[test]
    fn identity_every_change_is_a_case_of_its_own() {
        let text = files::read(&files::root().join("fixtures/cases/paper-ag.ron")).unwrap();
        let unchanged = Case::from_ron(&text).unwrap();
        let mut names = std::collections::BTreeSet::new();
        for change in all() {
            assert!(names.insert(change.name.clone()) && !change.name.contains(','), "{}", change.name);
            let case =
                change.values.iter().fold(text.clone(), |text, (path, value)| set_value(&text, path, value).unwrap());
            let case = Case::from_ron(&case).unwrap_or_else(|e| panic!("{}: {e}", change.name));
            let loads = change.axial_share != 1.0 || change.radial_follows;
            assert_eq!(case != unchanged, !change.values.is_empty(), "{}", change.name);
            assert!(loads || !change.values.is_empty() || change.name == "as identified", "{}", change.name);
        }
    }
}
