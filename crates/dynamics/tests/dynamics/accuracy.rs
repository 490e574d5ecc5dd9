//! The fast scheme with a step by its accuracy, against the classical Runge–Kutta method well within its stability.

use crate::{Keep, OIL_6206, case};
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{Ending, Run, Sample};
use tribodyn_quasistatic::{Model, PatchRule, solve};

const ANGULAR_7210: &str = include_str!("../../../../fixtures/cases/angular-7210.ron");

/// Balls that meet no wall of their pockets.
const NO_POCKETS: (&str, &str) = ("cage.pocket_stiffness", "N_per_um(0)");

/// A case of a catalogue bearing from its equilibrium over 10 ms.
fn catalogue(text: &str, scheme: &str, change: (&str, &str)) -> Case {
    let start = ("transient.start", "QuasiStatic");
    let changes = [start, ("transient.scheme", scheme), ("transient.duration", "s(0.01)"), change];
    let text = changes.iter().fold(text.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap());
    Case::from_ron(&text).unwrap()
}

fn samples(case: &Case) -> (Run, Vec<Sample>) {
    let mut run = Run::new(case.run_inputs().unwrap()).unwrap();
    let mut keep = Keep::default();
    let _ = run.advance(f64::INFINITY, &mut keep).unwrap();
    (run, keep.samples)
}

/// Root mean square of how far the loads are apart over their mean, of the mean torque, of the angle that the cage
/// turned.
fn apart(a: &[Sample], b: &[Sample]) -> [f64; 3] {
    let loads = |s: &[Sample]| -> Vec<f64> {
        s.iter().flat_map(|s| s.balls.iter().flat_map(|b| [b.contacts.inner.load_n, b.contacts.outer.load_n])).collect()
    };
    let (ours, exact) = (loads(a), loads(b));
    let count = exact.len() as f64;
    let squares: f64 = ours.iter().zip(&exact).map(|(a, b)| (a - b).powi(2)).sum();
    let load = (squares / count).sqrt() / (exact.iter().sum::<f64>() / count);
    let torque = |s: &[Sample]| s.iter().map(|s| s.inner.torque_nm).sum::<f64>() / s.len() as f64;
    let turned = |s: &[Sample]| s.last().unwrap().cage.angle_rad;
    [load, (torque(a) / torque(b) - 1.0).abs(), (turned(a) / turned(b) - 1.0).abs()]
}

/// Loads within twice the accuracy asked for, which is an estimate from the first milliseconds, the torque within three
/// times, which has the linear traction's error besides, and the cage within a tenth of it.
#[test]
fn identity_the_step_by_accuracy_errs_as_asked_for() {
    let [of_6206, of_7210] = ["RungeKutta4(step: us(0.5))", "RungeKutta4(step: us(1))"];
    for (name, text, quarter) in [("6206", OIL_6206, of_6206), ("7210", ANGULAR_7210, of_7210)] {
        let (_, exact) = samples(&catalogue(text, quarter, NO_POCKETS));
        let (run, found) = samples(&catalogue(text, "FastTo(accuracy: 0.001)", NO_POCKETS));
        let choice = run.step_choice().unwrap();
        let errors = apart(&found, &exact);
        assert!(choice.errors.worst() <= 1e-3 && !choice.scatters, "{name}: {choice:?}");
        assert!(errors[0] < 2e-3 && errors[1] < 3e-3 && errors[2] < 2e-4, "{name}: {choice:?} {errors:?}");
    }
}

/// In oil the balls grip so well that in the middle of a kick, half of its change away from where friction acts, the
/// torque was off by 8.2e-3 in the mean at 13 µs. What is left is the linear traction's and a second-order part.
#[test]
fn code_torque_at_samples_is_that_of_runge_kutta() {
    let second_half = |scheme: &str| {
        let all = samples(&catalogue(ANGULAR_7210, scheme, NO_POCKETS)).1;
        all[all.len() / 2..].to_vec()
    };
    let errors = apart(&second_half("Fast(step: us(6.6))"), &second_half("RungeKutta4(step: us(1))"));
    assert!(errors[1] < 5e-3, "{errors:?}");
}

