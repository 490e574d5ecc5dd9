//! How a contact slides, and its traction as force and moment on the ball.

use crate::contact::{NormalContact, RaceContact};
use crate::races::Side;
use crate::vectors::{add, dot, sum};
use tribodyn_contact::{Ellipse, Scalar};
use tribodyn_traction::{PatchTraction, RelativeMotion};

/// A loaded contact's motion in the axes of its patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sliding<D = f64> {
    /// Outward normal from the ball centre (axial, radial).
    pub normal: [D; 2],
    /// The ball's motion against the race.
    pub motion: RelativeMotion<D>,
    /// Mean of the two surface speeds along e_t in the orbiting frame, m/s.
    pub rolling_speed: D,
    /// How much nearer than the nominal radius the patch stands to the ball's centre, m: the motion is that of the
    /// bodies as seen from a centre moved by so much towards the patch.
    pub sunk: D,
    /// Axis, outward direction and direction round a ring that is free to tilt, in the ball's axes; none where the
    /// ball's own axes serve.
    pub meridian: Option<[[D; 3]; 3]>,
}

/// Traction of a contact in the axes of the ball [a, r, t].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForces<D = f64> {
    /// Force on the ball, N.
    pub force: [D; 3],
    /// Moment on the ball about its centre, N m.
    pub moment: [D; 3],
}

impl<D: Scalar> Sliding<D> {
    /// Integrals over the patch as force and moment on the ball.
    #[inline(always)]
    pub fn on_ball(&self, traction: &PatchTraction<D>) -> ContactForces<D> {
        let [n_a, n_r] = self.normal;
        // e_y = (n_r, −n_a, 0).
        let lateral = traction.force_lateral;
        // The arm is shorter than the radius that the integrals have.
        let about_lateral = traction.moment_lateral - traction.force_rolling * self.sunk;
        let about_rolling = traction.moment_rolling + lateral * self.sunk;
        let forces = ContactForces {
            force: [lateral * n_r, -(lateral * n_a), traction.force_rolling],
            moment: [
                about_lateral * n_r + traction.moment_normal * n_a,
                traction.moment_normal * n_r - about_lateral * n_a,
                about_rolling,
            ],
        };
        match &self.meridian {
            Some(axes) => ContactForces { force: sum(axes, forces.force), moment: sum(axes, forces.moment) },
            None => forces,
        }
    }
}

impl Sliding {
    /// A traction whose force on the ball is another one (a, r, t), N, which acts at the contact.
    #[inline(always)]
    pub fn with_force(&self, traction: &PatchTraction, force: [f64; 3], ball_radius: f64) -> PatchTraction {
        let [a, r, rolling] = self.meridian.map_or(force, |axes| axes.map(|axis| dot(axis, force)));
        let [n_a, n_r] = self.normal;
        let lateral = a * n_r - r * n_a;
        let [more, more_lateral] = [rolling - traction.force_rolling, lateral - traction.force_lateral];
        let mut with = PatchTraction {
            force_rolling: rolling,
            force_lateral: lateral,
            moment_lateral: traction.moment_lateral + ball_radius * more,
            moment_rolling: traction.moment_rolling - ball_radius * more_lateral,
            ..*traction
        };
        with.power = -with.work_on(&self.motion);
        with
    }
}

impl<D: Scalar> RaceContact<D> {
    /// A contact from its parts.
    #[inline(always)]
    pub fn new(
        side: Side,
        normal: NormalContact<D>,
        ellipse: Ellipse<D>,
        sliding: &Sliding<D>,
        traction: PatchTraction<D>,
    ) -> Self {
        let ContactForces { force: traction_force, moment } = sliding.on_ball(&traction);
        let Sliding { motion, rolling_speed, .. } = *sliding;
        let force = add(normal.on_ball(side), traction_force);
        Self { normal, ellipse, motion, rolling_speed, traction, traction_force, force, moment }
    }
}
