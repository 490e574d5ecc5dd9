//! The drift of balls that vibrate too fast for leapfrog: implicit in their springs and dampers.
//!
//! Velocities change by half of the accelerations at either end of a piece, as in leapfrog, and so do those of the
//! rings: what one loses the other has. Positions of the balls follow the mean of both velocities,
//!
//! x₁ = x₀ + h v₀ + h²/4 (a₀ + a₁), a₁ with v₁ = v₀ + h/2 (a₀ + a₁),
//!
//! the trapezium rule, or Newmark's method of constant mean acceleration: of second order, stable for any ω h, and
//! without damping of its own, so that what is too fast for h rings as long as its dampers let it, only slower. Two
//! unknowns a ball, axial and radial, by Newton's method with the stiffness and the dampers of both contacts; what else
//! an acceleration depends on is slow and left to the iteration.
//!
//! The rings vibrate more slowly and are looked at more closely. Theirs are
//!
//! x₁ = x₀ + h v₀ + h²/12 (5 a₀ + a₁),
//!
//! which is of fourth order for what vibrates, where leapfrog and the trapezium rule are of second; stable up to
//! ω h = √6. What the change of a ring's acceleration adds is small, and one look at it is enough; the balls follow it.
//!
//! Sources: N. M. Newmark, J. Eng. Mech. Div. ASCE 85 (1959) 67; L. Fox, E. T. Goodwin, Proc. Camb. Phil. Soc. 45
//! (1949) 373.

use super::Fast;
use super::drift::{Pressed, drift_acceleration};
use super::lanes::{InUse, Lane, get, put, sin_cos};
use super::scratch::{Explicit, Scratch};
use crate::equations::Equations;
use crate::layout::{AXIAL, AZIMUTH, BALL, Layout, ORBIT, RADIUS, VELOCITY};
use fearless_simd::dispatch;
use tribodyn_bearing::{AzimuthFrame, NormalContact, Races, Side};

/// Corrections at most: usual are one or two, more where a ball leaves a race or meets it.
const MOST_CORRECTIONS: usize = 8;
/// Part of an approach by which a correction may change it and be the last: its square is left.
const LAST_CHANGE: f64 = 2e-3;
/// Share of h² by which a change of a ring's acceleration moves it: with a twelfth what vibrates is right to the fourth
/// order of h, and stable up to ω h = √6.
pub(super) const OF_RINGS: f64 = 1.0 / 12.0;
/// Least approach that this is taken of, m.
const LEAST_APPROACH: f64 = 1e-7;

/// Springs and dampers of a contact as they act on a ball in a piece, over its inertia.
#[derive(Clone, Copy)]
pub(super) struct Weights {
    /// At a stiffness of 1 N/m: in a piece h²/4 over the mass.
    pub of_spring: f64,
    /// h/2 · 2ζ/√m: of a damper, by the root of the stiffness.
    pub of_damper: f64,
}

/// A contact as Newton's method sees it: its normal, (axial, radial), by which a motion of the ball adds to the
/// approach, the approach, and the weights of spring and damper.
#[derive(Clone, Copy)]
pub(super) struct Line {
    normal: [f64; 2],
    approach: f64,
    spring: f64,
    damper: f64,
}

impl Line {
    #[inline(always)]
    pub fn of(contact: &NormalContact, side: Side, (weights, relative_mass): (Weights, f64)) -> Self {
        let approach = contact.pose.approach;
        let stiffness = if contact.load > 0.0 { 1.5 * contact.load / (relative_mass * approach) } else { 0.0 };
        let (spring, damper) = (weights.of_spring * stiffness, weights.of_damper * stiffness.sqrt());
        Self { normal: contact.pose.normal(side), approach, spring, damper }
    }

    /// The same, with a spring of some weight where there is none or a softer one.
    #[inline(always)]
    pub fn with_spring_of_at_least(self, least: f64) -> Self {
        Self { spring: self.spring.max(least), ..self }
    }

