//! Archard's law: J. F. Archard, J. Appl. Phys. 24 (1953) 981, doi:10.1063/1.1721448.

use tribodyn_contact::Scalar;

/// Wear pair under Archard's law, w = (K_w/H) × load × sliding speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Archard {
    /// Wear coefficient K_w.
    pub coefficient: f64,
    /// Hardness H of the surface that wears, Pa.
    pub hardness: f64,
}

impl Archard {
    /// Volume worn per time, m³/s, for a pressure-slip integral ∬ p |Δv| dA, W (or load times sliding speed).
    pub fn rate<D: Scalar>(&self, pressure_slip_integral: D) -> D {
        pressure_slip_integral * (self.coefficient / self.hardness)
    }
}

/// Volume worn off a race per time, m³/s: (K_w/H) ∬ p |Δv| dA, from coefficient, hardness (Pa) and the integral (W).
pub fn archard_rate<D: Scalar>(coefficient: f64, hardness: f64, pressure_slip_integral: D) -> D {
    Archard { coefficient, hardness }.rate(pressure_slip_integral)
}

/// Volume worn off the cage per time at one pocket, m³/s: (K_w/H) |F| |Δv|, from coefficient, hardness (Pa), pocket
/// force (N) and sliding speed (m/s). Signs of force and speed do not matter.
pub fn cage_rate<D: Scalar>(coefficient: f64, hardness: f64, force: D, sliding_speed: D) -> D {
    archard_rate(coefficient, hardness, (force * sliding_speed).abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::Dual64;

    #[test]
    fn limit_sliding_distance_times_load_over_hardness() {
        // 100 N sliding 1 km at 2 m/s, K_w = 1e-5, H = 2 GPa: 1e-5 · 100 · 1000/2e9 = 5e-10 m³ in 500 s.
        let rate: f64 = archard_rate(1e-5, 2e9, 100.0 * 2.0);
        assert!((rate * 500.0 / 5e-10 - 1.0).abs() < 1e-15);
        assert_eq!(archard_rate(1e-5, 2e9, 0.0), 0.0);
    }

    #[test]
    fn identity_cage_rate_has_no_sign_and_is_the_integral_of_one_force() {
        let expected = archard_rate(3e-6, 1e9, 12.0);
        for (force, speed) in [(3.0, 4.0), (-3.0, 4.0), (3.0, -4.0), (-3.0, -4.0)] {
            assert_eq!(cage_rate(3e-6, 1e9, force, speed), expected);
        }
    }

    #[test]
    fn identity_rate_is_linear_in_the_integral() {
        let pair = Archard { coefficient: 2e-7, hardness: 7e9 };
        let found = pair.rate(Dual64::new(5.0, 1.0));
        assert_eq!((found.re, found.eps), (pair.rate(5.0), pair.rate(1.0)));
        let found = cage_rate(2e-7, 7e9, Dual64::new(-5.0, 1.0), Dual64::from(2.0));
        assert!((found.eps / (-2.0 * 2e-7 / 7e9) - 1.0).abs() < 1e-15);
    }
}
