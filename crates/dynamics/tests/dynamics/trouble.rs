//! Failures of a run are reported, and the samples before them are good.

use crate::{Keep, OIL_6206, case, run};
use serde_json::json;
use std::convert::Infallible;
use std::ops::ControlFlow;
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{
    Blame, DynamicsError, Ending, Event, EventKind, Observer, Run, RunError, Sample, Scheme, StepBound,
};

/// The bound that a broken-off run names.
fn bound(error: &RunError<Infallible>) -> Option<(f64, StepBound)> {
    match error {
        RunError::Dynamics(DynamicsError::NotFinite { blame, .. } | DynamicsError::BallLost { blame, .. }) => {
            match blame {
                Blame::Step { step_s, bound } => Some((*step_s, (**bound).clone())),
                Blame::Case { .. } => None,
            }
        }
        other => panic!("{other}"),
    }
}

#[test]
fn limit_a_step_far_too_long_ends_with_the_stable_one_named() {
    let case = case(&[("transient.scheme", "RungeKutta4(step: us(90))"), ("transient.duration", "s(0.5)")]);
    let mut keep = Keep::default();
    let error = Run::new(case.run_inputs().unwrap()).unwrap().advance(f64::INFINITY, &mut keep).unwrap_err();
    let limit_s = bound(&error).unwrap().1.limit_s;
    assert!(limit_s > 1e-8 && limit_s < 5e-5, "{limit_s}");
    assert!(!keep.samples.is_empty());
    let warned =
        keep.events.iter().any(|e| matches!(&e.kind, EventKind::Warning { message } if message.contains("beyond")));
    assert!(warned, "{:?}", keep.events);
}

/// At this slip scale and without differential slip 1e-5 s is beyond the bound: nothing blows up, but a warning says
/// so.
#[test]
fn paper_step_is_beyond_the_bound_without_differential_slip() {
    let changes = [
        ("traction.differential_slip", "false"),
        ("transient.scheme", "RungeKutta4(step: us(10))"),
        ("transient.duration", "s(0.0001)"),
    ];
    let (run, keep) = run(&case(&changes));
    assert!(run.stiffness().runge_kutta_step_s < 1e-5, "{:?}", run.stiffness());
    assert!(keep.events.iter().any(|e| matches!(e.kind, EventKind::Warning { .. })));
}

#[test]
fn limit_an_outer_ring_that_nothing_holds_is_refused() {
    let mut inputs = case(&[]).run_inputs().unwrap();
    inputs.supports.outer.stiffness[1] = 0.0;
    let path = "supports.outer.stiffness";
    assert_eq!(Run::new(inputs).map(drop), Err(DynamicsError::Unsupported { path }));
}

#[test]
fn limit_an_observer_can_break_off() {
    let case = case(&[("transient.duration", "s(0.01)")]);
    let mut run = Run::new(case.run_inputs().unwrap()).unwrap();
    let mut keep = Keep { stop_after: 5, ..Default::default() };
    assert_eq!(run.advance(f64::INFINITY, &mut keep).unwrap(), Ending::Stopped);
    assert_eq!(keep.samples.len(), 5);
    assert!(run.time() < 0.001);
}

#[test]
fn limit_a_checkpoint_of_another_bearing_is_refused() {
    let mut run = Run::new(case(&[]).run_inputs().unwrap()).unwrap();
    let other = Run::new(case(&[("geometry.ball_count", "12")]).run_inputs().unwrap()).unwrap();
    let refused = run.resume(other.checkpoint());
    assert!(matches!(refused, Err(DynamicsError::Checkpoint { found, expected }) if expected - found == 9));
}

/// Checkpoints come from files: whatever number of one is changed, the run says which or goes on with it, and none
/// panics.
#[test]
fn limit_a_checkpoint_with_impossible_values_is_refused() {
    let case = case(&[("transient.scheme", "Fast(step: us(10))"), ("transient.duration", "s(0.01)")]);
    let begun = || {
        let mut run = Run::new(case.run_inputs().unwrap()).unwrap();
        let _ = run.advance(0.001, &mut Keep::default()).unwrap();
        run
    };
    let sound = serde_json::to_value(begun().checkpoint()).unwrap();
    let edits: [(&str, serde_json::Value); 14] = [
        ("/time", json!(-1.0)),
        ("/time", json!(0.5)),
        ("/state/1", json!(1.0)),
        ("/state/5", json!(1e12)),
        ("/state/3", json!(-1e300)),
        ("/steps", json!(u64::MAX)),
        ("/samples", json!(0)),
        ("/samples", json!(u64::MAX)),
        ("/filter/passed", json!(1)),
        ("/loaded", json!([])),
        ("/fast/contacts", json!([])),
        ("/fast/common", json!([1.0])),
        ("/stiffness/contact_frequency_hz", json!(1e300)),
        ("/worn/0", json!(-1.0)),
    ];
    for (place, value) in edits {
        let mut edited = sound.clone();
        *edited.pointer_mut(place).unwrap_or_else(|| panic!("{place}")) = value.clone();
        let refused = begun().resume(serde_json::from_value(edited).unwrap());
        assert!(matches!(refused, Err(DynamicsError::CheckpointValue { .. })), "{place} = {value}: {refused:?}");
    }
    let mut run = begun();
    run.resume(serde_json::from_value(sound).unwrap()).unwrap();
    let _ = run.advance(0.002, &mut Keep::default()).unwrap();
}

