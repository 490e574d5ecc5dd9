//! Whirl of a body from the path of its centre.
//!
//! About its mean place the centre goes round at the rate ω = arg(Σ conj(z_k) z_{k+1})/Δt, z = x + i y: each step
//! counts by the square of its distance, so that a passage near the centre, where the angle jumps, has no weight. It is
//! the pulse-pair estimate of a mean frequency: K. S. Miller, M. M. Rochwarger, IEEE Trans. Inf. Theory 18 (1972) 588,
//! doi:10.1109/TIT.1972.1054886. The rate is taken over windows; how it scatters from one to the next tells a steady
//! whirl from an irregular path.

use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Fewest windows that say something.
const FEWEST_WINDOWS: usize = 4;
/// Fewest points in a window.
const FEWEST_POINTS: usize = 8;
/// Spread of the rate over the faster of itself and the reference, and of the distance over its mean, from which a path
/// counts as irregular.
const IRREGULAR_RATE: f64 = 0.2;
const IRREGULAR_RADIUS: f64 = 0.5;
/// Distance of the rate from the reference up to which a body turns with it.
const WITH: f64 = 0.05;

/// Kinds of paths.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PathKind {
    /// It stays where it is, but for what is below the level asked for.
    Still,
    /// It goes round with the reference: the body is off centre and turns, no more.
    WithReference,
    /// It goes round at a rate of its own.
    Whirls,
    /// Neither rate nor distance is steady.
    Irregular,
}

/// The path of a centre over some time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Whirl {
    /// Mean place.
    pub mean: [f64; 2],
    /// Root of the mean square of the distance from it.
    pub radius_rms: f64,
    /// Largest distance from it.
    pub radius_max: f64,
    /// Rate about it over the reference; below 0 backward.
    pub ratio: f64,
    /// Standard deviation of that ratio over the windows.
    pub ratio_spread: f64,
    /// Windows.
    pub windows: usize,
    /// Kind of the path.
    pub kind: PathKind,
}

