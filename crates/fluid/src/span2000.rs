//! Equation of state of nitrogen: Span, Lemmon, Jacobsen, Wagner, Yokozeki, J. Phys. Chem. Ref. Data 29 (2000) 1361,
//! doi:10.1063/1.1349047.
//!
//! Valid from the triple point (63.151 K) to 1000 K and up to 2200 MPa; the authors give 0.02 % in density up to 523 K
//! and 12 MPa. Temperatures on ITS-90.

use crate::helmholtz::{Gaussian, Helmholtz, Power, power};

// The critical density is published as 11.1839 mol/dm³.
/// Nitrogen.
pub(crate) const EQUATION: Helmholtz = Helmholtz {
    molar_gas_constant: 8.31451,
    molar_mass: 0.02801348,
    critical_temperature: 126.192,
    critical_density: 11183.9 * 0.02801348,
    critical_pressure: 3.3958e6,
    powers: &POWERS,
    gaussians: &GAUSSIANS,
};

/// Triple point, K.
pub(crate) const TRIPLE_TEMPERATURE: f64 = 63.151;
/// Acentric factor.
pub(crate) const ACENTRIC: f64 = 0.0372;

/// Melting pressure, Pa, at T in K: the melting line of the same publication.
pub(crate) fn melting_pressure(temperature: f64) -> f64 {
    let ratio = temperature / TRIPLE_TEMPERATURE;
    12523.0 * (1.0 + 12798.61 * (ratio.powf(1.78963) - 1.0))
}

// Span et al. 2000, coefficients of the residual part, terms 1 to 32: n, d, t, l.
const POWERS: [Power; 32] = [
    power(0.924803575275, 1, 0.25, 0),
    power(-0.492448489428, 1, 0.875, 0),
    power(0.661883336938, 2, 0.5, 0),
    power(-1.92902649201, 2, 0.875, 0),
    power(-0.0622469309629, 3, 0.375, 0),
    power(0.349943957581, 3, 0.75, 0),
    power(0.564857472498, 1, 0.5, 1),
    power(-1.61720005987, 1, 0.75, 1),
    power(-0.481395031883, 1, 2.0, 1),
    power(0.421150636384, 3, 1.25, 1),
    power(-0.0161962230825, 3, 3.5, 1),
    power(0.172100994165, 4, 1.0, 1),
    power(0.00735448924933, 6, 0.5, 1),
    power(0.0168077305479, 6, 3.0, 1),
    power(-0.00107626664179, 7, 0.0, 1),
    power(-0.0137318088513, 7, 2.75, 1),
    power(0.000635466899859, 8, 0.75, 1),
    power(0.00304432279419, 8, 2.5, 1),
    power(-0.0435762336045, 1, 4.0, 2),
    power(-0.0723174889316, 2, 6.0, 2),
    power(0.0389644315272, 3, 6.0, 2),
    power(-0.021220136391, 4, 3.0, 2),
    power(0.00408822981509, 5, 3.0, 2),
    power(-5.51990017984e-05, 8, 6.0, 2),
    power(-0.0462016716479, 4, 16.0, 3),
    power(-0.00300311716011, 5, 11.0, 3),
    power(0.0368825891208, 5, 15.0, 3),
    power(-0.0025585684622, 8, 12.0, 3),
    power(0.00896915264558, 3, 12.0, 4),
    power(-0.0044151337035, 5, 7.0, 4),
    power(0.00133722924858, 6, 4.0, 4),
    power(0.000264832491957, 9, 16.0, 4),
];

// Span et al. 2000, coefficients of the residual part, terms 33 to 36.
const GAUSSIANS: [Gaussian; 4] = [
    Gaussian { n: 19.6688194015, d: 1, t: 0.0, eta: 20.0, beta: 325.0, gamma: 1.16 },
    Gaussian { n: -20.911560073, d: 1, t: 1.0, eta: 20.0, beta: 325.0, gamma: 1.16 },
    Gaussian { n: 0.0167788306989, d: 3, t: 2.0, eta: 15.0, beta: 300.0, gamma: 1.13 },
    Gaussian { n: 2627.67566274, d: 2, t: 3.0, eta: 25.0, beta: 275.0, gamma: 1.25 },
];
