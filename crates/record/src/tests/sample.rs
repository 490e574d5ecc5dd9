//! A made-up run whose quantities are known functions of time.

use super::{BALLS, case};
use crate::{RecordError, RunRecorder, RunRecording, StreamSink};
use std::f64::consts::TAU;
use std::io::Cursor;
use std::ops::Range;
use std::path::Path;
use tribodyn_bearing::{
    BallMotionResult, BallResult, ContactResult, FluidResult, FrictionResult, PocketResult, Races, TransientContact,
};
use tribodyn_dynamics::{CageSample, Event, EventKind, Observer, PowerSample, RingSample, Sample, WearSample};

/// Speeds of shaft and cage, rad/s.
pub(super) const SHAFT: f64 = 14_000.0 * TAU / 60.0;
pub(super) const CAGE: f64 = 5_802.0 * TAU / 60.0;
/// Frequency of the outer ring's acceleration (Hz), on a line of a spectrum of 2048 samples at 10 kHz, and its
/// amplitude (m/s²).
pub(super) const TONE_HZ: f64 = 10_000.0 * 200.0 / 2048.0;
pub(super) const TONE_M_S2: f64 = 0.7;

fn contact(angle_deg: f64, load: f64) -> ContactResult {
    ContactResult {
        angle_rad: angle_deg.to_radians(),
        approach_m: 2.1e-5,
        load_n: load,
        semi_axes_m: [2.6e-3, 3.4e-4],
        peak_pressure_pa: 2.1e9 * (load / 4000.0).cbrt(),
        spin_ratio_per_m: 21.0,
        rolling_speed_m_s: 57.0,
        film: None,
        friction: Some(FrictionResult {
            traction_n: [95.0, -120.0],
            slide_to_roll: [-0.002, 0.001],
            power_loss_w: 900.0,
            wear_rate_m3_s: 3e-14,
            ..FrictionResult::default()
        }),
        transient: Some(TransientContact { damping_n: 12.5, bare: 0.25, depth_m: 1.5e-6 }),
    }
}

fn ball(index: usize, time: f64) -> BallResult {
    let lead = 2e-3 * (80.0 * time + index as f64).sin();
    let azimuth = TAU * index as f64 / BALLS as f64 + CAGE * time + lead;
    let load = 4000.0 + 1500.0 * azimuth.cos();
    BallResult {
        azimuth_rad: azimuth,
        orbital_speed_rad_s: CAGE + 0.16 * (80.0 * time + index as f64).cos(),
        orbit_radius_m: 0.083_79,
        radial_displacement_m: 1.29e-3,
        axial_displacement_m: 3e-5,
        angular_velocity_rad_s: [-3900.0, 900.0, 15.0],
        centrifugal_force_n: 3400.0,
        gyroscopic_moment_nm: 6.0,
        contacts: Races { inner: contact(24.0, load), outer: contact(17.0, load + 2300.0) },
        fluid: Some(FluidResult {
            drag_n: 170.0,
            churning_nm: [0.02, -0.005, 0.0],
            churning_w: 70.0,
            power_loss_w: 8700.0,
        }),
        pocket: Some(PocketResult {
            lead_rad: lead,
            force_n: -1.0e4 * lead,
            friction_n: Some([2.0, -1.0]),
            wear_rate_m3_s: 1e-15,
        }),
        motion: Some(BallMotionResult {
            orbital_acceleration_rad_s2: -12.8 * (80.0 * time + index as f64).sin(),
            velocity_m_s: [0.001, -0.002],
        }),
    }
}

/// The sample at a time, s.
pub(super) fn sample(time: f64) -> Sample {
    let ring = |speed: f64, acceleration: f64| RingSample {
        tilt_rad: [0.0; 2],
        angle_rad: speed * time,
        speed_rad_s: speed,
        displacement_m: [1.1e-5 * (SHAFT * time).cos(), 1.1e-5 * (SHAFT * time).sin(), 6.4e-5],
        velocity_m_s: [1e-3, 2e-3, 0.0],
        acceleration_m_s2: [acceleration, 0.2, 0.0],
        acceleration_point_m_s2: [acceleration, 0.2, 0.0],
        ball_force_n: [-9000.0, 0.0, -21_000.0],
        torque_nm: 11.0,
    };
    Sample {
        time_s: time,
        inner: ring(SHAFT, 5.0 * (TAU * 300.0 * time).sin()),
        outer: ring(0.0, TONE_M_S2 * (TAU * TONE_HZ * time).sin()),
        cage: CageSample {
            angle_rad: CAGE * time,
            speed_rad_s: CAGE + 0.05 * (90.0 * time).sin(),
            speed_filtered_rad_s: CAGE + 0.05 * (90.0 * time).sin(),
            ..CageSample::default()
        },
        power: PowerSample { shaft_w: 16_000.0, imbalance_j: 2e-6, throughput_j: 1000.0, ..PowerSample::default() },
        wear: WearSample {
            volume_inner_m3: 3e-14 * time,
            coating_inner_min_m: 1e-5,
            coating_outer_min_m: 9e-6,
            ..WearSample::default()
        },
        balls: (0..BALLS).map(|index| ball(index, time)).collect(),
    }
}

pub(super) fn impact(time_s: f64, ball: usize, speed: f64) -> Event {
    let kind = EventKind::Impact { ball, azimuth_deg: 372.25, closing_speed_m_s: speed, ball_leads: true };
    Event { time_s, kind }
}

pub(super) fn recording(made: &case::Made) -> RunRecording<'_> {
    let case::Made { name, inputs, .. } = made;
    RunRecording::new(case::TEXT, name, inputs, "tribodyn 0.1.0 (test)")
}

/// Feeds a recorder, or whoever else observes: states at `rate` Hz, every `stride`-th of them with balls, an impact
/// after every tenth.
pub(super) fn feed(
    recorder: &mut impl Observer<Error = RecordError>,
    samples: usize,
    rate: f64,
    stride: usize,
) -> Result<(), RecordError> {
    feed_from(recorder, 0..samples, rate, stride)
}

/// The same, a part of the samples.
pub(super) fn feed_from(
    recorder: &mut impl Observer<Error = RecordError>,
    samples: Range<usize>,
    rate: f64,
    stride: usize,
) -> Result<(), RecordError> {
    for index in samples {
        let time = index as f64 / rate;
        assert!(recorder.sample(&sample(time), index.is_multiple_of(stride))?.is_continue());
        if index % 10 == 9 {
            recorder.event(&impact(time + 0.3 / rate, index % BALLS, 0.01 * (index % 7) as f64))?;
        }
    }
    Ok(())
}

/// The bytes of a recorded run.
pub(super) fn run_bytes(samples: usize, rate: f64, stride: usize) -> Vec<u8> {
    let case = case::case(BALLS);
    let sink = StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
    let mut recorder = RunRecorder::new(sink, &recording(&case)).expect("a sound case");
    feed(&mut recorder, samples, rate, stride).expect("memory takes everything");
    recorder.finish().expect("memory takes everything").into_inner()
}
