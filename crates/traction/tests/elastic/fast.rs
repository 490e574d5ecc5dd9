//! The march in vector lanes against the plain one, and its derivatives against dual numbers.

use crate::contacts::{BALL_RADIUS, Contact, SCALES, contacts, silver};
use crate::steel;
use num_dual::Dual64;
use proptest::prelude::*;
use tribodyn_traction::{
    CoatingLaw, Fastsim, FastsimRule, Kragelskii, Patch, PatchLaw, PatchTraction, PressureChoice, RelativeMotion,
    SlipUnit, TractionLaw, elastic_patch_traction, fast_elastic_patch_traction, linear_elastic_patch_traction,
};

const RULES: [FastsimRule; 5] = [
    FastsimRule { across: 8, cells: 12 },
    FastsimRule { across: 5, cells: 7 },
    FastsimRule { across: 1, cells: 2 },
    FastsimRule { across: 3, cells: 3 },
    FastsimRule { across: 20, cells: 33 },
];

fn parts(t: &PatchTraction) -> [f64; 7] {
    let PatchTraction { force_rolling, force_lateral, moment_lateral, moment_normal, moment_rolling, .. } = *t;
    [force_rolling, force_lateral, moment_normal, moment_lateral, moment_rolling, t.power, t.wear_integral]
}

/// Largest difference over load, load times radius, and power.
fn difference(contact: &Contact, ours: &PatchTraction, plain: &PatchTraction) -> f64 {
    let load = contact.load();
    let sizes = [1.0, 1.0, contact.patch.semi_lateral, BALL_RADIUS, BALL_RADIUS].map(|arm| 0.1 * load * arm);
    let [.., power, wear] = parts(plain);
    let sizes = sizes.into_iter().chain([power, wear].map(|size| size.max(1e-100)));
    parts(ours).into_iter().zip(parts(plain)).zip(sizes).fold(0.0, |worst: f64, ((a, b), size)| {
        let d = ((a - b) / size).abs();
        if d.is_nan() { f64::INFINITY } else { worst.max(d) }
    })
}

fn compare(grid: &Fastsim, contact: &Contact, law: &PatchLaw<'_, CoatingLaw>) -> f64 {
    let (patch, motion, v) = (&contact.patch, &contact.motion, contact.rolling_speed);
    let plain = elastic_patch_traction(patch, motion, v, law, &steel(), grid);
    difference(contact, &fast_elastic_patch_traction(grid, patch, motion, v, law, &steel()), &plain)
}

#[test]
fn identity_fast_equals_plain_on_solved_contacts() {
    let law = silver();
    for rule in RULES {
        let grid = Fastsim::new(rule).unwrap();
        let mut worst = 0.0f64;
        for contact in SCALES.into_iter().flat_map(contacts) {
            for unit in [contact.law(&law).slip_unit, SlipUnit::PercentOfRolling] {
                let law = PatchLaw { slip_unit: unit, ..contact.law(&law) };
                worst = worst.max(compare(&grid, &contact, &law));
            }
        }
        println!("{rule:?}: {worst:.1e}");
        assert!(worst < 1e-12, "{rule:?}: {worst:e}");
    }
}

#[test]
fn identity_first_order_numbers_carry_the_closed_derivatives() {
    let (law, grid) = (silver(), Fastsim::new(RULES[0]).unwrap());
    for contact in contacts(22.0) {
        let m = contact.motion;
        let real = Dual64::from;
        let p = &contact.patch;
        let patch = Patch {
            semi_lateral: real(p.semi_lateral),
            semi_rolling: real(p.semi_rolling),
            peak_pressure: real(p.peak_pressure),
            ball_radius: p.ball_radius,
            surface_radius: p.surface_radius,
        };
        let motion = RelativeMotion {
            rolling: real(m.rolling),
            lateral: real(m.lateral),
            spin: Dual64::new(m.spin, 1.0),
            about_lateral: real(m.about_lateral),
            about_rolling: real(m.about_rolling),
        };
        let v = contact.rolling_speed;
        let t = linear_elastic_patch_traction(&grid, &patch, &motion, real(v), &contact.law(&law), &steel());
        let curves = (
            &law.kragelskii(p.peak_pressure).unwrap(),
            &law.kragelskii_slope(p.peak_pressure).unwrap(),
            contact.law(&law).slip_unit,
        );
        let d = grid.derivative(p, &m, v, curves, &steel());
        let forces = [t.force_rolling, t.force_lateral, t.moment_normal, t.moment_lateral, t.moment_rolling];
        for (ours, row) in forces.into_iter().zip(d.by_motion) {
            assert_eq!(ours.eps, row[2]);
        }
        assert_eq!(t.force_lateral.re, d.traction.force_lateral);
    }
}

