//! A cage that whirls and tilts: its numbers, and how it is drawn.

use super::sample::{recording, sample};
use super::{BALLS, case};
use crate::wire::foxglove::{FrameTransforms, SceneUpdate};
use crate::wire::tribodyn::TransientState;
use crate::{RunRecorder, StreamSink};
use prost::Message;
use std::io::Cursor;
use std::path::Path;
use tribodyn_bearing::Races;
use tribodyn_dynamics::{FreeCageSample, Observer, Sample};

fn record(samples: &[Sample]) -> Vec<u8> {
    let (made, sink) = (case::case(BALLS), StreamSink::new(Cursor::new(Vec::new()), Path::new("memory")));
    let mut recorder = RunRecorder::new(sink, &recording(&made)).unwrap();
    for sample in samples {
        assert!(recorder.sample(sample, true).unwrap().is_continue());
    }
    recorder.finish().unwrap().into_inner()
}

fn of_topic<M: Message + Default>(file: &[u8], topic: &str) -> Vec<M> {
    let messages = mcap::MessageStream::new(file).unwrap().map(Result::unwrap);
    messages.filter(|m| m.channel.topic == topic).map(|m| M::decode(&*m.data).unwrap()).collect()
}

fn whirling(time: f64) -> Sample {
    let mut sample = sample(time);
    let (sin, cos) = (1000.0 * time).sin_cos();
    sample.cage.free = Some(FreeCageSample {
        centre_m: [1e-4 * cos, 1e-4 * sin, 2e-5],
        tilt_rad: [1e-3, 0.0],
        land_force_n: Races { inner: [0.0; 3], outer: [-3.0 * cos, -3.0 * sin, 0.1] },
        land_gap_m: Races { inner: None, outer: Some(-1e-6) },
        land_friction_w: 0.5,
        land_film_w: 0.25,
        ..FreeCageSample::default()
    });
    sample
}

/// A ring that has turned a quarter, then tilted about X: its own x axis stands along Y.
#[test]
fn identity_tilts_of_a_ring_are_in_state_and_picture() {
    let tilted = |time: f64| {
        let mut sample = sample(time);
        sample.inner.angle_rad = std::f64::consts::FRAC_PI_2;
        sample.inner.tilt_rad = [2e-3, 0.0];
        sample.outer.tilt_rad = [0.0, -1e-3];
        sample
    };
    let file = record(&[0.0, 1e-3].map(tilted));
    let states: Vec<TransientState> = of_topic(&file, "/bearing/state");
    assert_eq!((states[1].inner_tilt_x_mrad, states[1].inner_tilt_y_mrad), (2.0, 0.0));
    assert_eq!((states[1].outer_tilt_x_mrad, states[1].outer_tilt_y_mrad), (0.0, -1.0));
    let frames: Vec<FrameTransforms> = of_topic(&file, "/tf");
    let ring = frames[0].transforms.iter().find(|frame| frame.child_frame_id == "inner_ring").unwrap();
    let q = ring.rotation.unwrap();
    // The third component of the ring's x axis in the bearing's frame, 2 (x z − w y), rises by the tilt.
    let rise = 2.0 * (q.x * q.z - q.w * q.y);
    assert!((rise - 2e-3).abs() < 1e-6, "{rise} {q:?}");
    let ring = frames[0].transforms.iter().find(|frame| frame.child_frame_id == "outer_ring").unwrap();
    let q = ring.rotation.unwrap();
    assert!((q.y + 0.5e-3).abs() < 1e-6 && q.x.abs() < 1e-6, "{q:?}");
}

#[test]
fn identity_a_free_cage_is_in_state_and_picture() {
    let file = record(&[0.0, 1e-3, 2e-3].map(whirling));
    let states: Vec<TransientState> = of_topic(&file, "/bearing/state");
    let s = &states[1];
    let (sin, cos) = 1f64.sin_cos();
    assert!(s.cage_free && (s.cage_x_um - 100.0 * cos).abs() < 1e-9 && (s.cage_y_um - 100.0 * sin).abs() < 1e-9);
    assert_eq!((s.cage_z_um, s.cage_tilt_x_mrad, s.land_gap_um), (20.0, 1.0, -1.0));
    assert!((s.land_outer_x_n + 3.0 * cos).abs() < 1e-12 && s.land_inner_x_n == 0.0);
    assert_eq!((s.land_friction_w, s.land_film_w), (0.5, 0.25));
    // Ten times as far as it is, on the grid of the picture.
    let frames: Vec<FrameTransforms> = of_topic(&file, "/tf");
    let cage = frames[1].transforms.iter().find(|frame| frame.child_frame_id == "cage").unwrap();
    let (at, turned) = (cage.translation.unwrap(), cage.rotation.unwrap());
    assert!((at.x - 1e-3 * cos).abs() < 1e-7 && (at.z - 2e-4).abs() < 1e-7, "{at:?}");
    assert!((turned.x.hypot(turned.y) - 0.5 * 1e-2).abs() < 1e-5, "{turned:?}");
    // The trail has the places so far.
    let contacts: Vec<SceneUpdate> = of_topic(&file, "/bearing/contacts");
    let trail = |scene: &SceneUpdate| {
        let trail = scene.entities.iter().find(|entity| entity.id == "cage_trail").unwrap();
        (trail.frame_id.clone(), trail.lines[0].points.clone())
    };
    let (frame, points) = trail(contacts.last().unwrap());
    assert_eq!((frame.as_str(), points.len()), ("bearing", 3));
    assert!((points[1].x - at.x).abs() < 1e-7 && (points[1].y - at.y).abs() < 1e-7);
}

#[test]
fn limit_a_cage_that_only_turns_has_no_place_and_no_trail() {
    let file = record(&[0.0, 1e-3].map(sample));
    let states: Vec<TransientState> = of_topic(&file, "/bearing/state");
    assert!(!states[1].cage_free && states[1].cage_x_um == 0.0 && states[1].land_gap_um == 0.0);
    let contacts: Vec<SceneUpdate> = of_topic(&file, "/bearing/contacts");
    assert!(contacts.iter().flat_map(|scene| &scene.entities).all(|entity| entity.id != "cage_trail"));
}
