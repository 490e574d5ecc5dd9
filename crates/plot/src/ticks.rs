//! Round axis steps: 1, 2 or 5 times a power of ten, linear or logarithmic.

use crate::text::{number, power_of_ten};

/// A scaled axis: range, and where labels stand. All in the axis' displayed numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scale {
    pub min: f64,
    pub max: f64,
    /// Values with their labels, ascending.
    pub major: Vec<(f64, String)>,
    /// Values of unlabelled marks (logarithmic axes only).
    pub minor: Vec<f64>,
    pub log: bool,
}

impl Scale {
    /// Position of a value between the ends of the axis, 0 to 1 inside.
    pub fn position(&self, value: f64) -> f64 {
        if self.log {
            (value / self.min).ln() / (self.max / self.min).ln()
        } else {
            (value - self.min) / (self.max - self.min)
        }
    }
}

/// Below this spread, relative to the greatest magnitude, an axis shows a constant and not rounding noise.
const LEAST_SPREAD: f64 = 1e-6;
/// Magnitudes that are drawn: squares and ratios of these neither overflow nor vanish. Smaller ones are zero on a
/// linear axis.
pub(crate) const MAGNITUDES: std::ops::Range<f64> = 1e-150..1e150;

/// The power of ten, a multiple of three, to take out of the numbers of an axis: 0 between 0.01 and 100 000.
pub(crate) fn engineering_exponent(greatest: f64) -> i32 {
    let size = greatest.abs();
    if size == 0.0 || (1e-2..1e5).contains(&size) {
        return 0;
    }
    3 * ((size.log10() + 1.0) / 3.0).floor() as i32
}

/// True if a range is zero and nothing else.
pub(crate) fn is_zero((low, high): (f64, f64)) -> bool {
    low.abs().max(high.abs()) < MAGNITUDES.start
}

/// Widens a range that is a single value to within rounding by 1 % of the value; zero stays zero.
pub(crate) fn spread((low, high): (f64, f64)) -> (f64, f64) {
    let greatest = low.abs().max(high.abs());
    if is_zero((low, high)) {
        return (0.0, 0.0);
    }
    if high - low > LEAST_SPREAD * greatest {
        return (low, high);
    }
    let margin = 0.01 * greatest;
    (low - margin, high + margin)
}

/// The smallest of 1, 2, 5 × 10ⁿ that is not below `least`: mantissa and exponent.
fn step(least: f64) -> (f64, i32) {
    let exponent = least.log10().floor() as i32;
    let fraction = least / 10f64.powi(exponent);
    match [1.0, 2.0, 5.0].into_iter().find(|m| fraction <= m * (1.0 + 1e-9)) {
        Some(mantissa) => (mantissa, exponent),
        None => (1.0, exponent + 1),
    }
}

/// A linear axis of at most `intervals` steps over the range; `snap` moves the ends out to the next step.
///
/// If all is zero only zero is labelled, in the middle: any other label would claim a magnitude that nothing has.
pub(crate) fn linear((low, high): (f64, f64), intervals: usize, snap: bool) -> Scale {
    let (low, high) = spread((low, high));
    if is_zero((low, high)) {
        return Scale { min: -1.0, max: 1.0, major: vec![(0.0, "0".to_owned())], minor: Vec::new(), log: false };
    }
    let mut least = (high - low) / intervals as f64;
    loop {
        let (mantissa, exponent) = step(least);
        // Multiples of an integer mantissa, scaled once: 0.3 stays 0.3 and not 0.30000000000000004.
        let value = |n: i64| {
            let units = n as f64 * mantissa;
            if exponent < 0 { units / 10f64.powi(-exponent) } else { units * 10f64.powi(exponent) }
        };
        let width = value(1);
        let (from, to) = ((low / width + 1e-6), (high / width - 1e-6));
        let (first, last) = if snap { (from.floor(), to.ceil()) } else { ((from - 2e-6).ceil(), (to + 2e-6).floor()) };
        if snap && last - first > intervals as f64 {
            least = width * 1.01;
            continue;
        }
        let decimals = (-exponent).max(0) as usize;
        let major: Vec<_> = (first as i64..=last as i64).map(|n| (value(n), number(value(n), decimals))).collect();
        let (min, max) = if snap { (value(first as i64), value(last as i64)) } else { (low, high) };
        return Scale { min, max, major, minor: Vec::new(), log: false };
    }
}

