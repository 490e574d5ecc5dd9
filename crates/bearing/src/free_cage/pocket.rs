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
    /// Place against the centre of the cage along and across the pocket's radius, m.
    on_circle: [f64; 2],
    /// Centre of the ball, inertial, m.
    ball: [f64; 3],
    /// From the ball's centre to the wall, inertial; zero in the very middle.
    outward: [f64; 3],
}

impl InPocket {
    /// Lead over the middle of the pocket, rad.
    pub fn lead(&self) -> f64 {
        let [r, t] = self.on_circle;
        t.atan2(r)
    }
}

/// The wall of a pocket as it is searched for a ball: one rule for all shapes, without a branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PocketWall {
    /// Gap of the centred ball where the wall is nearest, m.
    gap: f64,
    /// Half length of the straight walls along the axis and along the orbit, m.
    straight: [f64; 2],
    /// 1 where the wall is behind the ball along the radius too, else 0.
    radial: f64,
}

impl PocketWall {
    /// From the straight part of the wall's middle line to a ball at a place [a, r, t] about the middle of the pocket.
    #[inline(always)]
    fn to_wall(self, [a, r, t]: [f64; 3]) -> [f64; 3] {
        let beyond = |x: f64, straight: f64| (x.abs() - straight).max(0.0).copysign(x);
        [beyond(a, self.straight[0]), self.radial * r, beyond(t, self.straight[1])]
    }
}

impl PocketShape {
    /// The wall of such pockets with a gap along the orbit, m.
    pub fn wall(self, gap: f64) -> PocketWall {
        match self {
            Self::Cylinder => PocketWall { gap, straight: [0.0; 2], radial: 0.0 },
            Self::Sphere => PocketWall { gap, straight: [0.0; 2], radial: 1.0 },
            Self::RaceTrack { axial_gap } => {
                let least = gap.min(axial_gap);
                PocketWall { gap: least, straight: [axial_gap - least, gap - least], radial: 0.0 }
            }
        }
    }
}

impl Pocket {
    /// The wall of the pockets of a free cage.
    pub fn wall(&self, shape: PocketShape) -> PocketWall {
        shape.wall(self.clearance * self.radius)
    }

    /// A ball centre at a place [a, r, t] m in its azimuth frame, inertial, and as a pocket of a free cage sees it,
    /// which is in the direction `pocket` of the cage: along the cage's axis, the pocket's radius and the orbit, m.
    #[inline(always)]
    fn seen(
        (pose, pocket): (&CagePose, AzimuthFrame),
        (frame, at): (AzimuthFrame, [f64; 3]),
    ) -> ([f64; 3], [[f64; 3]; 3], [f64; 3]) {
        let [first, second, axis] = pose.axes;
        let radial = add(scaled(first, pocket.cos), scaled(second, pocket.sin));
        let tangential = add(scaled(first, -pocket.sin), scaled(second, pocket.cos));
        let ball = frame.to_inertial(at);
        let from_centre = along(pose.centre, ball);
        (ball, [axis, radial, tangential], [axis, radial, tangential].map(|direction| dot(from_centre, direction)))
    }

    /// How far a ball is pressed into the wall, m: [`InPocket::depth`] alone.
    #[inline(always)]
    pub fn depth_in(&self, wall: &PocketWall, cage: (&CagePose, AzimuthFrame), ball: (AzimuthFrame, [f64; 3])) -> f64 {
        let (_, _, [a, r, t]) = Self::seen(cage, ball);
        length(wall.to_wall([a, r - self.radius, t])) - wall.gap
    }

    /// Where a ball at a place [a, r, t] m in its azimuth frame is in the pocket in a direction of a free cage.
    #[inline]
    pub fn place(
        &self,
        wall: &PocketWall,
        cage: (&CagePose, AzimuthFrame),
        ball: (AzimuthFrame, [f64; 3]),
    ) -> InPocket {
        let (ball, [axis, radial, tangential], [a, r, t]) = Self::seen(cage, ball);
        let to_wall = wall.to_wall([a, r - self.radius, t]);
        let size = length(to_wall);
        let unit = if size > 0.0 { scaled(to_wall, 1.0 / size) } else { [0.0; 3] };
        let outward = add(scaled(axis, unit[0]), add(scaled(radial, unit[1]), scaled(tangential, unit[2])));
        InPocket { depth: size - wall.gap, on_circle: [r, t], ball, outward }
    }

    /// How fast a ball with a velocity [a, r, t] (m/s) goes into the wall, m/s.
    pub fn closing(&self, pose: &CagePose, place: &InPocket, (frame, velocity): (AzimuthFrame, [f64; 3])) -> f64 {
        let cage = pose.velocity_at(place.ball);
        dot(along(cage, frame.to_inertial(velocity)), place.outward)
    }

    /// Force and friction on a ball with a velocity and an absolute angular velocity [a, r, t] in a pocket of a free
    /// cage. Both act at the point of the ball that is next to the wall. Friction and damping are at most `hold`
    /// (N s/m) times the velocity that they are against: infinite, or what stops it within a step.
    pub fn load_of_free(
        &self,
        pose: &CagePose,
        place: &InPocket,
        (frame, velocity, omega): (AzimuthFrame, [f64; 3], [f64; 3]),
        hold: f64,
    ) -> PocketLoad {
        if place.depth <= 0.0 && self.film.is_none() {
            return PocketLoad::none();
        }
        let (n, arm) = (place.outward, scaled(place.outward, self.ball_radius));
        let of_ball = add(frame.to_inertial(velocity), cross(frame.to_inertial(omega), arm));
        let moving = along(pose.velocity_at(add(place.ball, arm)), of_ball);
        let closing = dot(moving, n);
        let film = self.film_of_free(place, closing);
        let depth = place.depth.max(0.0);
        let spring = self.stiffness * depth;
        let normal = (spring + (spring * self.damping).min(hold) * closing).max(0.0);
        let slip = across(moving, n);
        let (dragged, friction_power) = friction(self.friction, normal, slip, [CREEP, hold]);
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
    #[inline(always)]
    pub fn react(&mut self, pose: &CagePose, load: &PocketLoad, (frame, at): (AzimuthFrame, [f64; 3])) {
        let [a, r] = load.friction;
        let force = frame.to_inertial([-a, -r, -load.force]);
        let moment = frame.to_inertial(load.moment.map(|m| -m));
        self.add_at(along(pose.mass_centre, frame.to_inertial(at)), force, moment);
    }
}
