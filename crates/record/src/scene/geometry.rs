//! `/bearing/geometry`: the bodies, written once, each in the frame that moves it.

use crate::contacts::Scales;
use crate::quaternion::{Rotation, grid, pose, vector};
use crate::raceway::Defect;
use crate::wire::foxglove::{
    Color, CubePrimitive, LinePrimitive, Point3, SceneEntity, SceneUpdate, SpherePrimitive, line_primitive,
};
use crate::{colour, frames, guide, mesh};
use prost_types::{Duration, Timestamp};
use tribodyn_bearing::{Geometry, Side};

/// Inputs of the static scene.
pub(crate) struct Bodies<'a> {
    /// Unloaded bearing.
    pub(crate) geometry: &'a Geometry,
    /// Circumferential gap of a ball in its pocket, m; absent without a cage.
    pub(crate) pocket_gap: Option<f64>,
    /// Azimuth of ball 0 at the start, rad.
    pub(crate) first_azimuth: f64,
    /// Scales of arrows and patches.
    pub(crate) scales: Scales,
    /// Load of the inner ring at the start, N.
    pub(crate) ring_load_n: [f64; 3],
    /// Defects of the raceways.
    pub(crate) defects: &'a [Defect],
    /// True if the coating of the raceways is drawn.
    pub(crate) with_coating: bool,
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
    let mut entities = vec![ring(bodies, Side::Outer, stamp), ring(bodies, Side::Inner, stamp)];
    entities.extend(bodies.pocket_gap.map(|gap| cage(bodies, gap, stamp)));
    entities.extend(guide::entities(bodies.geometry, bodies.scales, bodies.with_coating, stamp));
    entities.extend(guide::radial_mark(bodies.geometry, bodies.ring_load_n, stamp));
    let defect = |(index, defect): (usize, &Defect)| defect.entity(bodies.geometry, index, stamp);
    entities.extend(bodies.defects.iter().enumerate().map(defect));
    for index in 0..bodies.geometry.ball_count {
        entities.push(ball(bodies.geometry.ball_diameter, index, stamp));
        entities.push(number(bodies.geometry, index, stamp));
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

fn cage(bodies: &Bodies, pocket_gap: f64, stamp: Timestamp) -> SceneEntity {
    let (body, rims) = mesh::cage(bodies.geometry, pocket_gap, bodies.first_azimuth);
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
/// axis of rotation, so that band and dots tumble.
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

/// The ball's number, outside the outer ring.
fn number(geometry: &Geometry, index: usize, stamp: Timestamp) -> SceneEntity {
    let out = mesh::back_radius(geometry, Side::Outer) - 0.5 * geometry.pitch_diameter + 0.3 * geometry.ball_diameter;
    let label = guide::Stage::new(geometry).label([0.0, out, 0.0], index.to_string());
    SceneEntity { texts: vec![label], ..entity(stamp, frames::orbit(index), format!("number_{index:02}")) }
}
