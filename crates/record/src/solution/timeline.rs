//! One orbit of the cage in simulated time: when samples are taken, and how far everything has turned by then.

use crate::RecordError;
use prost_types::Timestamp;
use std::f64::consts::TAU;
use tribodyn_quasistatic::Solution;

/// Simulated time 0 as nanoseconds of Unix time: 2026-01-01 00:00 UTC. A fixed epoch makes the bytes reproducible;
/// a real date keeps viewers from showing 1970.
pub(crate) const EPOCH_NS: u64 = 1_767_225_600 * NS_PER_S;
const NS_PER_S: u64 = 1_000_000_000;

/// Least number of samples of state and balls in one orbit: a degree of cage angle or less between samples.
const SAMPLES_PER_ORBIT: usize = 360;
/// Wanted number of frame transforms and contact arrows in one turn of the faster ring.
const FRAMES_PER_TURN: f64 = 70.0;
/// Lowest cage speed that is recorded, r/min: one orbit in about seventeen hours.
const LEAST_CAGE_SPEED_RPM: f64 = 1e-3;

/// The samples of a recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Timeline {
    /// Time between samples, whole ns.
    pub(crate) step_ns: u64,
    /// Samples in one orbit; one more closes it.
    pub(crate) samples: usize,
    /// Samples from one set of frame transforms to the next.
    pub(crate) frame_stride: usize,
    /// Cage speed, rad/s.
    pub(crate) cage_speed: f64,
}

impl Timeline {
    /// Samples for a solution. Their number is a multiple of the ball count, so that every ball passes the azimuths
    /// at which the solver stood.
    pub(crate) fn new(solution: &Solution) -> Result<Self, RecordError> {
        let rpm = solution.cage_speed_rpm;
        if !rpm.is_finite() || rpm.abs() < LEAST_CAGE_SPEED_RPM {
            return Err(RecordError::NotOrbiting { cage_speed_rpm: rpm, least_rpm: LEAST_CAGE_SPEED_RPM });
        }
        let cage_speed = rpm * TAU / 60.0;
        let balls = solution.balls.len();
        let samples = balls * SAMPLES_PER_ORBIT.div_ceil(balls);
        let step_s = TAU / cage_speed.abs() / samples as f64;
        let ring_speed = solution.inner_speed_rad_s.abs().max(solution.outer_speed_rad_s.abs());
        let frame_step = TAU / FRAMES_PER_TURN / ring_speed.max(cage_speed.abs());
        Ok(Self {
            // Equal steps of whole nanoseconds: the orbit is off by half a step in a thousand at most.
            step_ns: ((step_s * NS_PER_S as f64).round() as u64).max(1),
            samples,
            frame_stride: ((frame_step / step_s).round() as usize).clamp(1, samples),
            cage_speed,
        })
    }

    /// Simulated time of a sample, s.
    pub(crate) fn seconds(&self, sample: usize) -> f64 {
        self.since_start(sample) as f64 / NS_PER_S as f64
    }

    /// Log time of a sample, ns since the Unix epoch.
    pub(crate) fn log_time(&self, sample: usize) -> u64 {
        EPOCH_NS + self.since_start(sample)
    }

    /// Angle of the cage at a sample, rad.
    pub(crate) fn cage_angle(&self, sample: usize) -> f64 {
        self.cage_speed * self.seconds(sample)
    }

    fn since_start(&self, sample: usize) -> u64 {
        self.step_ns * sample as u64
    }
}

/// A log time as a message field.
pub(crate) fn timestamp(log_time: u64) -> Timestamp {
    // Both fit: u64 nanoseconds are 1.8e10 seconds, the remainder is below 1e9.
    Timestamp { seconds: (log_time / NS_PER_S) as i64, nanos: (log_time % NS_PER_S) as i32 }
}
