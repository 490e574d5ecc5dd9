//! A bearing that nothing holds, drives or brakes: linear momentum, angular momentum and energy stay.

use crate::layout::{AXIAL, AZIMUTH, OMEGA, ORBIT, RADIUS, VELOCITY};
use crate::machine::Machine;
use crate::start::{Started, start};
use crate::stepping_test::{Scheme, run};
use tribodyn_bearing::{AzimuthFrame, Races, RingOffset, Translation};
use tribodyn_case::{Case, set_value};
use tribodyn_traction::{Conditions, CurveNumber, CustomCurve, CustomLaw, Law, OverSlip};

/// No friction at any slip.
#[derive(Debug, Clone, Copy)]
struct Frictionless;

impl CustomLaw for Frictionless {
    type Curve = Self;
    fn under(&self, _: &Conditions) -> Self {
        *self
    }
}

impl CustomCurve for Frictionless {
    fn over_slip<N: CurveNumber>(&self, slip: N) -> OverSlip<N> {
        let none = slip.constant(0.0);
        OverSlip { value: none, slope: none, by_pressure: none, by_entrainment: None }
    }
}

/// The paper's bearing set free of supports, loads, cage and fluid, both rings moving.
fn free(case: &str, friction: bool) -> (Machine, Vec<f64>) {
    let changes = [
        ("traction.patch", "GaussJacobi(radial: 3, angles: 8)"),
        ("traction.slip_unit", "MeterPerSecond"),
        ("transient.contact_damping", "0.0"),
        ("cage.pocket_stiffness", "N_per_um(0)"),
        ("cage.drag_torque", "Nm(0)"),
    ];
    let text = changes.iter().fold(case.to_owned(), |t, (path, value)| set_value(&t, path, value).unwrap());
    let case = Case::from_ron(&text).unwrap();
    let Started { mut machine, mut state, .. } = start(case.run_inputs().unwrap(), None).unwrap();
    machine.bearing.fluid = None;
    machine.cage.guidance = None;
    if !friction {
        let tribology = machine.bearing.tribology.as_mut().unwrap();
        tribology.laws = Races::from_fn(|_| Law::custom(Frictionless));
        tribology.bare_law = None;
    }
    machine.loads[0] = Translation::Force(0.0);
    machine.loads[1] = Translation::Force(0.0);
    (machine.inner.stiffness, machine.inner.damping) = ([0.0; 3], [0.0; 3]);
    (machine.outer.stiffness, machine.outer.damping) = ([0.0; 2], [0.0; 2]);
    let l = machine.layout;
    let (i, o) = (l.inner(), l.outer());
    state[i + 3..i + 5].copy_from_slice(&[0.02, -0.01]);
    state[o..o + 4].copy_from_slice(&[-8e-6, 5e-6, -0.01, 0.03]);
    (machine, state)
}

/// Linear momentum along x and y (N s), angular momentum about z (N m s), and energy less the work of the axial load
/// (J).
fn totals(machine: &Machine, t: f64, y: &[f64]) -> [f64; 4] {
    let l = machine.layout;
    let [i, o] = [l.inner(), l.outer()];
    let rings = [(machine.inner.mass, i, i + 3), (machine.outer.mass, o, o + 2)];
    let mut sum =
        [0.0, 0.0, machine.cage.inertia * y[l.cage() + 1], machine.energy(t, y) - y[l.work()] + y[l.work() + 1]];
    for (mass, x, v) in rings {
        (0..2).for_each(|k| sum[k] += mass * y[v + k]);
        sum[2] += mass * (y[x] * y[v + 1] - y[x + 1] * y[v]);
    }
    for index in 0..l.balls {
        let (b, size) = (machine.unknowns(index, y), machine.bearing.ball_size(index));
        let (m, j) = (machine.bearing.mass_of(&size), machine.bearing.inertia_of(&size));
        let velocity = [b[VELOCITY + AXIAL], b[VELOCITY + RADIUS], b[RADIUS] * b[ORBIT]];
        let [v_x, v_y, _] = AzimuthFrame::at(b[AZIMUTH]).to_inertial(velocity);
        sum[0] += m * v_x;
        sum[1] += m * v_y;
        sum[2] += m * b[RADIUS] * b[RADIUS] * b[ORBIT] + j * b[OMEGA];
    }
    sum
}

