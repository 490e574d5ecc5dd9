//! Films in the vector kernel against the plain integral, values and slopes.

use crate::film::tests::{EYRING, contact, law, rule};
use crate::{FastPatch, FilmShear, MovingPatch, Patch, PatchRule, PatchTraction, RelativeMotion};
use num_dual::{Derivative, DualNum, DualSVec64};

/// Motion, load and rolling speed.
type Dual = DualSVec64<7>;

fn seeded(at: &MovingPatch) -> MovingPatch<Dual> {
    let seed = |value: f64, input: usize| {
        Dual::new(value, Derivative::derivative_generic(nalgebra::Const, nalgebra::U1, input))
    };
    let m = at.motion;
    let load = seed(at.load(), 5);
    let grown = (load / load.re).powf(1.0 / 3.0);
    MovingPatch {
        patch: Patch {
            semi_lateral: grown * at.patch.semi_lateral,
            semi_rolling: grown * at.patch.semi_rolling,
            peak_pressure: grown * at.patch.peak_pressure,
            ball_radius: at.patch.ball_radius,
            surface_radius: at.patch.surface_radius,
        },
        motion: RelativeMotion {
            rolling: seed(m.rolling, 0),
            lateral: seed(m.lateral, 1),
            spin: seed(m.spin, 2),
            about_lateral: seed(m.about_lateral, 3),
            about_rolling: seed(m.about_rolling, 4),
        },
        rolling_speed: seed(at.rolling_speed, 6),
    }
}

/// Closed-form derivatives equal those on dual numbers, whose temperature is differentiated through its fixed point.
#[test]
fn identity_derivatives_equal_dual_numbers() {
    let quadrature = rule(8, 12);
    for (shear, rough) in [(FilmShear::LimitingShear, 0.07e-6), (EYRING, 0.07e-6), (EYRING, 0.6e-6)] {
        let mut law = law(shear);
        law.inlet.roughness = rough;
        for (slip, spin, reversed) in [(0.02, 20.0, 1.0), (-0.5, 150.0, 1.0), (2.0, -400.0, 1.0), (0.03, 5.0, -1.0)] {
            let mut at = contact(slip, spin);
            at.rolling_speed *= reversed;
            let expected = law.traction(&seeded(&at), &quadrature);
            let found = law.derivative(&at, &FastPatch::of(quadrature.clone()));
            let rows = |t: &PatchTraction<Dual>| {
                [t.force_rolling, t.force_lateral, t.moment_normal, t.moment_lateral, t.moment_rolling, t.power]
            };
            let plain = |t: &PatchTraction| {
                [t.force_rolling, t.force_lateral, t.moment_normal, t.moment_lateral, t.moment_rolling, t.power]
            };
            let (values, by_load) = (plain(&found.traction), plain(&found.by_load));
            let by_speed = plain(&found.by_rolling_speed);
            for (row, dual) in rows(&expected).iter().enumerate() {
                let slopes = dual.eps.unwrap_generic(nalgebra::Const, nalgebra::U1);
                let close = |found: f64, expected: f64, allowed: f64| {
                    assert!((found - expected).abs() <= allowed, "{shear:?} {slip} row {row}: {found} {expected}");
                };
                // The film may be 3e-4 K from where its slopes are taken.
                let size = 1e-5 * slopes.iter().fold(0.0f64, |size, slope| size.max(slope.abs()));
                close(values[row], dual.re, 1e-10 * dual.re.abs() + 1e-12);
                if row < 5 {
                    (0..5).for_each(|input| close(found.by_motion[row][input], slopes[input], size));
                }
                close(by_load[row], slopes[5], size);
                close(by_speed[row], slopes[6], size);
            }
            let wear = expected.wear_integral.eps.unwrap_generic(nalgebra::Const, nalgebra::U1);
            assert!((found.by_load.wear_integral / wear[5] - 1.0).abs() < 1e-9);
        }
    }
}

/// Eight nodes at a time make what one after the other makes, in films cold and hot, at rest and fast.
#[test]
fn identity_the_vector_kernel_is_the_plain_integral() {
    for shear in [FilmShear::LimitingShear, EYRING] {
        for rough in [0.02e-6, 0.6e-6] {
            let mut law = law(shear);
            law.inlet.roughness = rough;
            for (slip, spin) in [(0.0, 0.0), (1e-7, 0.0), (1e-3, 2.0), (0.05, 40.0), (-1.0, 300.0), (12.0, -900.0)] {
                for rule in
                    [PatchRule::SplitStrip { across: 8, along: 5 }, PatchRule::GaussJacobi { radial: 5, angles: 12 }]
                {
                    let contact = contact(slip, spin);
                    let fast = FastPatch::new(rule).unwrap();
                    let plain = law.value(&contact, fast.quadrature());
                    let found = law.fast_value(&contact, &fast);
                    let with_slopes = law.derivative(&contact, &fast).traction;
                    let rows = |t: &PatchTraction| {
                        let r = contact.patch.ball_radius;
                        let moments = [t.moment_normal, t.moment_lateral, t.moment_rolling].map(|moment| moment / r);
                        [t.force_rolling, t.force_lateral, moments[0], moments[1], moments[2]]
                    };
                    let size = rows(&plain).iter().fold(0.0f64, |size, row| size.max(row.abs()));
                    for found in [&found, &with_slopes] {
                        for (found, plain) in rows(found).iter().zip(rows(&plain)) {
                            assert!(
                                (found - plain).abs() < 1e-10 * size,
                                "{shear:?} {slip} {spin} {rule:?}: {found} {plain}"
                            );
                        }
                        assert!((found.power / plain.power - 1.0).abs() < 1e-10, "{} {}", found.power, plain.power);
                        assert!((found.wear_integral - plain.wear_integral).abs() < 1e-12 * plain.wear_integral);
                    }
                }
            }
        }
    }
}
