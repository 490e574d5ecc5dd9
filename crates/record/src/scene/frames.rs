//! The frames of `/tf`: world > bearing > inner_ring, outer_ring, cage, orbit_00 > ball_00, …
//!
//! Frame orbit_j is the ball's azimuth frame, origin at the ball centre, axes (axial, radial, tangential). In it the
//! ball turns by its relative angular velocity ω, dq/dt = ½ ω q, advanced by the exponential of ω at the middle of each
//! step: exact for a constant ω, second order in the step where ω varies over azimuth (with 360 steps an orbit and an
//! angular velocity that changes by a percent over it, 3e-6 rad in all).

use crate::quaternion::{Rotation, vector};
use crate::timeline::{Timeline, timestamp};
use crate::wire::foxglove::{FrameTransform, FrameTransforms};
use serde::{Deserialize, Serialize};
use tribodyn_bearing::BallResult;
use tribodyn_quasistatic::OverAzimuth;
use tribodyn_quasistatic::Solution;

/// Frame of the bearing: origin at the plane of the unloaded ball centres, Z axial.
pub(crate) const BEARING: &str = "bearing";
/// Frame of the inner ring.
pub(crate) const INNER_RING: &str = "inner_ring";
/// Frame of the outer ring.
pub(crate) const OUTER_RING: &str = "outer_ring";
/// Frame of the cage.
pub(crate) const CAGE: &str = "cage";

/// Azimuth frame of a ball.
pub(crate) fn orbit(ball: usize) -> String {
    format!("orbit_{ball:02}")
}

/// Turning frame of a ball.
pub(crate) fn ball(ball: usize) -> String {
    format!("ball_{ball:02}")
}

/// The orientation of every ball in its azimuth frame, as it turns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Orientations {
    rotations: Vec<Rotation>,
}

impl Orientations {
    /// All balls aligned with their azimuth frames.
    pub(crate) fn new(balls: usize) -> Self {
        Self { rotations: vec![Rotation::IDENTITY; balls] }
    }

    /// Number of balls.
    pub(crate) fn balls(&self) -> usize {
        self.rotations.len()
    }

    /// All numbers.
    pub(crate) fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.rotations.iter().flat_map(|r| r.vector.into_iter().chain([r.real]))
    }

    /// Advances all balls from a sample to the next.
    pub(crate) fn advance(&mut self, over: &OverAzimuth, timeline: &Timeline, sample: usize) {
        let middle = 0.5 * (timeline.cage_angle(sample) + timeline.cage_angle(sample + 1));
        let step = timeline.seconds(sample + 1) - timeline.seconds(sample);
        for (index, rotation) in self.rotations.iter_mut().enumerate() {
            let angular_velocity = over.at(over.start(index) + middle).angular_velocity_rad_s;
            *rotation = Rotation::by_vector(angular_velocity.map(|w| w * step)).after(*rotation).unit();
        }
    }

    /// Advances ball `index` by its angular velocity relative to the azimuth frame, rad/s, over a step, s.
    pub(crate) fn advance_one(&mut self, index: usize, angular_velocity: [f64; 3], step: f64) {
        let rotation = &mut self.rotations[index];
        *rotation = Rotation::by_vector(angular_velocity.map(|w| w * step)).after(*rotation).unit();
    }
}

/// Where rings, cage and balls are at one time.
pub(crate) struct Poses<'a> {
    pub(crate) log_time: u64,
    /// Displacement of the inner ring, m, and its rotation.
    pub(crate) inner: ([f64; 3], Rotation),
    /// The same of the outer ring.
    pub(crate) outer: ([f64; 3], Rotation),
    /// Displacement of the cage's centre, m, and its rotation.
    pub(crate) cage: ([f64; 3], Rotation),
    pub(crate) orientations: &'a Orientations,
}

/// All frames at one sample of a solution. Azimuths of `balls` are not wrapped.
pub(crate) fn transforms(
    solution: &Solution,
    timeline: &Timeline,
    sample: usize,
    balls: &[BallResult],
    orientations: &Orientations,
) -> FrameTransforms {
    let time = timeline.seconds(sample);
    let [tilt_x, tilt_y] = solution.ring_tilt_rad;
    let shaft = Rotation::by_vector([tilt_x, tilt_y, 0.0]).after(Rotation::about_z(solution.inner_speed_rad_s * time));
    let poses = Poses {
        log_time: timeline.log_time(sample),
        inner: (solution.ring_displacement_m, shaft),
        outer: ([0.0; 3], Rotation::about_z(solution.outer_speed_rad_s * time)),
        cage: ([0.0; 3], Rotation::about_z(timeline.cage_angle(sample))),
        orientations,
    };
    let mut message = FrameTransforms::default();
    poses.update(&mut message, balls.iter().map(|b| [b.azimuth_rad, b.orbit_radius_m, b.axial_displacement_m]));
    message
}

/// Frames that are there whatever the number of balls.
const FIXED: usize = 4;

impl Poses<'_> {
    /// All frames; each ball by azimuth (rad), orbit radius and axial position (m). `message` is empty or that of
    /// another time: making its names anew would cost more than all of the numbers.
    pub(crate) fn update(&self, message: &mut FrameTransforms, balls: impl Iterator<Item = [f64; 3]>) {
        if message.transforms.is_empty() {
            message.transforms = named(self.orientations.balls());
        }
        let stamp = timestamp(self.log_time);
        let place = |frame: &mut FrameTransform, at: [f64; 3], turned: Rotation| {
            frame.timestamp = Some(stamp);
            frame.translation = Some(vector(at));
            frame.rotation = Some(turned.message());
        };
        let (fixed, of_balls) = message.transforms.split_at_mut(FIXED);
        let poses: [_; FIXED] = [([0.0; 3], Rotation::IDENTITY), self.inner, self.outer, self.cage];
        for (frame, (at, turned)) in fixed.iter_mut().zip(poses) {
            place(frame, at, turned);
        }
        let orientations = &self.orientations.rotations;
        for ((pair, spun), [azimuth, radius, axial]) in of_balls.chunks_exact_mut(2).zip(orientations).zip(balls) {
            let turned = Rotation::about_z(azimuth);
            let [cos, sin] = turned.direction();
            let centre = [radius * cos, radius * sin, axial];
            place(&mut pair[0], centre, turned.after(Rotation::AXIAL_RADIAL_TANGENTIAL));
            place(&mut pair[1], [0.0; 3], *spun);
        }
    }
}

/// The names of all frames, in the order in which [`Poses::update`] sets them.
fn named(balls: usize) -> Vec<FrameTransform> {
    let frame = |parent: &str, child: String| FrameTransform {
        parent_frame_id: parent.into(),
        child_frame_id: child,
        ..FrameTransform::default()
    };
    let mut all = vec![frame("world", BEARING.into())];
    all.extend([INNER_RING, OUTER_RING, CAGE].map(|child| frame(BEARING, child.into())));
    for index in 0..balls {
        all.extend([frame(BEARING, orbit(index)), frame(&orbit(index), ball(index))]);
    }
    all
}
