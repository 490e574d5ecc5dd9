//! Ratings and lives against the standards' tables, catalogues and closed forms.

use std::f64::consts::PI;
use tribodyn_rating::{
    BallLoads, Lubrication, RatedBearing, RatingError, Turning, basic_life_mrev, hours, life_modification_factor,
    reference_viscosity, reliability_factor,
};

/// A bearing with the usual grooves, dimensions in mm and degrees.
fn bearing(ball_count: usize, diameter: f64, pitch: f64, angle_deg: f64) -> RatedBearing {
    RatedBearing {
        ball_count,
        ball_diameter: diameter * 1e-3,
        pitch_diameter: pitch * 1e-3,
        contact_angle: angle_deg.to_radians(),
        inner_coefficient: 0.52,
        outer_coefficient: 0.53,
    }
}

#[track_caller]
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} is not {expected} to {tolerance:e}");
}

/// ISO 281:2007, table 2, column of single-row bearings: half a unit of the last digit.
#[test]
fn paper_dynamic_factors_of_the_standards_table() {
    let table = [
        (0.05, 46.7),
        (0.07, 51.1),
        (0.10, 55.5),
        (0.12, 57.5),
        (0.14, 58.8),
        (0.16, 59.6),
        (0.20, 59.9),
        (0.24, 59.0),
        (0.28, 57.1),
        (0.32, 54.6),
        (0.36, 51.7),
        (0.40, 48.4),
    ];
    for (gamma, factor) in table {
        let found = bearing(9, 10.0 * gamma, 10.0, 0.0).dynamic_factor().unwrap();
        assert!((found - factor).abs() <= 0.051, "f_c({gamma}) = {found}, in the standard {factor}");
    }
}

/// ISO 76:2006, table 1: half a unit of the last digit. Up to 0.09 the outer race is the weaker one.
#[test]
fn paper_static_factors_of_the_standards_table() {
    let table = [(0.01, 14.9), (0.05, 15.7), (0.09, 16.5), (0.10, 16.4), (0.15, 15.2), (0.20, 14.0)];
    for (gamma, factor) in table {
        let found = bearing(9, 10.0 * gamma, 10.0, 0.0).static_factor().unwrap();
        assert!((found - factor).abs() <= 0.055, "f_0({gamma}) = {found}, in the standard {factor}");
    }
}

/// NSK, Rolling Bearings, CAT. No. E1102: 19 500 N, 11 300 N, f_0 13.8; the balls are the known nine of 3/8 inch.
///
/// By hand: γ = 9.525/46 = 0.20707, f_c = 59.8 from the table, C_r = 1.3 · 59.8 · 9^(2/3) · 9.525^1.8 = 19 450 N;
/// C_0r = 13.8 · 9 · 9.525² = 11 270 N. With 2 kN radial and 1 kN axial F_a/(Z D²) = 1.2247 N/mm²:
/// Y = 1.55 − 0.10 · (1.2247 − 1.03)/0.35 = 1.4944, P = 0.56 · 2000 + 1.4944 · 1000 = 2614.4 N, L_10 = (19
/// 500/2614.4)³.
#[test]
fn paper_deep_groove_bearing_6206_by_hand_and_in_the_catalogue() {
    let b = bearing(9, 9.525, 46.0, 0.0);
    assert_close(b.dynamic_rating().unwrap(), 19_450.0, 1e-3);
    assert_close(b.dynamic_rating().unwrap(), 19_500.0, 4e-3);
    assert_close(b.static_rating().unwrap(), 11_300.0, 5e-3);
    assert_close(b.static_factor().unwrap(), 13.8, 4e-3);
    let equivalent = b.equivalent_load(2000.0, 1000.0).unwrap();
    assert_close(equivalent, 2614.4, 2e-5);
    assert_close(basic_life_mrev(19_500.0, equivalent).unwrap(), 414.94, 1e-4);
    // A light axial load does no harm.
    assert_eq!(b.equivalent_load(2000.0, 400.0).unwrap(), 2000.0);
    // P_0 = 0.6 · 2000 + 0.5 · 3000.
    assert_close(b.static_equivalent_load(2000.0, 3000.0).unwrap(), 2700.0, 1e-12);
    assert_eq!(b.static_equivalent_load(2000.0, 1000.0).unwrap(), 2000.0);
    assert_close(b.fatigue_load_limit(11_300.0).unwrap(), 513.6, 1e-4);
}

