//! Oil in contacts and pockets: the power balance, and whether all schemes have the same forces.

use crate::layout::{BALL, OMEGA, VELOCITY};
use crate::start::{Started, start};
use crate::stepping_test::{self, Scheme, imbalance};
use tribodyn_case::{Case, set_value};

const STEP: f64 = 5e-7;

/// The oil of the pockets as thick as that of cold gears, so that it counts.
const THICK: (&str, &str) = ("lubricant.oil", "Library(\"mineral-vg460\")");

/// The bearing in oil with some values of its case replaced.
fn started(changes: &[(&str, &str)]) -> Started {
    let text = include_str!("../../../fixtures/cases/oil-6206.ron").to_owned();
    let text = changes.iter().fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    start(Case::from_ron(&text).unwrap().run_inputs().unwrap(), None).unwrap()
}

/// From the start over a number of [`STEP`]s: the state, and the imbalance of the work over what is put in.
fn run(scheme: Scheme, steps: u32, changes: &[(&str, &str)]) -> (Vec<f64>, f64) {
    run_in(scheme, (STEP, steps), changes)
}

/// The same in steps of another length.
fn run_in(scheme: Scheme, (step, steps): (f64, u32), changes: &[(&str, &str)]) -> (Vec<f64>, f64) {
    let patch = [
        ("lubricant.patch", "SplitStrip(across: 5, along: 3)"),
        ("ring.z", "Force(N(400))"),
        ("transient.start", "QuasiStatic"),
    ];
    let changes: Vec<_> = patch.iter().chain(changes).copied().collect();
    let Started { mut machine, mut state, .. } = started(&changes);
    let before = machine.energy(0.0, &state);
    stepping_test::run(scheme, (&mut machine, &mut state), step, steps);
    let imbalance = imbalance(&machine, (f64::from(steps) * step, &state), before);
    (state, imbalance)
}

