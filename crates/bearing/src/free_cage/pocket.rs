//! A ball in a pocket of a cage that is free to move.

use super::friction;
use super::{CagePose, Wrench};
use crate::frame::AzimuthFrame;
use crate::pocket::{CREEP, Pocket, PocketLoad};
use crate::vectors::{across, add, along, cross, dot, length, scaled};

/// Form of the pockets, all with the pocket's gap about the centred ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PocketShape {
    /// A cylinder with its axis radial: it holds no ball along the radius.
    Cylinder,
    /// A sphere about the ball: it holds the cage on its balls.
    Sphere,
    /// Two half cylinders with flat walls between, longer along the axis or along the orbit: the gap is that along the
    /// orbit, this (m) that along the axis.
    RaceTrack {
        /// Gap along the axis, m.
        axial_gap: f64,
    },
}

/// A ball as its pocket sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InPocket {
    /// How far it is pressed into the wall, m; negative where there is a gap.
    pub depth: f64,
    /// Lead over the middle of the pocket, rad.
    pub lead: f64,
    /// Centre of the ball, inertial, m.
    ball: [f64; 3],
    /// From the ball's centre to the wall, inertial; zero in the very middle.
    outward: [f64; 3],
}

impl PocketShape {
    /// Depth in the wall and the direction to it, of a ball at a place [a, r, t] against the middle of the pocket.
    fn wall(self, gap: f64, [a, r, t]: [f64; 3]) -> (f64, [f64; 3]) {
        let (gap, to_wall) = match self {
            Self::Cylinder => (gap, [a, 0.0, t]),
            Self::Sphere => (gap, [a, r, t]),
            Self::RaceTrack { axial_gap } => {
                let least = gap.min(axial_gap);
                let beyond = |x: f64, straight: f64| (x.abs() - straight).max(0.0).copysign(x);
                (least, [beyond(a, axial_gap - least), 0.0, beyond(t, gap - least)])
            }
        };
        let size = length(to_wall);
        let unit = if size > 0.0 { scaled(to_wall, 1.0 / size) } else { [0.0; 3] };
        (size - gap, unit)
    }
}

impl Pocket {
    /// Where a ball at a place [a, r, t] m in its azimuth frame is in the pocket at an angle (rad) of a free cage.
    pub fn place(
        &self,
        shape: PocketShape,
        (pose, angle): (&CagePose, f64),
        (frame, at): (AzimuthFrame, [f64; 3]),
    ) -> InPocket {
        let [first, second, axis] = pose.axes;
        let (sin, cos) = angle.sin_cos();
        let radial = add(scaled(first, cos), scaled(second, sin));
        let tangential = add(scaled(first, -sin), scaled(second, cos));
        let ball = frame.to_inertial(at);
        let from_centre = along(pose.centre, ball);
        let (a, r, t) = (dot(from_centre, axis), dot(from_centre, radial), dot(from_centre, tangential));
        let (depth, unit) = shape.wall(self.clearance * self.radius, [a, r - self.radius, t]);
        let outward = add(scaled(axis, unit[0]), add(scaled(radial, unit[1]), scaled(tangential, unit[2])));
        InPocket { depth, lead: t.atan2(r), ball, outward }
    }

    /// How fast a ball with a velocity [a, r, t] (m/s) goes into the wall, m/s.
    pub fn closing(&self, pose: &CagePose, place: &InPocket, (frame, velocity): (AzimuthFrame, [f64; 3])) -> f64 {
        let cage = pose.velocity_at(place.ball);
        dot(along(cage, frame.to_inertial(velocity)), place.outward)
    }

    /// Force and friction on a ball with a velocity and an absolute spin [a, r, t] in a pocket of a free cage. Both act
    /// at the point of the ball that is next to the wall.
    pub fn load_of_free(
        &self,
        pose: &CagePose,
        place: &InPocket,
        (frame, velocity, spin): (AzimuthFrame, [f64; 3], [f64; 3]),
    ) -> PocketLoad {
        if place.depth <= 0.0 && self.film.is_none() {
            return PocketLoad::none();
        }
        let (n, arm) = (place.outward, scaled(place.outward, self.ball_radius));
        let of_ball = add(frame.to_inertial(velocity), cross(frame.to_inertial(spin), arm));
        let moving = along(pose.velocity_at(add(place.ball, arm)), of_ball);
        let closing = dot(moving, n);
        let film = self.film_of_free(place, closing);
        let depth = place.depth.max(0.0);
        let spring = self.stiffness * depth;
        let normal = (spring * (1.0 + self.damping * closing)).max(0.0);
        let slip = across(moving, n);
        let (dragged, friction_power) = friction(self.friction, normal, slip, CREEP);
        let force = add(scaled(n, -(normal + film)), dragged);
        let moment = frame.from_inertial(cross(arm, dragged));
        let [a, r, t] = frame.from_inertial(force);
        let [_, radius, _] = frame.from_inertial(place.ball);
        PocketLoad {
            force: t,
            friction: [a, r],
            moment,
            cage_torque: -(radius * t + moment[0]),
            energy: 0.5 * spring * depth,
            damping_power: (normal - spring + film) * closing,
            friction_power,
            sliding: length(slip),
            normal,
        }
    }
}

impl Pocket {
    /// Force of the oil on a ball away from the wall next to it, N: below 0 where it approaches the wall behind it.
    fn film_of_free(&self, place: &InPocket, closing: f64) -> f64 {
        let Some(film) = &self.film else { return 0.0 };
        let across = 2.0 * self.clearance * self.radius;
        film.force(-place.depth, closing) - film.force(across + place.depth, -closing)
    }
}

impl Wrench {
    /// Adds the reaction of a pocket's load on the ball whose centre is at [a, r, t] m.
    pub fn react(&mut self, pose: &CagePose, load: &PocketLoad, (frame, at): (AzimuthFrame, [f64; 3])) {
        let [a, r] = load.friction;
        let force = frame.to_inertial([-a, -r, -load.force]);
        let moment = frame.to_inertial(load.moment.map(|m| -m));
        self.add_at(along(pose.mass_centre, frame.to_inertial(at)), force, moment);
    }
}
