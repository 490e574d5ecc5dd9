//! Viscosity of nitrogen and oxygen: Lemmon, Jacobsen, Int. J. Thermophys. 25 (2004) 21,
//! doi:10.1023/B:IJOT.0000022327.04529.f3.
//!
//! ```text
//! μ = μ_0(T) + Σ N τ^t δ^d exp(−γ δ^l),      μ_0 = 0.0266958 √(M T)/(σ² Ω(T/ε))  in µPa s, M in g/mol, σ in nm
//! Ω = exp(Σ b_i (ln T/ε)^i)
//! ```
//! The authors estimate 2 % for nitrogen and 5 % for oxygen, more near the critical point, where the equation has no
//! enhancement.

use crate::helmholtz::Helmholtz;

/// N τ^t δ^d, times exp(−δ^l) where l > 0; N in µPa s.
struct Residual {
    n: f64,
    t: f64,
    d: i32,
    l: i32,
}

const fn residual(n: f64, t: f64, d: i32, l: i32) -> Residual {
    Residual { n, t, d, l }
}

/// The coefficients of one fluid.
pub(crate) struct Coefficients {
    /// Lennard-Jones energy over the Boltzmann constant, K.
    energy: f64,
    /// Lennard-Jones size, nm.
    size: f64,
    residual: [Residual; 5],
}

// Lemmon, Jacobsen 2004, Lennard-Jones parameters and residual coefficients of nitrogen: N, t, d, l.
/// Nitrogen.
pub(crate) const NITROGEN: Coefficients = Coefficients {
    energy: 98.94,
    size: 0.3656,
    residual: [
        residual(10.72, 0.1, 2, 0),
        residual(0.03989, 0.25, 10, 1),
        residual(0.001208, 3.2, 12, 1),
        residual(-7.402, 0.9, 2, 2),
        residual(4.620, 0.3, 1, 3),
    ],
};

// Lemmon, Jacobsen 2004, Lennard-Jones parameters and residual coefficients of oxygen: N, t, d, l.
/// Oxygen.
pub(crate) const OXYGEN: Coefficients = Coefficients {
    energy: 118.5,
    size: 0.3428,
    residual: [
        residual(17.67, 0.05, 1, 0),
        residual(0.4042, 0.0, 5, 0),
        residual(0.0001077, 2.1, 12, 0),
        residual(0.3510, 0.0, 8, 1),
        residual(-13.67, 0.5, 1, 2),
    ],
};

// Lemmon, Jacobsen 2004, coefficients b_0 to b_4 of the collision integral, the same for both fluids.
const COLLISION: [f64; 5] = [0.431, -0.4623, 0.08406, 0.005341, -0.00331];

/// Viscosity, Pa s, at T in K and ρ in kg/m³.
pub(crate) fn viscosity(coefficients: &Coefficients, equation: &Helmholtz, temperature: f64, density: f64) -> f64 {
    let log = (temperature / coefficients.energy).ln();
    let collision = COLLISION.iter().rev().fold(0.0, |sum, b| sum * log + b);
    let molar_mass_gram = 1e3 * equation.molar_mass;
    let dilute = 0.0266958 * (molar_mass_gram * temperature).sqrt() / (coefficients.size.powi(2) * collision.exp());
    let tau = equation.critical_temperature / temperature;
    let delta = density / equation.critical_density;
    let dense: f64 = coefficients
        .residual
        .iter()
        .map(|term| {
            let value = term.n * tau.powf(term.t) * delta.powi(term.d);
            match term.l {
                0 => value,
                l => value * (-delta.powi(l)).exp(),
            }
        })
        .sum();
    1e-6 * (dilute + dense)
}