/// NSK, Rolling Bearings, CAT. No. E1102: 7210 B with 40°, 37 500 N and 28 600 N; fifteen balls of half an inch.
///
/// By hand: P = 0.35 · 3000 + 0.57 · 4500 = 3615 N, L_10 = (37 500/3615)³ = 1116.2; P_0 = 0.5 · 3000 + 0.26 · 9000.
#[test]
fn paper_angular_contact_bearing_7210_by_hand_and_in_the_catalogue() {
    let b = bearing(15, 12.7, 70.0, 40.0);
    assert_close(b.dynamic_rating().unwrap(), 37_500.0, 4e-3);
    assert_close(b.static_rating().unwrap(), 28_600.0, 4e-3);
    let equivalent = b.equivalent_load(3000.0, 4500.0).unwrap();
    assert_close(equivalent, 3615.0, 1e-12);
    assert_close(basic_life_mrev(37_500.0, equivalent).unwrap(), 1116.2, 1e-4);
    assert_eq!(b.equivalent_load(3000.0, 3400.0).unwrap(), 3000.0);
    assert_close(b.static_equivalent_load(3000.0, 9000.0).unwrap(), 3840.0, 1e-12);
}

/// Where F_a/F_r = e both branches of P meet, X + Y e = 1, as far as the table's two digits let them.
#[test]
fn identity_both_branches_of_the_equivalent_load_meet() {
    for angle in [0.0, 5.0, 7.0, 10.0, 12.0, 15.0, 18.0, 20.0, 27.0, 30.0, 40.0, 45.0] {
        let b = bearing(10, 10.0, 50.0, angle);
        for axial in [10.0, 172.0, 500.0, 1234.0, 3450.0, 9000.0] {
            let f = b.load_factors(axial).unwrap();
            let meet = f.radial + f.axial * f.limit;
            assert!((meet - 1.0).abs() < 0.025, "{angle}°, {axial} N: {meet}");
        }
    }
}

/// The table of ISO 281 ends at F_a/(Z D²) = 6.89: beyond it Y stays, and from 20° on there is nothing to leave.
#[test]
fn limit_axial_loads_beyond_the_table_are_told() {
    let groove = bearing(9, 9.525, 46.0, 0.0);
    let last = 6.89 * 9.0 * 9.525 * 9.525;
    assert_eq!(groove.beyond_table(0.999 * last), Ok(None));
    let [relative, end] = groove.beyond_table(2.0 * last).unwrap().unwrap();
    assert_close(relative, 2.0 * end, 1e-12);
    assert_eq!(groove.load_factors(2.0 * last).unwrap().axial, groove.load_factors(last).unwrap().axial);
    assert!(bearing(9, 9.525, 46.0, 15.0).beyond_table(2.0 * last).unwrap().is_some());
    for angle in [20.0, 40.0] {
        assert_eq!(bearing(9, 9.525, 46.0, angle).beyond_table(2.0 * last), Ok(None));
    }
}

/// Loads of balls spread over half the ring under a radial load of 1, Hertzian: (cos φ)^1.5.
fn half_loaded(count: usize, angle_deg: f64) -> (f64, Vec<f64>) {
    let azimuth = |j: usize| 2.0 * PI * j as f64 / count as f64;
    let loads: Vec<f64> = (0..count).map(|j| azimuth(j).cos().max(0.0).powf(1.5)).collect();
    let cos = angle_deg.to_radians().cos();
    let radial: f64 = loads.iter().enumerate().map(|(j, q)| q * azimuth(j).cos() * cos).sum();
    (radial, loads)
}

/// ISO 281 rests on the bearing that is half loaded: L_10r is then (C_r/F_r)³ up to the rounding of its constants,
/// whatever the contact angle. With cos α to any power but the first in Q_c it would not be.
#[test]
fn identity_reference_life_of_a_half_loaded_bearing_is_that_of_iso_281() {
    let ratio = |angle: f64| {
        let b = bearing(60, 0.2 * 100.0 / angle.to_radians().cos(), 100.0, angle);
        let (radial, loads) = half_loaded(60, angle);
        let loads = BallLoads { inner: &loads, outer: &loads, turning: Turning::Inner };
        let life = b.reference_life(1000.0, &loads).unwrap().life_mrev.unwrap();
        life * (radial / 1000.0).powi(3)
    };
    assert_close(ratio(0.0), 1.0, 0.05);
    assert_close(ratio(40.0), ratio(0.0), 1e-9);
}

#[test]
fn identity_twice_the_load_is_an_eighth_of_the_life() {
    let b = bearing(9, 9.525, 46.0, 0.0);
    let (_, loads) = half_loaded(9, 0.0);
    let double: Vec<f64> = loads.iter().map(|q| 2.0 * q).collect();
    let life = |q: &[f64], turning| b.reference_life(19_500.0, &BallLoads { inner: q, outer: q, turning }).unwrap();
    for turning in [Turning::Inner, Turning::Outer, Turning::Both] {
        let (one, two) = (life(&loads, turning), life(&double, turning));
        assert_close(two.life_mrev.unwrap() * 8.0, one.life_mrev.unwrap(), 1e-12);
        // P_ref gives the life back.
        assert_close((19_500.0 / one.equivalent_load).powi(3), one.life_mrev.unwrap(), 1e-12);
    }
    // A ring that stands under the load has the larger mean, and the inner race is the weaker one.
    let [inner, outer] = life(&loads, Turning::Inner).ball_loads;
    assert!(outer > inner);
    assert!(life(&loads, Turning::Outer).life_mrev < life(&loads, Turning::Inner).life_mrev);
    assert_eq!(life(&[0.0; 9], Turning::Inner).life_mrev, None);
}

