//! Spalls of balls: where they stand as the balls turn, and what they take off the approach of a contact.
//!
//! The orientation of a ball in its azimuth frame is a quaternion, q' = ½ (Ω − ω_m e_a) q. The depth h of a spall at a
//! contact follows from the angle between its middle and the contact; its derivative g by a rotation of the ball is a
//! moment N g on the ball, and as much against it on the orbit. So power and momentum hold.
//!
//! The contacts run where those of the most loaded ball are at the start, whatever the contact angle of the ball is.

use std::collections::BTreeSet;
use tribodyn_bearing::vectors::{cross, rotated};
use tribodyn_bearing::{BallResult, BallSpall, Bearing, Races, SPALLED_BALLS, Side};
use tribodyn_wear::{BallSpallPath, LocalSurface, WearError};

/// A ball that has not turned in its azimuth frame, as a quaternion (x, y, z, w).
pub(crate) const UNTURNED: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

/// Spalls of the balls of a bearing.
#[derive(Debug, Clone, Default)]
pub(crate) struct BallSpalls {
    /// Balls with spalls, each once: the places of their orientations.
    balls: Vec<usize>,
    spalls: Vec<OnBall>,
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

/// Balls with spalls, each once.
pub(crate) fn spalled_balls(spalls: &[BallSpall]) -> Vec<usize> {
    spalls.iter().map(|spall| spall.ball).collect::<BTreeSet<_>>().into_iter().collect()
}

impl BallSpalls {
    /// Spalls of a bearing whose balls and largest loads (N) are those of the start. One without depth is left out.
    pub fn new(
        bearing: &Bearing,
        spalls: &[BallSpall],
        (balls, loads): (&[BallResult], Races<f64>),
    ) -> Result<Self, WearError> {
        let tracks = Races::from_fn(|side| bearing.track(side, loads[side]));
        let heavier = |a: &&BallResult, b: &&BallResult| a.contacts.inner.load_n.total_cmp(&b.contacts.inner.load_n);
        let angles = balls.iter().max_by(heavier).map(|ball| ball.contacts.each_ref().map(|c| c.angle_rad));
        let [inner, outer] =
            angles.map_or([bearing.geometry.contact_angle(); 2], |angles| [angles.inner, angles.outer]);
        let normals = Races { inner: [-inner.sin(), -inner.cos()], outer: [outer.sin(), outer.cos()] };
        let numbers = spalled_balls(spalls);
        let on_ball = |spall: &BallSpall| {
            let ([n_a, n_r], (sin, cos)) = (normals.outer, spall.angle.sin_cos());
            let (off, on) = spall.latitude.sin_cos();
            let paths = Races::try_from_fn(|side| BallSpallPath::new(&spall.spall, &tracks[side]))?;
            Ok::<_, WearError>(OnBall {
                ball: spall.ball,
                slot: numbers.iter().position(|ball| *ball == spall.ball).unwrap_or_default(),
                direction: [on * cos * n_a + off * n_r, on * cos * n_r - off * n_a, on * sin],
                paths,
            })
        };
        let spalls = spalls.iter().map(on_ball).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { balls: numbers, spalls, ball_radius: bearing.geometry.ball_radius(), normals })
    }

    /// True if no ball has any.
    pub fn are_none(&self) -> bool {
        self.spalls.is_empty()
    }

    /// All of them.
    pub fn all(&self) -> &[OnBall] {
        &self.spalls
    }

    /// Place of the orientation of a ball; none for a ball without a spall.
    pub fn slot(&self, ball: usize) -> Option<usize> {
        self.balls.iter().position(|number| *number == ball)
    }

    /// Balls in the order of their orientations.
    pub fn balls(&self) -> &[usize] {
        &self.balls
    }

    /// Where a spall stands against the contact of a race.
    pub fn place(&self, spall: &OnBall, side: Side, orientations: &[[f64; 4]; SPALLED_BALLS]) -> SpallPlace {
        let direction = rotated(orientations[spall.slot], spall.direction);
        let ([n_a, n_r], [a, r, t]) = (self.normals[side], direction);
        let angle = t.atan2(a * n_a + r * n_r);
        SpallPlace { angle, across: self.ball_radius * (a * n_r - r * n_a), direction }
    }

    /// Adds what the spalls of a ball do at a race.
    #[inline]
    pub fn add_to(
        &self,
        surface: &mut LocalSurface,
        (side, ball): (Side, usize),
        orientations: &[[f64; 4]; SPALLED_BALLS],
    ) {
        for spall in self.spalls.iter().filter(|spall| spall.ball == ball) {
            let SpallPlace { angle, across, direction } = self.place(spall, side, orientations);
            let depth = spall.paths[side].at(angle, across);
            surface.depth += depth.depth;
            let [n_a, n_r] = self.normals[side];
            let (along, towards) = (direction[2], direction[0] * n_a + direction[1] * n_r);
            // Of the angle by its sine and cosine; those change with a rotation by their axes times the direction.
            let share = depth.by_angle / (along * along + towards * towards).max(f64::MIN_POSITIVE);
            let by_sine = cross(direction, [0.0, 0.0, 1.0]);
            let by_cosine = cross(direction, [n_a, n_r, 0.0]);
            let by_across = cross(direction, [n_r, -n_a, 0.0]);
            let turn = |k: usize| {
                share * (towards * by_sine[k] - along * by_cosine[k])
                    + depth.by_across * self.ball_radius * by_across[k]
            };
            (0..3).for_each(|k| surface.turn[k] += turn(k));
            surface.slope -= turn(0);
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
