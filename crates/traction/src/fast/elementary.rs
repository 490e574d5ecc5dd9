//! exp and ln over eight lanes, and exp in single precision over sixteen, the same bits at every vector width: only
//! +, −, ×, ÷, a b + c rounded once, and integer shifts.
//!
//! The polynomials were fitted at Chebyshev's nodes: exp over |r| ≤ ln 2/2 with a truncation error of 1.7e-17, ln over
//! m in [√½, √2] with 5e-18. Measured against the standard library's functions, relative: exp 2.2e-16, exp − 1 down to
//! the smallest arguments 2.2e-16, ln down to 1 3.3e-16 (asserted below with twice as much); exp − 1 in single
//! precision 4.4e-7.

use super::lanes::{Lanes, fused};
use fearless_simd::prelude::*;

/// 1.5 · 2^52: added to a number below 2^51 in magnitude it leaves the nearest integer in the low bits.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;
/// ln 2, its upper 21 bits, so that k · `LN_2_HIGH` is exact, and the rest.
const LN_2_HIGH: f64 = 0.693_146_705_627_441_4;
const LN_2_LOW: f64 = 4.749_325_039_031_672_6e-7;
/// s(r) of exp(r) = 1 + r + r² s(r).
const EXP: [f64; 10] = [
    0.5,
    0.166_666_666_666_666_69,
    0.041_666_666_666_624_13,
    0.008_333_333_333_330_062,
    0.001_388_888_891_721_371_7,
    0.000_198_412_698_630_536_18,
    2.480_152_129_595_437_6e-5,
    2.755_726_845_999_706_4e-6,
    2.762_008_844_540_974_6e-7,
    2.510_038_549_551_032e-8,
];
/// q(z) of atanh(s) = s + s z q(z), z = s².
const ATANH: [f64; 7] = [
    0.333_333_333_333_333_5,
    0.199_999_999_999_497_22,
    0.142_857_143_130_016_35,
    0.111_111_055_651_299_39,
    0.090_914_447_278_374_74,
    0.076_658_553_091_053_86,
    0.073_082_927_124_443_11,
];

/// r, s(r) and 2^k with exp(x) = 2^k (1 + r + r² s(r)), for |x| ≤ 700.
#[inline(always)]
fn split_exp<S: Simd>(x: Lanes<S>) -> (Lanes<S>, Lanes<S>, Lanes<S>) {
    let shifted = fused(x, std::f64::consts::LOG2_E, TO_INTEGER);
    let k = shifted - TO_INTEGER;
    let r = fused(k, -LN_2_LOW, fused(k, -LN_2_HIGH, x));
    let (r2, c) = (r * r, EXP);
    let r4 = r2 * r2;
    let low = fused(fused(r, c[3], c[2]), r2, fused(r, c[1], c[0]));
    let high = fused(fused(r, c[7], c[6]), r2, fused(r, c[5], c[4]));
    let series = fused(fused(fused(r, c[9], c[8]), r4, high), r4, low);
    // k stands in the low bits of `shifted`; 1023 is the bias of the exponent.
    let power = Lanes::from_bits((shifted.to_bits() << 52u32) + (1023u64 << 52));
    (r, series, power)
}

/// exp(x) for |x| ≤ 700.
#[inline(always)]
pub(crate) fn exp<S: Simd>(x: Lanes<S>) -> Lanes<S> {
    let (r, series, power) = split_exp(x);
    fused(power, fused(r * r, series, r), power)
}

/// exp(x) − 1 for |x| ≤ 700, without loss of digits at small x.
#[inline(always)]
pub(crate) fn exp_m1<S: Simd>(x: Lanes<S>) -> Lanes<S> {
    let (r, series, power) = split_exp(x);
    fused(power, fused(r * r, series, r), power - 1.0)
}

/// exp(x) − 1 for x ≤ 80 in single precision, without loss of digits at small x; below −80 as there.
#[inline(always)]
pub(crate) fn exp_m1_single<S: Simd, V: SimdFloat<S, Element = f32>>(x: V) -> V {
    /// 1.5 · 2^23: as [`TO_INTEGER`].
    const TO_INTEGER: f32 = 12_582_912.0;
    let x = x.max(-80.0);
    let shifted = fused(x, std::f32::consts::LOG2_E, TO_INTEGER);
    let k = shifted - TO_INTEGER;
    // ln 2 is rounded by 2e-9, the product not at all.
    let r = fused(k, -std::f32::consts::LN_2, x);
    let r2 = r * r;
    // Terms of the exponential series from the second: the next is below 2e-8 of the first.
    let high = fused(r2, 1.0 / 720.0, fused(r, 1.0 / 120.0, 1.0 / 24.0));
    let series = fused(r2, high, fused(r, 1.0 / 6.0, 0.5));
    let power = V::from_bits((shifted.to_bits() << 23u32) + (127u32 << 23));
    fused(power, fused(r2, series, r), power - 1.0)
}