#[test]
fn identity_other_pressures_take_the_plain_way() {
    let (law, grid) = (silver(), Fastsim::new(RULES[1]).unwrap());
    let contact = contacts(22.0).remove(0);
    let local = PatchLaw { pressure: PressureChoice::Local, ..contact.law(&law) };
    assert_eq!(compare(&grid, &contact, &local), 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(13),
        ..ProptestConfig::with_cases(2_000)
    })]

    #[test]
    fn identity_fast_equals_plain_on_scattered_contacts(
        motion in proptest::array::uniform5(-1.0..1.0f64),
        sizes in proptest::array::uniform5(-5.0..0.5f64),
        pressure in 0.5e9..3.5e9f64,
        ratio in 0.05..2.0f64,
        log_scale in -1.0..3.0f64,
        speed in -80.0..80.0f64,
        rule in 0..RULES.len(),
    ) {
        let law = silver();
        let [rolling, lateral, spin, about_lateral, about_rolling] =
            std::array::from_fn(|i| motion[i] * 10f64.powf(sizes[i]) * [1.0, 1.0, 500.0, 30.0, 30.0][i]);
        let mut contact = contacts(22.0).remove(0);
        contact.motion = RelativeMotion { rolling, lateral, spin, about_lateral, about_rolling };
        contact.rolling_speed = speed;
        contact.patch.peak_pressure = pressure;
        contact.patch.semi_rolling = ratio * contact.patch.semi_lateral;
        contact.scale = 10f64.powf(log_scale);
        let d = compare(&Fastsim::new(RULES[rule]).unwrap(), &contact, &contact.law(&law));
        prop_assert!(d < 1e-12, "{:?} {d:e}", RULES[rule]);
    }
}

/// Derivatives of the plain march by dual numbers over (motion, load, rolling speed), strips moving along.
fn dual(contact: &Contact, law: &PatchLaw<'_, CoatingLaw>, grid: &Fastsim, input: usize) -> [f64; 7] {
    let eps = |k: usize| if k == input { 1.0 } else { 0.0 };
    let (m, p) = (&contact.motion, &contact.patch);
    // Semi-axes and pressure grow with the cube root of the load.
    let growth = Dual64::new(1.0, eps(5) / (3.0 * contact.load()));
    let motion = RelativeMotion {
        rolling: Dual64::new(m.rolling, eps(0)),
        lateral: Dual64::new(m.lateral, eps(1)),
        spin: Dual64::new(m.spin, eps(2)),
        about_lateral: Dual64::new(m.about_lateral, eps(3)),
        about_rolling: Dual64::new(m.about_rolling, eps(4)),
    };
    let patch = Patch {
        semi_lateral: growth * p.semi_lateral,
        semi_rolling: growth * p.semi_rolling,
        peak_pressure: growth * p.peak_pressure,
        ball_radius: p.ball_radius,
        surface_radius: p.surface_radius,
    };
    let v = Dual64::new(contact.rolling_speed, eps(6));
    let t = elastic_patch_traction(&patch, &motion, v, law, &steel(), grid);
    [t.force_rolling, t.force_lateral, t.moment_normal, t.moment_lateral, t.moment_rolling, t.power, t.wear_integral]
        .map(|x| x.eps)
}

/// Largest difference between closed and dual derivatives, over the size of the change.
fn derivative_error(contact: &Contact, unit: SlipUnit, grid: &Fastsim) -> f64 {
    let law = silver();
    let patch_law = PatchLaw { slip_unit: unit, ..contact.law(&law) };
    let pressure = contact.patch.peak_pressure;
    let curves = (&law.kragelskii(pressure).unwrap(), &law.kragelskii_slope(pressure).unwrap(), unit);
    let d = grid.derivative(&contact.patch, &contact.motion, contact.rolling_speed, curves, &steel());
    let duals: [[f64; 7]; 7] = std::array::from_fn(|input| dual(contact, &patch_law, grid, input));
    let (load, speed) = (parts(&d.by_load), parts(&d.by_rolling_speed));
    let mut worst = 0.0f64;
    for row in 0..7 {
        for input in if row < 5 { 0..7 } else { 5..7 } {
            let ours = match input {
                0..=4 => d.by_motion[row][input],
                5 => load[row],
                _ => speed[row],
            };
            let size = duals[input][row].abs().max(1e-2 * row_size(&duals, row, input));
            let error = (ours - duals[input][row]).abs() / size;
            worst = worst.max(error);
        }
    }
    worst
}

