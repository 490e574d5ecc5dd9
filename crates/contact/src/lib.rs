//! (filled by the contact work)
use num_dual::DualNum;

/// A real number or a dual number over `f64`: the physics is written once and differentiated exactly.
pub trait Scalar: DualNum<Primitive = f64> + Copy {}
impl<T: DualNum<Primitive = f64> + Copy> Scalar for T {}
