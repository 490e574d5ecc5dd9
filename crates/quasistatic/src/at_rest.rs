//! Bearings at rest: each ball is two Hertz springs in a row between the centres of its grooves.
//!
//! Without centrifugal force and friction the two contacts of a ball stand opposite each other, so that its place
//! follows from that of the ring: with s the distance of the groove centres, R_k the groove radius less that of the
//! ball and K_k the contact constants,
//!
//! ```text
//! δ = s − R_i − R_o,   Q = K δ^1.5,   K = (K_i^(−2/3) + K_o^(−2/3))^(−3/2)      where δ > 0
//! ```
//!
//! and a ball with δ ≤ 0 carries nothing, takes no part in the balance of the ring and none in its stiffness. It lies
//! where the least speed would throw it: at the bottom of the outer groove, or where the inner one stops it on its way
//! there. What is left are the freedoms of the ring in the potential Σ ⅖ Q δ − load·q, which is convex, as s is.
//! Several bearings on a rigid shaft are no more than that: a sum over all their balls.

use crate::block::{AXIAL, BALL, Balance, BlockState, BlockSystem, Iterate, RADIAL, RING};
use crate::driver;
use crate::jones_harris::{Typical, ring_action, ring_state};
use crate::methods::{Downhill, NewtonOrNested};
use crate::problem::{Place, QuasiStaticError};
use crate::relax::relax;
use crate::settle::FROM_NEAR;
use crate::stability::steadied;
use crate::{Model, rescue};
use tribodyn_bearing::{
    AzimuthFrame, Bearing, ContactPose, OperatingPoint, Races, RingFreedom, RingState, Scalar, Side,
};

/// Residual of the balances from which Newton's method goes on.
const ELASTIC: f64 = 1e-6;
/// The share of its way to the middle of its free space by which a ball that carries nothing stands off the races: more
/// than rounding, less than any load.
const OFF: f64 = 1e-9;

/// A bearing on a rigid shaft. Its ring's freedoms q are x, y, z (m) and the tilts about X and Y (rad), u those of the
/// shaft.
#[derive(Debug, Clone, Copy)]
pub struct Seated<'a> {
    /// The bearing.
    pub bearing: &'a Bearing,
    /// dq/du by rows.
    pub seat: [[f64; RING]; RING],
    /// Axial displacement of the ring where the shaft is not displaced, m.
    pub shift: f64,
    /// Axial force that moves a ring which slides, N; absent where the ring goes with the shaft.
    pub spring: Option<f64>,
}

impl<'a> Seated<'a> {
    /// A bearing whose ring is the shaft.
    pub fn alone(bearing: &'a Bearing) -> Self {
        let seat = std::array::from_fn(|row| std::array::from_fn(|column| f64::from(u8::from(row == column))));
        Self { bearing, seat, shift: 0.0, spring: None }
    }
}

/// True where no ring turns.
pub(crate) fn is_at_rest(point: &OperatingPoint) -> bool {
    point.inner_speed == 0.0 && point.outer_speed == 0.0
}

/// Freedoms of a shaft in its bearings at rest: x, y, z (m) and tilts about X and Y (rad), by the loads and held
/// freedoms of the operating point.
///
/// # Errors
/// [`QuasiStaticError::NotConverged`].
pub fn shaft_at_rest(bearings: Vec<Seated<'_>>, point: &OperatingPoint) -> Result<[f64; RING], QuasiStaticError> {
    let Some(first) = bearings.first() else { return Ok([0.0; RING]) };
    let still = Races { inner: 0.0, outer: 0.0 };
    let typical = Typical::new(first.bearing, &point.ring, still);
    let moments = Moments::OfPotential;
    let mut system = AtRest { bearings, ring: point.ring, frozen: true, moments, typical };
    let solved = system.solve(point);
    let worst = solved.worst();
    if worst.residual <= point.numerics.tolerance {
        return Ok(solved.state.ring);
    }
    Err(QuasiStaticError::NotConverged {
        model: Model::JonesHarris,
        equation: "force or moment",
        place: Place::Ring,
        residual: worst.residual,
        iterations: solved.statistics.accepted,
        tolerance: point.numerics.tolerance,
        reason: Box::new(rescue::why_not_at_rest(&solved)),
    })
}

/// The balances of a shaft, each of its bearings a block. The only unknown of a block is the place of a ring that
/// slides.
pub(crate) struct AtRest<'a> {
    bearings: Vec<Seated<'a>>,
    ring: [RingFreedom; RING],
    /// Contact constants of the free contact angle, with which the forces have a potential.
    frozen: bool,
    moments: Moments,
    typical: Typical,
}

