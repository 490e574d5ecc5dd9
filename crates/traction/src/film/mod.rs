//! Traction through a lubricant film.
//!
//! At each point of the patch the film is sheared at γ̇ = |Δv|/h_c, in series with the tangential flexibility of the
//! bodies, at the point's own pressure and at one temperature for the patch:
//! ```text
//! m   = 1/(h/η + V/g),   g = C11 G/π                         stress over sliding speed at rest, Pa s/m
//! τ   = τ_L [1 − exp(−m|Δv|/τ_L)]                            limiting shear (Bair and Winer 1979), τ_L = Λ p
//! τ   = min(τ_E asinh(m|Δv|/τ_E), τ_L)                       Eyring (Johnson and Tevaarwerk 1977)
//! τ   = (1 − f) τ_film + f μ_b p [1 − exp(−g|Δv|/(V μ_b p))]  asperities carry the share f(λ)
//! T   = T_0 + q [h/(8 k_oil) + ⅔ sqrt(2b/(π k ρ c V))],  q = ∬τ|Δv|/(πab)          fixed point
//! ```
//! h is the central thickness, not less than the roughness: sqrt(h_c² + R_q²). The inlet and the hysteresis of the
//! bodies resist rolling besides.

mod asperities;
mod lanes;
mod node;
mod rolling;
mod temperature;

pub use asperities::asperity_share;
pub use node::{FilmShear, FilmStress};
pub use temperature::FilmTemperature;

use crate::{MovingPatch, Patch, PatchTraction, Quadrature, RelativeMotion, Scalar, SlipField, TangentialElasticity};
use node::Shearing;

use std::f64::consts::PI;
use tribodyn_contact::ElasticBody;
use tribodyn_lubricant::{FilmThickness, InletFilm, Oil, RollingContact};

/// Thermal conductivity times density times specific heat of bearing steel, J²/(m⁴ K² s): 46 W/(m K), 7810 kg/m³ and
/// 475 J/(kg K), 100Cr6.
const STEEL: f64 = 46.0 * 7810.0 * 475.0;
/// Thermal diffusivity of bearing steel, m²/s.
const STEEL_DIFFUSIVITY: f64 = 46.0 / (7810.0 * 475.0);
/// Share of its elastic work that bearing steel loses when it is rolled over: some tenths of a percent to 1 %.
///
/// Source: K. L. Johnson, Contact Mechanics, Cambridge 1985, section 9.4; the middle of what is usual, spread 50 %.
pub const STEEL_HYSTERESIS: f64 = 0.007;
/// Rolling speed below which it is taken at this one, m/s.
const LEAST_ROLLING: f64 = 1e-6;

/// The lubricant between a ball and a race: how thick its film is and how it is sheared.
#[derive(Debug, Clone)]
pub struct FilmLaw {
    /// The oil.
    pub oil: Oil,
    /// Temperature of oil and surfaces outside the contact, K.
    pub temperature: f64,
    /// The oil at the inlet, starvation and roughness.
    pub inlet: InletFilm,
    /// How the film is sheared.
    pub shear: FilmShear,
    /// Friction of asperities that touch, μ_b.
    pub boundary_friction: f64,
    /// Share of the elastic work that the bodies lose when they are rolled over, α.
    pub hysteresis: f64,
    /// Radius of relative curvature along rolling R_x, m.
    pub rolling_radius: f64,
    /// Radius of relative curvature across rolling R_y, m.
    pub lateral_radius: f64,
    /// Effective modulus E', Pa.
    pub effective_modulus: f64,
    /// Tangential elasticity of ball and ring.
    pub elasticity: TangentialElasticity,
}

/// The film of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmState<D = f64> {
    /// Thickness.
    pub thickness: FilmThickness<D>,
    /// Film parameter λ.
    pub lambda_ratio: D,
    /// Share of the load that asperities carry.
    pub asperity_share: D,
}

impl<D: Scalar> MovingPatch<D> {
    /// Load under the ellipse, N.
    pub fn load(&self) -> D {
        self.patch.peak_pressure * self.patch.semi_lateral * self.patch.semi_rolling * (2.0 / 3.0 * PI)
    }

    /// Magnitude of the rolling speed, m/s.
    fn speed(&self) -> D {
        let speed = self.rolling_speed.abs();
        if speed.re() > LEAST_ROLLING { speed } else { D::from(LEAST_ROLLING) }
    }

