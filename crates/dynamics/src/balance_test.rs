//! The power balance, what happens to it when a term is left out, and whether all schemes have the same terms.

use crate::equations::{Equations, Friction, Springs};
use crate::forces::System;
use crate::layout::{BALL, OMEGA, VELOCITY};
use crate::machine::Machine;
use crate::start::{Started, start};
use crate::stepping_test::{self, Scheme, imbalance};
use tribodyn_bearing::{
    AzimuthFrame, BallLoads, BallSize, BallState, Bearing, ContactForces, NormalContact, NormalLoads, PocketLoad,
    Races, RingState, Side, Sliding,
};
use tribodyn_case::{Case, set_value};

/// Short against the contact modes of 14 kHz that the start excites: the error of the scheme must stay below the
/// balance's.
const STEP: f64 = 2e-6;

/// A term of the equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Term {
    /// ω_m e_a × Ω, the change of the components of Ω with the frame. It does no work.
    TurningAxes,
    /// Euler's equation for the absolute angular velocity and not for that against the orbiting frame.
    AbsoluteRotation,
    /// The tangential part of the normal forces where a ring is off centre.
    TangentialNormalForce,
    /// The ball's translation in the sliding velocity.
    BallTranslation,
    /// The rings' translation in the sliding velocity.
    RingTranslation,
    /// The same torque of the pocket force on ball and cage.
    PocketArm,
    /// Mass, inertia and rolling radius of each ball.
    OwnSize,
    /// Mass and inertia of each ball where friction moves it.
    OwnInertia,
}

const TERMS: [Term; 6] = [
    Term::TurningAxes,
    Term::AbsoluteRotation,
    Term::TangentialNormalForce,
    Term::BallTranslation,
    Term::RingTranslation,
    Term::PocketArm,
];

/// The equations without one term.
struct Without {
    machine: Machine,
    term: Option<Term>,
}

impl Without {
    fn lacks(&self, term: Term) -> bool {
        self.term == Some(term)
    }
}

impl Equations for Without {
    fn machine(&self) -> &Machine {
        &self.machine
    }

    fn machine_mut(&mut self) -> &mut Machine {
        &mut self.machine
    }

    fn state_at(&self, ball: (AzimuthFrame, BallSize), position: [f64; 2], b: &[f64]) -> BallState {
        let (frame, size) = ball;
        let size = if self.lacks(Term::OwnSize) { BallSize::NOMINAL } else { size };
        self.machine.state_at((frame, size), position, b)
    }

    fn springs(&self, normal: NormalLoads) -> Springs {
        let mut springs = self.machine.springs(normal);
        if self.lacks(Term::TangentialNormalForce) {
            springs.force[2] = 0.0;
        }
        springs
    }

    fn sliding(&self, side: Side, contact: &NormalContact, state: &BallState, at: (&RingState, f64)) -> Sliding {
        if self.lacks(Term::BallTranslation) {
            return self.machine.sliding(side, contact, &BallState { velocity: [0.0; 2], ..*state }, at);
        }
        if !self.lacks(Term::RingTranslation) {
            return self.machine.sliding(side, contact, state, at);
        }
        self.machine.sliding(side, contact, state, (&RingState { velocity: [0.0; 3], ..*at.0 }, at.1))
    }

    fn friction(
        &self,
        traction: &Races<ContactForces>,
        fluid: (f64, [f64; 3]),
        pocket: PocketLoad,
        orbit_radius: f64,
    ) -> Friction {
        let mut friction = self.machine.friction(traction, fluid, pocket, orbit_radius);
        if self.lacks(Term::PocketArm) {
            friction.force[2] += friction.pocket.force * (1.0 - self.machine.cage.pocket.radius / orbit_radius);
        }
        friction
    }

    fn friction_acceleration(&self, state: &BallState, friction: &Friction, orbit_radius: f64) -> [f64; 6] {
        let size = if self.lacks(Term::OwnInertia) { BallSize::NOMINAL } else { state.size };
        let mut a = self.machine.friction_acceleration(&BallState { size, ..*state }, friction, orbit_radius);
        let (w, [_, omega_r, omega_t]) = (state.orbital_speed, state.angular_velocity);
        if self.lacks(Term::AbsoluteRotation) {
            a[3] += a[2];
        }
        if self.lacks(Term::TurningAxes) {
            (a[4], a[5]) = (a[4] - w * omega_t, a[5] + w * omega_r);
        }
        a
    }

