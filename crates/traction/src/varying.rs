//! Curve parameters that vary with contact pressure (the paper's Eq. 2).

use crate::chebyshev::{Chebyshev, Powers};
use crate::{
    Coating, FastPatch, FilmLaw, Kragelskii, MovingPatch, Patch, PatchDerivative, PatchTraction, Peak, Scalar,
    SlipCurve, SlipUnit, TractionError,
};
use num_dual::Dual64;

/// Conditions at a point of a contact that a traction law may use.
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

    /// The integral by the vector kernel, where one curve holds for all of the patch; `None` where the law has no curve
    /// in lanes, and the generic integral is taken.
    fn fast_traction(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> Option<PatchTraction> {
        let MovingPatch { patch, motion, rolling_speed } = contact;
        let curve = self.kragelskii(patch.peak_pressure)?;
        Some(fast.traction(patch, motion, *rolling_speed, &curve, unit))
    }

    /// [`Self::fast_traction`] with its derivatives.
    fn fast_derivative(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> Option<PatchDerivative> {
        let MovingPatch { patch, motion, rolling_speed } = contact;
        let curve = self.kragelskii(patch.peak_pressure)?;
        let slope = self.kragelskii_slope(patch.peak_pressure)?;
        Some(fast.derivative(patch, motion, *rolling_speed, (&curve, &slope), unit))
    }

    /// True for laws of which [`Self::fast_derivative`] is known.
    fn has_derivative(&self) -> bool {
        // Any pressure: a law is of that kind or is not.
        self.kragelskii_slope(2e9).is_some()
    }

    /// The curve at `pressure` in Pa where it is Kragelskii's: [`crate::FastPatch`] and [`crate::Fastsim`] then take
    /// the place of the generic integrals. None for any other curve.
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
mod tests;
