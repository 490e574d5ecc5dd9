//! Against 40-digit arithmetic (tables written by `fixtures/reference/mpmath/hertz.py`) and the `ellip` crate.

use super::{assert_close, error};
use tribodyn_contact::*;

const HERTZ: &str = include_str!("../../../../fixtures/reference/mpmath/hertz.csv");
const ELLIPTIC: &str = include_str!("../../../../fixtures/reference/mpmath/elliptic.csv");
/// Accuracy that the crate promises; the references themselves are good to 1e-29.
const PROMISED: f64 = 1e-14;

fn rows<const N: usize>(text: &str) -> Vec<[f64; N]> {
    let data = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let row = |line: &str| {
        let values: Vec<f64> = line.split(',').map(|v| v.parse().unwrap()).collect();
        values.try_into().unwrap()
    };
    data.map(row).collect()
}

#[test]
fn code_mpmath_integrals_to_the_last_digits() {
    let table = rows::<5>(ELLIPTIC);
    assert!(table.len() > 80);
    for [ratio, k, e, b, d] in table {
        let found = CompleteElliptic::new(ratio).unwrap();
        for (found, expected) in [(found.first, k), (found.second, e), (found.b, b), (found.d, d)] {
            assert_close(found, expected, PROMISED);
        }
        let difference = (b - ratio * ratio * d) / e;
        assert!((curvature_difference(ratio).unwrap() - difference).abs() < 1e-15);
    }
}

#[test]
fn code_mpmath_contacts_to_the_last_digits() {
    let table = rows::<21>(HERTZ);
    assert!(table.len() > 250);
    for row in table {
        let [r1x, r1y, r2x, r2y, angle, young1, poisson1, young2, poisson2, load, x, y, ..] = row;
        let [e_prime, k, first, second, a, b, pressure, approach, stiffness] = row[12..].try_into().unwrap();
        let bodies = [Body { radius_x: r1x, radius_y: r1y }, Body { radius_x: r2x, radius_y: r2y }];
        let gap = relative_curvatures(&bodies[0], &bodies[1], angle).unwrap();
        let elastic = [(young1, poisson1), (young2, poisson2)].map(|(young, poisson)| ElasticBody { young, poisson });
        let modulus = effective_modulus(&elastic[0], &elastic[1]);
        let contact = HertzContact::new(gap.x, gap.y, modulus).unwrap();
        let ellipse = contact.ellipse(load);
        let found_approach = contact.approach(load);
        let pairs = [
            (gap.x, x),
            (gap.y, y),
            (modulus, e_prime),
            (contact.ellipticity, k),
            (contact.first_integral, first),
            (contact.second_integral, second),
            (contact.curvature_sum, x + y),
            (ellipse.semi_major, a),
            (ellipse.semi_minor, b),
            (ellipse.peak_pressure, pressure),
            (found_approach, approach),
            (contact.stiffness(), stiffness),
            (contact.load(approach), load),
            (contact.tangent_stiffness(approach), 1.5 * load / approach),
            (contact.load_from_peak_pressure(pressure), load),
        ];
        for (found, expected) in pairs {
            assert_close(found, expected, PROMISED);
        }
        let lateral = if contact.ellipticity == 1.0 || x > y { a } else { b };
        assert_close(ellipse.semi_lateral(), lateral, PROMISED);
        assert_close(ellipse.semi_rolling(), a * b / lateral, PROMISED);
    }
}

/// The figures in the doc comment of `CompleteElliptic`.
#[test]
fn code_ellip_loses_digits_to_the_parameter_at_high_ellipticity() {
    let (mut theirs, mut ours) = (0f64, 0f64);
    for row in rows::<21>(HERTZ).iter().filter(|row| row[13] > 20.0) {
        let (k, first) = (row[13], row[14]);
        theirs = theirs.max(error(ellip::ellipk(1.0 - 1.0 / (k * k)).unwrap(), first));
        ours = ours.max(error(CompleteElliptic::new(1.0 / k).unwrap().first, first));
    }
    assert!(theirs > 1.2e-14 && theirs < 1.3e-14 && ours < 5e-16, "{theirs:e} {ours:e}");
    let [_, at_fifty, ..] = *rows::<5>(ELLIPTIC).iter().find(|row| row[0] == 0.02).unwrap();
    let theirs = error(ellip::ellipk(1.0 - 1.0 / 2500.0).unwrap(), at_fifty);
    let ours = error(CompleteElliptic::new(0.02).unwrap().first, at_fifty);
    assert!(theirs > 1.0e-14 && theirs < 1.1e-14 && ours < 3e-16, "{theirs:e} {ours:e}");
}
