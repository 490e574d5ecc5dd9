//! The slip field against the published equations, and what symmetry and energy demand of the integrals.

use crate::COARSE;
use crate::contacts::{BALL_RADIUS, SCALES, contacts, silver};
use tribodyn_traction::{
    Patch, PatchTraction, PressureChoice, Quadrature, RelativeMotion, SlipField, SlipUnit, patch_traction,
};

#[test]
fn paper_eq_3_slip_without_curvature_and_differential_slip() {
    for contact in contacts(22.0) {
        let (mut patch, motion, v) = (contact.patch, contact.motion, contact.rolling_speed);
        patch.surface_radius = f64::INFINITY;
        let [along, across] = motion.centre_slip(BALL_RADIUS);
        let (xi_x, xi_y, spin) = (along / v, across / v, motion.spin / v);
        for (x, y) in [(0.0, 0.0), (4e-4, -3e-3), (-2e-4, 2e-3)] {
            let [u, w] = motion.slip_at(x, y, &patch);
            assert!((u - v * (xi_x - spin * y)).abs() < 1e-12 && (w - v * (xi_y + spin * x)).abs() < 1e-12);
        }
    }
}

#[test]
fn paper_eq_5_differential_slip_of_both_races() {
    // Contact angle zero, speeds in the moving frame: the ball turns at −ω_b about the axis, the inner race at ω_i,
    // the outer one at −ω_o. Across the groove the axis points along −e_y at the inner race and along e_y at the outer.
    let (ball, inner, outer, v) = (3800.0, 860.0, 600.0, 58.0);
    let patch = contacts(22.0)[0].patch;
    let still = RelativeMotion { rolling: 0.0, lateral: 0.0, spin: 0.0, about_lateral: 0.0, about_rolling: 0.0 };
    for y in [-3e-3, 1e-3, 2e-3] {
        let bow = y * y / (2.0 * patch.surface_radius * v);
        // The paper's x points along the motion of the surfaces: along e_t at the inner race, against it at the outer.
        for (turn, direction, published) in
            [(ball + inner, 1.0, (ball + inner) * bow), (outer - ball, -1.0, (ball - outer) * bow)]
        {
            // Rolling without slip at the centre.
            let motion = RelativeMotion { rolling: -turn * BALL_RADIUS, about_lateral: turn, ..still };
            let [u, _] = motion.slip_at(0.0, y, &patch);
            assert!((direction * u + v * published).abs() < 1e-12 * v, "{u} against {}", -v * published);
        }
    }
}

#[test]
fn identity_slip_field_of_the_unit_disc_is_the_slip_at_each_point() {
    for contact in contacts(1.0) {
        let field = SlipField::new(&contact.patch, &contact.motion);
        for (x, y) in [(0.0, 0.0), (0.6, -0.7), (-0.3, 0.9)] {
            let (a, b) = (contact.patch.semi_lateral, contact.patch.semi_rolling);
            let (ours, plain) = (field.at(x, y), contact.motion.slip_at(b * x, a * y, &contact.patch));
            assert!((ours[0] - plain[0]).abs() < 1e-13 * 70.0 && (ours[1] - plain[1]).abs() < 1e-13 * 70.0);
        }
    }
}

#[test]
fn identity_power_is_the_work_on_the_rigid_motion() {
    let law = silver();
    for contact in SCALES.into_iter().flat_map(contacts) {
        for (rule, radius, pressure) in COARSE.into_iter().flat_map(|rule| {
            [contact.patch.surface_radius, f64::INFINITY]
                .into_iter()
                .flat_map(move |r| [PressureChoice::Peak, PressureChoice::Local].map(|p| (rule, r, p)))
        }) {
            let mut patch = contact.patch;
            patch.surface_radius = radius;
            let mut patch_law = contact.law(&law);
            patch_law.pressure = pressure;
            let quadrature = Quadrature::new(rule).unwrap();
            let work = |patch: &Patch| {
                let t = patch_traction(patch, &contact.motion, contact.rolling_speed, &patch_law, &quadrature);
                // Rolling takes far more power than is lost: relative to the terms that cancel.
                let size = (t.force_rolling * contact.motion.rolling).abs();
                (t.work_on(&contact.motion) + t.power) / size
            };
            let balance = work(&patch);
            assert!(balance.abs() < 1e-12, "{rule:?} {}: {balance:e}", contact.name);
        }
    }
}

#[test]
fn identity_mirrored_motions_mirror_the_result() {
    let law = silver();
    for contact in contacts(22.0).into_iter().chain(contacts(1.0)) {
        let m = contact.motion;
        let along_x = RelativeMotion { rolling: -m.rolling, spin: -m.spin, about_lateral: -m.about_lateral, ..m };
        let along_y = RelativeMotion { lateral: -m.lateral, spin: -m.spin, about_rolling: -m.about_rolling, ..m };
        let both = RelativeMotion { spin: m.spin, lateral: -m.lateral, about_rolling: -m.about_rolling, ..along_x };
        for quadrature in COARSE.map(|rule| Quadrature::new(rule).unwrap()) {
            let of = |motion| {
                patch_traction(&contact.patch, &motion, contact.rolling_speed, &contact.law(&law), &quadrature)
            };
            let t = of(m);
            let expected = [
                (along_x, [-1.0, 1.0, -1.0, -1.0, 1.0]),
                (along_y, [1.0, -1.0, 1.0, -1.0, -1.0]),
                (both, [-1.0, -1.0, -1.0, 1.0, -1.0]),
            ];
            for (motion, signs) in expected {
                let mirrored = of(motion);
                for ((ours, image), sign) in forces(&t).into_iter().zip(forces(&mirrored)).zip(signs) {
                    assert!((image - sign * ours).abs() < 1e-12 * contact.load(), "{motion:?}: {image} {ours}");
                }
                assert!((mirrored.power - t.power).abs() < 1e-12 * t.power);
            }
        }
    }
}

fn forces(t: &PatchTraction) -> [f64; 5] {
    [t.force_rolling, t.force_lateral, t.moment_lateral, t.moment_normal, t.moment_rolling]
}

#[test]
fn identity_slip_units_are_multiples_of_each_other() {
    let law = silver();
    let contact = contacts(22.0).remove(3);
    let quadrature = Quadrature::new(COARSE[2]).unwrap();
    let of = |slip_unit| {
        let mut patch_law = contact.law(&law);
        patch_law.slip_unit = slip_unit;
        patch_traction(&contact.patch, &contact.motion, contact.rolling_speed, &patch_law, &quadrature)
    };
    let speed = contact.rolling_speed.abs();
    assert!(contact.rolling_speed < 0.0, "an outer race, where the surfaces move against e_t");
    for (unit, per_m_s) in [
        (SlipUnit::MeterPerSecond, 1.0),
        (SlipUnit::PercentOfRolling, 100.0 / speed),
        (SlipUnit::PerMilleOfRolling, 1000.0 / speed),
    ] {
        let (ours, scaled) = (of(unit), of(SlipUnit::Scaled { per_m_s }));
        assert!((ours.force_lateral - scaled.force_lateral).abs() < 1e-12 * contact.load());
        assert!((ours.power - scaled.power).abs() < 1e-12 * scaled.power);
    }
}
