//! Rings that tilt among balls: balances, closed forms, and whether all schemes have the same terms.

use crate::equations::BallForces;
use crate::forces::{BodyForces, evaluate};
use crate::layout::{AXIAL, OMEGA, ORBIT, RADIUS, VELOCITY};
use crate::machine::Machine;
use crate::start::{Started, start};
use crate::stepping_test::{Scheme, imbalance, run};
use crate::tilting::tilt_rates;
use tribodyn_bearing::vectors::cross;
use tribodyn_bearing::{BallState, RingState, Side, Tilt, Translation};
use tribodyn_case::{Case, set_value};

pub(crate) const TILT: &str = "(inertia: Given(polar: kg_m2(0.05), transverse: kg_m2(0.03)),
    stiffness: (Nm_per_rad(2000), Nm_per_rad(3000)), damping: (Nm_s_per_rad(1), Nm_s_per_rad(2)))";
/// The outer ring tilts and turns too, both seats stand askew.
pub(crate) const BOTH: [(&str, &str); 4] = [
    ("speed.outer", "Constant(rpm(-3000))"),
    (
        "supports.outer_tilt",
        "(inertia: Given(polar: kg_m2(0.08), transverse: kg_m2(0.05)), damping: (Nm_s_per_rad(2), Nm_s_per_rad(3)),
        stiffness: (Nm_per_rad(40000), Nm_per_rad(60000)))",
    ),
    ("supports.tilt.askew", "(mrad(0.3), mrad(0.1))"),
    ("supports.outer_tilt.askew", "(mrad(-0.2), mrad(0.4))"),
];

fn case(changes: &[(&str, &str)]) -> Case {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let tilting = [
        ("traction.patch", "GaussJacobi(radial: 3, angles: 8)"),
        ("ring.tilt_x", "Moment(Nm(120))"),
        ("ring.tilt_y", "Moment(Nm(-60))"),
        ("supports.tilt", TILT),
    ];
    let text = tilting.iter().chain(changes).fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    Case::from_ron(&text).unwrap()
}

/// The machine of a case, its ring off its equilibrium, turning over.
fn machine(changes: &[(&str, &str)]) -> (Machine, Vec<f64>) {
    let Started { machine, mut state, .. } = start(case(changes).run_inputs().unwrap(), None).unwrap();
    swing(&machine, &mut state);
    (machine, state)
}

/// Tilts rings that may, and lets them swing.
pub(crate) fn swing(machine: &Machine, state: &mut [f64]) {
    for (side, sign) in [(Side::Inner, 1.0), (Side::Outer, -0.5)] {
        if let [x, y, w_x, w_y] = &mut state[machine.layout.tilt(side)] {
            (*x, *y, *w_x, *w_y) = (*x + sign * 1e-4, *y - sign * 2e-4, sign * 0.3, sign * -0.2);
        }
    }
}

#[test]
fn identity_power_balances_with_tilting_rings() {
    let cases = [(Scheme::RungeKutta, &BOTH[..0]), (Scheme::RungeKutta, &BOTH), (Scheme::DormandPrince, &BOTH)];
    for (scheme, changes) in cases {
        let (mut machine, mut state) = machine(changes);
        let before = machine.energy(0.0, &state);
        let (h, steps) = (1e-6, 400);
        run(scheme, (&mut machine, &mut state), h, steps);
        let imbalance = imbalance(&machine, (h * f64::from(steps), &state), before);
        assert!(imbalance < 1e-9, "{scheme:?}: {imbalance:e}");
    }
}

/// Rates of the linear and the angular momentum about the bearing's centre of balls and inner ring, less what the outer
/// ring does, those of the outer ring about its centre, and the largest force: what is left are the drives' torques
/// about the rings' axes and the loads.
#[derive(Default)]
struct Rates {
    linear: [f64; 3],
    angular: [f64; 3],
    outer: [f64; 3],
    force: f64,
}

