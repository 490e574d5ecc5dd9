//! Vectors of three numbers, and rotations of them.

use tribodyn_contact::Scalar;

/// a + b.
#[inline(always)]
pub fn add<D: Scalar>(a: [D; 3], b: [D; 3]) -> [D; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// a · b.
#[inline(always)]
pub fn dot<D: Scalar>(a: [D; 3], b: [D; 3]) -> D {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b.
#[inline(always)]
pub fn cross<D: Scalar>(a: [D; 3], b: [D; 3]) -> [D; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Sum of axes times components.
#[inline(always)]
pub fn sum<D: Scalar>([a, b, c]: &[[D; 3]; 3], v: [D; 3]) -> [D; 3] {
    [0, 1, 2].map(|k| a[k] * v[0] + b[k] * v[1] + c[k] * v[2])
}

/// From a point to another.
#[inline(always)]
pub fn along(from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
}

/// A vector times a number.
#[inline(always)]
pub fn scaled(a: [f64; 3], by: f64) -> [f64; 3] {
    a.map(|value| value * by)
}

/// |a|.
#[inline(always)]
pub fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// The part of a vector across a unit vector.
#[inline(always)]
pub fn across(a: [f64; 3], unit: [f64; 3]) -> [f64; 3] {
    add(a, scaled(unit, -dot(a, unit)))
}

/// A vector turned by a quaternion (x, y, z, w), which need not be of length 1: 2/|q|² (u (u·v) ...) by the products of
/// its vector part u.
#[inline(always)]
pub fn rotated([x, y, z, w]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let u = [x, y, z];
    let twice = scaled(cross(u, v), 2.0 / (dot(u, u) + w * w));
    add(v, add(scaled(twice, w), cross(u, twice)))
}
