//! Laws of one's own in runs, friction that the fast scheme has to take explicitly, and steps beyond the stability of a
//! scheme.

#[path = "../../../traction/examples/film_law/mod.rs"]
mod film_law;

use crate::{Keep, case};
use film_law::Film;
use tribodyn_bearing::Side;
use tribodyn_dynamics::{DynamicsError, Ending, Run, RunInputs, Sample};
use tribodyn_traction::{Conditions, CurveNumber, CustomCurve, CustomLaw, Law, OverSlip};

/// The paper's bearing with that film on both races.
fn own_law(changes: &[(&str, &str)], temperature: f64) -> RunInputs {
    let short = [("transient.duration", "s(0.002)"), ("traction.slip_unit", "MeterPerSecond")];
    let mut inputs = case(&[&short[..], changes].concat()).run_inputs().unwrap();
    let tribology = inputs.bearing.tribology.as_mut().unwrap();
    for side in Side::BOTH {
        tribology.laws[side] = Law::custom(Film { temperature });
    }
    inputs
}

fn end(scheme: &str, temperature: f64) -> Sample {
    let mut keep = Keep::default();
    let mut run = Run::new(own_law(&[("transient.scheme", scheme)], temperature)).unwrap();
    assert_eq!(run.advance(f64::INFINITY, &mut keep).unwrap(), Ending::Complete);
    keep.samples.pop().unwrap()
}

/// A law that asks for entrainment speed and temperature, with no kernel of its own, takes the steps that the built-in
/// ones take.
#[test]
fn identity_a_film_of_ones_own_by_the_fast_scheme_and_by_small_steps() {
    let speeds = |sample: &Sample| sample.balls.iter().map(|b| b.orbital_speed_rad_s).collect::<Vec<_>>();
    let apart =
        |a: &Sample, b: &Sample| speeds(a).iter().zip(speeds(b)).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
    let fine = end("RungeKutta4(step: us(1))", 343.0);
    let long = end("Fast(step: us(20))", 343.0);
    assert!(apart(&long, &fine) < 2e-4, "{:e}", apart(&long, &fine));
    // The temperature is in it: a film of a tenth of the viscosity lets the balls slide.
    let warm = end("Fast(step: us(20))", 420.0);
    assert!(apart(&warm, &long) > 1e-3, "{:e}", apart(&warm, &long));
}

/// Where the curve changes from node to node no derivative is known, and friction is taken explicitly: at 20 µs balls
/// once slid 7 % too fast and the run was a success.
#[test]
fn limit_a_step_beyond_explicit_friction_is_refused() {
    let local = |scheme: &str| {
        let changes =
            [("traction.pressure", "Local"), ("transient.scheme", scheme), ("transient.duration", "s(0.002)")];
        case(&changes).run_inputs().unwrap()
    };
    let refused = Run::new(local("Fast(step: us(20))")).map(drop).unwrap_err();
    let DynamicsError::UnstableFriction { step_s, limit_s, .. } = refused else { panic!("{refused}") };
    assert!(limit_s < step_s && limit_s > 1e-6, "{limit_s} {step_s}");
    assert!(refused.to_string().contains("shorten the step"), "{refused}");
    // At the peak pressure the law has derivatives and runs.
    let coated = case(&[("transient.scheme", "Fast(step: us(20))")]).run_inputs().unwrap();
    assert!(Run::new(coated).is_ok());
    let mut run = Run::new(local(&format!("Fast(step: s({:e}))", 0.5 * limit_s))).unwrap();
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