impl Rates {
    fn of_ball(&mut self, machine: &Machine, b: &[f64], ball: &BallForces, outer: &RingState) {
        let BallState { frame, orbital_speed: w, angular_velocity, .. } = ball.state;
        let (m, j, r) = (machine.bearing.ball_mass, machine.bearing.ball_inertia, b[RADIUS]);
        let [axial, radial, orbital, about_a, about_r, about_t] = ball.acceleration;
        let along = r * orbital + 2.0 * b[VELOCITY + 1] * w;
        let moving = frame.to_inertial([m * axial, m * (radial - r * w * w), m * along]);
        // The accelerations of Ω are those of its components; the frame turns them.
        let turning = [about_a, about_r - w * angular_velocity[2], about_t + w * angular_velocity[1]].map(|a| j * a);
        let turning = frame.to_inertial(turning);
        let place = frame.to_inertial([b[AXIAL], r, 0.0]);
        let contact = &ball.contacts[Side::Outer];
        let by_outer = frame.to_inertial(contact.force);
        let about = frame.to_inertial(contact.moment);
        let (of_motion, of_force) = (cross(place, moving), cross(place, by_outer));
        for k in 0..3 {
            self.linear[k] += moving[k] - by_outer[k];
            self.angular[k] += of_motion[k] + turning[k] - of_force[k] - about[k];
        }
        let [x, y, _] = outer.displacement;
        let of_force = cross([place[0] - x, place[1] - y, place[2]], by_outer);
        (0..3).for_each(|k| self.outer[k] += of_force[k] + about[k]);
        self.force = self.force.max(contact.normal.load);
        assert!(OMEGA == 6 && outer.turning.is_some() && ORBIT == 5);
    }

    /// The ring, its centre at a height above the plane of the outer groove centres.
    fn of_ring(&mut self, machine: &Machine, ring: &RingState, bodies: &BodyForces) {
        let g = &machine.bearing.geometry;
        let [x, y, z] = ring.displacement;
        let place = [x, y, z + g.centre_distance() * g.sin_contact_angle()];
        let moving = bodies.inner.map(|a| machine.inner.mass * a);
        let of_motion = cross(place, moving);
        let own = own_rate(machine, (Side::Inner, ring), bodies);
        for k in 0..3 {
            self.linear[k] += moving[k];
            self.angular[k] += of_motion[k] + own[k];
        }
    }
}

/// Rate of a ring's own angular momentum, N m.
fn own_rate(machine: &Machine, (side, ring): (Side, &RingState), bodies: &BodyForces) -> [f64; 3] {
    let body = &machine.tilting[side].as_ref().unwrap().body;
    let [.., w_x, w_y] = bodies.tilt[side].unwrap();
    let (axis, turning) = (ring.axis(), ring.turning.unwrap());
    let axis_rate = cross(turning, axis);
    // That ω stays across the axis gives its third component.
    let across: f64 = (0..3).map(|k| turning[k] * axis_rate[k]).sum();
    let rates = [w_x, w_y, -(across + w_x * axis[0] + w_y * axis[1]) / axis[2]];
    [0, 1, 2].map(|k| body.transverse_inertia * rates[k] + body.polar_inertia * ring.speed * axis_rate[k])
}