/// The radial load grows beyond what a soft support holds: balls and rings leave their place together.
#[test]
fn limit_a_ball_thrown_out_is_named() {
    let case = case(&[
        ("transient.duration", "s(0.1)"),
        ("transient.scheme", "Fast(step: us(20))"),
        ("supports.outer.stiffness", "(N_per_um(1), N_per_um(1))"),
        ("ring.x", "ForceTable([(s(0), kN(22.98)), (s(0.001), kN(60))])"),
    ]);
    let mut keep = Keep::default();
    let error = Run::new(case.run_inputs().unwrap()).unwrap().advance(f64::INFINITY, &mut keep).unwrap_err();
    // No shorter step would hold it, and none is named.
    assert_eq!(bound(&error), None, "{error}");
    assert!(error.to_string().contains("supports too soft"), "{error}");
    let RunError::Dynamics(DynamicsError::BallLost { distance_mm, time_s, .. }) = error else { panic!("{error}") };
    // A tenth of the ball's diameter.
    assert!(distance_mm > 3.0 && time_s < 0.05, "{error}");
    assert!(!keep.samples.is_empty());
}

/// A step far beyond the period of contact springs that nothing damps, on a ring that weighs next to nothing.
#[test]
fn limit_numbers_that_are_none_end_a_run_with_time_and_step() {
    let case = case(&[
        ("transient.duration", "s(0.5)"),
        ("transient.scheme", "Fast(step: us(100))"),
        ("transient.contact_damping", "0"),
        ("supports.outer.mass", "kg(1e-6)"),
        ("recording.state_rate", "kHz(1)"),
        ("recording.ball_rate", "kHz(1)"),
    ]);
    let error = Run::new(case.run_inputs().unwrap()).unwrap().advance(f64::INFINITY, &mut Keep::default()).unwrap_err();
    let RunError::Dynamics(DynamicsError::NotFinite { blame: Blame::Step { step_s, bound }, .. }) = &error else {
        panic!("{error}")
    };
    assert!((step_s - 1e-4).abs() < 1e-12 && bound.limit_s < 5e-5, "{error}");
    assert!(error.to_string().contains("not a number"), "{error}");
}

/// A motion other than a ball's may make a step too long: the bound that is named is below the step that was used, with
/// the motion it is of.
#[test]
fn limit_a_bound_that_is_named_is_below_the_step_that_was_used() {
    let soft = ("supports.outer.damping", "(N_s_per_m(5e6), N_s_per_m(5e6))");
    let light = ("supports.outer.mass", "kg(0.005)");
    // So light that no number of pieces follows it.
    let lighter = ("supports.outer.mass", "kg(5e-6)");
    for (change, scheme, motion) in [
        (soft, "RungeKutta4(step: us(10))", "the outer ring"),
        (light, "RungeKutta4(step: us(8))", "the outer ring"),
        (lighter, "Fast(step: us(20))", "the outer ring"),
    ] {
        let case = case(&[change, ("transient.scheme", scheme), ("transient.duration", "s(0.02)")]);
        let mut keep = Keep::default();
        let error = Run::new(case.run_inputs().unwrap()).unwrap().advance(f64::INFINITY, &mut keep).unwrap_err();
        let (step_s, bound) = bound(&error).unwrap_or_else(|| panic!("{scheme}: {error}"));
        assert!(bound.limit_s < step_s && bound.motion.starts_with(motion), "{scheme}: {error}");
    }
}

#[test]
fn limit_a_step_that_never_comes_to_an_end_is_refused() {
    let case = case(&[]);
    for scheme in [Scheme::RungeKutta4 { step: 1e-300 }, Scheme::DormandPrince { tolerance: 1e-6, longest: 0.0 }] {
        let mut inputs = case.run_inputs().unwrap();
        inputs.options.scheme = scheme;
        assert!(matches!(Run::new(inputs).map(drop), Err(DynamicsError::NoProgress { .. })));
    }
}

/// Stops after every few steps, wherever that is.
#[derive(Default)]
struct Pauses {
    keep: Keep,
    steps: usize,
}

impl Observer for Pauses {
    type Error = Infallible;

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, Infallible> {
        self.keep.sample(sample, with_balls)
    }

    fn event(&mut self, event: &Event) -> Result<(), Infallible> {
        self.keep.event(event)
    }

    fn stepped(&mut self, _: f64) -> ControlFlow<()> {
        self.steps += 1;
        if self.steps.is_multiple_of(7) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// The last one with balls that are implicit in their springs.
#[test]
fn identity_a_run_taken_up_after_any_step_makes_the_samples_of_one_that_went_on() {
    let of_paper = ["RungeKutta4(step: us(5))", "DormandPrince(tolerance: 1e-5, longest: us(10))", "Fast(step: us(5))"]
        .map(|scheme| case(&[("transient.scheme", scheme), ("transient.duration", "s(0.001)")]));
    let in_oil = [("transient.contact_damping", "0.25"), ("transient.start", "QuasiStatic")]
        .into_iter()
        .chain([("transient.scheme", "Fast(step: us(20))"), ("transient.duration", "s(0.004)")])
        .fold(OIL_6206.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap());
    for case in of_paper.into_iter().chain([Case::from_ron(&in_oil).unwrap()]) {
        let whole = run(&case).1;
        let mut pauses = Pauses::default();
        let mut run = Run::new(case.run_inputs().unwrap()).unwrap();
        while run.advance(f64::INFINITY, &mut pauses).unwrap() == Ending::Stopped {
            let saved = serde_json::to_string(&run.checkpoint()).unwrap();
            run = Run::new(case.run_inputs().unwrap()).unwrap();
            run.resume(serde_json::from_str(&saved).unwrap()).unwrap();
        }
        let scheme = case.transient.as_ref().unwrap().scheme;
        assert!(pauses.steps > 100, "{} steps", pauses.steps);
        assert_eq!(pauses.keep.samples, whole.samples, "{scheme:?}");
        assert_eq!(pauses.keep.events, whole.events, "{scheme:?}");
    }
}
