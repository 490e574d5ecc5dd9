//! `/tf` of a run, and how often frames and contacts are due.
//!
//! Frames and contacts take far more bytes than the numbers: they come with samples of the balls only, and no more
//! often than [`FRAMES_PER_TURN`] and [`CONTACTS_PER_TURN`] times a turn of whatever turns fastest. Contacts ride on
//! the frames, so fewer of them do not make the picture jump.

use super::overview::Overview;
use crate::frames::{Orientations, Poses};
use crate::quaternion::Rotation;
use crate::trail;
use crate::wire::foxglove::FrameTransforms;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tribodyn_bearing::BallResult;
use tribodyn_dynamics::{RingSample, Sample};

/// Most frame transforms in a turn.
const FRAMES_PER_TURN: f64 = 70.0;
/// Most sets of contact arrows and patches in a turn.
const CONTACTS_PER_TURN: f64 = 20.0;
/// Longest time between either, s, where little turns.
const LONGEST_S: f64 = 0.01;

/// State of a moving scene: orientations of the balls, and when frames and contacts were sent last.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Motion {
    orientations: Orientations,
    /// Time (s) and angular velocity (rad/s) of each ball at the last sample.
    last: Option<(f64, Vec<[f64; 3]>)>,
    frames: Due,
    contacts: Due,
}

/// When something was sent last: time (s) and angles of inner ring, outer ring and cage (rad).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
struct Due {
    last: Option<(f64, [f64; 3])>,
}

impl Due {
    fn due(&mut self, sample: &Sample, per_turn: f64) -> bool {
        let angles = [sample.inner.angle_rad, sample.outer.angle_rad, sample.cage.angle_rad];
        // A little less than the step, so that rounding does not skip a sample.
        let step = TAU / per_turn * (1.0 - 1e-6);
        let is_due = self.last.is_none_or(|(time, before)| {
            sample.time_s - time >= LONGEST_S || angles.iter().zip(before).any(|(now, then)| (now - then).abs() >= step)
        });
        if is_due {
            self.last = Some((sample.time_s, angles));
        }
        is_due
    }
}

impl Motion {
    pub(crate) fn new(balls: usize) -> Self {
        Self { orientations: Orientations::new(balls), last: None, frames: Due::default(), contacts: Due::default() }
    }

    /// Number of balls.
    pub(crate) fn balls(&self) -> usize {
        self.orientations.balls()
    }

    /// Number of balls at the last sample, if there was one.
    pub(super) fn last_balls(&self) -> Option<usize> {
        self.last.as_ref().map(|(_, speeds)| speeds.len())
    }

    /// All numbers.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> + '_ {
        let last = self.last.iter().flat_map(|(time, speeds)| speeds.iter().flatten().chain([time]));
        let due = [&self.frames, &self.contacts].into_iter().flat_map(|due| &due.last);
        last.copied()
            .chain(due.flat_map(|(time, angles)| angles.iter().copied().chain([*time])))
            .chain(self.orientations.values())
    }

    /// Turns the balls from the last sample to this one, by the mean of both angular velocities.
    pub(crate) fn advance(&mut self, overview: &Overview) {
        let (time_s, now) = (overview.time_s(), overview.angular_velocities_rad_s.iter().copied());
        if let Some((time, speeds)) = &mut self.last {
            let step = time_s - *time;
            for (index, (before, after)) in speeds.iter_mut().zip(now).enumerate() {
                let mean = [0, 1, 2].map(|k| 0.5 * (before[k] + after[k]));
                self.orientations.advance_one(index, mean, step);
                *before = after;
            }
            *time = time_s;
        } else {
            self.last = Some((time_s, now.collect()));
        }
    }

    pub(crate) fn frames_due(&mut self, sample: &Sample) -> bool {
        self.frames.due(sample, FRAMES_PER_TURN)
    }

    pub(crate) fn contacts_due(&mut self, sample: &Sample) -> bool {
        self.contacts.due(sample, CONTACTS_PER_TURN)
    }

    /// Sets the frames of a message that is empty or of another time.
    pub(crate) fn transforms(
        &self,
        (sample, balls): (&Sample, &[BallResult]),
        log_time: u64,
        message: &mut FrameTransforms,
    ) {
        let poses = Poses {
            log_time,
            inner: (sample.inner.displacement_m, tilted(&sample.inner)),
            outer: (sample.outer.displacement_m, tilted(&sample.outer)),
            cage: trail::place(&sample.cage),
            orientations: &self.orientations,
        };
        let balls = balls.iter().map(|b| [b.azimuth_rad, b.orbit_radius_m, b.axial_displacement_m]);
        poses.update(message, balls);
    }
}

/// Rotation of a ring that has turned, then tilted.
fn tilted(ring: &RingSample) -> Rotation {
    let turned = Rotation::about_z(ring.angle_rad);
    let [x, y] = ring.tilt_rad;
    // Rings without a tilt stay what they are to the last bit.
    if x == 0.0 && y == 0.0 { turned } else { Rotation::by_vector([x, y, 0.0]).after(turned) }
}