/// Nothing but the outer ring and the drive acts on balls and inner ring, and but the balls and its drive on the outer
/// ring, at any tilt, with friction.
#[test]
fn identity_linear_and_angular_momentum_balance_with_tilting_rings() {
    let alone = [("cage.pocket_stiffness", "N_per_um(0)"), ("cage.drag_torque", "Nm(0)")];
    let (mut machine, mut state) = machine(&[&alone[..], &BOTH].concat());
    machine.bearing.fluid = None;
    machine.loads = [0, 1, 2].map(|_| Translation::Force(0.0));
    (machine.inner.stiffness, machine.inner.damping) = ([0.0; 3], [0.0; 3]);
    for side in Side::BOTH {
        let tilting = machine.tilting[side].as_mut().unwrap();
        tilting.loads = [Tilt::Moment(0.0), Tilt::Moment(0.0)];
        (tilting.body.stiffness, tilting.body.damping) = ([0.0; 2], [0.0; 2]);
    }
    let l = machine.layout;
    state[l.inner()] += 1e-5;
    state[l.inner() + 3..l.inner() + 6].copy_from_slice(&[0.02, -0.01, 0.03]);
    state[l.outer()..l.outer() + 4].copy_from_slice(&[-8e-6, 5e-6, -0.01, 0.03]);
    // Tilts far above those of the start.
    state[l.tilt(Side::Inner).start] += 1e-3;
    state[l.tilt(Side::Outer).start] -= 2e-3;
    let frame = machine.frame(0.0, &state);
    let mut rates = Rates::default();
    let unknowns = state.clone();
    let (_, _, bodies) = evaluate(&machine, 0.0, &state, |index, ball| {
        rates.of_ball(&machine, machine.unknowns(index, &unknowns), ball, &frame.rings.outer);
    });
    let ring = &frame.rings.inner;
    rates.of_ring(&machine, ring, &bodies);
    let axis = ring.axis();
    let drive: f64 = (0..3).map(|k| rates.angular[k] * axis[k]).sum();
    let lever = machine.bearing.geometry.pitch_diameter;
    for (k, along) in axis.into_iter().enumerate() {
        assert!(rates.linear[k].abs() < 1e-10 * rates.force, "{k}: {:e} of {}", rates.linear[k], rates.force);
        let left = rates.angular[k] - drive * along;
        assert!(left.abs() < 1e-10 * rates.force * lever, "{k}: {left:e} of {}", rates.force * lever);
    }
    assert!((drive - bodies.torque.inner).abs() < 1e-10 * rates.force * lever, "{drive} {}", bodies.torque.inner);
    let ring = &frame.rings.outer;
    let (own, axis) = (own_rate(&machine, (Side::Outer, ring), &bodies), ring.axis());
    for (k, along) in axis.into_iter().enumerate() {
        let left = own[k] + rates.outer[k] - bodies.torque.outer * along;
        assert!(left.abs() < 1e-10 * rates.force * lever, "{k}: {left:e} of {}", rates.force * lever);
    }
}

/// A seat carries a ring round: without balls and damping, it goes with its seat, larger by k/(k − (I_t − I_p) Ω²).
#[test]
fn code_a_ring_alone_goes_round_with_its_seat() {
    let (mut machine, state) = machine(&[("supports.tilt.askew", "(mrad(0.3), mrad(0.1))")]);
    let tilting = machine.tilting.inner.as_mut().unwrap();
    tilting.loads = [Tilt::Moment(0.0), Tilt::Moment(0.0)];
    tilting.reference = [0.0; 2];
    (tilting.body.stiffness, tilting.body.damping) = ([2e5; 2], [0.0; 2]);
    let (body, askew) = (tilting.body, tilting.body.askew);
    let mut frame = machine.frame(0.0, &state);
    let speed = frame.rings.inner.speed;
    let follows = 2e5 / (2e5 - (body.transverse_inertia - body.polar_inertia) * speed * speed);
    for angle in [0.0f64, 0.7, 2.9] {
        let (sin, cos) = angle.sin_cos();
        let seat = [askew[0] * cos - askew[1] * sin, askew[0] * sin + askew[1] * cos];
        let tilt = seat.map(|tilt| follows * tilt);
        let ring = &mut frame.rings.inner;
        (ring.tilt, ring.turning) = (tilt, Some([-speed * tilt[1], speed * tilt[0], 0.0]));
        frame.angles.inner = angle;
        let mut f = BodyForces::default();
        machine.tilting_body(Side::Inner, 0.0, (&frame, [0.0; 3]), &mut f);
        let [.., by_x, by_y] = f.tilt.inner.unwrap();
        let expected = tilt.map(|tilt| -speed * speed * tilt);
        let size = speed * speed * askew[0].hypot(askew[1]);
        // To first order in the tilts.
        assert!((by_x - expected[0]).hypot(by_y - expected[1]) < 1e-6 * size, "{by_x} {by_y} {expected:?}");
        assert!(f.torque.inner.abs() < 1e-9 * 2e5 * askew[0].hypot(askew[1]), "{}", f.torque.inner);
    }
}

