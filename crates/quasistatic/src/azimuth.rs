//! Quantities of a ball at any azimuth, from the solved ones at N equispaced azimuths.
//!
//! Smooth periodic data f_j at φ_j = φ_0 + 2πj/N have one trigonometric interpolant of least degree,
//! f(φ) = Σ_j D(φ − φ_j) f_j, with the cardinal function D(x) = sin(Nx/2)/(N sin(x/2)) for odd N and
//! D(x) = sin(Nx/2) cos(x/2)/(N sin(x/2)) for even N (Trefethen, Spectral Methods in MATLAB, 2000,
//! doi:10.1137/1.9780898719598, chapter 3). It converges exponentially where the solution is analytic in φ.
//! A ball that loses contact makes the data kink, and the interpolant would ring through zero load: then every
//! quantity is interpolated linearly. Pocket force and pocket wear have a dead band and are always linear.

use crate::{BallSolution, Solution};
use std::f64::consts::TAU;

/// How quantities are interpolated over azimuth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AzimuthRule {
    /// Trigonometric: all balls carry load at both races.
    Trigonometric,
    /// Piecewise linear: some ball has lost contact.
    Linear,
}

impl AzimuthRule {
    /// The rule that suits a solution.
    pub fn of(solution: &Solution) -> Self {
        let loaded = |ball: &BallSolution| ball.load_inner_n > 0.0 && ball.load_outer_n > 0.0;
        if solution.balls.iter().all(loaded) { AzimuthRule::Trigonometric } else { AzimuthRule::Linear }
    }

    /// Name for the metadata of the recording.
    pub fn name(self) -> &'static str {
        match self {
            AzimuthRule::Trigonometric => "trigonometric",
            AzimuthRule::Linear => "linear",
        }
    }
}

/// Weights of N equispaced values, the first at `first`, for the value at `azimuth` (both rad); they sum to 1.
fn weights(rule: AzimuthRule, count: usize, first: f64, azimuth: f64) -> Vec<f64> {
    let spacing = TAU / count as f64;
    match rule {
        AzimuthRule::Trigonometric => {
            (0..count).map(|j| cardinal(count, azimuth - first - spacing * j as f64)).collect()
        }
        AzimuthRule::Linear => {
            let place = (azimuth - first).rem_euclid(TAU) / spacing;
            let left = place.floor();
            let mut out = vec![0.0; count];
            // rem_euclid may round up to the full circle: wrap the index.
            out[left as usize % count] += 1.0 - (place - left);
            out[(left as usize + 1) % count] += place - left;
            out
        }
    }
}

fn cardinal(count: usize, x: f64) -> f64 {
    let n = count as f64;
    // Near a full turn the two sines would vanish with different rounding errors: reduce to a half turn first.
    let x = x - TAU * (x / TAU).round();
    let half = (0.5 * x).sin();
    // At a node the quotient is 0/0, its limit 1.
    if half == 0.0 {
        return 1.0;
    }
    let even = if count.is_multiple_of(2) { (0.5 * x).cos() } else { 1.0 };
    (0.5 * n * x).sin() * even / (n * half)
}

/// Writes down each scalar field of [`BallSolution`] once: what interpolates it, and its name for error messages.
macro_rules! ball_scalars {
    (smooth: $($smooth:ident),*; positive: $($positive:ident),*; threshold: $($threshold:ident),*;) => {
        /// A ball at `azimuth_deg`, from the weights of the solution's rule and the linear ones.
        fn blend(balls: &[BallSolution], rule: &[f64], linear: &[f64], azimuth_deg: f64) -> BallSolution {
            let sum = |weights: &[f64], get: fn(&BallSolution) -> f64| -> f64 {
                weights.iter().zip(balls).map(|(w, ball)| w * get(ball)).sum()
            };
            BallSolution {
                azimuth_deg,
                $($smooth: sum(rule, |b| b.$smooth),)*
                // The interpolant of a positive quantity may undershoot.
                $($positive: sum(rule, |b| b.$positive).max(0.0),)*
                $($threshold: sum(linear, |b| b.$threshold),)*
                semi_axes_inner_m: [0, 1].map(|i| axis(balls, rule, |b| b.semi_axes_inner_m, i).max(0.0)),
                semi_axes_outer_m: [0, 1].map(|i| axis(balls, rule, |b| b.semi_axes_outer_m, i).max(0.0)),
                spin_rad_s: [0, 1, 2].map(|i| axis(balls, rule, |b| b.spin_rad_s, i)),
            }
        }

        /// Every number of a ball with the name of its field.
        pub fn ball_numbers(ball: &BallSolution) -> Vec<(&'static str, f64)> {
            let mut out = vec![("azimuth_deg", ball.azimuth_deg)];
            $(out.push((stringify!($smooth), ball.$smooth));)*
            $(out.push((stringify!($positive), ball.$positive));)*
            $(out.push((stringify!($threshold), ball.$threshold));)*
            out.extend(ball.semi_axes_inner_m.map(|v| ("semi_axes_inner_m", v)));
            out.extend(ball.semi_axes_outer_m.map(|v| ("semi_axes_outer_m", v)));
            out.extend(ball.spin_rad_s.map(|v| ("spin_rad_s", v)));
            out
        }
    };
}