    /// Sliding over rolling speed in the middle of the patch.
    fn slide_to_roll(&self) -> D {
        let [along, across] = self.motion.centre_slip(self.patch.ball_radius);
        let squared = along * along + across * across;
        if squared.re() > 1e-60 { squared.sqrt() / self.speed() } else { D::zero() }
    }

    /// Without derivatives.
    pub fn re(&self) -> MovingPatch {
        MovingPatch { patch: self.patch.re(), motion: self.motion.re(), rolling_speed: self.rolling_speed.re() }
    }
}

impl MovingPatch {
    /// d ln |V|/dV, s/m; 0 where the speed is taken as the least.
    fn log_speed_slope(&self) -> f64 {
        if self.rolling_speed.abs() > LEAST_ROLLING { self.rolling_speed.recip() } else { 0.0 }
    }
}

impl FilmLaw {
    /// A film between two bodies of steel, with radii of relative curvature along and across rolling, m.
    ///
    /// # Errors
    /// Those of [`TangentialElasticity::of_bodies`].
    pub fn new(
        (oil, temperature, inlet): (Oil, f64, InletFilm),
        (shear, boundary_friction): (FilmShear, f64),
        [rolling_radius, lateral_radius]: [f64; 2],
        bodies: [ElasticBody; 2],
    ) -> Result<Self, crate::TractionError> {
        let effective_modulus = tribodyn_contact::effective_modulus(&bodies[0], &bodies[1]);
        let elasticity = TangentialElasticity::of_bodies(bodies)?;
        Ok(Self {
            oil,
            temperature,
            inlet,
            shear,
            boundary_friction,
            hysteresis: STEEL_HYSTERESIS,
            rolling_radius,
            lateral_radius,
            effective_modulus,
            elasticity,
        })
    }

    /// The contact for the film formulas.
    fn rolling_contact<D: Scalar>(&self, contact: &MovingPatch<D>) -> RollingContact<D> {
        RollingContact {
            load: contact.load(),
            entrainment: contact.rolling_speed,
            slide_to_roll: contact.slide_to_roll(),
            rolling_radius: D::from(self.rolling_radius),
            lateral_radius: self.lateral_radius,
            ellipticity: contact.patch.semi_lateral / contact.patch.semi_rolling,
            peak_pressure: contact.patch.peak_pressure,
            effective_modulus: self.effective_modulus,
        }
    }

    /// The film of a contact.
    pub fn state<D: Scalar>(&self, contact: &MovingPatch<D>) -> FilmState<D> {
        let thickness = self.inlet.thickness(&self.rolling_contact(contact));
        let lambda_ratio = self.inlet.lambda_ratio(&thickness);
        FilmState { thickness, lambda_ratio, asperity_share: asperity_share(lambda_ratio) }
    }

    /// The film of a patch that rolls at a speed (m/s) with a slide-to-roll ratio, and how much warmer it is than its
    /// surroundings (K), from the frictional power of the contact with that of its inlet (W).
    pub fn under_power(&self, patch: &Patch, speed: f64, slide_to_roll: f64, power: f64) -> (FilmState, f64) {
        let contact = sliding_contact(patch, speed, slide_to_roll);
        let sheared = power - self.rolling_powers(patch, speed, slide_to_roll).iter().sum::<f64>();
        let state = self.state(&contact);
        (state, self.heating(&contact, self.gap(state.thickness.central)) * sheared)
    }

    /// Powers of the inlet's resistance to rolling on both surfaces and of the bodies' hysteresis, W.
    pub fn rolling_powers(&self, patch: &Patch, speed: f64, slide_to_roll: f64) -> [f64; 2] {
        let contact = sliding_contact(patch, speed, slide_to_roll);
        let turning = speed.abs() / self.rolling_radius;
        [2.0 * self.rolling_resistance(&contact) * speed, self.hysteresis_moment(&contact) * turning]
    }

    /// Central thickness, not less than the roughness, m.
    fn gap<D: Scalar>(&self, central: D) -> D {
        (central * central + self.inlet.roughness * self.inlet.roughness).sqrt()
    }

    /// The film of a contact at a temperature in K, ready to be sheared at every point.
    fn shearing<D: Scalar>(&self, contact: &MovingPatch<D>, temperature: D) -> Shearing<D> {
        let FilmState { thickness, asperity_share, .. } = self.state(contact);
        self.sheared(contact, (self.gap(thickness.central), asperity_share), temperature)
    }

