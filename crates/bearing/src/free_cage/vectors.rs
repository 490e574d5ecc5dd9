//! Vectors of three numbers.

pub(super) fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// From a point to another.
pub(super) fn along(from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
}

pub(super) fn scaled(a: [f64; 3], by: f64) -> [f64; 3] {
    a.map(|value| value * by)
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) use crate::interaction::cross;

pub(super) fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// The part of a vector across a unit vector.
pub(super) fn across(a: [f64; 3], unit: [f64; 3]) -> [f64; 3] {
    add(a, scaled(unit, -dot(a, unit)))
}

/// A vector turned by a quaternion (x, y, z, w), which need not be of length 1: 2/|q|² (u (u·v) ...) by the products of
/// its vector part u.
pub(super) fn rotated([x, y, z, w]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let u = [x, y, z];
    let twice = scaled(cross(u, v), 2.0 / (dot(u, u) + w * w));
    add(v, add(scaled(twice, w), cross(u, twice)))
}

/// Friction of a coefficient against a sliding velocity under a normal force, N, and the power that it takes, W; below
/// `creep` (m/s) it falls off in proportion.
pub(super) fn friction(coefficient: f64, normal: f64, slip: [f64; 3], creep: f64) -> ([f64; 3], f64) {
    let square = dot(slip, slip);
    let share = coefficient * normal / (square + creep * creep).sqrt();
    (scaled(slip, -share), share * square)
}
