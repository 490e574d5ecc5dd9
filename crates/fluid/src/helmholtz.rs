//! The residual Helmholtz energy of a reference equation of state, and what follows from its derivatives.
//!
//! Every derivative is taken by dual numbers, so that one function per equation states the physics.

use crate::Scalar;
use num_dual::Dual;

/// n δ^d τ^t exp(−δ^l), without the exponential where l = 0.
pub(crate) struct Power {
    pub n: f64,
    pub d: i32,
    pub t: f64,
    pub l: i32,
}

/// n δ^d τ^t exp(−η(δ−1)² − β(τ−γ)²); the three equations used here all centre the bell at δ = 1.
pub(crate) struct Gaussian {
    pub n: f64,
    pub d: i32,
    pub t: f64,
    pub eta: f64,
    pub beta: f64,
    pub gamma: f64,
}

/// Row of a coefficient table.
pub(crate) const fn power(n: f64, d: i32, t: f64, l: i32) -> Power {
    Power { n, d, t, l }
}

/// One reference equation of state with its constants.
pub(crate) struct Helmholtz {
    /// Molar gas constant of the publication, J/(mol K).
    pub molar_gas_constant: f64,
    /// Molar mass, kg/mol.
    pub molar_mass: f64,
    /// Critical and reducing temperature, K.
    pub critical_temperature: f64,
    /// Critical and reducing density, kg/m³.
    pub critical_density: f64,
    /// Critical pressure, Pa.
    pub critical_pressure: f64,
    /// Power and exponential terms.
    pub powers: &'static [Power],
    /// Terms of the critical region.
    pub gaussians: &'static [Gaussian],
}

impl Helmholtz {
    /// Specific gas constant, J/(kg K).
    pub fn gas_constant(&self) -> f64 {
        self.molar_gas_constant / self.molar_mass
    }

    /// α(τ, δ), residual Helmholtz energy over R T.
    pub fn residual<D: Scalar>(&self, tau: D, delta: D) -> D {
        let mut sum = D::zero();
        for term in self.powers {
            let value = delta.powi(term.d) * tau.powf(term.t) * term.n;
            sum += match term.l {
                0 => value,
                l => value * (-delta.powi(l)).exp(),
            };
        }
        for term in self.gaussians {
            let away = (delta - 1.0).powi(2) * term.eta + (tau - term.gamma).powi(2) * term.beta;
            sum += delta.powi(term.d) * tau.powf(term.t) * (-away).exp() * term.n;
        }
        sum
    }

    /// α and ∂α/∂δ at (T, ρ).
    pub fn residual_and_slope<D: Scalar>(&self, temperature: D, density: D) -> (D, D) {
        let tau = temperature.recip() * self.critical_temperature;
        let delta = density / self.critical_density;
        let alpha = self.residual(Dual::new(tau, D::zero()), Dual::new(delta, D::one()));
        (alpha.re, alpha.eps)
    }

    /// Pressure, Pa, at T in K and ρ in kg/m³.
    pub fn pressure<D: Scalar>(&self, temperature: D, density: D) -> D {
        let (_, slope) = self.residual_and_slope(temperature, density);
        let compressibility = slope * density / self.critical_density + 1.0;
        density * temperature * compressibility * self.gas_constant()
    }

    /// τ ∂α/∂τ + δ ∂α/∂δ: enthalpy over R T less that of the ideal gas.
    pub fn enthalpy_departure(&self, temperature: f64, density: f64) -> f64 {
        let (tau, delta) = (self.critical_temperature / temperature, density / self.critical_density);
        let (one, zero) = (Dual::new(tau, 1.0), Dual::new(tau, 0.0));
        let by_tau = self.residual(one, Dual::new(delta, 0.0)).eps;
        let by_delta = self.residual(zero, Dual::new(delta, 1.0)).eps;
        tau * by_tau + delta * by_delta
    }

    /// Part of the Gibbs energy over R T that depends on the density (logarithm of ρ over ρ_c included).
    pub fn gibbs(&self, temperature: f64, density: f64) -> f64 {
        let (alpha, slope) = self.residual_and_slope(temperature, density);
        let delta = density / self.critical_density;
        alpha + delta * slope + delta.ln()
    }
}
