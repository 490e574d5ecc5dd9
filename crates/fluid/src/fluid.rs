//! The liquids, their states and their saturation line.

use crate::helmholtz::Helmholtz;
use crate::{
    FluidError, Scalar, lemmon_jacobsen2004, quinones_cisneros2006, schmidt_wagner1985, setzmann_wagner1991, span2000,
};
use num_dual::{Dual64, first_derivative};
use std::fmt;

/// Highest pressure that [`Fluid::state`] answers for, Pa: the range of the comparison with another program.
pub const MAX_PRESSURE: f64 = 30e6;

/// Newton steps on the density after which the search is given up. It converges monotonically from the dense or the
/// dilute end; from the dense end to saturation it takes at most 11 in the permitted range.
const MAX_STEPS: usize = 60;

/// Relative change of density or pressure that ends a search. Newton steps are quadratic, so what is left is rounding.
const SETTLED: f64 = 1e-13;

/// Relative excess over a limit of pressure that is let pass, so that rounding does not decide on the limit itself.
const ROUNDING: f64 = 1e-9;

/// A cryogenic liquid with a reference equation of state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fluid {
    /// Nitrogen, 63.151–119.8 K: Span et al. 2000, viscosity by Lemmon and Jacobsen 2004.
    Nitrogen,
    /// Oxygen, 54.361–146.8 K: Schmidt and Wagner 1985, viscosity by Lemmon and Jacobsen 2004.
    Oxygen,
    /// Methane, 90.6941–181 K: Setzmann and Wagner 1991, viscosity by Quiñones-Cisneros and Deiters 2006.
    Methane,
}

/// A liquid at a temperature and a pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FluidState {
    /// Density, kg/m³.
    pub density: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
    /// Temperature, K.
    pub temperature: f64,
    /// Pressure, Pa.
    pub pressure: f64,
}

/// Liquid and vapour in equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Saturation {
    /// Temperature, K.
    pub temperature: f64,
    /// Pressure of both, Pa.
    pub pressure: f64,
    /// Density of the boiling liquid, kg/m³.
    pub liquid_density: f64,
    /// Density of the vapour, kg/m³.
    pub vapour_density: f64,
}

impl fmt::Display for Fluid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Fluid::Nitrogen => "nitrogen",
            Fluid::Oxygen => "oxygen",
            Fluid::Methane => "methane",
        })
    }
}

impl Fluid {
    /// All fluids.
    pub const ALL: [Fluid; 3] = [Fluid::Nitrogen, Fluid::Oxygen, Fluid::Methane];

