//! Schemes: order of convergence, and one against the other.

use crate::{Keep, case, run};
use tribodyn_case::Case;
use tribodyn_dynamics::{EventKind, Run, Sample};

/// Short runs from a start that is not in equilibrium: the radial load moves the rings at once.
const SHORT: [(&str, &str); 4] = [
    ("transient.duration", "s(0.0016)"),
    ("recording.state_rate", "Hz(625)"),
    ("recording.ball_rate", "Hz(625)"),
    // Slip in m/s: the curve is smooth on the scale of the slip, and so is the solution.
    ("traction.slip_unit", "MeterPerSecond"),
];
const SMOOTH_RULE: (&str, &str) = ("traction.patch", "GaussJacobi(radial: 3, angles: 12)");
const NO_CAGE: (&str, &str) = ("cage.pocket_stiffness", "N_per_um(0)");

fn end(scheme: &str, changes: &[(&str, &str)]) -> Sample {
    let all = [&SHORT[..], &[SMOOTH_RULE, ("transient.scheme", scheme)], changes].concat();
    run(&case(&all)).1.samples.pop().unwrap()
}

/// Largest difference of the orbital speeds and angular velocities, rad/s.
fn distance(a: &Sample, b: &Sample) -> f64 {
    let speeds = |s: &Sample| {
        s.balls
            .iter()
            .flat_map(|b| [b.orbital_speed_rad_s, b.angular_velocity_rad_s[0], b.angular_velocity_rad_s[1]])
            .collect::<Vec<_>>()
    };
    speeds(a).iter().zip(speeds(b)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn identity_runge_kutta_is_of_fourth_order_without_the_cage() {
    let reference = end("RungeKutta4(step: us(1))", &[NO_CAGE]);
    let error = |step: &str| distance(&end(step, &[NO_CAGE]), &reference);
    let (coarse, fine) = (error("RungeKutta4(step: us(8))"), error("RungeKutta4(step: us(4))"));
    let order = (coarse / fine).log2();
    assert!(order > 3.6 && order < 5.0, "order {order:.2}: {coarse:e}, {fine:e}");
}

/// Pockets with little play, so that balls meet and leave their walls on the way: steps end there, and the order stays
/// four.
#[test]
fn identity_runge_kutta_is_of_fourth_order_over_impacts() {
    let at = |step: &str| {
        let changes = [SMOOTH_RULE, ("cage.pocket_gap", "mm(0.02)"), ("transient.scheme", step)];
        run(&case(&[&SHORT[..], &changes].concat()))
    };
    let last = |(_, keep): (Run, Keep)| keep.samples.last().unwrap().clone();
    let reference = last(at("RungeKutta4(step: us(1))"));
    let (run, keep) = at("RungeKutta4(step: us(8))");
    let impacts = keep.events.iter().filter(|e| matches!(e.kind, EventKind::Impact { .. })).count();
    assert!(impacts > 10 && run.statistics().cut_at_pocket > 10, "{impacts} impacts, {:?}", run.statistics());
    let coarse = distance(&last((run, keep)), &reference);
    let fine = distance(&last(at("RungeKutta4(step: us(4))")), &reference);
    let order = (coarse / fine).log2();
    assert!(order > 3.4 && order < 5.0, "order {order:.2}: {coarse:e}, {fine:e}");
}

/// Down to the error of its linear traction, 2.5e-4 of the load at most.
#[test]
fn identity_the_fast_scheme_comes_to_the_numbers_of_the_others() {
    let reference = end("RungeKutta4(step: us(2))", &[]);
    for step in ["Fast(step: us(20))", "Fast(step: us(5))"] {
        let apart = distance(&end(step, &[]), &reference);
        // Of angular velocities of 3000 rad/s.
        assert!(apart < 0.3, "{step}: {apart} rad/s apart");
    }
}

/// Without differential slip all of a patch slides alike and friction settles a hundred times within a step of 20 µs.
#[test]
fn identity_the_fast_scheme_carries_stiff_friction() {
    let speeds = |scheme: &str| {
        let changes = [
            ("transient.duration", "s(0.006)"),
            ("traction.differential_slip", "false"),
            ("traction.patch", "SplitStrip(across: 8, along: 3)"),
            ("transient.scheme", scheme),
            ("recording.state_rate", "kHz(1)"),
            ("recording.ball_rate", "kHz(1)"),
        ];
        let (run, keep) = run(&case(&changes));
        assert!(run.stiffness().traction_rate_per_s * 2e-5 > 50.0, "{:?}", run.stiffness());
        keep.samples.last().unwrap().balls.iter().map(|b| b.orbital_speed_rad_s).collect::<Vec<_>>()
    };
    let (long, short) = (speeds("Fast(step: us(20))"), speeds("Fast(step: us(2))"));
    let worst = long.iter().zip(&short).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-3, "orbital speeds {worst:e} apart");
}

/// At a quarter of the axial load balls skid beyond the peak of the traction curve, where friction falls with growing
/// slip and an implicit step may divide by nothing: it did so here after 11 ms.
#[test]
fn regress_the_fast_scheme_stands_falling_friction() {
    let changes = [
        ("transient.duration", "s(0.012)"),
        ("traction.differential_slip", "false"),
        ("traction.patch", "TargetError(relative: 1e-5)"),
        ("ring.z.Force", "kN(13.69)"),
        ("transient.scheme", "Fast(step: us(20))"),
    ];
    let (_, keep) = run(&case(&changes));
    let speeds = keep.samples.last().unwrap().balls.iter().map(|b| b.orbital_speed_rad_s * 30.0 / std::f64::consts::PI);
    // Skidding balls between full rolling on the outer race and on the inner.
    assert!(speeds.into_iter().all(|rpm| (3000.0..8000.0).contains(&rpm)));
}

/// Local pressure leaves the patch without a derivative in closed form: friction is explicit then, and bounds the step.
#[test]
fn limit_the_fast_step_is_bounded_by_friction_without_a_derivative() {
    let bound =
        |pressure: &str| Run::new(case(&[("traction.pressure", pressure)]).run_inputs().unwrap()).unwrap().stiffness();
    let (peak, local) = (bound("Peak"), bound("Local"));
    assert_eq!(peak.fast_step_s, 2.0 / peak.contact_frequency_hz);
    let undamped = [("traction.pressure", "Peak"), ("transient.contact_damping", "0")];
    let undamped = Run::new(case(&undamped).run_inputs().unwrap()).unwrap().stiffness();
    assert_eq!(undamped.fast_step_s, 0.45 / undamped.contact_frequency_hz);
    assert_eq!(local.fast_step_s, 2.0 / local.traction_rate_per_s);
}

#[test]
fn identity_adaptive_and_fixed_steps_agree() {
    let reference = end("RungeKutta4(step: us(1))", &[]);
    let adaptive = end("DormandPrince(tolerance: 1e-8, longest: us(20))", &[]);
    let apart = distance(&adaptive, &reference);
    assert!(apart < 1e-5, "{apart:e} rad/s apart");
}

#[test]
fn identity_fast_kernel_gives_the_run_of_the_plain_one() {
    let case = case(&[("transient.duration", "s(0.0005)"), ("transient.scheme", "RungeKutta4(step: us(10))")]);
    let last = |mut run: Run| {
        let mut keep = Keep::default();
        let _ = run.advance(f64::INFINITY, &mut keep).unwrap();
        keep.samples.pop().unwrap()
    };
    let fast = last(Run::new(case.run_inputs().unwrap()).unwrap());
    let plain = last(Run::new(case.run_inputs().unwrap()).unwrap().with_plain_kernel().unwrap());
    assert!(distance(&fast, &plain) < 1e-8, "{:e}", distance(&fast, &plain));
}

/// Halving the step changes the mean cage speed by less than 1e-5 of it.
#[test]
fn identity_halving_the_step_hardly_moves_the_cage() {
    let mean = |scheme: &str| {
        let changes = [
            ("transient.duration", "s(0.004)"),
            ("cage.pocket_gap", "mm(0.02)"),
            ("transient.scheme", scheme),
            ("recording.state_rate", "kHz(10)"),
            ("recording.ball_rate", "kHz(1)"),
        ];
        let samples = run(&case(&changes)).1.samples;
        samples.iter().map(|s| s.cage.speed_rad_s).sum::<f64>() / samples.len() as f64
    };
    for (scheme, half) in
        [("RungeKutta4(step: us(10))", "RungeKutta4(step: us(5))"), ("Fast(step: us(20))", "Fast(step: us(10))")]
    {
        let (whole, half) = (mean(scheme), mean(half));
        assert!((whole / half - 1.0).abs() < 1e-5, "{scheme}: {whole} {half}");
    }
}

/// A run of a case, stopped after so many samples, saved as text and taken up again.
fn resumed(case: &Case, stop_after: usize) -> (Run, Keep) {
    let mut first = Run::new(case.run_inputs().unwrap()).unwrap();
    let mut keep = Keep { stop_after, ..Default::default() };
    let _ = first.advance(f64::INFINITY, &mut keep).unwrap();
    let text = serde_json::to_string(&first.checkpoint()).unwrap();
    let mut second = Run::new(case.run_inputs().unwrap()).unwrap();
    second.resume(serde_json::from_str(&text).unwrap()).unwrap();
    keep.stop_after = 0;
    let _ = second.advance(f64::INFINITY, &mut keep).unwrap();
    (second, keep)
}

/// Samples, events, counts and the last look at the stiffness. The fast scheme makes more than the 1000 steps between
/// two looks here, which go by the number of steps from the start, and coatings wear fast enough to get thinner.
#[test]
fn regress_a_checkpoint_goes_on_to_the_same_numbers() {
    for scheme in [
        "RungeKutta4(step: us(10))",
        "DormandPrince(tolerance: 1e-6, longest: us(10))",
        "Fast(step: us(20))",
        "Fast(step: us(1.5))",
    ] {
        let case = case(&[
            ("transient.duration", "s(0.002)"),
            ("transient.scheme", scheme),
            ("transient.wear_acceleration", "1e3"),
        ]);
        let (straight, whole) = run(&case);
        let (second, keep) = resumed(&case, 20);
        assert_eq!(keep.samples.len(), whole.samples.len(), "{scheme}");
        for (a, b) in keep.samples.iter().zip(&whole.samples) {
            assert_eq!(a, b, "{scheme} at {}", a.time_s);
        }
        assert_eq!(keep.events, whole.events, "{scheme}");
        assert_eq!(second.statistics(), straight.statistics(), "{scheme}");
        assert_eq!(second.stiffness(), straight.stiffness(), "{scheme}");
        assert!(second.checkpoint() == straight.checkpoint(), "{scheme}: the checkpoints at the end differ");
    }
}

/// A step beyond the bound is warned of once, whether the run was stopped before or not.
#[test]
fn regress_a_resumed_run_does_not_warn_again() {
    let case = case(&[
        ("traction.differential_slip", "false"),
        ("transient.scheme", "RungeKutta4(step: us(10))"),
        ("transient.duration", "s(0.0004)"),
    ]);
    let warnings = |keep: &Keep| keep.events.iter().filter(|e| matches!(e.kind, EventKind::Warning { .. })).count();
    let (whole, keep) = (run(&case).1, resumed(&case, 5).1);
    assert!(warnings(&whole) >= 1);
    assert_eq!(keep.events, whole.events);
}
