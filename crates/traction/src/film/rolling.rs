//! Rolling resistance of the inlet as force and moment on a ball.
//!
//! The inlet retards both surfaces with F_R, so that u_1 and u_2 lose the power F_R (|u_1| + |u_2|); the pressure there
//! makes the pair free of a net force. What is left on the ball is a moment M = −F_R r_b about its lateral axis and a
//! force F = F_R l along rolling, with l such that the race has its −F_R too: for a race of radius R about the
//! bearing's axis and an orbit of radius r_c, l = ±(R ∓ r_b)/r_c. From the relative motion alone, l = −2 u_2/W_x − 1.

use super::{FilmContact, FilmLaw};
use crate::{PatchTraction, Scalar};

/// Velocity of the ball's centre against the race below which nothing rolls, m/s.
const LEAST_ROLLING: f64 = 1e-9;

impl FilmLaw {
    /// Resistance to rolling on each surface, N.
    pub fn rolling_resistance<D: Scalar>(&self, contact: &FilmContact<D>) -> D {
        self.inlet.rolling_resistance(&self.rolling_contact(contact))
    }

    /// A traction with the rolling resistance of the inlet added.
    pub(super) fn with_rolling<D: Scalar>(
        &self,
        contact: &FilmContact<D>,
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

    /// Force along rolling (N), moment about the lateral axis (N m) and power (W) of the inlet.
    pub(super) fn rolling_loads<D: Scalar>(&self, contact: &FilmContact<D>) -> [D; 3] {
        let FilmContact { patch, motion, rolling_speed } = contact;
        if motion.rolling.re().abs() < LEAST_ROLLING {
            return [D::zero(); 3];
        }
        let radius = patch.ball_radius;
        let [along, _] = motion.centre_slip(radius);
        let race = *rolling_speed - along * 0.5;
        let lever = race / motion.rolling * -2.0 - 1.0;
        // The resistance goes to 0 with the speed, not its sign alone.
        let resistance = self.rolling_resistance(contact) * if rolling_speed.re() < 0.0 { -1.0 } else { 1.0 };
        [resistance * lever, resistance * -radius, resistance * *rolling_speed * 2.0]
    }

    /// [`Self::rolling_loads`] with their slopes by motion, load and rolling speed, from the resistance (N) and its
    /// own.
    pub(super) fn rolling_slopes(&self, contact: &FilmContact, resistance: f64, by: &[f64; 7]) -> RollingSlopes {
        let FilmContact { patch, motion, rolling_speed } = contact;
        if motion.rolling.abs() < LEAST_ROLLING {
            return RollingSlopes::default();
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
            value: [resistance * lever, resistance * -radius, resistance * rolling_speed * 2.0],
            by: std::array::from_fn(|input| {
                let change = sign * by[input];
                let faster = if input == 6 { resistance } else { 0.0 };
                let force = change * lever + resistance * lever_by[input];
                [force, change * -radius, 2.0 * (change * rolling_speed + faster)]
            }),
        }
    }
}

/// Force along rolling, moment about the lateral axis and power of the inlet, with their slopes by motion, load and
/// rolling speed.
#[derive(Default)]
pub(super) struct RollingSlopes {
    pub value: [f64; 3],
    pub by: [[f64; 3]; 7],
}
