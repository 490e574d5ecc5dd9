//! Classes against published tables, and against the formulas of the standard.

use super::grades::{F, FINE_SIZES, G, K, M, N, P, R, SIZES, standard};
use super::{FitError, Interference, RingClass, SeatClass, Within, effective_interference};
use crate::Side;

const TABLE: &str = include_str!("../../../../fixtures/reference/skf-fits/resultant-fits.csv");

fn microns(value: f64) -> f64 {
    (value * 1e8).round() / 100.0
}

/// All of SKF's rows: deviations of seats and theoretical fits exactly, probable ones to 1 µm, by how they are printed.
#[test]
fn paper_resultant_fits_of_skf() {
    let mut count = 0;
    for line in TABLE.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |k: usize| cells[k].parse::<f64>().ok();
        let seat = SeatClass::parse(cells[3]).unwrap();
        assert_eq!(seat.to_string(), cells[3]);
        // Just above the lower end of the range, and at its upper end.
        for millimetres in [number(0).unwrap() + 0.1, number(1).unwrap()] {
            let diameter = 1e-3 * millimetres;
            let ring = RingClass::Normal.deviations(seat.side(), diameter).unwrap();
            assert_eq!(Some(microns(ring.low)), number(2), "{line}");
            let on_seat = seat.deviations(diameter).unwrap();
            assert_eq!((Some(microns(on_seat.low)), Some(microns(on_seat.high))), (number(4), number(5)), "{line}");
            let found = Interference::of(seat, RingClass::Normal, diameter).unwrap();
            assert_eq!(
                (Some(-microns(found.tightest)), Some(-microns(found.loosest))),
                (number(6), number(7)),
                "{line}"
            );
            let middle = 0.5 * (found.tightest + found.loosest);
            assert!((found.mean - middle).abs() < 1e-12);
            for (likely, printed) in [(found.likely[1], number(8)), (found.likely[0], number(9))] {
                let off = printed.map_or(0.0, |printed| (-1e6 * likely - printed).abs());
                assert!(off <= 1.5, "{line}: {likely}");
            }
        }
        count += 1;
    }
    assert_eq!(count, 356);
}

/// Middle of a range of sizes as ISO 286-1 takes it: the geometric mean of its ends, of 1 and 3 mm for the first.
fn middle(ends: &[f64], at: usize) -> f64 {
    let low = if at == 0 { 1.0 } else { ends[at - 1] };
    (low * ends[at]).sqrt()
}

/// Standard tolerances are multiples of i = 0.45 D^(1/3) + 0.001 D µm, IT5 7 i to IT10 64 i, rounded by the standard;
/// up to 3 mm its table departs from the formulas.
#[test]
fn paper_standard_tolerances_by_the_formula_of_iso_286() {
    for at in 1..SIZES.len() {
        let size = middle(&SIZES, at);
        let unit = 0.45 * size.cbrt() + 0.001 * size;
        for (grade, multiple) in [(5, 7.0), (6, 10.0), (7, 16.0), (8, 25.0), (9, 40.0), (10, 64.0)] {
            let (table, formula) = (standard(grade, at), multiple * unit);
            assert!((table - formula).abs() <= 0.6 + 0.02 * formula, "IT{grade} at {size} mm: {table} {formula}");
        }
        // Between IT1 and IT5 in geometric progression.
        let first = 0.8 + 0.02 * size;
        let step = (7.0 * unit / first).powf(0.25);
        for (grade, power) in [(3, 2), (4, 3)] {
            let formula = first * step.powi(power);
            assert!((standard(grade, at) - formula).abs() <= 0.5 + 0.1 * formula, "IT{grade} at {size} mm: {formula}");
        }
    }
}

/// Fundamental deviations of shafts by the formulas of ISO 286-1, to the rounding of its table.
#[test]
fn paper_fundamental_deviations_by_the_formulas_of_iso_286() {
    for at in 1..SIZES.len() {
        let size = middle(&SIZES, at);
        let close = |table: f64, formula: f64, letter: &str| {
            assert!((table - formula).abs() <= 1.0 + 0.03 * formula, "{letter} at {size} mm: {table} {formula}");
        };
        close(F[at], 5.5 * size.powf(0.41), "f");
        close(G[at], 2.5 * size.powf(0.34), "g");
        close(K[at], 0.6 * size.cbrt(), "k");
        close(N[at], 5.0 * size.powf(0.34), "n");
        // m stands as much below as IT7 is above IT6; p is IT7 and up to 5 µm more.
        assert_eq!(M[at], standard(7, at) - standard(6, at), "m at {size} mm");
        assert!((0.0..=5.0).contains(&(P[at] - standard(7, at))), "p at {size} mm");
    }
    // r is the geometric mean of p and s; s is IT8 and 1 to 4 µm up to 50 mm, IT7 + 0.4 D above.
    for (fine, end) in FINE_SIZES.into_iter().enumerate() {
        let at = SIZES.iter().position(|size| end <= *size).unwrap();
        let size = middle(&FINE_SIZES, fine);
        let s = if end <= 50.0 { standard(8, at) + 2.5 } else { standard(7, at) + 0.4 * size };
        let formula = (P[at] * s).sqrt();
        assert!((R[fine] - formula).abs() <= 1.0 + 0.03 * formula, "r up to {end} mm: {} {formula}", R[fine]);
    }
}

