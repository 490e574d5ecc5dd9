//! Traction laws of one's own, integrated in vector lanes as the built-in ones are.

use crate::fast::curve::{LaneCurve, Slopes};
use crate::fast::lanes::{LANES, Lanes, fused};
use crate::fast::{elementary, scale_slope};
use crate::{Conditions, FastPatch, MovingPatch, PatchDerivative, PatchTraction, SlipUnit};
use fearless_simd::{SimdBase, prelude::*};
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

/// A double, or eight of them in vector lanes: what a curve is written in.
pub trait CurveNumber:
    Copy
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// A constant, in as many lanes as this has.
    fn constant(self, value: f64) -> Self;
    /// a b + c, rounded once; a is this.
    fn fused(self, b: Self, c: Self) -> Self;
    /// √x.
    fn sqrt(self) -> Self;
    /// exp(x) for |x| ≤ 700.
    fn exp(self) -> Self;
    /// exp(x) − 1 for |x| ≤ 700, with all digits at small x.
    fn exp_m1(self) -> Self;
    /// ln(x) for x > 0.
    fn ln(self) -> Self;
    /// The larger of this and a constant.
    fn max(self, least: f64) -> Self;
    /// The smaller of this and a constant.
    fn min(self, most: f64) -> Self;
    /// `then` where this is below a constant, else `otherwise`.
    fn below(self, limit: f64, then: Self, otherwise: Self) -> Self;
    /// Any other function, lane by lane: as slow as it is on one double.
    fn map(self, function: impl Fn(f64) -> f64) -> Self;
}

/// A traction curve at one slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OverSlip<N = f64> {
    /// κ/s; at rest the initial slope of κ.
    pub value: N,
    /// dκ/ds.
    pub slope: N,
    /// Derivative of κ/s by the pressure, per Pa.
    pub by_pressure: N,
    /// Derivative of κ/s by the entrainment speed, s/m; `None` spares its integrals.
    pub by_entrainment: Option<N>,
}

/// A curve κ(s) under the conditions of one contact.
pub trait CustomCurve {
    /// κ/s with its slopes at a slip s > 0; a body at rest slips by 1e-140.
    ///
    /// Write it without branches and mark it `#[inline(always)]`, so that it becomes part of the vector code: as a
    /// function apart it takes some ten times as long.
    fn over_slip<N: CurveNumber>(&self, slip: N) -> OverSlip<N>;
}

/// A traction law of one's own: a coefficient over slip, pressure and entrainment speed, given by value and slopes.
/// Whatever else it needs, such as a temperature, it holds itself.
///
/// ```
/// use tribodyn_traction::{Conditions, CurveNumber, CustomCurve, CustomLaw, Law, OverSlip};
///
/// /// κ = μ s/(s + s_0).
/// #[derive(Debug, Clone, Copy)]
/// struct Smooth {
///     coefficient: f64,
///     slip: f64,
/// }
///
/// impl CustomCurve for Smooth {
///     #[inline(always)]
///     fn over_slip<N: CurveNumber>(&self, slip: N) -> OverSlip<N> {
///         let value = slip.constant(self.coefficient) / (slip + self.slip);
///         let none = slip.constant(0.0);
///         let slope = value * self.slip / (slip + self.slip);
///         OverSlip { value, slope, by_pressure: none, by_entrainment: None }
///     }
/// }
///
/// impl CustomLaw for Smooth {
///     type Curve = Self;
///     fn under(&self, _: &Conditions) -> Self {
///         *self
///     }
/// }
///
/// let law = Law::custom(Smooth { coefficient: 0.1, slip: 0.02 });
/// ```
pub trait CustomLaw: Debug + Send + Sync + 'static {
    /// The curve of one contact.
    type Curve: CustomCurve;

    /// The curve under the conditions of a contact, made once for all of its nodes. The size of the ellipse, which they
    /// hold too, has no slopes: what depends on it is differentiated as if it stayed.
    fn under(&self, conditions: &Conditions) -> Self::Curve;

    /// Pressures between which the law is supported by data, Pa.
    fn valid_pressure(&self) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }
}

/// Any [`CustomLaw`].
#[derive(Debug, Clone)]
pub struct OwnLaw(Arc<dyn Integrated>);

impl OwnLaw {
    pub(crate) fn new(law: impl CustomLaw) -> Self {
        Self(Arc::new(law))
    }

    /// κ/s with its slopes.
    pub(crate) fn over_slip(&self, slip: f64, conditions: &Conditions) -> OverSlip {
        self.0.over_slip(slip.max(AT_REST), conditions)
    }

    pub(crate) fn valid_pressure(&self) -> [f64; 2] {
        self.0.pressures()
    }

