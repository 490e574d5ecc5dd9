//! Jones–Harris equilibrium: two force balances per ball, rotation and orbit from raceway control, which also carries
//! the gyroscopic moment.
//!
//! Sources: A. B. Jones, J. Basic Eng. 82 (1960) 309, doi:10.1115/1.3662587; T. A. Harris, Rolling Bearing Analysis,
//! high-speed chapter; MODEL of the source paper: Lubricants 2025, 13(8), 352, section 4.3.3 ("QSJH").
//!
//! Signs: with inner speed and contact angles positive, Ω_r > 0, so the contact must supply +J ω_m Ω_r e_t. Friction
//! does it by a lateral force on the ball of (−cos α_o, sin α_o) λ_o M_g/D at the outer race. The shares λ are a
//! modelling choice ([`tribodyn_bearing::GyroscopicFriction`]).

use crate::block::{AXIAL, BALL, Balance, BlockState, BlockSystem, OMEGA, ORBIT, RADIAL, RING};
use tribodyn_bearing::{
    AzimuthFrame, BallPose, BallSize, Bearing, ContactPose, Races, RingFreedom, RingState, Scalar, Side,
};

/// Names of the equations, for error messages.
pub(crate) const EQUATIONS: [&str; BALL] = [
    "axial force",
    "radial force",
    "axial angular velocity",
    "radial angular velocity",
    "tangential angular velocity",
    "orbital speed",
];

/// The Jones–Harris equations of one bearing at one operating point.
pub(crate) struct JonesHarris<'a> {
    pub bearing: &'a Bearing,
    pub ring: [RingFreedom; RING],
    pub speeds: Races<f64>,
    /// Per ball: whether the inner race controls.
    pub inner_control: Vec<bool>,
    pub centrifugal_at_free_pitch: bool,
    /// True if the friction that holds the gyroscopic moments is bounded by the loads; a guess for other models may
    /// take it from nowhere.
    pub bounded: bool,
    /// Inertia is frozen in the first phase, where forces then have a convex potential.
    pub frozen: Option<f64>,
    pub typical: Typical,
}

/// Share of a typical contact load below which the inner race drives nothing: far below any drag.
const DRIVING_LOAD: f64 = 1e-6;

/// Typical magnitudes for weights, step limits and the floor of relative residuals.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Typical {
    /// Contact force, N.
    pub force: f64,
    /// Contact stiffness, N/m.
    pub stiffness: f64,
    /// Distance of ball centre from the nearer groove centre, m: steps must not pass over it.
    pub offset: f64,
    /// Pitch radius, m.
    pub radius: f64,
    /// Ball count.
    pub balls: f64,
}

impl Typical {
    /// True if an inner load is too small to drive a ball.
    pub fn is_idle(&self, inner_load: f64) -> bool {
        inner_load <= DRIVING_LOAD * self.force
    }

    pub fn new(bearing: &Bearing, ring: &[RingFreedom; RING], speeds: Races<f64>) -> Self {
        let g = &bearing.geometry;
        let balls = g.ball_count as f64;
        let load: f64 = ring[..3].iter().map(|f| if let RingFreedom::Loaded(v) = f { v.abs() } else { 0.0 }).sum();
        let radius = 0.5 * g.pitch_diameter;
        let centrifugal = bearing.ball_mass * radius * (0.5 * (speeds.inner.abs() + speeds.outer.abs())).powi(2);
        // A pressure of 0.5 GPa on a tenth of the ball's section squared: a light but real contact, where nothing loads
        // it.
        let least = 1e-4 * 0.5e9 * g.ball_diameter.powi(2);
        let force = (load / balls + centrifugal).max(least);
        let hertz = bearing.races.outer.frozen::<f64>();
        let approach = hertz.approach(force);
        let offset = g.groove_offset(Side::Outer).min(g.groove_offset(Side::Inner));
        Self { force, stiffness: 1.5 * force / approach, offset, radius, balls }
    }

    pub fn ring_weights(&self) -> [f64; RING] {
        let k = self.stiffness * self.balls;
        let tilt = k * self.radius * self.radius;
        [k, k, k, tilt, tilt]
    }

    pub fn ring_limits(&self) -> [f64; RING] {
        let length = 0.1 * self.offset;
        [length, length, length, length / self.radius, length / self.radius]
    }

    pub fn position_limit(&self) -> f64 {
        0.1 * self.offset
    }

    /// Balances are judged relative to the sum of their terms, but not below this share of a contact force: slip in
    /// the last digit of a surface speed already moves traction by 1e-13 of the load.
    pub fn floor(&self) -> f64 {
        1e-3 * self.force
    }
}

/// Speeds and gyroscopic moment of a ball under raceway control.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Kinematics<D> {
    pub orbital_speed: D,
    /// ω relative to the orbiting frame: axial, radial.
    pub angular_velocity: [D; 2],
    pub gyroscopic_moment: D,
    pub centrifugal_force: D,
}