/// H and K, M, N, P, R of one grade fit like the shafts of the finer grade with h: the rule of Δ.
#[test]
fn identity_a_hole_mirrors_the_shaft_of_the_finer_grade() {
    for (hole, shaft) in [("K7", "k6"), ("N7", "n6"), ("P7", "p6"), ("R7", "r6"), ("M7", "m6"), ("K6", "k5")] {
        for millimetres in [5.0, 25.0, 47.0, 72.0, 110.0, 150.0, 300.0, 450.0] {
            let of = |class: &str| SeatClass::parse(class).unwrap().deviations(1e-3 * millimetres).unwrap();
            let same_grade = |class: &str| of(&format!("{class}{}", &hole[1..]));
            let finer = |class: &str| of(&format!("{class}{}", &shaft[1..]));
            let basic_hole = of(shaft).high - same_grade("H").low;
            let basic_shaft = finer("h").high - of(hole).low;
            assert!((basic_hole - basic_shaft).abs() < 1e-12, "{hole} at {millimetres} mm");
        }
    }
}

/// Tolerances of the classes P6, P5, P4 and P2 where two sources print them, and a drawn example of NKE: a shaft 75 j5
/// gives 21 µm of interference to 7 µm of play.
#[test]
fn paper_rings_of_iso_492_and_an_example_of_nke() {
    for (class, side, millimetres, low) in [
        (RingClass::P6, Side::Inner, 25.0, 8.0),
        (RingClass::P6, Side::Inner, 150.0, 18.0),
        (RingClass::P6, Side::Outer, 62.0, 11.0),
        (RingClass::P5, Side::Inner, 30.0, 6.0),
        (RingClass::P5, Side::Outer, 110.0, 10.0),
        (RingClass::P5, Side::Outer, 160.0, 13.0),
        (RingClass::P4, Side::Inner, 60.0, 7.0),
        (RingClass::P4, Side::Outer, 95.0, 8.0),
        (RingClass::P2, Side::Inner, 60.0, 4.0),
        (RingClass::P2, Side::Outer, 95.0, 5.0),
    ] {
        let found = class.deviations(side, 1e-3 * millimetres).unwrap();
        assert_eq!((microns(found.low), found.high), (-low, 0.0), "{class:?} {side:?} {millimetres}");
    }
    let found = Interference::of(SeatClass::parse("j5").unwrap(), RingClass::Normal, 75e-3).unwrap();
    assert_eq!((microns(found.tightest), microns(found.loosest)), (21.0, -7.0));
    // Better classes are within the coarser ones.
    for pair in RingClass::ALL.windows(2) {
        for (side, millimetres) in
            [(Side::Inner, 20.0), (Side::Inner, 100.0), (Side::Outer, 47.0), (Side::Outer, 180.0)]
        {
            let of = |class: RingClass| class.deviations(side, 1e-3 * millimetres).unwrap().low;
            assert!(of(pair[0]) < of(pair[1]));
        }
    }
}

#[test]
fn limit_smoothing_takes_interference_and_leaves_play() {
    assert!((effective_interference(20e-6, 6.3e-6) - 17.48e-6).abs() < 1e-12);
    assert_eq!(effective_interference(1e-6, 6.3e-6), 0.0);
    assert_eq!(effective_interference(-5e-6, 6.3e-6), -5e-6);
    let fit = Interference::of(SeatClass::parse("m6").unwrap(), RingClass::Normal, 40e-3).unwrap();
    let by_size = [Within::Loosest, Within::LikelyLoosest, Within::Mean, Within::LikelyTightest, Within::Tightest];
    assert!(by_size.windows(2).all(|pair| fit.within(pair[0]) < fit.within(pair[1])));
}

#[test]
fn limit_classes_that_seats_do_not_have_are_refused() {
    for text in ["", "k", "5", "k5k", "Kk5", "K3", "k11", "j8", "J5", "j4", "zc7", "q6", "h3", "k5 H7", "κ5"] {
        let error = SeatClass::parse(text).unwrap_err();
        assert!(matches!(error, FitError::Class { .. }) && error.to_string().contains("such as H7"), "{text}: {error}");
    }
    assert_eq!(SeatClass::parse(" js5 ").unwrap().side(), Side::Inner);
    let far = SeatClass::parse("h6").unwrap().deviations(0.6).unwrap_err().to_string();
    assert!(far.contains("600 mm") && far.contains("500 mm"), "{far}");
    let precise = RingClass::P2.deviations(Side::Inner, 0.2).unwrap_err().to_string();
    assert!(precise.contains("P2") && precise.contains("180 mm"), "{precise}");
}
