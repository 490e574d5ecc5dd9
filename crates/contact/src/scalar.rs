//! The numbers that the formulas are written in: `f64`, with the feature `dual` dual numbers too, and a value with its
//! slope.

#[cfg(not(feature = "dual"))]
use std::ops::SubAssign;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub};

#[cfg(feature = "dual")]
use num_dual::{DualNum, DualStruct};

/// A real number or a dual number over `f64`: the physics is written once and differentiated exactly.
#[cfg(feature = "dual")]
pub trait Scalar: DualNum<Primitive = f64> + Copy {}
#[cfg(feature = "dual")]
impl<T: DualNum<Primitive = f64> + Copy> Scalar for T {}

/// A real number; with the feature `dual` a dual number over `f64` too, so that the physics is differentiated exactly.
#[cfg(not(feature = "dual"))]
pub trait Scalar: Real + Sub<f64, Output = Self> + Div<f64, Output = Self> + SubAssign {}
#[cfg(not(feature = "dual"))]
impl Scalar for f64 {}

/// The arithmetic of the formulas.
pub trait Real:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Mul<f64, Output = Self>
    + AddAssign
    + MulAssign
{
    /// Order of the derivatives that it carries.
    const NDERIV: usize;
    /// Zero.
    fn zero() -> Self {
        Self::from(0.0)
    }
    /// One.
    fn one() -> Self {
        Self::from(1.0)
    }
    /// Its real part.
    fn re(&self) -> f64;
    /// Square root.
    fn sqrt(&self) -> Self;
    /// Cube root.
    fn cbrt(&self) -> Self;
    /// Reciprocal.
    fn recip(&self) -> Self;
}

#[cfg(feature = "dual")]
impl<T: DualNum<Primitive = f64> + Copy> Real for T {
    const NDERIV: usize = <T as DualNum>::NDERIV;
    fn re(&self) -> f64 {
        DualStruct::re(self)
    }
    fn sqrt(&self) -> Self {
        DualNum::sqrt(self)
    }
    fn cbrt(&self) -> Self {
        DualNum::cbrt(self)
    }
    fn recip(&self) -> Self {
        DualNum::recip(self)
    }
}

#[cfg(not(feature = "dual"))]
impl Real for f64 {
    const NDERIV: usize = 0;
    fn re(&self) -> f64 {
        *self
    }
    fn sqrt(&self) -> Self {
        f64::sqrt(*self)
    }
    fn cbrt(&self) -> Self {
        f64::cbrt(*self)
    }
    fn recip(&self) -> Self {
        f64::recip(*self)
    }
}

/// A value with its slope: what Newton's method needs of a function of one number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sloped {
    pub value: f64,
    pub slope: f64,
}

impl Sloped {
    /// f(x) with f'(x) by the chain rule.
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, slope: self.slope * slope }
    }
}

impl From<f64> for Sloped {
    fn from(value: f64) -> Self {
        Self { value, slope: 0.0 }
    }
}

impl Add for Sloped {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Sloped {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl Mul for Sloped {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, slope: self.slope * other.value + other.slope * self.value }
    }
}

impl Div for Sloped {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let inverse = other.value.recip();
        let slope = (self.slope * other.value - other.slope * self.value) * inverse * inverse;
        Self { value: self.value * inverse, slope }
    }
}

impl Neg for Sloped {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Add<f64> for Sloped {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        Self { value: self.value + other, ..self }
    }
}

impl Mul<f64> for Sloped {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { value: self.value * factor, slope: self.slope * factor }
    }
}

impl AddAssign for Sloped {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl MulAssign for Sloped {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Real for Sloped {
    const NDERIV: usize = 1;
    fn re(&self) -> f64 {
        self.value
    }
    fn sqrt(&self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, root * self.value.recip() * 0.5)
    }
    fn cbrt(&self) -> Self {
        let root = self.value.cbrt();
        self.chain(root, root * self.value.recip() / 3.0)
    }
    fn recip(&self) -> Self {
        let inverse = self.value.recip();
        self.chain(inverse, -inverse * inverse)
    }
}
