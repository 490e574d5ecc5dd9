//! Contents of the messages: interpolated balls, frames, arrows, scene.

use super::{BALLS, Payload, ball, bytes, decode, solution};
use crate::quaternion::Rotation;
use crate::wire::foxglove::{FrameTransform, FrameTransforms, Quaternion, SceneUpdate};
use std::f64::consts::{PI, TAU};

/// Grid of the drawn numbers, with what products of a few of them add.
const DRAWN: f64 = 3e-7;

fn turned(q: &Quaternion, v: [f64; 3]) -> [f64; 3] {
    let cross =
        |a: [f64; 3], b: [f64; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let u = [q.x, q.y, q.z];
    let first = cross(u, v);
    let second = cross(u, first);
    [0, 1, 2].map(|k| v[k] + 2.0 * (q.w * first[k] + second[k]))
}

fn frame<'a>(frames: &'a FrameTransforms, child: &str) -> &'a FrameTransform {
    frames.transforms.iter().find(|f| f.child_frame_id == child).unwrap()
}

fn origin(frame: &FrameTransform) -> [f64; 3] {
    let t = frame.translation.as_ref().unwrap();
    [t.x, t.y, t.z]
}

fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
}

fn transforms(file: &[u8]) -> Vec<(f64, FrameTransforms)> {
    let seconds = |time: u64| (time - crate::timeline::EPOCH_NS) as f64 * 1e-9;
    decode(file)
        .into_iter()
        .filter_map(|(time, _, payload)| match payload {
            Payload::Transforms(frames) => Some((seconds(time), frames)),
            _ => None,
        })
        .collect()
}

fn scenes(file: &[u8], topic: &str) -> Vec<SceneUpdate> {
    decode(file)
        .into_iter()
        .filter_map(|(_, t, payload)| match payload {
            Payload::Scene(scene) if t == topic => Some(scene),
            _ => None,
        })
        .collect()
}

#[test]
fn identity_recorded_balls_follow_the_solution_over_azimuth() {
    let (mut checked, cage) = (0, 5802.0 * TAU / 60.0);
    for (_, _, payload) in decode(&bytes(&solution(BALLS))) {
        let Payload::Balls(message) = payload else {
            continue;
        };
        for (index, recorded) in message.balls.iter().enumerate() {
            let azimuth = TAU * index as f64 / BALLS as f64 + cage * message.time_s;
            let exact = ball(azimuth);
            // f32 has 6e-8; 3e-7 leaves room for the conversion of units.
            let same = |a: f32, b: f64, scale: f64| (f64::from(a) - b).abs() < 3e-7 * scale;
            assert!(same(recorded.load_inner_n, exact.contacts.inner.load_n, 5e3));
            assert!(same(recorded.peak_pressure_outer_gpa, exact.contacts.outer.peak_pressure_pa * 1e-9, 3.0));
            assert!(same(recorded.semi_axis_across_outer_mm, exact.contacts.outer.semi_axes_m[0] * 1e3, 3.0));
            assert!(same(recorded.angular_velocity_radial_rad_s, exact.angular_velocity_rad_s[1], 1e3));
            assert!(same(
                recorded.slide_to_roll_inner_percent,
                exact.contacts.inner.friction_or_nan().slide_to_roll[0] * 100.0,
                1.0
            ));
            let turn = (f64::from(recorded.azimuth_deg) - azimuth.to_degrees() + 180.0).rem_euclid(360.0) - 180.0;
            assert!(turn.abs() < 1e-4, "azimuth is {turn}° off");
            assert!(recorded.pocket_force_n >= 0.0, "a dead band rings");
            checked += 1;
        }
    }
    assert_eq!(checked, BALLS * 365);
}

#[test]
fn identity_state_sums_and_extremes_are_those_of_the_balls() {
    let messages = decode(&bytes(&solution(BALLS)));
    let mut states = messages.iter().filter_map(|(_, _, p)| if let Payload::State(s) = p { Some(s) } else { None });
    let balls = messages.iter().filter_map(|(_, _, p)| if let Payload::Balls(b) = p { Some(b) } else { None });
    for balls in balls {
        let state = states.next().unwrap();
        assert_eq!(state.time_s, balls.time_s);
        let power: f64 = balls.balls.iter().map(|b| f64::from(b.power_loss_inner_w)).sum();
        assert!((power - state.power_loss_inner_w).abs() < 1e-6 * power);
        let largest = balls.balls.iter().map(|b| b.load_outer_n).fold(0.0, f32::max);
        assert!((f64::from(largest) - state.load_outer_max_n).abs() < 1e-6 * state.load_outer_max_n);
        assert_eq!(state.balls_in_contact as usize, BALLS);
    }
    assert!(states.next().is_none());
}

