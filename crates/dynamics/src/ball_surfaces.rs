//! Spalls and waves of balls: where they stand as the balls turn, and what they take off the approach of a contact.
//!
//! The orientation of a ball in its azimuth frame is a quaternion, q' = ½ (Ω − ω_m e_a) q. The depth h of a spall at a
//! contact follows from the angle between its middle and the contact, that of a form from the direction of the contact
//! in the ball; its derivative g by a rotation of the ball is a moment N g on the ball, and as much against it on the
//! orbit. So power and momentum hold.
//!
//! The contacts run where those of the most loaded ball are at the start, whatever the contact angle of the ball is.

use fearless_simd::{Level, dispatch};
use std::collections::BTreeSet;
use tribodyn_bearing::vectors::{cross, dot, rotated};
use tribodyn_bearing::{BallResult, BallSpall, Bearing, Races, RunInputs, Side};
use tribodyn_wear::{BallForm, BallSpallPath, BallWaves, LocalSurface, WearError};

/// A ball that has not turned in its azimuth frame, as a quaternion (x, y, z, w).
pub(crate) const UNTURNED: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

/// Spalls and waves of the balls of a bearing.
#[derive(Debug, Clone, Default)]
pub(crate) struct BallSurfaces {
    /// Balls that are not round, each once: the places of their orientations.
    balls: Vec<usize>,
    spalls: Vec<OnBall>,
    /// Form of each of those balls; empty where none has waves.
    forms: Vec<BallForm>,
    level: Option<Level>,
    ball_radius: f64,
    /// Normals (axial, radial) of the contacts that meet the spalls.
    normals: Races<[f64; 2]>,
}

/// A spall of a ball.
#[derive(Debug, Clone)]
pub(crate) struct OnBall {
    /// Number of the ball, and the place of its orientation.
    pub ball: usize,
    slot: usize,
    /// Direction of its middle in the ball at the start [a, r, t].
    direction: [f64; 3],
    pub paths: Races<BallSpallPath>,
}

/// A spall against a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpallPlace {
    /// Angle along rolling, rad.
    pub angle: f64,
    /// Distance across, m.
    pub across: f64,
    /// Direction of the spall's middle [a, r, t].
    direction: [f64; 3],
}

impl BallSurfaces {
    /// The balls with spalls or waves, each once, whose surfaces are not yet known.
    pub fn of(inputs: &RunInputs) -> Self {
        let waves = &inputs.ball_waves;
        let drawn = waves.spectrum.is_some_and(|spectrum| spectrum.amplitude != 0.0);
        let all = if drawn { 0..inputs.bearing.geometry.ball_count } else { 0..0 };
        let wavy = waves.waves.iter().filter(|wave| wave.wave.amplitude != 0.0).map(|wave| wave.ball);
        let marked: BTreeSet<_> = inputs.ball_spalls.iter().map(|spall| spall.ball).chain(wavy).chain(all).collect();
        Self { balls: marked.into_iter().collect(), ..Self::default() }
    }

    /// Sets their surfaces; the balls and the largest loads (N) are those of the start. A spall without depth is left
    /// out.
    pub fn set(
        &mut self,
        bearing: &Bearing,
        (spalls, waves): (&[BallSpall], &BallWaves),
        (balls, loads): (&[BallResult], Races<f64>),
    ) -> Result<(), WearError> {
        let tracks = Races::from_fn(|side| bearing.track(side, loads[side]));
        let heavier = |a: &&BallResult, b: &&BallResult| a.contacts.inner.load_n.total_cmp(&b.contacts.inner.load_n);
        let angles = balls.iter().max_by(heavier).map(|ball| ball.contacts.each_ref().map(|c| c.angle_rad));
        let [inner, outer] =
            angles.map_or([bearing.geometry.contact_angle(); 2], |angles| [angles.inner, angles.outer]);
        let normals = Races { inner: [-inner.sin(), -inner.cos()], outer: [outer.sin(), outer.cos()] };
        let on_ball = |spall: &BallSpall| {
            let ([n_a, n_r], (sin, cos)) = (normals.outer, spall.angle.sin_cos());
            let (off, on) = spall.latitude.sin_cos();
            let paths = Races::try_from_fn(|side| BallSpallPath::new(&spall.spall, &tracks[side]))?;
            Ok::<_, WearError>(OnBall {
                ball: spall.ball,
                slot: self.slot(spall.ball).unwrap_or_default(),
                direction: [on * cos * n_a + off * n_r, on * cos * n_r - off * n_a, on * sin],
                paths,
            })
        };
        let spalls = spalls.iter().map(on_ball).collect::<Result<Vec<_>, _>>()?;
        let [n_a, n_r] = normals.outer;
        let wavy = if waves.are_none() { &[][..] } else { &self.balls };
        let form = |ball: &usize| waves.form(*ball, [[n_a, n_r, 0.0], [0.0, 0.0, 1.0]]);
        let forms = wavy.iter().map(form).collect::<Result<Vec<_>, _>>()?;
        (self.spalls, self.forms, self.level) = (spalls, forms, Some(Level::new()));
        (self.ball_radius, self.normals) = (bearing.geometry.ball_radius(), normals);
        Ok(())
    }

