//! Order of the fast scheme where traction is linearised anew at every step.

use crate::fast::{Fast, Room};
use crate::forces::System;
use crate::layout::{BALL, OMEGA, ORBIT};
use crate::observer::BallDetail;
use crate::start::{Started, start};
use tribodyn_bearing::quantities::OfBall;
use tribodyn_bearing::{BallResult, ContactResult, Races, Side};
use tribodyn_case::{Case, set_value};
use tribodyn_numerics::Rk4;

const END: f64 = 1.6e-3;

fn started(actual_angle: &str) -> Started {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let changes = [
        ("traction.patch", "GaussJacobi(radial: 3, angles: 12)"),
        ("traction.slip_unit", "MeterPerSecond"),
        ("cage.pocket_stiffness", "N_per_um(0)"),
        ("modelling.contact_at_actual_angle", actual_angle),
    ];
    let text = changes.iter().fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    let case = Case::from_ron(&text).unwrap();
    start(case.run_inputs().unwrap(), None).unwrap()
}

fn fast(steps: u32) -> Vec<f64> {
    let Started { mut machine, mut state, .. } = started("false");
    let mut scheme = Fast::with_linear_error(1e-9);
    let h = END / f64::from(steps);
    for step in 0..steps {
        scheme.step(&mut machine, h * f64::from(step), &mut state, h);
    }
    state
}

fn reference() -> Vec<f64> {
    let Started { mut machine, mut state, .. } = started("false");
    let (mut derivative, mut next, mut method) = (state.clone(), state.clone(), Rk4::default());
    let h = END / 800.0;
    for step in 0..800 {
        let t = h * f64::from(step);
        machine.derivative(t, &state, &mut derivative);
        method.step(machine.rates(), t, (&state, &derivative), h, &mut next);
        std::mem::swap(&mut state, &mut next);
    }
    state
}

/// Of second order, right after the start too.
#[test]
fn identity_the_fast_scheme_converges() {
    let exact = reference();
    let error = |steps| {
        let state = fast(steps);
        let speeds = (0..13).flat_map(|k| [BALL * k + ORBIT, BALL * k + OMEGA, BALL * k + OMEGA + 1]);
        speeds.map(|i| (state[i] - exact[i]).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(160), error(320));
    let order = (coarse / fine).log2();
    assert!(order > 1.8, "order {order:.2}: {coarse:e}, {fine:e}");
}

/// Samples in lanes are those of the equations ball by ball with integrals over the patches: all numbers of a ball, and
/// the sums over them.
#[test]
fn identity_samples_in_lanes_are_those_of_single_balls() {
    compare_samples(started("false"));
    compare_samples(started("true"));
}

fn compare_samples(Started { mut machine, mut state, .. }: Started) {
    let (mut scheme, h) = (Fast::default(), 2e-5);
    for step in 0..60 {
        scheme.step(&mut machine, h * f64::from(step), &mut state, h);
    }
    let t = 60.0 * h;
    let sample = |detail| scheme.sample(&machine, (t, &state), (detail, &mut Room::default()));
    let ((sums, lanes), (plain_sums, plain)) = (sample(BallDetail::All), machine.balls(t, &state));
    assert_eq!(lanes.len(), plain.len());
    let (same_sums, fewer) = sample(BallDetail::Loads);
    assert_eq!(format!("{same_sums:?}"), format!("{sums:?}"));
    for (of_loads, all) in fewer.iter().zip(&lanes) {
        let contact = |c: ContactResult| ContactResult { friction: None, transient: None, ..c };
        let contacts = Races { inner: contact(all.contacts.inner), outer: contact(all.contacts.outer) };
        assert_eq!(*of_loads, BallResult { fluid: None, motion: None, contacts, ..*all });
    }
    let mut integrated = 0;
    for quantity in OfBall::all() {
        let values = |balls: &[BallResult]| -> Vec<f64> { balls.iter().filter_map(|b| quantity.get(b)).collect() };
        let (ours, theirs) = (values(&lanes), values(&plain));
        assert_eq!(ours.len(), theirs.len());
        let scale = theirs.iter().fold(1e-300, |scale: f64, v| scale.max(v.abs()));
        let off = ours.iter().zip(&theirs).map(|(a, b)| (a - b).abs() / scale).fold(0.0, f64::max);
        // Traction is linear between its refreshes, to 1e-3 of the load, and all that follows from it.
        let name = quantity.name_in(quantity.facts().unit);
        let friction = ["traction", "power_loss", "wear_rate", "sliding_speed", "acceleration"];
        let by_traction = friction.iter().any(|part| name.contains(part));
        integrated += usize::from(by_traction && off > 0.0);
        assert!(off < if by_traction { 0.1 } else { 1e-12 }, "{name}: {off:e}");
    }
    // The lanes were looked at, not the way round them.
    assert!(integrated > 3, "{integrated}");
    let (a, b) = (sums.powers, plain_sums.powers);
    let lost = sums.losses() / plain_sums.losses() - 1.0;
    assert!(lost.abs() < 1e-3 && (a.energy / b.energy - 1.0).abs() < 1e-12, "{lost:e} {a:?} {b:?}");
    for side in Side::BOTH {
        let off = (0..3).map(|i| (sums.on_rings[side][i] - plain_sums.on_rings[side][i]).abs()).fold(0.0, f64::max);
        assert!(off < 20.0, "{side:?}: {off} N");
        assert!((sums.torque[side] - plain_sums.torque[side]).abs() < 1.0, "{side:?}");
    }
}

/// At a quarter of the axial load balls of the paper's case start without load on the inner race: such a contact has no
/// linear form yet.
#[test]
fn limit_a_start_with_unloaded_contacts_stays_finite() {
    let text = include_str!("../../../fixtures/cases/paper-authors-ag.ron");
    let case = Case::from_ron(&set_value(text, "ring.z", "Force(N(11535))").unwrap()).unwrap();
    let Started { mut machine, mut state, .. } = start(case.run_inputs().unwrap(), None).unwrap();
    let mut scheme = Fast::with_linear_error(1e-4);
    for step in 0..3 {
        scheme.step(&mut machine, 2e-5 * f64::from(step), &mut state, 2e-5);
        assert!(state.iter().all(|value| value.is_finite()), "step {step}");
    }
}
