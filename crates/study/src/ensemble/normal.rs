//! Quantiles of the normal distribution, the same bits on every machine.

use std::f64::consts::{LN_2, SQRT_2};

/// Wichura, Algorithm AS 241, Applied Statistics 37 (1988) 477, doi:10.2307/2347330: PPND7, rational approximations to
/// 7 digits. Coefficients of the middle (|share − 0.5| up to 0.425).
const MIDDLE: [[f64; 4]; 2] = [
    [3.387_132_717_9, 50.434_271_938, 159.291_132_02, 59.109_374_720],
    [1.0, 17.895_169_469, 78.757_757_664, 67.187_563_600],
];
/// The same for the sides (share of the tail down to exp(−25)).
const SIDES: [[f64; 4]; 2] = [
    [1.423_437_277_7, 2.756_815_390_0, 1.306_728_481_6, 0.170_238_211_03],
    [1.0, 0.737_001_642_50, 0.120_211_329_75, 0.0],
];
/// The same for the ends beyond.
const ENDS: [[f64; 4]; 2] = [
    [6.657_905_115_0, 3.081_226_386_0, 0.428_682_943_37, 0.017_337_203_997],
    [1.0, 0.241_978_942_25, 0.012_258_202_635, 0.0],
];

/// Values below which a share (above 0, below 1) of a normal distribution lies, in standard deviations from its mean;
/// relative error 2e-7.
pub(crate) fn normal_quantile(share: f64) -> f64 {
    let off = share - 0.5;
    if off.abs() <= 0.425 {
        return off * ratio(&MIDDLE, 0.425 * 0.425 - off * off);
    }
    let tail = if off < 0.0 { share } else { 1.0 - share };
    let r = (-ln(tail)).sqrt();
    let far = if r <= 5.0 { ratio(&SIDES, r - 1.6) } else { ratio(&ENDS, r - 5.0) };
    far.copysign(off)
}

fn ratio([above, below]: &[[f64; 4]; 2], r: f64) -> f64 {
    let sum = |c: &[f64; 4]| c.iter().rev().fold(0.0, |sum, c| sum * r + c);
    sum(above) / sum(below)
}

/// Natural logarithm of a normal number above 0. Sums, products and quotients are the same on every machine, which the
/// logarithm of the system is not.
fn ln(x: f64) -> f64 {
    const MANTISSA: u64 = (1 << 52) - 1;
    let exponent = (x.to_bits() >> 52) as i32 - 1023;
    let mantissa = f64::from_bits((x.to_bits() & MANTISSA) | 1.0f64.to_bits());
    let (exponent, mantissa) = if mantissa > SQRT_2 { (exponent + 1, 0.5 * mantissa) } else { (exponent, mantissa) };
    // ln m = 2 artanh s: |s| is at most 0.172, and of the series 12 terms are enough for all digits.
    let s = (mantissa - 1.0) / (mantissa + 1.0);
    let series = (0..12).rev().fold(0.0, |sum, k| sum * (s * s) + 1.0 / f64::from(2 * k + 1));
    f64::from(exponent) * LN_2 + 2.0 * s * series
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_the_logarithm_has_all_digits() {
        for k in 0..4000 {
            let x = 0.96_f64.powi(k % 900) * (1.0 + f64::from(k) / 977.0);
            let (found, expected) = (ln(x), x.ln());
            assert!((found - expected).abs() <= 4e-16 * expected.abs().max(1.0), "ln {x} = {found}, not {expected}");
        }
        assert_eq!([ln(1.0), ln(0.5)], [0.0, -LN_2]);
    }

    /// Python's `statistics.NormalDist().inv_cdf`, which has the same source's 16 digits.
    #[test]
    fn code_python_quantiles_of_the_normal_distribution() {
        for (share, expected) in [
            (0.025, -1.959_963_984_540_053_8),
            (0.075, -1.439_531_470_938_455_7),
            (0.0749, -1.440_238_267_527_963_2),
            (0.3, -0.524_400_512_708_040_7),
            (0.9, 1.281_551_565_544_600_8),
            (1e-5, -4.264_890_793_922_823),
            (1e-12, -7.034_483_825_301_132),
            (f64::EPSILON / 4.0, -8.292_361_075_813_595),
        ] {
            let found = normal_quantile(share);
            assert!((found / expected - 1.0).abs() < 2e-7, "{share}: {found} instead of {expected}");
        }
        assert_eq!(normal_quantile(0.5), 0.0);
        assert_eq!(normal_quantile(0.25), -normal_quantile(0.75));
    }
}
