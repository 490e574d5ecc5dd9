//! How long the drift's pieces may be: what vibrates fastest on the contact springs, and how it is damped.

use super::Fast;
use super::lanes::filled;
use crate::machine::{Machine, Support};
use crate::stiffness::or_infinite;
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};
use std::f64::consts::SQRT_2;
use tribodyn_bearing::{Races, Side};

/// Square of the longest piece times the angular frequency, if it is the only one of its step: 4 with a margin for what
/// loads do until the next look. In one piece springs and friction act at the same places, as in leapfrog itself, so
/// that there is no splitting for what vibrates.
const LIMIT: f64 = 3.9;
/// The same for several pieces in a step: nearer to the limit what vibrates swings too far for its velocity.
const LIMIT_OF_SEVERAL: f64 = 2.0;
/// Longest piece times the angular frequency of rings on implicit balls, alone in its step and one of several: what
/// vibrates so is 0.2 % too slow in the longer ones. Alone, those leave accelerations of the rings off by several times
/// as much, sample by sample, as two of half their length.
const ANGLE_OF_RINGS: [f64; 2] = [0.3, 1.0];
/// The same for rings that tilt, whose tilts are explicit: what vibrates so is 0.4 % too fast.
const ANGLE_OF_TILTS: f64 = 0.3;
/// Pieces with explicit balls that cost as much as one with implicit ones.
const DEARER: usize = 3;
/// Most pieces of a drift: where more were needed the step is too long by far, and the run says so.
const MOST_PIECES: f64 = 64.0;

/// Longest pieces of a drift that are stable.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Longest {
    /// That is the only one of its step, s.
    #[serde(deserialize_with = "or_infinite")]
    alone: f64,
    /// Where there are several, s.
    #[serde(deserialize_with = "or_infinite")]
    of_several: f64,
    /// With implicit balls, alone, s.
    #[serde(deserialize_with = "or_infinite")]
    of_rings_alone: f64,
    /// With implicit balls, where there are several, s.
    #[serde(deserialize_with = "or_infinite")]
    of_rings: f64,
}

/// How a step goes about its drift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pieces {
    pub count: usize,
    /// True if balls are implicit in their springs.
    pub implicit: bool,
}

impl Longest {
    /// Where nothing vibrates.
    pub const ANY: Self = {
        let any = f64::INFINITY;
        Self { alone: any, of_several: any, of_rings_alone: any, of_rings: any }
    };

    /// With a vibration of angular frequency ω (given by its square, 1/s²) and damping, 1/s; and that of rings with the
    /// balls held, which may tilt.
    fn of(all: [f64; 2], rings: [f64; 2], tilt: bool) -> Self {
        let with = |limit, [omega_squared, damping]: [f64; 2]| longest(limit, omega_squared, damping);
        let [alone, of_several] = [LIMIT, LIMIT_OF_SEVERAL].map(|limit| with(limit, all));
        let angles = if tilt { [ANGLE_OF_TILTS; 2] } else { ANGLE_OF_RINGS };
        let [of_rings_alone, of_rings] = angles.map(|angle| with(LIMIT_OF_SEVERAL, rings).min(angle / rings[0].sqrt()));
        Self { alone, of_several, of_rings_alone, of_rings }
    }

    /// Pieces of a step.
    pub fn pieces(&self, step: f64) -> Pieces {
        let of = |longest: f64, least| (step / longest).ceil().clamp(least, MOST_PIECES) as usize;
        let explicit = if step <= self.alone { 1 } else { of(self.of_several, 2.0) };
        let implicit = if step <= self.of_rings_alone { 1 } else { of(self.of_rings, 2.0) };
        if explicit > DEARER * implicit {
            Pieces { count: implicit, implicit: true }
        } else {
            Pieces { count: explicit, implicit: false }
        }
    }
}