/// Rolling kinematics with the ball's axis at the pitch angle β that raceway control gives.
pub(crate) fn kinematics<D: Scalar>(
    bearing: &Bearing,
    (pose, ball): (&BallPose<D>, &BallSize),
    Races { inner: inner_speed, outer: outer_speed }: Races<f64>,
    inner_control: bool,
    at_free_pitch: bool,
) -> Kinematics<D> {
    let g = &bearing.geometry;
    let ratio = (g.ball_diameter + 2.0 * ball.excess) / g.pitch_diameter;
    let (i, o) = (&pose.contacts.inner, &pose.contacts.outer);
    let tangent = if inner_control { i.sin / (i.cos - ratio) } else { o.sin / (o.cos + ratio) };
    let (roll_i, roll_o) = (i.cos + tangent * i.sin, o.cos + tangent * o.sin);
    let (near_i, near_o) = (-i.cos * ratio + 1.0, o.cos * ratio + 1.0);
    let (share_i, share_o) = (near_i * roll_o, near_o * roll_i);
    let orbital_speed = (share_i * inner_speed + share_o * outer_speed) / (share_i + share_o);
    // ω cos β from rolling at the outer race.
    let axial = (orbital_speed - outer_speed) * near_o / (roll_o * ratio);
    let angular_velocity = [-axial, axial * tangent];
    let radius = if at_free_pitch { D::from(0.5 * g.pitch_diameter) } else { pose.orbit_radius };
    Kinematics {
        orbital_speed,
        angular_velocity,
        gyroscopic_moment: angular_velocity[1] * orbital_speed * bearing.inertia_of(ball),
        centrifugal_force: radius * orbital_speed * orbital_speed * bearing.mass_of(ball),
    }
}

impl JonesHarris<'_> {
    pub fn pose<D: Scalar>(&self, index: usize, ball: [D; BALL], ring: [D; RING]) -> BallPose<D> {
        let frame = AzimuthFrame::at(self.bearing.azimuth(index)).lift();
        let inner = ring_state(ring, self.speeds.inner);
        let outer = RingState::centred(D::from(self.speeds.outer));
        let mut pose = self.bearing.pose(frame, [ball[AXIAL], ball[RADIAL]], Races { inner: &inner, outer: &outer });
        for side in Side::BOTH {
            pose.contacts[side].approach -= self.bearing.depth_under(index, side);
        }
        pose
    }

    /// Contact load; with constants at the free angle in the first phase, or it would have no potential.
    fn load<D: Scalar>(&self, side: Side, contact: &ContactPose<D>) -> D {
        match self.frozen {
            Some(_) => self.bearing.races[side].frozen::<D>().load(contact.approach),
            None => self.bearing.contact_load(side, contact).0,
        }
    }
}

/// The inner ring at rest in a displaced and tilted position.
pub(crate) fn ring_state<D: Scalar>(ring: [D; RING], speed: f64) -> RingState<D> {
    RingState {
        displacement: [ring[0], ring[1], ring[2]],
        tilt: [ring[3], ring[4]],
        velocity: [D::zero(); 3],
        speed: D::from(speed),
        turning: None,
    }
}

/// Friction over load that no dry contact exceeds for long; clean steel has 0.5 to 0.8.
const FRICTION_MAX: f64 = 1.0;

/// The friction of both races that is to hold a gyroscopic moment, N, as far as their loads give it: what one of them
/// cannot hold the other one takes over, and what neither can turns the ball.
fn held<D: Scalar>(wanted: Races<D>, loads: Races<D>) -> Races<D> {
    let beyond = |side: Side, force: D| {
        let most = loads[side] * FRICTION_MAX;
        let excess = force.re().abs() - most.re();
        if excess > 0.0 { force - most * force.re().signum() } else { D::zero() }
    };
    let over = Races { inner: beyond(Side::Inner, wanted.inner), outer: beyond(Side::Outer, wanted.outer) };
    if over.inner.re() == 0.0 && over.outer.re() == 0.0 {
        return wanted;
    }
    let taken = Races { inner: wanted.inner - over.inner + over.outer, outer: wanted.outer - over.outer + over.inner };
    Races {
        inner: taken.inner - beyond(Side::Inner, taken.inner),
        outer: taken.outer - beyond(Side::Outer, taken.outer),
    }
}

/// Force (N) and moment (N m) of the inner ring on a ball on which it presses with an axial and a radial force.
pub(crate) fn ring_action<D: Scalar>(bearing: &Bearing, index: usize, [axial, radial]: [D; 2]) -> [D; RING] {
    let frame = AzimuthFrame::at(bearing.azimuth(index));
    let lever = bearing.geometry.groove_centre_radius(Side::Inner);
    let [x, y, z] = frame.lift().to_inertial([axial, radial, D::zero()]);
    [x, y, z, axial * (lever * frame.sin), axial * (-lever * frame.cos)]
}

