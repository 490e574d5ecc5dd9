//! Resistance to rolling, of the inlet as force and moment on a ball, and of the bodies as a moment.
//!
//! The inlet retards both surfaces with F_R, so that u_1 and u_2 lose the power F_R (|u_1| + |u_2|); the pressure there
//! makes the pair free of a net force. What is left on the ball is a moment M = −F_R r_b about its lateral axis and a
//! force F = F_R l along rolling, with l such that the race has its −F_R too: for a race of radius R about the
//! bearing's axis and an orbit of radius r_c, l = ±(R ∓ r_b)/r_c. From the relative motion alone, l = −2 u_2/W_x − 1.
//!
//! The bodies give back less than they took when they were pressed: rolling at w_y against each other they feel the
//! moment M = −(3/16) α Q b w_y/|w_y|, with the share α of the elastic work that is lost.

use super::FilmLaw;
use crate::{MovingPatch, PatchTraction, Scalar};

/// Velocity of the ball's centre against the race below which nothing rolls, m/s.
const LEAST_ROLLING: f64 = 1e-9;
/// Angular velocity of rolling over which the moment of the bodies changes its sign, rad/s.
const LEAST_TURNING: f64 = 0.1;

impl FilmLaw {
    /// Resistance to rolling on each surface, N.
    pub fn rolling_resistance<D: Scalar>(&self, contact: &MovingPatch<D>) -> D {
        self.inlet.rolling_resistance(&self.rolling_contact(contact))
    }

    /// Moment of the bodies' hysteresis against rolling, N m: (3/16) α Q b, α times the moment of half of Hertz's
    /// pressure.
    ///
    /// Source: K. L. Johnson, Contact Mechanics, Cambridge 1985, section 9.4.
    pub fn hysteresis_moment<D: Scalar>(&self, contact: &MovingPatch<D>) -> D {
        contact.load() * contact.patch.semi_rolling * (3.0 / 16.0 * self.hysteresis)
    }

    /// A traction with the resistance to rolling of inlet and bodies added.
    pub(super) fn with_rolling<D: Scalar>(
        &self,
        contact: &MovingPatch<D>,
        traction: PatchTraction<D>,
    ) -> PatchTraction<D> {
        let [force, moment, power] = self.rolling_loads(contact);
        PatchTraction {
            force_rolling: traction.force_rolling + force,
            moment_lateral: traction.moment_lateral + moment,
            power: traction.power + power,
            ..traction
        }
    }

    /// Force along rolling (N), moment about the lateral axis (N m) and power (W) of inlet and bodies.
    pub(super) fn rolling_loads<D: Scalar>(&self, contact: &MovingPatch<D>) -> [D; 3] {
        let MovingPatch { patch, motion, rolling_speed } = contact;
        let turning = motion.about_lateral;
        let lost = self.hysteresis_moment(contact) * turning / turning_size(turning);
        if motion.rolling.re().abs() < LEAST_ROLLING {
            return [D::zero(), -lost, lost * turning];
        }
        let radius = patch.ball_radius;
        let [along, _] = motion.centre_slip(radius);
        let race = *rolling_speed - along * 0.5;
        let lever = race / motion.rolling * -2.0 - 1.0;
        // The resistance goes to 0 with the speed, not its sign alone.
        let resistance = self.rolling_resistance(contact) * if rolling_speed.re() < 0.0 { -1.0 } else { 1.0 };
        [resistance * lever, resistance * -radius - lost, resistance * *rolling_speed * 2.0 + lost * turning]
    }

    /// Share of the bodies in [`Self::rolling_slopes`].
    fn hysteresis_slopes(&self, contact: &MovingPatch) -> RollingSlopes {
        let moment = self.hysteresis_moment(contact);
        let turning = contact.motion.about_lateral;
        let size = turning_size(turning);
        let lost = moment * turning / size;
        let mut slopes = RollingSlopes { value: [0.0, -lost, lost * turning], by: [[0.0; 3]; 7] };
        // b grows with the cube root of the load, so that Q b has its power 4/3.
        let grown = 4.0 / 3.0 / contact.load();
        slopes.by[5] = [0.0, -lost * grown, lost * turning * grown];
        let bend = moment * (LEAST_TURNING / size).powi(2) / size;
        slopes.by[3] = [0.0, -bend, lost + bend * turning];
        slopes
    }

    /// [`Self::rolling_loads`] with their slopes by motion, load and rolling speed, from the resistance (N) and its
    /// own.
    pub(super) fn rolling_slopes(&self, contact: &MovingPatch, resistance: f64, by: &[f64; 7]) -> RollingSlopes {
        let MovingPatch { patch, motion, rolling_speed } = contact;
        let bodies = self.hysteresis_slopes(contact);
        if motion.rolling.abs() < LEAST_ROLLING {
            return bodies;
        }
        let radius = patch.ball_radius;
        let [along, _] = motion.centre_slip(radius);
        let race = rolling_speed - along * 0.5;
        let lever = race / motion.rolling * -2.0 - 1.0;
        let sign = if *rolling_speed < 0.0 { -1.0 } else { 1.0 };
        let mut lever_by = [0.0; 7];
        lever_by[0] = (1.0 + 2.0 * race / motion.rolling) / motion.rolling;
        lever_by[3] = radius / motion.rolling;
        lever_by[6] = -2.0 / motion.rolling;
        let resistance = sign * resistance;
        RollingSlopes {
            value: sum([resistance * lever, resistance * -radius, resistance * rolling_speed * 2.0], bodies.value),
            by: std::array::from_fn(|input| {
                let change = sign * by[input];
                let faster = if input == 6 { resistance } else { 0.0 };
                let force = change * lever + resistance * lever_by[input];
                sum([force, change * -radius, 2.0 * (change * rolling_speed + faster)], bodies.by[input])
            }),
        }
    }
}

/// Size of the angular velocity of rolling, rad/s; not below [`LEAST_TURNING`].
fn turning_size<D: Scalar>(turning: D) -> D {
    (turning * turning + LEAST_TURNING * LEAST_TURNING).sqrt()
}

fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|row| a[row] + b[row])
}

/// Force along rolling, moment about the lateral axis and power of inlet and bodies, with their slopes by motion, load
/// and rolling speed.
pub(super) struct RollingSlopes {
    pub value: [f64; 3],
    pub by: [[f64; 3]; 7],
}
