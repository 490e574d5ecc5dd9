//! Limiting cases with closed forms, and the edges of what is allowed.

use super::{assert_close, contact};
use num_dual::{Dual2_64, Dual3_64, Dual64};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use tribodyn_contact::*;

#[test]
fn limit_integrals_of_the_circle() {
    let found = CompleteElliptic::new(1.0).unwrap();
    assert_eq!((found.first, found.second), (FRAC_PI_2, FRAC_PI_2));
    assert_eq!((found.b, found.d), (FRAC_PI_4, FRAC_PI_4));
    assert_eq!(curvature_difference(1.0).unwrap(), 0.0);
    assert_eq!(curvature_ratio(1.0).unwrap(), 1.0);
}

#[test]
fn limit_integrals_of_a_thin_ellipse() {
    // K → ln(4/k'), E → 1 with remainders of the order of k'² ln k'.
    let found = CompleteElliptic::new(1e-9).unwrap();
    assert_close(found.first, (4e9f64).ln(), 1e-15);
    assert_close(found.second, 1.0, 1e-14);
}

#[test]
fn limit_axis_ratio_outside_its_range_is_refused() {
    for value in [0.0, -0.5, 1.0 + 1e-15, f64::INFINITY] {
        assert_eq!(CompleteElliptic::new(value), Err(ContactError::AxisRatio { value }));
    }
    assert!(CompleteElliptic::new(f64::NAN).is_err());
}

#[test]
fn limit_integrals_second_derivatives_at_the_circle() {
    // From the integrals' series in m with m = 1 − k'²: dK/dk' = −π/4, d²K/dk'² = 5π/16, dE/dk' = π/4, d²E/dk'² = π/16.
    let found = CompleteElliptic::new(Dual2_64::from_re(1.0).derivative()).unwrap();
    assert_close(found.first.v1, -FRAC_PI_4, 1e-15);
    assert_close(found.first.v2, 5.0 * PI / 16.0, 1e-15);
    assert_close(found.second.v1, FRAC_PI_4, 1e-15);
    assert_close(found.second.v2, PI / 16.0, 4e-15);
}

#[test]
fn limit_integrals_third_derivatives_next_to_the_circle() {
    // The coefficients of ε³ and ε⁴ at k' = 1 + ε in the same series. Here c_1 is just below the size at which the mean
    // starts its last steps.
    let offset = -1.9e-8;
    let found = CompleteElliptic::new(Dual3_64::from_re(1.0 + offset).derivative()).unwrap();
    let first = 36.0 / 64.0 - 200.0 / 256.0 + 4.0 * offset * (9.0 / 64.0 - 300.0 / 256.0 + 19600.0 / 16384.0);
    assert_close(found.first.v3, 6.0 * FRAC_PI_2 * first, 1e-13);
    let second = -12.0 / 64.0 + 40.0 / 256.0 + 4.0 * offset * (-3.0 / 64.0 + 60.0 / 256.0 - 2800.0 / 16384.0);
    assert_close(found.second.v3, 6.0 * FRAC_PI_2 * second, 1e-13);
}

#[test]
fn limit_sphere_on_flat() {
    // Q = (4/3) E* sqrt(R δ³), a = sqrt(R δ), p_max = (6 Q E*²/(π³R²))^(1/3), with E* = E'/2 (Johnson, section 4.2).
    let (radius, half) = (0.015, 1.1e11);
    let ball = Body { radius_x: radius, radius_y: radius };
    let flat = Body { radius_x: f64::INFINITY, radius_y: f64::INFINITY };
    let gap = relative_curvatures(&ball, &flat, 0.7).unwrap();
    let contact = contact(gap.x, gap.y);
    let approach: f64 = 3e-5;
    let load = 4.0 / 3.0 * half * (radius * approach.powi(3)).sqrt();
    assert_close(contact.ellipticity, 1.0, 1e-15);
    assert_close(contact.load(approach), load, 2e-15);
    let ellipse = contact.ellipse(load);
    assert_close(ellipse.semi_major, (radius * approach).sqrt(), 2e-15);
    assert_close(ellipse.peak_pressure, (6.0 * load * half * half / (PI.powi(3) * radius * radius)).cbrt(), 4e-15);
}

#[test]
fn limit_equal_crossed_cylinders_are_a_sphere_on_flat() {
    let cylinder = Body { radius_x: 0.02, radius_y: f64::INFINITY };
    let gap = relative_curvatures(&cylinder, &cylinder, FRAC_PI_2).unwrap();
    let crossed = contact(gap.x, gap.y);
    let sphere = contact(50.0, 50.0);
    assert_close(crossed.ellipticity, 1.0, 1e-15);
    assert_close(crossed.stiffness(), sphere.stiffness(), 2e-15);
    // At 60° the gap of equal cylinders has the curvatures (1 ± cos 60°)/r along the bisectors.
    let gap = relative_curvatures(&cylinder, &cylinder, PI / 3.0).unwrap();
    assert_close(gap.x, 75.0, 1e-15);
    assert_close(gap.y, 25.0, 4e-15);
    assert_close(gap.rotation, PI / 6.0, 4e-15);
}