impl BlockSystem for JonesHarris<'_> {
    fn ring(&self) -> &[RingFreedom; RING] {
        &self.ring
    }

    fn ball<D: Scalar>(&self, index: usize, ball: [D; BALL], ring: [D; RING]) -> Balance<D> {
        let pose = self.pose(index, ball, ring);
        let (i, o) = (&pose.contacts.inner, &pose.contacts.outer);
        let (q_i, q_o) = (self.load(Side::Inner, i), self.load(Side::Outer, o));
        let inner_control = self.inner_control[index];
        let size = self.bearing.ball_size(index);
        let k = kinematics(self.bearing, (&pose, &size), self.speeds, inner_control, self.centrifugal_at_free_pitch);
        let (moment, centrifugal) = match self.frozen {
            Some(force) => (D::zero(), D::from(force)),
            None => (k.gyroscopic_moment, k.centrifugal_force),
        };
        // λ M_g / D.
        let shares = self.bearing.modelling.gyroscopic_shares(inner_control);
        let diameter = self.bearing.geometry.ball_diameter + 2.0 * size.excess;
        let wanted = shares.map(|share| moment * (share / diameter));
        let Races { inner: f_i, outer: f_o } =
            if self.bounded { held(wanted, Races { inner: q_i, outer: q_o }) } else { wanted };
        let on_ball_i = [q_i * i.sin + f_i * i.cos, q_i * i.cos - f_i * i.sin];
        let on_ball_o = [-q_o * o.sin - f_o * o.cos, -q_o * o.cos + f_o * o.sin];
        let motion = [k.angular_velocity[0], k.angular_velocity[1], D::zero(), k.orbital_speed];
        let residual = [
            on_ball_i[0] + on_ball_o[0],
            on_ball_i[1] + on_ball_o[1] + centrifugal,
            motion[0] - ball[OMEGA],
            motion[1] - ball[OMEGA + 1],
            motion[2] - ball[OMEGA + 2],
            motion[3] - ball[ORBIT],
        ];
        let size = |d: D| d.re().abs();
        let floor = self.typical.floor();
        let speed = self.speeds.inner.abs() + self.speeds.outer.abs();
        let scale = [
            (size(on_ball_i[0]) + size(on_ball_o[0])).max(floor),
            (size(on_ball_i[1]) + size(on_ball_o[1]) + size(centrifugal)).max(floor),
            speed,
            speed,
            speed,
            speed,
        ];
        let lever = self.bearing.geometry.groove_centre_radius(Side::Inner);
        let ring = ring_action(self.bearing, index, on_ball_i);
        let total = q_i.re() + floor;
        Balance { residual, scale, ring, ring_scale: [total, total, total, total * lever, total * lever] }
    }

    fn weights(&self) -> ([f64; BALL], [f64; RING]) {
        let k = self.typical.stiffness;
        ([k, k, 0.0, 0.0, 0.0, 0.0], self.typical.ring_weights())
    }

    fn inertia(&self) -> [f64; BALL] {
        // No true inertia: the position creeps to equilibrium in about a tenth of a millisecond of pseudo-time.
        let creep = 1e-4 * self.typical.stiffness;
        [creep, creep, 0.0, 0.0, 0.0, 0.0]
    }

    fn step_limits(&self) -> ([f64; BALL], [f64; RING]) {
        let (near, any) = (self.typical.position_limit(), f64::INFINITY);
        ([near, near, any, any, any, any], self.typical.ring_limits())
    }

    /// With inertia and contact constants frozen the forces derive from Σ ⅖ Q δ − F_c X2 − load·q, convex in ball and
    /// ring positions because the distances are.
    fn energy(&self, state: &BlockState) -> f64 {
        let centrifugal = self.frozen.unwrap_or_default();
        let mut energy = 0.0;
        for (index, &ball) in state.balls.iter().enumerate() {
            let pose = self.pose(index, ball, state.ring);
            for (side, contact) in pose.contacts.iter() {
                energy += 0.4 * self.load(side, contact) * contact.approach;
            }
            energy -= centrifugal * ball[RADIAL];
        }
        for (freedom, q) in self.ring.iter().zip(state.ring) {
            if let RingFreedom::Loaded(load) = freedom {
                energy -= load * q;
            }
        }
        energy
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_friction_of_raceway_control_is_bounded_by_the_loads() {
        let both = |inner, outer| Races { inner, outer };
        // Enough load: as the model has it, to the last bit.
        assert_eq!(held(both(0.3, -0.1), both(1.0, 1.0)), both(0.3, -0.1));
        // What one race cannot hold the other one takes over, as far as it can.
        assert_eq!(held(both(10.0, 0.0), both(4.0, 100.0)), both(4.0, 6.0));
        assert_eq!(held(both(-10.0, 0.0), both(0.0, 3.0)), both(0.0, -3.0));
        assert_eq!(held(both(2.0, 2.0), both(0.0, 0.0)), both(0.0, 0.0));
    }
}
