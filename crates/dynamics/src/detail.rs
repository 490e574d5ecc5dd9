//! From a state to a sample.

use crate::equations::{BallForces, Frame};
use crate::forces::{BodyForces, Sums, evaluate};
use crate::layout::{AZIMUTH, VELOCITY};
use crate::machine::Machine;
use crate::power::PowerSample;
use crate::sample::{CageSample, RingSample, Sample, WearSample};
use tribodyn_bearing::{BallMotionResult, BallResult, PocketResult, Sheet, Side};

/// Volumes worn off so far, m³: inner race, outer race, cage.
pub(crate) type Worn = [f64; 3];

/// All balls at a time: what they do to rings and cage, and the result for each.
pub(crate) type Balls = (Sums, Vec<BallResult>);

impl Machine {
    /// The balls at a time and state, traction by the kernel.
    pub fn balls(&self, t: f64, y: &[f64]) -> Balls {
        let (sheet, speed) = (self.bearing.sheet(), self.speeds.inner.at(t));
        let mut balls = Vec::with_capacity(self.layout.balls);
        let (_, sums, _) = evaluate(self, t, y, |index, forces| {
            balls.push(ball_result(&sheet, (self.unknowns(index, y), speed), forces));
        });
        (sums, balls)
    }

    /// Everything at a time and state. `energy_at_start` and the volumes worn off are the run's.
    pub fn sample(&self, (t, y): (f64, &[f64]), (energy_at_start, worn): (f64, Worn), (sums, balls): Balls) -> Sample {
        let frame = self.frame(t, y);
        let bodies = self.bodies(t, &frame, &sums);
        let energy = sums.powers.energy + bodies.energy;
        let w = self.layout.work();
        Sample {
            time_s: t,
            inner: ring_sample(&frame, &sums, &bodies, Side::Inner),
            outer: ring_sample(&frame, &sums, &bodies, Side::Outer),
            cage: CageSample {
                angle_rad: frame.cage[0],
                speed_rad_s: frame.cage[1],
                speed_filtered_rad_s: frame.cage[1],
                acceleration_rad_s2: bodies.cage,
                ball_torque_nm: sums.cage_torque,
                fluid_torque_nm: bodies.fluid_torque,
                free: self.free_cage_sample(&frame),
            },
            power: PowerSample {
                energy_j: energy,
                imbalance_j: y[w] - y[w + 1] - (energy - energy_at_start),
                throughput_j: y[w + 2].max(y[w + 1].abs()),
                ..powers(&sums, &bodies)
            },
            wear: WearSample {
                volume_inner_m3: worn[0],
                volume_outer_m3: worn[1],
                volume_cage_m3: worn[2],
                coating_inner_min_m: self.thinnest.inner,
                coating_outer_min_m: self.thinnest.outer,
            },
            balls,
        }
    }

    /// Kinetic and elastic energy at a state, J.
    pub fn energy(&self, t: f64, y: &[f64]) -> f64 {
        let (_, sums, bodies) = evaluate(self, t, y, |_, _| ());
        sums.powers.energy + bodies.energy
    }
}

/// The ball's result, with what only a run has; `b` are its unknowns.
#[inline(always)]
pub(crate) fn ball_result(sheet: &Sheet, (b, inner_speed): (&[f64], f64), f: &BallForces) -> BallResult {
    let friction = &f.friction;
    let mut result = sheet.ball(b[AZIMUTH], &f.state, &f.loads(), inner_speed);
    let (contacts, surfaces) = (&f.contacts, &f.surfaces);
    result.contacts.inner.transient = Some(sheet.transient_contact(Side::Inner, &contacts.inner, &surfaces.inner));
    result.contacts.outer.transient = Some(sheet.transient_contact(Side::Outer, &contacts.outer, &surfaces.outer));
    result.pocket = Some(PocketResult {
        lead_rad: f.lead,
        force_n: friction.pocket.force,
        friction_n: Some(friction.pocket.friction),
        wear_rate_m3_s: sheet.pocket_wear(&friction.pocket),
    });
    result.motion = Some(BallMotionResult {
        orbital_acceleration_rad_s2: f.acceleration[2],
        velocity_m_s: [b[VELOCITY], b[VELOCITY + 1]],
    });
    result
}

fn ring_sample(frame: &Frame, sums: &Sums, bodies: &BodyForces, side: Side) -> RingSample {
    let ring = &frame.rings[side];
    let acceleration = match side {
        Side::Inner => bodies.inner,
        Side::Outer => [bodies.outer[0], bodies.outer[1], 0.0],
    };
    RingSample {
        angle_rad: frame.angles[side],
        speed_rad_s: ring.speed,
        displacement_m: ring.displacement,
        tilt_rad: ring.tilt,
        velocity_m_s: ring.velocity,
        // The run filters it.
        acceleration_m_s2: acceleration,
        acceleration_point_m_s2: acceleration,
        ball_force_n: sums.on_rings[side],
        torque_nm: bodies.torque[side],
    }
}

fn powers(sums: &Sums, bodies: &BodyForces) -> PowerSample {
    let p = &sums.powers;
    PowerSample {
        shaft_w: bodies.shaft_power,
        load_w: bodies.load_power,
        friction_inner_w: p.friction.inner,
        friction_outer_w: p.friction.outer,
        drag_w: p.drag,
        churning_w: p.churning,
        contact_damping_w: p.contact_damping,
        pocket_friction_w: p.pocket_friction,
        pocket_damping_w: p.pocket_damping,
        cage_w: bodies.cage_loss,
        support_w: bodies.support_loss,
        ..PowerSample::default()
    }
}
