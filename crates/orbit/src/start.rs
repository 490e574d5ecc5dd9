//! Where the iteration begins: ring and rolling speeds of Jones–Harris.

use crate::residual::Scales;
use crate::system::{BALL, LEAD, ORBIT, RING};
use std::f64::consts::TAU;
use tribodyn_bearing::{Bearing, Pocket, RingFreedom, Side};
use tribodyn_quasistatic::{BallMotion, RollingStart};

/// Force in the pocket over that on a ball whose share in the lead counts as an error of one.
const PRESSED: f64 = 0.1;
/// Part of the scale of the orbital speed that counts as an error of one: by little more a ball meets its pocket.
const ALONG: f64 = 0.3;

/// The speed of the cage as the loaded balls give it.
pub(crate) fn cage_speed(start: &RollingStart) -> f64 {
    mean_speed(&start.balls, &start.inner_loads)
}

/// Mean orbital speed of balls, by their loads.
pub(crate) fn mean_speed(balls: &[BallMotion], loads: &[f64]) -> f64 {
    let even = 1e-9 * loads.iter().sum::<f64>() / balls.len() as f64 + f64::MIN_POSITIVE;
    let weighted = balls.iter().zip(loads).map(|(ball, q)| (q + even) * ball.orbital_speed);
    weighted.sum::<f64>() / loads.iter().map(|q| q + even).sum::<f64>()
}

/// Mean load of a ball on the inner race, N.
pub(crate) fn mean_load(start: &RollingStart) -> f64 {
    start.inner_loads.iter().sum::<f64>() / start.inner_loads.len() as f64
}

/// Centrifugal force of a ball at an orbital speed, rad/s, on the pitch circle, N.
pub(crate) fn centrifugal_force(bearing: &Bearing, speed: f64) -> f64 {
    bearing.ball_mass * 0.5 * bearing.geometry.pitch_diameter * speed * speed
}

/// Typical magnitudes where balls carry a mean load on the inner race at a cage speed.
pub(crate) fn scales(
    (bearing, pocket): (&Bearing, &Pocket),
    ring: &[RingFreedom; RING],
    (carried, speed): (f64, f64),
) -> Scales {
    let g = &bearing.geometry;
    let (balls, radius) = (g.ball_count as f64, 0.5 * g.pitch_diameter);
    let load: f64 = ring[..3].iter().map(|f| if let RingFreedom::Loaded(v) = f { v.abs() } else { 0.0 }).sum();
    let force = (load / balls).max(carried) + bearing.ball_mass * radius * speed * speed;
    let force = force.max(1e-4 * 0.5e9 * g.ball_diameter.powi(2));
    let length = 0.1 * bearing.races.outer.frozen::<f64>().approach(force);
    let offset = g.groove_offset(Side::Outer).min(g.groove_offset(Side::Inner));
    let turning = speed.abs() * g.pitch_diameter / g.ball_diameter;
    let (slow, turn) = (1e-3 * speed.abs(), 1e-3 * turning);
    let velocity = 10.0 * length * speed.abs();
    let lead = 1e-3;
    let mut errors = [1.0; BALL];
    errors[ORBIT] = ALONG;
    errors[LEAD] = (PRESSED * force / (pocket.stiffness * pocket.radius * lead)).min(1.0);
    Scales {
        ball: [length, length, lead, velocity, velocity, slow, turn, turn, turn],
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
            0.5 * pocket.clearance + lead,
            f64::INFINITY,
            f64::INFINITY,
            0.1 * speed.abs(),
            0.2 * turning,
            0.2 * turning,
            0.2 * turning,
        ],
        errors,
    }
}

/// The balls of an equilibrium at a cage speed, by azimuth.
pub(crate) struct Profile {
    balls: Vec<[f64; BALL]>,
}

impl Profile {
    /// The balls turn with the cage, each in the middle of its pocket.
    pub fn new(balls: &[BallMotion], cage_speed: f64) -> Self {
        Self { balls: balls.iter().map(|ball| unknowns(ball, cage_speed)).collect() }
    }

    /// A ball at an azimuth, rad, between its neighbours.
    pub fn at(&self, azimuth: f64) -> [f64; BALL] {
        let count = self.balls.len();
        let place = (azimuth / TAU).rem_euclid(1.0) * count as f64;
        let (first, share) = (place as usize, place.fract());
        let [a, b] = [first, first + 1].map(|k| &self.balls[k % count]);
        std::array::from_fn(|k| a[k] + share * (b[k] - a[k]))
    }
}

/// The ball that the inner ring presses hardest.
pub(crate) fn hardest(start: &RollingStart) -> usize {
    let loads = start.inner_loads.iter().enumerate();
    loads.fold((0, 0.0), |best, (index, &load)| if load > best.1 { (index, load) } else { best }).0
}

/// Unknowns of a ball of an equilibrium at a cage speed.
pub(crate) fn unknowns(ball: &BallMotion, cage_speed: f64) -> [f64; BALL] {
    let ([x1, x2], [a, r, t]) = (ball.position, ball.angular_velocity);
    [x1, x2, 0.0, 0.0, 0.0, cage_speed, a + ball.orbital_speed, r, t]
}
