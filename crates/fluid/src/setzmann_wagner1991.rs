//! Equation of state of methane: Setzmann, Wagner, J. Phys. Chem. Ref. Data 20 (1991) 1061, doi:10.1063/1.555898.
//!
//! Valid from the melting line to 625 K and up to 1000 MPa; the authors give 0.03 % in density below 12 MPa and 350 K
//! and 0.03 % to 0.15 % at higher pressures and temperatures. Temperatures on ITS-90.

use crate::helmholtz::{Gaussian, Helmholtz, Power, power};

// The critical density is published as 162.66 kg/m³.
/// Methane.
pub(crate) const EQUATION: Helmholtz = Helmholtz {
    molar_gas_constant: 8.31451,
    molar_mass: 0.0160428,
    critical_temperature: 190.564,
    critical_density: 162.66,
    critical_pressure: 4.5992e6,
    powers: &POWERS,
    gaussians: &GAUSSIANS,
};

/// Triple point, K.
pub(crate) const TRIPLE_TEMPERATURE: f64 = 90.6941;
/// Acentric factor.
pub(crate) const ACENTRIC: f64 = 0.01142;

/// Melting pressure, Pa, at T in K: the melting line of the same publication.
pub(crate) fn melting_pressure(temperature: f64) -> f64 {
    let ratio = temperature / TRIPLE_TEMPERATURE;
    11696.0 * (1.0 + 24756.8 * (ratio.powf(1.85) - 1.0) - 7366.02 * (ratio.powf(2.1) - 1.0))
}

// Setzmann, Wagner 1991, coefficients of the residual part, terms 1 to 36: n, d, t, l.
const POWERS: [Power; 36] = [
    power(0.04367901028, 1, -0.5, 0),
    power(0.6709236199, 1, 0.5, 0),
    power(-1.765577859, 1, 1.0, 0),
    power(0.8582330241, 2, 0.5, 0),
    power(-1.206513052, 2, 1.0, 0),
    power(0.512046722, 2, 1.5, 0),
    power(-0.0004000010791, 2, 4.5, 0),
    power(-0.01247842423, 3, 0.0, 0),
    power(0.03100269701, 4, 1.0, 0),
    power(0.001754748522, 4, 3.0, 0),
    power(-3.171921605e-06, 8, 1.0, 0),
    power(-2.24034684e-06, 9, 3.0, 0),
    power(2.947056156e-07, 10, 3.0, 0),
    power(0.1830487909, 1, 0.0, 1),
    power(0.1511883679, 1, 1.0, 1),
    power(-0.4289363877, 1, 2.0, 1),
    power(0.06894002446, 2, 0.0, 1),
    power(-0.01408313996, 4, 0.0, 1),
    power(-0.0306305483, 5, 2.0, 1),
    power(-0.02969906708, 6, 2.0, 1),
    power(-0.01932040831, 1, 5.0, 2),
    power(-0.1105739959, 2, 5.0, 2),
    power(0.09952548995, 3, 5.0, 2),
    power(0.008548437825, 4, 2.0, 2),
    power(-0.06150555662, 4, 4.0, 2),
    power(-0.04291792423, 3, 12.0, 3),
    power(-0.0181320729, 5, 8.0, 3),
    power(0.0344590476, 5, 10.0, 3),
    power(-0.00238591945, 8, 10.0, 3),
    power(-0.01159094939, 2, 10.0, 4),
    power(0.06641693602, 3, 14.0, 4),
    power(-0.0237154959, 4, 12.0, 4),
    power(-0.03961624905, 4, 18.0, 4),
    power(-0.01387292044, 4, 22.0, 4),
    power(0.03389489599, 5, 18.0, 4),
    power(-0.002927378753, 6, 14.0, 4),
];

// Setzmann, Wagner 1991, coefficients of the residual part, terms 37 to 40.
const GAUSSIANS: [Gaussian; 4] = [
    Gaussian { n: 9.324799946e-05, d: 2, t: 2.0, eta: 20.0, beta: 200.0, gamma: 1.07 },
    Gaussian { n: -6.287171518, d: 0, t: 0.0, eta: 40.0, beta: 250.0, gamma: 1.11 },
    Gaussian { n: 12.71069467, d: 0, t: 1.0, eta: 40.0, beta: 250.0, gamma: 1.11 },
    Gaussian { n: -6.423953466, d: 0, t: 2.0, eta: 40.0, beta: 250.0, gamma: 1.11 },
];