fn speeds(state: &[f64]) -> Vec<f64> {
    (0..9).flat_map(|k| state[BALL * k + VELOCITY..BALL * (k + 1)].to_vec()).collect()
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

#[test]
fn identity_power_balances_in_oil() {
    for scheme in [Scheme::RungeKutta, Scheme::DormandPrince] {
        for changes in [&[][..], &[THICK]] {
            let (_, off) = run(scheme, 1000, changes);
            assert!(off < 1e-9, "{scheme:?} {changes:?}: {off:e}");
        }
    }
}

#[test]
fn identity_all_schemes_have_the_oil_in_the_pockets() {
    let half = ("cage.pocket_film.fill", "0.5");
    for changes in [&[THICK][..], &[THICK, ("cage.free", FREE)]] {
        let thinner: Vec<_> = changes.iter().copied().chain([half]).collect();
        let exact = [changes, &thinner].map(|changes| speeds(&run(Scheme::RungeKutta, 400, changes).0));
        let fast = [changes, &thinner].map(|changes| speeds(&run(Scheme::Fast, 400, changes).0));
        let (effect, error) = (apart(&exact[0], &exact[1]), apart(&exact[0], &fast[0]));
        assert!(effect > 1e-4 && error < 0.3 * effect, "effect {effect:e}, error {error:e}");
        let effect_of_fast = apart(&fast[0], &fast[1]);
        assert!(
            (effect_of_fast / effect - 1.0).abs() < 0.1,
            "effect {effect:e}, in the fast scheme {effect_of_fast:e}"
        );
    }
}

/// A loaded ball whose rotation is off slides with all the traction of its oil, which then grows with slip no more. It
/// comes to rolling within some steps and stays there; by the tangent alone it went five times as far off again.
#[test]
fn limit_a_sliding_ball_comes_to_rolling_and_not_beyond() {
    let changes = [("transient.start", "QuasiStatic"), ("ring.x", "Force(N(0))"), ("ring.z", "Force(kN(5))")];
    let Started { mut machine, mut state, .. } = started(&changes);
    let at = machine.layout.ball(0) + OMEGA;
    let rolling = state[at];
    state[at] *= 1.02;
    state[at + 2] += 0.02 * rolling;
    let mut away = Vec::new();
    stepping_test::run_watched(Scheme::Fast, (&mut machine, &mut state), (12e-6, 40), |_, _, state| {
        away.push((state[at] / rolling - 1.0).hypot(state[at + 2] / rolling));
    });
    assert!(away[1..].iter().all(|away| *away < 4e-3), "{away:?}");
}

const FREE: &str = "(mass: g(7.6), transverse_inertia: kg_mm2(2.35), displacement: (um(20), um(0)), pockets: Cylinder)";

/// Steps in which balls vibrate up to three times are of second order where what vibrates has died out: balls are then
/// implicit in their springs.
#[test]
fn identity_long_steps_are_of_second_order() {
    let no_pockets = [("cage.pocket_stiffness", "N_per_um(0)")];
    let after = |scheme, step: f64| speeds(&run_in(scheme, (step, (2e-3 / step).round() as u32), &no_pockets).0);
    let exact = after(Scheme::RungeKutta, STEP);
    let errors = [32e-6, 16e-6, 8e-6].map(|step| apart(&exact, &after(Scheme::Fast, step)));
    let orders = [0, 1].map(|i| (errors[i] / errors[i + 1]).log2());
    assert!(orders.iter().all(|&order| order > 1.8) && errors[2] < 2e-3, "{orders:?}: {errors:?}");
}

/// Rings shake as by the Runge–Kutta method while balls enter and leave the load: their push along the races changes
/// within a millisecond. With pushes that friction was given over half of one, they were of first order.
#[test]
fn identity_rings_on_balls_that_enter_the_load_shake_as_by_runge_kutta() {
    let changes = [
        ("lubricant.patch", "SplitStrip(across: 5, along: 3)"),
        ("speed.inner", "Constant(rpm(4000))"),
        ("transient.start", "QuasiStatic"),
        ("transient.contact_damping", "0.25"),
        ("lubricant.shear", "LimitingShear"),
        ("geometry.fit", "RadialClearance(um(12.5))"),
        ("geometry.outer_groove", "Coefficient(0.53)"),
        ("ring.x", "Force(N(2000))"),
        ("ring.z", "Force(N(390))"),
    ];
    let Started { mut machine, mut state, .. } = started(&changes);
    // Until balls roll.
    stepping_test::run(Scheme::Fast, (&mut machine, &mut state), 5e-6, 1600);
    let rings = machine.layout.velocities_of_rings();
    // Changes of the rings' velocities over 20 µs each, one list a velocity.
    let shaking = |scheme, step: f64| {
        let (mut machine, mut state) = (machine.clone(), state.clone());
        let (every, mut changes) = ((2e-5 / step).round() as usize, vec![Vec::new(); rings.len()]);
        let (mut count, mut before) = (0, state.clone());
        stepping_test::run_watched(scheme, (&mut machine, &mut state), (step, 200 * every as u32), |_, _, state| {
            count += 1;
            if count % every == 0 {
                changes.iter_mut().zip(rings).for_each(|(list, k)| list.push(state[k] - before[k]));
                before.copy_from_slice(state);
            }
        });
        changes
    };
    let exact = shaking(Scheme::RungeKutta, STEP);
    let errors = [20e-6, 10e-6, 5e-6].map(|step| {
        let off = |(found, exact): (Vec<f64>, &Vec<f64>)| {
            let squares: f64 = found.iter().zip(exact).map(|(a, b)| (a - b).powi(2)).sum();
            (squares / exact.iter().map(|a| a * a).sum::<f64>()).sqrt()
        };
        shaking(Scheme::Fast, step).into_iter().zip(&exact).map(off).fold(0.0, f64::max)
    });
    // By the older way 0.082, 0.044 and 0.021. The longest step has two pieces, the shortest explicit balls.
    let most = [0.025, 0.015, 0.002];
    assert!(errors.iter().zip(most).all(|(error, most)| *error < most), "{errors:?}");
}
