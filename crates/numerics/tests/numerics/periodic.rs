//! Van der Pol's limit cycle, u'' = μ (1 − u²) u' − u, by collocation: its period is the unknown of the border, and
//! that it begins at a crest the border's equation.

use nalgebra::SMatrix;
use std::f64::consts::TAU;
use tribodyn_numerics::{Change, DormandPrince, Interval, Periodic, Radau, StepControl, bisect, hermite};

const PLACES: usize = 2;
const POINTS: usize = 3 * PLACES;
type Linear = Periodic<PLACES, POINTS, 1, 3>;

/// Derivative and its slopes by u and v = u'.
fn van_der_pol(mu: f64, [u, v]: [f64; 2]) -> ([f64; 2], [[f64; 2]; 2]) {
    ([v, mu * (1.0 - u * u) * v - u], [[0.0, 1.0], [-2.0 * mu * u * v - 1.0, mu * (1.0 - u * u)]])
}

/// A cycle on a mesh of equal intervals.
#[derive(Clone)]
struct Cycle {
    values: Vec<[f64; POINTS]>,
    period: f64,
}

impl Cycle {
    fn circle(intervals: usize) -> Self {
        let place = |j: usize, i: usize| TAU * (j as f64 + Radau::new().points[i]) / intervals as f64;
        let pair = |phase: f64| [2.0 * phase.cos(), -2.0 * phase.sin()];
        let of = |j: usize| std::array::from_fn(|n| pair(place(j, n / 2))[n % 2]);
        Self { values: (0..intervals).map(of).collect(), period: TAU }
    }

    fn place(&self, j: usize, i: usize) -> [f64; 2] {
        [self.values[j][2 * i], self.values[j][2 * i + 1]]
    }

    fn begin(&self, j: usize) -> [f64; 2] {
        self.place((j + self.values.len() - 1) % self.values.len(), 2)
    }

    /// Residuals of the equations, of which the border's is that the cycle begins at rest, and their slopes.
    fn equations(&self, mu: f64) -> (Change<POINTS, 1>, Vec<Interval<POINTS, 1, 3>>) {
        let (radau, h) = (Radau::new(), 1.0 / self.values.len() as f64);
        let (mut lacking, mut slopes) = (Vec::new(), Vec::new());
        for j in 0..self.values.len() {
            let begin = self.begin(j);
            let mut r = [0.0; POINTS];
            let mut own = Box::new(SMatrix::<f64, POINTS, POINTS>::zeros());
            let mut right = Box::new(SMatrix::<f64, POINTS, 3>::zeros());
            let mut rows = Box::new(SMatrix::<f64, 1, POINTS>::zeros());
            for i in 0..3 {
                let (f, by) = van_der_pol(mu, self.place(j, i));
                for a in 0..2 {
                    let row = 2 * i + a;
                    for k in 0..3 {
                        let slope = radau.slope[i][k];
                        r[row] += slope * (self.values[j][2 * k + a] - begin[a]);
                        own[(row, 2 * k + a)] += slope;
                        right[(row, a)] += slope;
                    }
                    r[row] -= h * self.period * f[a];
                    (0..2).for_each(|b| own[(row, 2 * i + b)] -= h * self.period * by[a][b]);
                    right[(row, 2)] = h * f[a];
                }
            }
            if j + 1 == self.values.len() {
                rows[(0, 5)] = 1.0;
            }
            lacking.push(r);
            slopes.push(Interval { own, right, rows });
        }
        (Change { values: lacking, border: [self.begin(0)[1]] }, slopes)
    }

    fn change(&mut self, step: &Change<POINTS, 1>) {
        let steps = step.values.iter().flatten();
        self.values.iter_mut().flatten().zip(steps).for_each(|(v, d)| *v += d);
        self.period += step.border[0];
    }

    /// Newton's method: the cycle, its Jacobian, and Jacobians taken; each serves while it halves what is lacking.
    fn solved(mut self, mu: f64, chord: bool) -> (Self, Linear, usize) {
        for jacobians in 1..20 {
            let (mut lacking, slopes) = self.equations(mu);
            let linear = Linear::new(slopes, &[[0.0]]).unwrap();
            let mut taken = vec![linear.step(&lacking.values, &lacking.border)];
            while let Some(step) = taken.last() {
                self.change(step);
                let before = lacking.norm();
                lacking = self.equations(mu).0;
                if lacking.norm() < 1e-13 {
                    return (self, linear, jacobians);
                }
                if !chord || lacking.norm() > 0.5 * before {
                    break;
                }
                let next = linear.step(&lacking.values, &lacking.border).corrected(&taken).lengthened(step);
                taken.push(next);
            }
        }
        panic!("no cycle");
    }
}