#[test]
fn limit_sphere_in_a_socket_keeps_all_digits_of_the_clearance() {
    // Radii 2^-6 and −(2^-6 + 2^-46): their difference is exact, that of their reciprocals loses 12 digits.
    let (r1, gap) = (2f64.powi(-6), 2f64.powi(-46));
    let ball = Body { radius_x: r1, radius_y: r1 };
    let socket = Body { radius_x: -(r1 + gap), radius_y: -(r1 + gap) };
    let found = relative_curvatures(&ball, &socket, 0.0).unwrap();
    assert_close(found.x, gap / (r1 * (r1 + gap)), 4e-16);
    assert_eq!(contact(found.x, found.y).ellipticity, 1.0);
}

#[test]
fn limit_impossible_contacts_are_refused() {
    let reject = |x, y, modulus| HertzContact::<f64>::new(x, y, modulus).unwrap_err();
    assert_eq!(reject(-1.0, 2.0, 1e11), ContactError::Curvature { plane: "x", value: -1.0 });
    assert_eq!(reject(1.0, 0.0, 1e11), ContactError::Curvature { plane: "y", value: 0.0 });
    assert!(matches!(reject(f64::NAN, 1.0, 1e11), ContactError::Curvature { plane: "x", .. }));
    assert!(matches!(reject(1.0, f64::INFINITY, 1e11), ContactError::Curvature { plane: "y", .. }));
    assert_eq!(reject(1.0, 1.0, 0.0), ContactError::Modulus { value: 0.0 });
    for tiny in [1e-300, 5e-8] {
        assert!(matches!(reject(tiny, 1.0, 1e11), ContactError::Ellipticity { .. }));
    }
    let message = reject(-1.0, 2.0, 1e11).to_string();
    assert!(message.contains("-1.0000 1/m") && message.contains("above 0"), "{message}");
    let (good, bad) = (Body { radius_x: 0.1, radius_y: 0.1 }, Body { radius_x: 0.1, radius_y: 0.0 });
    assert!(matches!(relative_curvatures(&good, &bad, 0.0), Err(ContactError::Radius { plane: "y", .. })));
    assert!(matches!(relative_curvatures(&good, &good, f64::NAN), Err(ContactError::Angle { .. })));
}

#[test]
fn limit_longest_ellipse_taken() {
    let ratio = curvature_ratio(MAX_ELLIPTICITY).unwrap();
    assert_close(contact(0.999 * ratio, 1.0).ellipticity, MAX_ELLIPTICITY, 1e-3);
    assert!(HertzContact::new(1.001 * ratio, 1.0, 1e11).is_err());
}

#[test]
fn limit_no_contact_gives_zeros_without_nan() {
    let contact = contact(Dual2_64::new(80.0, 1.0, 0.0), Dual2_64::from(3.0));
    for value in [0.0, -0.0, -1e-5, 1e-320, 1e-101] {
        let argument = Dual2_64::new(value, 1.0, 0.0);
        let ellipse = contact.ellipse(argument);
        let results = [
            contact.load(argument),
            contact.approach(argument),
            contact.tangent_stiffness(argument),
            contact.load_from_peak_pressure(argument),
            ellipse.semi_major,
            ellipse.semi_minor,
            ellipse.peak_pressure,
        ];
        for found in results {
            assert_eq!((found.re, found.v1, found.v2), (0.0, 0.0, 0.0));
        }
    }
    let just_touching = contact.ellipse(Dual2_64::new(1e-99, 1.0, 0.0));
    assert!(just_touching.peak_pressure.re > 0.0 && just_touching.peak_pressure.v2.is_finite());
    assert!(contact.load(Dual2_64::new(f64::NAN, 1.0, 0.0)).re.is_nan());
}

#[test]
fn limit_derivatives_at_equal_curvatures_are_those_of_a_smooth_surface() {
    // d ln k/d ln λ = 2/3 at the circle; K_n is symmetric and of degree −1/2 in both curvatures, so −K_n/(4ρ) in each.
    let along_x = contact(Dual64::new(40.0, 1.0), Dual64::from(40.0));
    let along_y = contact(Dual64::from(40.0), Dual64::new(40.0, 1.0));
    assert_close(along_x.ellipticity.eps, 2.0 / 3.0 / 40.0, 2e-15);
    assert_close(along_y.ellipticity.eps, -2.0 / 3.0 / 40.0, 2e-15);
    for contact in [along_x, along_y] {
        assert_close(contact.stiffness().eps, -contact.stiffness().re / 160.0, 1e-14);
    }
}
