//! The frames of `/tf`: world > bearing > inner_ring, outer_ring, cage, orbit_00 > ball_00, …
//!
//! Frame orbit_j is the ball's azimuth frame, origin at the ball centre, axes (axial, radial, tangential). In it the
//! ball turns by its relative spin ω, dq/dt = ½ ω q, advanced by the exponential of ω at the middle of each step:
//! exact for a constant ω, second order in the step where ω varies over azimuth (with 360 steps an orbit and a spin
//! that changes by a percent over it, 3e-6 rad in all).

use crate::quaternion::{Rotation, vector};
use crate::timeline::{Timeline, timestamp};
use crate::wire::foxglove::{FrameTransform, FrameTransforms};
use tribodyn_quasistatic::OverAzimuth;
use tribodyn_quasistatic::{BallSolution, Solution};

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

/// Spinning frame of a ball.
pub(crate) fn ball(ball: usize) -> String {
    format!("ball_{ball:02}")
}

/// The orientation of every ball in its azimuth frame, as it spins on.
pub(crate) struct Spins {
    rotations: Vec<Rotation>,
}

impl Spins {
    /// All balls aligned with their azimuth frames.
    pub(crate) fn new(balls: usize) -> Self {
        Self { rotations: vec![Rotation::IDENTITY; balls] }
    }

    /// Advances all balls from a sample to the next.
    pub(crate) fn advance(&mut self, over: &OverAzimuth, timeline: &Timeline, sample: usize) {
        let middle = 0.5 * (timeline.cage_angle(sample) + timeline.cage_angle(sample + 1));
        let step = timeline.seconds(sample + 1) - timeline.seconds(sample);
        for (index, rotation) in self.rotations.iter_mut().enumerate() {
            let spin = over.at(over.start(index) + middle).spin_rad_s;
            *rotation = Rotation::by_vector(spin.map(|w| w * step)).after(*rotation).unit();
        }
    }
}

/// All frames at one sample. `balls` holds each ball with its azimuth unwrapped, rad.
pub(crate) fn transforms(
    solution: &Solution,
    timeline: &Timeline,
    sample: usize,
    balls: &[(f64, BallSolution)],
    spins: &Spins,
) -> FrameTransforms {
    let stamp = timestamp(timeline.log_time(sample));
    let time = timeline.seconds(sample);
    let frame = |parent: &str, child: String, at: [f64; 3], turned: Rotation| FrameTransform {
        timestamp: Some(stamp),
        parent_frame_id: parent.into(),
        child_frame_id: child,
        translation: Some(vector(at)),
        rotation: Some(turned.message()),
    };
    let [tilt_x, tilt_y] = solution.ring_tilt_rad;
    let shaft = Rotation::by_vector([tilt_x, tilt_y, 0.0]).after(Rotation::about_z(solution.inner_speed_rad_s * time));
    let outer = Rotation::about_z(solution.outer_speed_rad_s * time);
    let cage = Rotation::about_z(timeline.cage_angle(sample));
    let mut transforms = vec![
        frame("world", BEARING.into(), [0.0; 3], Rotation::IDENTITY),
        frame(BEARING, INNER_RING.into(), solution.ring_displacement_m, shaft),
        frame(BEARING, OUTER_RING.into(), [0.0; 3], outer),
        frame(BEARING, CAGE.into(), [0.0; 3], cage),
    ];
    for (index, (azimuth, state)) in balls.iter().enumerate() {
        let radius = state.orbit_radius_m;
        let centre = [radius * azimuth.cos(), radius * azimuth.sin(), state.axial_displacement_m];
        let turned = Rotation::about_z(*azimuth).after(Rotation::AXIAL_RADIAL_TANGENTIAL);
        transforms.push(frame(BEARING, orbit(index), centre, turned));
        transforms.push(frame(&orbit(index), ball(index), [0.0; 3], spins.rotations[index]));
    }
    FrameTransforms { transforms }
}
