//! Films of the contacts of a bearing with a lubricant.

use crate::bearing::Bearing;
use crate::geometry::Geometry;
use crate::races::Side;
use crate::result::{BallResult, ContactResult, FilmResult};
use tribodyn_traction::{FilmLaw, Patch, TractionLaw};

/// Rolling speed below which a contact entrains no film to speak of, m/s: a ball that nothing drives.
const LEAST_ROLLING: f64 = 1e-4;

impl Geometry {
    /// Radii of relative curvature along and across rolling at the free contact angle, R_x and R_y, m.
    pub fn relative_radii(&self, side: Side) -> [f64; 2] {
        self.curvatures(side, self.cos_contact_angle()).map(f64::recip)
    }
}

impl Bearing {
    /// The film law of a race; absent where it has no lubricant.
    pub fn film_law(&self, side: Side) -> Option<&FilmLaw> {
        self.tribology.as_ref()?.laws[side].film()
    }

    /// Puts their films into the results of balls; nothing where the bearing has no lubricant.
    pub fn put_films(&self, balls: &mut [BallResult]) {
        for side in Side::BOTH {
            if let Some(law) = self.film_law(side) {
                balls.iter_mut().for_each(|ball| {
                    let contact = &mut ball.contacts[side];
                    contact.film = self.film(law, contact);
                });
            }
        }
    }

    /// Powers that rolling takes in the inlet of a contact and by the hysteresis of its bodies, W; 0 without a
    /// lubricant or a load.
    pub fn rolling_powers(&self, side: Side, contact: &ContactResult) -> [f64; 2] {
        let Some((law, friction)) = self.film_law(side).zip(contact.friction) else { return [0.0; 2] };
        if contact.load_n <= 0.0 {
            return [0.0; 2];
        }
        let [along, across] = friction.slide_to_roll;
        law.rolling_powers(&self.film_patch(contact), contact.rolling_speed_m_s, along.hypot(across))
    }

    fn film_patch(&self, contact: &ContactResult) -> Patch {
        let [semi_lateral, semi_rolling] = contact.semi_axes_m;
        Patch {
            semi_lateral,
            semi_rolling,
            peak_pressure: contact.peak_pressure_pa,
            ball_radius: self.geometry.ball_radius(),
            surface_radius: f64::INFINITY,
        }
    }

    fn film(&self, law: &FilmLaw, contact: &ContactResult) -> Option<FilmResult> {
        let rolls = contact.load_n > 0.0 && contact.rolling_speed_m_s > LEAST_ROLLING;
        let friction = contact.friction.filter(|_| rolls)?;
        let patch = self.film_patch(contact);
        let [along, across] = friction.slide_to_roll;
        let (state, rise) =
            law.under_power(&patch, contact.rolling_speed_m_s, along.hypot(across), friction.power_loss_w);
        Some(FilmResult {
            central_m: state.thickness.central,
            minimum_m: state.thickness.minimum,
            lambda_ratio: state.lambda_ratio,
            temperature_rise_k: rise,
        })
    }
}
