//! Traction of a contact as a linear function of motion and load, good for a while, with a bend along the way that
//! motion and load go.
//!
//! Balls go round, so that the traction of a contact moves along a smooth curve. How far the linear form was off at a
//! refresh is half its second derivative along the way, and the next form takes it along: its error then grows with the
//! third power of the distance, not the second, and a third as many patches are integrated.

use crate::machine::Machine;
use nalgebra::{Matrix5, Vector2, Vector5};
use serde::{Deserialize, Serialize};
use std::ops::Range;
use tribodyn_bearing::LoadedPatch;
use tribodyn_traction::{PatchDerivative, PatchTraction, RelativeMotion};

/// Slip, m/s, as which a relative change of the load counts: it moves the rolling lines in the patch by little.
pub(crate) const LOAD_AS_SLIP: f64 = 1.0;
/// The slip of the spin at the ends of the patch counts as so much of a slip everywhere.
const SPIN_AS_SLIP: f64 = 0.5;
/// First distance that a linear traction may be used over, m/s.
const FIRST_REACH: f64 = 3e-3;
/// Shortest distance, m/s: an estimate of zero error at a lucky point must not end linearisation for good.
const SHORTEST_REACH: f64 = 1e-6;
/// Change of the bare part of the surface beyond which the patch is integrated anew: steel has four times the traction
/// of silver, so that this is 1e-4 of the load.
const BARE_CHANGE: f64 = 3e-4;
/// Change of the rolling speed, over it, beyond which the patch is integrated anew: what a film's thickness bends the
/// traction over it is then 1e-4 of that.
const ROLLING_CHANGE: f64 = 2e-2;
/// A load that is none, N: where there is no linear form its load is zero, and the change of it has to be finite, as
/// what a form of zeros makes of it is masked by a factor.
const NO_LOAD: f64 = 1e-30;
/// Growth of the distance from one refresh to the next.
const GROWTH: f64 = 1.5;
/// Share of the distance at which the error found would be the one that is allowed.
const CAUTION: f64 = 0.8;
/// Shortest way that a bend is found from, over the reach: on a shorter one rounding and the patch rule bend more.
const SHORTEST_BEND: f64 = 0.3;

/// Both contacts of a ball.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Contacts {
    /// Inner, outer.
    pub of: [LinearTraction; 2],
    /// Last step, counted from the start of the run, that the linear form of each serves.
    pub last: [u64; 2],
}

/// Motion, load and rolling speed.
const INPUTS: usize = 7;

/// Numbers that a form takes over from those before it.
struct Next {
    reach: f64,
    reach_of_slip: f64,
    bend: [f64; 6],
    way: [f64; 6],
    reach_is_found: bool,
}

/// Value, slopes and bend at one point. Linear is the traction over the load, in the motion and in the load: traction
/// is nearly in proportion to the load, and so are its slopes by the motion.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct LinearTraction {
    /// Motion: rolling, lateral, spin, about lateral, about rolling; the load, N; and the rolling speed, m/s.
    inputs: [f64; INPUTS],
    /// Forces and moments that do work on the motion, and the wear integral.
    value: [f64; 6],
    /// Derivatives of them all over the load, times the load, by one input after the other: by the load's change over
    /// itself. Wear's are those by the load.
    slopes: [[f64; 6]; INPUTS],
    /// Addition of the square of the way to the value, and the way by the changes of motion and load: 1 for that from
    /// the point before.
    bend: [f64; 6],
    way: [f64; 6],
    /// Part of the coating that is gone.
    bare: f64,
    /// Lateral semi-axis, m.
    semi_lateral: f64,
    /// How far slip and load may move from here, m/s; 0 where there is no linear form.
    reach: f64,
    /// How far the slip alone may, m/s: no farther than it is known to do no harm. Where loads vibrate the reach is
    /// that of the load, which hardly bends the traction over it, and a ball that slides comes to rolling within it.
    reach_of_slip: f64,
    /// Where traction changed its sign since the form before: direction of the change of the slip, and slope of the
    /// traction over it, N s/m; else zeros.
    crossed: [f64; 3],
    /// False where the reach is a guess, or a bound on how fast reaches may shrink.
    reach_is_found: bool,
}

