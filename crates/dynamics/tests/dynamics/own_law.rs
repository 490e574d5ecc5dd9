//! Friction that the fast scheme has to take explicitly, and steps beyond the stability of a scheme.

use crate::{Keep, case};
use std::sync::Arc;
use tribodyn_bearing::Side;
use tribodyn_dynamics::{DynamicsError, Ending, Run, RunInputs};
use tribodyn_traction::{Coating, CoatingLaw, Conditions, CustomLaw, Law, OverSlip, SlipCurve, TractionLaw};

/// The silver coating's law handed in as one's own, with slopes by differences.
#[derive(Debug)]
struct Silver(CoatingLaw);

impl CustomLaw for Silver {
    fn over_slip(&self, slip: f64, contact: &Conditions) -> OverSlip {
        let pressure = contact.pressure;
        let at = |slip: f64, pressure: f64| self.0.at(pressure).over_slip(slip);
        let (ds, dp) = (1e-6 * slip.abs().max(1e-6), 1e-6 * pressure);
        OverSlip {
            value: at(slip, pressure),
            by_slip: (at(slip + ds, pressure) - at(slip - ds, pressure)) / (2.0 * ds),
            by_pressure: (at(slip, pressure + dp) - at(slip, pressure - dp)) / (2.0 * dp),
            by_entrainment: 0.0,
        }
    }
}

fn own_law(scheme: &str) -> RunInputs {
    let changes = [("transient.scheme", scheme), ("transient.duration", "s(0.002)")];
    let mut inputs = case(&changes).run_inputs().unwrap();
    let silver = CoatingLaw::varying(&Coating::library("ag").unwrap(), 2).unwrap();
    let tribology = inputs.bearing.tribology.as_mut().unwrap();
    for side in Side::BOTH {
        tribology.laws[side] = Law::Custom(Arc::new(Silver(silver.clone())));
    }
    inputs
}

/// With a law of one's own at 20 µs balls slid 7 % too fast and the run was a success.
#[test]
fn limit_a_law_of_ones_own_at_a_step_beyond_its_friction_is_refused() {
    let refused = Run::new(own_law("Fast(step: us(20))")).map(drop).unwrap_err();
    let DynamicsError::UnstableFriction { step_s, limit_s, .. } = refused else { panic!("{refused}") };
    assert!(limit_s < step_s && limit_s > 1e-6, "{limit_s} {step_s}");
    assert!(refused.to_string().contains("shorten the step"), "{refused}");
    // The coating's own law has derivatives and runs.
    let coated = case(&[("transient.scheme", "Fast(step: us(20))")]).run_inputs().unwrap();
    assert!(Run::new(coated).is_ok());
    let mut run = Run::new(own_law(&format!("Fast(step: s({:e}))", 0.5 * limit_s))).unwrap();
    assert_eq!(run.advance(f64::INFINITY, &mut Keep::default()).unwrap(), Ending::Complete);
}

/// Whoever keeps no events sees it in the ending.
#[test]
fn limit_a_step_beyond_stability_is_in_the_ending() {
    let changes = [
        ("traction.differential_slip", "false"),
        ("transient.scheme", "RungeKutta4(step: us(10))"),
        ("transient.duration", "s(0.0001)"),
    ];
    let mut run = Run::new(case(&changes).run_inputs().unwrap()).unwrap();
    let ending = run.advance(f64::INFINITY, &mut ()).unwrap();
    let Ending::BeyondStability { step_s, limit_s } = ending else { panic!("{ending:?}") };
    assert!(step_s == 1e-5 && limit_s < step_s, "{limit_s}");
}