/// ln(x) for finite x > 0 that are not subnormal.
#[inline(always)]
pub(crate) fn ln<S: Simd>(x: Lanes<S>) -> Lanes<S> {
    // Exponent k such that the mantissa x/2^k lies in [√½, √2): the bits of √½ are the border.
    const BELOW_BORDER: u64 = 0x3ff0_0000_0000_0000 - 0x3fe6_a09e_667f_3bcd;
    let bits = x.to_bits();
    let biased = (bits + BELOW_BORDER) >> 52u32;
    let mantissa = Lanes::from_bits(bits - ((biased - 1023u64) << 52u32));
    // The integer as the low bits of 2^52 + integer.
    let k = Lanes::from_bits(biased | 0x4330_0000_0000_0000u64) - (4_503_599_627_370_496.0 + 1023.0);
    let s = (mantissa - 1.0) / (mantissa + 1.0);
    let (z, c) = (s * s, ATANH);
    let z2 = z * z;
    let low = fused(fused(z, c[3], c[2]), z2, fused(z, c[1], c[0]));
    let series = fused(fused(z2, c[6], fused(z, c[5], c[4])), z2 * z2, low);
    let atanh = fused(s, z * series, s);
    fused(k, LN_2_HIGH, fused(k, LN_2_LOW, atanh + atanh))
}

#[cfg(test)]
mod tests {
    use super::super::lanes::{LANES, Pairs};
    use super::*;
    use fearless_simd::{Level, dispatch};

    type Vectors = [[f64; LANES]; 3];

    /// exp, exp − 1 and ln of the magnitude, of eight numbers.
    fn all(level: Level, x: [f64; LANES]) -> Vectors {
        dispatch!(level, simd => {
            let v = Lanes::simd_from(simd, x);
            [exp(v).to_array(), exp_m1(v).to_array(), ln(v.max(0.75)).to_array()]
        })
    }

    /// From 1e-300 to 690 in magnitude, both signs, and plainly spaced where the curve works.
    fn arguments() -> impl Iterator<Item = f64> {
        let wide = (0..4000).map(|i| 690.0 * (-f64::from(i) * 0.173).exp());
        let near = (0..40_000).map(|i| f64::from(i) * 1e-3);
        wide.chain(near).flat_map(|x| [x, -x])
    }

    #[test]
    fn identity_against_the_library_functions() {
        let mut worst = [0.0f64; 3];
        for x in arguments() {
            let [e, m, l] = all(Level::new(), [x; LANES]).map(|v| v[1]);
            worst[0] = worst[0].max((e / x.exp() - 1.0).abs());
            if x != 0.0 {
                worst[1] = worst[1].max((m / x.exp_m1() - 1.0).abs());
            }
            if x > 1.0 {
                worst[2] = worst[2].max((l / x.ln() - 1.0).abs());
            }
        }
        assert!(worst[0] < 4e-16 && worst[1] < 5e-16 && worst[2] < 5e-16, "{worst:?}");
    }

    #[test]
    fn identity_single_precision_against_the_library_function() {
        let single =
            |level: Level, x: f32| -> f32 { dispatch!(level, simd => exp_m1_single(Pairs::splat(simd, x))[3]) };
        let mut worst = 0.0f32;
        for x in (0..40_000).flat_map(|i| [-2e-3 * i as f32, -80.0 * (-1e-3 * i as f32).exp()]) {
            let ours = single(Level::new(), x);
            assert_eq!(ours.to_bits(), single(Level::baseline(), x).to_bits());
            if x != 0.0 {
                worst = worst.max((ours / x.exp_m1() - 1.0).abs());
            }
        }
        assert!(worst < 8.4e-7, "{worst:e}");
    }

    #[test]
    fn limit_ends_of_the_range() {
        let [e, m, l] = all(Level::new(), [0.0, -700.0, 1.0, 700.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!([e[0], m[0], m[1], l[2]], [1.0, 0.0, -1.0, 0.0]);
        assert!(e[1] > 9e-305 && e[1] < 1e-304 && e[3].is_finite());
    }

    #[test]
    fn identity_bits_do_not_depend_on_the_vector_width() {
        for x in arguments() {
            let x = [x, 0.5 * x, -x, x + 1e-9, 0.25 * x, 0.3 * x, -0.7 * x, x - 1e-9];
            assert_eq!(
                all(Level::baseline(), x).map(|v| v.map(f64::to_bits)),
                all(Level::new(), x).map(|v| v.map(f64::to_bits))
            );
        }
    }
}
