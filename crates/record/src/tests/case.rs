//! The case behind the made-up solution.

use tribodyn_bearing::{OperatingPoint, RunInputs};
use tribodyn_case::Case;

/// A bearing of the 7224 envelope.
pub(crate) const TEXT: &str = r#"(
    name: "7224, made-up loads",
    geometry: (
        ball_count: 13,
        ball_diameter: mm(30.16),
        pitch_diameter: mm(167.5),
        inner_groove: Coefficient(0.525),
        outer_groove: Coefficient(0.53),
        fit: ContactAngle(deg(18.0)),
    ),
    materials: (
        ball: (young: GPa(208.0), poisson: 0.3, density: kg_per_m3(7800.0)),
        inner: (young: GPa(208.0), poisson: 0.3, density: kg_per_m3(7800.0)),
        outer: (young: GPa(208.0), poisson: 0.3, density: kg_per_m3(7800.0)),
    ),
    coatings: (
        inner: (curve: Library("ag"), thickness: um(10.0)),
        outer: (curve: Library("ag"), thickness: um(10.0)),
    ),
    traction: (
        slip_unit: Scaled(per_m_s: 22.0),
        order: 2,
        varying: true,
        reference_pressure: GPa(2.5),
        differential_slip: true,
        pressure: Peak,
        patch: TargetError(relative: 1e-5),
    ),
    cage: (
        pocket_gap: mm(0.12),
        pocket_stiffness: N_per_m(1e7),
        pocket_friction: 0.1,
        drag_torque: Nm(0.0),
        inertia: kg_m2(0.002),
    ),
    supports: (
        inner: (
            mass: kg(12),
            stiffness: (N_per_um(0), N_per_um(0), N_per_um(0)),
            damping: (N_s_per_m(2000), N_s_per_m(2000), N_s_per_m(2000)),
        ),
        outer: (
            mass: kg(5),
            stiffness: (N_per_um(500), N_per_um(500)),
            damping: (N_s_per_m(5000), N_s_per_m(5000)),
        ),
    ),
    transient: (
        duration: s(1),
        start: QuasiStatic,
        scheme: RungeKutta4(step: us(5)),
        contact_damping: 0.02,
        wear_acceleration: 0,
    ),
    wear: (
        inner: (coefficient: 1e-6, hardness: GPa(6.0)),
        outer: (coefficient: 1e-6, hardness: GPa(6.0)),
        cage: (coefficient: 1e-5, hardness: GPa(0.2)),
    ),
    ring: (
        x: Force(kN(9.0)),
        y: Force(kN(0.0)),
        z: Force(kN(21.0)),
        tilt_x: Held(rad(1e-5)),
        tilt_y: Held(rad(2e-5)),
    ),
    speed: (inner: Constant(rpm(14000.0)), outer: Constant(rpm(0.0))),
    modelling: (contact_at_actual_angle: false, ring_centre: Displaced),
)
"#;

/// A case made into what the solvers take.
pub(crate) struct Made {
    pub name: String,
    pub inputs: RunInputs,
    pub point: OperatingPoint,
}

impl Made {
    /// Of a case with all that a run needs.
    pub fn of(case: &Case) -> Self {
        let inputs = case.run_inputs().expect("a case that runs");
        Self { name: case.name.clone(), inputs, point: case.operating_point() }
    }
}

/// The case with another number of balls.
pub(crate) fn case(ball_count: usize) -> Made {
    let mut case = Case::from_ron(TEXT).expect("the text above is a sound case");
    case.geometry.ball_count = ball_count;
    Made::of(&case)
}