    /// The same, but none where a damper pulls as hard as the spring presses: that leaves no force that could change.
    #[inline(always)]
    fn pressing(contact: &NormalContact, side: Side, of_ball: (Weights, f64)) -> Self {
        let line = Self::of(contact, side, of_ball);
        let share = if contact.force > 0.0 { 1.0 } else { 0.0 };
        Self { spring: share * line.spring, damper: share * line.damper, ..line }
    }

    #[inline(always)]
    fn along(&self, [axial, radial]: [f64; 2]) -> f64 {
        self.normal[0] * axial + self.normal[1] * radial
    }

    /// Change of the approach by a motion of the ball, over what it is.
    #[inline(always)]
    fn change(&self, by: [f64; 2]) -> f64 {
        let change = self.along(by);
        let most = self.approach.max(self.approach + change);
        if most > 0.0 { change.abs() / most.max(LEAST_APPROACH) } else { 0.0 }
    }
}

/// Solves (1 + Σ w n nᵀ) x = r.
#[inline(always)]
pub(super) fn solve(lines: [Line; 2], r: [f64; 2]) -> [f64; 2] {
    let [i, o] = lines;
    let (w_i, w_o) = (i.spring + i.damper, o.spring + o.damper);
    let entry = |j: usize, l: usize| w_i * i.normal[j] * i.normal[l] + w_o * o.normal[j] * o.normal[l];
    let (a, b, d) = (1.0 + entry(0, 0), entry(0, 1), 1.0 + entry(1, 1));
    let over = 1.0 / (a * d - b * b);
    [over * (d * r[0] - b * r[1]), over * (a * r[1] - b * r[0])]
}

/// Moves a ball whose velocities are the expected ones of the end of a piece, its angular momentum held; `before` has
/// those of the middle.
#[inline(always)]
fn shift((b, before): (&mut [f64; BALL], &mut [f64; 3]), [axial, radial]: [f64; 2], h: f64) {
    let r = b[RADIUS];
    b[AXIAL] += axial;
    b[RADIUS] += radial;
    b[VELOCITY] += 2.0 / h * axial;
    b[VELOCITY + 1] += 2.0 / h * radial;
    let ratio = r / b[RADIUS];
    let gained = before[2] * (ratio * ratio - 1.0);
    before[2] += gained;
    b[ORBIT] += gained;
    b[AZIMUTH] += 0.5 * h * gained;
}

/// Displacements of the rings at the start of a piece and at its end (x, y, z), m.
type Moved = Races<[[f64; 3]; 2]>;

/// To where springs as they were at the start would bring the balls of a block, with the grooves where they are at the
/// end. It follows from positions and accelerations there alone, so that a run that is taken up goes on as it would
/// have.
#[inline(always)]
fn predict(
    (balls, before): (&mut [Lane; BALL], &mut [Lane; 3]),
    pressed: &Pressed,
    (weights, h): (Weights, f64),
    (rings, out): (&Moved, &mut Explicit),
) {
    let rings = *rings;
    for k in pressed.in_use.lanes() {
        let (mut b, mut mean) = (get(balls, k), get(before, k));
        put(&mut out.positions, k, [b[AXIAL], b[RADIUS]]);
        put(&mut out.accelerations, k, pressed.acceleration_in_plane(k));
        let of_ball = (weights, pressed.relative_mass(k));
        let lines = [
            Line::of(&pressed.contact(Side::Inner, k), Side::Inner, of_ball),
            Line::of(&pressed.contact(Side::Outer, k), Side::Outer, of_ball),
        ];
        let (sin, cos) = sin_cos(b[AZIMUTH]);
        let axes = [pressed.axes(k), AzimuthFrame { sin, cos }];
        let way_i = from_groove(axes, rings.inner, [h * mean[0], h * mean[1]]);
        let way_o = from_groove(axes, rings.outer, [h * mean[0], h * mean[1]]);
        let [back_i, back_o] = [lines[0].spring * lines[0].along(way_i), lines[1].spring * lines[1].along(way_o)];
        let back = [0, 1].map(|i| -back_i * lines[0].normal[i] - back_o * lines[1].normal[i]);
        shift((&mut b, &mut mean), solve(lines, back), h);
        put(balls, k, b);
        put(before, k, mean);
    }
}