#[test]
fn identity_frames_stand_where_the_solution_puts_them() {
    let cage = 5802.0 * TAU / 60.0;
    for (time, frames) in transforms(&bytes(&solution(BALLS))) {
        assert_eq!(frames.transforms.len(), 4 + 2 * BALLS);
        for f in &frames.transforms {
            let q = f.rotation.as_ref().unwrap();
            assert!((q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - 1.0).abs() < DRAWN, "{}", f.child_frame_id);
        }
        assert_eq!(frame(&frames, "bearing").parent_frame_id, "world");
        assert_eq!(frame(&frames, "ball_05").parent_frame_id, "orbit_05");
        assert!(close(origin(frame(&frames, "inner_ring")), [1.1e-5, -2e-6, 6.4e-5], DRAWN));
        for index in 0..BALLS {
            let orbit = frame(&frames, &format!("orbit_{index:02}"));
            let azimuth = TAU * index as f64 / BALLS as f64 + cage * time;
            let (exact, (sin, cos)) = (ball(azimuth), azimuth.sin_cos());
            let r = exact.orbit_radius_m;
            assert!(close(origin(orbit), [r * cos, r * sin, exact.axial_displacement_m], DRAWN));
            let q = orbit.rotation.as_ref().unwrap();
            assert!(close(turned(q, [1.0, 0.0, 0.0]), [0.0, 0.0, 1.0], DRAWN), "axial");
            assert!(close(turned(q, [0.0, 1.0, 0.0]), [cos, sin, 0.0], DRAWN), "radial");
            assert!(close(turned(q, [0.0, 0.0, 1.0]), [-sin, cos, 0.0], DRAWN), "tangential");
        }
        // The shaft's tilt is 2e-5 rad: a mark on the ring turns with ω t to that accuracy.
        let (sin, cos) = (solution(BALLS).inner_speed_rad_s * time).sin_cos();
        let q = frame(&frames, "inner_ring").rotation.as_ref().unwrap();
        assert!(close(turned(q, [1.0, 0.0, 0.0]), [cos, sin, 0.0], 3e-5), "shaft");
    }
}

#[test]
fn limit_a_constant_angular_velocity_turns_a_ball_by_its_angle_about_its_axis() {
    let mut solution = solution(BALLS);
    let omega = [-3900.0, 900.0, -50.0];
    solution.balls.iter_mut().for_each(|ball| ball.angular_velocity_rad_s = omega);
    let speed = omega.iter().map(|x| x * x).sum::<f64>().sqrt();
    for (time, frames) in transforms(&bytes(&solution)) {
        let q = frame(&frames, "ball_02").rotation.as_ref().unwrap();
        let half = 0.5 * speed * time;
        let closed = omega.map(|x| x / speed * half.sin());
        // A quaternion and its negative are the same rotation.
        let sign = if q.w * half.cos() + q.x * closed[0] < 0.0 { -1.0 } else { 1.0 };
        assert!((sign * q.w - half.cos()).abs() < DRAWN && close([q.x, q.y, q.z].map(|x| sign * x), closed, DRAWN));
    }
}

#[test]
fn limit_an_angular_velocity_that_varies_over_azimuth_is_followed_as_with_fine_steps() {
    // Ball 2 by 200 small rotations in each recorded step, the angular velocity taken where the ball is at the middle
    // of each.
    let (cage, fine, mut worst) = (5802.0 * TAU / 60.0, 200, 0.0_f64);
    let (mut q, mut last) = (Rotation::IDENTITY, 0.0);
    for (time, frames) in transforms(&bytes(&solution(BALLS))) {
        let step = (time - last) / f64::from(fine);
        for k in 0..fine {
            let middle = last + (f64::from(k) + 0.5) * step;
            let omega = ball(TAU * 2.0 / BALLS as f64 + cage * middle).angular_velocity_rad_s;
            q = Rotation::by_vector(omega.map(|w| w * step)).after(q).unit();
        }
        last = time;
        let drawn = frame(&frames, "ball_02").rotation.as_ref().unwrap();
        let drawn = [drawn.x, drawn.y, drawn.z, drawn.w];
        let exact = [q.vector[0], q.vector[1], q.vector[2], q.real];
        let apart = |sign: f64| {
            let squares = exact.iter().zip(drawn).map(|(a, b)| (a - sign * b).powi(2));
            2.0 * squares.sum::<f64>().sqrt()
        };
        worst = worst.max(apart(1.0).min(apart(-1.0)));
    }
    // Taking the angular velocity at the start of each step would be off by 6e-4 rad.
    assert!(worst < 1e-5, "{worst} rad");
}