impl LinearTraction {
    /// All its numbers.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        self.numbers().into_iter().chain(self.crossed)
    }

    /// Numbers that a linear traction is evaluated with, and which of them is the lateral semi-axis.
    pub const NUMBERS: usize = 71;
    pub const SEMI_LATERAL: usize = 68;
    /// Those between the first and the last ones tell the traction, the others where it holds.
    pub const OF_TRACTION: Range<usize> = 7..67;

    /// These in order.
    pub fn numbers(&self) -> [f64; Self::NUMBERS] {
        let mut all = [0.0; Self::NUMBERS];
        all[..7].copy_from_slice(&self.inputs);
        all[7..13].copy_from_slice(&self.value);
        all[13..55].copy_from_slice(self.slopes.as_flattened());
        all[55..61].copy_from_slice(&self.bend);
        all[61..67].copy_from_slice(&self.way);
        all[67..].copy_from_slice(&[self.bare, self.semi_lateral, self.reach, self.reach_of_slip]);
        all
    }

    /// From its numbers in that order.
    #[inline(always)]
    pub fn from_numbers(n: impl Fn(usize) -> f64) -> Self {
        let six = |at: usize| [n(at), n(at + 1), n(at + 2), n(at + 3), n(at + 4), n(at + 5)];
        Self {
            inputs: [n(0), n(1), n(2), n(3), n(4), n(5), n(6)],
            value: six(7),
            slopes: [six(13), six(19), six(25), six(31), six(37), six(43), six(49)],
            bend: six(55),
            way: six(61),
            bare: n(67),
            semi_lateral: n(68),
            reach: n(69),
            reach_of_slip: n(70),
            crossed: [0.0; 3],
            reach_is_found: false,
        }
    }

    /// The change of motion, of the load over itself and of the rolling speed, and whether it and the bare part of the
    /// surface are near enough: within `share` of the reach.
    #[inline(always)]
    pub fn reaches(
        &self,
        (motion, rolling_speed): (&RelativeMotion, f64),
        load: f64,
        (bare, share): (f64, f64),
        ball_radius: f64,
    ) -> ([f64; INPUTS], bool) {
        let change = self.change(motion, (load, rolling_speed));
        let [reach, of_slip] = [share * self.reach, share * self.reach_of_slip];
        let [all, slip] = self.distances(&change, ball_radius);
        let near = (self.reach > 0.0)
            & ((bare - self.bare).abs() <= BARE_CHANGE)
            & (change[6].abs() <= ROLLING_CHANGE * rolling_speed.abs())
            & (all <= reach * reach)
            & (slip <= of_slip * of_slip);
        (change, near)
    }

    /// Squares of how far slip and load have moved, and the slip alone, m²/s².
    #[inline(always)]
    fn distances(&self, d: &[f64; INPUTS], r: f64) -> [f64; 2] {
        let [along, across] = centre_slip(d, r);
        let spin = SPIN_AS_SLIP * (d[2] * self.semi_lateral);
        let load = LOAD_AS_SLIP * d[5];
        let slip = along * along + across * across + spin * spin;
        [slip + load * load, slip]
    }

    #[inline(always)]
    fn change(&self, motion: &RelativeMotion, (load, rolling_speed): (f64, f64)) -> [f64; INPUTS] {
        let now = inputs(motion, (load, rolling_speed));
        let from = &self.inputs;
        [
            now[0] - from[0],
            now[1] - from[1],
            now[2] - from[2],
            now[3] - from[3],
            now[4] - from[4],
            now[5] / from[5].max(NO_LOAD) - 1.0,
            now[6] - from[6],
        ]
    }

    /// The linear form. Its power is what forces and moments take from the motion.
    #[inline(always)]
    #[allow(clippy::needless_range_loop)] // iterators would still be loops when one over many balls is vectorised
    pub fn traction(&self, motion: &RelativeMotion, change: &[f64; INPUTS]) -> PatchTraction {
        let mut f = self.value;
        for input in 0..INPUTS {
            for output in 0..6 {
                f[output] += self.slopes[input][output] * change[input];
            }
        }
        let mut way = 0.0;
        for input in 0..6 {
            way += self.way[input] * change[input];
        }
        let (square, grown) = (way * way, 1.0 + change[5]);
        for output in 0..6 {
            f[output] = (f[output] + square * self.bend[output]) * grown;
        }
        let mut traction = PatchTraction {
            force_rolling: f[0],
            force_lateral: f[1],
            moment_normal: f[2],
            moment_lateral: f[3],
            moment_rolling: f[4],
            power: 0.0,
            wear_integral: f[5],
        };
        traction.power = -traction.work_on(motion);
        traction
    }

    /// Lateral semi-axis where it was linearised, m.
    pub fn semi_lateral(&self) -> f64 {
        self.semi_lateral
    }

    /// Square of the share of its reach that a contact is at, or infinity where the form is not near enough to serve
    /// it: beyond `share` of the reach, or on a surface that is worn otherwise.
    #[inline(always)]
    pub fn distance_to(&self, p: &LoadedPatch<'_, f64>, share: f64) -> f64 {
        let r = p.patch.ball_radius;
        let (change, near) = self.reaches((&p.motion, p.rolling_speed), p.load, (p.bare, share), r);
        let [all, _] = self.distances(&change, r);
        if near { all / (self.reach * self.reach) } else { f64::INFINITY }
    }

    /// Gives way to a form from elsewhere that is near enough, and has its traction.
    pub fn give_way(&mut self, to: Self, p: &LoadedPatch<'_, f64>) -> PatchTraction {
        let traction = to.traction(&p.motion, &to.change(&p.motion, (p.load, p.rolling_speed)));
        let now = inputs(&p.motion, (p.load, p.rolling_speed));
        *self = Self { crossed: self.crossed_to(&outputs(&traction), &now, p.patch.ball_radius), ..to };
        traction
    }

    /// How far the form is off at a contact whose traction is `exact`, over the load, and from where it was made, m/s.
    pub fn error_at(&self, p: &LoadedPatch<'_, f64>, exact: &PatchTraction) -> [f64; 2] {
        let change = self.change(&p.motion, (p.load, p.rolling_speed));
        let found = self.traction(&p.motion, &change);
        let [along, across] = [found.force_rolling - exact.force_rolling, found.force_lateral - exact.force_lateral];
        let [square, _] = self.distances(&change, p.patch.ball_radius);
        [along.hypot(across) / p.load, square.sqrt()]
    }

    /// No reach beyond the distance at which the error would be the one that is allowed, by one found at a distance.
    pub fn narrow(&mut self, [off, distance]: [f64; 2], tolerance: f64) {
        let farthest = (CAUTION * distance * (tolerance / off).cbrt()).max(SHORTEST_REACH);
        (self.reach, self.reach_of_slip) = (self.reach.min(farthest), self.reach_of_slip.min(farthest));
    }

    /// True where the form has a bend and that before it erred no more than allowed, so that others may rely on its
    /// reach: beyond a reach that is guessed a form serves once, and its error is found as it is refreshed.
    pub fn reach_is_found(&self) -> bool {
        self.reach_is_found
    }

    /// The integral over the patch, from which the linear form starts anew; the distance that it may serve over follows
    /// from the error found now, which grows with its square.
    pub fn refresh(&mut self, machine: &Machine, p: &LoadedPatch<'_, f64>, tolerance: f64) -> PatchTraction {
        let Some(d) = machine.kernel.derivative(p) else {
            self.reach = 0.0;
            return machine.kernel.traction(&machine.bearing, p);
        };
        let load = p.load;
        let Next { reach, reach_of_slip, bend, way, reach_is_found } = self.next_way(p, &d, (load, tolerance));
        let PatchDerivative { traction, by_motion, by_load, by_rolling_speed } = d;
        let (value, by_load) = (outputs(&traction), outputs(&by_load));
        let inputs = inputs(&p.motion, (load, p.rolling_speed));
        let crossed = self.crossed_to(&value, &inputs, p.patch.ball_radius);
        *self = Self {
            inputs,
            value,
            slopes: std::array::from_fn(|input| match input {
                5 => std::array::from_fn(|i| load * by_load[i] - value[i]),
                6 => outputs(&by_rolling_speed),
                _ => std::array::from_fn(|i| by_motion.get(i).map_or(0.0, |row| row[input])),
            }),
            bend,
            way,
            bare: p.bare,
            semi_lateral: p.patch.semi_lateral,
            reach,
            reach_of_slip,
            crossed,
            reach_is_found,
        };
        traction
    }

    /// How the form that follows crossed to the other side of free rolling, with its forces and inputs.
    fn crossed_to(&self, value: &[f64; 6], inputs: &[f64; INPUTS], r: f64) -> [f64; 3] {
        let [now, before] = [inputs, &self.inputs].map(|inputs| centre_slip(inputs, r));
        let (along, across) = (now[0] - before[0], now[1] - before[1]);
        let way = along.hypot(across);
        if self.reach <= 0.0 || way <= 0.0 {
            return [0.0; 3];
        }
        let (along, across) = (along / way, across / way);
        let force = |f: &[f64; 6]| along * f[0] + across * f[1];
        // At the same load.
        let (before, now) = (force(&self.value) * inputs[5] / self.inputs[5].max(NO_LOAD), force(value));
        if before > 0.0 && now < 0.0 { [along, across, (now - before) / way] } else { [0.0; 3] }
    }

    /// Reaches, bend and way of the form that follows.
    fn next_way(&self, p: &LoadedPatch<'_, f64>, d: &PatchDerivative, (load, tolerance): (f64, f64)) -> Next {
        let nothing = [0.0; 6];
        let straight =
            |reach, reach_of_slip| Next { reach, reach_of_slip, bend: nothing, way: nothing, reach_is_found: false };
        if self.reach <= 0.0 {
            return straight(FIRST_REACH, FIRST_REACH);
        }
        let (change, r) = (self.change(&p.motion, (load, p.rolling_speed)), p.patch.ball_radius);
        let [off, _] = self.error_at(p, &d.traction);
        let [square, of_slip] = self.distances(&change, r);
        // The error grows with the square of the distance, and with its third power where there was a bend.
        let ratio = tolerance / off.max(1e-14);
        let farther = CAUTION * if self.way == nothing { ratio.sqrt() } else { ratio.cbrt() };
        // A reach grows as far as it was tried.
        let next = |square: f64, before: f64| {
            let tried = square.sqrt();
            (farther * tried).clamp(before / (2.0 * GROWTH), before.max(GROWTH * tried)).max(SHORTEST_REACH)
        };
        let (reach, reach_of_slip) = (next(square, self.reach), next(of_slip, self.reach_of_slip));
        if square.sqrt() < SHORTEST_BEND * self.reach {
            return straight(reach, reach_of_slip);
        }
        let linear = outputs(&Self { bend: nothing, ..*self }.traction(&p.motion, &change));
        let exact = outputs(&d.traction);
        let way = self.metric(&change, r).map(|part| part / square);
        let bend = std::array::from_fn(|i| exact[i] - linear[i]);
        Next { reach, reach_of_slip, bend, way, reach_is_found: off <= tolerance }
    }

    /// Half the slopes of [`Self::distances`] at a change: the metric times it.
    fn metric(&self, d: &[f64; INPUTS], r: f64) -> [f64; 6] {
        let [along, across] = centre_slip(d, r);
        let spin = SPIN_AS_SLIP * self.semi_lateral;
        [along, across, spin * spin * d[2], r * along, -r * across, LOAD_AS_SLIP * LOAD_AS_SLIP * d[5]]
    }

    /// Derivative of forces and moments by the motion, a column for each input, for a kick in which a force changes the
    /// slip by `give` times itself, m/(s N). A ball that slides so that traction hardly grows with slip any more would
    /// be pushed beyond rolling, and as far back in the next step: where the way to no slip is shorter than the kick,
    /// the chord to there takes the place of the tangent along the slip. Where it rolls freely with slip in the middle,
    /// the next step knows the way that it was pushed, and takes the chord over that.
    ///
    /// Within its reach the tangent leads there by itself. Where balls `strike`, loads change so much from step to step
    /// that a reach tells of them alone, and that of slip counts.
    pub fn stiffness(&self, give: f64, ball_radius: f64, strike: bool) -> Matrix5<f64> {
        if self.reach <= 0.0 {
            return Matrix5::zeros();
        }
        let mut stiffness = Matrix5::from_fn(|row, column| self.slopes[column][row]);
        let [along, across] = centre_slip(&self.inputs, ball_radius);
        let (slip, force) = (along.hypot(across), self.value[0].hypot(self.value[1]));
        let reach = if strike { self.reach_of_slip } else { self.reach };
        if slip > reach && give * force > slip {
            let (along, across) = (along / slip, across / slip);
            let chord = (along * self.value[0] + across * self.value[1]) / slip;
            stiffness = no_less([along, across], chord, ball_radius, stiffness);
        }
        let [along, across, slope] = self.crossed;
        no_less([along, across], slope, ball_radius, stiffness)
    }
}