/// The way (axial, radial) of a ball as a groove sees it, whose centre moves with its ring and as the ball comes round.
#[inline(always)]
fn from_groove(axes: [AzimuthFrame; 2], ring: [[f64; 3]; 2], [axial, radial]: [f64; 2]) -> [f64; 2] {
    let ([a0, r0, _], [a1, r1, _]) = (axes[0].from_inertial(ring[0]), axes[1].from_inertial(ring[1]));
    [axial - (a1 - a0), radial - (r1 - r0)]
}

/// A step of Newton's method for the balls of a block, whose grooves move by so much, and what it changes of the
/// approaches.
#[inline(always)]
fn correction(
    balls: &[Lane; BALL],
    (pressed, start): (&Pressed, &Explicit),
    (weights, h): (Weights, f64),
    (rings, by, changes): (&Races<[f64; 3]>, &mut [Lane; 2], &mut Lane),
) {
    let rings = *rings;
    for k in pressed.in_use.lanes() {
        let (b, of_ball, axes) = (get(balls, k), (weights, pressed.relative_mass(k)), pressed.axes(k));
        let lines = [
            Line::pressing(&pressed.contact(Side::Inner, k), Side::Inner, of_ball),
            Line::pressing(&pressed.contact(Side::Outer, k), Side::Outer, of_ball),
        ];
        let (now, at_start, from) =
            (pressed.acceleration_in_plane(k), get(&start.accelerations, k), get(&start.positions, k));
        let ([a_i, r_i, _], [a_o, r_o, _]) = (axes.from_inertial(rings.inner), axes.from_inertial(rings.outer));
        let (with_i, with_o) =
            (lines[0].spring * lines[0].along([a_i, r_i]), lines[1].spring * lines[1].along([a_o, r_o]));
        let with = [0, 1].map(|i| with_i * lines[0].normal[i] + with_o * lines[1].normal[i]);
        let quarter = 0.25 * h * h;
        let residual = [
            quarter * (now[0] - at_start[0]) - (b[AXIAL] - from[0]) + with[0],
            quarter * (now[1] - at_start[1]) - (b[RADIUS] - from[1]) + with[1],
        ];
        let [axial, radial] = solve(lines, residual);
        let (way_i, way_o) = ([axial - a_i, radial - r_i], [axial - a_o, radial - r_o]);
        changes.0[k] = lines[0].change(way_i).max(lines[1].change(way_o));
        put(by, k, [axial, radial]);
    }
}

/// Moves the balls of a block.
#[inline(always)]
fn shift_all((balls, before): (&mut [Lane; BALL], &mut [Lane; 3]), by: &[Lane; 2], (in_use, h): (InUse, f64)) {
    for k in in_use.lanes() {
        let (mut b, mut mean) = (get(balls, k), get(before, k));
        shift((&mut b, &mut mean), get(by, k), h);
        put(balls, k, b);
        put(before, k, mean);
    }
}

