//! The stress at one point of a film.

use crate::Scalar;
use num_dual::Dual64;
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
const LEAST_PRESSURE: f64 = 1.0;
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

/// The stress over the sliding speed at one point, and its slopes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct NodeSlopes {
    /// Stress over speed t, Pa s/m.
    pub value: f64,
    /// v dt/dv.
    pub bend: f64,
    /// p dt/dp.
    pub by_log_pressure: f64,
    /// dt/dT, per K.
    pub by_temperature: f64,
    /// dt/dh, per m.
    pub by_gap: f64,
    /// dt/d ln V, through the flexibility of the bodies.
    pub by_log_creep: f64,
    /// dt/df.
    pub by_share: f64,
}

/// A film at one temperature with the slopes of its oil by temperature.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sloped {
    pub at: Shearing,
    /// d ln η0/dT, 1/K.
    log_ambient_slope: f64,
    /// d stiffness/dT, 1/K.
    stiffness_slope: f64,
    /// d ln Λ/dT, 1/K.
    limiting_slope: f64,
}

impl Sloped {
    pub fn new(at: Shearing, oil: &Oil, temperature: f64) -> Self {
        let (shear, friction) = (at.stress.shear, at.stress.boundary_friction);
        let dual = FilmStress::new(oil, (shear, friction), Dual64::from(temperature).derivative());
        Self {
            at,
            log_ambient_slope: dual.log_ambient.eps,
            stiffness_slope: dual.stiffness.eps,
            limiting_slope: dual.limiting.eps / dual.limiting.re,
        }
    }

    /// Stress over speed and its slopes at a pressure in Pa, with ln(η/η0) by pressure alone (see
    /// [`PressureViscosity::relative_log`]), and a sliding speed in m/s.
    #[inline]
    pub fn slopes(&self, pressure: f64, relative_log: f64, speed: f64) -> NodeSlopes {
        let Shearing { stress, gap, creep, share } = &self.at;
        let pressure = pressure.max(LEAST_PRESSURE);
        let compliance = gap * (-(relative_log * stress.stiffness) - stress.log_ambient).exp();
        let newton = 1.0 / (compliance + creep);
        let limit = stress.limiting * pressure;
        // t, dt/d ln m, dt/d ln v and dt/d ln τ_L of the film.
        let (film, by_newton, by_speed, by_limit) = match stress.shear {
            FilmShear::LimitingShear => {
                let (phi, x_slope) = saturation_slope(newton * speed / limit);
                (newton * phi, newton * (phi + x_slope), newton * x_slope, -newton * x_slope)
            }
            FilmShear::Eyring { stress: reference } => {
                let (psi, x_slope) = eyring_slope(newton * speed / reference);
                let free = newton * psi;
                if free * speed > limit {
                    let capped = limit / speed;
                    (capped, 0.0, -capped, capped)
                } else {
                    (free, newton * (psi + x_slope), newton * x_slope, 0.0)
                }
            }
        };
        let stick = 1.0 / creep;
        let (phi, x_slope) = saturation_slope(stick * speed / (pressure * stress.boundary_friction));
        let (dry, dry_bend) = (stick * phi, stick * x_slope);
        // d ln m = −m (dA); A = h/η + creep.
        let [log_gap, log_creep] = [-newton * compliance, -newton * creep];
        let log_viscosity = by_newton * -log_gap;
        let pressed = stress.stiffness * pressure * stress.pressure.relative_log_slope(pressure);
        let warmed = self.log_ambient_slope + self.stiffness_slope * relative_log;
        let blend = |film: f64, dry: f64| film + (dry - film) * share;
        NodeSlopes {
            value: blend(film, dry),
            bend: blend(by_speed, dry_bend),
            by_log_pressure: blend(log_viscosity * pressed + by_limit, -dry_bend),
            by_temperature: blend(log_viscosity * warmed + by_limit * self.limiting_slope, 0.0),
            by_gap: blend(by_newton * log_gap / gap, 0.0),
            by_log_creep: blend(by_newton * log_creep, -(dry + dry_bend)),
            by_share: dry - film,
        }
    }

    /// ln(η/η0) by pressure alone.
    pub fn relative_log(&self, pressure: f64) -> f64 {
        self.at.stress.pressure.relative_log(pressure.max(LEAST_PRESSURE))
    }

    /// Stress over speed and its slope by temperature.
    #[inline]
    pub fn by_temperature(&self, pressure: f64, relative_log: f64, speed: f64) -> [f64; 2] {
        let NodeSlopes { value, by_temperature, .. } = self.slopes(pressure, relative_log, speed);
        [value, by_temperature]
    }
}

/// φ(x) = (1 − e^(−x))/x and x φ'(x).
fn saturation_slope(x: f64) -> (f64, f64) {
    if x < SMALL {
        return ((x / 3.0 - 1.0) * x * 0.5 + 1.0, (x * (2.0 / 3.0) - 1.0) * x * 0.5);
    }
    let decay = (-x).exp_m1();
    let phi = -decay / x;
    (phi, decay + 1.0 - phi)
}

/// ψ(x) = asinh(x)/x and x ψ'(x).
fn eyring_slope(x: f64) -> (f64, f64) {
    if x < SMALL {
        return (1.0 - x * x / 6.0, -x * x / 3.0);
    }
    let root = (x * x + 1.0).sqrt();
    let psi = (x + root).ln() / x;
    (psi, 1.0 / root - psi)
}