    fn motion(&self, state: &BallState, loads: &BallLoads, pocket: PocketLoad) -> (Friction, [f64; 6]) {
        if self.term.is_none() {
            return self.machine.motion(state, loads, pocket);
        }
        let (fluid, r) = ((loads.drag, loads.churning), loads.orbit_radius);
        let friction = self.friction(&loads.tractions(), fluid, pocket, r);
        let by_springs = self.spring_acceleration(&self.springs(loads.normal()), state);
        let by_friction = self.friction_acceleration(state, &friction, r);
        (friction, Bearing::acceleration(state, r, by_springs, by_friction))
    }
}

fn started(changes: &[(&str, &str)], term: Option<Term>) -> (Without, Vec<f64>) {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let patch = [("traction.patch", "SplitStrip(across: 5, along: 3)")];
    let text = patch.iter().chain(changes).fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    let case = Case::from_ron(&text).unwrap();
    let Started { machine, state, .. } = start(case.run_inputs().unwrap(), None).unwrap();
    (Without { machine, term }, state)
}

/// From the start over a number of steps: the equations, the state and the imbalance of the work over what is put in.
fn run(scheme: Scheme, steps: u32, changes: &[(&str, &str)], term: Option<Term>) -> (Vec<f64>, f64) {
    let (mut equations, mut state) = started(changes, term);
    let before = equations.machine.energy(0.0, &state);
    stepping_test::run(scheme, (&mut equations, &mut state), STEP, steps);
    let imbalance = imbalance(&equations.machine, (f64::from(steps) * STEP, &state), before);
    (state, imbalance)
}

/// Tight pockets, so that the balls push their cage from the start.
const PUSHING: [(&str, &str); 1] = [("cage.pocket_gap", "mm(0.01)")];

#[test]
fn identity_power_balances_and_every_term_is_needed() {
    for scheme in [Scheme::RungeKutta, Scheme::DormandPrince] {
        let (_, whole) = run(scheme, 1000, &PUSHING, None);
        assert!(whole < 1e-8, "{scheme:?}: {whole:e}");
        for term in TERMS.into_iter().filter(|&term| term != Term::TurningAxes) {
            let (_, off) = run(scheme, 1000, &PUSHING, Some(term));
            assert!(off > 30.0 * whole, "{scheme:?} without {term:?}: {off:e}, whole {whole:e}");
        }
    }
}

/// The fast scheme sums its work over samples and cannot resolve single terms in it. It has each one all the same:
/// leaving it out moves the end of a run as it moves that of the Runge–Kutta method.
#[test]
fn identity_the_fast_scheme_has_every_term() {
    let speeds = |scheme, term| -> Vec<f64> {
        let (state, _) = run(scheme, 300, &PUSHING, term);
        (0..13).flat_map(|k| state[BALL * k + VELOCITY..BALL * (k + 1)].to_vec()).collect()
    };
    let difference = |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a - b).collect() };
    let size = |v: &[f64]| v.iter().fold(0.0f64, |most, v| most.max(v.abs()));
    let whole = [Scheme::RungeKutta, Scheme::Fast].map(|scheme| speeds(scheme, None));
    for term in TERMS {
        let effect = difference(&speeds(Scheme::RungeKutta, Some(term)), &whole[0]);
        let of_fast = difference(&speeds(Scheme::Fast, Some(term)), &whole[1]);
        let (effect, error) = (size(&effect), size(&difference(&of_fast, &effect)));
        assert!(error < 0.3 * effect, "{term:?}: effect {effect:e}, error {error:e}");
    }
}

/// ω_m e_a × Ω is at right angles to Ω and leaves the power alone: the quasi-static state, which has it, tells whether
/// it is there.
#[test]
fn identity_without_turning_axes_the_quasistatic_state_does_not_stay() {
    let turning_up = |term| {
        let (mut equations, state) = started(&[("ring.x", "Force(N(0))")], term);
        let mut derivative = vec![0.0; state.len()];
        equations.derivative(0.0, &state, &mut derivative);
        derivative[OMEGA + 1].hypot(derivative[OMEGA + 2])
    };
    let (with, without) = (turning_up(None), turning_up(Some(Term::TurningAxes)));
    // ω_m Ω_r is some 600 × 800 rad/s².
    assert!(with < 1.0 && without > 1e5, "{with:e} {without:e}");
}

