//! Supports of a shaft: the force of a bearing on its inner ring by the ring's displacement.

use nalgebra::SVector;
use num_dual::{Derivative, DualSVec64};
use tribodyn_bearing::{AzimuthFrame, Bearing, OperatingPoint, Races, RingFreedom, RingState, Scalar, Side};
use tribodyn_quasistatic::{
    Model, QuasiStaticError, StiffnessMatrix, WarmStart, jones_harris_stiffness, solve, solve_from, traction_stiffness,
};

use crate::element::FREEDOMS;

/// Displacement x, y, z (m) and tilts about X and Y (rad), or forces (N) and moments (N m).
pub type Vector = [f64; FREEDOMS];

/// Force that holds an inner ring in its place, and its stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    /// Force (N) and moment about the bearing's middle (N m) on the inner ring.
    pub force: Vector,
    /// Its derivatives by the displacement.
    pub stiffness: StiffnessMatrix,
}

impl Held {
    /// A ring that nothing touches.
    pub const FREE: Self = Self { force: [0.0; FREEDOMS], stiffness: [[0.0; FREEDOMS]; FREEDOMS] };
}

/// A bearing, or anything else between shaft and housing, by the displacement of its inner ring against the outer one.
pub trait RingForce {
    /// Force that holds the inner ring at a displacement, and its stiffness.
    ///
    /// # Errors
    /// [`QuasiStaticError`] where there is no equilibrium of the balls.
    fn at(&mut self, displacement: &Vector) -> Result<Held, QuasiStaticError>;

    /// Longest change of the displacement (m, and rad) in a step of Newton's method.
    fn longest_step(&self) -> [f64; 2];

    /// Half the axial play, m: farther out of its load than this an angular-contact bearing has nothing to bear on.
    fn half_play(&self) -> f64 {
        f64::INFINITY
    }
}

/// A linear spring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring(pub StiffnessMatrix);

impl Spring {
    /// Without coupling between the freedoms.
    pub fn diagonal(stiffness: Vector) -> Self {
        Self(std::array::from_fn(|i| std::array::from_fn(|j| if i == j { stiffness[i] } else { 0.0 })))
    }
}

impl RingForce for Spring {
    fn at(&mut self, displacement: &Vector) -> Result<Held, QuasiStaticError> {
        Ok(Held { force: times(&self.0, displacement), stiffness: self.0 })
    }

    fn longest_step(&self) -> [f64; 2] {
        [f64::INFINITY; 2]
    }
}

/// Longest step over the ball diameter: balls are pressed in by about a thousandth of it.
const LONGEST: f64 = 2e-3;

fn longest_step(bearing: &Bearing) -> [f64; 2] {
    let length = LONGEST * bearing.geometry.ball_diameter;
    [length, 2.0 * length / bearing.geometry.pitch_diameter]
}

/// A ball bearing at rest and without friction. Each ball then stands on the line between the groove centres, pressed
/// by both contacts in series, so that it drops out of the equations:
///
/// ```text
/// s = |A| − (f_i + f_o − 1) D,   Q = s^1.5 / (K_i^(−2/3) + K_o^(−2/3))^1.5 for s > 0
/// ```
/// A is the vector between the groove centres. It is the limit of Jones and Harris's equations at rest.
#[derive(Debug, Clone, Copy)]
pub struct RestingBearing<'a> {
    /// The bearing.
    pub bearing: &'a Bearing,
    /// Azimuth of the first ball, rad.
    pub first_ball: f64,
}

/// One ball of a bearing at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestingBall<D = f64> {
    /// Load of both contacts, N.
    pub load: D,
    /// Sine of the contact angle.
    pub sin: D,
    /// Its cosine.
    pub cos: D,
}

impl RestingBearing<'_> {
    /// A ball at an azimuth (rad) under a displacement of the inner ring.
    pub fn ball<D: Scalar>(&self, azimuth: f64, displacement: [D; FREEDOMS]) -> RestingBall<D> {
        let bearing = self.bearing;
        let [x, y, z, tilt_x, tilt_y] = displacement;
        let inner = RingState { displacement: [x, y, z], tilt: [tilt_x, tilt_y], ..RingState::centred(D::zero()) };
        let outer = RingState::centred(D::zero());
        let frame = AzimuthFrame::at(azimuth).lift();
        // The inner contact of a ball in the outer groove centre lies along A.
        let between = bearing.pose(frame, [D::zero(); 2], Races { inner: &inner, outer: &outer }).contacts.inner;
        let approach = between.approach - (bearing.geometry.groove_offset(Side::Outer) + bearing.worn.outer.depth);
        let (sin, cos) = (between.sin, between.cos);
        if approach.re() <= 0.0 {
            return RestingBall { load: D::zero(), sin, cos };
        }
        let weakness = Side::BOTH.map(|side| self.hertz_stiffness(side, cos).powf(-2.0 / 3.0));
        let load = (approach / (weakness[0] + weakness[1])).powf(1.5);
        RestingBall { load, sin, cos }
    }

    /// Azimuth of a ball, rad.
    pub fn azimuth(&self, ball: usize) -> f64 {
        self.first_ball + self.bearing.azimuth(ball)
    }

    fn hertz_stiffness<D: Scalar>(&self, side: Side, cos: D) -> D {
        let race = &self.bearing.races[side];
        if self.bearing.modelling.contact_at_actual_angle {
            let [rolling, lateral] = self.bearing.geometry.curvatures(side, cos);
            if let Ok(hertz) = race.hertz_at(rolling, lateral) {
                return hertz.stiffness();
            }
        }
        race.frozen().stiffness()
    }
}

