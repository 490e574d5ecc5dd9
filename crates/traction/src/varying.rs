//! Curve parameters that vary with contact pressure (the paper's Eq. 2).

use crate::chebyshev::{Chebyshev, Powers};
use crate::{Coating, FilmLaw, Kragelskii, Patch, Peak, Scalar, SlipCurve, TractionError};
use num_dual::Dual64;

/// What a traction law may know of a point of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditions<D = f64> {
    /// Pressure, Pa: the highest of the contact or that at the point, as the law is taken.
    pub pressure: D,
    /// Entrainment speed, the mean of both surface speeds along rolling, m/s.
    pub entrainment_speed: D,
    /// The contact's ellipse and highest pressure.
    pub patch: Patch<D>,
}

impl<D: Scalar> Conditions<D> {
    /// The same in another scalar.
    pub(crate) fn map<T: Scalar>(&self, to: impl Fn(D) -> T) -> Conditions<T> {
        let patch = Patch {
            semi_lateral: to(self.patch.semi_lateral),
            semi_rolling: to(self.patch.semi_rolling),
            peak_pressure: to(self.patch.peak_pressure),
            ball_radius: self.patch.ball_radius,
            surface_radius: self.patch.surface_radius,
        };
        Conditions { pressure: to(self.pressure), entrainment_speed: to(self.entrainment_speed), patch }
    }
}

/// A traction law: the curve κ(s) that holds at a point of a contact. Implement it to bring your own curve.
pub trait TractionLaw: Sync {
    /// The curve at one pressure.
    type Curve<D: Scalar>: SlipCurve<D>;

    /// The curve at contact pressure `pressure` in Pa.
    fn at<D: Scalar>(&self, pressure: D) -> Self::Curve<D>;

    /// The curve under the conditions of a contact; that of their pressure unless a law asks for more.
    fn under<D: Scalar>(&self, conditions: &Conditions<D>) -> Self::Curve<D> {
        self.at(conditions.pressure)
    }

    /// The film of a law that is one of a lubricant: all patch integrals then go through
    /// [`FilmLaw::traction`], which has pressures, temperatures and slip units of its own.
    fn film(&self) -> Option<&FilmLaw> {
        None
    }

    /// True if `pressure` in Pa lies outside the range of the data, so that it is clamped.
    fn clamps(&self, pressure: f64) -> bool;

    /// The curve at `pressure` in Pa where it is Kragelskii's: [`crate::FastPatch`] then takes the place of the generic
    /// integral. None for any other curve.
    fn kragelskii(&self, _pressure: f64) -> Option<Kragelskii> {
        None
    }

    /// dA/dp, dB/dp and dC/dp of [`TractionLaw::kragelskii`], per Pa.
    fn kragelskii_slope(&self, _pressure: f64) -> Option<Kragelskii> {
        None
    }
}

/// S_m, K_m and K as polynomials in pressure, fitted to a coating's tests.
#[derive(Debug, Clone, PartialEq)]
pub struct PressureFit {
    /// Coefficients by rising power of p in GPa, for S_m, K_m and K.
    pub coefficients: [Vec<f64>; 3],
    /// Pressures between which the fit holds, Pa.
    pub valid_pressure: [f64; 2],
}

impl PressureFit {
    /// Polynomials of degree `order`: through the tests where their number is `order` + 1, least squares where there
    /// are more.
    ///
    /// # Errors
    /// [`TractionError::TooFewTests`] where the tests do not determine the polynomial.
    pub fn new(coating: &Coating, order: usize) -> Result<Self, TractionError> {
        let count = coating.tested.len();
        if count <= order {
            return Err(TractionError::TooFewTests { order, count, needed: order + 1 });
        }
        let pressures: Vec<f64> = coating.tested.iter().map(|t| t.pressure * 1e-9).collect();
        let fit = |value: fn(&Peak) -> f64| {
            polynomial_fit(&pressures, &coating.tested.iter().map(|t| value(&t.peak)).collect::<Vec<_>>(), order)
        };
        Ok(Self {
            coefficients: [fit(|p| p.slip), fit(|p| p.coefficient), fit(|p| p.residual)],
            valid_pressure: coating.valid_pressure,
        })
    }

    /// Peak data at a pressure in Pa, not clamped.
    pub fn peak<D: Scalar>(&self, pressure: D) -> Peak<D> {
        let p = pressure * 1e-9;
        let [slip, coefficient, residual] =
            self.coefficients.each_ref().map(|c| c.iter().rev().fold(D::zero(), |sum, &k| sum * p + k));
        Peak { slip, coefficient, residual }
    }
}