ball_scalars! {
    smooth: contact_angle_inner_deg, contact_angle_outer_deg, approach_inner_m, approach_outer_m,
        orbital_speed_rad_s, orbit_radius_m, axial_displacement_m, drag_n,
        traction_inner_n, traction_outer_n, lateral_traction_inner_n, lateral_traction_outer_n,
        slide_to_roll_inner, slide_to_roll_outer, lateral_slide_to_roll_inner, lateral_slide_to_roll_outer,
        spin_ratio_inner, spin_ratio_outer, rolling_speed_inner_m_s, rolling_speed_outer_m_s, pocket_lead_rad;
    positive: load_inner_n, load_outer_n, peak_pressure_inner_pa, peak_pressure_outer_pa,
        centrifugal_force_n, gyroscopic_moment_nm, power_loss_inner_w, power_loss_outer_w, power_loss_fluid_w,
        wear_rate_inner_m3_s, wear_rate_outer_m3_s;
    threshold: cage_force_n, wear_rate_cage_m3_s;
}

fn axis<const N: usize>(
    balls: &[BallSolution],
    weights: &[f64],
    get: fn(&BallSolution) -> [f64; N],
    index: usize,
) -> f64 {
    weights.iter().zip(balls).map(|(w, ball)| w * get(ball)[index]).sum()
}

/// The solution as a function of azimuth.
#[derive(Debug, Clone)]
pub struct OverAzimuth<'a> {
    balls: &'a [BallSolution],
    rule: AzimuthRule,
    first: f64,
}

impl<'a> OverAzimuth<'a> {
    /// Takes the balls of a solution: at least one, equispaced, as the solver gives them.
    pub fn new(solution: &'a Solution) -> Self {
        Self {
            balls: &solution.balls,
            rule: AzimuthRule::of(solution),
            first: solution.balls[0].azimuth_deg.to_radians(),
        }
    }

    /// Azimuth of a ball at the start, rad.
    pub fn start(&self, ball: usize) -> f64 {
        self.first + TAU * ball as f64 / self.balls.len() as f64
    }

    /// The state of a ball at this azimuth, rad, between those of the solution.
    pub fn at(&self, azimuth: f64) -> BallSolution {
        let count = self.balls.len();
        let rule = weights(self.rule, count, self.first, azimuth);
        let linear = weights(AzimuthRule::Linear, count, self.first, azimuth);
        blend(self.balls, &rule, &linear, azimuth.rem_euclid(TAU).to_degrees())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_trigonometric_weights_reproduce_harmonics_below_the_nyquist_one() {
        for count in [1_usize, 2, 5, 8, 13, 16] {
            for step in 0..50 {
                let azimuth = 0.37 + 0.21 * f64::from(step);
                let w = weights(AzimuthRule::Trigonometric, count, 0.3, azimuth);
                for order in 0..count.div_ceil(2) {
                    let k = order as f64;
                    let f = |phi: f64| (k * phi + 0.4).cos();
                    let node = |j: usize| 0.3 + TAU * j as f64 / count as f64;
                    let value: f64 = w.iter().enumerate().map(|(j, w)| w * f(node(j))).sum();
                    assert!((value - f(azimuth)).abs() < 1e-12, "N {count}, order {order}");
                }
            }
        }
    }

    #[test]
    fn identity_both_rules_return_the_nodes_and_sum_to_one() {
        for rule in [AzimuthRule::Trigonometric, AzimuthRule::Linear] {
            for count in [1_usize, 2, 13] {
                for node in 0..3 * count {
                    let azimuth = 0.3 + TAU * node as f64 / count as f64;
                    let w = weights(rule, count, 0.3, azimuth);
                    assert!((w[node % count] - 1.0).abs() < 1e-12, "{rule:?} {count} {node}");
                    let between: f64 = weights(rule, count, 0.3, azimuth + 0.1).iter().sum();
                    assert!((between - 1.0).abs() < 1e-12);
                }
            }
        }
    }
}
