//! The bearings whose orbits are held against runs: case files with changes.

/// A bearing.
#[derive(Clone)]
#[allow(dead_code, reason = "tests run no turns")]
pub struct Compared {
    pub name: &'static str,
    /// Case file in `fixtures/cases`.
    file: &'static str,
    /// Changes to it, path and value.
    changes: Vec<(&'static str, &'static str)>,
    /// Turns of the cage with its own inertia, with that of a heavy one, and those of the mean.
    pub turns: [f64; 3],
    /// True where the run starts from the orbit: from the equilibrium, with balls far from where they end, it does not
    /// come through.
    pub from_orbit: bool,
    /// How much heavier its rings are than those of others: each ball that enters the load of a light bearing would
    /// move those of the others by a part of it. Such rings do not find their place from elsewhere.
    pub heavy: f64,
}

const TURNS: [f64; 3] = [6.0, 40.0, 20.0];
/// Where a turn takes long, in time or by an explicit scheme.
const FEW: [f64; 3] = [4.0, 5.0, 5.0];
/// From the orbit there is nothing to wait for.
const AT_ONCE: [f64; 3] = [1.0, 1.0, 20.0];
/// Where a heavy cage would take hundreds of turns to come to the speed of the orbit from another.
const STAYING: [f64; 3] = [0.0, 2.0, 10.0];

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
    Compared { name, file, changes: changes.to_vec(), turns: TURNS, from_orbit: false, heavy: 1.0 }
}

fn staying(bearing: Compared) -> Compared {
    Compared { from_orbit: true, turns: STAYING, ..bearing }
}

fn turbopump() -> Vec<Compared> {
    let explicit = ("transient.scheme", "RungeKutta4(step: us(4))");
    let paper =
        |name, file, changes: &[_]| Compared { turns: FEW, ..changed(name, file, &[&[explicit], changes].concat()) };
    let guided = "(land: Outer, radius: mm(90), width: mm(12), gap: mm(0.3))";
    let fifth = [("ring.x", "Force(kN(2))"), ("ring.z", "Force(kN(5))")];
    vec![
        paper("paper, silver", TURBOPUMP, &[]),
        paper("paper, PTFE", "paper-ptfe", &[]),
        paper("paper, fixed parameters", TURBOPUMP, &[("traction.varying", "false")]),
        paper("paper, axial only", TURBOPUMP, &[("ring.x", "Force(kN(0))")]),
        staying(paper("paper, 5 kN axial, 2 kN radial", TURBOPUMP, &fifth)),
        staying(paper("paper, guided cage", TURBOPUMP, &[("cage.guidance", guided)])),
    ]
}

fn angular() -> Vec<Compared> {
    let of = |name, changes: &[_]| changed(name, ANGULAR, changes);
    let half = ("ring.x", "Force(kN(2))");
    vec![
        of("7210, 3 kN axial, 4 kN radial, 6000 r/min", &[]),
        staying(of("the same at 1000 r/min", &[("speed.inner", "Constant(rpm(1000))")])),
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
    // What the fast scheme takes for linear is a part of so small a torque.
    let fine = ("transient.scheme", "RungeKutta4(step: us(2))");
    let light = |name, changes: &[_]| Compared {
        from_orbit: true,
        heavy: 100.0,
        turns: AT_ONCE,
        ..of(name, &[&[fine], changes].concat())
    };
    let finer = ("transient.scheme", "RungeKutta4(step: us(0.5))");
    let dragged = [finer, ("ring.x", "Force(kN(2))"), ("cage.drag_torque", "Nm(0.02)")];
    let loose = [("ring.x", "Force(N(100))"), ("geometry.fit", "RadialClearance(um(60))")];
    vec![
        Compared {
            from_orbit: true,
            ..of("6206, 2 kN radial, clearance 13 µm, 6000 r/min", &[("ring.x", "Force(kN(2))")])
        },
        light("6206, 100 N", &[("ring.x", "Force(N(100))")]),
        light("6206, 100 N, clearance 60 µm: one loaded ball", &loose),
        light("6206, 100 N, held along its axis", &[("ring.x", "Force(N(100))"), ("ring.z", "Held(um(0))")]),
        light("6206, 2 kN, 0.02 N m on the cage", &dragged),
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