/// How the moments of the balls on the ring are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Moments {
    /// About the axis of the outer ring, as in Jones–Harris: the derivative of the potential.
    OfPotential,
    /// About the centre of the displaced and tilted ring, as in the models with traction: a part in a thousand more.
    AboutRing,
}

/// A ball between the centres of its grooves.
struct Pressed<D> {
    /// Direction from the outer to the inner groove centre: axial, radial.
    direction: [D; 2],
    /// Approach of both contacts together, m; negative where there is a gap.
    approach: D,
    /// Load of both, N.
    load: D,
    /// Share of the approach at the outer race.
    outer_share: D,
}

impl<'a> AtRest<'a> {
    /// One bearing.
    pub fn of(bearing: &'a Bearing, point: &OperatingPoint, (typical, moments): (Typical, Moments)) -> Self {
        Self { bearings: vec![Seated::alone(bearing)], ring: point.ring, frozen: true, moments, typical }
    }

    /// The equilibrium of ring and balls of one bearing, in the unknowns of the other models.
    pub fn solve_bearing(&mut self, point: &OperatingPoint) -> Iterate {
        let solved = self.solve(point);
        let mut solved = steadied(&*self, solved, &self.typical, point);
        let Seated { bearing, .. } = self.bearings[0];
        let ring = solved.state.ring;
        let place = |index| {
            let [axial, radial] = self.place(bearing, index, ring);
            let mut ball = [0.0; BALL];
            (ball[AXIAL], ball[RADIAL]) = (axial, radial);
            ball
        };
        solved.state.balls = (0..bearing.geometry.ball_count).map(place).collect();
        solved
    }

    /// The state for the stiffness of the ring at its place.
    pub fn state(ring: [f64; RING]) -> BlockState {
        BlockState { balls: vec![[0.0; BALL]], ring }
    }

    /// Contact constants as the case asks for them.
    pub fn with_actual_constants(mut self) -> Self {
        self.frozen = false;
        self
    }

    /// Downhill in the potential to its one minimum; from near it by Newton's method, which the rounding of energies
    /// does not stop, or farther downhill where that finds no way.
    fn solve(&mut self, point: &OperatingPoint) -> Iterate {
        let (tolerance, limit) = (point.numerics.tolerance, point.numerics.max_iterations);
        let start = BlockState { balls: vec![[0.0; BALL]; self.bearings.len()], ring: [0.0; RING] };
        let near = ELASTIC.max(tolerance);
        let found = driver::run(&*self, Iterate::new(self, start), Downhill { mu: 1.0 }, near, limit);
        self.frozen = false;
        let solved = self.newton(&found, tolerance, limit);
        if solved.worst().residual <= tolerance {
            return solved;
        }
        self.frozen = true;
        let nearest = driver::run(&*self, found, Downhill { mu: 1.0 }, tolerance, limit);
        self.frozen = false;
        let solved = self.newton(&nearest, tolerance, limit);
        if solved.worst().residual <= tolerance {
            return solved;
        }
        let relaxed = relax(self, solved.state.clone(), ELASTIC, FROM_NEAR, limit);
        let statistics = solved.statistics;
        self.newton(&Iterate { statistics, ..Iterate::new(self, relaxed) }, tolerance, limit)
    }

    fn newton(&self, from: &Iterate, tolerance: f64, limit: usize) -> Iterate {
        let mut start = Iterate::new(self, from.state.clone());
        start.statistics = from.statistics;
        driver::run(self, start, NewtonOrNested::newton_alone(), tolerance, limit)
    }

    fn pressed<D: Scalar>(&self, bearing: &Bearing, index: usize, ring: [D; RING]) -> Pressed<D> {
        let [axial, radial] = groove_centres_apart(bearing, index, ring);
        let apart = (axial * axial + radial * radial).sqrt();
        let direction = [axial / apart, radial / apart];
        let approach = apart - (reach(bearing, index, Side::Inner) + reach(bearing, index, Side::Outer));
        let compliance = Races::from_fn(|side| {
            let hertz = if self.frozen {
                bearing.races[side].frozen::<D>()
            } else {
                bearing.hertz(side, &ContactPose { sin: direction[0], cos: direction[1], approach })
            };
            let stiffness = hertz.stiffness();
            (stiffness * stiffness).cbrt().recip()
        });
        let both = compliance.inner + compliance.outer;
        let load = if approach.re() > 0.0 {
            let pressed = approach / both;
            pressed * pressed.sqrt()
        } else {
            D::zero()
        };
        Pressed { direction, approach, load, outer_share: compliance.outer / both }
    }

