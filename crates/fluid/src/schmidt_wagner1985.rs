//! Equation of state of oxygen: Schmidt, Wagner, Fluid Phase Equilib. 19 (1985) 175, doi:10.1016/0378-3812(85)87016-3.
//!
//! Valid from the triple point (54.361 K) to 300 K and up to 82 MPa. Stewart, Jacobsen, Wagner, J. Phys. Chem. Ref.
//! Data 20 (1991) 917, doi:10.1063/1.555897, took the same equation for their tables.

use crate::helmholtz::{Helmholtz, Power, power};

// The critical density is published as 13.63 mol/dm³.
/// Oxygen.
pub(crate) const EQUATION: Helmholtz = Helmholtz {
    molar_gas_constant: 8.31434,
    molar_mass: 0.0319988,
    critical_temperature: 154.581,
    critical_density: 13630.0 * 0.0319988,
    critical_pressure: 5.043e6,
    powers: &POWERS,
    gaussians: &[],
};

/// Triple point, K.
pub(crate) const TRIPLE_TEMPERATURE: f64 = 54.361;
/// Acentric factor.
pub(crate) const ACENTRIC: f64 = 0.0222;

/// Melting pressure, Pa, at T in K: Younglove, J. Phys. Chem. Ref. Data 11 Suppl. 1 (1982).
pub(crate) fn melting_pressure(temperature: f64) -> f64 {
    1e6 * (-267.226854 + 0.227606348 * temperature.powf(1.769))
}

// Schmidt, Wagner 1985, coefficients of the residual part, terms 1 to 32: n, d, t, l.
const POWERS: [Power; 32] = [
    power(0.3983768749, 1, 0.0, 0),
    power(-1.846157454, 1, 1.5, 0),
    power(0.4183473197, 1, 2.5, 0),
    power(0.02370620711, 2, -0.5, 0),
    power(0.09771730573, 2, 1.5, 0),
    power(0.03017891294, 2, 2.0, 0),
    power(0.02273353212, 3, 0.0, 0),
    power(0.01357254086, 3, 1.0, 0),
    power(-0.04052698943, 3, 2.5, 0),
    power(0.0005454628515, 6, 0.0, 0),
    power(0.0005113182277, 7, 2.0, 0),
    power(2.953466883e-07, 7, 5.0, 0),
    power(-8.687645072e-05, 8, 2.0, 0),
    power(-0.2127082589, 1, 5.0, 2),
    power(0.08735941958, 1, 6.0, 2),
    power(0.127550919, 2, 3.5, 2),
    power(-0.09067701064, 2, 5.5, 2),
    power(-0.03540084206, 3, 3.0, 2),
    power(-0.03623278059, 3, 7.0, 2),
    power(0.0132769929, 5, 6.0, 2),
    power(-0.0003254111865, 6, 8.5, 2),
    power(-0.008313582932, 7, 4.0, 2),
    power(0.002124570559, 8, 6.5, 2),
    power(-0.0008325206232, 10, 5.5, 2),
    power(-2.626173276e-05, 2, 22.0, 4),
    power(0.002599581482, 3, 11.0, 4),
    power(0.009984649663, 3, 18.0, 4),
    power(0.002199923153, 4, 11.0, 4),
    power(-0.02591350486, 4, 23.0, 4),
    power(-0.1259630848, 5, 17.0, 4),
    power(0.1478355637, 5, 18.0, 4),
    power(-0.01011251078, 5, 23.0, 4),
];