    /// True if all balls are round.
    pub fn are_round(&self) -> bool {
        self.spalls.is_empty() && self.forms.is_empty()
    }

    /// All spalls.
    pub fn spalls(&self) -> &[OnBall] {
        &self.spalls
    }

    /// Place of the orientation of a ball; none for a round one.
    pub fn slot(&self, ball: usize) -> Option<usize> {
        self.balls.iter().position(|number| *number == ball)
    }

    /// Balls in the order of their orientations.
    pub fn balls(&self) -> &[usize] {
        &self.balls
    }

    /// Where a spall stands against the contact of a race, on whose ring the ball is so far behind its azimuth (rad).
    pub fn place(&self, spall: &OnBall, side: Side, (orientations, behind): (&[[f64; 4]], f64)) -> SpallPlace {
        let direction = rotated(orientations[spall.slot], spall.direction);
        let [normal, along, across] = self.contact_axes(side, behind).map(|axis| dot(axis, direction));
        SpallPlace { angle: along.atan2(normal), across: self.ball_radius * across, direction }
    }

    /// Directions in the azimuth frame of a contact's normal, along rolling, and across both.
    fn contact_axes(&self, side: Side, behind: f64) -> [[f64; 3]; 3] {
        let ([n_a, n_r], (sin, cos)) = (self.normals[side], behind.sin_cos());
        [[n_a, n_r * cos, -n_r * sin], [0.0, sin, cos], [n_r, -n_a * cos, n_a * sin]]
    }

    /// Adds what the spalls and waves of a ball do at a race.
    #[inline]
    pub fn add_to(&self, surface: &mut LocalSurface, (side, ball): (Side, usize), at: (&[[f64; 4]], f64)) {
        if self.are_round() {
            return;
        }
        let (orientations, behind) = at;
        let [normal, along, across] = self.contact_axes(side, behind);
        if let (Some(slot), Some(level)) = (self.slot(ball), self.level)
            && let Some(form) = self.forms.get(slot)
        {
            let [x, y, z, w] = orientations[slot];
            let contact = rotated([-x, -y, -z, w], normal);
            let (depth, gradient) = dispatch!(level, _simd => form.at(contact));
            surface.depth += depth;
            surface.turn_by(rotated(orientations[slot], cross(gradient, contact)));
        }
        for spall in self.spalls.iter().filter(|spall| spall.ball == ball) {
            let place = self.place(spall, side, at);
            let depth = spall.paths[side].at(place.angle, place.across);
            surface.depth += depth.depth;
            let [cosine, sine] = [normal, along].map(|axis| dot(axis, place.direction));
            // Of the angle by its sine and cosine; those change with a rotation by their axes times the direction.
            let share = depth.by_angle / (sine * sine + cosine * cosine).max(f64::MIN_POSITIVE);
            let [by_cosine, by_sine, by_across] = [normal, along, across].map(|axis| cross(place.direction, axis));
            surface.turn_by([0, 1, 2].map(|k| {
                share * (cosine * by_sine[k] - sine * by_cosine[k]) + depth.by_across * self.ball_radius * by_across[k]
            }));
        }
    }
}

/// First a quaternion, then a rotation by a vector, rad, its length kept at one.
pub(crate) fn turned_on([x, y, z, w]: [f64; 4], by: [f64; 3]) -> [f64; 4] {
    let angle = by.iter().map(|v| v * v).sum::<f64>().sqrt();
    let (sin, cos) = (0.5 * angle).sin_cos();
    let scale = if angle > 0.0 { sin / angle } else { 0.5 };
    let u = by.map(|v| v * scale);
    let across = cross(u, [x, y, z]);
    let vector = [0, 1, 2].map(|k| cos * [x, y, z][k] + w * u[k] + across[k]);
    let real = cos * w - (u[0] * x + u[1] * y + u[2] * z);
    let length = (vector.iter().map(|v| v * v).sum::<f64>() + real * real).sqrt();
    [vector[0], vector[1], vector[2], real].map(|v| v / length)
}