    pub(crate) fn traction(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> PatchTraction {
        self.0.traction(contact, unit, fast)
    }

    pub(crate) fn derivative(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> PatchDerivative {
        self.0.derivative(contact, unit, fast)
    }
}

/// Slip that a body at rest is taken to have.
const AT_REST: f64 = 1e-140;

/// A law with the integrals that are compiled for it: one call a patch is by reference, none a node.
trait Integrated: Debug + Send + Sync {
    fn over_slip(&self, slip: f64, conditions: &Conditions) -> OverSlip;
    fn pressures(&self) -> [f64; 2];
    fn traction(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> PatchTraction;
    fn derivative(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> PatchDerivative;
}

impl<L: CustomLaw> Integrated for L {
    fn over_slip(&self, slip: f64, conditions: &Conditions) -> OverSlip {
        self.under(conditions).over_slip(slip)
    }

    fn pressures(&self) -> [f64; 2] {
        self.valid_pressure()
    }

    fn traction(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> PatchTraction {
        let scale = unit.scale(contact.rolling_speed);
        fast.traction_of((&contact.patch, &contact.motion), scale, OwnCurve::new(self, contact, scale))
    }

    fn derivative(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> PatchDerivative {
        let scale = unit.scale(contact.rolling_speed);
        let scales = (scale, scale_slope(unit, contact.rolling_speed));
        fast.derivative_of((&contact.patch, &contact.motion), scales, OwnCurve::new(self, contact, scale))
    }
}

/// A curve of one's own over the sliding speed.
struct OwnCurve<C> {
    curve: C,
    /// λ, slip over sliding speed, s/m.
    scale: f64,
    /// Pa.
    pressure: f64,
    /// Sign of the rolling speed.
    sense: f64,
}

impl<C: CustomCurve> OwnCurve<C> {
    fn new(law: &impl CustomLaw<Curve = C>, contact: &MovingPatch, scale: f64) -> Self {
        let MovingPatch { patch, rolling_speed, .. } = *contact;
        let pressure = patch.peak_pressure;
        let curve = law.under(&Conditions { pressure, entrainment_speed: rolling_speed.abs(), patch });
        Self { curve, scale, pressure, sense: rolling_speed.signum() }
    }
}

impl<C: CustomCurve> LaneCurve for OwnCurve<C> {
    const ENTRAINED: bool = true;

    #[inline(always)]
    fn over_slip<S: Simd>(&self, speed: Lanes<S>) -> Lanes<S> {
        self.curve.over_slip(Eight(speed * self.scale)).value.0
    }

    #[inline(always)]
    fn slopes<S: Simd>(&self, speed: Lanes<S>) -> Slopes<S> {
        let at = self.curve.over_slip(Eight(speed * self.scale));
        Slopes {
            over_slip: at.value.0,
            bend: (at.slope - at.value).0,
            by_pressure: at.by_pressure.0 * self.pressure,
            by_entrainment: at.by_entrainment.map(|Eight(slope)| slope * self.sense),
        }
    }
}

/// Eight doubles.
#[derive(Clone, Copy)]
struct Eight<S: Simd>(Lanes<S>);

macro_rules! operators {
    ($($operator:ident $method:ident $sign:tt),*) => {$(
        impl<S: Simd> $operator for Eight<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $sign other.0)
            }
        }

        impl<S: Simd> $operator<f64> for Eight<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                Self(self.0 $sign other)
            }
        }
    )*};
}

operators!(Add add +, Sub sub -, Mul mul *, Div div /);

impl<S: Simd> Neg for Eight<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Simd> CurveNumber for Eight<S> {
    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        Self(Lanes::splat(self.0.token(), value))
    }

    #[inline(always)]
    fn fused(self, b: Self, c: Self) -> Self {
        Self(fused(self.0, b.0, c.0))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    fn exp(self) -> Self {
        Self(elementary::exp(self.0))
    }

    #[inline(always)]
    fn exp_m1(self) -> Self {
        Self(elementary::exp_m1(self.0))
    }

    #[inline(always)]
    fn ln(self) -> Self {
        Self(elementary::ln(self.0))
    }

    #[inline(always)]
    fn max(self, least: f64) -> Self {
        Self(self.0.max(least))
    }

    #[inline(always)]
    fn min(self, most: f64) -> Self {
        Self(self.0.min(most))
    }

    #[inline(always)]
    fn below(self, limit: f64, then: Self, otherwise: Self) -> Self {
        Self(self.0.simd_lt(limit).select(then.0, otherwise.0))
    }

    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        let mut lanes = [0.0; LANES];
        for (result, &x) in lanes.iter_mut().zip(self.0.as_slice()) {
            *result = function(x);
        }
        Self(Lanes::simd_from(self.0.token(), lanes))
    }
}

impl CurveNumber for f64 {
    fn constant(self, value: f64) -> Self {
        value
    }

    fn fused(self, b: Self, c: Self) -> Self {
        self.mul_add(b, c)
    }

    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }

    fn exp(self) -> Self {
        Self::exp(self)
    }

    fn exp_m1(self) -> Self {
        Self::exp_m1(self)
    }

    fn ln(self) -> Self {
        Self::ln(self)
    }

    fn max(self, least: f64) -> Self {
        Self::max(self, least)
    }

    fn min(self, most: f64) -> Self {
        Self::min(self, most)
    }

    fn below(self, limit: f64, then: Self, otherwise: Self) -> Self {
        if self < limit { then } else { otherwise }
    }

    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        function(self)
    }
}

#[cfg(test)]
mod tests;