/// Changes of the totals over 1 ms, over the momentum and angular momentum of one ball and the elastic energy's order.
fn changes(scheme: Scheme, (machine, state): (Machine, Vec<f64>), h: f64) -> [f64; 4] {
    let (mut machine, mut state) = (machine, state);
    let ball = machine.unknowns(0, &state);
    let m = machine.bearing.ball_mass;
    let momentum = m * ball[RADIUS] * ball[ORBIT];
    let scales = [momentum, momentum, momentum * ball[RADIUS], 1.0];
    let before = totals(&machine, 0.0, &state);
    run(scheme, (&mut machine, &mut state), h, (1e-3 / h).round() as u32);
    let after = totals(&machine, 1e-3, &state);
    std::array::from_fn(|k| ((after[k] - before[k]) / scales[k]).abs())
}

const PAPER: &str = include_str!("../../../fixtures/cases/paper-ag.ron");
const DEFECT: &str = include_str!("../../../fixtures/cases/paper-ag-defect.ron");

#[test]
fn identity_momentum_angular_momentum_and_energy_stay_without_friction() {
    for scheme in [Scheme::RungeKutta, Scheme::DormandPrince] {
        let [x, y, turning, energy] = changes(scheme, free(PAPER, false), 2e-6);
        assert!(x < 1e-9 && y < 1e-9 && turning < 1e-10, "{x:e} {y:e} {turning:e}");
        // Of some 5 J in the contacts, whose vibration of 14 kHz the schemes damp a little.
        assert!(energy < 1e-4, "{energy:e} J");
    }
}

/// Friction and the slopes of a defect are forces between balls and rings, too.
#[test]
fn identity_momentum_stays_with_friction_and_a_defect() {
    let [x, y, ..] = changes(Scheme::RungeKutta, free(PAPER, true), 2e-6);
    assert!(x < 1e-9 && y < 1e-9, "{x:e} {y:e}");
    let [x, y, ..] = changes(Scheme::RungeKutta, free(DEFECT, true), 2e-6);
    assert!(x < 1e-7 && y < 1e-7, "with a defect {x:e} {y:e}");
}

/// The elastic patch and the deformed ball change friction, not what rings and balls do to each other.
#[test]
fn identity_momentum_stays_under_every_reading_of_friction() {
    let readings = [("modelling.patch", "Elastic(strips: 4, cells: 6)"), ("modelling.rolling_radius", "Deformed")];
    for (path, value) in readings {
        let case = set_value(PAPER, path, value).unwrap();
        for (scheme, h, allowed) in
            [(Scheme::RungeKutta, 4e-6, 1e-9), (Scheme::DormandPrince, 4e-6, 1e-9), (Scheme::Fast, 5e-6, 1e-4)]
        {
            let [x, y, ..] = changes(scheme, free(&case, true), h);
            assert!(x.hypot(y) < allowed, "{value}: {x:e} {y:e}");
        }
    }
}

/// In polar coordinates, and with a part of the springs' force handed to the kick, the fast scheme keeps the momentum
/// to its second order, and the angular momentum.
#[test]
fn identity_the_fast_scheme_keeps_momentum_to_its_order() {
    let [x, y, turning, _] = changes(Scheme::Fast, free(PAPER, false), 10e-6);
    let [finer_x, finer_y, finer_turning, _] = changes(Scheme::Fast, free(PAPER, false), 5e-6);
    let (coarse, fine) = (x.hypot(y), finer_x.hypot(finer_y));
    assert!(coarse < 1e-6 && fine < 0.3 * coarse, "{coarse:e} {fine:e}");
    assert!(turning < 1e-12 && finer_turning < 1e-12, "{turning:e} {finer_turning:e}");
}

