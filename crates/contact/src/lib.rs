#![doc = include_str!("../README.md")]

mod bodies;
mod elliptic;
mod hertz;
mod line;
mod scalar;
mod subsurface;

pub use bodies::{Body, ElasticBody, RelativeCurvatures, effective_modulus, relative_curvatures};
pub use elliptic::{CompleteElliptic, curvature_difference, curvature_ratio};
pub use hertz::{Ellipse, HertzContact, MAX_ELLIPTICITY, MajorAxis, NEGLIGIBLE};
pub use line::LineContact;
pub use scalar::{Real, Scalar};
pub use subsurface::Subsurface;

/// Faults in the description of a contact.
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
        /// Name of the body.
        body: &'static str,
        /// The plane, `x` or `y`.
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
    /// A curvature sum that leaves no contact.
    #[error(
        "curvature sum in the {plane} plane is {value:.4} 1/m: a contact needs it finite and above 0 (the concave \
         radius larger than the convex one)"
    )]
    Curvature {
        /// The plane, `x` (rolling) or `y` (lateral).
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