/// A stiffness with at least a slope of the force along a slip.
fn no_less([along, across]: [f64; 2], least: f64, r: f64, stiffness: Matrix5<f64>) -> Matrix5<f64> {
    let slope = stiffness.fixed_view::<2, 2>(0, 0) * Vector2::new(along, across);
    let lacking = least - (along * slope[0] + across * slope[1]);
    let by_motion = Vector5::new(along, across, 0.0, r * along, -r * across);
    stiffness + by_motion * by_motion.transpose() * lacking.min(0.0)
}

/// Sliding velocity in the middle of the patch, along and across.
#[inline(always)]
fn centre_slip(inputs: &[f64; INPUTS], ball_radius: f64) -> [f64; 2] {
    let [rolling, lateral, spin, about_lateral, about_rolling, ..] = *inputs;
    RelativeMotion { rolling, lateral, spin, about_lateral, about_rolling }.centre_slip(ball_radius)
}

#[inline(always)]
fn inputs(m: &RelativeMotion, (load, rolling_speed): (f64, f64)) -> [f64; INPUTS] {
    [m.rolling, m.lateral, m.spin, m.about_lateral, m.about_rolling, load, rolling_speed]
}

fn outputs(t: &PatchTraction) -> [f64; 6] {
    [t.force_rolling, t.force_lateral, t.moment_normal, t.moment_lateral, t.moment_rolling, t.wear_integral]
}
