//! The basic dynamic load rating C_r of ISO 281, with the factor f_c from the formula behind its table.

use crate::{CONTACT_ANGLE_MAX_DEG, RatingError, positive};

/// Groove radii over ball diameter, inner and outer, up to which ISO 281 and ISO 76 count a bearing as usual.
pub(crate) const USUAL_GROOVES: [f64; 2] = [0.52, 0.53];
/// Rating factor b_m of ISO 281 for today's steel in deep-groove and angular-contact bearings.
const RATING_FACTOR: f64 = 1.3;
/// 0.41 · 98.0665 · 0.95: Lundberg and Palmgren's constants, N/mm^1.8, and the reduction for single-row bearings
/// (ISO/TR 1281-1).
const MATERIAL: f64 = 0.41 * 98.0665 * 0.95;
/// Ball diameter beyond which C_r grows with D^1.4, mm.
const LARGE_BALL_MM: f64 = 25.4;
/// Millimetres in a metre.
pub(crate) const MM_PER_M: f64 = 1e3;

/// The numbers of a single-row radial ball bearing that the standards' formulas need, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatedBearing {
    /// Number of balls Z.
    pub ball_count: usize,
    /// Ball diameter D, m.
    pub ball_diameter: f64,
    /// Pitch diameter d_m, m.
    pub pitch_diameter: f64,
    /// Nominal contact angle α, rad: 0 for a deep-groove bearing, whatever its clearance.
    pub contact_angle: f64,
    /// Inner groove radius over ball diameter, f_i.
    pub inner_coefficient: f64,
    /// Outer groove radius over ball diameter, f_o.
    pub outer_coefficient: f64,
}

impl RatedBearing {
    /// γ = D cos α/d_m.
    pub fn gamma(&self) -> f64 {
        self.ball_diameter * self.contact_angle.cos() / self.pitch_diameter
    }

    /// The factor f_c of ISO 281, N/mm^1.8.
    ///
    /// Grooves closer than those of the standard's class earn nothing; wider ones lower it by the formula.
    ///
    /// # Errors
    /// [`RatingError`] for dimensions that are not those of a radial ball bearing.
    pub fn dynamic_factor(&self) -> Result<f64, RatingError> {
        self.check()?;
        let gamma = self.gamma();
        let [inner, outer] = USUAL_GROOVES;
        let wide = shape(gamma, self.inner_coefficient.max(inner), self.outer_coefficient.max(outer));
        // The table of the standard is the formula with both grooves at 0.52.
        Ok(MATERIAL * shape(gamma, inner, inner) * wide / shape(gamma, inner, outer))
    }

    /// Basic dynamic load rating C_r, N.
    ///
    /// # Errors
    /// As [`Self::dynamic_factor`].
    pub fn dynamic_rating(&self) -> Result<f64, RatingError> {
        let factor = self.dynamic_factor()?;
        let diameter = self.ball_diameter * MM_PER_M;
        let size = if diameter <= LARGE_BALL_MM { diameter.powf(1.8) } else { 3.647 * diameter.powf(1.4) };
        let balls = (self.ball_count as f64).powf(2.0 / 3.0);
        Ok(RATING_FACTOR * factor * self.contact_angle.cos().powf(0.7) * balls * size)
    }

    pub(crate) fn check(&self) -> Result<(), RatingError> {
        positive("number of balls", self.ball_count as f64, "")?;
        positive("ball diameter", self.ball_diameter, "m")?;
        positive("pitch diameter", self.pitch_diameter, "m")?;
        let angle_deg = self.contact_angle.to_degrees();
        // Half a millionth of a degree for angles that were given in degrees.
        if !(0.0..=CONTACT_ANGLE_MAX_DEG + 5e-7).contains(&angle_deg) {
            return Err(RatingError::ContactAngle { angle_deg });
        }
        let gamma = self.gamma();
        if gamma >= 1.0 {
            return Err(RatingError::Ratio { gamma });
        }
        for (race, coefficient) in [("inner", self.inner_coefficient), ("outer", self.outer_coefficient)] {
            if !(coefficient.is_finite() && coefficient > 0.5) {
                return Err(RatingError::Groove { race, coefficient });
            }
        }
        Ok(())
    }
}

/// Capacity of the outer race's contacts over that of the inner's, to the power that the lives add up with: t.
pub(crate) fn race_ratio(constant: f64, gamma: f64, inner: f64, outer: f64) -> f64 {
    let grooves = inner / outer * (2.0 * outer - 1.0) / (2.0 * inner - 1.0);
    constant * ((1.0 - gamma) / (1.0 + gamma)).powf(1.72) * grooves.powf(0.41)
}

/// f_c without its material constant: ISO/TR 1281-1, from Lundberg and Palmgren's point contact.
fn shape(gamma: f64, inner: f64, outer: f64) -> f64 {
    let ratio = race_ratio(1.04, gamma, inner, outer);
    let both = (1.0 + ratio.powf(10.0 / 3.0)).powf(-0.3);
    let curvature = gamma.powf(0.3) * (1.0 - gamma).powf(1.39) / (1.0 + gamma).cbrt();
    both * curvature * (2.0 * inner / (2.0 * inner - 1.0)).powf(0.41)
}