/// Least squares by modified Gram–Schmidt on centred powers, expanded back to powers of p.
fn polynomial_fit(x: &[f64], y: &[f64], order: usize) -> Vec<f64> {
    let mut basis: Vec<(Vec<f64>, Vec<f64>)> = Vec::new(); // (values at x, coefficients)
    let mut result = vec![0.0; order + 1];
    for degree in 0..=order {
        let (mut values, mut coefficients) = match basis.last() {
            None => (vec![1.0; x.len()], vec![1.0]),
            Some((v, c)) => {
                let mut shifted = vec![0.0];
                shifted.extend_from_slice(c);
                (v.iter().zip(x).map(|(v, x)| v * x).collect(), shifted)
            }
        };
        for (v, c) in &basis {
            let share = dot(&values, v) / dot(v, v);
            values.iter_mut().zip(v).for_each(|(a, b)| *a -= share * b);
            coefficients.iter_mut().zip(c).for_each(|(a, b)| *a -= share * b);
        }
        let weight = dot(y, &values) / dot(&values, &values);
        result.iter_mut().zip(&coefficients).for_each(|(r, c)| *r += weight * c);
        debug_assert_eq!(coefficients.len(), degree + 1);
        basis.push((values, coefficients));
    }
    result
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A coating's traction law: Kragelskii's curve with parameters that follow the pressure, or fixed ones.
///
/// The inversion from peak data to A, B, C is done once: Chebyshev series over the valid range stand in for it
/// (relative error below 1e-13, tested), smooth and cheap in the solver's loops.
#[derive(Debug, Clone, PartialEq)]
pub struct CoatingLaw {
    fit: PressureFit,
    series: [Chebyshev; 3],
    /// The series and their derivatives in a quicker form, where it keeps the digits.
    powers: Option<[Powers; 2]>,
    ends: Ends,
    reference_pressure: Option<f64>,
}

/// Part of the range of pressures over which a law goes from following the pressure to standing still.
const ENDING: f64 = 0.01;

/// Pressures at which a law stops following the pressure, Pa. Over `width` on either side the slope goes from one to
/// zero in a straight line: a bend there would be one in the traction of a ball on its way round, and its slope a jump.
/// Tested pressures are never within.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ends {
    least: f64,
    most: f64,
    width: f64,
}

impl Ends {
    fn new(coating: &Coating) -> Self {
        let [low, high] = coating.valid_pressure;
        let width = ENDING * (high - low);
        let tested = || coating.tested.iter().map(|test| test.pressure);
        let least = low.min(tested().fold(f64::INFINITY, f64::min) - width);
        let most = high.max(tested().fold(0.0, f64::max) + width);
        Self { least, most, width }
    }

    /// The pressure at which the parameters are taken.
    fn within<D: Scalar>(&self, pressure: D) -> D {
        let Self { least, most, width } = *self;
        let p = pressure.re();
        if p <= least - width {
            D::from(least)
        } else if p >= most + width {
            D::from(most)
        } else if p < least + width {
            let above = pressure - (least - width);
            above * above * (0.25 / width) + least
        } else if p > most - width {
            let below = pressure - (most + width);
            -(below * below * (0.25 / width)) + most
        } else {
            pressure
        }
    }
}

/// Enough for 1e-14 of A, B, C of parabolas over 1.5–4 GPa; the construction adapts.
const SERIES_LENGTHS: [usize; 4] = [16, 32, 64, 128];

impl CoatingLaw {
    /// The law whose parameters follow the pressure (cases 1 and 3 of the paper).
    ///
    /// # Errors
    /// Too few tests for the order, or [`TractionError::FitNotACurve`] where the fit leaves K_m > K > 0, S_m > 0.
    pub fn varying(coating: &Coating, order: usize) -> Result<Self, TractionError> {
        let fit = PressureFit::new(coating, order)?;
        let [low, high] = fit.valid_pressure;
        // A grid finer than any wiggle of a low-order polynomial: is there a curve everywhere?
        for i in 0..=400 {
            let pressure = low + (high - low) * f64::from(i) / 400.0;
            let peak = fit.peak(pressure);
            Kragelskii::from_peak(peak).map_err(|_| TractionError::FitNotACurve {
                order,
                pressure_gpa: pressure * 1e-9,
                slip: peak.slip,
                coefficient: peak.coefficient,
                residual: peak.residual,
            })?;
        }
        let parameter = |index: usize| {
            move |fit: &PressureFit, pressure: f64| {
                // The grid above has shown that a curve exists.
                Kragelskii::from_peak(fit.peak(pressure)).map_or(f64::NAN, |k| [k.a, k.b, k.c][index])
            }
        };
        let mut series = None;
        for length in SERIES_LENGTHS {
            let candidate = [0, 1, 2].map(|i| Chebyshev::interpolate(low, high, length, |p| parameter(i)(&fit, p)));
            let done = candidate.iter().all(|c| c.tail() < 1e-14);
            series = Some(candidate);
            if done {
                break;
            }
        }
        let series = series.unwrap_or_else(|| unreachable!("at least one length is tried")).map(Chebyshev::trimmed);
        let powers = Powers::new(&series);
        Ok(Self { fit, series, powers, ends: Ends::new(coating), reference_pressure: None })
    }

