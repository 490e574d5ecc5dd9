//! `/bearing/contacts`: what changes as the balls go round. Contact loads are arrows and contact ellipses patches, in
//! the ball's azimuth frame; forces of the pockets are arrows in the frame of the cage; the load of the ring is an
//! arrow from the middle of the bearing. Defects that a ball passes light up.
//!
//! An arrow of a contact is the force of the race on the ball, −Q n: its head touches the contact point and it pushes
//! towards the ball centre, so outer arrows come from outside and inner ones from the bore. With the outward normals
//! from the ball centre, n_o = (sin α_o, cos α_o, 0) and n_i = (−sin α_i, −cos α_i, 0) in (a, r, t), the contact point
//! is r_b n. Length grows linearly with the load from zero, the colour of arrow and patch with the peak pressure. A
//! contact without load has neither. An arrow of a pocket pushes the ball along its orbit, longer for its load by a
//! factor.

use crate::guide::{self, Stage};
use crate::quaternion::{Rotation, pose, vector};
use crate::raceway::Defect;
use crate::timeline::timestamp;
use crate::wire::foxglove::{ArrowPrimitive, SceneEntity, SceneUpdate, SpherePrimitive};
use crate::{colour, frames, layout, scene};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};
use tribodyn_bearing::{BallResult, ContactResult, Geometry, Side};
use tribodyn_quasistatic::Solution;

/// Semi-axes of a patch over the true ones: true ones are hard to see on a ball.
pub(crate) const PATCH_EXAGGERATION: f64 = 2.0;
/// Half the thickness of a patch over the ball diameter: enough to stand above the curved surface.
const PATCH_HALF_THICKNESS: f64 = 0.03;
/// Length of an arrow at the end of the scale over the ball diameter.
pub(crate) const LONGEST_ARROW: f64 = 1.5;
/// Lengths of pocket forces over those of contact loads: pockets carry hundreds of newtons where races carry thousands.
pub(crate) const POCKET_MAGNIFICATION: f64 = 20.0;
/// Length of the arrow of the ring load at the start, over the outside radius of the bearing.
const RING_ARROW: f64 = 0.95;
/// How much longer than that an arrow may get where a load exceeds the scale.
const OVERLONG: f64 = 2.0;
/// Load and pressure of a run's scale where its first sample carries nothing, N and Pa.
const UNLOADED: Scales = Scales { load_n: 1e3, pressure_pa: 1e9, ring_n: 0.0 };

/// The loads and pressures at which scales end: round numbers, whatever occurs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Scales {
    /// Contact load of an arrow of full length, N.
    pub(crate) load_n: f64,
    /// Peak pressure of the brightest colour, Pa.
    pub(crate) pressure_pa: f64,
    /// Load of the ring at the start, N, whose arrow has its length.
    pub(crate) ring_n: f64,
}

impl Scales {
    pub(crate) fn of(solution: &Solution) -> Self {
        let largest = |get: fn(&ContactResult) -> f64| layout::round_up(largest(&solution.balls, get));
        Self {
            load_n: largest(|c| c.load_n),
            pressure_pa: largest(|c| c.peak_pressure_pa),
            ring_n: size(solution.ring_load_n),
        }
    }

    /// Scales of a run from its first sample, with some room, since loads will vary.
    pub(crate) fn of_first(balls: &[BallResult], ring_load_n: [f64; 3]) -> Self {
        let largest = |get: fn(&ContactResult) -> f64| layout::round_up(1.1 * largest(balls, get));
        let (load_n, pressure_pa) = (largest(|c| c.load_n), largest(|c| c.peak_pressure_pa));
        let scales =
            if load_n > 0.0 && pressure_pa > 0.0 { Self { load_n, pressure_pa, ring_n: 0.0 } } else { UNLOADED };
        Self { ring_n: size(ring_load_n), ..scales }
    }
}

fn largest(balls: &[BallResult], get: fn(&ContactResult) -> f64) -> f64 {
    balls.iter().map(|b| get(&b.contacts.inner).max(get(&b.contacts.outer))).fold(0.0, f64::max)
}

fn size(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// One contact as it is drawn.
struct Contact {
    /// Direction of the outward normal in the plane (a, r), rad from the axial direction.
    normal: f64,
    load_n: f64,
    pressure_pa: f64,
    semi_axes_m: [f64; 2],
}

/// Data of the drawing that are the same in all messages.
pub(crate) struct Drawing<'a> {
    pub(crate) geometry: &'a Geometry,
    pub(crate) scales: Scales,
    pub(crate) defects: &'a [Defect],
}

/// Data of the drawing that change with time, besides the balls.
pub(crate) struct Moment {
    pub(crate) log_time: u64,
    /// External load that the balls carry: their force on the inner ring, turned round, N.
    pub(crate) ring_load_n: [f64; 3],
    pub(crate) cage_angle_rad: f64,
    /// Angles of inner and outer ring, rad.
    pub(crate) ring_angles_rad: [f64; 2],
}

