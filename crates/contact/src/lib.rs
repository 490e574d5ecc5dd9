//! Hertz point contact of two elastic bodies, from their principal curvatures and elastic constants, and the complete
//! elliptic integrals that it needs.
//!
//! # Equations
//! ```text
//! E'   = 2/[(1−ν1²)/E1 + (1−ν2²)/E2]                        R = 1/(ρx + ρy)
//! F(ρ) = |ρx − ρy|/(ρx + ρy) = [(k²+1) E − 2 K]/[(k²−1) E]   m = 1 − 1/k²
//! a    = (6 k² E Q R/(π E'))^(1/3)                          b = a/k
//! p_max = 3 Q/(2 π a b)                                     p = p_max sqrt(1 − (minor/b)² − (major/a)²)
//! δ    = K (9/(2 E R) · (Q/(π k E'))²)^(1/3)                Q = K_n δ^(3/2)
//! ```
//! The equation for k is solved in the equivalent form ρ_greater/ρ_smaller = k² B/D with the integrals
//! B = (E − m1 K)/m and D = (K − E)/m, m1 = 1/k², neither of which comes from a difference of near values here: the
//! form above loses half its digits near k = 1 (0/0) and again at large k (F → 1).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x, y | rolling direction, lateral direction | m |
//! | ρx, ρy | sums of the two bodies' curvatures in the x and y planes | 1/m |
//! | E1, E2, ν1, ν2 | Young's moduli and Poisson's ratios | Pa, – |
//! | E', R | effective modulus, reciprocal of the curvature sum | Pa, m |
//! | a, b, k = a/b | semi-axes along and across the longer direction, ellipticity | m, m, – |
//! | k' = b/a, m, m1 | axis ratio (complementary modulus), parameter 1 − k'², its complement k'² | – |
//! | K, E (with m) | complete elliptic integrals, first and second kind | – |
//! | Q, δ, K_n | normal load, elastic approach, contact stiffness | N, m, N/m^1.5 |
//! | p_max | peak pressure | Pa |
//!
//! Sources: K. L. Johnson, Contact Mechanics, Cambridge 1985, ch. 4, doi:10.1017/CBO9781139171731; the notation with k,
//! E' and R is that of B. J. Hamrock and D. Brewe, J. Lubr. Technol. 105 (1983) 171, doi:10.1115/1.3254558. The
//! arithmetic-geometric mean and the integrals B and D: NIST Digital Library of Mathematical Functions, sections 19.2
//! and 19.8.
//!
//! Limits: smooth, frictionless, linearly elastic half-spaces, so that the ellipse must be small against the radii of
//! curvature; a close fit (conforming bodies) is computed as if it were. Ellipticity 1 to 10⁴. The relative error is
//! below 1e-14 for ellipticities of 1 to 50 against 40-digit arithmetic (`fixtures/reference/mpmath`). First and higher
//! derivatives are exact with dual numbers, at k = 1 also.
//!
//! The crate does not know what a bearing is, nor friction, lubricant, damping, roughness, plasticity or line contact.

mod bodies;
mod elliptic;
mod hertz;

pub use bodies::{Body, ElasticBody, RelativeCurvatures, effective_modulus, relative_curvatures};
pub use elliptic::{CompleteElliptic, curvature_difference, curvature_ratio};
pub use hertz::{Ellipse, HertzContact, MAX_ELLIPTICITY, MajorAxis, NEGLIGIBLE};

use num_dual::DualNum;

/// A real number or a dual number over `f64`: the physics is written once and differentiated exactly.
pub trait Scalar: DualNum<Primitive = f64> + Copy {}
impl<T: DualNum<Primitive = f64> + Copy> Scalar for T {}

/// What can be wrong with the description of a contact.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// An axis ratio that no ellipse has.
    #[error("axis ratio b/a is {value}: it must be above 0 and at most 1")]
    AxisRatio {
        /// The ratio given.
        value: f64,
    },
    /// A principal radius of a body that is zero or not a number.
    #[error(
        "principal radius {plane} of {body} is {value} m: it must differ from 0, infinity is allowed, concave is negative"
    )]
    Radius {
        /// Which body.
        body: &'static str,
        /// Which plane, `x` or `y`.
        plane: &'static str,
        /// The radius given, m.
        value: f64,
    },
    /// An angle between principal planes that is not finite.
    #[error("angle between the principal planes is {value} rad: it must be finite")]
    Angle {
        /// The angle given, rad.
        value: f64,
    },
    /// A curvature sum that leaves no point contact.
    #[error(
        "curvature sum in the {plane} plane is {value} 1/m: a point contact needs it finite and above 0 (the concave radius larger than the convex one)"
    )]
    Curvature {
        /// Which plane, `x` (rolling) or `y` (lateral).
        plane: &'static str,
        /// The sum given, 1/m.
        value: f64,
    },
    /// An effective modulus that no pair of elastic bodies has.
    #[error("effective modulus is {value} Pa: it must be finite and above 0")]
    Modulus {
        /// The modulus given, Pa.
        value: f64,
    },
    /// Curvatures so unequal that the contact is a line rather than an ellipse.
    #[error(
        "curvature sums {curvature_x} and {curvature_y} 1/m make an ellipse with axes in a ratio above {limit}: that is a line contact"
    )]
    Ellipticity {
        /// Curvature sum in the x plane, 1/m.
        curvature_x: f64,
        /// Curvature sum in the y plane, 1/m.
        curvature_y: f64,
        /// Largest ellipticity taken.
        limit: f64,
    },
}
