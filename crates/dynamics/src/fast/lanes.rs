//! Balls side by side: sixteen of them in a block, every number of theirs in a row of sixteen.
//!
//! The equations are written for one ball and called in a loop over the lanes of a block, which the compiler turns into
//! vector instructions of whatever width the processor has: loops without calls and without branches that it could not
//! turn into selections. A lane does the operations of the equations in their order, none of them fused, so the bits
//! are those of one ball alone, at every width.

use crate::layout::{BALL, Layout};
use std::ops::Range;

/// Balls in a block. Most bearings have one block, and only its vectors with balls in them are worked on ([`InUse`]).
pub(super) const WIDTH: usize = 16;

/// Lanes of the vectors that a block is made up of, by all processors of today once or more.
const VECTOR: usize = 4;

/// Vectors of a block that are worked on: those with balls in them.
///
/// Loops over their lanes become vector instructions however short they are, as the compiler does not know how short.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct InUse {
    vectors: usize,
}

impl InUse {
    pub const NONE: Self = Self { vectors: 0 };

    pub fn of(l: Layout, block: usize) -> Self {
        Self { vectors: filled(l, block).div_ceil(VECTOR) }
    }

    /// The lanes of the vectors.
    #[inline(always)]
    pub fn lanes(self) -> Range<usize> {
        0..VECTOR * self.vectors.min(WIDTH / VECTOR)
    }
}

/// One number of the balls of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub(super) struct Lane(pub [f64; WIDTH]);

impl Lane {
    pub const ZERO: Self = Self([0.0; WIDTH]);

    pub const fn all(value: f64) -> Self {
        Self([value; WIDTH])
    }
}

/// The numbers of one lane.
#[inline(always)]
#[allow(clippy::needless_range_loop)] // iterators would still be loops when the one over the lanes is vectorised
pub(super) fn get<const N: usize>(lanes: &[Lane; N], k: usize) -> [f64; N] {
    let mut values = [0.0; N];
    for i in 0..N {
        values[i] = lanes[i].0[k];
    }
    values
}

/// Sets the numbers of one lane.
#[inline(always)]
#[allow(clippy::needless_range_loop)] // as above
pub(super) fn put<const N: usize>(lanes: &mut [Lane; N], k: usize, values: [f64; N]) {
    for i in 0..N {
        lanes[i].0[k] = values[i];
    }
}

/// Blocks that so many balls fill.
pub(super) fn blocks(balls: usize) -> usize {
    balls.div_ceil(WIDTH)
}

/// Number of balls in a block; its other lanes repeat the last ball.
pub(super) fn filled(l: Layout, block: usize) -> usize {
    (l.balls - WIDTH * block).min(WIDTH)
}

/// Ball of a lane of a block: lanes that are left over go with the last one.
pub(super) fn ball_in(l: Layout, block: usize, k: usize) -> usize {
    (block * WIDTH + k).min(l.balls - 1)
}

/// Lanes of a ball of a block: its own, and those that repeat it if it is the last.
pub(super) fn lanes_of(l: Layout, block: usize, k: usize) -> Range<usize> {
    k..if k + 1 == filled(l, block) { WIDTH } else { k + 1 }
}

/// The unknowns of the balls of a block.
pub(super) fn gather(l: Layout, y: &[f64], block: usize) -> [Lane; BALL] {
    gather_from(l, (y, 0), block)
}

/// So many numbers of every ball of a block from the one with a number on, in a list that is laid out as the unknowns.
pub(super) fn gather_from<const N: usize>(l: Layout, (list, from): (&[f64], usize), block: usize) -> [Lane; N] {
    let mut lanes = [Lane::ZERO; N];
    for k in 0..WIDTH {
        let at = l.ball((WIDTH * block + k).min(l.balls - 1)) + from;
        put(&mut lanes, k, std::array::from_fn(|i| list[at + i]));
    }
    lanes
}

/// Writes the unknowns back.
pub(super) fn scatter(l: Layout, lanes: &[Lane; BALL], block: usize, y: &mut [f64]) {
    scatter_from(l, lanes, block, (y, 0));
}

/// True where the balls of a block have the unknowns of a list.
pub(super) fn are_those(l: Layout, balls: &[Lane; BALL], block: usize, y: &[f64]) -> bool {
    let listed = gather(l, y, block);
    (0..filled(l, block)).all(|k| get(balls, k) == get(&listed, k))
}