/// All entities at one time. `message` is empty or that of another time, whose names stay.
pub(crate) fn update(message: &mut SceneUpdate, drawing: &Drawing, moment: &Moment, balls: &[BallResult]) {
    let stamp = timestamp(moment.log_time);
    let diameter = drawing.geometry.ball_diameter;
    for (index, ball) in balls.iter().enumerate() {
        if message.entities.len() == index {
            message.entities.push(scene::entity(stamp, frames::orbit(index), format!("contacts_{index:02}")));
        }
        let entity = &mut message.entities[index];
        entity.timestamp = Some(stamp);
        entity.arrows.clear();
        entity.spheres.clear();
        for contact in of_ball(ball) {
            if contact.load_n > 0.0 {
                add(entity, diameter, drawing.scales, &contact);
            }
        }
    }
    message.entities.truncate(balls.len());
    message.entities.push(pockets(drawing, moment, balls));
    message.entities.push(present(drawing, moment, balls));
    let azimuths: Vec<f64> = balls.iter().map(|b| b.azimuth_rad).collect();
    let flash = |(i, d): (usize, &Defect)| d.flash(drawing.geometry, i, moment.ring_angles_rad, &azimuths, stamp);
    message.entities.extend(drawing.defects.iter().enumerate().map(flash));
}

/// The forces of the pockets on the balls, heads at the balls.
fn pockets(drawing: &Drawing, moment: &Moment, balls: &[BallResult]) -> SceneEntity {
    let (diameter, scales) = (drawing.geometry.ball_diameter, drawing.scales);
    let mut entity = scene::entity(timestamp(moment.log_time), frames::CAGE.into(), "pocket_forces".into());
    for ball in balls {
        let part = POCKET_MAGNIFICATION * ball.pocket.unwrap_or_default().force_n.abs() / scales.load_n;
        let length = LONGEST_ARROW * diameter * part.min(OVERLONG);
        // Behind a ball that is driven along the orbit, ahead of one that is held back.
        let sign = ball.pocket.unwrap_or_default().force_n.signum();
        let (sin, cos) = (ball.azimuth_rad - moment.cage_angle_rad).sin_cos();
        let back = -sign * (0.5 * diameter + length);
        let tail =
            [ball.orbit_radius_m * cos - back * sin, ball.orbit_radius_m * sin + back * cos, ball.axial_displacement_m];
        let direction = [-sign * sin, sign * cos, 0.0];
        // Below a hundredth of the diameter there is nothing to see.
        if length > 0.01 * diameter {
            entity.arrows.extend(guide::arrow(tail, direction, length, 0.08 * diameter, colour::POCKET_FORCE));
        }
    }
    entity
}

/// The load of the ring as an arrow, and the highest load and pressure there are now.
fn present(drawing: &Drawing, moment: &Moment, balls: &[BallResult]) -> SceneEntity {
    let stage = Stage::new(drawing.geometry);
    let mut entity = scene::entity(timestamp(moment.log_time), frames::BEARING.into(), "present".into());
    let (load, scales) = (size(moment.ring_load_n), drawing.scales);
    if load > 0.0 && scales.ring_n > 0.0 {
        let radius = stage.at(0.0, 0.0, 1.0)[2];
        let length = RING_ARROW * radius * (load / scales.ring_n).min(OVERLONG);
        entity.arrows.extend(guide::arrow([0.0; 3], moment.ring_load_n, length, 0.06 * radius, colour::LOAD));
        let end = moment.ring_load_n.map(|x| x / load * (length + 0.13 * radius));
        entity.texts.push(stage.label(end, format!("ring load {}", guide::force(load))));
    }
    let pressure = largest(balls, |c| c.peak_pressure_pa);
    entity.texts.push(stage.label(guide::now_at(&stage), format!("now up to {:.2} GPa", pressure * 1e-9)));
    entity
}

impl Contact {
    fn new(side: Side, angle: f64, load_n: f64, pressure_pa: f64, semi_axes_m: [f64; 2]) -> Self {
        // From the axial direction; the inner normal points the other way.
        let outward = FRAC_PI_2 - angle;
        let normal = if side == Side::Inner { outward + PI } else { outward };
        Self { normal, load_n, pressure_pa, semi_axes_m }
    }
}

/// Inner and outer contact of a ball.
fn of_ball(ball: &BallResult) -> [Contact; 2] {
    let contact =
        |side, c: &ContactResult| Contact::new(side, c.angle_rad, c.load_n, c.peak_pressure_pa, c.semi_axes_m);
    [contact(Side::Inner, &ball.contacts.inner), contact(Side::Outer, &ball.contacts.outer)]
}

fn add(entity: &mut SceneEntity, diameter: f64, scales: Scales, contact: &Contact) {
    let outward = Rotation::about_z(contact.normal);
    let [cos, sin] = outward.direction();
    let along = |distance: f64| [distance * cos, distance * sin, 0.0];
    let color = Some(colour::scale(contact.pressure_pa / scales.pressure_pa));
    let part = contact.load_n / scales.load_n;
    // Loads of a run may outgrow the scale: the arrow says so up to a point.
    let length = LONGEST_ARROW * diameter * part.min(OVERLONG);
    let head = (0.28 * diameter).min(0.5 * length);
    entity.arrows.push(ArrowPrimitive {
        // The arrow lies along x of its pose: turned half round, it points against the normal.
        pose: Some(pose(along(0.5 * diameter + length), outward.turned_round())),
        shaft_length: length - head,
        shaft_diameter: 0.09 * diameter,
        head_length: head,
        head_diameter: 0.22 * diameter,
        color,
    });
    let [across, rolling] = contact.semi_axes_m.map(|x| 2.0 * PATCH_EXAGGERATION * x);
    entity.spheres.push(SpherePrimitive {
        // x along the normal, y across the groove, z along rolling.
        pose: Some(pose(along(0.5 * diameter), outward)),
        size: Some(vector([2.0 * PATCH_HALF_THICKNESS * diameter, across, rolling])),
        color,
    });
}