    fn equation(self) -> &'static Helmholtz {
        match self {
            Fluid::Nitrogen => &span2000::EQUATION,
            Fluid::Oxygen => &schmidt_wagner1985::EQUATION,
            Fluid::Methane => &setzmann_wagner1991::EQUATION,
        }
    }

    /// Critical temperature, K.
    pub fn critical_temperature(self) -> f64 {
        self.equation().critical_temperature
    }

    /// Critical pressure as published beside the equation of state, Pa.
    pub fn critical_pressure(self) -> f64 {
        self.equation().critical_pressure
    }

    /// Critical density, kg/m³.
    pub fn critical_density(self) -> f64 {
        self.equation().critical_density
    }

    /// Specific gas constant, J/(kg K).
    pub fn gas_constant(self) -> f64 {
        self.equation().gas_constant()
    }

    /// Enthalpy over R T less that of the ideal gas, at T in K and ρ in kg/m³.
    pub(crate) fn departure(self, temperature: f64, density: f64) -> f64 {
        self.equation().enthalpy_departure(temperature, density)
    }

    /// Temperature of the triple point, K.
    pub fn triple_temperature(self) -> f64 {
        match self {
            Fluid::Nitrogen => span2000::TRIPLE_TEMPERATURE,
            Fluid::Oxygen => schmidt_wagner1985::TRIPLE_TEMPERATURE,
            Fluid::Methane => setzmann_wagner1991::TRIPLE_TEMPERATURE,
        }
    }

    /// Highest temperature that [`Fluid::state`] answers for, K: 0.95 T_c. Nearer to the critical point density and
    /// viscosity vary so steeply with pressure that one state for a whole bearing says nothing.
    pub fn max_temperature(self) -> f64 {
        0.95 * self.critical_temperature()
    }

    /// Pressure, Pa, at T in K and ρ in kg/m³, by the equation of state in any single-phase state; generic, so that
    /// dual numbers give compressibility and thermal pressure.
    pub fn pressure<D: Scalar>(self, temperature: D, density: D) -> D {
        self.equation().pressure(temperature, density)
    }

    /// Dynamic viscosity, Pa s, at T in K and ρ in kg/m³.
    pub fn viscosity(self, temperature: f64, density: f64) -> f64 {
        use lemmon_jacobsen2004::{NITROGEN, OXYGEN, viscosity};
        let equation = self.equation();
        match self {
            Fluid::Nitrogen => viscosity(&NITROGEN, equation, temperature, density),
            Fluid::Oxygen => viscosity(&OXYGEN, equation, temperature, density),
            Fluid::Methane => quinones_cisneros2006::viscosity(equation, temperature, density),
        }
    }

    /// Pressure at which the liquid freezes, Pa, at T in K, from the triple point up.
    pub fn melting_pressure(self, temperature: f64) -> f64 {
        match self {
            Fluid::Nitrogen => span2000::melting_pressure(temperature),
            Fluid::Oxygen => schmidt_wagner1985::melting_pressure(temperature),
            Fluid::Methane => setzmann_wagner1991::melting_pressure(temperature),
        }
    }

    /// The liquid at a temperature in K and a pressure in Pa. Refuses states where there is no liquid, and pressures
    /// above [`MAX_PRESSURE`].
    pub fn state(self, temperature: f64, pressure: f64) -> Result<FluidState, FluidError> {
        let saturation = self.saturation(temperature)?;
        if pressure.is_nan() || pressure > MAX_PRESSURE * (1.0 + ROUNDING) {
            return Err(FluidError::Pressure { fluid: self, pressure, max: MAX_PRESSURE });
        }
        if pressure < saturation.pressure * (1.0 - ROUNDING) {
            let saturation = saturation.pressure;
            return Err(FluidError::Vapour { fluid: self, temperature, pressure, saturation });
        }
        let melting = self.melting_pressure(temperature).max(saturation.pressure);
        if pressure > melting * (1.0 + ROUNDING) {
            return Err(FluidError::Solid { fluid: self, temperature, pressure, melting });
        }
        let density = self.density(temperature, pressure, self.dense())?;
        let viscosity = self.viscosity(temperature, density);
        Ok(FluidState { density, viscosity, temperature, pressure })
    }

    /// Liquid and vapour in equilibrium at a temperature in K: equal pressure and equal Gibbs energy by the equation
    /// of state (no auxiliary equation enters).
    pub fn saturation(self, temperature: f64) -> Result<Saturation, FluidError> {
        let (min, max) = (self.triple_temperature(), self.max_temperature());
        if !(min..=max).contains(&temperature) {
            let critical = self.critical_temperature();
            return Err(FluidError::Temperature { fluid: self, temperature, min, max, critical });
        }
        let equation = self.equation();
        let gas = equation.gas_constant() * temperature;
        let mut pressure = self.wilson_pressure(temperature);
        let mut liquid = self.dense();
        for _ in 0..MAX_STEPS {
            liquid = self.density(temperature, pressure, liquid)?;
            let vapour = self.density(temperature, pressure, pressure / gas)?;
            // Newton in ln p, in which the Gibbs energy of the vapour is nearly linear: d(g_l − g_v)/dp = v_l − v_v.
            let excess = equation.gibbs(temperature, liquid) - equation.gibbs(temperature, vapour);
            let slope = pressure * (liquid.recip() - vapour.recip()) / gas;
            let change = -excess / slope;
            pressure *= change.exp();
            if change.abs() < 1e3 * SETTLED {
                return Ok(Saturation { temperature, pressure, liquid_density: liquid, vapour_density: vapour });
            }
        }
        Err(FluidError::Density { fluid: self, temperature, pressure, iterations: MAX_STEPS })
    }

    /// Density from T and p by Newton's method on p(ρ), started beyond the root: from [`Fluid::dense`] for the liquid,
    /// where p(ρ) is convex, from the ideal gas for the vapour, where it is concave. Either way no step overshoots.
    fn density(self, temperature: f64, pressure: f64, start: f64) -> Result<f64, FluidError> {
        let mut density = start;
        let mut iterations = 0;
        while iterations < MAX_STEPS {
            iterations += 1;
            let (p, slope) = first_derivative(|rho| self.pressure(Dual64::from_re(temperature), rho), density);
            let change = (pressure - p) / slope;
            density += change;
            if slope <= 0.0 || !density.is_finite() {
                break;
            }
            if change.abs() < SETTLED * density {
                return Ok(density);
            }
        }
        Err(FluidError::Density { fluid: self, temperature, pressure, iterations })
    }

    /// A density above every liquid state that is permitted, kg/m³: the liquid at the triple point has 2.7 to 3.0 times
    /// the critical density, and 30 MPa adds less than 5 %.
    pub(crate) fn dense(self) -> f64 {
        3.2 * self.critical_density()
    }

    /// First guess of the saturation pressure, Pa: Wilson's rule, within 2.5 % above 0.6 T_c, which keeps it below the
    /// spinodal of the vapour up to 0.95 T_c; 38 % too high at the triple point of oxygen, where any guess would do.
    fn wilson_pressure(self, temperature: f64) -> f64 {
        let acentric = match self {
            Fluid::Nitrogen => span2000::ACENTRIC,
            Fluid::Oxygen => schmidt_wagner1985::ACENTRIC,
            Fluid::Methane => setzmann_wagner1991::ACENTRIC,
        };
        let exponent = 5.373 * (1.0 + acentric) * (1.0 - self.critical_temperature() / temperature);
        self.critical_pressure() * exponent.exp()
    }
}