/// The other way of [`gather_from`].
pub(super) fn scatter_from<const N: usize>(
    l: Layout,
    lanes: &[Lane; N],
    block: usize,
    (list, from): (&mut [f64], usize),
) {
    for k in 0..filled(l, block) {
        list[l.ball(WIDTH * block + k) + from..][..N].copy_from_slice(&get(lanes, k));
    }
}

/// 1.5 · 2^52: added to a number below 2^51 in magnitude it leaves the nearest integer in the low bits.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;
/// π/2 in three parts, the first two of 33 bits each, so that their products with whole numbers below 2^20 are exact.
const QUARTER: [f64; 3] =
    [f64::from_bits(0x3ff9_21fb_5440_0000), f64::from_bits(0x3dd0_b461_1a60_0000), 2.022_266_248_795_950_6e-21];
/// Of (sin r − r)/r³ and (cos r − 1 + r²/2)/r⁴ in r², |r| ≤ π/4: Taylor's, the next term is below 2e-17 of the sum.
const SIN: [f64; 8] = [
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
    1.0 / 355_687_428_096_000.0,
];
const COS: [f64; 8] = [
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
    -1.0 / 6_402_373_705_728_000.0,
];

/// Σ c_k z^k.
#[inline(always)]
fn series(c: &[f64; 8], z: f64) -> f64 {
    let z2 = z * z;
    let z4 = z2 * z2;
    let low = (c[0] + c[1] * z) + (c[2] + c[3] * z) * z2;
    let high = (c[4] + c[5] * z) + (c[6] + c[7] * z) * z2;
    low + high * z4
}

/// Sine and cosine without a branch or a call, to 2e-16 for angles up to a million turns.
#[inline(always)]
pub(super) fn sin_cos(angle: f64) -> (f64, f64) {
    let shifted = angle * std::f64::consts::FRAC_2_PI + TO_INTEGER;
    let turns = shifted - TO_INTEGER;
    let r = ((angle - turns * QUARTER[0]) - turns * QUARTER[1]) - turns * QUARTER[2];
    let z = r * r;
    let sin = r + r * z * series(&SIN, z);
    let cos = (1.0 - 0.5 * z) + z * z * series(&COS, z);
    let quadrant = shifted.to_bits();
    let odd = quadrant & 1 != 0;
    let (s, c) = if odd { (cos, sin) } else { (sin, cos) };
    // The second bit turns both round; for odd quarters the cosine has the other sign.
    let sign = (quadrant & 2) << 62;
    let sign_of_cos = ((quadrant + 1) & 2) << 62;
    (f64::from_bits(s.to_bits() ^ sign), f64::from_bits(c.to_bits() ^ sign_of_cos))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_sine_and_cosine_are_those_of_the_library() {
        let angles =
            (0..200_000).map(|k| (k as f64 - 1e5) * 0.013_37).chain((0..1000).map(|k| 37.0 * f64::from(k) + 1e5));
        for angle in angles {
            let (ours, (sin, cos)) = (sin_cos(angle), angle.sin_cos());
            assert!((ours.0 - sin).abs() < 4e-16 && (ours.1 - cos).abs() < 4e-16, "{angle}: {ours:?} {sin} {cos}");
        }
    }

    #[test]
    fn identity_lanes_hold_every_ball_once() {
        for balls in [3, 8, 13, 17] {
            let l = Layout { balls, free_cage: false, tilting: tribodyn_bearing::Races::default(), marked: 0 };
            let y: Vec<f64> = (0..l.len()).map(|i| i as f64).collect();
            let mut back = vec![0.0; l.len()];
            for block in 0..blocks(balls) {
                let lanes = gather(l, &y, block);
                assert_eq!(lanes[0].0[WIDTH - 1], y[l.ball((WIDTH * (block + 1)).min(balls) - 1)]);
                let in_use = InUse::of(l, block).lanes().len();
                assert!(in_use.is_multiple_of(VECTOR) && in_use - filled(l, block) < VECTOR);
                scatter(l, &lanes, block, &mut back);
            }
            assert_eq!(back[..l.cage()], y[..l.cage()]);
        }
    }
}