impl Fast {
    /// Moves balls and rings from where the velocities in the middle of a piece have brought them to where the
    /// accelerations at both of its ends do, and finds those at its end.
    pub(super) fn settle_on_springs<E: Equations>(&mut self, equations: &E, (t, y): (f64, &mut [f64]), h: f64) {
        let machine = equations.machine();
        let (l, mass) = (machine.layout, machine.bearing.ball_mass);
        let weights =
            Weights { of_spring: 0.25 * h * h / mass, of_damper: h * machine.bearing.contact_damping / mass.sqrt() };
        let (moved, at_start) = (self.moved(l, y, h), l.velocities_of_rings().map(|velocity| self.drift[velocity]));
        let Scratch { level, balls, before, pressed, explicit, by, .. } = &mut self.scratch;
        explicit.resize(balls.len(), Explicit::NONE);
        by.resize(balls.len(), [Lane::ZERO; 2]);
        for (((balls, before), pressed), start) in balls.iter_mut().zip(before).zip(pressed).zip(explicit) {
            dispatch!(*level, _simd => predict((balls, before), pressed, (weights, h), (&moved, start)));
        }
        let (mut shifts, mut last) = ([0.0; 5], false);
        for round in 0..=MOST_CORRECTIONS {
            let Scratch { level, balls, before, pressed, explicit, by, .. } = &mut self.scratch;
            drift_acceleration(*level, equations, (t, y), balls, (&mut self.drift, pressed));
            if last || round == MOST_CORRECTIONS {
                break;
            }
            let changes = l.velocities_of_rings().map(|velocity| self.drift[velocity]);
            let more: [f64; 5] = std::array::from_fn(|i| OF_RINGS * h * h * (changes[i] - at_start[i]) - shifts[i]);
            let [x, y_, z, outer_x, outer_y] = more;
            let rings = Races { inner: [x, y_, z], outer: [outer_x, outer_y, 0.0] };
            let mut most = 0.0f64;
            for (((balls, pressed), start), by) in
                balls.iter().zip(pressed.iter()).zip(explicit.iter()).zip(by.iter_mut())
            {
                let mut changes = Lane::ZERO;
                let found = (&rings, by, &mut changes);
                dispatch!(*level, _simd => correction(balls, (pressed, start), (weights, h), found));
                most = changes.0.iter().fold(most, |most, &change| most.max(change));
            }
            if most <= LAST_CHANGE * LAST_CHANGE {
                break;
            }
            for (((balls, before), pressed), by) in balls.iter_mut().zip(before).zip(pressed).zip(by) {
                dispatch!(*level, _simd => shift_all((balls, before), by, (pressed.in_use, h)));
            }
            for ([place, velocity], (shift, more)) in l.translations().into_iter().zip(shifts.iter_mut().zip(more)) {
                *shift += more;
                y[place] += more;
                y[velocity] += 0.5 / (OF_RINGS * h) * more;
            }
            last = most <= LAST_CHANGE;
        }
    }

    /// How the rings moved in a piece of `h`, by their velocities in its middle.
    fn moved(&self, l: Layout, y: &[f64], h: f64) -> Moved {
        let moved = |[place, velocity]: [usize; 2]| [y[place] - h * self.before[velocity], y[place]];
        let [x, y_, z, outer_x, outer_y] = l.translations().map(moved);
        Races {
            inner: [0, 1].map(|end| [x[end], y_[end], z[end]]),
            outer: [0, 1].map(|end| [outer_x[end], outer_y[end], 0.0]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Phase by which x'' = −x is off after a time of 12 in so many pieces, rad.
    fn phase_error(pieces: usize) -> f64 {
        let h = 12.0 / pieces as f64;
        let (mut x, mut v, mut a) = (1.0, 0.0, -1.0);
        for _ in 0..pieces {
            v += 0.5 * h * a;
            x += h * v;
            // By OF_RINGS h² (a₁ − a₀), a₁ of where that leads.
            let share = OF_RINGS * h * h;
            x += share * (-x - a) / (1.0 + share);
            a = -x;
            v += 0.5 * h * a;
        }
        let ratio = (1.0 - (0.25 - OF_RINGS) * h * h).sqrt();
        (f64::atan2(-v / ratio, x) - 12.0).sin()
    }

    #[test]
    fn order_rings_vibrate_right_to_the_fourth_order() {
        for pieces in [24, 48, 96] {
            let ratio = phase_error(pieces) / phase_error(2 * pieces);
            assert!((ratio / 16.0 - 1.0).abs() < 0.02, "{pieces}: {ratio}");
        }
        assert!(phase_error(12).abs() < 0.03, "ω h = 1: {}", phase_error(12));
    }
}
