//! Phase, density and enthalpy at a temperature and a pressure, beyond the liquid too, and what heat makes of a flow.
//!
//! Enthalpy is that of the reference equation: h = h_0(T) + R T (1 + τ ∂α/∂τ + δ ∂α/∂δ), with the heat capacity of the
//! ideal gas by translation, rotation and, for methane, its four vibrations (NIST Webbook, fundamental frequencies):
//! 7/2 R for nitrogen and oxygen, whose vibrations (3390 K, 2270 K) add less than 0.2 % below 250 K.

use crate::fluid::{Fluid, MAX_PRESSURE};
use crate::{FluidError, Saturation};
use num_dual::{Dual64, first_derivative};
use std::fmt;

/// Bisections of the density; 60 leave a relative 1e-15 of the range.
const HALVINGS: usize = 200;
/// Highest temperature of [`Fluid::density_at`], K. The equations hold far beyond; what floods a bearing does not.
pub const MAX_TEMPERATURE: f64 = 300.0;
/// Methane's vibrations: temperature, K, and how often each occurs (1306, 1534, 2917, 3019 1/cm).
const METHANE: [(f64, f64); 4] = [(1879.0, 3.0), (2207.0, 2.0), (4197.0, 1.0), (4344.0, 3.0)];

/// Phase of a fluid at a temperature and a pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Liquid below the critical pressure: it boils when it is heated enough.
    Liquid,
    /// Colder than the critical temperature and above the critical pressure: it never boils, and there are no bubbles.
    DenseLiquid,
    /// Gas below the critical pressure, or hotter than the critical temperature there.
    Gas,
    /// Above critical temperature and pressure: neither liquid nor gas, its density falls steadily with temperature.
    Supercritical,
}

impl fmt::Display for Phase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Phase::Liquid => "liquid",
            Phase::DenseLiquid => "liquid above the critical pressure",
            Phase::Gas => "gas",
            Phase::Supercritical => "supercritical",
        })
    }
}

/// A flow of fluid that has taken up heat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatedFlow {
    /// Temperature, K: that of boiling while it boils.
    pub temperature: f64,
    /// Density, kg/m³, of the mixture while it boils.
    pub density: f64,
    /// Part of the mass that is vapour; absent where there is one phase only.
    pub quality: Option<f64>,
    /// Its phase; absent while it boils.
    pub phase: Option<Phase>,
}

impl Fluid {
    /// Boiling temperature at a pressure in Pa, K; absent at and above the critical pressure, below the triple point,
    /// and within the last twentieth below the critical temperature, where [`Fluid::saturation`] does not answer.
    pub fn boiling(self, pressure: f64) -> Option<Saturation> {
        let (mut low, mut high) = (self.triple_temperature(), self.max_temperature());
        let at = |temperature| self.saturation(temperature).ok().map(|s| s.pressure);
        if !(at(low)?..=at(high)?).contains(&pressure) {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if at(middle)? < pressure { low = middle } else { high = middle }
        }
        self.saturation(high).ok()
    }

    /// The phase at a temperature in K and a pressure in Pa.
    ///
    /// # Errors
    /// [`FluidError`] out of range, and close to the critical point below its pressure.
    pub fn phase(self, temperature: f64, pressure: f64) -> Result<Phase, FluidError> {
        self.check_range(temperature, pressure)?;
        Ok(match (pressure >= self.critical_pressure(), temperature >= self.critical_temperature()) {
            (true, true) => Phase::Supercritical,
            (true, false) => Phase::DenseLiquid,
            (false, true) => Phase::Gas,
            (false, false) if pressure >= self.below_critical(temperature, pressure)?.pressure => Phase::Liquid,
            (false, false) => Phase::Gas,
        })
    }

