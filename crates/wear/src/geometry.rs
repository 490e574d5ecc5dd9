//! Free contact angle of a worn bearing (Zhang et al. 2025, Eqs. 12 and 13).

use crate::WearError;
use tribodyn_contact::Scalar;

/// Groove geometry of a ball bearing before wear, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrooveGeometry {
    /// Ball diameter D, m.
    pub ball_diameter: f64,
    /// Groove radius of the inner race r_i, m.
    pub inner_groove: f64,
    /// Groove radius of the outer race r_o, m.
    pub outer_groove: f64,
    /// Radius of the inner groove's bottom about the bearing's axis R_i, m.
    pub inner_bottom: f64,
    /// Radius of the outer groove's bottom about the bearing's axis R_o, m.
    pub outer_bottom: f64,
}

/// Depths worn off the groove bottoms, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearDepths<D = f64> {
    /// Of the inner race d_i, m.
    pub inner: D,
    /// Of the outer race d_o, m.
    pub outer: D,
}

impl WearDepths {
    /// No wear.
    pub const NONE: Self = Self { inner: 0.0, outer: 0.0 };
}

impl GrooveGeometry {
    /// Distance of the groove centres A = r_i + r_o − D, m.
    pub fn centre_distance(&self) -> f64 {
        (self.inner_groove - 0.5 * self.ball_diameter) + (self.outer_groove - 0.5 * self.ball_diameter)
    }

    /// Radial clearance on the radius with wear, R_o − R_i − D + d_i + d_o, m; half the diametral clearance. Negative
    /// where the ball is squeezed.
    pub fn clearance<D: Scalar>(&self, wear: WearDepths<D>) -> D {
        wear.inner + wear.outer + (self.outer_bottom - self.inner_bottom - self.ball_diameter)
    }

    /// Free contact angle with wear taken as added radial clearance, rad, from 0 to π/2.
    ///
    /// cos α = 1 − c/A with the clearance c is the paper's equation; it is evaluated as sin(α/2) = sqrt(c/(2A)), which
    /// keeps the digits of small angles. At no clearance angle and derivative are returned as 0, although the slope of
    /// the angle grows without bound towards it.
    ///
    /// # Errors
    /// [`WearError`] for lengths that are not finite and above 0, a groove that is not wider than the ball, a negative
    /// depth, and for a clearance that no contact angle has.
    pub fn free_contact_angle<D: Scalar>(&self, wear: WearDepths<D>) -> Result<D, WearError> {
        self.check(wear.inner.re(), wear.outer.re())?;
        let (clearance, limit) = (self.clearance(wear), self.centre_distance());
        let value = clearance.re();
        if !(0.0..=limit).contains(&value) {
            return Err(WearError::Clearance { clearance: value, limit });
        }
        if value == 0.0 {
            return Ok(D::zero());
        }
        Ok((clearance / (2.0 * limit)).sqrt().asin() * 2.0)
    }

