//! The numbers that a new case assumes, from the size of its bearing.

use super::NewCase;
use crate::{BallSet, CatalogueError};
use std::f64::consts::PI;

/// Speed of a moderate application, pitch diameter times speed, mm r/min: a third of what grease allows.
pub(super) const MODERATE_SPEED: f64 = 200_000.0;
/// Radial load over C_r: of an angular-contact and of a deep-groove bearing. An equivalent load of a tenth of C_r, a
/// usual one, is a life of a thousand million turns.
const RADIAL: [f64; 2] = [0.05, 0.1];
/// Axial load over C_r, likewise. Deep-groove bearings carry little of it, as a rule from a spring that keeps them
/// quiet.
const AXIAL: [f64; 2] = [0.1, 0.02];
/// Shoulder height over ball diameter, of an angular-contact and of a deep-groove bearing.
const SHOULDER: [f64; 2] = [0.3, 0.2];
/// Density of bearing steel, kg/m³.
pub(super) const STEEL: f64 = 7800.0;
/// Density of a cage of glass-filled polyamide, kg/m³.
const POLYAMIDE: f64 = 1300.0;
/// Rates of samples, kHz.
const RATES_KHZ: [f64; 5] = [12.8, 25.6, 51.2, 102.4, 204.8];
/// Outside diameter from which on the first of them does, m: of the outer ring's acceleration up to 10 kHz, 98 % and
/// more of the rms are below the 5 kHz that it passes, with round races, waves and spalls of 1 mm (6206, 6308, 6024,
/// 71908C, 7210B). A 6204 of 47 mm has 95 % over a spall, a 608 a third.
const LARGE: f64 = 0.05;

/// Assumed numbers of a case, SI.
pub(super) struct Numbers {
    pub radial_load: f64,
    pub axial_load: f64,
    pub speed_rpm: f64,
    pub shoulder: f64,
    pub pocket_gap: f64,
    pub cage_inertia: f64,
    pub inner_mass: f64,
    pub outer_mass: f64,
    /// Of the outer ring's support, N/m and N s/m.
    pub support: [f64; 2],
    /// Of the inner ring, N s/m.
    pub inner_damping: f64,
    pub duration: f64,
    pub state_rate_khz: f64,
    pub dynamic_rating: f64,
}

impl Numbers {
    pub fn new(case: &NewCase, balls: &BallSet) -> Result<Self, CatalogueError> {
        let BallSet { ball_count, ball_diameter, pitch_diameter: pitch, .. } = *balls;
        let envelope = &case.envelope;
        let class = usize::from(case.is_deep_groove());
        let dynamic_rating = match case.ratings {
            Some(ratings) => ratings.dynamic,
            None => envelope.rated(balls).dynamic_rating()?,
        };
        let axial_load = case.axial_load.unwrap_or(round(AXIAL[class] * dynamic_rating, 2));
        let radial_load = case.radial_load.unwrap_or(round(RADIAL[class] * dynamic_rating, 2));
        let speed_rpm = case.speed.map_or_else(|| round(MODERATE_SPEED / (pitch * 1e3), 1), |w| w * 30.0 / PI);
        // A shaft of the bore, four diameters long; the outer ring in a housing as wide and twice as large.
        let inner_mass = round(STEEL * PI * envelope.bore.powi(3), 2);
        let outer_mass = round(STEEL * 0.75 * PI * envelope.outside.powi(2) * envelope.width, 2);
        let stiffness = round(1e10 * ball_diameter, 1);
        let turn = 60.0 / speed_rpm.abs().max(60.0);
        let pass = 0.6 * ball_count as f64 / turn;
        let large = envelope.outside >= LARGE;
        let fast_enough = |rate: &f64| rate * 1e3 >= 20.0 * pass && (large || *rate > RATES_KHZ[0]);
        Ok(Self {
            radial_load,
            axial_load,
            speed_rpm,
            shoulder: SHOULDER[class] * ball_diameter,
            pocket_gap: round(0.01 * ball_diameter, 1),
            cage_inertia: round(cage_mass(pitch, ball_diameter, envelope.width) * (0.5 * pitch).powi(2), 2),
            inner_mass,
            outer_mass,
            support: [stiffness, round(0.1 * (stiffness * outer_mass).sqrt(), 1)],
            inner_damping: round(0.05 * (stiffness * inner_mass).sqrt(), 1),
            duration: (5.0 * turn * 100.0).ceil() / 100.0,
            state_rate_khz: RATES_KHZ.into_iter().find(fast_enough).unwrap_or(RATES_KHZ[4]),
            dynamic_rating,
        })
    }
}

/// A ring of half the solid section between the balls' centre line and the rings, 0.35 D high and 0.8 B wide.
fn cage_mass(pitch: f64, ball_diameter: f64, width: f64) -> f64 {
    POLYAMIDE * PI * pitch * 0.35 * ball_diameter * 0.8 * width * 0.5
}

/// A number to so many significant digits.
fn round(value: f64, digits: i32) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let unit = 10f64.powi(digits - 1 - value.abs().log10().floor() as i32);
    (value * unit).round() / unit
}
