//! Explicit schemes: an oscillator for the order, Arenstorf's orbit for the control of steps.

use std::f64::consts::TAU;
use tribodyn_numerics::{DormandPrince, Rk4, StepControl, bisect, hermite};

fn oscillator(_t: f64, y: &[f64], dy: &mut [f64]) {
    (dy[0], dy[1]) = (y[1], -y[0]);
}

fn derivative(equation: fn(f64, &[f64], &mut [f64]), t: f64, y: &[f64]) -> Vec<f64> {
    let mut dy = vec![0.0; y.len()];
    equation(t, y, &mut dy);
    dy
}

/// Error of an oscillator after a period of so many equal steps.
fn error(steps: usize, mut step: impl FnMut(f64, (&[f64], &[f64]), f64, &mut [f64])) -> f64 {
    let (h, mut y) = (TAU / steps as f64, vec![1.0, 0.0]);
    for n in 0..steps {
        let (t, mut next) = (n as f64 * h, vec![0.0; 2]);
        step(t, (&y, &derivative(oscillator, t, &y)), h, &mut next);
        y = next;
    }
    (y[0] - 1.0).hypot(y[1])
}

#[test]
fn order_of_runge_and_kutta_is_four_and_of_dormand_and_prince_five() {
    let rk4 = |steps| {
        let mut scheme = Rk4::default();
        error(steps, |t, y, h, next| scheme.step(oscillator, t, y, h, next))
    };
    let dp54 = |steps| {
        let mut scheme = DormandPrince::default();
        error(steps, |t, y, h, next| {
            scheme.step(oscillator, t, y, h, &[1.0; 2], next);
        })
    };
    let orders = [rk4(40) / rk4(80), dp54(40) / dp54(80)].map(f64::log2);
    assert!((orders[0] - 4.0).abs() < 0.05 && (orders[1] - 5.0).abs() < 0.05, "{orders:?}");
}

/// Three bodies, of which one is small (E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I,
/// 1993, section II.0): in the frame that turns with the other two.
fn arenstorf(_t: f64, y: &[f64], dy: &mut [f64]) {
    const SMALL: f64 = 0.012277471;
    let cube = |x: f64| x.hypot(y[1]).powi(3);
    let (earth, moon) = (cube(y[0] + SMALL), cube(y[0] - (1.0 - SMALL)));
    (dy[0], dy[1]) = (y[2], y[3]);
    dy[2] = y[0] + 2.0 * y[3] - (1.0 - SMALL) * (y[0] + SMALL) / earth - SMALL * (y[0] - 1.0 + SMALL) / moon;
    dy[3] = y[1] - 2.0 * y[2] - (1.0 - SMALL) * y[1] / earth - SMALL * y[1] / moon;
}

/// Distance from the start after a period, steps kept and rejected.
fn round_arenstorf(tolerance: f64) -> (f64, usize, usize) {
    const PERIOD: f64 = 17.065_216_560_157_963;
    let start = [0.994, 0.0, 0.0, -2.001_585_106_379_082_5];
    let (mut scheme, mut control) = (DormandPrince::default(), StepControl::new(1e-4));
    let (mut t, mut y) = (0.0, start.to_vec());
    let mut dy = derivative(arenstorf, t, &y);
    let (mut kept, mut rejected) = (0, 0);
    while PERIOD - t > 1e-13 {
        let (h, mut next) = (control.step.min(PERIOD - t), vec![0.0; 4]);
        let error = scheme.step(arenstorf, t, (&y, &dy), h, &[tolerance; 4], &mut next);
        if control.judge(error, h, 1.0) {
            (t, y) = (t + h, next);
            dy.copy_from_slice(scheme.last_derivative());
            kept += 1;
        } else {
            rejected += 1;
        }
    }
    ((y[0] - start[0]).hypot(y[1] - start[1]), kept, rejected)
}

#[test]
fn code_arenstorfs_orbit_closes_and_takes_so_many_steps() {
    let counts = [1e-8, 1e-10, 1e-12].map(|tolerance| {
        let (off, kept, rejected) = round_arenstorf(tolerance);
        // Passing the moon magnifies what is left behind.
        assert!(off < 3e5 * tolerance, "{off:e} at {tolerance:e}");
        format!("{tolerance:e}: {kept} steps, {rejected} rejected")
    });
    insta::assert_snapshot!(counts.join("\n"), @"
    1e-8: 485 steps, 6 rejected
    1e-10: 1214 steps, 0 rejected
    1e-12: 3054 steps, 1 rejected
    ");
}

#[test]
fn limit_what_is_no_number_is_rejected() {
    let mut broken = |_t: f64, _y: &[f64], dy: &mut [f64]| dy[0] = f64::NAN;
    let (mut control, mut next) = (StepControl::new(0.1), [0.0]);
    let error = DormandPrince::default().step(&mut broken, 0.0, (&[1.0], &[0.0]), 0.1, &[1.0], &mut next);
    assert!(error == f64::INFINITY && !control.judge(error, 0.1, 1.0) && control.step < 0.011);
}

#[test]
fn identity_a_cubic_is_found_to_its_root() {
    // (s - 0.3)(s² + 1), by its values and slopes at both ends.
    let cubic = |s: f64| hermite(s, [-0.3, 1.4], [1.0, 3.4]);
    assert!((bisect(cubic, false) - 0.3).abs() < 1e-14);
    assert!((bisect(|s| -cubic(s), true) - 0.3).abs() < 1e-14);
}