/// The whirl of a path whose points are `step` (s) apart, against a rotation at `reference` (rad/s); `still` is the
/// distance below which nothing moves. A window is a turn of the faster of both. None where the path has less than four
/// windows.
pub fn whirl(path: &[[f64; 2]], step: f64, reference: f64, still: f64) -> Option<Whirl> {
    if path.len() < FEWEST_WINDOWS * FEWEST_POINTS || reference == 0.0 {
        return None;
    }
    let count = path.len() as f64;
    let mean = [0, 1].map(|k| path.iter().map(|z| z[k]).sum::<f64>() / count);
    let from_mean: Vec<[f64; 2]> = path.iter().map(|z| [z[0] - mean[0], z[1] - mean[1]]).collect();
    let distances = || from_mean.iter().map(|z| z[0].hypot(z[1]));
    let square = distances().map(|d| d * d).sum::<f64>() / count;
    let mean_distance = distances().sum::<f64>() / count;
    let rate = |points: &[[f64; 2]]| {
        let pairs = points.windows(2);
        let [real, imaginary] = pairs.fold([0.0; 2], |[real, imaginary], pair| {
            let ([x, y], [u, v]) = (pair[0], pair[1]);
            [real + x * u + y * v, imaginary + x * v - y * u]
        });
        imaginary.atan2(real) / (step * reference)
    };
    let ratio = rate(&from_mean);
    let turn = TAU / (reference.abs() * ratio.abs().max(1.0) * step);
    let windows = path.len() / (turn.ceil() as usize).max(FEWEST_POINTS);
    if windows < FEWEST_WINDOWS {
        return None;
    }
    let rates: Vec<f64> = from_mean.chunks_exact(path.len() / windows).map(rate).collect();
    let spread = rates.iter().map(|r| (r - ratio).powi(2)).sum::<f64>() / rates.len() as f64;
    let ratio_spread = spread.sqrt();
    // With d² = mean² + variance.
    let radius_spread = (square - mean_distance * mean_distance).max(0.0).sqrt();
    let kind = if square.sqrt() < still {
        PathKind::Still
    } else if ratio_spread > IRREGULAR_RATE * ratio.abs().max(1.0) || radius_spread > IRREGULAR_RADIUS * mean_distance {
        PathKind::Irregular
    } else if (ratio - 1.0).abs() < WITH {
        PathKind::WithReference
    } else {
        PathKind::Whirls
    };
    Some(Whirl {
        mean,
        radius_rms: square.sqrt(),
        radius_max: distances().fold(0.0, f64::max),
        ratio,
        ratio_spread,
        windows: rates.len(),
        kind,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: f64 = 1.0 / 25_600.0;
    const REFERENCE: f64 = 120.0;

    fn path(at: impl Fn(f64) -> [f64; 2]) -> Whirl {
        let path: Vec<[f64; 2]> = (0..25_600).map(|k| at(STEP * f64::from(k))).collect();
        whirl(&path, STEP, REFERENCE, 1e-9).unwrap()
    }

    fn circle(rate: f64, radius: f64, centre: [f64; 2]) -> impl Fn(f64) -> [f64; 2] {
        move |t| {
            let (sin, cos) = (rate * t).sin_cos();
            [centre[0] + radius * cos, centre[1] + radius * sin]
        }
    }

    #[test]
    fn limit_a_circle_has_its_rate_forward_and_backward() {
        for (ratio, kind) in [
            (1.0, PathKind::WithReference),
            (0.45, PathKind::Whirls),
            (-3.2, PathKind::Whirls),
            (60.0, PathKind::Whirls),
        ] {
            let found = path(circle(ratio * REFERENCE, 5e-5, [2e-5, -7e-5]));
            assert!((found.ratio / ratio - 1.0).abs() < 0.01, "{found:?}");
            assert!((found.radius_rms / 5e-5 - 1.0).abs() < 0.02 && found.kind == kind, "{found:?}");
        }
    }

    #[test]
    fn limit_a_body_that_stays_is_still_and_a_short_path_says_nothing() {
        assert_eq!(path(|_| [3e-5, 0.0]).kind, PathKind::Still);
        let short: Vec<[f64; 2]> = (0..1000).map(|k| circle(120.0, 1e-5, [0.0; 2])(STEP * f64::from(k))).collect();
        assert_eq!(whirl(&short, STEP, REFERENCE, 1e-9), None);
        // A body that hardly turns can whirl all the same.
        let fast: Vec<[f64; 2]> = (0..1000).map(|k| circle(-6e3, 1e-5, [0.0; 2])(STEP * f64::from(k))).collect();
        let found = whirl(&fast, STEP, 3.0, 1e-9).unwrap();
        assert!(found.kind == PathKind::Whirls && (found.ratio / -2000.0 - 1.0).abs() < 0.01, "{found:?}");
        assert_eq!(whirl(&short, STEP, 0.0, 1e-9), None);
    }

    /// Passing close by the centre turns the angle by half a turn at once, which must not count.
    #[test]
    fn identity_a_rate_is_robust_near_the_centre() {
        // An ellipse whose short axis is a hundredth of the long one, forward.
        let found = path(|t| {
            let (sin, cos) = (0.5 * REFERENCE * t).sin_cos();
            [1e-4 * cos, 1e-6 * sin]
        });
        assert!(found.ratio.abs() < 0.02, "{found:?}");
    }

    /// A walk by the generator of Park and Miller.
    #[test]
    fn identity_a_random_walk_is_irregular() {
        let mut seed = 42u64;
        let mut random = || {
            seed = seed * 48_271 % 2_147_483_647;
            seed as f64 / 2_147_483_647.0 - 0.5
        };
        let mut z = [0.0f64; 2];
        let mut walk = Vec::new();
        for _ in 0..25_600 {
            z = [0.998 * z[0] + random(), 0.998 * z[1] + random()];
            walk.push(z);
        }
        assert_eq!(whirl(&walk, STEP, REFERENCE, 1e-9).unwrap().kind, PathKind::Irregular);
    }
}
