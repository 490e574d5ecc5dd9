//! Aids to reading the picture: colour scales with numbers, arrows of a round force, axes, the mark of the radial load.
//! All of it stands beside the bearing, where the camera of the layout looks past it.

use crate::contacts::{LONGEST_ARROW, POCKET_MAGNIFICATION, Scales};
use crate::mesh::{self, Mesh};
use crate::quaternion::{Rotation, pose};
use crate::wire::foxglove::{ArrowPrimitive, Color, SceneEntity, TextPrimitive};
use crate::{colour, frames, scene};
use prost_types::Timestamp;
use tribodyn_bearing::{Geometry, Side};

/// Where the camera of the layout stands: angle from the axis, degrees.
pub(crate) const CAMERA_PHI_DEG: f64 = 54.0;
/// And around it, as viewers count: the camera's azimuth is 270° less this.
pub(crate) const CAMERA_THETA_DEG: f64 = -30.0;

/// Patches of colour along a scale.
const SCALE_STEPS: usize = 48;

/// Directions and lengths of the picture, as the camera of the layout sees it.
pub(crate) struct Stage {
    /// Outside radius of the bearing, m.
    radius: f64,
    /// Horizontal, to the right, and towards the camera.
    right: [f64; 2],
    near: [f64; 2],
}

impl Stage {
    pub(crate) fn new(geometry: &Geometry) -> Self {
        let camera = (270.0 - CAMERA_THETA_DEG).to_radians();
        let [near, right] = [camera, camera + std::f64::consts::FRAC_PI_2].map(|angle| [angle.cos(), angle.sin()]);
        Self { radius: mesh::back_radius(geometry, Side::Outer), right, near }
    }

    /// A place in outside radii: to the right, towards the camera, up.
    pub(crate) fn at(&self, right: f64, near: f64, up: f64) -> [f64; 3] {
        let horizontal = |k: usize| self.radius * (right * self.right[k] + near * self.near[k]);
        [horizontal(0), horizontal(1), self.radius * up]
    }

    /// A label of the size that all have.
    pub(crate) fn label(&self, at: [f64; 3], text: impl Into<String>) -> TextPrimitive {
        TextPrimitive {
            pose: Some(pose(at, Rotation::IDENTITY)),
            billboard: true,
            font_size: 0.085 * self.radius,
            scale_invariant: false,
            color: Some(colour::TEXT),
            text: text.into(),
        }
    }

