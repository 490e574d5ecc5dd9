//! The lanes that the kernels work in: eight doubles, in one register, two or four as the processor has them.

use fearless_simd::{f64x8, mask64x8, prelude::*};

pub(crate) const LANES: usize = 8;
pub(crate) type Lanes<S> = f64x8<S>;
pub(crate) type Mask<S> = mask64x8<S>;

/// Sum of the lanes, in an order that no vector width changes.
#[inline(always)]
pub(crate) fn total<S: Simd>(v: Lanes<S>) -> f64 {
    ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]))
}
