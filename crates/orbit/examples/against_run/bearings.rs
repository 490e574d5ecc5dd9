//! The bearings whose orbits are held against runs: case files with changes.

/// A bearing.
#[derive(Clone)]
pub struct Compared {
    pub name: &'static str,
    /// Case file in `fixtures/cases`.
    file: &'static str,
    /// Changes to it, path and value.
    changes: Vec<(&'static str, &'static str)>,
}

/// A 6206 of the catalogue's dimensions, C0. Free along its axis it centres itself; z = 0 is where its balls touch both
/// grooves.
const DEEP_GROOVE: [(&str, &str); 7] = [
    ("geometry.ball_count", "9"),
    ("geometry.ball_diameter", "mm(9.525)"),
    ("geometry.pitch_diameter", "mm(46)"),
    ("geometry.inner_groove", "Coefficient(0.515)"),
    ("geometry.outer_groove", "Coefficient(0.525)"),
    ("geometry.fit", "RadialClearance(um(13))"),
    ("ring.z", "Force(N(0))"),
];
const TURBOPUMP: &str = "paper-ag";
const ANGULAR: &str = "angular-7210";

/// All of them.
pub fn bearings() -> Vec<Compared> {
    [turbopump(), angular(), deep_groove()].concat()
}

fn changed(name: &'static str, file: &'static str, changes: &[(&'static str, &'static str)]) -> Compared {
    Compared { name, file, changes: changes.to_vec() }
}

fn turbopump() -> Vec<Compared> {
    let of = |name, changes: &[_]| changed(name, TURBOPUMP, changes);
    let guided = "(land: Outer, radius: mm(90), width: mm(12), gap: mm(0.3))";
    vec![
        of("paper, silver", &[]),
        changed("paper, PTFE", "paper-ptfe", &[]),
        of("paper, fixed parameters", &[("traction.varying", "false")]),
        of("paper, axial only", &[("ring.x", "Force(kN(0))")]),
        of("paper, 5 kN axial, 2 kN radial", &[("ring.x", "Force(kN(2))"), ("ring.z", "Force(kN(5))")]),
        of("paper, guided cage", &[("cage.guidance", guided)]),
    ]
}

fn angular() -> Vec<Compared> {
    let of = |name, changes: &[_]| changed(name, ANGULAR, changes);
    let half = ("ring.x", "Force(kN(2))");
    vec![
        of("7210, 3 kN axial, 4 kN radial, 6000 r/min", &[]),
        of("the same at 1000 r/min", &[("speed.inner", "Constant(rpm(1000))")]),
        of("the same at 12 000 r/min", &[("speed.inner", "Constant(rpm(12000))")]),
        of("7210, 3 kN, 2 kN", &[half]),
        of("7210, 300 N, 400 N", &[("ring.x", "Force(N(400))"), ("ring.z", "Force(N(300))")]),
        of("7210, 3 kN axial only", &[("ring.x", "Force(kN(0))")]),
        of("7210, 3 kN, 8 kN", &[("ring.x", "Force(kN(8))")]),
        of("7210, 3 kN, 2 kN, outer ring at 2000 r/min", &[half, ("speed.outer", "Constant(rpm(2000))")]),
        of("7210, 3 kN, 2 kN, outer ring at −3000 r/min", &[half, ("speed.outer", "Constant(rpm(-3000))")]),
        of(
            "7210, 3 kN, 2 kN, outer ring alone at 6000 r/min",
            &[half, ("speed.inner", "Constant(rpm(0))"), ("speed.outer", "Constant(rpm(6000))")],
        ),
        of("7210, 3 kN, 4 kN, 0.1 N m on the cage", &[("cage.drag_torque", "Nm(0.1)")]),
        of("7210, 3 kN, 2 kN, 0.3 N m on the cage", &[half, ("cage.drag_torque", "Nm(0.3)")]),
    ]
}

fn deep_groove() -> Vec<Compared> {
    let of = |name, changes: &[_]| changed(name, ANGULAR, &[&DEEP_GROOVE, changes].concat());
    let (light, heavy) = (("ring.x", "Force(N(100))"), ("ring.x", "Force(kN(2))"));
    let loose = ("geometry.fit", "RadialClearance(um(60))");
    vec![
        of("6206, 2 kN radial, clearance 13 µm, 6000 r/min", &[heavy]),
        of("6206, 100 N", &[light]),
        of("6206, 100 N, clearance 60 µm: one loaded ball", &[light, loose]),
        of("6206, 100 N, held along its axis", &[light, ("ring.z", "Held(um(0))")]),
        of("6206, 2 kN, 0.02 N m on the cage", &[heavy, ("cage.drag_torque", "Nm(0.02)")]),
    ]
}

impl Compared {
    /// The text of its case.
    pub fn text(&self) -> Result<String, Box<dyn std::error::Error>> {
        let path = format!("{}/../../fixtures/cases/{}.ron", env!("CARGO_MANIFEST_DIR"), self.file);
        let mut text = std::fs::read_to_string(path)?;
        for (path, value) in &self.changes {
            text = tribodyn_case::set_value(&text, path, value)?;
        }
        Ok(text)
    }
}