    /// Where a ball stands against the centre of the outer groove: axial, radial, m.
    fn place(&self, bearing: &Bearing, index: usize, ring: [f64; RING]) -> [f64; 2] {
        let Pressed { direction: [sin, cos], approach, outer_share, .. } = self.pressed(bearing, index, ring);
        if approach > 0.0 {
            let length = reach(bearing, index, Side::Outer) + outer_share * approach;
            return [length * sin, length * cos];
        }
        let reaches = Races::from_fn(|side| reach(bearing, index, side));
        let apart = reaches.inner + reaches.outer + approach;
        let middle = 0.5 * (apart + reaches.outer - reaches.inner);
        let thrown = outermost([apart * sin, apart * cos], reaches);
        let to_middle = [middle * sin - thrown[0], middle * cos - thrown[1]];
        [thrown[0] + OFF * to_middle[0], thrown[1] + OFF * to_middle[1]]
    }

    /// The freedoms of a bearing's ring.
    fn freedoms<D: Scalar>(seated: &Seated<'_>, slid: D, shaft: [D; RING]) -> [D; RING] {
        let mut ring: [D; RING] = std::array::from_fn(|row| {
            (0..RING).fold(D::zero(), |sum, column| sum + shaft[column] * seated.seat[row][column])
        });
        ring[2] = if seated.spring.is_some() { slid } else { ring[2] + seated.shift };
        ring
    }
}

/// Moment (N m) that a ring's displacement and tilt add to that of its force on a ball: the groove centre stands off
/// the plane of the ring's centre, and the ring's centre beside the ball's radius.
fn about_ring<D: Scalar>(bearing: &Bearing, index: usize, ring: [D; RING], [axial, radial]: [D; 2]) -> [D; 2] {
    let frame = AzimuthFrame::at(bearing.azimuth(index));
    let lever = bearing.geometry.groove_centre_radius(Side::Inner);
    let off_plane = (ring[3] * frame.sin - ring[4] * frame.cos) * lever;
    let [_, _, beside] = frame.lift().from_inertial([ring[0], ring[1], ring[2]]);
    let [x, y, _] = frame.lift().to_inertial([D::zero(), -(beside * axial), off_plane * radial]);
    [x, y]
}

/// The farthest place from the axis between two races that a ball does not leave, by the inner groove centre and the
/// distances that it keeps from both, m: at the bottom of the outer groove, or where the inner one stops it.
fn outermost([axial, radial]: [f64; 2], Races { inner, outer }: Races<f64>) -> [f64; 2] {
    let bottom = [0.0, outer];
    if (bottom[0] - axial).hypot(bottom[1] - radial) <= inner {
        return bottom;
    }
    // The outer of the two points at the distances from either centre.
    let apart = axial.hypot(radial);
    let (sin, cos) = (axial / apart, radial / apart);
    let along = (apart * apart + outer * outer - inner * inner) / (2.0 * apart);
    let across = (outer * outer - along * along).max(0.0).sqrt().copysign(sin);
    [along * sin - across * cos, along * cos + across * sin]
}

/// Where a ball that the rings leave alone is thrown to by a centrifugal force, N: axial, radial against the centre of
/// the outer groove, m. None for a ball that they press.
pub(crate) fn thrown(bearing: &Bearing, index: usize, ring: [f64; RING], centrifugal: f64) -> Option<[f64; 2]> {
    let centre = groove_centres_apart(bearing, index, ring);
    let reaches = Races::from_fn(|side| reach(bearing, index, side));
    if centre[0].hypot(centre[1]) > reaches.inner + reaches.outer {
        return None;
    }
    let pressed_in = |side: Side, load: f64| reaches[side] + bearing.races[side].frozen::<f64>().approach(load);
    let [axial, radial] = outermost(centre, reaches);
    if axial == 0.0 {
        return Some([0.0, pressed_in(Side::Outer, centrifugal)]);
    }
    // Two contacts hold it: Q_i sin α_i = Q_o sin α_o, Q_i cos α_i + F_c = Q_o cos α_o.
    let (sin_o, cos_o) = (axial / reaches.outer, radial / reaches.outer);
    let (sin_i, cos_i) = ((centre[0] - axial) / reaches.inner, (centre[1] - radial) / reaches.inner);
    let turned = cos_o * sin_i - sin_o * cos_i;
    let loads = Races { inner: centrifugal * sin_o / turned, outer: centrifugal * sin_i / turned };
    if !(loads.inner >= 0.0 && loads.outer >= 0.0 && loads.inner + loads.outer < f64::INFINITY) {
        return Some([axial, radial]);
    }
    Some(outermost(centre, Races::from_fn(|side| pressed_in(side, loads[side]))))
}

