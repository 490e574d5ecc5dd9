//! Forces, accelerations and powers at a time and state: section 5 of the model, every term, written once for the
//! schemes and for the samples.

use crate::layout::{AXIAL, AZIMUTH, BALL, Layout, ORBIT, RADIUS, SPIN, VELOCITY};
use crate::machine::Machine;
use crate::pocket::{PocketLoad, PocketMotion};
use std::f64::consts::TAU;
use tribodyn_bearing::traction::{PatchTraction, TractionLaw};
use tribodyn_bearing::wear::{Archard, LocalSurface};
use tribodyn_bearing::{BallLoads, BallState, LoadedPatch, RingState, Side, in_azimuth_frame};

/// What can be integrated in time.
pub(crate) trait System {
    /// Time derivative of the unknowns `y` at time `t` in s.
    fn derivative(&mut self, t: f64, y: &[f64], dy: &mut [f64]);
}

/// One ball with all that acts on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BallForces {
    pub state: BallState,
    pub loads: BallLoads,
    pub pocket: PocketLoad,
    pub lead: f64,
    pub surfaces: [LocalSurface; 2],
    /// Of the axial and radial velocity (m/s²), the orbital speed and the spin (rad/s²).
    pub acceleration: [f64; 6],
}

/// Rings and cage at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    /// Inner, outer.
    pub rings: [RingState; 2],
    /// Angles turned by the rings, rad.
    pub angles: [f64; 2],
    /// Cage angle (rad) and speed (rad/s).
    pub cage: [f64; 2],
}

/// Sums over all balls.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Sums {
    /// Force of the balls on inner and outer ring, N.
    pub on_rings: [[f64; 3]; 2],
    /// Torque of the rings on the balls, N m.
    pub torque: [f64; 2],
    /// Torque of the balls on the cage, N m.
    pub cage_torque: f64,
    pub powers: BallPowers,
}

/// Powers lost by the balls, W, and the energy they hold, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct BallPowers {
    /// Inner, outer.
    pub friction: [f64; 2],
    pub drag: f64,
    pub churning: f64,
    pub contact_damping: f64,
    pub pocket_friction: f64,
    pub pocket_damping: f64,
    pub energy: f64,
}

/// Accelerations of rings and cage and the powers that belong to them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct BodyForces {
    pub inner: [f64; 3],
    pub outer: [f64; 2],
    pub cage: f64,
    pub fluid_torque: f64,
    /// Torques of the rings' drives, N m.
    pub torque: [f64; 2],
    pub shaft_power: f64,
    pub load_power: f64,
    pub support_loss: f64,
    pub cage_loss: f64,
    /// Of rings, cage and supports, J.
    pub energy: f64,
}

impl<L: TractionLaw> Machine<L> {
    /// Rings and cage of a state.
    pub fn frame(&self, t: f64, y: &[f64]) -> Frame {
        let l = self.layout;
        let [i, o, c, a] = [l.inner(), l.outer(), l.cage(), l.angles()];
        let inner = RingState {
            displacement: [y[i], y[i + 1], y[i + 2]],
            tilt: self.tilt,
            velocity: [y[i + 3], y[i + 4], y[i + 5]],
            speed: self.speeds[0].at(t),
        };
        let outer = RingState {
            displacement: [y[o], y[o + 1], 0.0],
            tilt: [0.0; 2],
            velocity: [y[o + 2], y[o + 3], 0.0],
            speed: self.speeds[1].at(t),
        };
        Frame { rings: [inner, outer], angles: [y[a], y[a + 1]], cage: [y[c], y[c + 1]] }
    }

    /// State of a ball with the unknowns `b`, and the surfaces where it stands.
    #[inline]
    pub fn ball_state(&self, b: &[f64], frame: &Frame) -> (BallState, [LocalSurface; 2]) {
        let (sin, cos) = b[AZIMUTH].sin_cos();
        let groove = self.bearing.geometry.groove_centre_radius(Side::Outer);
        let shift = in_azimuth_frame([sin, cos], frame.rings[1].displacement)[1];
        let velocity = [b[VELOCITY], b[VELOCITY + 1]];
        let state = BallState {
            azimuth: [sin, cos],
            position: [b[AXIAL], b[RADIUS] - shift - groove],
            velocity: if self.terms.ball_translation { velocity } else { [0.0; 2] },
            orbital_speed: b[ORBIT],
            spin: [b[SPIN], b[SPIN + 1], b[SPIN + 2]],
        };
        (state, [self.surface(0, b[AZIMUTH] - frame.angles[0]), self.surface(1, b[AZIMUTH] - frame.angles[1])])
    }

