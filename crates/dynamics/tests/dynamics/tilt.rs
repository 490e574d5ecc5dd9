//! A ring that is free to tilt, in whole runs: where it settles, how fast it rocks.

use super::{case, run};
use std::f64::consts::TAU;
use tribodyn_case::Case;
use tribodyn_dynamics::Sample;
use tribodyn_quasistatic::{Model, solve};

/// Moment of inertia across the axis, kg m².
const INERTIA: f64 = 0.03;
/// Moment that comes on at the start, N m.
const MOMENT: f64 = 300.0;

/// The bearing under thrust; a moment about x comes on within 50 µs.
fn rocking(damping: &str, duration: &str) -> Case {
    let tilt = format!(
        "(inertia: Given(polar: kg_m2(0.002), transverse: kg_m2({INERTIA})),
          stiffness: (Nm_per_rad(0), Nm_per_rad(0)), damping: (Nm_s_per_rad({damping}), Nm_s_per_rad({damping})))"
    );
    case(&[
        // Held across the axis, and the outer ring, too: a tilt would else move both, with their masses.
        ("ring.x", "Held(um(0))"),
        ("ring.y", "Held(um(0))"),
        ("supports.outer.mass", "kg(1e6)"),
        ("supports.outer.stiffness", "(N_per_um(1e7), N_per_um(1e7))"),
        ("ring.tilt_x", &format!("MomentTable([(s(0), Nm(0)), (us(50), Nm({MOMENT}))])")),
        ("ring.tilt_y", "Moment(Nm(0))"),
        ("supports.tilt", &tilt),
        ("speed.inner", "Constant(rpm(300))"),
        ("transient.duration", duration),
        ("transient.scheme", "Fast(step: us(5))"),
        ("recording.state_rate", "kHz(50)"),
        ("recording.ball_rate", "kHz(1)"),
    ])
}

/// Tilt about x of the equilibrium under the moment, rad.
fn settled(case: &Case) -> f64 {
    let solved = solve(&case.bearing().unwrap(), &case.operating_point(), Model::Traction).unwrap();
    solved.solution.ring_tilt_rad[0]
}

/// Balls that lie across their new paths roll into them: within 5 ms the tilt is 1 % short of it, after 30 ms there.
#[test]
fn limit_a_damped_ring_settles_at_the_tilt_of_the_equilibrium() {
    let case = rocking("130", "ms(30)");
    let (_, keep) = run(&case);
    let last = keep.samples.last().unwrap();
    let expected = settled(&case);
    let [x, y] = last.inner.tilt_rad;
    assert!(expected > 1e-5 && (x / expected - 1.0).abs() < 5e-3, "{x:e} {expected:e}");
    assert!(y.abs() < 0.02 * expected, "{y:e} of {expected:e}");
    assert!(last.inner.torque_nm.is_finite() && last.power.imbalance_j.abs() < 1e-2 * last.power.throughput_j);
}

/// The ring rocks on the stiffness of the equilibrium, moment over tilt, far below the modes of the balls.
#[test]
fn limit_a_ring_rocks_at_the_frequency_of_its_stiffness() {
    let case = rocking("0", "ms(8)");
    let (_, keep) = run(&case);
    let middle = settled(&case);
    let off = |sample: &Sample| sample.inner.tilt_rad[0] - middle;
    let crossings: Vec<f64> = keep
        .samples
        .windows(2)
        .filter(|pair| off(&pair[0]) < 0.0 && off(&pair[1]) >= 0.0)
        .map(|pair| {
            let [a, b] = [off(&pair[0]), off(&pair[1])];
            pair[0].time_s + (pair[1].time_s - pair[0].time_s) * a / (a - b)
        })
        .collect();
    assert!(crossings.len() > 3, "{crossings:?}");
    let found = 3.0 / (crossings[3] - crossings[0]);
    let expected = (MOMENT / middle / INERTIA).sqrt() / TAU;
    assert!((found / expected - 1.0).abs() < 0.03, "{found} {expected} Hz");
}
