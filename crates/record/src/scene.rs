//! `/bearing/geometry`: the bodies, written once, each in the frame that moves it.

use crate::contacts::{PATCH_EXAGGERATION, Scales};
use crate::quaternion::{Rotation, grid, pose, vector};
use crate::wire::foxglove::{
    Color, CubePrimitive, LinePrimitive, Point3, SceneEntity, SceneUpdate, SpherePrimitive, TextPrimitive,
    line_primitive,
};
use crate::{colour, frames, mesh};
use prost_types::{Duration, Timestamp};
use tribodyn_bearing::{Geometry, Side};

/// What the static scene needs to know.
pub(crate) struct Bodies<'a> {
    /// Unloaded bearing.
    pub(crate) geometry: &'a Geometry,
    /// Circumferential gap of a ball in its pocket, m.
    pub(crate) pocket_gap: f64,
    /// Azimuth of ball 0 at the start, rad.
    pub(crate) first_azimuth: f64,
    /// Title of the case.
    pub(crate) name: &'a str,
    /// Scales of arrows and patches, for the legend.
    pub(crate) scales: Scales,
}

/// A body that stays until it is replaced and moves with its frame.
pub(crate) fn entity(stamp: Timestamp, frame: String, id: String) -> SceneEntity {
    SceneEntity {
        timestamp: Some(stamp),
        frame_id: frame,
        id,
        lifetime: Some(Duration::default()),
        frame_locked: true,
        ..SceneEntity::default()
    }
}

/// All bodies.
pub(crate) fn geometry(bodies: &Bodies, stamp: Timestamp) -> SceneUpdate {
    let mut entities = vec![
        ring(bodies, Side::Outer, stamp),
        ring(bodies, Side::Inner, stamp),
        cage(bodies, stamp),
        legend(bodies, stamp),
    ];
    for index in 0..bodies.geometry.ball_count {
        entities.push(ball(bodies.geometry.ball_diameter, index, stamp));
        entities.push(number(bodies.geometry.ball_diameter, index, stamp));
    }
    SceneUpdate { deletions: Vec::new(), entities }
}

fn ring(bodies: &Bodies, side: Side, stamp: Timestamp) -> SceneEntity {
    let (frame, color) = match side {
        Side::Inner => (frames::INNER_RING, colour::INNER_RING),
        Side::Outer => (frames::OUTER_RING, colour::OUTER_RING),
    };
    let geometry = bodies.geometry;
    let diameter = geometry.ball_diameter;
    let back = mesh::back_radius(geometry, side);
    // A mark on the face, just inside the back of the ring.
    let middle = if side == Side::Outer { back - 0.12 * diameter } else { back + 0.12 * diameter };
    let mark = CubePrimitive {
        pose: Some(pose([middle, 0.0, mesh::half_width(geometry)], Rotation::IDENTITY)),
        size: Some(vector([0.16, 0.1, 0.04].map(|x| x * diameter))),
        color: Some(colour::MARK),
    };
    SceneEntity {
        triangles: vec![mesh::ring(geometry, side).message(color)],
        cubes: vec![mark],
        ..entity(stamp, frame.into(), frame.into())
    }
}

fn cage(bodies: &Bodies, stamp: Timestamp) -> SceneEntity {
    let (body, rims) = mesh::cage(bodies.geometry, bodies.pocket_gap, bodies.first_azimuth);
    let point = |p: [f64; 3]| Point3 { x: grid(p[0]), y: grid(p[1]), z: grid(p[2]) };
    let outline = |rim: Vec<[f64; 3]>| LinePrimitive {
        r#type: line_primitive::Type::LineLoop.into(),
        pose: Some(pose([0.0; 3], Rotation::IDENTITY)),
        thickness: 0.02 * bodies.geometry.ball_diameter,
        points: rim.into_iter().map(point).collect(),
        color: Some(colour::POCKET),
        ..LinePrimitive::default()
    };
    SceneEntity {
        triangles: vec![body.message(colour::CAGE)],
        lines: rims.into_iter().map(outline).collect(),
        ..entity(stamp, frames::CAGE.into(), frames::CAGE.into())
    }
}

/// A ball with a band about its z axis and a dot on either pole of it: z starts along the orbit, across the main
/// spin axis, so that band and dots tumble.
fn ball(diameter: f64, index: usize, stamp: Timestamp) -> SceneEntity {
    let sphere = |z: f64, size: f64, color: Color| SpherePrimitive {
        pose: Some(pose([0.0, 0.0, z * diameter], Rotation::IDENTITY)),
        size: Some(vector([size * diameter; 3])),
        color: Some(color),
    };
    SceneEntity {
        spheres: vec![
            sphere(0.0, 1.0, colour::BALL),
            sphere(0.34, 0.38, colour::DOT),
            sphere(-0.34, 0.38, colour::OTHER_DOT),
        ],
        triangles: vec![mesh::band(0.5 * diameter).message(colour::BAND)],
        ..entity(stamp, frames::ball(index), frames::ball(index))
    }
}

fn text(at: [f64; 3], size: f64, text: String) -> TextPrimitive {
    TextPrimitive {
        pose: Some(pose(at, Rotation::IDENTITY)),
        billboard: true,
        font_size: size,
        scale_invariant: false,
        color: Some(colour::TEXT),
        text,
    }
}

/// The ball's number, above it.
fn number(diameter: f64, index: usize, stamp: Timestamp) -> SceneEntity {
    let label = text([0.95 * diameter, 0.0, 0.0], 0.2 * diameter, index.to_string());
    SceneEntity { texts: vec![label], ..entity(stamp, frames::orbit(index), format!("number_{index:02}")) }
}

/// What arrows and patches mean, in words.
fn legend(bodies: &Bodies, stamp: Timestamp) -> SceneEntity {
    let diameter = bodies.geometry.ball_diameter;
    let lines = [
        bodies.name.to_owned(),
        format!("arrows: force on the ball, longest {:.0} N", bodies.scales.load_n),
        format!(
            "patches: contact ellipses x {PATCH_EXAGGERATION:.0}, highest pressure {:.2} GPa",
            bodies.scales.pressure_pa * 1e-9
        ),
    ];
    let top = mesh::half_width(bodies.geometry) + 2.4 * diameter;
    let line = |(i, words): (usize, String)| text([0.0, 0.0, top - 0.42 * diameter * i as f64], 0.28 * diameter, words);
    SceneEntity {
        texts: lines.into_iter().enumerate().map(line).collect(),
        ..entity(stamp, frames::BEARING.into(), "legend".into())
    }
}
