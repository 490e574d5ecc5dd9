//! Balances of momentum over a run: what balls and rings gain against what loads, supports, fluid, pockets and drives
//! give them.
//!
//! Linear momentum across the axis: d/dt (Σ m v + m_i v_i + m_o v_o) = loads + supports + drag + pockets. The cage only
//! turns, so that what its pockets do to the balls comes from outside. Angular momentum about the axis:
//! d/dt (Σ (m r² ω_m + J Ω_a) + Σ_rings m (x v_y − y v_x) + J_c ω_c) = torques of the drives + moments of loads and
//! supports − r drag + churning + drag on the cage. Neither is in the equations of motion as such: contact forces have
//! to cancel between balls and rings. Forces are summed over the samples by the trapezium rule.

use tribodyn_bearing::{AzimuthFrame, BallResult, CageBody, Races, RingLoads, RunInputs, Supports, Tilt, Translation};
use tribodyn_dynamics::{RingSample, Sample};

/// Difference between sums over all and over every second sample, over what went to and fro, up to which samples tell
/// what goes on between them.
const RESOLVED: f64 = 1e-3;

/// Momentum along x and y (N s) and angular momentum about z (N m s).
type Momenta = [f64; 3];

/// The balances of a run.
#[derive(Debug, Clone)]
pub(super) struct Balance {
    mass: f64,
    inertia: f64,
    cage: CageBody,
    supports: Supports,
    loads: RingLoads,
    /// True where the inner ring is tilted: its torque is then about an axis of its own.
    tilted: bool,
    start: Option<Start>,
    last: (f64, Rates),
    given: Momenta,
    /// The same by every second sample up to the last of these: how well samples tell what goes on between them.
    every_second: (f64, Rates, Momenta),
    /// Momentum given up to there, by all samples.
    given_there: Momenta,
    samples: usize,
    /// Magnitudes of what went to and fro.
    throughput: Momenta,
    gained: Momenta,
}

/// Where springs are relaxed: the inner ring's where it stands at first, the outer ring's where they carry its load.
#[derive(Debug, Clone, Copy)]
struct Start {
    inner: [f64; 2],
    outer: [f64; 2],
    outer_force: [f64; 2],
    momenta: Momenta,
}

/// Forces and torque from outside, and the magnitudes that they and the contacts have.
#[derive(Debug, Clone, Copy, Default)]
struct Rates {
    given: Momenta,
    throughput: Momenta,
}

impl Balance {
    pub fn new(inputs: &RunInputs) -> Self {
        let bearing = &inputs.bearing;
        Self {
            mass: bearing.ball_mass,
            inertia: bearing.ball_inertia,
            cage: CageBody::new(&inputs.cage, bearing),
            supports: inputs.supports,
            tilted: [&inputs.ring.tilt_x, &inputs.ring.tilt_y].iter().any(|tilt| **tilt != Tilt::Held(0.0)),
            loads: inputs.ring.clone(),
            start: None,
            last: (0.0, Rates::default()),
            given: [0.0; 3],
            every_second: (0.0, Rates::default(), [0.0; 3]),
            given_there: [0.0; 3],
            samples: 0,
            throughput: [0.0; 3],
            gained: [0.0; 3],
        }
    }

    /// Takes the next sample; the first one is that of the start.
    pub fn take(&mut self, sample: &Sample) {
        let momenta = self.momenta(sample);
        let start = *self.start.get_or_insert_with(|| Start {
            inner: xy(sample.inner.displacement_m),
            outer: xy(sample.outer.displacement_m),
            outer_force: xy(sample.outer.ball_force_n),
            momenta,
        });
        let rates = self.rates(sample, &start);
        let (time, before) = std::mem::replace(&mut self.last, (sample.time_s, rates));
        let half = 0.5 * (sample.time_s - time);
        let added = |sum: Momenta, before: Momenta, now: Momenta| -> Momenta {
            std::array::from_fn(|k| sum[k] + half * (before[k] + now[k]))
        };
        self.given = added(self.given, before.given, rates.given);
        self.throughput = added(self.throughput, before.throughput, rates.throughput);
        self.gained = std::array::from_fn(|k| momenta[k] - start.momenta[k]);
        if self.samples.is_multiple_of(2) {
            let (time, before, given) = self.every_second;
            let half = 0.5 * (sample.time_s - time);
            let given = std::array::from_fn(|k| given[k] + half * (before.given[k] + rates.given[k]));
            (self.every_second, self.given_there) = ((sample.time_s, rates, given), self.given);
        }
        self.samples += 1;
    }