/// Longest piece with a vibration of angular frequency ω (given by its square) and damping d, both 1/s: (ω h)² + 4 d h
/// = `limit`. So leapfrog ends, with dampers that see the velocity as it is expected: an iteration that changes its
/// sign each time.
fn longest(limit: f64, omega_squared: f64, damping: f64) -> f64 {
    limit / (2.0 * damping + (4.0 * damping * damping + limit * omega_squared).sqrt())
}

impl Fast {
    /// Longest pieces of the drift at the positions at which it was found last.
    pub(super) fn longest_pieces(&self, machine: &Machine) -> Longest {
        let (mut both, mut single) = (0.0f64, Races::<f64>::default());
        // Of springs and dampers.
        let mut on_rings = Races::from_fn(|_| [Matrix3::<f64>::zeros(); 2]);
        let (mut against_tilt, mass) = (Races::<[f64; 2]>::default(), machine.bearing.ball_mass);
        let of_damper = 2.0 * machine.bearing.contact_damping * mass.sqrt();
        for (block, pressed) in self.scratch.pressed.iter().enumerate() {
            for k in 0..filled(machine.layout, block) {
                let mut sum = 0.0;
                for side in Side::BOTH {
                    let contact = pressed.contact(side, k);
                    if contact.load <= 0.0 {
                        continue;
                    }
                    let stiffness = 1.5 * contact.load / contact.pose.approach;
                    let [axial, radial] = contact.pose.normal(side);
                    let normal = pressed.axes(k).to_inertial([axial, radial, 0.0]);
                    sum += stiffness;
                    single[side] = single[side].max(stiffness);
                    let (lever, line) = (axial * pressed.orbit_radius(k), Vector3::from(normal));
                    for (i, of) in [stiffness, of_damper * stiffness.sqrt()].into_iter().enumerate() {
                        against_tilt[side][i] += of * lever * lever;
                        on_rings[side][i] += line * line.transpose() * of;
                    }
                }
                both = both.max(sum);
            }
        }
        let (inner, outer) = (&machine.inner, &machine.outer);
        let mut rings = Races { inner: of_ring(inner, &on_rings.inner), outer: of_ring(outer, &on_rings.outer) };
        for (side, tilting) in machine.tilting.iter() {
            let Some(body) = tilting.as_ref().map(|tilting| &tilting.body) else { continue };
            let most = |[x, y]: [f64; 2]| x.max(y);
            let [springs, dampers] = against_tilt[side];
            for (i, of) in [springs + most(body.stiffness), dampers, most(body.damping)].into_iter().enumerate() {
                rings[side][i] += of / body.transverse_inertia;
            }
        }
        let of_balls = both / mass;
        // Dampers of both contacts with equal stiffness have the most to say, √2 of that of one with all of it.
        let damping = 2.0 * SQRT_2 * machine.bearing.contact_damping * of_balls.sqrt();
        let highest = highest(of_balls, single.map(|k| k / mass), rings.map(|[square, ..]| square));
        let [square, of_contacts, of_supports] = [0, 1, 2].map(|i| rings.inner[i].max(rings.outer[i]));
        let tilt = machine.layout.any_tilts();
        let longest = Longest::of([highest, damping + of_supports], [square, of_contacts + of_supports], tilt);
        // Explicit pieces err less where balls strike, and short ones: a blow excites the balls' own vibration.
        if machine.is_damaged() {
            Longest { alone: longest.of_several, of_rings_alone: 0.0, of_rings: 0.0, ..longest }
        } else {
            longest
        }
    }
}

/// A bound from above on the squares of all angular frequencies, from those of balls with the rings held, by both
/// contacts (k_i + k_o)/m and by one, and those of the rings with the balls held.
///
/// In the energy of a spring between ball and ring, k (u − v)² ≤ k ((1 + t) u² + (1 + 1/t) v²) for any t > 0. With the
/// t for which the rings come to the same bound λ, t = b/(λ − b), it is λ = a + Σ a_s b_s/(λ − b_s).
fn highest(both: f64, single: Races<f64>, rings: Races<f64>) -> f64 {
    let most = both + rings.inner.max(rings.outer);
    let share = |bound: f64, side: Side| {
        let (of_ball, of_ring) = (single[side], rings[side]);
        if of_ball > 0.0 { of_ball * of_ring / (bound - of_ring) } else { 0.0 }
    };
    // The right side falls with λ, so that of two values in a row one lies above.
    let next = |bound: f64| both + share(bound, Side::Inner) + share(bound, Side::Outer);
    let first = next(most).max(rings.inner).max(rings.outer);
    most.min(first.max(next(first)))
}

