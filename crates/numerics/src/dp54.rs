//! The embedded pair 5(4) of Dormand and Prince, that behind ode45: adaptive steps.
//!
//! Source: J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19, doi:10.1016/0771-050X(80)90013-3; step
//! control: proportional–integral after Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, 1993,
//! section II.4.

const STAGES: usize = 7;

// Dormand and Prince 1980, Table 2, RK5(4)7M: nodes, coefficients row by row, and the difference of the two solutions.
const NODES: [f64; STAGES] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];
const ROWS: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
const ERROR: [f64; STAGES] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// Stages and scratch of the method; after a step the last stage is the derivative at its end.
#[derive(Debug, Clone, Default)]
pub struct DormandPrince {
    k: [Vec<f64>; STAGES],
    y: Vec<f64>,
}

impl DormandPrince {
    /// From `y` with derivative `dy` at `t` over `h` to `next`; returns the largest error over `scale`. The
    /// `derivative` is that of unknowns at a time.
    pub fn step(
        &mut self,
        mut derivative: impl FnMut(f64, &[f64], &mut [f64]),
        t: f64,
        (y, dy): (&[f64], &[f64]),
        h: f64,
        scale: &[f64],
        next: &mut [f64],
    ) -> f64 {
        let n = y.len();
        self.y.resize(n, 0.0);
        self.k.iter_mut().for_each(|k| k.resize(n, 0.0));
        self.k[0].copy_from_slice(dy);
        for stage in 1..STAGES {
            let (done, rest) = self.k.split_at_mut(stage);
            for i in 0..n {
                let slope: f64 = done.iter().zip(&ROWS[stage - 1]).map(|(k, a)| a * k[i]).sum();
                self.y[i] = y[i] + h * slope;
            }
            derivative(t + NODES[stage] * h, &self.y, &mut rest[0]);
        }
        next.copy_from_slice(&self.y);
        let error = |i: usize| h * self.k.iter().zip(&ERROR).map(|(k, e)| e * k[i]).sum::<f64>();
        let mut worst = 0.0f64;
        for (i, s) in scale.iter().enumerate() {
            let e = (error(i) / s).abs();
            // A comparison would lose what is not a number.
            worst = if e.is_nan() { f64::INFINITY } else { worst.max(e) };
        }
        worst
    }

    /// Derivative at the end of the step just made.
    pub fn last_derivative(&self) -> &[f64] {
        &self.k[STAGES - 1]
    }
}

/// Chooses the next step.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct StepControl {
    /// The step to try next, s.
    pub step: f64,
    /// Error over tolerance of the last accepted step.
    last: f64,
}

impl StepControl {
    /// Begins with a step.
    pub fn new(step: f64) -> Self {
        Self { step, last: 1.0 }
    }

    /// True if a step with this error (1 is the tolerance) is kept; sets the next one.
    pub fn judge(&mut self, error: f64, h: f64, longest: f64) -> bool {
        let e = error.max(1e-10);
        if error <= 1.0 {
            // Exponents of the proportional and the integral part for order 5.
            let factor = 0.9 * e.powf(-0.7 / 5.0) * self.last.powf(0.4 / 5.0);
            self.step = (h * factor.clamp(0.2, 5.0)).min(longest);
            self.last = e;
            return true;
        }
        self.step = h * (0.9 * e.powf(-0.2)).clamp(0.1, 0.9);
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_rows_sum_to_their_nodes_and_errors_to_zero() {
        for (row, node) in ROWS.iter().zip(&NODES[1..]) {
            assert!((row.iter().sum::<f64>() - node).abs() < 1e-14);
        }
        assert!(ERROR.iter().sum::<f64>().abs() < 1e-15);
    }
}
