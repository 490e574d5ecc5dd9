//! From a state to a sample.

use crate::equations::{BallForces, Frame};
use crate::forces::{BodyForces, Sums, dot, evaluate, evaluate_with};
use crate::layout::{AZIMUTH, VELOCITY};
use crate::machine::Machine;
use crate::sample::{BallSample, CageSample, ContactSample, PowerSample, RingSample, Sample, WearSample};
use tribodyn_bearing::{LoadedPatch, Side};
use tribodyn_traction::PatchTraction;

/// Volumes worn off so far, m³: inner race, outer race, cage.
pub(crate) type Worn = [f64; 3];

impl Machine {
    /// Everything at a time and state. `energy_at_start` and the volumes worn off are the run's, and `traction` tells who
    /// integrates it.
    pub fn sample(
        &self,
        (t, y): (f64, &[f64]),
        (energy_at_start, worn): (f64, Worn),
        traction: impl FnMut(usize, &LoadedPatch<'_, f64>) -> PatchTraction,
    ) -> Sample {
        let mut balls = Vec::with_capacity(self.layout.balls);
        let (frame, sums, bodies) = evaluate_with(self, t, y, traction, |index, forces| {
            balls.push(self.ball_sample(self.unknowns(index, y), forces));
        });
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
            },
            power: PowerSample {
                energy_j: energy,
                imbalance_j: y[w] - y[w + 1] - (energy - energy_at_start),
                throughput_j: y[w + 2],
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

    fn ball_sample(&self, b: &[f64], f: &BallForces) -> BallSample {
        let g = &self.bearing.geometry;
        let s = &f.state;
        BallSample {
            azimuth_rad: b[AZIMUTH],
            orbital_speed_rad_s: s.orbital_speed,
            orbital_acceleration_rad_s2: f.acceleration[2],
            orbit_radius_m: f.orbit_radius,
            axial_displacement_m: s.position[0] - g.groove_offset(Side::Outer) * g.sin_contact_angle(),
            velocity_m_s: [b[VELOCITY], b[VELOCITY + 1]],
            spin_rad_s: [s.spin[0] - s.orbital_speed, s.spin[1], s.spin[2]],
            inner: self.contact_sample(Side::Inner, f),
            outer: self.contact_sample(Side::Outer, f),
            drag_n: f.friction.drag,
            churning_nm: f.friction.churning,
            churning_w: -dot(f.friction.churning, s.spin),
            pocket_lead_rad: f.lead,
            pocket_force_n: f.friction.pocket.force,
            pocket_friction_n: f.friction.pocket.friction,
            wear_rate_cage_m3_s: self.pocket_wear(&f.friction.pocket),
        }
    }

    fn contact_sample(&self, side: Side, f: &BallForces) -> ContactSample {
        let c = &f.contacts[side];
        let normal = &c.normal;
        let [along, across, spin] = c.slide_to_roll(self.bearing.geometry.ball_radius());
        let surface = &f.surfaces[side];
        ContactSample {
            angle_rad: normal.pose.sin.atan2(normal.pose.cos),
            approach_m: normal.pose.approach,
            load_n: normal.load,
            normal_force_n: normal.force,
            semi_axes_m: [c.ellipse.semi_lateral(), c.ellipse.semi_rolling()],
            peak_pressure_pa: c.ellipse.peak_pressure,
            traction_n: [c.traction.force_rolling, c.traction.force_lateral],
            slide_to_roll: [along, across],
            spin_ratio_per_m: spin,
            rolling_speed_m_s: c.rolling_speed.abs(),
            power_loss_w: c.traction.power,
            wear_rate_m3_s: self.bearing.wear_rate(side, c.traction.wear_integral),
            bare: surface.bare,
            depth_m: surface.depth + self.bearing.worn[side].depth,
        }
    }
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