/// A contact that slips at `shift` on either side of the groove, with a share of its spin.
fn sliding(contact: &Contact, shift: f64, spin: f64) -> Contact {
    let mut contact = contact.clone();
    contact.motion.spin *= spin;
    contact.motion.about_lateral = 0.0;
    contact.motion.rolling = shift;
    contact
}

#[test]
fn identity_closed_derivatives_equal_dual_numbers_where_the_strips_stay() {
    for contact in SCALES.into_iter().flat_map(contacts) {
        for shift in [1.5, -0.9] {
            // The longitudinal slip is the same everywhere and has no zero that strips could follow.
            let contact = sliding(&contact, shift, 0.0);
            for (unit, rule) in [(contact.law(&()).slip_unit, RULES[0]), (SlipUnit::PercentOfRolling, RULES[1])] {
                let error = derivative_error(&contact, unit, &Fastsim::new(rule).unwrap());
                assert!(error < 1e-7, "{} {} {unit:?}: {error:e}", contact.scale, contact.name);
            }
        }
    }
}

#[test]
fn identity_closed_derivatives_equal_dual_numbers_where_strips_hardly_move() {
    for contact in contacts(1.0) {
        for shift in [1.5, -0.9] {
            // Zeros of the longitudinal slip far outside of the patch, and so many strips that where they stand is all
            // the same; nothing slips at the peak of the curve.
            let contact = sliding(&contact, shift, 0.1);
            let grid = Fastsim::new(FastsimRule { across: 40, cells: 12 }).unwrap();
            let error = derivative_error(&contact, contact.law(&()).slip_unit, &grid);
            assert!(error < 1e-7, "{} {}: {error:e}", contact.scale, contact.name);
        }
    }
}

#[test]
fn identity_closed_derivatives_approach_dual_numbers_on_solved_contacts() {
    // The closed form holds the strips fast: it agrees as well as the rule integrates the derivative, which has sharp
    // ridges where the slip passes the peak of a curve as steep as that at 100 per m/s.
    let of = |across| Fastsim::new(FastsimRule { across, cells: 12 }).unwrap();
    for (scale, most) in [(1.0, 1e-3), (5.0, 1e-2), (22.0, 3e-2)] {
        for contact in contacts(scale) {
            let unit = contact.law(&()).slip_unit;
            let [coarse, fine] = [20, 320].map(|across| derivative_error(&contact, unit, &of(across)));
            assert!(
                fine < most && (fine < 0.5 * coarse || fine < 1e-5),
                "{scale} {}: {coarse:e} {fine:e}",
                contact.name
            );
            assert!(derivative_error(&contact, SlipUnit::PercentOfRolling, &of(320)) < 1e-3);
        }
    }
}

/// Size of an output's change by an input, from the output's changes by the others.
fn row_size(duals: &[[f64; 7]; 7], row: usize, input: usize) -> f64 {
    const INPUT: [f64; 7] = [0.1, 0.1, 100.0, 10.0, 10.0, 1e3, 60.0];
    (0..7).map(|k| duals[k][row].abs() * INPUT[k] / INPUT[input]).fold(0.0, f64::max)
}

#[test]
fn identity_derivatives_carry_the_values() {
    let law = silver();
    let grid = Fastsim::new(RULES[0]).unwrap();
    for contact in SCALES.into_iter().flat_map(contacts) {
        let pressure = contact.patch.peak_pressure;
        let unit = contact.law(&law).slip_unit;
        let (curve, slope): (Kragelskii, Kragelskii) =
            (law.kragelskii(pressure).unwrap(), law.kragelskii_slope(pressure).unwrap());
        let (patch, motion, v) = (&contact.patch, &contact.motion, contact.rolling_speed);
        let values = grid.traction(patch, motion, v, (&curve, unit), &steel());
        let with = grid.derivative(patch, motion, v, (&curve, &slope, unit), &steel());
        assert!(difference(&contact, &with.traction, &values) < 1e-13);
    }
}
