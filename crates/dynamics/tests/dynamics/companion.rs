//! The error of the accelerations, by companions with half the step and a finer patch.

use crate::{Keep, case};
use tribodyn_dynamics::Run;

const TARGET: &str = "TargetError(relative: 1e-5)";

/// A run of 50 ms with accelerations of the outer ring along x from the second half on, m/s².
fn run(patch: &str, scheme: &str) -> (Run, Vec<f64>) {
    let changes = [("traction.patch", patch), ("transient.scheme", scheme), ("transient.duration", "s(0.05)")];
    let mut run = Run::new(case(&changes).run_inputs().unwrap()).unwrap();
    let mut keep = Keep::default();
    let _ = run.advance(f64::INFINITY, &mut keep).unwrap();
    let half = &keep.samples[keep.samples.len() / 2..];
    (run, half.iter().map(|s| s.outer.acceleration_m_s2[0]).collect())
}

fn error(patch: &str, scheme: &str) -> f64 {
    run(patch, scheme).0.acceleration_error().unwrap().error_m_s2
}

/// A coarser linear traction shows, and so does a coarse patch rule, which is the same at every step.
#[test]
fn identity_the_error_of_accelerations_follows_patch_and_linear_traction() {
    let fine = error("TargetError(relative: 2e-6)", "Fast(step: us(5))");
    let coarse = error("TargetError(relative: 1e-4)", "Fast(step: us(5))");
    assert!(coarse > 2.0 * fine, "{coarse} {fine}");
    let rough = error("SplitStrip(across: 3, along: 2)", "RungeKutta4(step: us(10))");
    let smooth = error(TARGET, "RungeKutta4(step: us(10))");
    assert!(rough > 3.0 * smooth, "{rough} {smooth}");
}

/// Peaks of the fast scheme were 60 % off; where the error is small they agree with those of a converged run.
#[test]
fn regress_peak_accelerations_of_the_fast_scheme_are_those_of_an_explicit_one() {
    let peak = |values: &[f64]| {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        values.iter().map(|a| (a - mean).abs()).fold(0.0, f64::max)
    };
    let (_, exact) = run(TARGET, "RungeKutta4(step: us(5))");
    let (fast, values) = run(TARGET, "Fast(step: us(20))");
    let found = fast.acceleration_error().unwrap();
    assert!((peak(&values) / peak(&exact) - 1.0).abs() < 0.15, "{} {}", peak(&values), peak(&exact));
    assert!(found.error_m_s2 < 0.1 * found.acceleration_m_s2, "{found:?}");
    assert!(found.span_s > 4e-3 && found.span_s < 6e-3);
}

/// Under thrust alone all balls do the same and the outer ring rests: what moves it is rounding, below the error.
#[test]
fn limit_rounding_is_below_the_error_of_accelerations() {
    let changes = [
        ("transient.scheme", "Fast(step: us(20))"),
        ("ring.x", "Force(N(0))"),
        ("cage.pocket_stiffness", "N_per_um(0)"),
        ("transient.duration", "s(0.02)"),
    ];
    let mut run = Run::new(case(&changes).run_inputs().unwrap()).unwrap();
    let _ = run.advance(f64::INFINITY, &mut Keep::default()).unwrap();
    let found = run.acceleration_error().unwrap();
    assert!(found.error_m_s2 > 1e-9 && found.acceleration_m_s2 < found.error_m_s2, "{found:?}");
}

/// A run of some samples only has nothing to compare.
#[test]
fn limit_a_short_run_has_no_error_of_accelerations() {
    let mut run = Run::new(case(&[]).run_inputs().unwrap()).unwrap();
    assert_eq!(run.acceleration_error(), None);
    let _ = run.advance(5e-4, &mut Keep::default()).unwrap();
    assert_eq!(run.acceleration_error(), None);
}
