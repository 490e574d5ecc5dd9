//! A whirling cage among balls and rings: balances, symmetry, and whether all schemes have the same terms.

use crate::forces::evaluate;
use crate::layout::{OMEGA, ORBIT, RADIUS, VELOCITY};
use crate::machine::Machine;
use crate::start::{Started, start};
use crate::stepping_test::{Scheme, imbalance, run};
use crate::tilt_test::{BOTH, TILT, swing};
use tribodyn_bearing::{AzimuthFrame, Translation};
use tribodyn_case::{Case, set_value};

/// A land in each ring, the outer one in its fluid; tight pockets. Gaps of 0.1 mm about a cage that starts off centre.
const FREE: &str = "(mass: kg(0.33), transverse_inertia: kg_m2(0.0011), unbalance: um(30),
    gravity: (m_per_s2(-9.81), m_per_s2(0), m_per_s2(0)), displacement: (um(80), um(50)), pockets: POCKETS, lands: [
    (land: Outer, axial: mm(2), radius: mm(86), width: mm(6), gap: mm(0.1), stiffness: N_per_um(5),
     damping: s_per_m(0.3), friction: FRICTION,
     film: (viscosity: uPa_s(120), density: kg_per_m3(770), fill: 0.8, extent: Half,
     roughness: um(2))),
    (land: Inner, radius: mm(70), width: mm(8), gap: mm(0.11), stiffness: N_per_um(5), friction: FRICTION)])";

fn case(pockets: &str, friction: &str, changes: &[(&str, &str)]) -> Case {
    let free = FREE.replace("POCKETS", pockets).replace("FRICTION", friction);
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let whirling = [
        ("traction.patch", "GaussJacobi(radial: 3, angles: 8)"),
        ("cage.pocket_gap", "mm(0.02)"),
        ("cage.free", free.as_str()),
    ];
    let text = whirling.iter().chain(changes).fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    Case::from_ron(&text).unwrap()
}

/// The machine of a case, its cage tilted and moving.
fn machine(case: &Case) -> (Machine, Vec<f64>) {
    let Started { machine, mut state, .. } = start(case.run_inputs().unwrap(), None).unwrap();
    let at = machine.layout.free().start;
    state[at + 3..at + 8].copy_from_slice(&[0.4, -0.3, 0.05, 3.0, -8.0]);
    (state[at + 8], state[at + 9]) = (4e-4, -3e-4);
    (machine, state)
}

const POCKETS: [&str; 3] = ["Cylinder", "Sphere", "RaceTrack(axial_gap: mm(0.01))"];

/// Both rings tilt and turn, under moments and on seats that stand askew.
fn tilting() -> Vec<(&'static str, &'static str)> {
    let moments = [("ring.tilt_x", "Moment(Nm(120))"), ("ring.tilt_y", "Moment(Nm(-60))"), ("supports.tilt", TILT)];
    moments.into_iter().chain(BOTH).collect()
}

/// The same as [`machine`] with rings that are tilted and swing, if they may.
fn swinging(case: &Case) -> (Machine, Vec<f64>) {
    let (machine, mut state) = machine(case);
    swing(&machine, &mut state);
    (machine, state)
}

#[test]
fn identity_power_balances_with_a_whirling_cage() {
    for (pockets, rings) in POCKETS.iter().flat_map(|pockets| [(pockets, Vec::new()), (pockets, tilting())]) {
        for scheme in [Scheme::RungeKutta, Scheme::DormandPrince] {
            let (mut machine, mut state) = swinging(&case(pockets, "0.2", &rings));
            let before = machine.energy(0.0, &state);
            // Short: edges and walls begin within steps.
            let (h, steps) = (0.125e-6, 3200);
            run(scheme, (&mut machine, &mut state), h, steps);
            let imbalance = imbalance(&machine, (h * f64::from(steps), &state), before);
            let frame = machine.frame(h * f64::from(steps), &state);
            let lands = machine.lands(&frame);
            assert!(lands.film_power > 0.0 && lands.losses() > 1.0, "{lands:?}");
            assert!(imbalance < 1e-9, "{pockets} {rings:?}: {imbalance:e}");
        }
    }
}

