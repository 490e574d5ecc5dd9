//! A traction law of one's own, as a program writes it: the shear of a film.

use super::{Conditions, CurveNumber, CustomCurve, CustomLaw, OverSlip};

/// Shear of a film that is as thick as speed and temperature make it, up to a limit: κ = κ_L [1 − exp(−η s/(h κ_L p))],
/// slip s in m/s.
#[derive(Debug, Clone, Copy)]
pub struct Film {
    /// K.
    pub temperature: f64,
}

/// The film of one contact.
#[derive(Debug, Clone, Copy)]
pub struct FilmCurve {
    /// η/(h κ_L p), s/m.
    rate: f64,
    /// Pa.
    pressure: f64,
    /// Entrainment speed, m/s.
    speed: f64,
}

/// κ_L.
const LIMIT: f64 = 0.06;
/// Exponent of the speed in the thickness.
const THICKENING: f64 = 0.67;

impl CustomLaw for Film {
    type Curve = FilmCurve;
    fn under(&self, &Conditions { pressure, entrainment_speed, .. }: &Conditions) -> FilmCurve {
        let (viscosity, speed) = (200.0 * (-0.03 * (self.temperature - 343.0)).exp(), entrainment_speed.max(1e-3));
        let thickness = 3e-8 * speed.powf(THICKENING);
        FilmCurve { rate: viscosity / (thickness * LIMIT * pressure), pressure, speed }
    }
}

impl CustomCurve for FilmCurve {
    #[inline(always)]
    fn over_slip<N: CurveNumber>(&self, slip: N) -> OverSlip<N> {
        let e = (slip * -self.rate).max(-700.0).exp_m1();
        let by_log_rate = (e + 1.0) * (LIMIT * self.rate);
        OverSlip {
            value: e / slip * -LIMIT,
            slope: by_log_rate,
            by_pressure: by_log_rate * (-1.0 / self.pressure),
            by_entrainment: Some(by_log_rate * (-THICKENING / self.speed)),
        }
    }
}
