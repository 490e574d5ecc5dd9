//! A free cage in a run: its path, whirl and lands.

use serde::Serialize;
use std::f64::consts::TAU;
use tribodyn_record::StateRow;
use tribodyn_signal::{PathKind, Whirl, whirl};

/// Distance from its mean place, µm, below which a cage counts as still: roughness of its lands.
const STILL_UM: f64 = 0.1;

/// A free cage over some rows of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CageBlock {
    /// Mean place, µm.
    pub place: [f64; 2],
    /// Largest forces of the lands of inner and outer ring, N, and tilt, mrad.
    pub largest: [f64; 3],
    /// Smallest gap, µm.
    pub gap: f64,
}

impl CageBlock {
    /// Of a row; none where the cage turns only.
    pub fn of(r: &StateRow) -> Option<Self> {
        r.cage_free.then(|| Self {
            place: [r.cage_x_um, r.cage_y_um],
            largest: [
                r.land_inner_x_n.hypot(r.land_inner_y_n),
                r.land_outer_x_n.hypot(r.land_outer_y_n),
                r.cage_tilt_x_mrad.hypot(r.cage_tilt_y_mrad),
            ],
            gap: r.land_gap_um,
        })
    }

    /// This one of `a` rows and one of `b` after it.
    pub fn and(&self, next: &Self, [a, b]: [f64; 2]) -> Self {
        Self {
            place: [0, 1].map(|k| (a * self.place[k] + b * next.place[k]) / (a + b)),
            largest: std::array::from_fn(|k| self.largest[k].max(next.largest[k])),
            gap: self.gap.min(next.gap),
        }
    }
}

/// The free cage of a run; means and extremes are over the time of the other averages.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CageMotion {
    /// Mean displacement of its centre along X, µm.
    pub mean_x_um: f64,
    /// Mean displacement along Y, µm.
    pub mean_y_um: f64,
    /// Distance of the centre from its mean place, rms, µm.
    pub radius_rms_um: f64,
    /// Largest distance from the mean place, µm.
    pub radius_max_um: f64,
    /// Speed at which the centre goes round its mean place over the cage's speed; below 0 backward. None where the time
    /// is too short to say.
    pub whirl_ratio: Option<f64>,
    /// Standard deviation of that ratio from one turn of the cage to the next.
    pub whirl_ratio_spread: Option<f64>,
    /// Kind of the path.
    pub motion: Option<PathKind>,
    /// Largest tilt, mrad.
    pub tilt_max_mrad: f64,
    /// Largest force of the inner ring's lands, N.
    pub land_force_inner_max_n: f64,
    /// Largest force of the outer ring's lands, N.
    pub land_force_outer_max_n: f64,
    /// Smallest gap at the lands, µm, negative where an edge is pressed.
    pub land_gap_min_um: f64,
}

impl CageMotion {
    /// Of blocks that follow each other every `step` s, of a cage that turns at a speed, r/min; none where it is not
    /// free.
    pub(super) fn of(blocks: &[CageBlock], step: f64, cage_speed_rpm: f64) -> Option<Self> {
        let first = blocks.first()?;
        let path: Vec<[f64; 2]> = blocks.iter().map(|block| block.place).collect();
        let found = whirl(&path, step, cage_speed_rpm * TAU / 60.0, STILL_UM);
        let count = path.len() as f64;
        let [mean_x_um, mean_y_um] = [0, 1].map(|k| path.iter().map(|z| z[k]).sum::<f64>() / count);
        let distances = path.iter().map(|z| (z[0] - mean_x_um).hypot(z[1] - mean_y_um));
        let all = blocks.iter().fold(*first, |all, block| all.and(block, [1.0; 2]));
        let steady = found.filter(|whirl| whirl.kind != PathKind::Still);
        Some(Self {
            mean_x_um,
            mean_y_um,
            radius_rms_um: (distances.clone().map(|d| d * d).sum::<f64>() / count).sqrt(),
            radius_max_um: distances.fold(0.0, f64::max),
            whirl_ratio: steady.map(|whirl: Whirl| whirl.ratio),
            whirl_ratio_spread: steady.map(|whirl| whirl.ratio_spread),
            motion: found.map(|whirl| whirl.kind),
            tilt_max_mrad: all.largest[2],
            land_force_inner_max_n: all.largest[0],
            land_force_outer_max_n: all.largest[1],
            land_gap_min_um: all.gap,
        })
    }

    /// The verdict as a sentence.
    pub fn sentence(&self) -> String {
        match (self.motion, self.whirl_ratio) {
            (Some(PathKind::Still), _) => "stays in its place".to_owned(),
            (Some(PathKind::WithReference), _) => "turns with the ball group".to_owned(),
            (Some(PathKind::Whirls), Some(ratio)) => format!("whirls at {ratio:.2} of the cage's speed"),
            (Some(PathKind::Irregular), _) => "irregular".to_owned(),
            _ => "too short to tell: averages over four turns are needed".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_verdicts_of_plain_paths() {
        let block = |x: f64, y: f64| CageBlock { place: [x, y], largest: [1.0, 0.0, 0.2], gap: 40.0 };
        let path = |ratio: f64, radius: f64| {
            let at = |k: u32| (ratio * TAU * 20.0 * 1e-4 * f64::from(k)).sin_cos();
            let blocks = (0..5000).map(|k| block(radius * at(k).1 + 30.0, radius * at(k).0)).collect::<Vec<_>>();
            CageMotion::of(&blocks, 1e-4, 1200.0).unwrap()
        };
        assert_eq!(path(1.0, 20.0).sentence(), "turns with the ball group");
        assert_eq!(path(-0.5, 20.0).sentence(), "whirls at -0.50 of the cage's speed");
        assert_eq!(path(1.0, 0.01).sentence(), "stays in its place");
        assert!((path(1.0, 20.0).radius_rms_um - 20.0).abs() < 0.1);
        assert_eq!(CageMotion::of(&[], 1e-4, 1200.0), None);
        let short = CageMotion::of(&[block(0.0, 0.0); 9], 1e-4, 1200.0).unwrap();
        assert_eq!((short.motion, short.whirl_ratio, short.land_gap_min_um), (None, None, 40.0));
    }
}