impl RingForce for RestingBearing<'_> {
    fn at(&mut self, displacement: &Vector) -> Result<Held, QuasiStaticError> {
        let mut held = Held::FREE;
        let seeded: [DualSVec64<FREEDOMS>; FREEDOMS] = std::array::from_fn(|k| {
            let mut direction = SVector::<f64, FREEDOMS>::zeros();
            direction[k] = 1.0;
            DualSVec64::new(displacement[k], Derivative::some(direction))
        });
        let lever = self.bearing.geometry.groove_centre_radius(Side::Inner);
        for index in 0..self.bearing.geometry.ball_count {
            let azimuth = self.azimuth(index);
            let RestingBall { load, sin, cos } = self.ball(azimuth, seeded);
            if load.re <= 0.0 {
                continue;
            }
            let (along_y, along_x) = azimuth.sin_cos();
            let (axial, radial) = (load * sin, load * cos);
            let parts =
                [radial * along_x, radial * along_y, axial, axial * (lever * along_y), axial * (-lever * along_x)];
            for (k, part) in parts.into_iter().enumerate() {
                held.force[k] += part.re;
                let slope = part.eps.unwrap_generic(nalgebra::Const::<FREEDOMS>, nalgebra::Const::<1>);
                (0..FREEDOMS).for_each(|c| held.stiffness[k][c] += slope[c]);
            }
        }
        Ok(held)
    }

    fn longest_step(&self) -> [f64; 2] {
        longest_step(self.bearing)
    }

    fn half_play(&self) -> f64 {
        0.5 * self.bearing.geometry.axial_play()
    }
}

/// Centrifugal force of all balls together that is next to nothing, N.
const SLIGHT: f64 = 0.1;

/// A ball bearing that turns, in quasi-static equilibrium.
#[derive(Debug, Clone)]
pub struct TurningBearing<'a> {
    bearing: &'a Bearing,
    point: OperatingPoint,
    model: Model,
    near: Option<WarmStart>,
}

impl<'a> TurningBearing<'a> {
    /// A bearing at the speeds of an operating point, whose ring freedoms do not matter.
    pub fn new(bearing: &'a Bearing, point: &OperatingPoint, model: Model) -> Self {
        Self { bearing, point: point.clone(), model, near: None }
    }

    /// True where no ball would touch at rest, and all press outwards by next to nothing.
    fn idle(&self, displacement: &Vector) -> bool {
        let geometry = &self.bearing.geometry;
        let gamma = geometry.ball_diameter * geometry.cos_contact_angle() / geometry.pitch_diameter;
        let orbit = 0.5 * (self.point.inner_speed * (1.0 - gamma) + self.point.outer_speed * (1.0 + gamma));
        let outwards =
            geometry.ball_count as f64 * self.bearing.ball_mass * 0.5 * geometry.pitch_diameter * orbit * orbit;
        let resting = RestingBearing { bearing: self.bearing, first_ball: 0.0 };
        let touches = |ball| resting.ball(resting.azimuth(ball), *displacement).load > 0.0;
        outwards < SLIGHT && !(0..geometry.ball_count).any(touches)
    }
}

impl RingForce for TurningBearing<'_> {
    fn at(&mut self, displacement: &Vector) -> Result<Held, QuasiStaticError> {
        let point = OperatingPoint { ring: displacement.map(RingFreedom::Held), ..self.point.clone() };
        let near = self.near.as_ref().and_then(|near| solve_from(self.bearing, &point, near).ok());
        let solved = match near {
            Some(solved) => solved,
            // Raceway control has no equilibrium of balls that hardly press.
            None => match solve(self.bearing, &point, self.model) {
                Err(_) if self.idle(displacement) => return Ok(Held::FREE),
                solved => solved?,
            },
        };
        let stiffness = match &solved.warm_start {
            Some(at) => traction_stiffness(self.bearing, &point, at)?,
            None => jones_harris_stiffness(self.bearing, &point)?,
        };
        let ([x, y, z], [mx, my]) = (solved.solution.ring_load_n, solved.solution.ring_moment_nm);
        self.near = solved.warm_start;
        Ok(Held { force: [x, y, z, mx, my], stiffness })
    }

    fn longest_step(&self) -> [f64; 2] {
        longest_step(self.bearing)
    }

    fn half_play(&self) -> f64 {
        0.5 * self.bearing.geometry.axial_play()
    }
}

/// A matrix times a vector.
pub(crate) fn times(matrix: &StiffnessMatrix, vector: &Vector) -> Vector {
    std::array::from_fn(|i| (0..FREEDOMS).map(|j| matrix[i][j] * vector[j]).sum())
}