/// A ring that nothing touches: its axis goes round its angular momentum at |L|/I_t.
#[test]
fn code_free_precession_of_a_ring() {
    let (mut machine, state) = machine(&[]);
    let tilting = machine.tilting.inner.as_mut().unwrap();
    tilting.loads = [Tilt::Moment(0.0), Tilt::Moment(0.0)];
    (tilting.body.stiffness, tilting.body.damping) = ([0.0; 2], [0.0; 2]);
    let body = tilting.body;
    let at = machine.layout.tilt(Side::Inner).start;
    let ring = |y: &[f64]| machine.frame(0.0, y).rings.inner;
    let derivative = |y: &[f64]| {
        let mut f = BodyForces::default();
        machine.tilting_body(Side::Inner, 0.0, (&machine.frame(0.0, y), [0.0; 3]), &mut f);
        f.tilt.inner.unwrap()
    };
    let mut y = state;
    y[at..at + 4].copy_from_slice(&[2e-3, -1e-3, 3.0, 5.0]);
    let first = ring(&y);
    let (spin, turning, axis) = (body.polar_inertia * first.speed, first.turning.unwrap(), first.axis());
    let momentum = [0, 1, 2].map(|k| body.transverse_inertia * turning[k] + spin * axis[k]);
    let size = momentum.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (rate, steps) = (size / body.transverse_inertia, 2000);
    let h = 4.0 / rate / f64::from(steps);
    for _ in 0..steps {
        let start: [f64; 4] = std::array::from_fn(|k| y[at + k]);
        let mut slopes = [[0.0; 4]; 4];
        for stage in 0..4 {
            let back = [0.0, 0.5 * h, 0.5 * h, h][stage];
            let before = if stage == 0 { [0.0; 4] } else { slopes[stage - 1] };
            (0..4).for_each(|k| y[at + k] = start[k] + back * before[k]);
            slopes[stage] = derivative(&y);
        }
        for k in 0..4 {
            y[at + k] = start[k] + h / 6.0 * (slopes[0][k] + 2.0 * (slopes[1][k] + slopes[2][k]) + slopes[3][k]);
        }
    }
    // Rodrigues' formula for a rotation by 4 rad about the angular momentum.
    let about = momentum.map(|x| x / size);
    let along: f64 = (0..3).map(|k| about[k] * axis[k]).sum();
    let (sin, cos) = 4f64.sin_cos();
    let turned = cross(about, axis);
    let exact = [0, 1, 2].map(|k| axis[k] * cos + turned[k] * sin + about[k] * along * (1.0 - cos));
    let found = ring(&y).axis();
    assert!((0..3).all(|k| (found[k] - exact[k]).abs() < 1e-12), "{found:?} {exact:?}");
    let [x, y_] = tilt_rates(&first, turning);
    assert!((x - 3.0).abs() < 1e-2 && (y_ - 5.0).abs() < 1e-2);
}

/// The fast scheme goes where the Runge–Kutta method goes, and nearer with shorter steps. Balls follow the tilts but
/// for their angular velocity, so that the order falls below two in the end.
#[test]
fn identity_the_fast_scheme_has_the_same_tilts() {
    for (changes, side) in [(&BOTH[..0], Side::Inner), (&BOTH, Side::Inner), (&BOTH, Side::Outer)] {
        same_tilts(changes, side);
    }
}

fn same_tilts(changes: &[(&str, &str)], side: Side) {
    let end = |scheme, h: f64, steps: u32| -> [f64; 4] {
        let (mut machine, mut state) = machine(changes);
        run(scheme, (&mut machine, &mut state), h, steps);
        let at = machine.layout.tilt(side).start;
        std::array::from_fn(|k| state[at + k])
    };
    let apart = |a: [f64; 4], b: [f64; 4]| [0, 2].map(|k| (a[k] - b[k]).hypot(a[k + 1] - b[k + 1]));
    let start = end(Scheme::RungeKutta, 1e-6, 0);
    let exact = end(Scheme::RungeKutta, 1e-6, 1600);
    let way = apart(start, exact);
    let [coarse, fine, finest] =
        [(8e-6, 200), (4e-6, 400), (1e-6, 1600)].map(|(h, steps)| apart(end(Scheme::Fast, h, steps), exact));
    assert!(coarse[0] < 0.01 * way[0] && fine[0] < 0.6 * coarse[0], "{way:?} {coarse:?} {fine:?}");
    // In the velocity the vibration of the contacts has a phase of its own, which comes right with the shortest steps.
    assert!(coarse[1] < 0.03 * way[1] && finest[1] < 0.6 * coarse[1], "{way:?} {coarse:?} {finest:?}");
    let other = apart(end(Scheme::DormandPrince, 1e-6, 1600), exact);
    assert!((0..2).all(|k| other[k] < 1e-6 * way[k]), "{other:?} of {way:?}");
}
