//! Radau's points on Prothero and Robinson's equation (Math. Comp. 28 (1974) 145): y' = λ (y − cos t) − sin t, whose
//! solution is cos t however stiff it is.

use nalgebra::{Matrix3, Vector3};
use tribodyn_numerics::Radau;

/// Error at t = 1 after so many intervals.
fn error(stiffness: f64, intervals: usize) -> f64 {
    let (radau, h) = (Radau::new(), 1.0 / intervals as f64);
    let mut y = 1.0;
    for j in 0..intervals {
        let times = radau.points.map(|c| (j as f64 + c) * h);
        // The slopes of the polynomial at its points are those of the equation there, linear in the values.
        let slope = |i: usize, k: usize| radau.slope[i][k];
        let left = Matrix3::from_fn(|i, k| slope(i, k) - if i == k { h * stiffness } else { 0.0 });
        let right = Vector3::from_fn(|i, _| {
            let begin: f64 = (0..3).map(|k| slope(i, k)).sum::<f64>() * y;
            begin - h * (stiffness * times[i].cos() + times[i].sin())
        });
        y = left.lu().solve(&right).unwrap()[2];
    }
    (y - 1f64.cos()).abs()
}

#[test]
fn order_of_radaus_points_is_five_where_nothing_is_stiff() {
    let order = (error(-1.0, 4) / error(-1.0, 8)).log2();
    assert!((order - 5.0).abs() < 0.15, "{order}");
}

/// Where it is stiff, the order of the stages is left; the error falls with the stiffness.
#[test]
fn limit_stiff_equations_are_met_by_long_intervals() {
    assert!(error(-1e3, 4) < 1e-6 && error(-1e6, 4) < 1e-9 && error(-1e9, 4) < 1e-12);
    let order = (error(-1e6, 8) / error(-1e6, 16)).log2();
    assert!(order > 2.8, "{order}");
}

#[test]
fn identity_a_polynomial_of_third_degree_is_its_own_interpolant() {
    let radau = Radau::new();
    let cubic = |x: f64| 1.0 + x * (2.0 + x * (-3.0 + 4.0 * x));
    let shares = radau.shares(0.37);
    let there = shares[0] + (0..3).map(|k| shares[k + 1] * cubic(radau.points[k])).sum::<f64>();
    assert!((there - cubic(0.37)).abs() < 1e-14);
    // And Radau's weights integrate one of fourth degree.
    let integral: f64 = (0..3).map(|k| radau.weights[k] * radau.points[k].powi(4)).sum();
    assert!((integral - 0.2).abs() < 1e-15);
}
