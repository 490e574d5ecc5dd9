//! The lanes that the kernels work in: eight doubles, in one register, two or four as the processor has them.

use fearless_simd::{Level, SimdFloatElement, f32x8, f32x16, f64x8, mask64x8, prelude::*};

pub(crate) const LANES: usize = 8;
pub(crate) type Lanes<S> = f64x8<S>;
pub(crate) type Mask<S> = mask64x8<S>;
/// One and two lots of lanes in single precision.
pub(crate) type Singles<S> = f32x8<S>;
pub(crate) type Pairs<S> = f32x16<S>;

/// Numbers whose products can be added with one rounding.
pub(crate) trait Fuse: SimdFloatElement {
    fn fused(self, b: Self, c: Self) -> Self;
}

impl Fuse for f64 {
    fn fused(self, b: Self, c: Self) -> Self {
        if cfg!(target_arch = "wasm32") { self * b + c } else { self.mul_add(b, c) }
    }
}

impl Fuse for f32 {
    fn fused(self, b: Self, c: Self) -> Self {
        if cfg!(target_arch = "wasm32") { self * b + c } else { self.mul_add(b, c) }
    }
}

/// a b + c, rounded once: the same bits from processors that have it as one instruction and from those that have not,
/// on which a patch takes ten to twenty times as long. WebAssembly has no such instruction on any processor: there the
/// product is rounded too, and bits differ from those of other targets.
#[inline(always)]
pub(crate) fn fused<S: Simd, V: SimdFloat<S, Element: Fuse>>(
    a: V,
    b: impl SimdInto<V, S>,
    c: impl SimdInto<V, S>,
) -> V {
    let simd = a.token();
    if cfg!(target_arch = "wasm32") {
        a * b.simd_into(simd) + c.simd_into(simd)
    } else if has_fused(simd.level()) {
        a.mul_add(b, c)
    } else {
        let mut sum: V = c.simd_into(simd);
        one_by_one(a.as_slice(), b.simd_into(simd).as_slice(), sum.as_mut_slice());
        sum
    }
}

/// Known when a kernel is compiled.
#[inline(always)]
#[allow(unused_variables, reason = "of processors that are not asked for")]
fn has_fused(level: Level) -> bool {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let has = level.as_avx2().is_some();
    #[cfg(target_arch = "aarch64")]
    let has = level.as_neon().is_some();
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
    let has = false;
    has
}

#[inline(never)]
fn one_by_one<E: Fuse>(a: &[E], b: &[E], c: &mut [E]) {
    for ((&a, &b), c) in a.iter().zip(b).zip(c) {
        *c = a.fused(b, *c);
    }
}

/// [`total`] of each: a loop, where the compiler would not draw the closure of a map into the vector code.
#[inline(always)]
pub(crate) fn totals<S: Simd, const N: usize>(sums: &[Lanes<S>; N]) -> [f64; N] {
    let mut totals = [0.0; N];
    for (total_of, &sum) in totals.iter_mut().zip(sums) {
        *total_of = total(sum);
    }
    totals
}

/// Sum of the lanes, in an order that no vector width changes.
#[inline(always)]
pub(crate) fn total<S: Simd>(v: Lanes<S>) -> f64 {
    let (low, high) = v.split();
    let (first, second) = (low + high).split();
    let sums = first + second;
    sums[0] + sums[1]
}
