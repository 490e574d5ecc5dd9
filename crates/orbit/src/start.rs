//! Where the iteration begins: ring and rolling speeds of Jones–Harris, and one ball sent round by implicit steps.

use crate::collocation::{Orbit, STAGES};
use crate::residual::Scales;
use crate::system::{BALL, ORBIT, OrbitSystem, RING, rings};
use nalgebra::{SMatrix, SVector};
use num_dual::DualSVec64;
use tribodyn_bearing::{Bearing, LoadedPatch, RingFreedom, Side};
use tribodyn_quasistatic::RollingStart;

/// Implicit steps of a turn.
const STEPS: usize = 72;
/// Turns that the ball goes before it counts as settled.
const TURNS: usize = 1;
/// Newton steps of an implicit step.
const ITERATIONS: usize = 6;

type Dual = DualSVec64<BALL>;

/// The speed of the cage as the loaded balls give it.
pub(crate) fn cage_speed(start: &RollingStart) -> f64 {
    let total: f64 = start.inner_loads.iter().sum();
    let even = 1e-9 * total / start.balls.len() as f64 + f64::MIN_POSITIVE;
    let weighted = start.balls.iter().zip(&start.inner_loads).map(|(b, q)| (q + even) * b.orbital_speed);
    weighted.sum::<f64>() / start.inner_loads.iter().map(|q| q + even).sum::<f64>()
}

/// Typical magnitudes at a start.
pub(crate) fn scales(bearing: &Bearing, ring: &[RingFreedom; RING], start: &RollingStart, speed: f64) -> Scales {
    let g = &bearing.geometry;
    let (balls, radius) = (g.ball_count as f64, 0.5 * g.pitch_diameter);
    let carried = start.inner_loads.iter().sum::<f64>() / balls;
    let load: f64 = ring[..3].iter().map(|f| if let RingFreedom::Loaded(v) = f { v.abs() } else { 0.0 }).sum();
    let force = (load / balls).max(carried) + bearing.ball_mass * radius * speed * speed;
    let force = force.max(1e-4 * 0.5e9 * g.ball_diameter.powi(2));
    let length = 0.1 * bearing.races.outer.frozen::<f64>().approach(force);
    let offset = g.groove_offset(Side::Outer).min(g.groove_offset(Side::Inner));
    let spin = speed.abs() * g.pitch_diameter / g.ball_diameter;
    let (slow, turn) = (1e-3 * speed.abs(), 1e-3 * spin);
    let velocity = 10.0 * length * speed.abs();
    Scales {
        ball: [length, length, 1e-3, velocity, velocity, slow, turn, turn, turn],
        border: [slow, length, length, length, length / radius, length / radius],
        border_rows: [
            1e-2 * force * radius * balls,
            force * balls,
            force * balls,
            force * balls,
            force * radius * balls,
            force * radius * balls,
        ],
        force,
        limits: [
            0.2 * offset,
            0.2 * offset,
            f64::INFINITY,
            f64::INFINITY,
            f64::INFINITY,
            0.1 * speed.abs(),
            0.2 * spin,
            0.2 * spin,
            0.2 * spin,
        ],
    }
}

/// A ball sent round with the cage at a held speed and the ring held, by implicit Euler steps.
pub(crate) fn sent_round(system: &OrbitSystem<'_>, scales: &Scales, start: &RollingStart, cage_speed: f64) -> Orbit {
    let ball = &start.balls[0];
    let [x1, x2] = ball.position;
    let [a, r, t] = ball.spin;
    let mut y = [x1, x2, 0.0, 0.0, 0.0, ball.orbital_speed, a + ball.orbital_speed, r, t];
    y[ORBIT] = cage_speed;
    let time = system.time(1.0 / STEPS as f64, cage_speed);
    let mut ends = Vec::with_capacity(STEPS);
    for step in 1..=STEPS * TURNS {
        let turn = step as f64 / STEPS as f64;
        y = implicit_step(system, scales, (system.azimuth(turn), time), &y, (cage_speed, start.ring));
        if step > STEPS * (TURNS - 1) {
            ends.push(y);
        }
    }
    let values = ends.into_iter().map(|y| [y; STAGES]).collect();
    let mesh = (0..=STEPS).map(|j| j as f64 / STEPS as f64).collect();
    Orbit { ends: mesh, values, stages: 1, cage_speed, ring: start.ring }
}

pub(crate) fn implicit_step(
    system: &OrbitSystem<'_>,
    scales: &Scales,
    (azimuth, time): (f64, f64),
    from: &[f64; BALL],
    (cage_speed, ring): (f64, [f64; RING]),
) -> [f64; BALL] {
    let fixed = rings(ring.map(Dual::from), system.speeds);
    let mut y = *from;
    for _ in 0..ITERATIONS {
        let unknowns: [Dual; BALL] = std::array::from_fn(|k| {
            let mut direction = SVector::<f64, BALL>::zeros();
            direction[k] = scales.ball[k];
            Dual::new(y[k], num_dual::Derivative::some(direction))
        });
        let traction = |patch: &LoadedPatch<'_, Dual>| system.bearing.linear_traction(patch, &system.kernel);
        let e = system.ball(Dual::from(azimuth), &unknowns, Dual::from(cage_speed), &fixed, traction);
        let mut own = SMatrix::<f64, BALL, BALL>::identity();
        let mut right = SVector::<f64, BALL>::zeros();
        for k in 0..BALL {
            let slope = e.rate[k].eps.unwrap_generic(nalgebra::Const::<BALL>, nalgebra::Const::<1>);
            (0..BALL).for_each(|c| own[(k, c)] -= time * slope[c] / scales.ball[k]);
            right[k] = (from[k] + time * e.rate[k].re - y[k]) / scales.ball[k];
        }
        let Some(change) = own.lu().solve(&right) else { break };
        let limit = |k: usize| scales.limits[k] / (change[k] * scales.ball[k]).abs().max(1e-300);
        let share = (0..BALL).map(limit).fold(1.0, f64::min);
        (0..BALL).for_each(|k| y[k] += share * change[k] * scales.ball[k]);
        if share == 1.0 && change.norm() < 1e-3 {
            break;
        }
    }
    y
}
