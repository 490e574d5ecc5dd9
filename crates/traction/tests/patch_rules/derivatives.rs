//! Dual-number derivatives of the patch integral against central differences, in every input.

use crate::COARSE;
use crate::contacts::{Contact, contacts, silver};
use num_dual::Dual64;
use proptest::prelude::*;
use tribodyn_traction::{
    CoatingLaw, Patch, PatchLaw, PatchRule, PatchTraction, PressureChoice, Quadrature, RelativeMotion, Scalar,
    SlipUnit, patch_traction,
};

const INPUTS: usize = 9;

/// Semi-axes, peak pressure, motion and rolling speed of a contact.
fn inputs(contact: &Contact) -> [f64; INPUTS] {
    let (p, m) = (&contact.patch, &contact.motion);
    [
        p.semi_lateral,
        p.semi_rolling,
        p.peak_pressure,
        m.rolling,
        m.lateral,
        m.spin,
        m.about_lateral,
        m.about_rolling,
        contact.rolling_speed,
    ]
}

/// Sizes against which the inputs are stepped: a step changes the slip by about the same everywhere.
const SIZES: [f64; INPUTS] = [4e-3, 5e-4, 2e9, 0.3, 0.3, 300.0, 20.0, 20.0, 60.0];

struct Case<'a> {
    law: PatchLaw<'a, CoatingLaw>,
    surface: (f64, f64),
    quadrature: Quadrature,
}

impl Case<'_> {
    fn of<D: Scalar>(&self, x: [D; INPUTS]) -> [D; 7] {
        let [semi_lateral, semi_rolling, peak_pressure, rolling, lateral, spin, about_lateral, about_rolling, v] = x;
        let (ball_radius, surface_radius) = self.surface;
        let patch = Patch { semi_lateral, semi_rolling, peak_pressure, ball_radius, surface_radius };
        let motion = RelativeMotion { rolling, lateral, spin, about_lateral, about_rolling };
        let t: PatchTraction<D> = patch_traction(&patch, &motion, v, &self.law, &self.quadrature);
        [
            t.force_rolling,
            t.force_lateral,
            t.moment_lateral,
            t.moment_normal,
            t.moment_rolling,
            t.power,
            t.wear_integral,
        ]
    }

    /// Largest difference between dual and central-difference derivatives over the size of the output. A long step
    /// steps over the kinks that a rule has where a strip's cut enters the patch, a short one shows rounding: of both
    /// steps the better one counts, for a wrong derivative agrees with neither.
    fn worst(&self, at: [f64; INPUTS], sizes: [f64; 7]) -> f64 {
        let mut worst = 0.0f64;
        for k in 0..INPUTS {
            let mut dual = at.map(Dual64::from);
            dual[k].eps = SIZES[k];
            let exact = self.of(dual);
            let difference = |step: f64| {
                let shifted = |sign: f64| {
                    let mut x = at;
                    x[k] += sign * step * SIZES[k];
                    self.of(x)
                };
                let (up, down) = (shifted(1.0), shifted(-1.0));
                (0..7).map(|i| (exact[i].eps - (up[i] - down[i]) / (2.0 * step)).abs() / sizes[i]).fold(0.0, f64::max)
            };
            worst = worst.max(difference(1e-5).min(difference(1e-7)));
        }
        worst
    }
}

fn check(contact: &Contact, at: [f64; INPUTS], rule: PatchRule, slip_unit: SlipUnit, pressure: PressureChoice) -> f64 {
    let law = silver();
    let p = &contact.patch;
    let case = Case {
        law: PatchLaw { law: &law, slip_unit, pressure },
        surface: (p.ball_radius, p.surface_radius),
        quadrature: Quadrature::new(rule).unwrap(),
    };
    // The largest friction that the contact can have.
    let (force, speed) = (0.13 * contact.load(), 1.0);
    let moment = force * p.ball_radius;
    case.worst(at, [force, force, moment, force * p.semi_lateral, moment, force * speed, contact.load() * speed])
}

#[test]
fn identity_dual_derivatives_of_every_rule_unit_and_pressure() {
    for contact in contacts(22.0).into_iter().chain(contacts(1.0)) {
        for rule in COARSE {
            for unit in [SlipUnit::PercentOfRolling, SlipUnit::Scaled { per_m_s: contact.scale }] {
                // Local pressure: below 1.5 GPa the law is clamped and has a kink that differences step over.
                for pressure in [PressureChoice::Peak, PressureChoice::Local] {
                    let worst = check(&contact, inputs(&contact), rule, unit, pressure);
                    assert!(worst < 2e-6, "{} {rule:?} {unit:?} {pressure:?}: {worst:e}", contact.name);
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(352),
        ..ProptestConfig::with_cases(48)
    })]

    #[test]
    fn identity_dual_derivatives_at_scattered_motions(
        shift in proptest::array::uniform5(-1.0..1.0f64),
        which in 0usize..6,
        rule in 0usize..3,
    ) {
        let contact = contacts(5.0).swap_remove(which);
        let mut at = inputs(&contact);
        for (k, s) in (3..8).zip(shift) {
            at[k] += s * SIZES[k];
        }
        let worst = check(&contact, at, COARSE[rule], SlipUnit::Scaled { per_m_s: 5.0 }, PressureChoice::Peak);
        prop_assert!(worst < 1e-5, "{worst:e}");
    }
}
