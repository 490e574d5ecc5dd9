//! Where the iteration begins: ring and rolling speeds of Jones–Harris.

use crate::residual::Scales;
use crate::system::{BALL, LEAD, RING};
use tribodyn_bearing::{Bearing, Pocket, RingFreedom, Side};
use tribodyn_quasistatic::RollingStart;

/// Force in the pocket over that on a ball whose share in the lead counts as an error of one.
const PRESSED: f64 = 0.1;

/// The speed of the cage as the loaded balls give it.
pub(crate) fn cage_speed(start: &RollingStart) -> f64 {
    let total: f64 = start.inner_loads.iter().sum();
    let even = 1e-9 * total / start.balls.len() as f64 + f64::MIN_POSITIVE;
    let weighted = start.balls.iter().zip(&start.inner_loads).map(|(b, q)| (q + even) * b.orbital_speed);
    weighted.sum::<f64>() / start.inner_loads.iter().map(|q| q + even).sum::<f64>()
}

/// Typical magnitudes at a start.
pub(crate) fn scales(
    (bearing, pocket): (&Bearing, &Pocket),
    ring: &[RingFreedom; RING],
    start: &RollingStart,
    speed: f64,
) -> Scales {
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
    let lead = 1e-3;
    let mut errors = [1.0; BALL];
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
            0.2 * spin,
            0.2 * spin,
            0.2 * spin,
        ],
        errors,
    }
}

/// The ball that the inner ring presses hardest.
pub(crate) fn hardest(start: &RollingStart) -> usize {
    let loads = start.inner_loads.iter().enumerate();
    loads.fold((0, 0.0), |best, (index, &load)| if load > best.1 { (index, load) } else { best }).0
}

/// Unknowns of a ball of the start at a cage speed.
pub(crate) fn unknowns(start: &RollingStart, index: usize, cage_speed: f64) -> [f64; BALL] {
    let ball = &start.balls[index];
    let ([x1, x2], [a, r, t]) = (ball.position, ball.spin);
    [x1, x2, 0.0, 0.0, 0.0, cage_speed, a + ball.orbital_speed, r, t]
}
