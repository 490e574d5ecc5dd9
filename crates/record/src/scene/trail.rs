//! The way of a free cage off centre: how far it is drawn from its place, and the trail of its centre.

use crate::frames;
use crate::quaternion::{Rotation, pose, vector};
use crate::scene::{colour, entity};
use crate::wire::foxglove::{LinePrimitive, Point3, SceneEntity, line_primitive};
use prost_types::Timestamp;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use tribodyn_dynamics::CageSample;

/// Times that displacement and tilt of a free cage are drawn larger than they are: of tenths of a millimetre nothing
/// would be seen.
const DRAWN: f64 = 10.0;
/// Points of the trail.
pub(crate) const POINTS: usize = 400;

/// Displacement (m) and rotation of a cage as it is drawn.
pub(crate) fn place(cage: &CageSample) -> ([f64; 3], Rotation) {
    let turned = Rotation::about_z(cage.angle_rad);
    let Some(free) = &cage.free else { return ([0.0; 3], turned) };
    let [tilt_x, tilt_y] = free.tilt_rad.map(|tilt| DRAWN * tilt);
    (free.centre_m.map(|x| DRAWN * x), Rotation::by_vector([tilt_x, tilt_y, 0.0]).after(turned))
}

/// Where the centre of a free cage was, as drawn.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Trail {
    points: VecDeque<[f64; 3]>,
}

impl Trail {
    pub(crate) fn len(&self) -> usize {
        self.points.len()
    }

    pub(crate) fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.points.iter().flatten().copied()
    }

    pub(crate) fn push(&mut self, cage: &CageSample) {
        if cage.free.is_none() {
            return;
        }
        self.points.push_back(place(cage).0);
        if self.points.len() > POINTS {
            self.points.pop_front();
        }
    }

    /// The trail as a line; none of a cage that turns only.
    pub(crate) fn entity(&self, diameter: f64, stamp: Timestamp) -> Option<SceneEntity> {
        let points = self.points.iter().map(|p| vector(*p)).map(|p| Point3 { x: p.x, y: p.y, z: p.z });
        let line = LinePrimitive {
            r#type: line_primitive::Type::LineStrip.into(),
            pose: Some(pose([0.0; 3], Rotation::IDENTITY)),
            thickness: 0.01 * diameter,
            points: points.collect(),
            color: Some(colour::POCKET),
            ..LinePrimitive::default()
        };
        let trail = entity(stamp, frames::BEARING.into(), "cage_trail".into());
        (!self.points.is_empty()).then(|| SceneEntity { lines: vec![line], ..trail })
    }
}
