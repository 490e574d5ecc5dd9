//! Single balls of a solution, and how far their contacts reach.

use tribodyn_bearing::BallResult;
use tribodyn_quasistatic::Solution;

/// Contact angle beyond which no shoulder reaches, degrees: at 75° it would be 0.39 of the ball diameter high.
pub(super) const SHOULDER_MAX_DEG: f64 = 75.0;

/// The ball with the largest value of something, and that value, where it is a number.
pub(super) fn largest(solution: &Solution, of: impl Fn(&BallResult) -> Option<f64>) -> Option<(&BallResult, f64)> {
    let known = solution.balls.iter().filter_map(|ball| of(ball).filter(|value| value.is_finite()).map(|v| (ball, v)));
    known.max_by(|a, b| a.1.total_cmp(&b.1))
}

pub(super) fn at(ball: &BallResult) -> String {
    format!("ball at {:.1}°", ball.azimuth_rad.to_degrees())
}