/// A spall of a ball, or its waves, take from the rotation what they give to the orbit: linear and angular momentum
/// stay.
#[test]
fn identity_momentum_stays_with_spalls_and_waves_of_balls() {
    let spall = "[(ball: 2, angle: deg(30), length: mm(2), width: mm(6), depth: um(300), edge_radius: um(50))]";
    let waves = "(spectrum: (first: 2, last: 12, amplitude: um(1), exponent: 1, seed: 3))";
    for (path, value) in [("ball_spalls", spall), ("deviations.ball_waves", waves)] {
        let case = set_value(PAPER, path, value).unwrap();
        for friction in [false, true] {
            let [x, y, turning, energy] = changes(Scheme::RungeKutta, free(&case, friction), 1e-6);
            assert!(x < 1e-9 && y < 1e-9, "{path} {x:e} {y:e}");
            assert!(friction || (turning < 1e-9 && energy < 1e-4), "{path} {turning:e} {energy:e} J");
        }
    }
}

/// The reaction of the tangential normal force is what linear momentum needs.
#[test]
fn limit_offsets_to_first_order_lose_linear_momentum() {
    let (mut machine, state) = free(PAPER, false);
    machine.bearing.ring_offset = RingOffset::FirstOrder;
    let [x, y, ..] = changes(Scheme::RungeKutta, (machine, state), 2e-6);
    assert!(x.hypot(y) > 1e-5, "{x:e} {y:e}");
}

/// Balls of unequal size have their own mass, inertia and radius: with those of the drawing in the sums, momentum would
/// not stay.
#[test]
fn identity_momentum_angular_momentum_and_energy_stay_with_unequal_balls() {
    let sizes: Vec<String> = (0..13).map(|k| format!("um({})", 20 * (k * 5 % 7) - 60)).collect();
    let case = set_value(PAPER, "deviations.balls", &format!("Excess([{}])", sizes.join(", "))).unwrap();
    for scheme in [Scheme::RungeKutta, Scheme::DormandPrince] {
        let [x, y, turning, energy] = changes(scheme, free(&case, false), 2e-6);
        assert!(x < 1e-9 && y < 1e-9 && turning < 1e-10 && energy < 1e-4, "{x:e} {y:e} {turning:e} {energy:e} J");
        let [x, y, ..] = changes(scheme, free(&case, true), 2e-6);
        assert!(x < 1e-9 && y < 1e-9, "with friction {x:e} {y:e}");
    }
    let [x, y, turning, _] = changes(Scheme::Fast, free(&case, false), 5e-6);
    let [finer_x, finer_y, finer_turning, _] = changes(Scheme::Fast, free(&case, false), 2.5e-6);
    let (coarse, fine) = (x.hypot(y), finer_x.hypot(finer_y));
    assert!(coarse < 1e-6 && fine < 0.3 * coarse, "{coarse:e} {fine:e}");
    assert!(turning < 1e-12 && finer_turning < 1e-12, "{turning:e} {finer_turning:e}");
}

/// Waves and unequal balls push balls and rings against each other, and nothing else. (Angular momentum is not that of
/// balls and cage alone: races that are not round turn them, and the rings' drives have that.) The highest order passes
/// a ball at 4 kHz here.
#[test]
fn identity_momentum_and_energy_stay_with_waves_and_unequal_balls() {
    let spectrum = "(spectrum: (first: 2, last: 40, amplitude: um(1), exponent: 0.5, seed: 3))";
    let uneven = format!("(inner: {spectrum}, outer: {spectrum}, balls: Grade(grade: 100, seed: 2))");
    let case = set_value(PAPER, "deviations", &uneven).unwrap();
    for scheme in [Scheme::RungeKutta, Scheme::DormandPrince] {
        let [x, y, _, energy] = changes(scheme, free(&case, false), 2e-6);
        assert!(x < 1e-9 && y < 1e-9 && energy < 1e-4, "{x:e} {y:e} {energy:e} J");
    }
    let [x, y, ..] = changes(Scheme::RungeKutta, free(&case, true), 2e-6);
    assert!(x < 1e-9 && y < 1e-9, "with friction {x:e} {y:e}");
    let [x, y, ..] = changes(Scheme::Fast, free(&case, false), 10e-6);
    let [finer_x, finer_y, ..] = changes(Scheme::Fast, free(&case, false), 5e-6);
    let (coarse, fine) = (x.hypot(y), finer_x.hypot(finer_y));
    assert!(coarse < 1e-5 && fine < 0.3 * coarse, "{coarse:e} {fine:e}");
}