    fn check(&self, inner_depth: f64, outer_depth: f64) -> Result<(), WearError> {
        let lengths = [
            ("ball diameter", self.ball_diameter),
            ("radius of the inner groove's bottom", self.inner_bottom),
            ("radius of the outer groove's bottom", self.outer_bottom),
        ];
        for (name, value) in lengths {
            if !(value > 0.0 && value.is_finite()) {
                return Err(WearError::Length { name, value });
            }
        }
        let ball_radius = 0.5 * self.ball_diameter;
        for (race, value) in [("inner", self.inner_groove), ("outer", self.outer_groove)] {
            if !(value > ball_radius && value.is_finite()) {
                return Err(WearError::Groove { race, value, ball_radius });
            }
        }
        for (race, value) in [("inner", inner_depth), ("outer", outer_depth)] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(WearError::Depth { race, value });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::Dual64;

    const ANGLE: f64 = 18.0;

    /// Ball, grooves and angle of the 7224 envelope; bottoms follow from cos α0 = 1 − (R_o − R_i − D)/A.
    fn bearing() -> GrooveGeometry {
        let (ball_diameter, inner_groove, outer_groove) = (0.03016, 0.01552, 0.01583);
        let centre_distance = inner_groove + outer_groove - ball_diameter;
        let clearance = centre_distance * (1.0 - ANGLE.to_radians().cos());
        let inner_bottom = 0.0686;
        let outer_bottom = inner_bottom + ball_diameter + clearance;
        GrooveGeometry { ball_diameter, inner_groove, outer_groove, inner_bottom, outer_bottom }
    }

    /// The paper's form of the equation, written out.
    fn printed(g: &GrooveGeometry, wear: WearDepths) -> f64 {
        let grooves = g.inner_groove + g.outer_groove;
        let worn = grooves - (g.outer_bottom - g.inner_bottom) - (wear.inner + wear.outer);
        (worn / (grooves - g.ball_diameter)).acos()
    }

    #[test]
    fn limit_unworn_angle_is_the_free_contact_angle() {
        let found = bearing().free_contact_angle(WearDepths::NONE).unwrap();
        assert!((found - ANGLE.to_radians()).abs() < 1e-12, "{found}");
    }

    #[test]
    fn identity_half_angle_form_is_the_printed_equation() {
        let g = bearing();
        for (inner, outer) in [(0.0, 0.0), (3e-6, 0.0), (0.0, 8e-6), (1e-5, 2e-5), (3e-4, 5e-4)] {
            let wear = WearDepths { inner, outer };
            assert!((g.free_contact_angle(wear).unwrap() - printed(&g, wear)).abs() < 1e-13);
        }
    }

    #[test]
    fn identity_wear_raises_the_angle_whichever_race_it_is_on() {
        let g = bearing();
        let mut last = g.free_contact_angle(WearDepths::NONE).unwrap();
        for step in 1..=20 {
            let depth = 1e-6 * f64::from(step);
            let inner = g.free_contact_angle(WearDepths { inner: depth, outer: 0.0 }).unwrap();
            let outer = g.free_contact_angle(WearDepths { inner: 0.0, outer: depth }).unwrap();
            assert_eq!(inner, outer);
            assert!(inner > last + 1e-4);
            last = inner;
        }
    }

    #[test]
    fn identity_wear_equals_added_radial_clearance() {
        let g = bearing();
        let wear = WearDepths { inner: 4e-6, outer: 7e-6 };
        let mut wider = g;
        wider.inner_bottom -= wear.inner;
        wider.outer_bottom += wear.outer;
        let worn = g.free_contact_angle(wear).unwrap();
        assert!((worn - wider.free_contact_angle(WearDepths::NONE).unwrap()).abs() < 1e-12);
        // Diametral clearance 2A (1 − cos α) grows by twice the depths.
        let diametral = |angle: f64| 2.0 * g.centre_distance() * (1.0 - angle.cos());
        let grown = diametral(worn) - diametral(g.free_contact_angle(WearDepths::NONE).unwrap());
        assert!((grown - 2.0 * (wear.inner + wear.outer)).abs() < 1e-16);
    }

    #[test]
    fn identity_derivative_is_one_over_a_sine() {
        let g = bearing();
        let wear = WearDepths { inner: Dual64::new(5e-6, 1.0), outer: Dual64::from(2e-6) };
        let found = g.free_contact_angle(wear).unwrap();
        let expected = 1.0 / (g.centre_distance() * found.re.sin());
        assert!((found.eps / expected - 1.0).abs() < 1e-14);
    }

    #[test]
    fn limit_no_clearance_and_most_clearance() {
        // Binary fractions: sums and differences below are exact.
        let mut g = GrooveGeometry {
            ball_diameter: 0.25,
            inner_groove: 0.140625,
            outer_groove: 0.140625,
            inner_bottom: 1.0,
            outer_bottom: 1.25,
        };
        let zero = WearDepths { inner: Dual64::new(0.0, 1.0), outer: Dual64::from(0.0) };
        let found = g.free_contact_angle(zero).unwrap();
        assert_eq!((found.re, found.eps), (0.0, 0.0));
        g.outer_bottom += g.centre_distance();
        let most = g.free_contact_angle(WearDepths::NONE).unwrap();
        assert!((most - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        let beyond = WearDepths { inner: 0.0, outer: 1e-6 };
        assert!(matches!(g.free_contact_angle(beyond), Err(WearError::Clearance { limit: 0.03125, .. })));
        g.outer_bottom = 1.2499;
        assert!(matches!(
            g.free_contact_angle(WearDepths::NONE),
            Err(WearError::Clearance { clearance, .. }) if clearance < 0.0
        ));
    }

    #[test]
    fn limit_impossible_input_is_refused() {
        let g = bearing();
        let none = WearDepths::NONE;
        let tight = GrooveGeometry { inner_groove: 0.015, ..g };
        let expected = WearError::Groove { race: "inner", value: 0.015, ball_radius: 0.01508 };
        assert_eq!(tight.free_contact_angle(none), Err(expected));
        let nothing = GrooveGeometry { ball_diameter: 0.0, ..g };
        assert_eq!(nothing.free_contact_angle(none), Err(WearError::Length { name: "ball diameter", value: 0.0 }));
        for bad in [f64::NAN, f64::INFINITY, -1.0] {
            assert!(matches!(
                GrooveGeometry { outer_bottom: bad, ..g }.free_contact_angle(none),
                Err(WearError::Length { .. })
            ));
            let depths = WearDepths { inner: 0.0, outer: bad };
            assert!(matches!(g.free_contact_angle(depths), Err(WearError::Depth { race: "outer", .. })));
        }
        let message = g.free_contact_angle(WearDepths { inner: -1e-6, outer: 0.0 }).unwrap_err().to_string();
        assert!(message.contains("inner") && message.contains("-0.000001 m"), "{message}");
    }
}