/// Distance of the centre of an unloaded ball from that of a groove, m.
fn reach(bearing: &Bearing, index: usize, side: Side) -> f64 {
    drawn_reach(bearing, side) + bearing.depth_under(index, side)
}

/// The same of the ball of the drawing on a round race.
fn drawn_reach(bearing: &Bearing, side: Side) -> f64 {
    bearing.geometry.groove_offset(side) + bearing.worn[side].depth
}

/// From the outer to the inner groove centre at a ball: axial, radial, m.
fn groove_centres_apart<D: Scalar>(bearing: &Bearing, index: usize, ring: [D; RING]) -> [D; 2] {
    let frame = AzimuthFrame::at(bearing.azimuth(index)).lift();
    let outer = drawn_reach(bearing, Side::Outer);
    let (inner_ring, outer_ring) = (ring_state(ring, 0.0), RingState::centred(D::zero()));
    let rings = Races { inner: &inner_ring, outer: &outer_ring };
    let inner = bearing.pose(frame, [D::zero(), D::from(outer)], rings).contacts.inner;
    let length = inner.approach + drawn_reach(bearing, Side::Inner);
    [inner.sin * length, inner.cos * length + outer]
}

impl BlockSystem for AtRest<'_> {
    fn ring(&self) -> &[RingFreedom; RING] {
        &self.ring
    }

    fn ball<D: Scalar>(&self, index: usize, [slid, rest @ ..]: [D; BALL], shaft: [D; RING]) -> Balance<D> {
        let seated = &self.bearings[index];
        let (bearing, ring) = (seated.bearing, Self::freedoms(seated, slid, shaft));
        let (mut carried, mut total) = ([D::zero(); RING], 0.0);
        for ball in 0..bearing.geometry.ball_count {
            let Pressed { direction: [sin, cos], load, .. } = self.pressed(bearing, ball, ring);
            total += load.re() + self.typical.floor();
            let force = [load * sin, load * cos];
            let on_balls = ring_action(bearing, ball, force);
            (0..RING).for_each(|k| carried[k] += on_balls[k]);
            if self.moments == Moments::AboutRing && !self.frozen {
                let [x, y] = about_ring(bearing, ball, ring, force);
                (carried[3], carried[4]) = (carried[3] + x, carried[4] + y);
            }
        }
        // Unknowns that no ring has stay where they are.
        let mut residual = [D::zero(); BALL];
        let mut scale = [1.0; BALL];
        residual[0] = -slid;
        residual[1..].iter_mut().zip(rest).for_each(|(residual, unknown)| *residual = -unknown);
        if let Some(force) = seated.spring {
            (residual[0], scale[0]) = (-carried[2] + force, total + force.abs());
            carried[2] = D::from(force);
        }
        let lever = bearing.geometry.groove_centre_radius(Side::Inner);
        let size = [total, total, total, total * lever, total * lever];
        let through = |k: usize| (0..RING).fold(D::zero(), |sum, row| sum + carried[row] * seated.seat[row][k]);
        let sizes = |k: usize| (0..RING).map(|row| size[row] * seated.seat[row][k].abs()).sum();
        Balance { residual, scale, ring: std::array::from_fn(through), ring_scale: std::array::from_fn(sizes) }
    }

    fn weights(&self) -> ([f64; BALL], [f64; RING]) {
        let k = self.typical.stiffness * self.typical.balls;
        ([k, 1.0, 1.0, 1.0, 1.0, 1.0], self.typical.ring_weights())
    }

    fn inertia(&self) -> [f64; BALL] {
        let creep = 1e-4 * self.typical.stiffness * self.typical.balls;
        [creep, 0.0, 0.0, 0.0, 0.0, 0.0]
    }

    fn step_limits(&self) -> ([f64; BALL], [f64; RING]) {
        let any = f64::INFINITY;
        ([self.typical.position_limit(), any, any, any, any, any], self.typical.ring_limits())
    }

    fn energy(&self, state: &BlockState) -> f64 {
        let mut energy = 0.0;
        for (seated, &[slid, ..]) in self.bearings.iter().zip(&state.balls) {
            let ring = Self::freedoms(seated, slid, state.ring);
            for ball in 0..seated.bearing.geometry.ball_count {
                let Pressed { approach, load, .. } = self.pressed(seated.bearing, ball, ring);
                energy += 0.4 * load * approach.max(0.0);
            }
            energy -= seated.spring.unwrap_or_default() * slid;
        }
        for (freedom, q) in self.ring.iter().zip(state.ring) {
            if let RingFreedom::Loaded(load) = freedom {
                energy -= load * q;
            }
        }
        energy
    }
}