/// Forces on all bodies add up to those from outside, and their moments about the bearing's axis to those of the drives
/// and of what brakes balls and cage from outside, at a state where the cage touches lands and balls.
#[test]
fn identity_forces_and_moments_of_all_bodies_balance() {
    for pockets in POCKETS {
        let (mut machine, mut state) = machine(&case(pockets, "0.2", &[]));
        machine.bearing.fluid = None;
        machine.loads = [0, 1, 2].map(|_| Translation::Force(0.0));
        (machine.inner.free, machine.outer.free) = ([true; 3], [true; 2]);
        (machine.inner.stiffness, machine.inner.damping) = ([0.0; 3], [0.0; 3]);
        (machine.outer.stiffness, machine.outer.damping) = ([0.0; 2], [0.0; 2]);
        let cage = machine.free_cage.as_mut().unwrap();
        cage.gravity = [0.0; 3];
        let l = machine.layout;
        state[l.inner()..l.inner() + 2].copy_from_slice(&[3e-6, -2e-6]);
        state[l.outer()..l.outer() + 4].copy_from_slice(&[-8e-6, 5e-6, -0.01, 0.03]);
        state[l.free().start] += 4e-5;
        // Radial and axial momentum of the balls by their accelerations; the frame's turning is in those.
        let (m, j) = (machine.bearing.ball_mass, machine.bearing.ball_inertia);
        let (mut force, mut moment, mut largest) = ([0.0; 2], 0.0, 0.0f64);
        let unknowns = state.clone();
        let (frame, sums, bodies) = evaluate(&machine, 0.0, &state, |index, ball| {
            let b = machine.unknowns(index, &unknowns);
            let (r, w) = (b[RADIUS], b[ORBIT]);
            let [_, radial, orbital, about_axis, ..] = ball.acceleration;
            let along = r * orbital + 2.0 * b[VELOCITY + 1] * w;
            let [x, y, _] = AzimuthFrame::at(b[2]).to_inertial([0.0, radial - r * w * w, along]);
            (force[0], force[1]) = (force[0] + m * x, force[1] + m * y);
            moment += m * r * along + j * about_axis;
            largest = largest.max(ball.friction.pocket.normal);
            assert_eq!(OMEGA, 6);
        });
        let lands = machine.lands(&frame);
        assert!(largest > 10.0 && lands.force.outer[0].abs() > 1.0 && lands.force.inner[0].abs() > 1.0, "{lands:?}");
        let (cage, pose) = (machine.free_cage.as_ref().unwrap(), frame.free_cage.unwrap());
        let rates = bodies.free_cage.unwrap();
        for k in 0..2 {
            force[k] += machine.inner.mass * bodies.inner[k] + machine.outer.mass * bodies.outer[k];
            force[k] += cage.mass * rates[3 + k];
        }
        let size = sums.on_rings.inner[2].abs();
        assert!(force[0].hypot(force[1]) < 1e-9 * size, "{pockets}: {force:?} of {size}");
        for (x, a, mass) in [
            (l.inner(), [bodies.inner[0], bodies.inner[1]], machine.inner.mass),
            (l.outer(), bodies.outer, machine.outer.mass),
        ] {
            moment += mass * (state[x] * a[1] - state[x + 1] * a[0]);
        }
        // The cage's angular momentum, by what it becomes in a short time.
        let after = |h: f64| {
            let mut moved = state.clone();
            moved[l.cage()] += h * frame.cage[1];
            moved[l.cage() + 1] += h * bodies.cage;
            l.free().zip(rates).for_each(|(k, rate)| moved[k] += h * rate);
            cage.angular_momentum(&machine.cage_at(&moved).1.unwrap(), machine.cage.inertia)[2]
        };
        let h = 1e-8;
        moment += (after(h) - after(-h)) / (2.0 * h);
        let turned = moment - bodies.torque.inner - bodies.torque.outer - bodies.fluid_torque;
        let scale = cage.mass * pose.omega[2] * pose.omega[2] * 1e-3 + size * 0.08;
        assert!(turned.abs() < 1e-9 * scale, "{pockets}: {turned} of {scale}");
    }
}