    /// Density, kg/m³, of the one phase at a temperature in K and a pressure in Pa.
    ///
    /// # Errors
    /// As [`Self::phase`].
    pub fn density_at(self, temperature: f64, pressure: f64) -> Result<f64, FluidError> {
        let phase = self.phase(temperature, pressure)?;
        let gas = self.gas_constant() * temperature;
        // Where liquid and gas both have a root of p(ρ), saturation parts them.
        let (mut low, mut high) = match phase {
            Phase::Liquid | Phase::DenseLiquid if temperature <= self.max_temperature() => {
                (self.saturation(temperature)?.liquid_density * (1.0 - 1e-9), self.dense())
            }
            // Below the critical temperature and above the critical pressure it is denser than at the critical point.
            Phase::Liquid | Phase::DenseLiquid => (self.critical_density(), self.dense()),
            Phase::Gas if temperature < self.critical_temperature() => {
                (0.0, self.below_critical(temperature, pressure)?.vapour_density * (1.0 + 1e-9))
            }
            Phase::Gas | Phase::Supercritical => (0.0, self.dense()),
        };
        let mut density = (pressure / gas).clamp(low, high);
        for _ in 0..HALVINGS {
            let (p, slope) = first_derivative(|rho| self.pressure(Dual64::from_re(temperature), rho), density);
            if p < pressure {
                low = density
            } else {
                high = density
            }
            let newton = density + (pressure - p) / slope;
            let next = if slope > 0.0 && newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - density).abs() <= 1e-14 * density {
                return Ok(next);
            }
            density = next;
        }
        Ok(density)
    }

    /// Specific enthalpy, J/kg, at a temperature in K and a density in kg/m³, against the ideal gas at 0 K.
    pub fn enthalpy(self, temperature: f64, density: f64) -> f64 {
        let (r, t) = (self.gas_constant(), temperature);
        let ideal = match self {
            Fluid::Nitrogen | Fluid::Oxygen => 3.5 * t,
            Fluid::Methane => 4.0 * t + METHANE.iter().map(|(theta, n)| n * theta / (theta / t).exp_m1()).sum::<f64>(),
        };
        r * (ideal + t * self.departure(t, density))
    }

    /// A flow, kg/s, at a temperature in K and a pressure in Pa after it has taken up a power, W, at that pressure.
    ///
    /// # Errors
    /// [`FluidError`] for states out of range, heat that no state within [`MAX_TEMPERATURE`] holds among them.
    pub fn heated(self, (temperature, pressure): (f64, f64), power: f64, flow: f64) -> Result<HeatedFlow, FluidError> {
        let at = |t: f64| self.density_at(t, pressure).map(|rho| (self.enthalpy(t, rho), rho));
        let wanted = at(temperature)?.0 + power / flow;
        let mut low = temperature;
        if let Some(boiling) = self.boiling(pressure).filter(|b| b.temperature >= temperature) {
            let t = boiling.temperature;
            let (liquid, vapour) = (self.enthalpy(t, boiling.liquid_density), self.enthalpy(t, boiling.vapour_density));
            if wanted > liquid && wanted < vapour {
                let quality = (wanted - liquid) / (vapour - liquid);
                let volume = (1.0 - quality) / boiling.liquid_density + quality / boiling.vapour_density;
                return Ok(HeatedFlow { temperature: t, density: 1.0 / volume, quality: Some(quality), phase: None });
            }
            // Rounding may leave the gas a hair below saturation.
            low = if wanted >= vapour { t * (1.0 + 1e-9) } else { low };
        }
        let mut high = MAX_TEMPERATURE;
        if wanted > at(high)?.0 {
            return Err(self.too_hot(temperature));
        }
        if let Some(boiling) = self.boiling(pressure).filter(|b| low < b.temperature) {
            high = boiling.temperature * (1.0 - 1e-12);
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if at(middle)?.0 < wanted { low = middle } else { high = middle }
        }
        let (phase, (_, density)) = (self.phase(low, pressure)?, at(low)?);
        Ok(HeatedFlow { temperature: low, density, quality: None, phase: Some(phase) })
    }

    /// Saturation, at the highest temperature that [`Fluid::saturation`] answers for where it is hotter and its
    /// pressure is lower than that there: gas, and thinner than the vapour.
    fn below_critical(self, temperature: f64, pressure: f64) -> Result<Saturation, FluidError> {
        let highest = self.saturation(self.max_temperature())?;
        if temperature > highest.temperature && pressure < highest.pressure {
            return Ok(highest);
        }
        self.saturation(temperature)
    }

    fn too_hot(self, temperature: f64) -> FluidError {
        let (min, critical) = (self.triple_temperature(), self.critical_temperature());
        FluidError::Temperature { fluid: self, temperature, min, max: MAX_TEMPERATURE, critical }
    }

    fn check_range(self, temperature: f64, pressure: f64) -> Result<(), FluidError> {
        if !(self.triple_temperature()..=MAX_TEMPERATURE).contains(&temperature) {
            return Err(self.too_hot(temperature));
        }
        if !(pressure > 0.0 && pressure <= MAX_PRESSURE) {
            return Err(FluidError::Pressure { fluid: self, pressure, max: MAX_PRESSURE });
        }
        Ok(())
    }
}
