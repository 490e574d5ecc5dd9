//! Steps allocate nothing: counted by an allocator of the whole process, hence a test binary of its own.

use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::Run;

const PAPER_AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");

/// Allocations from 1 ms, where everything has its size, to `until`, and steps there. Samples are 20 ms apart.
fn allocations(scheme: &str, until: f64) -> (u64, u64) {
    let changes = [
        ("traction.patch", "SplitStrip(across: 5, along: 3)"),
        ("transient.scheme", scheme),
        ("recording.state_rate", "Hz(50)"),
        ("recording.ball_rate", "Hz(50)"),
    ];
    let text = changes.iter().fold(PAPER_AG.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap());
    let mut run = Run::new(Case::from_ron(&text).unwrap().run_inputs().unwrap()).unwrap();
    let _ = run.advance(1e-3, &mut ()).unwrap();
    let before = run.statistics().steps;
    let counted = allocation_counter::measure(|| {
        let _ = run.advance(until, &mut ()).unwrap();
    });
    (counted.count_total, run.statistics().steps - before)
}

#[test]
fn identity_steps_allocate_nothing() {
    for scheme in ["RungeKutta4(step: us(10))", "Fast(step: us(20))", "DormandPrince(tolerance: 1e-6, longest: us(20))"]
    {
        let (allocations, steps) = allocations(scheme, 3e-3);
        assert!(steps >= 100, "{scheme}: {steps} steps");
        assert_eq!(allocations, 0, "{scheme}: in {steps} steps");
    }
}

/// Without it the count could be that of an allocator that is not in use.
#[test]
fn limit_a_sample_does_allocate() {
    let (allocations, _) = allocations("Fast(step: us(20))", 2.1e-2);
    assert!(allocations >= 1, "{allocations}");
}
