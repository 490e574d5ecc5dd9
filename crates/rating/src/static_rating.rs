//! Static load rating C_0r, static safety and fatigue load limit: ISO 76, and annex B of ISO 281.

use crate::dynamic_rating::{MM_PER_M, USUAL_GROOVES};
use crate::equivalent::between;
use crate::{RatedBearing, RatingError, load};
use tribodyn_contact::{ContactError, ElasticBody, HertzContact, effective_modulus};

/// Peak pressure that ISO 76 allows a ball bearing at rest, Pa: a total permanent deformation of about D/10000.
pub const PERMISSIBLE_PRESSURE: f64 = 4.2e9;

/// The bearing steel of ISO/TR 10657.
const STEEL: ElasticBody = ElasticBody { young: 207e9, poisson: 0.3 };
/// Load of the heaviest loaded ball over the mean radial load of a ball, Stribeck's number.
const STRIBECK: f64 = 5.0;
/// Pitch diameter beyond which the fatigue load limit falls, m.
const LARGE_PITCH: f64 = 0.1;

impl RatedBearing {
    /// The factor f_0 of ISO 76, N/mm²: 0.2/D² of the ball load that brings the weaker race to
    /// [`PERMISSIBLE_PRESSURE`].
    ///
    /// # Errors
    /// [`RatingError`] for dimensions that are not those of a radial ball bearing.
    pub fn static_factor(&self) -> Result<f64, RatingError> {
        let diameter = self.ball_diameter * MM_PER_M;
        Ok(self.permissible_ball_load()? / (STRIBECK * diameter * diameter))
    }

    /// Basic static load rating C_0r, N.
    ///
    /// # Errors
    /// As [`Self::static_factor`].
    pub fn static_rating(&self) -> Result<f64, RatingError> {
        Ok(self.permissible_ball_load()? * self.ball_count as f64 * self.contact_angle.cos() / STRIBECK)
    }

    /// Fatigue load limit C_u by the simplified method of ISO 281, annex B, N; `static_rating` is C_0r, N.
    ///
    /// # Errors
    /// [`RatingError::Load`] for a rating that is negative or not finite.
    pub fn fatigue_load_limit(&self, static_rating: f64) -> Result<f64, RatingError> {
        let limit = load("static load rating", static_rating)? / 22.0;
        Ok(limit * (LARGE_PITCH / self.pitch_diameter).min(1.0).sqrt())
    }

    /// Static equivalent load P_0 of a radial and an axial load, N.
    ///
    /// # Errors
    /// [`RatingError`] for loads below 0 and for dimensions that are not those of a radial ball bearing.
    pub fn static_equivalent_load(&self, radial: f64, axial: f64) -> Result<f64, RatingError> {
        self.check()?;
        let (radial, axial) = (load("radial load", radial)?, load("axial load", axial)?);
        let angle = self.contact_angle.to_degrees();
        let factor = |column: usize| between(&STATIC_FACTORS, angle, |row| row.0, |row| [row.1, row.2][column]);
        Ok((factor(0) * radial + factor(1) * axial).max(radial))
    }

    /// Load of a ball that brings the weaker of the two races to [`PERMISSIBLE_PRESSURE`], N; the grooves at least as
    /// wide as those of the standard.
    fn permissible_ball_load(&self) -> Result<f64, RatingError> {
        self.check()?;
        let gamma = self.gamma();
        let grooves = [self.inner_coefficient, self.outer_coefficient];
        let mut least = f64::INFINITY;
        for (k, sign) in [(0, -1.0), (1, 1.0)] {
            let groove = grooves[k].max(USUAL_GROOVES[k]);
            least = least.min(self.load_at_pressure(1.0 + sign * gamma, groove)?);
        }
        Ok(least)
    }

    fn load_at_pressure(&self, track: f64, groove: f64) -> Result<f64, ContactError> {
        let rolling = 2.0 / (self.ball_diameter * track);
        let lateral = (2.0 - 1.0 / groove) / self.ball_diameter;
        let contact = HertzContact::new(rolling, lateral, effective_modulus(&STEEL, &STEEL))?;
        Ok(contact.load_from_peak_pressure(PERMISSIBLE_PRESSURE))
    }
}

/// ISO 76, table 2, single row: contact angle in degrees, X_0, Y_0. The row of 0° is that of deep-groove bearings.
const STATIC_FACTORS: [(f64, f64, f64); 10] = [
    (0.0, 0.6, 0.50),
    (5.0, 0.5, 0.52),
    (10.0, 0.5, 0.50),
    (15.0, 0.5, 0.46),
    (20.0, 0.5, 0.42),
    (25.0, 0.5, 0.38),
    (30.0, 0.5, 0.33),
    (35.0, 0.5, 0.29),
    (40.0, 0.5, 0.26),
    (45.0, 0.5, 0.22),
];