/// Period for μ = 1, by Dormand and Prince's scheme from crest to crest of the settled cycle.
fn period_by_time() -> f64 {
    let mut equation = |_t: f64, y: &[f64], dy: &mut [f64]| dy.copy_from_slice(&van_der_pol(1.0, [y[0], y[1]]).0);
    let (mut scheme, mut control) = (DormandPrince::default(), StepControl::new(1e-3));
    let (mut t, mut y, mut dy) = (0.0, [2.0, 0.0], [0.0, -2.0]);
    let mut crests = Vec::new();
    while crests.len() < 6 {
        let (h, mut next) = (control.step, [0.0; 2]);
        let error = scheme.step(&mut equation, t, (&y, &dy), h, &[1e-13; 2], &mut next);
        if !control.judge(error, h, 2e-3) {
            continue;
        }
        let slopes = [h * dy[1], h * scheme.last_derivative()[1]];
        if t > 0.0 && y[1] > 0.0 && next[1] <= 0.0 {
            crests.push(t + h * bisect(|s| hermite(s, [y[1], next[1]], slopes), true));
        }
        dy.copy_from_slice(scheme.last_derivative());
        (t, y) = (t + h, next);
    }
    crests[5] - crests[4]
}

#[test]
fn code_the_period_of_van_der_pols_cycle_is_that_of_integration_in_time() {
    const INTERVALS: usize = 320;
    let (cycle, linear, _) = Cycle::circle(INTERVALS).solved(1.0, false);
    let exact = period_by_time();
    assert!((cycle.period - exact).abs() < 1e-9, "{} {exact}", cycle.period);
    // A shift along the cycle stays; both multipliers together are what an area shrinks by (Liouville).
    let multipliers = linear.transfer().complex_eigenvalues();
    let divergence: f64 = (0..INTERVALS)
        .flat_map(|j| (0..3).map(move |i| (j, i)))
        .map(|(j, i)| Radau::new().weights[i] * (1.0 - cycle.place(j, i)[0].powi(2)) / INTERVALS as f64)
        .sum();
    let product = (multipliers[0] * multipliers[1]).re;
    assert!(multipliers.iter().any(|m| (m.re - 1.0).abs() < 1e-6), "{multipliers:?}");
    assert!((product / (divergence * cycle.period).exp() - 1.0).abs() < 1e-5, "{product:e}");
}

#[test]
fn order_of_the_period_is_five() {
    let period = |intervals| Cycle::circle(intervals).solved(1.0, false).0.period;
    let exact = period(320);
    let order = ((period(40) - exact) / (period(80) - exact)).abs().log2();
    assert!((order - 5.0).abs() < 0.4, "{order}");
}

/// From one cycle to the next stiffer one; what a Jacobian errs by is learnt from the steps taken with it.
#[test]
fn code_jacobians_from_a_circle_along_rising_damping() {
    let mut counts = Vec::new();
    for chord in [false, true] {
        let mut cycle = Cycle::circle(80);
        for mu in [0.2, 0.5, 1.0, 1.5, 2.0] {
            let (found, _, jacobians) = cycle.solved(mu, chord);
            counts.push(format!("μ = {mu}: {jacobians} Jacobians, period {:.6}", found.period));
            cycle = found;
        }
    }
    insta::assert_snapshot!(counts.join("\n"), @"
    μ = 0.2: 3 Jacobians, period 6.298877
    μ = 0.5: 4 Jacobians, period 6.380676
    μ = 1: 4 Jacobians, period 6.663287
    μ = 1.5: 5 Jacobians, period 7.096373
    μ = 2: 5 Jacobians, period 7.629870
    μ = 0.2: 1 Jacobians, period 6.298877
    μ = 0.5: 1 Jacobians, period 6.380676
    μ = 1: 1 Jacobians, period 6.663287
    μ = 1.5: 2 Jacobians, period 7.096373
    μ = 2: 2 Jacobians, period 7.629870
    ");
}

#[test]
fn limit_equations_without_a_border_of_their_own_are_singular() {
    let (_, mut slopes) = Cycle::circle(8).equations(1.0);
    slopes.iter_mut().for_each(|interval| interval.rows.fill(0.0));
    assert!(Linear::new(slopes, &[[0.0]]).is_err());
}
