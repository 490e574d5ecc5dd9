//! The classical Runge–Kutta method of fourth order with a fixed step: the paper's.

/// Stages and scratch of the method.
#[derive(Debug, Clone, Default)]
pub struct Rk4 {
    k: [Vec<f64>; 3],
    y: Vec<f64>,
}

impl Rk4 {
    /// From `y` with derivative `dy` at `t` over `h` to `next`, by the `derivative` of unknowns at a time.
    pub fn step(
        &mut self,
        mut derivative: impl FnMut(f64, &[f64], &mut [f64]),
        t: f64,
        (y, dy): (&[f64], &[f64]),
        h: f64,
        next: &mut [f64],
    ) {
        let n = y.len();
        self.y.resize(n, 0.0);
        self.k.iter_mut().for_each(|k| k.resize(n, 0.0));
        let [k2, k3, k4] = &mut self.k;
        for i in 0..n {
            self.y[i] = y[i] + 0.5 * h * dy[i];
        }
        derivative(t + 0.5 * h, &self.y, k2);
        for i in 0..n {
            self.y[i] = y[i] + 0.5 * h * k2[i];
        }
        derivative(t + 0.5 * h, &self.y, k3);
        for i in 0..n {
            self.y[i] = y[i] + h * k3[i];
        }
        derivative(t + h, &self.y, k4);
        for i in 0..n {
            next[i] = y[i] + h / 6.0 * (dy[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }
}
