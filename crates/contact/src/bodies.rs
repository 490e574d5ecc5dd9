//! The two bodies of a contact: elastic constants and principal radii.

use crate::ContactError;

/// Isotropic linear elasticity of one body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticBody {
    /// Young's modulus, Pa.
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

impl ElasticBody {
    /// (1 − ν²)/E, 1/Pa; zero for a rigid body (infinite modulus).
    pub fn compliance(&self) -> f64 {
        (1.0 - self.poisson) * (1.0 + self.poisson) / self.young
    }
}

/// Effective modulus E' = 2/[(1−ν1²)/E1 + (1−ν2²)/E2], Pa (twice the contact modulus E* of other authors).
pub fn effective_modulus(a: &ElasticBody, b: &ElasticBody) -> f64 {
    2.0 / (a.compliance() + b.compliance())
}

/// Principal radii of a body at the contact point, m: positive where convex, negative where concave, infinite where
/// flat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// In the body's x plane, m.
    pub radius_x: f64,
    /// In the body's y plane, m.
    pub radius_y: f64,
}

/// Principal curvatures of the gap between two bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeCurvatures {
    /// Along the principal direction next to the first body's x axis, 1/m.
    pub x: f64,
    /// Along the other one, 1/m.
    pub y: f64,
    /// Angle of the first of these from the first body's x axis towards its y axis, rad, within ±π/4.
    pub rotation: f64,
}

/// Principal curvatures of the gap between two bodies whose x axes make `angle` (rad, from the first body's x towards
/// its y). At angle 0 they are the sums 1/r1x + 1/r2x and 1/r1y + 1/r2y.
///
/// The gap's curvature matrix diag(1/r1) + T(angle) diag(1/r2) Tᵀ is diagonalised by one Jacobi rotation. Sums of two
/// curvatures are formed as (r1 + r2)/(r1 r2), so that nearly conforming bodies lose no digits.
///
/// # Errors
/// [`ContactError::Radius`] for a radius that is zero or NaN, [`ContactError::Angle`] for an angle that is not finite.
/// A result that is not positive is no error here: it is one of [`crate::HertzContact::new`].
pub fn relative_curvatures(first: &Body, second: &Body, angle: f64) -> Result<RelativeCurvatures, ContactError> {
    check(first, "the first body")?;
    check(second, "the second body")?;
    if !angle.is_finite() {
        return Err(ContactError::Angle { value: angle });
    }
    let (sin, cos) = angle.sin_cos();
    let (s, c) = (sin * sin, cos * cos);
    let mix = |radius, other, crossed| c * sum(radius, other) + s * sum(radius, crossed);
    let xx = mix(first.radius_x, second.radius_x, second.radius_y);
    let yy = mix(first.radius_y, second.radius_y, second.radius_x);
    let xy = sin * cos * sum(second.radius_x, -second.radius_y);
    let tangent = if xy == 0.0 {
        0.0
    } else {
        let t = (xx - yy) / (2.0 * xy);
        1f64.copysign(t) / (t.abs() + t.hypot(1.0))
    };
    Ok(RelativeCurvatures { x: xx + tangent * xy, y: yy - tangent * xy, rotation: tangent.atan() })
}

fn check(body: &Body, name: &'static str) -> Result<(), ContactError> {
    for (plane, value) in [("x", body.radius_x), ("y", body.radius_y)] {
        if value == 0.0 || value.is_nan() {
            return Err(ContactError::Radius { body: name, plane, value });
        }
    }
    Ok(())
}

/// 1/r1 + 1/r2: the sum of near opposites is exact, the sum of their reciprocals is not.
fn sum(r1: f64, r2: f64) -> f64 {
    if r1.is_finite() && r2.is_finite() { (r1 + r2) / r1 / r2 } else { r1.recip() + r2.recip() }
}