/// Equal pockets and balls under an axial load push a balanced cage nowhere.
#[test]
fn identity_a_balanced_cage_stays_in_the_middle_under_an_axial_load() {
    let changes = [
        ("ring.x", "Force(N(0))"),
        ("cage.free.displacement", "(um(0), um(0))"),
        ("cage.free.unbalance", "um(0)"),
        ("cage.free.gravity", "(m_per_s2(0), m_per_s2(0), m_per_s2(0))"),
    ];
    let case = case("Cylinder", "0.2", &changes);
    let Started { mut machine, mut state, .. } = start(case.run_inputs().unwrap(), None).unwrap();
    // Faster than its balls, so that they push it from the start.
    let at = machine.layout.cage() + 1;
    state[at] *= 1.02;
    run(Scheme::RungeKutta, (&mut machine, &mut state), 2e-6, 400);
    let pose = machine.cage_at(&state).1.unwrap();
    let pushed = machine.unknowns(0, &state)[ORBIT];
    assert!(pushed != 0.0 && machine.pocket_depth(0, machine.unknowns(0, &state), ([0.0; 2], Some(&pose)))[0] > 0.0);
    let [x, y, _] = pose.centre;
    assert!(x.hypot(y) < 1e-12, "{x:e} {y:e}");
    let [tilt_x, tilt_y] = pose.tilt();
    assert!(tilt_x.hypot(tilt_y) < 1e-10, "{tilt_x:e} {tilt_y:e}");
}

/// The fast scheme goes where the Runge–Kutta method goes, and nearer with its second order: velocities, angular
/// velocities and places of the cage, and tilts of rings, if they do.
#[test]
fn identity_the_fast_scheme_has_the_same_cage() {
    for rings in [Vec::new(), tilting()] {
        let case = case("Cylinder", "0.2", &rings);
        let end = |scheme: Scheme, h: f64, steps: u32| {
            let (mut machine, mut state) = swinging(&case);
            run(scheme, (&mut machine, &mut state), h, steps);
            let (cage, pose) = machine.cage_at(&state);
            let (pose, tilts) = (pose.unwrap(), machine.tilts_at(&state));
            let ([x, y], [outer_x, outer_y]) = (tilts.inner.0, tilts.outer.0);
            let moved = [pose.velocity_at(pose.centre), pose.omega, pose.centre.map(|x| x * 1e4)];
            ([&moved[0][..], &moved[1], &moved[2], &[x, y], &[outer_x, outer_y]].map(<[f64]>::to_vec), cage)
        };
        let (exact, speed) = end(Scheme::RungeKutta, 0.5e-6, 800);
        let (start, _) = end(Scheme::RungeKutta, 0.5e-6, 0);
        let difference = |a: &[Vec<f64>; 5], b: &[Vec<f64>; 5]| {
            [0, 1, 2, 3, 4].map(|k| a[k].iter().zip(&b[k]).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt())
        };
        let way = difference(&start, &exact);
        let (fast, speed_of_fast) = end(Scheme::Fast, 1e-6, 400);
        let (finer, _) = end(Scheme::Fast, 0.5e-6, 800);
        let (errors, fine) = (difference(&fast, &exact), difference(&finer, &exact));
        for k in 0..if rings.is_empty() { 3 } else { 5 } {
            assert!(errors[k] < 0.02 * way[k], "{k}: {errors:?} of {way:?}");
            assert!(fine[k] < 0.6 * errors[k], "{k}: {fine:?} {errors:?}");
        }
        assert!((speed[1] - speed_of_fast[1]).abs() < 1e-3 * speed[1].abs(), "{speed:?} {speed_of_fast:?}");
    }
}

/// A cage of 0.33 kg that is pressed with 6.6 kN into oil: its film settles within some ns, and steps of 2 µs go where
/// steps of 0.25 µs go.
#[test]
fn limit_a_thin_film_does_not_bound_the_step_of_the_fast_scheme() {
    let changes = [
        ("cage.free.gravity", "(m_per_s2(20000), m_per_s2(0), m_per_s2(0))"),
        ("cage.free.lands[0].film.viscosity", "mPa_s(100)"),
        ("cage.free.lands[0].film.fill", "1"),
        ("cage.pocket_gap", "mm(0.5)"),
    ];
    let case = case("Cylinder", "0.2", &changes);
    let end = |h: f64, steps: u32| {
        let (mut machine, mut state) = machine(&case);
        run(Scheme::Fast, (&mut machine, &mut state), h, steps);
        let frame = machine.frame(h * f64::from(steps), &state);
        (frame.free_cage.unwrap().centre, machine.lands(&frame).force.outer)
    };
    let ([x, y, _], force) = end(2e-6, 300);
    let ([exact_x, exact_y, _], exact) = end(0.25e-6, 2400);
    assert!(exact[0] < -2000.0, "{exact:?}");
    assert!((x - exact_x).hypot(y - exact_y) < 2e-6, "{x:e} {y:e}, {exact_x:e} {exact_y:e}");
    assert!((force[0] - exact[0]).hypot(force[1] - exact[1]) < 0.1 * exact[0].abs(), "{force:?} {exact:?}");
}