    /// Surface of a raceway at an azimuth of its ring; what had worn off all round at the start is in the pose of the ball.
    #[inline]
    fn surface(&self, k: usize, azimuth: f64) -> LocalSurface {
        let mut surface = self.raceways[k].at(azimuth);
        surface.depth -= self.bearing.worn[k].depth;
        surface
    }

    /// What the pocket does to a ball.
    pub fn pocket_load(&self, index: usize, b: &[f64], frame: &Frame) -> PocketLoad {
        self.cage.pocket.load(&PocketMotion {
            lead: self.lead(index, b, frame.cage[0]),
            rate: b[ORBIT] - frame.cage[1],
            velocity: [b[VELOCITY], b[VELOCITY + 1]],
            spin: [b[SPIN], b[SPIN + 1]],
            cage_speed: frame.cage[1],
        })
    }

    /// Lead of a ball over the middle of its pocket, rad.
    pub fn lead(&self, index: usize, b: &[f64], cage_angle: f64) -> f64 {
        b[AZIMUTH] - cage_angle - TAU * index as f64 / self.layout.balls as f64
    }

    /// One ball, traction by the kernel: `b` are its unknowns.
    pub fn ball(&self, index: usize, b: &[f64], frame: &Frame) -> BallForces {
        self.ball_with(index, b, frame, |patch| self.kernel.traction(&self.bearing, patch))
    }

