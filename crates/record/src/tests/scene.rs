//! Drawings besides bodies and contacts: scales, forces, defects, coating.

use super::sample::{CAGE, SHAFT, recording, sample};
use super::{BALLS, Payload, bytes, case, decode, solution};
use crate::wire::foxglove::{SceneEntity, SceneUpdate};
use crate::wire::tribodyn::{AroundBearing, Balls, ball::Motion, ball::Pocket};
use crate::{RunRecorder, StreamSink};
use prost::Message;
use std::f64::consts::TAU;
use std::io::Cursor;
use std::path::Path;
use tribodyn_case::Case;
use tribodyn_dynamics::{Observer, Sample};

fn record(made: &case::Made, samples: &[Sample]) -> Vec<u8> {
    let sink = StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
    let mut recorder = RunRecorder::new(sink, &recording(made)).unwrap();
    for sample in samples {
        assert!(recorder.sample(sample, true).unwrap().is_continue());
    }
    recorder.finish().unwrap().into_inner()
}

fn of_topic<M: Message + Default>(file: &[u8], topic: &str) -> Vec<M> {
    let messages = mcap::MessageStream::new(file).unwrap().map(Result::unwrap);
    messages.filter(|m| m.channel.topic == topic).map(|m| M::decode(&*m.data).unwrap()).collect()
}

fn entity<'a>(scene: &'a SceneUpdate, id: &str) -> &'a SceneEntity {
    scene.entities.iter().find(|entity| entity.id == id).unwrap_or_else(|| panic!("no {id}"))
}

fn texts(scene: &SceneUpdate) -> Vec<&str> {
    scene.entities.iter().flat_map(|entity| &entity.texts).map(|text| text.text.as_str()).collect()
}

/// Labels are short, scales end at round numbers, and what is said of the present occurs then.
#[test]
fn identity_words_in_the_picture_are_short_and_true() {
    let start = sample(0.0);
    let file = record(&case::case(BALLS), std::slice::from_ref(&start));
    let geometry: Vec<SceneUpdate> = of_topic(&file, "/bearing/geometry");
    let words = texts(&geometry[0]);
    assert!(words.iter().all(|text| text.chars().count() <= 16), "{words:?}");
    // 1.1 times 2.45 GPa and 1.1 times 7.8 kN, rounded up; arrows of half the scale.
    for label in ["2", "4", "pressure, GPa", "contact 5.00 kN", "pocket 250 N", "radial load", "X", "Y", "Z"] {
        assert!(words.contains(&label), "{label} is not among {words:?}");
    }
    let contacts: Vec<SceneUpdate> = of_topic(&file, "/bearing/contacts");
    let highest = start.balls.iter().map(|b| b.contacts.outer.peak_pressure_pa).fold(0.0, f64::max) * 1e-9;
    let now = texts(&contacts[0]);
    assert!(now.contains(&format!("now up to {highest:.2} GPa").as_str()), "{now:?}");
    // 9 and 21 kN.
    assert!(now.contains(&"ring load 22.8 kN"), "{now:?}");
}

#[test]
fn identity_pocket_forces_push_the_balls() {
    let mut start = sample(0.0);
    start.balls.iter_mut().for_each(|ball| ball.pocket.as_mut().unwrap().force_n = 0.0);
    start.balls[0].pocket.as_mut().unwrap().force_n = 100.0;
    start.balls[4].pocket.as_mut().unwrap().force_n = -200.0;
    let file = record(&case::case(BALLS), &[start]);
    let contacts: Vec<SceneUpdate> = of_topic(&file, "/bearing/contacts");
    let forces = entity(&contacts[0], "pocket_forces");
    assert_eq!((forces.frame_id.as_str(), forces.arrows.len()), ("cage", 2));
    let length = |i: usize| forces.arrows[i].shaft_length + forces.arrows[i].head_length;
    assert!((length(1) / length(0) - 2.0).abs() < 1e-9);
    // Ball 0 at the X axis is driven along Y: the arrow comes from below, with its head at the surface of the ball.
    let tail = forces.arrows[0].pose.unwrap().position.unwrap();
    assert!((tail.y + length(0) + 0.5 * 0.03016).abs() < 1e-6, "{tail:?}");
    let balls: Vec<Balls> = of_topic(&file, "/bearing/balls");
    let pockets: Vec<Pocket> = [0, 4, 5].map(|ball: usize| balls[0].balls[ball].pocket()).into();
    assert_eq!(pockets, [Pocket::CagePushes, Pocket::BallPushes, Pocket::Clear]);
}

