//! Limits with a closed form: Coulomb friction, small slip, symmetric patches, no contact.

use crate::contacts::{BALL_RADIUS, contacts, silver};
use crate::{COARSE, Coulomb};
use std::f64::consts::PI;
use tribodyn_contact::CompleteElliptic;
use tribodyn_traction::{
    Patch, PatchLaw, PatchRule, PatchTraction, PressureChoice, Quadrature, RelativeMotion, SlipUnit, TractionLaw,
    patch_traction,
};

const STILL: RelativeMotion =
    RelativeMotion { rolling: 0.0, lateral: 0.0, spin: 0.0, about_lateral: 0.0, about_rolling: 0.0 };

/// One fine rule of each kind with the relative error that its edge or its kinks leave.
const FINE: [(PatchRule, f64); 3] = [
    (PatchRule::PolarMidpoint { radial: 60, circumferential: 120 }, 2e-3),
    (PatchRule::GaussJacobi { radial: 24, angles: 48 }, 1e-4),
    (PatchRule::SplitStrip { across: 32, along: 28 }, 1e-6),
];

fn flat(semi_lateral: f64, semi_rolling: f64) -> Patch {
    Patch { semi_lateral, semi_rolling, surface_radius: f64::INFINITY, ..contacts(22.0)[0].patch }
}

fn load(patch: &Patch) -> f64 {
    2.0 * PI / 3.0 * patch.peak_pressure * patch.semi_lateral * patch.semi_rolling
}

fn of<L: TractionLaw>(patch: &Patch, motion: &RelativeMotion, law: &L, rule: PatchRule) -> PatchTraction {
    let law = PatchLaw { law, slip_unit: SlipUnit::MeterPerSecond, pressure: PressureChoice::Peak };
    patch_traction(patch, motion, 1.0, &law, &Quadrature::new(rule).unwrap())
}

fn assert_close(ours: f64, exact: f64, relative: f64, what: &str) {
    assert!((ours - exact).abs() <= relative * exact.abs(), "{what}: {ours} against {exact}");
}

#[test]
fn limit_coulomb_pure_sliding_is_coefficient_times_load() {
    let (patch, law) = (flat(4e-3, 5e-4), Coulomb { coefficient: 0.1 });
    for (rule, tolerance) in FINE {
        // Only the polar midpoints do not integrate the Hertz pressure exactly.
        let tolerance = if matches!(rule, PatchRule::PolarMidpoint { .. }) { tolerance } else { 1e-12 };
        let t = of(&patch, &RelativeMotion { rolling: 0.3, lateral: -0.4, ..STILL }, &law, rule);
        let limit = 0.1 * load(&patch);
        assert_close(t.force_rolling, -0.6 * limit, tolerance, "along rolling");
        assert_close(t.force_lateral, 0.8 * limit, tolerance, "across");
        assert_close(t.moment_lateral, -0.6 * limit * BALL_RADIUS, tolerance, "moment about the lateral axis");
        assert_close(t.moment_rolling, -0.8 * limit * BALL_RADIUS, tolerance, "moment about the rolling direction");
        assert_close(t.power, 0.5 * limit, tolerance, "power");
        assert_close(t.wear_integral, 0.5 * load(&patch), tolerance, "wear integral");
        assert!(t.moment_normal.abs() < 1e-12 * limit * BALL_RADIUS);
    }
}

#[test]
fn limit_coulomb_pure_spin() {
    let law = Coulomb { coefficient: 0.1 };
    for (rule, tolerance) in FINE {
        for (a, b) in [(1e-3, 1e-3), (4e-3, 5e-4), (4e-3, 1e-3)] {
            let patch = flat(a, b);
            // (3/8) μ Q a E(m), m = 1 − b²/a²; for the circle (3π/16) μ Q a: the integral of
            // μ p √(x² + y²) with x = b r cos θ, y = a r sin θ.
            let e = CompleteElliptic::new(b / a).unwrap().second;
            let moment = 0.375 * 0.1 * load(&patch) * a * e;
            if a == b {
                assert_close(moment, 3.0 * PI / 16.0 * 0.1 * load(&patch) * a, 1e-14, "circle");
            }
            let t = of(&patch, &RelativeMotion { spin: 250.0, ..STILL }, &law, rule);
            assert_close(t.moment_normal, -moment, tolerance, "spin moment");
            assert_close(t.power, 250.0 * moment, tolerance, "spin power");
            // A symmetric field has no force.
            let forces = t.force_rolling.abs().max(t.force_lateral.abs());
            assert!(forces < 1e-13 * load(&patch), "{rule:?}: {forces}");
        }
    }
}

#[test]
fn limit_steep_curve_approaches_coulomb() {
    // At infinite slip κ → K.
    let (law, contact) = (silver(), contacts(100.0).remove(0));
    let residual = law.at(contact.patch.peak_pressure).d();
    let far = PatchLaw { law: &law, slip_unit: SlipUnit::Scaled { per_m_s: 1e7 }, pressure: PressureChoice::Peak };
    let quadrature = Quadrature::new(FINE[2].0).unwrap();
    let steep = patch_traction(&contact.patch, &contact.motion, contact.rolling_speed, &far, &quadrature);
    let coulomb = contact.traction(&Coulomb { coefficient: residual }, &quadrature);
    let errors = contact.errors(&steep, &coulomb);
    assert!(errors.iter().all(|&e| e < 1e-7), "{errors:?}");
}

#[test]
fn limit_small_slip_is_linear() {
    let (law, patch) = (silver(), flat(4e-3, 5e-4));
    let slope = law.at(patch.peak_pressure).initial_slope();
    let (u, v, spin) = (3e-9, -2e-9, 1e-6);
    for (rule, tolerance) in FINE {
        let tolerance = if matches!(rule, PatchRule::PolarMidpoint { .. }) { tolerance } else { 1e-7 };
        let t = of(&patch, &RelativeMotion { rolling: u, lateral: v, spin, ..STILL }, &law, rule);
        let per_speed = slope * load(&patch);
        let (a, b) = (patch.semi_lateral, patch.semi_rolling);
        // ∬ p x² dA = Q b²/5 and likewise across.
        let inertia = (a * a + b * b) / 5.0;
        assert_close(t.force_rolling, -per_speed * u, tolerance, "along rolling");
        assert_close(t.force_lateral, -per_speed * v, tolerance, "across");
        assert_close(t.moment_normal, -per_speed * spin * inertia, tolerance, "spin moment");
        assert_close(t.power, per_speed * (u * u + v * v + spin * spin * inertia), tolerance, "power");
    }
}

#[test]
fn limit_no_slip_and_no_pressure_give_no_traction() {
    let law = silver();
    for rule in COARSE {
        let patch = flat(4e-3, 5e-4);
        assert_eq!(forces(&of(&patch, &STILL, &law, rule)), [0.0; 7]);
        assert_eq!(forces(&of(&patch, &STILL, &Coulomb { coefficient: 0.1 }, rule)), [0.0; 7]);
        let lifted = Patch { peak_pressure: 0.0, ..patch };
        assert_eq!(of(&lifted, &contacts(22.0)[0].motion, &law, rule), PatchTraction::zero());
    }
}

fn forces(t: &PatchTraction) -> [f64; 7] {
    [t.force_rolling, t.force_lateral, t.moment_lateral, t.moment_normal, t.moment_rolling, t.power, t.wear_integral]
        .map(f64::abs)
}
