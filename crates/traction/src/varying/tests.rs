//! Limits and published figures of the laws over pressure.

use super::*;

fn close(a: f64, b: f64, relative: f64) -> bool {
    (a - b).abs() <= relative * b.abs()
}

#[test]
fn paper_table_2_comes_back_at_the_test_pressures() {
    for name in crate::coating_names() {
        let coating = Coating::library(name).unwrap();
        let law = CoatingLaw::varying(&coating, 2).unwrap();
        for test in &coating.tested {
            let published = Kragelskii::from_peak(test.peak).unwrap();
            let ours = law.at(test.pressure);
            for (x, y) in [(ours.a, published.a), (ours.b, published.b), (ours.c, published.c)] {
                assert!(close(x, y, 1e-12), "{name}: {x} against {y}");
            }
        }
    }
}

#[test]
fn identity_series_equals_inversion_with_its_derivative() {
    for (name, order) in [("ag", 2), ("ag", 1), ("ptfe", 2), ("ptfe", 1), ("ag", 0)] {
        let law = CoatingLaw::varying(&Coating::library(name).unwrap(), order).unwrap();
        for i in 0..=97 {
            let p = Dual64::from(1.5e9 + 2.5e9 * f64::from(i) / 97.0).derivative();
            let (fast, plain) = (law.at(p), law.at_by_inversion(p).unwrap());
            for (x, y) in [(fast.a, plain.a), (fast.b, plain.b), (fast.c, plain.c)] {
                assert!(close(x.re, y.re, 1e-13), "{name} {order}: {} {}", x.re, y.re);
                assert!((x.eps - y.eps).abs() < 1e-8 * (y.re * 1e-9).abs(), "{} {}", x.eps, y.eps);
            }
            let (value, slope) = (law.kragelskii(p.re).unwrap(), law.kragelskii_slope(p.re).unwrap());
            for (v, s, y) in [(value.a, slope.a, fast.a), (value.b, slope.b, fast.b), (value.c, slope.c, fast.c)] {
                assert!(close(v, y.re, 1e-13), "{name} {order}: {v} {}", y.re);
                assert!((s - y.eps).abs() < 1e-10 * (y.re * 1e-9).abs(), "{name} {order}: {s} {}", y.eps);
            }
        }
    }
}

#[test]
fn limit_outside_the_range_is_clamped_and_reported() {
    let law = CoatingLaw::varying(&Coating::library("ag").unwrap(), 2).unwrap();
    assert!(law.clamps(1.4e9) && law.clamps(4.1e9) && !law.clamps(2.0e9));
    assert_eq!(law.at(1.0e9), law.at(1.4e9));
    let fixed = CoatingLaw::fixed(&Coating::library("ag").unwrap(), 2, 2.5e9).unwrap();
    assert_eq!(fixed.at(1.0e9), fixed.at(3.0e9));
    assert!(!fixed.clamps(1.0e9));
}

/// Between following the pressure and standing still there is neither a jump nor a bend; tested pressures are
/// followed to the last bit, those far outside stand still.
#[test]
fn limit_a_law_ends_without_a_bend() {
    let points = |pressures: [f64; 3]| {
        let paper = Coating::library("ag").unwrap().tested;
        let tested = pressures.iter().zip(paper).map(|(&pressure, test)| crate::TestedCurve { pressure, ..test });
        Coating::from_tests("own", tested.collect()).unwrap()
    };
    for coating in [Coating::library("ag").unwrap(), Coating::library("ptfe").unwrap(), points([1e9, 1.5e9, 2e9])] {
        let law = CoatingLaw::varying(&coating, 2).unwrap();
        let [first, last] = [coating.tested[0].pressure, coating.tested[2].pressure];
        for share in [0.0, 0.13, 0.5, 0.9, 1.0] {
            let p = first + share * (last - first);
            assert_eq!(law.ends.within(p), p);
        }
        let [low, high] = coating.valid_pressure;
        assert_eq!(law.at(0.5 * low), law.at(0.9 * low));
        assert_eq!(law.at(2.0 * high), law.at(1.1 * high));
        let step = 1e5;
        // A difference across the end of the band, where the slope begins to grow by 1e-10 per Pa over its width.
        let ending = 0.125 * step * 1e-10 / (ENDING * (high - low));
        let mut slopes: Vec<f64> = Vec::new();
        let mut p = 0.95 * low;
        while p < 1.05 * high {
            let slope = law.kragelskii_slope(p).unwrap();
            let central =
                (law.kragelskii(p + 0.5 * step).unwrap().a - law.kragelskii(p - 0.5 * step).unwrap().a) / step;
            assert!((slope.a - central).abs() < 1e-3 * slope.a.abs() + ending, "{p}: {} {central}", slope.a);
            slopes.push(slope.a);
            p += 1e6;
        }
        // Over a hundredth of the range a slope of up to 1e-10 per Pa comes down to nothing.
        let steepest = slopes.iter().fold(0f64, |most, slope| most.max(slope.abs()));
        let most = steepest * 1e6 / (ENDING * (high - low));
        assert!(slopes.windows(2).all(|pair| (pair[1] - pair[0]).abs() < most), "a bend");
    }
}

#[test]
fn limit_order_beyond_the_tests_is_refused() {
    let error = CoatingLaw::varying(&Coating::library("ag").unwrap(), 3).unwrap_err();
    assert!(matches!(error, TractionError::TooFewTests { order: 3, count: 3, needed: 4 }));
}

#[test]
fn limit_least_squares_line_passes_through_the_mean() {
    let fit = PressureFit::new(&Coating::library("ag").unwrap(), 1).unwrap();
    // Equispaced pressures: the least-squares line takes the mean value at the middle one.
    assert!(close(fit.peak(3.0e9).residual, (0.124 + 0.116 + 0.102) / 3.0, 1e-13));
}

#[test]
fn paper_parabolas_are_not_monotone_below_the_tests() {
    // K of Ag peaks at 2.08 GPa, K_m of PTFE at 2.2 GPa: the reason why the order is an input.
    let slope = |name: &str, pick: fn(Peak<Dual64>) -> Dual64, p: f64| {
        let fit = PressureFit::new(&Coating::library(name).unwrap(), 2).unwrap();
        pick(fit.peak(Dual64::from(p).derivative())).eps
    };
    assert!(slope("ag", |p| p.residual, 2.07e9) > 0.0 && slope("ag", |p| p.residual, 2.09e9) < 0.0);
    assert!(slope("ptfe", |p| p.coefficient, 2.2e9) > 0.0 && slope("ptfe", |p| p.coefficient, 2.3e9) < 0.0);
}