    /// The law with the parameters of one pressure in Pa for every contact (cases 2 and 4).
    ///
    /// # Errors
    /// As [`CoatingLaw::varying`].
    pub fn fixed(coating: &Coating, order: usize, reference_pressure: f64) -> Result<Self, TractionError> {
        Ok(Self { reference_pressure: Some(reference_pressure), ..Self::varying(coating, order)? })
    }

    /// The fitted polynomials.
    pub fn fit(&self) -> &PressureFit {
        &self.fit
    }

    /// The curve by inversion at the pressure itself: the reference that the series is tested against.
    ///
    /// # Errors
    /// [`TractionError::Peak`] never occurs within the valid range.
    pub fn at_by_inversion<D: Scalar>(&self, pressure: D) -> Result<Kragelskii<D>, TractionError> {
        Kragelskii::from_peak(self.fit.peak(self.clamped(pressure)))
    }

    fn clamped<D: Scalar>(&self, pressure: D) -> D {
        self.ends.within(self.reference_pressure.map_or(pressure, D::from))
    }
}

impl TractionLaw for CoatingLaw {
    type Curve<D: Scalar> = Kragelskii<D>;

    fn at<D: Scalar>(&self, pressure: D) -> Kragelskii<D> {
        let p = self.clamped(pressure);
        let [a, b, c] = self.series.each_ref().map(|s| s.value(p));
        Kragelskii { a, b, c }
    }

    fn clamps(&self, pressure: f64) -> bool {
        let pressure = self.reference_pressure.unwrap_or(pressure);
        pressure < self.fit.valid_pressure[0] || pressure > self.fit.valid_pressure[1]
    }

    fn kragelskii(&self, pressure: f64) -> Option<Kragelskii> {
        let Some([values, _]) = &self.powers else {
            return Some(self.at(pressure));
        };
        let [a, b, c] = values.values(self.clamped(pressure));
        Some(Kragelskii { a, b, c })
    }

    fn kragelskii_slope(&self, pressure: f64) -> Option<Kragelskii> {
        let within = self.ends.within(Dual64::from(pressure).derivative());
        if self.reference_pressure.is_some() || within.eps == 0.0 {
            return Some(Kragelskii { a: 0.0, b: 0.0, c: 0.0 });
        }
        let [a, b, c] = match &self.powers {
            Some([_, slopes]) => slopes.values(within.re).map(|slope| slope * within.eps),
            None => {
                let curve = self.at(Dual64::from(pressure).derivative());
                [curve.a, curve.b, curve.c].map(|parameter| parameter.eps)
            }
        };
        Some(Kragelskii { a, b, c })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64, relative: f64) -> bool {
        (a - b).abs() <= relative * b.abs()
    }

    #[test]
    fn paper_table_2_comes_back_at_the_test_pressures() {
        for name in crate::coating_names() {
            let coating = Coating::library(name).unwrap();
            let law = CoatingLaw::varying(&coating, 2).unwrap();
            for test in &coating.tested {
                let published = Kragelskii::from_peak(test.peak).unwrap();
                let ours = law.at(test.pressure);
                for (x, y) in [(ours.a, published.a), (ours.b, published.b), (ours.c, published.c)] {
                    assert!(close(x, y, 1e-12), "{name}: {x} against {y}");
                }
            }
        }
    }

    #[test]
    fn identity_series_equals_inversion_with_its_derivative() {
        for (name, order) in [("ag", 2), ("ag", 1), ("ptfe", 2), ("ptfe", 1), ("ag", 0)] {
            let law = CoatingLaw::varying(&Coating::library(name).unwrap(), order).unwrap();
            for i in 0..=97 {
                let p = Dual64::from(1.5e9 + 2.5e9 * f64::from(i) / 97.0).derivative();
                let (fast, plain) = (law.at(p), law.at_by_inversion(p).unwrap());
                for (x, y) in [(fast.a, plain.a), (fast.b, plain.b), (fast.c, plain.c)] {
                    assert!(close(x.re, y.re, 1e-13), "{name} {order}: {} {}", x.re, y.re);
                    assert!((x.eps - y.eps).abs() < 1e-8 * (y.re * 1e-9).abs(), "{} {}", x.eps, y.eps);
                }
                let (value, slope) = (law.kragelskii(p.re).unwrap(), law.kragelskii_slope(p.re).unwrap());
                for (v, s, y) in [(value.a, slope.a, fast.a), (value.b, slope.b, fast.b), (value.c, slope.c, fast.c)] {
                    assert!(close(v, y.re, 1e-13), "{name} {order}: {v} {}", y.re);
                    assert!((s - y.eps).abs() < 1e-10 * (y.re * 1e-9).abs(), "{name} {order}: {s} {}", y.eps);
                }
            }
        }
    }