#[test]
fn limit_the_modification_factor_lies_between_dirt_and_endurance() {
    let factor = |viscosity_ratio, contamination, ratio| {
        life_modification_factor(Lubrication { viscosity_ratio, contamination }, ratio, 1.0).unwrap()
    };
    assert_eq!(factor(2.0, 0.0, 1.0), 0.1);
    assert_eq!(factor(4.0, 1.0, 5.0), 50.0);
    assert_eq!(factor(4.0, 0.5, 0.2), factor(9.0, 0.5, 0.2));
    // κ = 1, e_C C_u/P = 0.1, by hand: 1 − 0.5684^0.83 · 0.1^(1/3) = 0.70958, 0.1 · 0.70958^−9.3 = 2.431.
    assert_close(factor(1.0, 0.5, 0.2), 2.431, 1e-3);
    // The three formulas meet at 0.4 and at 1.
    for kappa in [0.4f64, 1.0] {
        assert_close(factor(kappa * (1.0 - 1e-12), 0.6, 0.5), factor(kappa, 0.6, 0.5), 1e-3);
    }
    let rising: Vec<f64> = [0.1, 0.3, 0.5, 1.0, 2.0, 4.0].map(|kappa| factor(kappa, 0.6, 0.5)).into();
    assert!(rising.windows(2).all(|pair| pair[0] < pair[1]), "{rising:?}");
}

/// ISO 281:2007, table 12.
#[test]
fn paper_reliability_factors_of_the_standards_table() {
    for (percent, factor) in [(90.0, 1.0), (95.0, 0.64), (96.0, 0.55), (97.0, 0.47), (98.0, 0.37), (99.0, 0.25)] {
        let found = reliability_factor(percent).unwrap();
        assert!((found - factor).abs() <= 0.006, "a_1({percent} %) = {found}, in the standard {factor}");
    }
}

/// ν_1 = 4500 · 3000^−0.5 · 72.5^−0.5 = 9.649 mm²/s; 45000 · 500^−0.83 · 72.5^−0.5 = 30.39 mm²/s.
#[test]
fn identity_reference_viscosity_by_hand() {
    let at = |rpm: f64| reference_viscosity(rpm * PI / 30.0, 0.0725).unwrap();
    assert_close(at(3000.0), 9.649e-6, 1e-4);
    assert_close(at(500.0), 30.40e-6, 1e-3);
    // Ten hours at 1000 r/min are 0.6 million turns.
    assert_close(hours(0.6, 1000.0 * PI / 30.0).unwrap(), 10.0, 1e-12);
    assert_eq!(hours(0.6, 0.0), None);
}

#[test]
fn limit_wider_grooves_lower_the_ratings_and_closer_ones_earn_nothing() {
    let usual = bearing(9, 9.525, 46.0, 0.0);
    let with = |inner_coefficient, outer_coefficient| RatedBearing { inner_coefficient, outer_coefficient, ..usual };
    let ratings = |b: RatedBearing| [b.dynamic_rating().unwrap(), b.static_rating().unwrap()];
    assert_eq!(ratings(with(0.515, 0.52)), ratings(usual));
    let wide = ratings(with(0.54, 0.54));
    assert!(wide[0] < 0.9 * ratings(usual)[0] && wide[1] < 0.9 * ratings(usual)[1], "{wide:?}");
}

#[test]
fn limit_what_the_standards_do_not_rate_is_refused() {
    let usual = bearing(9, 9.525, 46.0, 0.0);
    let refused = |b: RatedBearing| b.dynamic_rating().unwrap_err();
    assert!(matches!(refused(bearing(9, 9.5, 46.0, 50.0)), RatingError::ContactAngle { .. }));
    assert!(matches!(refused(bearing(9, 50.0, 46.0, 0.0)), RatingError::Ratio { .. }));
    assert!(matches!(refused(bearing(0, 9.5, 46.0, 0.0)), RatingError::Dimension { .. }));
    assert!(matches!(refused(RatedBearing { inner_coefficient: 0.5, ..usual }), RatingError::Groove { .. }));
    assert!(matches!(usual.equivalent_load(-1.0, 0.0), Err(RatingError::Load { .. })));
    let loads = BallLoads { inner: &[1.0; 9], outer: &[1.0; 8], turning: Turning::of_speeds(0.0, 0.0) };
    assert!(matches!(usual.reference_life(1e4, &loads), Err(RatingError::Count { found: 8, expected: 9, .. })));
    let film = |viscosity_ratio, contamination| {
        life_modification_factor(Lubrication { viscosity_ratio, contamination }, 1.0, 1.0)
    };
    assert!(matches!(film(0.05, 0.5), Err(RatingError::ViscosityRatio { .. })));
    assert!(matches!(film(1.0, 1.5), Err(RatingError::Contamination { .. })));
    assert!(reliability_factor(80.0).is_err());
}
