//! Tests of whole recordings, on a made-up solution whose quantities are known functions of azimuth.

mod case;
mod chunks;
mod content;
mod file;
mod free_cage;
mod layout;
#[cfg(feature = "live")]
mod live;
mod memory;
mod messages;
mod recover;
mod rows;
mod run;
mod sample;
mod scene;
mod start;

use crate::SolutionRecording;
use crate::wire::{foxglove, tribodyn};
use crate::write::Recording;
use prost::Message;
use std::io::Cursor;
use std::path::PathBuf;
use tribodyn_bearing::{BallResult, ContactResult, FluidResult, FrictionResult, PocketResult, Races};
use tribodyn_quasistatic::{Model, Solution};

const BALLS: usize = 13;

/// A ball as a function of azimuth, rad: harmonics up to the second.
fn ball(azimuth: f64) -> BallResult {
    let (one, two) = (azimuth.cos(), (2.0 * azimuth).sin());
    let load = 4000.0 + 1500.0 * one + 60.0 * two;
    let inner = ContactResult {
        angle_rad: (24.0 - 2.0 * one).to_radians(),
        approach_m: 2.1e-5 + 4e-6 * one,
        load_n: load,
        peak_pressure_pa: 2.1e9 + 3.3e8 * one,
        semi_axes_m: [2.6e-3 + 4e-4 * one, 3.4e-4 + 5e-5 * one],
        rolling_speed_m_s: 57.0,
        spin_ratio_per_m: 21.0 + one,
        film: None,
        friction: Some(FrictionResult {
            traction_n: [95.0 + 8.0 * one, -120.0 + 5.0 * two],
            slide_to_roll: [-0.002 * one, 0.001],
            power_loss_w: 900.0 + 200.0 * one,
            wear_rate_m3_s: 3e-14 + 1e-14 * one,
            ..FrictionResult::default()
        }),
        transient: None,
    };
    let outer = ContactResult {
        angle_rad: (17.0 + one).to_radians(),
        approach_m: 2.9e-5 + 4e-6 * one,
        load_n: load + 2300.0,
        peak_pressure_pa: 2.0e9 + 2.2e8 * one,
        semi_axes_m: [2.9e-3 + 4e-4 * one, 4.4e-4 + 5e-5 * one],
        rolling_speed_m_s: 61.0,
        spin_ratio_per_m: 3.0 + one,
        film: None,
        friction: Some(FrictionResult {
            traction_n: [60.0 - 8.0 * one, 118.0 + 5.0 * two],
            slide_to_roll: [0.001 + 0.0005 * two, 0.002 * one],
            power_loss_w: 400.0 + 90.0 * one,
            wear_rate_m3_s: 1e-14 + 3e-15 * one,
            ..FrictionResult::default()
        }),
        transient: None,
    };
    BallResult {
        azimuth_rad: azimuth,
        orbital_speed_rad_s: 607.6 + 1.5 * two,
        orbit_radius_m: 0.083_79 + 2e-5 * one,
        radial_displacement_m: 1.29e-3 + 2e-5 * one,
        axial_displacement_m: 3e-5 - 1e-5 * one,
        angular_velocity_rad_s: [-3900.0 - 20.0 * one, 900.0 + 40.0 * one, 15.0 * two],
        centrifugal_force_n: 3400.0,
        gyroscopic_moment_nm: 6.0 + 0.1 * one,
        contacts: Races { inner, outer },
        fluid: Some(FluidResult { drag_n: 170.0, power_loss_w: 8600.0, ..FluidResult::default() }),
        pocket: Some(PocketResult {
            lead_rad: 2e-3 * one,
            force_n: (80.0 * one - 40.0).max(0.0),
            friction_n: None,
            wear_rate_m3_s: (2e-15 * one - 1e-15).max(0.0),
        }),
        motion: None,
    }
}

/// The ring around such balls.
fn solution(balls: usize) -> Solution {
    let azimuth = |j: usize| std::f64::consts::TAU * j as f64 / balls as f64;
    Solution {
        model: Model::Traction,
        converged: true,
        stable: None,
        cage_speed_rpm: 5802.0,
        ring_displacement_m: [1.1e-5, -2e-6, 6.4e-5],
        ring_tilt_rad: [1e-5, 2e-5],
        ring_load_n: [9000.0, 0.0, 21_000.0],
        ring_moment_nm: [0.0, 0.0],
        shaft_torque_nm: Some(11.0),
        inner_speed_rad_s: 14_000.0 * std::f64::consts::TAU / 60.0,
        outer_speed_rad_s: 0.0,
        residual: 3e-12,
        iterations: 14,
        patch_error_estimate: Some(2e-5),
        warnings: vec!["pressure below the tests at 9 balls".into(), "second root at ball 6".into()],
        balls: (0..balls).map(|j| ball(azimuth(j))).collect(),
    }
}

/// A path of its own for one test.
fn path(test: &str) -> PathBuf {
    std::env::temp_dir().join(format!("tribodyn-record-{}-{test}.mcap", std::process::id()))
}

fn input<'a>(made: &'a case::Made, solution: &'a Solution) -> SolutionRecording<'a> {
    let case::Made { name, inputs, point } = made;
    let (case_text, generator) = (case::TEXT, "tribodyn 0.1.0 (test)");
    SolutionRecording { case_text, name, bearing: &inputs.bearing, point, solution, generator }
}

/// The bytes of a recording.
fn bytes(solution: &Solution) -> Vec<u8> {
    let case = case::case(solution.balls.len());
    let input = input(&case, solution);
    let recording = Recording::new(&input).expect("a sound solution");
    recording.write(Cursor::new(Vec::new())).expect("memory takes everything").into_inner()
}

/// One message of any topic.
#[derive(Debug, Clone)]
enum Payload {
    Scene(foxglove::SceneUpdate),
    Transforms(foxglove::FrameTransforms),
    Log(foxglove::Log),
    State(tribodyn::BearingState),
    Balls(tribodyn::Balls),
    Around(tribodyn::AroundBearing),
}

/// Decodes a whole file, chunk CRCs included: log time, topic, message.
fn decode(file: &[u8]) -> Vec<(u64, String, Payload)> {
    let message = |m: mcap::Message| {
        let data = m.data.as_ref();
        let schema = m.channel.schema.as_ref().expect("every topic has a schema");
        assert_eq!((schema.encoding.as_str(), m.channel.message_encoding.as_str()), ("protobuf", "protobuf"));
        let payload = match schema.name.as_str() {
            "foxglove.SceneUpdate" => Payload::Scene(Message::decode(data).unwrap()),
            "foxglove.FrameTransforms" => Payload::Transforms(Message::decode(data).unwrap()),
            "foxglove.Log" => Payload::Log(Message::decode(data).unwrap()),
            "tribodyn.v1.BearingState" => Payload::State(Message::decode(data).unwrap()),
            "tribodyn.v1.Balls" => Payload::Balls(Message::decode(data).unwrap()),
            "tribodyn.v1.AroundBearing" => Payload::Around(Message::decode(data).unwrap()),
            other => panic!("unknown schema {other}"),
        };
        (m.log_time, m.channel.topic.clone(), payload)
    };
    mcap::MessageStream::new(file).unwrap().map(|m| message(m.unwrap())).collect()
}