/// Samples have the forces that the kick gave rings and balls. By the linear form, whose bend a kick leaves out, a 608
/// at 5 µs had 2 % more power at its shaft than it lost, and this 7210 0.2 %.
#[test]
fn identity_samples_of_the_fast_scheme_have_the_power_that_is_lost() {
    let all = samples(&catalogue(ANGULAR_7210, "Fast(step: us(13))", NO_POCKETS)).1;
    let (last, mean) = (all.last().unwrap(), all.iter().map(|s| s.power.shaft_w).sum::<f64>() / all.len() as f64);
    let (off, work) = (last.power.imbalance_j, mean * last.time_s);
    assert!(off.abs() < 1e-3 * work.abs(), "{off:e} of {work:e} J");
}

/// A 6206 in steps of nine tenths of the period of its most loaded ball on its springs, damped by 2 %. Kicks drove such
/// a ball beyond all numbers within 2 ms, as the common acceleration followed what they set swinging.
#[test]
fn limit_kicks_drive_no_ball_on_its_springs() {
    let of = |scheme: &str| samples(&catalogue(OIL_6206, scheme, NO_POCKETS)).1;
    let errors = apart(&of("Fast(step: us(19.6))"), &of("RungeKutta4(step: us(0.5))"));
    assert!(errors[0] < 5e-2, "{errors:?}");
}

/// The same with waves of the balls, whose samples were off by a fifth while their patches were integrated at them.
#[test]
fn code_torque_at_samples_with_waves_of_balls_is_that_of_runge_kutta() {
    let waves = "(spectrum: (first: 2, last: 6, amplitude: um(0.1), exponent: 1, seed: 1))";
    let wavy = set_value(ANGULAR_7210, "deviations.ball_waves", waves).unwrap();
    let second_half = |scheme: &str| {
        let all = samples(&catalogue(&wavy, scheme, NO_POCKETS)).1;
        all[all.len() / 2..].to_vec()
    };
    let errors = apart(&second_half("Fast(step: us(13))"), &second_half("RungeKutta4(step: us(1))"));
    assert!(errors[0] < 5e-3 && errors[1] < 5e-3, "{errors:?}");
}

/// A ball that falls into a spall and strikes its far edge does so at another moment in every step: the shortest steps
/// that are tried do not come near enough, and the choice says what it leaves.
#[test]
fn limit_an_accuracy_that_no_step_reaches_is_said() {
    let spalls = "[(race: Outer, azimuth: deg(5), length: mm(1), width: mm(3), depth: um(50))]";
    let case = catalogue(OIL_6206, "FastTo(accuracy: 1e-6)", ("spalls", spalls));
    let choice = Run::new(case.run_inputs().unwrap()).unwrap().step_choice().unwrap();
    assert!(choice.errors.worst() > 1e-6, "{choice:?}");
}

/// A run starts from the equilibrium, where nothing drives a ball without load. When such balls stood still at first,
/// the others pushed the cage, the cage them, and a 6206 got steps of 0.3 µs.
#[test]
fn limit_balls_without_load_go_round_from_the_start() {
    let scheme = ("transient.scheme", "FastTo(accuracy: 0.001)");
    let run = Run::new(catalogue(OIL_6206, scheme.1, scheme).run_inputs().unwrap()).unwrap();
    let sample = run.sample();
    let speeds: Vec<f64> = sample.balls.iter().map(|ball| ball.orbital_speed_rad_s).collect();
    assert!(sample.balls.iter().any(|ball| ball.contacts.inner.load_n == 0.0));
    assert!(speeds.iter().all(|speed| (speed / sample.cage.speed_rad_s - 1.0).abs() < 1e-2), "{speeds:?}");
    let choice = run.step_choice().unwrap();
    assert!(choice.errors.worst() < 1e-3 && choice.step_s > 5e-6, "{choice:?}");
}

/// In oil strips with more nodes than there are strips do for a run what takes a solver more points.
#[test]
fn limit_a_run_in_oil_keeps_its_target_with_fewer_points() {
    let load = ("ring.x", "Force(N(2000))");
    let inputs = catalogue(OIL_6206, "RungeKutta4(step: us(0.1))", load).run_inputs().unwrap();
    let solved = solve(&inputs.bearing, &inputs.operating_point_at(0.0), Model::Traction).unwrap();
    let run = Run::new(inputs).unwrap();
    let points = |rule: PatchRule| match rule {
        PatchRule::SplitStrip { across, along } => across * along,
        other => panic!("{other:?}"),
    };
    let [ours, of_solver] = [run.patch_rule(), solved.warm_start.unwrap().rule()].map(points);
    assert!(4 * ours <= 3 * of_solver, "{ours} {of_solver}");
    assert!(run.solution().patch_error_estimate.unwrap() <= 1e-5);
}