/// A logarithmic axis over a positive range, its ends moved out to 1, 2 or 5 × 10ⁿ.
pub(crate) fn logarithmic((low, high): (f64, f64)) -> Scale {
    let marks = |from: i32, to: i32, mantissas: &'static [f64]| {
        (from..=to).flat_map(move |e| mantissas.iter().map(move |m| (*m, e)))
    };
    let (from, to) = (low.log10().floor() as i32 - 1, high.log10().floor() as i32 + 1);
    let at = |(m, e): (f64, i32)| {
        if e < 0 { m / 10f64.powi(-e) } else { m * 10f64.powi(e) }
    };
    let ends: Vec<f64> = marks(from, to, &[1.0, 2.0, 5.0]).map(at).collect();
    let mut first = ends.iter().rposition(|v| *v <= low * (1.0 + 1e-9)).unwrap_or(0);
    let mut last = ends.iter().position(|v| *v >= high * (1.0 - 1e-9)).unwrap_or(ends.len() - 1);
    if first == last {
        (first, last) = (first.saturating_sub(1), (last + 1).min(ends.len() - 1));
    }
    let (min, max) = (ends[first], ends[last]);
    let inside = |v: &f64| (min * (1.0 - 1e-9)..=max * (1.0 + 1e-9)).contains(v);
    let decades = marks(from, to, &[1.0]).filter(|p| inside(&at(*p))).count() as i32;
    let every = (decades - 1) / 7 + 1;
    let major = if decades >= 3 {
        marks(from, to, &[1.0])
            .filter(|p| inside(&at(*p)) && p.1.rem_euclid(every) == 0)
            .map(|p| (at(p), power_of_ten(p.1)))
            .collect()
    } else {
        marks(from, to, &[1.0, 2.0, 5.0]).filter(|p| inside(&at(*p))).map(|p| (at(p), mantissa_label(p))).collect()
    };
    let minor = marks(from, to, &[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]).map(at).filter(inside).collect();
    Scale { min, max, major, minor, log: true }
}

/// A number such as `0.2`, `50` or `2×10⁻⁶`.
fn mantissa_label((mantissa, exponent): (f64, i32)) -> String {
    match exponent {
        -3..=0 => number(mantissa / 10f64.powi(-exponent), (-exponent) as usize),
        1..=3 => number(mantissa * 10f64.powi(exponent), 0),
        _ if mantissa == 1.0 => power_of_ten(exponent),
        _ => format!("{mantissa:.0}×{}", power_of_ten(exponent)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: &Scale) -> Vec<&str> {
        scale.major.iter().map(|(_, text)| text.as_str()).collect()
    }

    #[test]
    fn limit_linear_ticks_are_round_and_cover_the_range() {
        assert_eq!(labels(&linear((5.1, 12.0), 5, true)), ["4", "6", "8", "10", "12"]);
        assert_eq!(labels(&linear((-2.0, 1.0), 5, true)), ["−2", "−1", "0", "1"]);
        assert_eq!(labels(&linear((1.69, 2.46), 5, true)), ["1.6", "1.8", "2.0", "2.2", "2.4", "2.6"]);
        assert_eq!(labels(&linear((0.13, 0.94), 5, false)), ["0.2", "0.4", "0.6", "0.8"]);
        assert_eq!(labels(&linear((0.0, 1.0), 5, false)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
    }

    #[test]
    fn identity_linear_ticks_over_many_ranges() {
        for k in 0..2000 {
            let low = f64::from(k % 37 - 18) * 1.7f64.powi(k % 23 - 11);
            let high = low + 1.3f64.powi(k % 61 - 30).max(1e-5 * low.abs());
            let scale = linear((low, high), 5, true);
            let slack = 2e-6 * (scale.max - scale.min);
            assert!(scale.min <= low + slack && scale.max >= high - slack, "{low} {high} {scale:?}");
            assert!((2..=6).contains(&scale.major.len()), "{low} {high} {scale:?}");
            let texts = labels(&scale);
            assert!(texts.windows(2).all(|pair| pair[0] != pair[1]), "{texts:?}");
        }
    }

    #[test]
    fn limit_constant_data_get_a_finite_range() {
        let scale = linear((5855.0, 5855.0), 5, true);
        assert!(scale.min < 5855.0 && scale.max > 5855.0);
        let zero = linear((0.0, 0.0), 5, true);
        assert_eq!((zero.position(0.0), labels(&zero)), (0.5, vec!["0"]));
        assert_eq!(linear((0.0, 1e-310), 5, true), zero);
    }

    #[test]
    fn limit_logarithmic_ticks() {
        assert_eq!(labels(&logarithmic((1e-6, 1e-2))), ["10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²"]);
        assert_eq!(labels(&logarithmic((10.0, 48.0))), ["10", "20", "50"]);
        let wide = logarithmic((3e-16, 4.0));
        assert!(wide.major.len() <= 9 && wide.min <= 3e-16 && wide.max >= 4.0, "{wide:?}");
        let one = logarithmic((7.0, 7.0));
        assert!(one.min < 7.0 && one.max > 7.0);
    }

    #[test]
    fn limit_engineering_exponents() {
        let cases = [(8e-13, -12), (2.3e-12, -12), (0.002, -3), (0.05, 0), (14_000.0, 0), (2e9, 9), (0.0, 0)];
        for (value, exponent) in cases {
            assert_eq!(engineering_exponent(value), exponent, "{value}");
        }
    }
}