    /// [`Self::shearing`] with the thickness (m) and the share of asperities that the film has.
    fn sheared<D: Scalar>(&self, contact: &MovingPatch<D>, (gap, share): (D, D), temperature: D) -> Shearing<D> {
        let coefficients = self.elasticity.coefficients();
        let ratio = contact.patch.semi_rolling.re() / contact.patch.semi_lateral.re();
        let stick = coefficients.at(ratio).longitudinal * self.elasticity.shear_modulus() / PI;
        let stress = FilmStress::new(&self.oil, (self.shear, self.boundary_friction), temperature);
        Shearing { stress, gap, creep: contact.speed() / stick, share }
    }

    /// [`Self::traction`] in double precision.
    pub fn value(&self, contact: &MovingPatch, quadrature: &Quadrature) -> PatchTraction {
        if contact.patch.peak_pressure <= 0.0 {
            return PatchTraction::zero();
        }
        let settled = self.settled(contact, quadrature);
        self.with_rolling(contact, integrate(&self.shearing(contact, settled.temperature), contact, quadrature))
    }

    /// Traction of a patch with rolling resistance, for any scalar; [`Self::derivative`] is its counterpart in closed
    /// form.
    pub fn traction<D: Scalar>(&self, contact: &MovingPatch<D>, quadrature: &Quadrature) -> PatchTraction<D> {
        if contact.patch.peak_pressure.re() <= 0.0 {
            return PatchTraction::zero();
        }
        let settled = self.settled(&contact.re(), quadrature);
        let at_rest = D::from(settled.temperature);
        // One Newton step on numbers that carry derivatives: its value is that of the fixed point.
        let shearing = self.shearing(contact, at_rest);
        let power = integrate(&shearing, contact, quadrature).power;
        let off = power * self.heating(contact, shearing.gap) + self.temperature - settled.temperature;
        let temperature = (off - off.re()) * (1.0 / (1.0 - settled.slope)) + settled.temperature;
        let sheared = integrate(&self.shearing(contact, temperature), contact, quadrature);
        self.with_rolling(contact, sheared)
    }
}

/// A patch that rolls at a speed with a slide-to-roll ratio.
fn sliding_contact(patch: &Patch, speed: f64, slide_to_roll: f64) -> MovingPatch {
    let rolling = slide_to_roll * speed;
    let motion = RelativeMotion { rolling, lateral: 0.0, spin: 0.0, about_lateral: 0.0, about_rolling: 0.0 };
    MovingPatch { patch: *patch, motion, rolling_speed: speed }
}

/// Integrals of the stress over a patch.
fn integrate<D: Scalar>(shearing: &Shearing<D>, contact: &MovingPatch<D>, quadrature: &Quadrature) -> PatchTraction<D> {
    let (patch, motion) = (&contact.patch, &contact.motion);
    let (a, b, peak) = (patch.semi_lateral, patch.semi_rolling, patch.peak_pressure);
    let flatness = 0.5 / patch.surface_radius;
    let mut sum = PatchTraction::zero();
    quadrature.for_each(&SlipField::new(patch, motion), |unit_x, unit_y, weight| {
        let inside = D::one() - unit_x * unit_x - unit_y * unit_y;
        if inside.re() <= 0.0 {
            return;
        }
        let depth = inside.sqrt();
        let (x, y) = (b * unit_x, a * unit_y);
        let [u, v] = motion.slip_at(x, y, patch);
        let squared = u * u + v * v;
        let speed = if squared.re() > 1e-60 { squared.sqrt() } else { D::zero() };
        // The weight of the rule is for pressures: it holds the root.
        let share = shearing.over_speed(peak * depth, speed) * (weight / depth);
        let (fx, fy) = (-(share * u), -(share * v));
        let arm = D::from(patch.ball_radius) - y * y * flatness;
        sum.force_rolling += fx;
        sum.force_lateral += fy;
        sum.moment_lateral += arm * fx;
        sum.moment_normal += x * fy - y * fx;
        sum.moment_rolling -= arm * fy;
        sum.power += share * speed * speed;
        sum.wear_integral += peak * weight * speed;
    });
    sum.times(a * b)
}

#[cfg(test)]
mod tests;