/// Vibrations of the contacts would fold into the samples' spectra, unless they die out at once.
#[test]
fn limit_samples_see_what_contacts_vibrate_or_it_dies_out() {
    let of = |damping: &str| {
        let case = catalogue(ANGULAR_7210, "FastTo(accuracy: 0.1)", ("transient.contact_damping", damping));
        let run = Run::new(case.run_inputs().unwrap()).unwrap();
        run.step_s().unwrap() * run.stiffness().contact_frequency_hz
    };
    let [lightly, well] = ["0.02", "0.25"].map(of);
    assert!(lightly < 0.5 && well > 0.5, "{lightly} {well}");
}

/// A finer accuracy has a shorter step, and no step is longer than what stability allows.
#[test]
fn limit_a_finer_accuracy_has_a_shorter_step() {
    let step = |accuracy: &str| {
        let scheme = format!("FastTo(accuracy: {accuracy})");
        let run = Run::new(case(&[("transient.scheme", &scheme)]).run_inputs().unwrap()).unwrap();
        let (choice, limit) = (run.step_choice().unwrap(), run.stiffness().fast_step_s);
        assert!(choice.step_s < limit && run.step_s() == Some(choice.step_s), "{choice:?} {limit}");
        choice.step_s
    };
    let [coarse, fine] = [step("0.01"), step("1e-5")];
    assert!(fine < 0.7 * coarse, "{coarse} {fine}");
}

/// The oil in the pockets bounds no step that was chosen: films are as thick as it resolves. A run that took its own
/// step for one that may go wrong said so of every bearing with oil in its pockets.
#[test]
fn regress_a_chosen_step_is_within_the_stability_of_its_run() {
    let case = catalogue(OIL_6206, "FastTo(accuracy: 0.001)", ("transient.contact_damping", "0.25"));
    let mut run = Run::new(case.run_inputs().unwrap()).unwrap();
    let (step, limit) = (run.step_s().unwrap(), run.stiffness().fast_step_s);
    assert!(step <= limit, "{step} {limit}");
    assert_eq!(run.advance(f64::INFINITY, &mut Keep::default()).unwrap(), Ending::Complete);
}

/// Films grow with the speed: while linear forms had no derivative by it, losses in a run-up lagged behind by 0.7 %.
#[test]
fn code_losses_of_a_run_up_are_those_of_runge_kutta() {
    let up = set_value(OIL_6206, "speed.inner", "Table([(s(0), rpm(3000)), (s(0.01), rpm(3400))])").unwrap();
    let lost = |scheme: &str| {
        let all = samples(&catalogue(&up, scheme, NO_POCKETS)).1;
        all[all.len() / 2..].iter().map(|s| s.power.lost()).sum::<f64>()
    };
    let (fast, exact) = (lost("FastTo(accuracy: 0.001)"), lost("RungeKutta4(step: us(0.5))"));
    assert!((fast / exact - 1.0).abs() < 2e-3, "{}", fast / exact - 1.0);
}

/// Balls that follow one another come by the linear forms of those before them: 4 % of the patches of a 6206 were
/// integrated when each had only its own.
#[test]
fn regress_few_patches_are_integrated_once_balls_have_been_round() {
    let changes = [
        ("transient.start", "QuasiStatic"),
        ("transient.scheme", "FastTo(accuracy: 0.001)"),
        ("transient.contact_damping", "0.25"),
        ("transient.duration", "s(0.2)"),
    ];
    let text = changes.iter().fold(OIL_6206.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap());
    let mut run = Run::new(Case::from_ron(&text).unwrap().run_inputs().unwrap()).unwrap();
    let mut advance = |until: f64| {
        let _ = run.advance(until, &mut Keep::default()).unwrap();
        run.statistics()
    };
    // One and a half orbits of the cage, then another one and a half.
    let (half, end) = (advance(0.1), advance(0.2));
    let share = |integrated: u64, used: u64| integrated as f64 / used as f64;
    let (first, second) = (
        share(half.patches_integrated, half.patches_used),
        share(end.patches_integrated - half.patches_integrated, end.patches_used - half.patches_used),
    );
    assert!(first < 0.02 && second < 0.006, "{first:e}, {second:e}");
}