/// Under every reading the work that goes in is lost or stored. An elastic patch has its power from the true slip and
/// its forces from their sum, which agree as its cells get finer.
#[test]
fn identity_power_balances_under_every_reading() {
    let (plain, whole) = run(Scheme::RungeKutta, 200, &PUSHING, None);
    let readings = [
        ("modelling.rolling_radius", "Deformed", 3.0 * whole),
        ("modelling.gyroscopic_moment", "Absent", 3.0 * whole),
        // The force jumps at the wall, within a step.
        ("modelling.pocket_force", "AsPrinted", 1e-4),
        ("modelling.patch", "Elastic(strips: 4, cells: 24)", 2e-3),
    ];
    for (path, value, allowed) in readings {
        let (state, off) = run(Scheme::RungeKutta, 200, &[PUSHING[0], (path, value)], None);
        assert!(off < allowed, "{value}: {off:e}, without {whole:e}");
        let moved = state.iter().zip(&plain).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(moved > 1e-6, "{value} changes nothing: {moved:e}");
    }
    let cells = |cells: u32| {
        let patch = format!("Elastic(strips: 4, cells: {cells})");
        run(Scheme::RungeKutta, 50, &[("modelling.patch", &patch)], None).1
    };
    let (coarse, fine) = (cells(12), cells(48));
    assert!(fine < 0.5 * coarse, "{coarse:e} {fine:e}");
}

/// The fast scheme and the Runge–Kutta method have the same equations under every reading.
#[test]
fn identity_the_fast_scheme_has_every_reading() {
    let speeds = |scheme, changes: &[(&str, &str)]| -> Vec<f64> {
        let (state, _) = run(scheme, 300, changes, None);
        (0..13).flat_map(|k| state[BALL * k + VELOCITY..BALL * (k + 1)].to_vec()).collect()
    };
    let size = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
    let whole = [Scheme::RungeKutta, Scheme::Fast].map(|scheme| speeds(scheme, &PUSHING));
    for (path, value) in [
        ("modelling.rolling_radius", "Deformed"),
        ("modelling.gyroscopic_moment", "Absent"),
        ("modelling.pocket_force", "AsPrinted"),
        ("modelling.patch", "Elastic(strips: 4, cells: 8)"),
    ] {
        let changes = [PUSHING[0], (path, value)];
        let [exact, fast] = [Scheme::RungeKutta, Scheme::Fast].map(|scheme| speeds(scheme, &changes));
        let (effect, error) = (size(&exact, &whole[0]), size(&fast, &exact));
        assert!(error < 0.3 * effect, "{value}: effect {effect:e}, error {error:e}");
    }
}

/// Sizes up to 0.4 % off, as no bearing has them, so that they count for much.
fn unequal() -> String {
    let sizes: Vec<String> = (0..13).map(|k| format!("um({})", 20 * (k * 5 % 7) - 60)).collect();
    format!("Excess([{}])", sizes.join(", "))
}

#[test]
fn identity_power_balances_with_unequal_balls_and_needs_their_inertia() {
    let sizes = unequal();
    let changes = [PUSHING[0], ("deviations.balls", &sizes)];
    for scheme in [Scheme::RungeKutta, Scheme::DormandPrince] {
        let (_, whole) = run(scheme, 1000, &changes, None);
        assert!(whole < 1e-7, "{scheme:?}: {whole:e}");
        let (_, off) = run(scheme, 1000, &changes, Some(Term::OwnInertia));
        assert!(off > 30.0 * whole, "{scheme:?} with the inertia of the drawing: {off:e}, whole {whole:e}");
    }
}

/// The effect of mass, inertia and radius of each ball on a run, beside its approach, is the same in all schemes.
#[test]
fn identity_all_schemes_have_the_sizes_of_the_balls() {
    let sizes = unequal();
    let speeds = |scheme, term| -> Vec<f64> {
        let (state, _) = run(scheme, 300, &[("deviations.balls", &sizes)], term);
        (0..13).flat_map(|k| state[BALL * k + VELOCITY..BALL * (k + 1)].to_vec()).collect()
    };
    let effect = |scheme| -> Vec<f64> {
        let [with, without] = [None, Some(Term::OwnSize)].map(|term| speeds(scheme, term));
        with.iter().zip(without).map(|(a, b)| a - b).collect()
    };
    let size = |v: &[f64]| v.iter().fold(0.0f64, |most, v| most.max(v.abs()));
    let exact = effect(Scheme::RungeKutta);
    assert!(size(&exact) > 0.1, "{:e}", size(&exact));
    for (scheme, allowed) in [(Scheme::DormandPrince, 1e-3), (Scheme::Fast, 0.1)] {
        let off: Vec<f64> = effect(scheme).iter().zip(&exact).map(|(a, b)| a - b).collect();
        assert!(size(&off) < allowed * size(&exact), "{scheme:?}: effect {:e}, off {:e}", size(&exact), size(&off));
    }
}
