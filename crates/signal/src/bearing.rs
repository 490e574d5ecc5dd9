//! Characteristic frequencies of a ball bearing, from its geometry or from a run.

use std::f64::consts::{FRAC_PI_2, TAU};

use serde::{Deserialize, Serialize};

use crate::error::{SignalError, check_setting};

/// Characteristic frequencies at which cage, balls and races meet, Hz; all as magnitudes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BearingFrequencies {
    /// Turns of the inner ring relative to the outer ring.
    pub shaft_hz: f64,
    /// Turns of the cage, or the mean orbit of the balls, in the frame at rest.
    pub cage_hz: f64,
    /// Balls passing a point of the outer race: an outer-race defect.
    pub ball_pass_outer_hz: f64,
    /// Balls passing a point of the inner race: an inner-race defect.
    pub ball_pass_inner_hz: f64,
    /// Turns of a ball about its own axis, seen from the cage.
    pub ball_spin_hz: f64,
    /// Contacts of a spot on a ball with either race, twice the spin: a ball defect.
    pub ball_defect_hz: f64,
}

impl BearingFrequencies {
    /// Frequencies of pure rolling at one contact angle:
    ///
    /// ```text
    /// γ = D cos α/d_m,   f_c = ½ [f_i (1 − γ) + f_o (1 + γ)]
    /// f_bpo = N |f_c − f_o|,   f_bpi = N |f_i − f_c|,   f_b = d_m/(2D) (1 − γ²) |f_i − f_o|
    /// ```
    ///
    /// after R. B. Randall, J. Antoni, Mech. Syst. Signal Process. 25 (2011) 485, doi:10.1016/j.ymssp.2010.07.017, with
    /// both rings turning. Real balls slip by some per mille to per cent and at unequal contact angles; see
    /// [`Self::from_run`].
    ///
    /// Diameters in m, contact angle in rad, speeds of the rings in rad/s with their signs.
    ///
    /// # Errors
    ///
    /// No balls, balls that are not smaller than the pitch circle, a contact angle outside ±90°, speeds that are not
    /// finite.
    pub fn from_geometry(
        ball_count: usize,
        ball_diameter: f64,
        pitch_diameter: f64,
        contact_angle: f64,
        inner_speed: f64,
        outer_speed: f64,
    ) -> Result<Self, SignalError> {
        let possible = ball_diameter > 0.0 && pitch_diameter > ball_diameter && contact_angle.abs() < FRAC_PI_2;
        if ball_count == 0 || !possible || !pitch_diameter.is_finite() {
            return Err(SignalError::Geometry {
                ball_count,
                ball_diameter_m: ball_diameter,
                pitch_diameter_m: pitch_diameter,
                contact_angle_rad: contact_angle,
            });
        }
        let gamma = ball_diameter * contact_angle.cos() / pitch_diameter;
        let cage = 0.5 * (inner_speed * (1.0 - gamma) + outer_speed * (1.0 + gamma));
        let spin = 0.5 * pitch_diameter / ball_diameter * (1.0 - gamma * gamma) * (inner_speed - outer_speed);
        Self::from_run(cage, spin, inner_speed, outer_speed, ball_count)
    }

    /// Frequencies of what was computed or measured: mean cage (or orbital) speed, mean spin of the balls relative to
    /// the cage (the magnitude of ω in the frame that orbits with the ball), and ring speeds, all rad/s.
    ///
    /// # Errors
    ///
    /// Speeds that are not finite.
    pub fn from_run(
        cage_speed: f64,
        ball_spin: f64,
        inner_speed: f64,
        outer_speed: f64,
        ball_count: usize,
    ) -> Result<Self, SignalError> {
        let named = [
            ("cage speed in rad/s", cage_speed),
            ("ball spin in rad/s", ball_spin),
            ("inner speed in rad/s", inner_speed),
            ("outer speed in rad/s", outer_speed),
        ];
        named.into_iter().try_for_each(|(name, value)| check_setting(name, value.abs(), true))?;
        let turns = |speed: f64| speed.abs() / TAU;
        let balls = ball_count as f64;
        Ok(Self {
            shaft_hz: turns(inner_speed - outer_speed),
            cage_hz: turns(cage_speed),
            ball_pass_outer_hz: balls * turns(cage_speed - outer_speed),
            ball_pass_inner_hz: balls * turns(inner_speed - cage_speed),
            ball_spin_hz: turns(ball_spin),
            ball_defect_hz: 2.0 * turns(ball_spin),
        })
    }
}
