//! The stress at one point of a film.

use crate::Scalar;
use tribodyn_lubricant::{Oil, PressureViscosity};

/// How a film is sheared beyond Newton's law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FilmShear {
    /// τ = τ_L [1 − exp(−ηγ̇/τ_L)]. Source: S. Bair and W. O. Winer, ASME J. Lubr. Technol. 101 (1979) 258.
    LimitingShear,
    /// τ = τ_E asinh(ηγ̇/τ_E), not above τ_L. Source: K. L. Johnson and J. L. Tevaarwerk, Proc. R. Soc. A 356 (1977)
    /// 215.
    Eyring {
        /// τ_E, Pa; 3 to 10 MPa.
        stress: f64,
    },
}

/// An oil at one temperature under shear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmStress<D = f64> {
    pub(super) shear: FilmShear,
    pub(super) pressure: PressureViscosity,
    /// ln η at ambient pressure, η in Pa s.
    pub(super) log_ambient: D,
    /// ln(η/η0) over what depends on pressure alone.
    pub(super) stiffness: D,
    /// Λ.
    pub(super) limiting: D,
    pub(super) boundary_friction: f64,
}

/// A film under shear in series with the flexibility of the bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shearing<D = f64> {
    pub stress: FilmStress<D>,
    /// Thickness, m.
    pub gap: D,
    /// Sliding speed that the bodies take up over the stress, m/(s Pa).
    pub creep: D,
    /// Share of the asperities.
    pub share: D,
}

/// Pressures below which 1 Pa is taken, where the limiting stress would be 0/0.
pub(super) const LEAST_PRESSURE: f64 = 1.0;
/// Arguments below which the functions are taken by their series.
const SMALL: f64 = 1e-3;

impl<D: Scalar> FilmStress<D> {
    /// An oil, its shear and the friction of asperities, at a temperature in K.
    pub fn new(oil: &Oil, (shear, boundary_friction): (FilmShear, f64), temperature: D) -> Self {
        let ambient = oil.dynamic(temperature);
        Self {
            shear,
            pressure: oil.pressure,
            log_ambient: ambient.ln(),
            stiffness: oil.pressure.stiffness(ambient),
            limiting: oil.limiting_shear_at(temperature),
            boundary_friction,
        }
    }

    /// Without derivatives.
    pub(super) fn re(&self) -> FilmStress {
        FilmStress {
            shear: self.shear,
            pressure: self.pressure,
            log_ambient: self.log_ambient.re(),
            stiffness: self.stiffness.re(),
            limiting: self.limiting.re(),
            boundary_friction: self.boundary_friction,
        }
    }

    /// Dynamic viscosity at a pressure in Pa, Pa s.
    pub fn viscosity(&self, pressure: D) -> D {
        (self.pressure.relative_log(pressure) * self.stiffness + self.log_ambient).exp()
    }

    /// Shear stress of the film at a pressure (Pa), over the sliding speed (m/s), given its Newtonian slope (Pa s/m).
    fn film(&self, newton: D, pressure: D, speed: D) -> D {
        let limit = self.limiting * pressure;
        match self.shear {
            FilmShear::LimitingShear => newton * saturation(newton * speed / limit),
            FilmShear::Eyring { stress } => {
                let free = newton * eyring(newton * speed / stress);
                if (free * speed).re() > limit.re() { limit / speed } else { free }
            }
        }
    }
}

impl<D: Scalar> Shearing<D> {
    /// Stress over sliding speed at a pressure in Pa and a sliding speed in m/s, Pa s/m.
    pub fn over_speed(&self, pressure: D, speed: D) -> D {
        let pressure = if pressure.re() > LEAST_PRESSURE { pressure } else { D::from(LEAST_PRESSURE) };
        let thinning =
            (-(self.stress.pressure.relative_log(pressure) * self.stress.stiffness) - self.stress.log_ambient).exp();
        let newton = (self.gap * thinning + self.creep).recip();
        let film = self.stress.film(newton, pressure, speed);
        let stick = self.creep.recip();
        let dry = stick * saturation(stick * speed / (pressure * self.stress.boundary_friction));
        film + (dry - film) * self.share
    }
}

/// (1 − e^(−x))/x.
fn saturation<D: Scalar>(x: D) -> D {
    if x.re() < SMALL { (x * (1.0 / 3.0) - 1.0) * x * 0.5 + 1.0 } else { -(-x).exp_m1() / x }
}

/// asinh(x)/x.
fn eyring<D: Scalar>(x: D) -> D {
    if x.re() < SMALL { x * x * (-1.0 / 6.0) + 1.0 } else { (x + (x * x + 1.0).sqrt()).ln() / x }
}