#[test]
fn limit_states_of_balls() {
    let mut start = sample(0.0);
    start.balls[1].contacts.inner.friction.as_mut().unwrap().slide_to_roll[0] = -0.2;
    start.balls[2].contacts.inner.load_n = 0.0;
    start.balls[3].contacts.outer.load_n = 0.0;
    (start.balls[4].contacts.inner.load_n, start.balls[4].contacts.outer.load_n) = (0.0, 0.0);
    let balls: Vec<Balls> = of_topic(&record(&case::case(BALLS), &[start]), "/bearing/balls");
    let states: Vec<Motion> = balls[0].balls.iter().take(5).map(|ball| ball.motion()).collect();
    assert_eq!(states, [Motion::Rolling, Motion::Skidding, Motion::InnerLost, Motion::OuterLost, Motion::Free]);
}

#[test]
fn identity_balls_over_azimuth_are_sorted_and_the_same_balls() {
    let later = sample(0.0031);
    let file = record(&case::case(BALLS), &[later]);
    let around: Vec<AroundBearing> = of_topic(&file, "/bearing/azimuth");
    let balls: Vec<Balls> = of_topic(&file, "/bearing/balls");
    assert!(around[0].azimuth_deg.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!(around[0].ball.len(), BALLS);
    for (place, &ball) in around[0].ball.iter().enumerate() {
        let of = &balls[0].balls[ball as usize];
        assert_eq!((around[0].azimuth_deg[place], around[0].load_outer_n[place]), (of.azimuth_deg, of.load_outer_n));
        assert_eq!(around[0].slide_to_roll_inner_percent[place], of.slide_to_roll_inner_percent);
    }
    let mut seen = 0;
    for (_, _, payload) in decode(&bytes(&solution(BALLS))) {
        if let Payload::Around(message) = payload {
            assert!(message.azimuth_deg.windows(2).all(|pair| pair[0] < pair[1]));
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}

/// A defect of the inner ring at 41°: at time 0 between the balls at 27.7° and 55.4°, none of which reaches it.
#[test]
fn identity_a_defect_lights_up_while_a_ball_passes() {
    let defect = "defects: [(race: Inner, azimuth: deg(41), width: deg(4), depth: um(20), bare: 0)],\n    speed:";
    let text = case::TEXT.replacen("speed:", defect, 1);
    let case = case::Made::of(&Case::from_ron(&text).unwrap());
    // The shaft is faster than the cage: the defect runs into the ball ahead of it.
    let met = (TAU / 13.0 * 2.0 - 41.0_f64.to_radians()) / (SHAFT - CAGE);
    let samples = [0.0, met].map(sample);
    let file = record(&case, &samples);
    let geometry: Vec<SceneUpdate> = of_topic(&file, "/bearing/geometry");
    let drawn = entity(&geometry[0], "defect_0");
    assert_eq!((drawn.frame_id.as_str(), drawn.texts[0].text.as_str()), ("inner_ring", "defect 4° x 20 µm"));
    let mesh = &drawn.triangles[0];
    let angles: Vec<f64> = mesh.points.iter().map(|p| p.y.atan2(p.x).to_degrees()).collect();
    let ends = [angles.iter().copied().fold(f64::MAX, f64::min), angles.iter().copied().fold(f64::MIN, f64::max)];
    assert!((ends[0] - 39.0).abs() < 1e-3 && (ends[1] - 43.0).abs() < 1e-3, "{ends:?}");
    let contacts: Vec<SceneUpdate> = of_topic(&file, "/bearing/contacts");
    let alight: Vec<bool> = contacts.iter().map(|c| !entity(c, "passed_0").triangles.is_empty()).collect();
    assert_eq!(alight, [false, true]);
}

/// A quarter of the coating is gone wherever the made-up balls have been.
#[test]
fn identity_the_coating_is_drawn_as_the_balls_found_it() {
    let samples: Vec<Sample> = (0..3).map(|i| sample(f64::from(i) * 1e-4)).collect();
    let coating: Vec<SceneUpdate> = of_topic(&record(&case::case(BALLS), &samples), "/bearing/coating");
    let last = coating.last().unwrap();
    let outer = &entity(last, "coating_outer_ring").triangles[0];
    assert_eq!((outer.points.len(), outer.colors.len()), (2 * 181, 2 * 181));
    let seen = crate::colour::coating(0.75);
    assert!(outer.colors[0] == seen, "ball 0 stands at the start");
    let coloured = outer.colors.iter().filter(|color| **color == seen).count();
    // 13 balls, each in one to six sectors of 2° over 7° of cage angle.
    assert!((2 * 13..2 * 13 * 6).contains(&coloured), "{coloured}");
    assert!(outer.colors.contains(&crate::colour::UNSEEN));
}
