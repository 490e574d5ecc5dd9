//! Viscosity of methane by friction theory: Quiñones-Cisneros, Deiters, J. Phys. Chem. B 110 (2006) 12820,
//! doi:10.1021/jp0618577, over the equation of state of Setzmann and Wagner.
//!
//! ```text
//! μ = μ_0 + κ_i p_id + κ_r Δp_r + κ_a p_a + κ_ii p_id² + κ_rr Δp_r² + κ_aa p_a²
//! p_id = ρ R T,   Δp_r = T (∂p/∂T)_ρ − p_id,   p_a = p − T (∂p/∂T)_ρ
//! κ_j = (c_0 + c_1 ψ) Γ,   κ_jj = (C_0 + C_1 ψ) Γ³,   Γ = T_c/T,   ψ = exp(Γ) − 1
//! μ_0 = a_0 + a_1 T_r^¼ + a_2 T_r^½,   T_r = T/T_c
//! ```
//! The paper's third coefficients, on exp(Γ²) − 1, are all zero for methane and left out.

use crate::helmholtz::Helmholtz;
use num_dual::Dual64;

// Quiñones-Cisneros, Deiters 2006, methane: dilute gas, µPa s.
const DILUTE: [f64; 3] = [2.60536, -18.5247, 23.4216];
// Quiñones-Cisneros, Deiters 2006, methane: linear friction coefficients, mPa s/bar.
const IDEAL: [f64; 2] = [3.49668e-5, -1.73176e-5];
const REPULSIVE: [f64; 2] = [5.98858e-5, -4.91143e-5];
const ATTRACTIVE: [f64; 2] = [-3.12118e-5, 1.99422e-7];
// Quiñones-Cisneros, Deiters 2006, methane: quadratic friction coefficients, mPa s/bar².
const IDEAL_SQUARE: [f64; 2] = [-3.55631e-7, 2.80326e-7];
const REPULSIVE_SQUARE: [f64; 2] = [1.60099e-8, 8.50221e-10];
const ATTRACTIVE_SQUARE: [f64; 2] = [-8.52992e-10, -3.58009e-10];

const PASCAL_PER_BAR: f64 = 1e5;

/// Viscosity, Pa s, at T in K and ρ in kg/m³.
pub(crate) fn viscosity(equation: &Helmholtz, temperature: f64, density: f64) -> f64 {
    let p = equation.pressure(Dual64::new(temperature, 1.0), Dual64::new(density, 0.0));
    let thermal = temperature * p.eps;
    let ideal = density * equation.gas_constant() * temperature / PASCAL_PER_BAR;
    let repulsive = thermal / PASCAL_PER_BAR - ideal;
    let attractive = (p.re - thermal) / PASCAL_PER_BAR;

    let gamma = equation.critical_temperature / temperature;
    let psi = gamma.exp_m1();
    let linear = |c: [f64; 2]| (c[0] + c[1] * psi) * gamma;
    let square = |c: [f64; 2]| (c[0] + c[1] * psi) * gamma.powi(3);
    let friction = linear(IDEAL) * ideal
        + linear(REPULSIVE) * repulsive
        + linear(ATTRACTIVE) * attractive
        + square(IDEAL_SQUARE) * ideal.powi(2)
        + square(REPULSIVE_SQUARE) * repulsive.powi(2)
        + square(ATTRACTIVE_SQUARE) * attractive.powi(2);

    let root = gamma.recip().sqrt();
    let dilute = DILUTE[0] + DILUTE[1] * root.sqrt() + DILUTE[2] * root;
    1e-6 * dilute + 1e-3 * friction
}