    /// One ball, traction by whoever integrates it.
    fn ball_with(
        &self,
        index: usize,
        b: &[f64],
        frame: &Frame,
        traction: impl FnMut(&LoadedPatch<'_, f64, L>) -> PatchTraction,
    ) -> BallForces {
        let (state, surfaces) = self.ball_state(b, frame);
        let [inner, outer] = &frame.rings;
        let still = |ring: &RingState| RingState { velocity: [0.0; 3], ..*ring };
        let rings = if self.terms.ring_translation { [*inner, *outer] } else { [still(inner), still(outer)] };
        let surroundings = ([&rings[0], &rings[1]], [&surfaces[0], &surfaces[1]]);
        let loads = self.bearing.ball_loads_with(&state, surroundings.0, surroundings.1, traction);
        let pocket = self.pocket_load(index, b, frame);
        let acceleration = self.acceleration(&state, [b[VELOCITY], b[VELOCITY + 1]], &loads, &pocket);
        let lead = self.lead(index, b, frame.cage[0]);
        BallForces { state, loads, pocket, lead, surfaces, acceleration }
    }

    /// Newton and Euler for one ball in its azimuth frame.
    fn acceleration(&self, s: &BallState, v: [f64; 2], loads: &BallLoads, pocket: &PocketLoad) -> [f64; 6] {
        let (m, j, r) = (self.bearing.ball_mass, self.bearing.ball_inertia, loads.orbit_radius);
        let [force, moment] = [loads.force(), loads.moment()];
        let off_centre = if self.terms.eccentricity { 0.0 } else { loads.eccentricity };
        let arm = if self.terms.equal_pocket_arms { self.cage.pocket.radius / r } else { 1.0 };
        let along = force[2] - off_centre + pocket.force * arm;
        let w = s.orbital_speed;
        // ω_m e_a × Ω = ω_m (−Ω_t e_r + Ω_r e_t).
        let transport = if self.terms.spin_transport { [-w * s.spin[2], w * s.spin[1]] } else { [0.0; 2] };
        let orbital = along / (m * r) - 2.0 * v[1] * w / r;
        let relative = if self.terms.absolute_spin { 0.0 } else { orbital };
        [
            (force[0] + pocket.friction[0]) / m,
            (force[1] + pocket.friction[1]) / m + r * w * w,
            orbital,
            (moment[0] + pocket.moment[0]) / j + relative,
            (moment[1] + pocket.moment[1]) / j - transport[0],
            moment[2] / j - transport[1],
        ]
    }

    /// Adds what a ball does to rings and cage, and its powers.
    pub fn add_ball(&self, b: &BallForces, velocity: [f64; 2], frame: &Frame, sums: &mut Sums) {
        let [sin, cos] = b.state.azimuth;
        for (k, contact) in [&b.loads.inner, &b.loads.outer].into_iter().enumerate() {
            let [f_a, f_r, f_t] = contact.force;
            let on_ball = [f_r * cos - f_t * sin, f_r * sin + f_t * cos, f_a];
            (0..3).for_each(|i| sums.on_rings[k][i] -= on_ball[i]);
            sums.torque[k] += self.bearing.ring_torque(&b.state, contact, b.loads.orbit_radius, &frame.rings[k]);
            sums.powers.friction[k] += contact.traction.power;
            sums.powers.contact_damping += (contact.normal_force - contact.load) * contact.closing_speed;
            // Work of a force that grows with the power 3/2 of the approach.
            sums.powers.energy += 0.4 * contact.load * contact.pose.approach.max(0.0);
        }
        sums.cage_torque += b.pocket.cage_torque;
        let p = &mut sums.powers;
        let (s, r) = (&b.state, b.loads.orbit_radius);
        p.drag += b.loads.drag * r * s.orbital_speed;
        p.churning -= dot(b.loads.churning, s.spin);
        p.pocket_friction += b.pocket.friction_power;
        p.pocket_damping += b.pocket.damping_power;
        let [v_a, v_r] = velocity;
        let speed = v_a * v_a + v_r * v_r + (r * s.orbital_speed).powi(2);
        p.energy += 0.5 * self.bearing.ball_mass * speed
            + 0.5 * self.bearing.ball_inertia * dot(s.spin, s.spin)
            + b.pocket.energy;
    }

    /// Rings and cage under the sums of the balls.
    pub fn bodies(&self, t: f64, frame: &Frame, sums: &Sums) -> BodyForces {
        let mut f = BodyForces::default();
        let [inner, outer] = &frame.rings;
        for i in 0..3 {
            if !self.inner.free[i] {
                continue;
            }
            let (x, v, load) = (inner.displacement[i], inner.velocity[i], self.loads[i].at(t));
            f.inner[i] = (load + sums.on_rings[0][i] + self.inner.force(i, x, v)) / self.inner.mass;
            f.load_power += load * v;
            let stretch = x - self.inner.reference[i];
            f.energy += 0.5 * (self.inner.mass * v * v + self.inner.stiffness[i] * stretch * stretch);
            f.support_loss += self.inner.damping[i] * v * v;
        }
        for i in 0..2 {
            if !self.outer.free[i] {
                continue;
            }
            let (x, v) = (outer.displacement[i], outer.velocity[i]);
            f.outer[i] = (sums.on_rings[1][i] + self.outer.force(i, x, v)) / self.outer.mass;
            let stretch = x - self.outer.reference[i];
            f.energy += 0.5 * (self.outer.mass * v * v + self.outer.stiffness[i] * stretch * stretch);
            f.support_loss += self.outer.damping[i] * v * v;
        }
        let speeds = [inner.speed, outer.speed];
        let [guidance, drag] = self.cage.fluid_torques(frame.cage[1], speeds);
        f.fluid_torque = guidance + drag;
        f.cage = (sums.cage_torque + f.fluid_torque) / self.cage.inertia;
        f.cage_loss = -f.fluid_torque * frame.cage[1];
        f.energy += 0.5 * self.cage.inertia * frame.cage[1] * frame.cage[1];
        f.torque = sums.torque;
        if let Some(land) = &self.cage.guidance {
            f.torque[land.ring()] += guidance;
            f.cage_loss += guidance * speeds[land.ring()];
        }
        f.shaft_power = f.torque[0] * speeds[0] + f.torque[1] * speeds[1];
        f
    }

    /// All balls at a time and state, traction by the kernel; `each` sees every one.
    pub fn evaluate(&self, t: f64, y: &[f64], each: impl FnMut(usize, &BallForces)) -> (Frame, Sums, BodyForces) {
        self.evaluate_with(t, y, |_, patch| self.kernel.traction(&self.bearing, patch), each)
    }

    /// All balls at a time and state, traction on the patches of each by whoever integrates it.
    pub fn evaluate_with(
        &self,
        t: f64,
        y: &[f64],
        mut traction: impl FnMut(usize, &LoadedPatch<'_, f64, L>) -> PatchTraction,
        mut each: impl FnMut(usize, &BallForces),
    ) -> (Frame, Sums, BodyForces) {
        let frame = self.frame(t, y);
        let mut sums = Sums::default();
        for index in 0..self.layout.balls {
            let b = &y[self.layout.ball(index)..][..BALL];
            let forces = self.ball_with(index, b, &frame, |patch| traction(index, patch));
            self.add_ball(&forces, [b[VELOCITY], b[VELOCITY + 1]], &frame, &mut sums);
            each(index, &forces);
        }
        let bodies = self.bodies(t, &frame, &sums);
        (frame, sums, bodies)
    }
}

impl Sums {
    /// All that the balls lose, W.
    pub fn losses(&self) -> f64 {
        let p = &self.powers;
        p.friction[0] + p.friction[1] + p.drag + p.churning + p.contact_damping + p.pocket_friction + p.pocket_damping
    }
}

impl<L: TractionLaw> System for Machine<L> {
    fn derivative(&mut self, t: f64, y: &[f64], dy: &mut [f64]) {
        let l = self.layout;
        let mut watch = std::mem::take(&mut self.watch);
        let (frame, sums, bodies) = self.evaluate(t, y, |index, ball| {
            let at = l.ball(index);
            dy[at..at + 3].copy_from_slice(&y[at + VELOCITY..at + VELOCITY + 3]);
            dy[at + VELOCITY..at + BALL].copy_from_slice(&ball.acceleration);
            watch[index] = self.watch(&ball.loads, &ball.pocket);
        });
        self.watch = watch;
        body_derivative(l, &frame, &sums, &bodies, dy);
    }
}

/// The derivatives of everything but the balls.
pub(crate) fn body_derivative(l: Layout, frame: &Frame, sums: &Sums, f: &BodyForces, dy: &mut [f64]) {
    let [c, i, o, a, w] = [l.cage(), l.inner(), l.outer(), l.angles(), l.work()];
    let [inner, outer] = &frame.rings;
    dy[c..c + 2].copy_from_slice(&[frame.cage[1], f.cage]);
    dy[i..i + 3].copy_from_slice(&inner.velocity);
    dy[i + 3..i + 6].copy_from_slice(&f.inner);
    dy[o..o + 2].copy_from_slice(&outer.velocity[..2]);
    dy[o + 2..o + 4].copy_from_slice(&f.outer);
    dy[a..a + 2].copy_from_slice(&[inner.speed, outer.speed]);
    let put_in = f.shaft_power + f.load_power;
    let lost = sums.losses() + f.support_loss + f.cage_loss;
    dy[w..w + 3].copy_from_slice(&[put_in, lost, f.shaft_power.abs() + f.load_power.abs()]);
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// What the run must know of a ball after every step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Watch {
    /// Wear rates of inner race, outer race and cage, m³/s.
    pub wear: [f64; 3],
    /// Lateral semi-axes of the contacts, m.
    pub semi_lateral: [f64; 2],
    /// Whether the contacts carry load.
    pub loaded: [bool; 2],
}

impl<L: TractionLaw> Machine<L> {
    pub fn watch(&self, loads: &BallLoads, pocket: &PocketLoad) -> Watch {
        let contacts = [&loads.inner, &loads.outer];
        let wear = |side: Side, k: usize| self.archard(side).rate(contacts[k].traction.wear_integral);
        Watch {
            wear: [wear(Side::Inner, 0), wear(Side::Outer, 1), self.pocket_wear(pocket)],
            semi_lateral: contacts.map(|c| c.ellipse.semi_lateral()),
            loaded: contacts.map(|c| c.load > 0.0),
        }
    }
}

impl<L> Machine<L> {
    /// Wear of a race.
    pub fn archard(&self, side: Side) -> &Archard {
        match side {
            Side::Inner => &self.bearing.wear_inner,
            Side::Outer => &self.bearing.wear_outer,
        }
    }

    /// Wear rate of a pocket, m³/s.
    pub fn pocket_wear(&self, pocket: &PocketLoad) -> f64 {
        self.bearing.wear_cage.rate(pocket.sliding * pocket.force.abs())
    }
}