    /// Missing momentum over what went to and fro, %: linear, and angular where the ring stands straight. None where
    /// half as many samples tell something else: then contacts vibrate between samples, and what is missing is the
    /// sum's and not the run's.
    pub fn missing_percent(&self) -> [Option<f64>; 2] {
        let [x, y, turning] = std::array::from_fn(|k| self.gained[k] - self.given[k]);
        let [error_x, error_y, error_turning] = std::array::from_fn(|k| self.given_there[k] - self.every_second.2[k]);
        let share = |missing: f64, error: f64, of: f64| {
            (of > 0.0 && error.abs() <= RESOLVED * of).then(|| 100.0 * missing.abs() / of)
        };
        let linear = share(x.hypot(y), error_x.hypot(error_y), self.throughput[0].hypot(self.throughput[1]));
        [linear, share(turning, error_turning, self.throughput[2]).filter(|_| !self.tilted)]
    }

    fn momenta(&self, sample: &Sample) -> Momenta {
        let mut sum = [0.0, 0.0, self.cage.inertia * sample.cage.speed_rad_s];
        for (mass, ring) in [(self.supports.inner.mass, &sample.inner), (self.supports.outer.mass, &sample.outer)] {
            let (x, v) = (ring.displacement_m, ring.velocity_m_s);
            (0..2).for_each(|k| sum[k] += mass * v[k]);
            sum[2] += mass * (x[0] * v[1] - x[1] * v[0]);
        }
        for ball in &sample.balls {
            let [along, out] = ball.motion.map_or([0.0; 2], |motion| motion.velocity_m_s);
            let (r, speed) = (ball.orbit_radius_m, ball.orbital_speed_rad_s);
            let v = axes(ball).to_inertial([along, out, r * speed]);
            (0..2).for_each(|k| sum[k] += self.mass * v[k]);
            sum[2] += self.mass * r * r * speed + self.inertia * (ball.angular_velocity_rad_s[0] + speed);
        }
        sum
    }

    fn rates(&self, sample: &Sample, start: &Start) -> Rates {
        let mut rates = Rates::default();
        let Supports { inner, outer } = self.supports;
        let loads = [&self.loads.x, &self.loads.y];
        let on_inner: [f64; 2] = std::array::from_fn(|k| match loads[k] {
            // What holds the ring carries what the balls do to it.
            Translation::Held(_) => -sample.inner.ball_force_n[k],
            load => {
                load.at(sample.time_s) + spring(&sample.inner, k, start.inner[k], (&inner.stiffness, &inner.damping))
            }
        });
        let on_outer: [f64; 2] = std::array::from_fn(|k| {
            let carried = spring(&sample.outer, k, start.outer[k], (&outer.stiffness, &outer.damping));
            carried - start.outer_force[k]
        });
        for (force, ring) in [(on_inner, &sample.inner), (on_outer, &sample.outer)] {
            let x = ring.displacement_m;
            (0..2).for_each(|k| rates.add(k, force[k]));
            rates.add(2, x[0] * force[1] - x[1] * force[0]);
        }
        for ball in &sample.balls {
            self.add_ball(ball, &mut rates);
        }
        let speeds = Races { inner: sample.inner.speed_rad_s, outer: sample.outer.speed_rad_s };
        let [_, drag] = self.cage.fluid_torques(sample.cage.speed_rad_s, speeds);
        for torque in [sample.inner.torque_nm, sample.outer.torque_nm, drag] {
            rates.add(2, torque);
        }
        rates
    }

    fn add_ball(&self, ball: &BallResult, rates: &mut Rates) {
        let (drag, churning) = ball.fluid.map_or((0.0, 0.0), |fluid| (fluid.drag_n, fluid.churning_nm[0]));
        let (r, radius) = (ball.orbit_radius_m, self.cage.pocket.radius);
        let (push, friction) = ball.pocket.map_or((0.0, [0.0; 2]), |p| (p.force_n, p.friction_n.unwrap_or_default()));
        let on_ball = axes(ball).to_inertial([friction[0], friction[1], push * radius / r - drag]);
        (0..2).for_each(|k| rates.add(k, on_ball[k]));
        rates.add(2, -r * drag);
        rates.add(2, churning);
        // Within: contact loads across the axis, and tractions with their arm.
        for (_, contact) in ball.contacts.iter() {
            let out = contact.load_n * contact.angle_rad.cos();
            (0..2).for_each(|k| rates.throughput[k] += out.abs());
            let along = contact.friction.map_or(0.0, |friction| friction.traction_n[0]);
            rates.throughput[2] += (r * along).abs();
        }
    }
}

impl Rates {
    fn add(&mut self, k: usize, given: f64) {
        self.given[k] += given;
        self.throughput[k] += given.abs();
    }
}

fn axes(ball: &BallResult) -> AzimuthFrame {
    AzimuthFrame::at(ball.azimuth_rad)
}

fn xy(v: [f64; 3]) -> [f64; 2] {
    [v[0], v[1]]
}

/// Force of a spring that is relaxed at a place, and of the damper beside it.
fn spring(ring: &RingSample, k: usize, relaxed: f64, (stiffness, damping): (&[f64], &[f64])) -> f64 {
    -stiffness[k] * (ring.displacement_m[k] - relaxed) - damping[k] * ring.velocity_m_s[k]
}