    #[test]
    fn limit_outside_the_range_is_clamped_and_reported() {
        let law = CoatingLaw::varying(&Coating::library("ag").unwrap(), 2).unwrap();
        assert!(law.clamps(1.4e9) && law.clamps(4.1e9) && !law.clamps(2.0e9));
        assert_eq!(law.at(1.0e9), law.at(1.5e9));
        let fixed = CoatingLaw::fixed(&Coating::library("ag").unwrap(), 2, 2.5e9).unwrap();
        assert_eq!(fixed.at(1.0e9), fixed.at(3.0e9));
        assert!(!fixed.clamps(1.0e9));
    }

    /// Between following the pressure and standing still there is neither a jump nor a bend; tested pressures are
    /// followed to the last bit, those far outside stand still.
    #[test]
    fn limit_a_law_ends_without_a_bend() {
        let points = |pressures: [f64; 3]| {
            let paper = Coating::library("ag").unwrap().tested;
            let tested = pressures.iter().zip(paper).map(|(&pressure, test)| crate::TestedCurve { pressure, ..test });
            Coating::from_tests("own", tested.collect()).unwrap()
        };
        for coating in [Coating::library("ag").unwrap(), Coating::library("ptfe").unwrap(), points([1e9, 1.5e9, 2e9])] {
            let law = CoatingLaw::varying(&coating, 2).unwrap();
            let [first, last] = [coating.tested[0].pressure, coating.tested[2].pressure];
            for share in [0.0, 0.13, 0.5, 0.9, 1.0] {
                let p = first + share * (last - first);
                assert_eq!(law.ends.within(p), p);
            }
            let [low, high] = coating.valid_pressure;
            assert_eq!(law.at(0.5 * low), law.at(0.9 * low));
            assert_eq!(law.at(2.0 * high), law.at(1.1 * high));
            let step = 1e5;
            let mut slopes: Vec<f64> = Vec::new();
            let mut p = 0.95 * low;
            while p < 1.05 * high {
                let slope = law.kragelskii_slope(p).unwrap();
                let central =
                    (law.kragelskii(p + 0.5 * step).unwrap().a - law.kragelskii(p - 0.5 * step).unwrap().a) / step;
                assert!((slope.a - central).abs() < 1e-3 * slope.a.abs() + 1e-15, "{p}: {} {central}", slope.a);
                slopes.push(slope.a);
                p += 1e6;
            }
            // Over a hundredth of the range a slope of up to 1e-10 per Pa comes down to nothing.
            let steepest = slopes.iter().fold(0f64, |most, slope| most.max(slope.abs()));
            let most = steepest * 1e6 / (ENDING * (high - low));
            assert!(slopes.windows(2).all(|pair| (pair[1] - pair[0]).abs() < most), "a bend");
        }
    }

    #[test]
    fn limit_order_beyond_the_tests_is_refused() {
        let error = CoatingLaw::varying(&Coating::library("ag").unwrap(), 3).unwrap_err();
        assert!(matches!(error, TractionError::TooFewTests { order: 3, count: 3, needed: 4 }));
    }

    #[test]
    fn limit_least_squares_line_passes_through_the_mean() {
        let fit = PressureFit::new(&Coating::library("ag").unwrap(), 1).unwrap();
        // Equispaced pressures: the least-squares line takes the mean value at the middle one.
        assert!(close(fit.peak(3.0e9).residual, (0.124 + 0.116 + 0.102) / 3.0, 1e-13));
    }

    #[test]
    fn paper_parabolas_are_not_monotone_below_the_tests() {
        // K of Ag peaks at 2.08 GPa, K_m of PTFE at 2.2 GPa: the reason why the order is an input.
        let slope = |name: &str, pick: fn(Peak<Dual64>) -> Dual64, p: f64| {
            let fit = PressureFit::new(&Coating::library(name).unwrap(), 2).unwrap();
            pick(fit.peak(Dual64::from(p).derivative())).eps
        };
        assert!(slope("ag", |p| p.residual, 2.07e9) > 0.0 && slope("ag", |p| p.residual, 2.09e9) < 0.0);
        assert!(slope("ptfe", |p| p.coefficient, 2.2e9) > 0.0 && slope("ptfe", |p| p.coefficient, 2.3e9) < 0.0);
    }
}