    /// A standing scale of colours.
    fn scale(&self, right: f64, color: fn(f64) -> Color) -> (Mesh, Vec<Color>) {
        let (mut mesh, mut colors) = (Mesh::default(), Vec::new());
        for step in 0..=SCALE_STEPS {
            let part = step as f64 / SCALE_STEPS as f64;
            let up = SCALE_FOOT + part * SCALE_HEIGHT;
            mesh.points.extend([self.at(right, 0.0, up), self.at(right + 0.1, 0.0, up)]);
            colors.extend([color(part); 2]);
        }
        for step in 0..SCALE_STEPS as u32 {
            let [a, b, c, d] = [0, 1, 3, 2].map(|corner| 2 * step + corner);
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
        (mesh, colors)
    }
}

/// Foot and height of the scales, in outside radii.
const SCALE_FOOT: f64 = -0.45;
const SCALE_HEIGHT: f64 = 1.1;
/// Places of the scales and of the arrows that explain lengths.
const PRESSURE_AT: f64 = -1.6;
const COATING_AT: f64 = 1.65;
const ARROWS_AT: [f64; 3] = [0.7, 1.2, -0.35];

/// An arrow along a direction (need not be of unit length), tail at a place; none for no direction.
pub(crate) fn arrow(
    tail: [f64; 3],
    direction: [f64; 3],
    length: f64,
    thick: f64,
    color: Color,
) -> Option<ArrowPrimitive> {
    let size = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
    if !(size > 0.0 && length > 0.0) {
        return None;
    }
    let [x, y, z] = direction.map(|x| x / size);
    // Turns the x axis into the direction: about y by the elevation, then about z by the azimuth.
    let up = Rotation::by_vector([0.0, -z.clamp(-1.0, 1.0).asin(), 0.0]);
    let head = (2.6 * thick).min(0.5 * length);
    Some(ArrowPrimitive {
        pose: Some(pose(tail, Rotation::about_z(y.atan2(x)).after(up))),
        shaft_length: length - head,
        shaft_diameter: thick,
        head_length: head,
        head_diameter: 2.2 * thick,
        color: Some(color),
    })
}

/// Scales, arrows and axes; `with_coating` where the coating of the raceways is drawn.
pub(crate) fn entities(geometry: &Geometry, scales: Scales, with_coating: bool, stamp: Timestamp) -> Vec<SceneEntity> {
    let stage = Stage::new(geometry);
    let mut all = vec![pressure(&stage, scales, stamp), lengths(&stage, geometry, scales, stamp), axes(&stage, stamp)];
    if with_coating {
        all.push(coating(&stage, stamp));
    }
    all
}

fn pressure(stage: &Stage, scales: Scales, stamp: Timestamp) -> SceneEntity {
    let (mesh, colors) = stage.scale(PRESSURE_AT, colour::scale);
    let top = scales.pressure_pa * 1e-9;
    let mut texts: Vec<TextPrimitive> = [0.0, 0.5, 1.0]
        .into_iter()
        .map(|part| {
            let at = stage.at(PRESSURE_AT + 0.26, 0.0, SCALE_FOOT + part * SCALE_HEIGHT);
            stage.label(at, format!("{}", (part * top * 1e6).round() / 1e6))
        })
        .collect();
    texts.push(stage.label(stage.at(PRESSURE_AT + 0.1, 0.0, SCALE_FOOT + SCALE_HEIGHT + 0.15), "pressure, GPa"));
    entity(stamp, "pressure_scale", |e| {
        e.triangles = vec![mesh.coloured(colors)];
        e.texts = texts;
    })
}

fn coating(stage: &Stage, stamp: Timestamp) -> SceneEntity {
    let (mesh, colors) = stage.scale(COATING_AT, colour::coating);
    let label =
        |part: f64, text: &str| stage.label(stage.at(COATING_AT - 0.2, 0.0, SCALE_FOOT + part * SCALE_HEIGHT), text);
    let title = stage.label(stage.at(COATING_AT, 0.0, SCALE_FOOT + SCALE_HEIGHT + 0.15), "coating, %");
    entity(stamp, "coating_scale", |e| {
        e.triangles = vec![mesh.coloured(colors)];
        e.texts = vec![label(0.0, "0"), label(0.5, "50"), label(1.0, "100"), title];
    })
}

/// Arrows of the length of half the scale's load, one of a contact and one of a pocket.
fn lengths(stage: &Stage, geometry: &Geometry, scales: Scales, stamp: Timestamp) -> SceneEntity {
    let diameter = geometry.ball_diameter;
    let [right, near, up] = ARROWS_AT;
    let direction = stage.at(1.0, 0.0, 0.0);
    let (load, length) = (0.5 * scales.load_n, 0.5 * LONGEST_ARROW * diameter);
    let line = |place: f64, color, text: String| {
        let tail = stage.at(right, near, up - place);
        let label = stage.at(right + 0.25, near, up - place + 0.11);
        (arrow(tail, direction, length, 0.09 * diameter, color), stage.label(label, text))
    };
    let contact = line(0.0, colour::FORCE, format!("contact {}", force(load)));
    let pocket = line(0.26, colour::POCKET_FORCE, format!("pocket {}", force(load / POCKET_MAGNIFICATION)));
    entity(stamp, "force_scale", |e| {
        e.arrows = [contact.0, pocket.0].into_iter().flatten().collect();
        e.texts = vec![contact.1, pocket.1];
    })
}

/// A force in words, three digits.
pub(crate) fn force(newtons: f64) -> String {
    match newtons.abs() {
        size if size >= 1e5 => format!("{:.0} kN", newtons * 1e-3),
        size if size >= 1e4 => format!("{:.1} kN", newtons * 1e-3),
        size if size >= 1e3 => format!("{:.2} kN", newtons * 1e-3),
        size if size >= 10.0 => format!("{newtons:.0} N"),
        _ => format!("{newtons:.1} N"),
    }
}

/// The axes X, Y and Z, beside the bearing.
fn axes(stage: &Stage, stamp: Timestamp) -> SceneEntity {
    let origin = stage.at(-1.35, 1.0, -0.35);
    let length = 0.3 * stage.radius;
    let directions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let names = ["X", "Y", "Z"];
    entity(stamp, "axes", |e| {
        for ((direction, name), color) in directions.into_iter().zip(names).zip(colour::AXES) {
            e.arrows.extend(arrow(origin, direction, length, 0.025 * stage.radius, color));
            let end = [0, 1, 2].map(|k| origin[k] + 1.3 * length * direction[k]);
            e.texts.push(stage.label(end, name));
        }
    })
}

/// A wedge on the outer ring towards the radial load at the start, N; none where the load is axial.
pub(crate) fn radial_mark(geometry: &Geometry, load_n: [f64; 3], stamp: Timestamp) -> Option<SceneEntity> {
    let [x, y, z] = load_n;
    let radial = x.hypot(y);
    // A hundredth of the load is a tenth of a degree or two of direction, and no load to speak of.
    if radial <= 0.01 * radial.hypot(z) || radial == 0.0 {
        return None;
    }
    let stage = Stage::new(geometry);
    let azimuth = y.atan2(x);
    let point = |part: f64, turn: f64| {
        let (sin, cos) = (azimuth + turn).sin_cos();
        let r = part * stage.radius;
        [r * cos, r * sin, 0.0]
    };
    let mut wedge =
        Mesh { points: vec![point(1.03, 0.0), point(1.2, 0.09), point(1.2, -0.09)], triangles: vec![[0, 1, 2]] };
    // Upright too, to be seen from the side.
    let [tip, ..] = wedge.points[..] else { return None };
    let middle = point(1.2, 0.0);
    let upright = |up: f64| [middle[0], middle[1], up * 0.11 * stage.radius];
    wedge.points.extend([tip, upright(1.0), upright(-1.0)]);
    wedge.triangles.push([3, 4, 5]);
    let label = stage.label(point(1.45, 0.0), "radial load");
    Some(entity(stamp, "radial_load", |e| {
        e.triangles = vec![wedge.message(colour::LOAD)];
        e.texts = vec![label];
    }))
}

fn entity(stamp: Timestamp, id: &str, fill: impl FnOnce(&mut SceneEntity)) -> SceneEntity {
    let mut entity = scene::entity(stamp, frames::BEARING.into(), id.into());
    fill(&mut entity);
    entity
}

/// The place of what is said about the present, above the scale of pressures.
pub(crate) fn now_at(stage: &Stage) -> [f64; 3] {
    stage.at(PRESSURE_AT + 0.1, 0.0, SCALE_FOOT - 0.15)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_forces_have_three_digits() {
        let texts = [22_847.3, 1_234.5, 431.2, 3.24, 210_000.0].map(force);
        assert_eq!(texts, ["22.8 kN", "1.23 kN", "431 N", "3.2 N", "210 kN"]);
    }

    #[test]
    fn identity_an_arrow_points_along_its_direction() {
        for direction in [[3.0, 0.0, 4.0], [0.0, -2.0, -1.0], [0.0, 0.0, 5.0], [-1.0, 1e-3, 0.0]] {
            let arrow = arrow([0.0; 3], direction, 0.1, 0.01, colour::LOAD).unwrap();
            let q = arrow.pose.unwrap().orientation.unwrap();
            // The x axis, turned.
            let turned =
                [1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.z * q.w), 2.0 * (q.x * q.z - q.y * q.w)];
            let size = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
            assert!((0..3).all(|k| (turned[k] - direction[k] / size).abs() < 1e-6), "{turned:?} for {direction:?}");
        }
        assert!(arrow([0.0; 3], [0.0; 3], 0.1, 0.01, colour::LOAD).is_none());
    }
}