#[test]
fn identity_arrows_end_at_the_contact_points_and_push_on_the_ball() {
    let file = bytes(&solution(BALLS));
    let contacts = &scenes(&file, "/bearing/contacts")[0];
    let (radius, mut lengths) = (0.5 * 0.03016, Vec::new());
    for (index, entity) in contacts.entities.iter().take(BALLS).enumerate() {
        let exact = ball(TAU * index as f64 / BALLS as f64);
        let (si, ci) = exact.contacts.inner.angle_rad.sin_cos();
        let (so, co) = exact.contacts.outer.angle_rad.sin_cos();
        let sides = [([-si, -ci, 0.0], exact.contacts.inner.load_n), ([so, co, 0.0], exact.contacts.outer.load_n)];
        assert_eq!((entity.arrows.len(), entity.spheres.len()), (2, 2));
        for ((arrow, patch), (normal, load)) in entity.arrows.iter().zip(&entity.spheres).zip(sides) {
            let pose = arrow.pose.as_ref().unwrap();
            let (tail, q) = (pose.position.as_ref().unwrap(), pose.orientation.as_ref().unwrap());
            let direction = turned(q, [1.0, 0.0, 0.0]);
            assert!(close(direction, normal.map(|x| -x), DRAWN), "against the normal");
            let length = arrow.shaft_length + arrow.head_length;
            let tail = [tail.x, tail.y, tail.z];
            let head = [0, 1, 2].map(|k| tail[k] + length * direction[k]);
            assert!(close(head, normal.map(|x| radius * x), DRAWN), "head at the contact point");
            lengths.push(length / load);
            let pose = patch.pose.as_ref().unwrap();
            let q = pose.orientation.as_ref().unwrap();
            let across = turned(q, [0.0, 1.0, 0.0]);
            assert!(close(turned(q, [1.0, 0.0, 0.0]), normal, DRAWN));
            assert!((across[0] * normal[0] + across[1] * normal[1]).abs() < DRAWN && across[2].abs() < DRAWN);
        }
        let size = entity.spheres[1].size.as_ref().unwrap();
        assert!((size.y / (4.0 * exact.contacts.outer.semi_axes_m[0]) - 1.0).abs() < 1e-5);
        assert!((size.z / (4.0 * exact.contacts.outer.semi_axes_m[1]) - 1.0).abs() < 1e-4);
    }
    assert!(lengths.iter().all(|x| (x / lengths[0] - 1.0).abs() < 1e-9), "length is proportional to load");
}

#[test]
fn limit_a_ball_without_load_has_no_arrow_and_nothing_rings_below_zero() {
    let mut loose = solution(BALLS);
    for index in 5..9 {
        let ball = &mut loose.balls[index];
        let inner = &mut ball.contacts.inner;
        (inner.load_n, inner.peak_pressure_pa, inner.approach_m) = (0.0, 0.0, 0.0);
        inner.semi_axes_m = [0.0; 2];
    }
    let file = bytes(&loose);
    let contacts = scenes(&file, "/bearing/contacts");
    assert_eq!(contacts[0].entities[6].arrows.len(), 1);
    assert_eq!(contacts[0].entities[6].spheres.len(), 1);
    assert_eq!(contacts[0].entities[0].arrows.len(), 2);
    let (mut lost, mut largest) = (0, 0.0_f32);
    for (_, _, payload) in decode(&file) {
        let Payload::Balls(message) = payload else {
            continue;
        };
        for ball in &message.balls {
            assert!(ball.load_inner_n >= 0.0 && ball.peak_pressure_inner_gpa >= 0.0);
            assert_eq!(ball.contact_inner, ball.load_inner_n > 0.0);
            lost += usize::from(!ball.contact_inner);
            largest = largest.max(ball.load_inner_n);
        }
    }
    // Three of thirteen gaps between balls are without load, at each of the 365 samples.
    assert!((lost as f64 / (BALLS * 365) as f64 - 3.0 / 13.0).abs() < 0.02, "{lost}");
    assert!(f64::from(largest) <= 5500.1, "no overshoot: {largest}");
}

#[test]
fn identity_bodies_ride_on_frames_that_exist_and_stay() {
    let file = bytes(&solution(BALLS));
    let (_, frames) = &transforms(&file)[0];
    let names: Vec<&str> = frames.transforms.iter().map(|f| f.child_frame_id.as_str()).collect();
    let geometry = &scenes(&file, "/bearing/geometry")[0];
    let mut ids: Vec<&str> = geometry.entities.iter().map(|entity| entity.id.as_str()).collect();
    for entity in &geometry.entities {
        assert!(names.contains(&entity.frame_id.as_str()), "{}", entity.frame_id);
        assert!(entity.frame_locked);
        assert_eq!(entity.lifetime.as_ref().map(|d| (d.seconds, d.nanos)), Some((0, 0)));
        for mesh in &entity.triangles {
            assert!(mesh.indices.len().is_multiple_of(3) && !mesh.indices.is_empty());
            assert!(mesh.indices.iter().all(|&i| (i as usize) < mesh.points.len()));
        }
    }
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), geometry.entities.len(), "identifiers repeat");
    let cage = geometry.entities.iter().find(|e| e.id == "cage").unwrap();
    assert_eq!(cage.lines.len(), BALLS);
    // Pocket 0 lies about ball 0: its rim is on the radial axis through azimuth 0 and as wide as ball and gap.
    let rim = &cage.lines[0].points;
    let width = rim.iter().map(|p| p.y).fold(f64::MIN, f64::max) - rim.iter().map(|p| p.y).fold(f64::MAX, f64::min);
    assert!((0.030_16..0.0306).contains(&width), "{width} m");
    assert!(rim.iter().all(|p| p.y.atan2(p.x).abs() < PI / BALLS as f64));
}