/// Square of a bound on the frequency of a ring on the balls' springs and its supports with the balls held, 1/s², and
/// the damping of the contacts and of its supports, 1/s.
fn of_ring<const N: usize>(ring: &Support<N>, [springs, dampers]: &[Matrix3<f64>; 2]) -> [f64; 3] {
    let of_supports = |i: usize| ring.damping[i];
    [
        most_of(ring, |i| row(springs, i) + ring.stiffness[i]),
        most_of(ring, |i| row(dampers, i)),
        most_of(ring, of_supports),
    ]
}

/// The largest of a ring that is free to move, over its mass.
fn most_of<const N: usize>(ring: &Support<N>, of: impl Fn(usize) -> f64) -> f64 {
    (0..N).filter(|&i| ring.free[i]).map(of).fold(0.0, f64::max) / ring.mass
}

/// Sum of a row: no eigenvalue is larger than the largest.
fn row(matrix: &Matrix3<f64>, i: usize) -> f64 {
    matrix.row(i).iter().map(|v| v.abs()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fast::common::share;

    /// Leapfrog for q'' = −ω² q − d q', the damper with the velocity expected at the end of the piece, h = 1: true if
    /// it stays where it began.
    fn stays(omega: f64, damping: f64) -> bool {
        let (mut q, mut v, mut a) = (1.0, 0.3, -omega * omega);
        for _ in 0..4000 {
            let half = v + 0.5 * a;
            q += half;
            a = -omega * omega * q - damping * (2.0 * half - v);
            v = half + 0.5 * a;
        }
        f64::abs(q) + f64::abs(v) < 100.0
    }

    /// Two equal balls on either side of a ring between springs, one behind the other: the exact frequencies.
    #[test]
    fn limit_the_bound_lies_just_above_the_exact_frequency() {
        for mass in [0.1, 0.5, 2.0, 10.0] {
            // A ball of mass 1 between a ring held, by a spring of 0.6, and a free ring, by one of 0.4.
            let exact = {
                let (ball, ring, coupling) = (1.0, 0.4 / mass, 0.4 * 0.4 / mass);
                let (sum, difference): (f64, f64) = (0.5 * (ball + ring), 0.5 * (ball - ring));
                sum + (difference * difference + coupling).sqrt()
            };
            let bound = highest(1.0, Races { inner: 0.6, outer: 0.4 }, Races { inner: 0.0, outer: 0.4 / mass });
            assert!(bound >= exact * (1.0 - 1e-12) && bound < 1.13 * exact, "{mass}: {bound} {exact}");
        }
        assert_eq!(highest(0.0, Races::default(), Races::default()), 0.0);
    }

    /// Of a 6206 with balls of 60 kHz and rings of 3 kHz, of one with light rings, and of the paper's bearing.
    #[test]
    fn limit_balls_are_implicit_where_that_takes_fewer_evaluations() {
        let hertz = |f: f64| (std::f64::consts::TAU * f).powi(2);
        let of = |ball, ring, ratio: f64, step| {
            let all = [hertz(ball), 2.0 * ratio * hertz(ball).sqrt()];
            Longest::of(all, [hertz(ring), 0.0], false).pieces(step)
        };
        assert_eq!(of(60e3, 3e3, 0.25, 20e-6), Pieces { count: 2, implicit: true });
        assert_eq!(of(60e3, 40e3, 0.0, 20e-6), Pieces { count: 6, implicit: false });
        assert_eq!(of(14e3, 2e3, 0.0, 20e-6), Pieces { count: 1, implicit: false });
    }

    #[test]
    fn limit_the_longest_piece_is_near_the_end_of_stability() {
        for ratio in [0.0, 0.01, 0.1, 0.5, 2.0] {
            let h = longest(LIMIT, 1.0, 2.0 * ratio);
            assert!(stays(h, 2.0 * ratio * h), "{ratio}: {h}");
            assert!(!stays(1.06 * h, 2.0 * ratio * 1.06 * h), "{ratio}: {h}");
        }
        assert!((longest(LIMIT, 0.0, 2.0) - 0.4875).abs() < 1e-15 && longest(LIMIT, 0.0, 0.0) == f64::INFINITY);
    }

    /// A damped spring of ω = 1 in steps of so many pieces, with kicks that give back the common acceleration, at most
    /// `most` of the way nearer to the mean of the drift from one step to the next: its largest value over the last
    /// steps, over that at the start.
    fn swing(damping: f64, (step, pieces): (f64, Pieces), most: f64) -> f64 {
        let (count, share) = (pieces.count as f64, share(step).min(most));
        let h = step / count;
        let (mut q, mut v, mut a, mut common, mut half) = (1.0, 0.0, -1.0, -1.0, 0.0);
        let mut most = 0.0f64;
        for made in 0..4000 {
            v += half;
            let (share_of_half, mut mean) = (0.5 / count, 0.0);
            for piece in 0..pieces.count {
                let start = v;
                v += 0.5 * h * (a - common);
                mean += share_of_half * a;
                q += h * v;
                let over = (piece + 1) as f64 / count;
                let expected = 2.0 * v - start + half * (2.0 * over - 1.0);
                let by = if pieces.implicit {
                    let quarter = 0.25 * h * h;
                    quarter * (-q - damping * expected - a) / (1.0 + quarter + 0.5 * h * damping)
                } else {
                    0.0
                };
                q += by;
                a = -q - damping * (expected + 2.0 / h * by);
                v += 0.5 * h * (a - common);
                mean += share_of_half * a;
            }
            let next = common + share * (mean - common);
            half = 0.25 * step * (common + next);
            common = next;
            v += half;
            most = if made < 3900 { 0.0 } else { most.max(f64::abs(q)) };
        }
        most
    }

    /// Whatever the damping, what vibrates dies out or stays in steps up to 0.45 of its period, and if it is damped at
    /// all, up to twice its period. With dampers that felt the half kicks, a spring with half of the critical damping
    /// grew without bound, and by a common acceleration that followed that at the end of a step any did between half a
    /// period and one.
    #[test]
    fn limit_neither_dampers_nor_kicks_drive_what_vibrates() {
        for ratio in [0.0, 0.005, 0.03, 0.15, 0.3, 0.5, 0.7, 1.0] {
            let damped = ratio > 0.0;
            for step in (6..=if damped { 252 } else { 56 }).map(|k| 0.05 * f64::from(k)) {
                for (share, tilt) in [0.006, 0.03, 0.08, 1.0].into_iter().flat_map(|s| [(s, false), (s, true)]) {
                    let pieces = Longest::of([1.0, 2.0 * ratio], [1.0, 2.0 * ratio], tilt).pieces(step);
                    let most = swing(2.0 * ratio, (step, pieces), share);
                    assert!(most < 20.0, "damping {ratio}, step {step}, {share}, {tilt}: {most:e}");
                }
            }
        }
    }

    /// Implicit vibrations die out in steps up to two of their periods, whatever damps them.
    #[test]
    fn limit_kicks_do_not_drive_what_is_implicit() {
        let one = Pieces { count: 1, implicit: true };
        for ratio in [0.01, 0.03, 0.15, 0.3, 0.5, 0.7, 1.0] {
            for step in (20..=252).map(|k| 0.05 * f64::from(k)) {
                for share in [0.006, 0.03, 0.08, 1.0] {
                    let most = swing(2.0 * ratio, (step, one), share);
                    assert!(most < 1e-3, "damping {ratio}, step {step}, {share}: {most:e}");
                }
            }
        }
    }
}
