//! `/bearing/contacts`: contact loads as arrows and contact ellipses as patches, in the ball's azimuth frame.
//!
//! An arrow is the force of the race on the ball, −Q n: its head touches the contact point and it pushes towards the
//! ball centre, so outer arrows come from outside and inner ones from the bore. With the outward normals from the
//! ball centre, n_o = (sin α_o, cos α_o, 0) and n_i = (−sin α_i, −cos α_i, 0) in (a, r, t), the contact point is
//! r_b n. Length and colour grow linearly with the load from zero; the colour of a patch grows with its peak
//! pressure. A contact without load has neither.

use crate::quaternion::{Rotation, pose, vector};
use crate::timeline::timestamp;
use crate::wire::foxglove::{ArrowPrimitive, SceneEntity, SceneUpdate, SpherePrimitive};
use crate::{colour, frames, scene};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};
use tribodyn_bearing::Side;
use tribodyn_dynamics::{BallSample, ContactSample};
use tribodyn_quasistatic::{BallSolution, Solution};

/// Semi-axes of a patch over the true ones: true ones are hard to see on a ball.
pub(crate) const PATCH_EXAGGERATION: f64 = 2.0;
/// Half the thickness of a patch over the ball diameter: enough to stand above the curved surface.
const PATCH_HALF_THICKNESS: f64 = 0.03;
/// Length of the longest arrow over the ball diameter.
const LONGEST_ARROW: f64 = 1.5;
/// How much longer than that an arrow may get where a load exceeds the scale.
const OVERLONG: f64 = 2.0;
/// Load and pressure of a run's scale where its first sample carries nothing, N and Pa.
const UNLOADED: Scales = Scales { load_n: 1e3, pressure_pa: 1e9 };

/// The loads and pressures at which arrows are longest and colours brightest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Scales {
    /// Largest contact load of the solution, N.
    pub(crate) load_n: f64,
    /// Largest peak pressure of the solution, Pa.
    pub(crate) pressure_pa: f64,
}

impl Scales {
    pub(crate) fn of(solution: &Solution) -> Self {
        let largest = |get: fn(&BallSolution) -> f64| solution.balls.iter().map(get).fold(0.0, f64::max);
        Self {
            load_n: largest(|b| b.load_inner_n.max(b.load_outer_n)),
            pressure_pa: largest(|b| b.peak_pressure_inner_pa.max(b.peak_pressure_outer_pa)),
        }
    }
}

impl Scales {
    /// Scales of a run from its first sample: the largest there is two thirds of the scale, since loads will vary.
    pub(crate) fn of_first(balls: &[BallSample]) -> Self {
        let largest = |get: fn(&ContactSample) -> f64| {
            1.5 * balls.iter().map(|b| get(&b.inner).max(get(&b.outer))).fold(0.0, f64::max)
        };
        let (load_n, pressure_pa) = (largest(|c| c.load_n), largest(|c| c.peak_pressure_pa));
        if load_n > 0.0 && pressure_pa > 0.0 { Self { load_n, pressure_pa } } else { UNLOADED }
    }
}

/// One contact as it is drawn.
pub(crate) struct Contact {
    /// Direction of the outward normal in the plane (a, r), rad from the axial direction.
    normal: f64,
    load_n: f64,
    pressure_pa: f64,
    semi_axes_m: [f64; 2],
}

/// Arrows and patches of all balls at one log time. `message` is empty or that of another time, whose names stay.
pub(crate) fn update(
    message: &mut SceneUpdate,
    (diameter, scales): (f64, Scales),
    log_time: u64,
    balls: impl Iterator<Item = [Contact; 2]>,
) {
    let stamp = timestamp(log_time);
    for (index, contacts) in balls.enumerate() {
        if message.entities.len() == index {
            message.entities.push(scene::entity(stamp, frames::orbit(index), format!("contacts_{index:02}")));
        }
        let entity = &mut message.entities[index];
        entity.timestamp = Some(stamp);
        entity.arrows.clear();
        entity.spheres.clear();
        for contact in contacts {
            if contact.load_n > 0.0 {
                add(entity, diameter, scales, &contact);
            }
        }
    }
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
pub(crate) fn of_sample(ball: &BallSample) -> [Contact; 2] {
    let contact =
        |side, c: &ContactSample| Contact::new(side, c.angle_rad, c.load_n, c.peak_pressure_pa, c.semi_axes_m);
    [contact(Side::Inner, &ball.inner), contact(Side::Outer, &ball.outer)]
}

fn add(entity: &mut SceneEntity, diameter: f64, scales: Scales, contact: &Contact) {
    let (sin, cos) = contact.normal.sin_cos();
    let along = |distance: f64| [distance * cos, distance * sin, 0.0];
    let part = contact.load_n / scales.load_n;
    // Loads of a run may outgrow the scale: the arrow says so up to a point.
    let length = LONGEST_ARROW * diameter * part.min(OVERLONG);
    let head = (0.28 * diameter).min(0.5 * length);
    entity.arrows.push(ArrowPrimitive {
        // The arrow lies along x of its pose: turned half round, it points against the normal.
        pose: Some(pose(along(0.5 * diameter + length), Rotation::about_z(contact.normal + PI))),
        shaft_length: length - head,
        shaft_diameter: 0.09 * diameter,
        head_length: head,
        head_diameter: 0.22 * diameter,
        color: Some(colour::scale(part)),
    });
    let [across, rolling] = contact.semi_axes_m.map(|x| 2.0 * PATCH_EXAGGERATION * x);
    entity.spheres.push(SpherePrimitive {
        // x along the normal, y across the groove, z along rolling.
        pose: Some(pose(along(0.5 * diameter), Rotation::about_z(contact.normal))),
        size: Some(vector([2.0 * PATCH_HALF_THICKNESS * diameter, across, rolling])),
        color: Some(colour::scale(contact.pressure_pa / scales.pressure_pa)),
    });
}
