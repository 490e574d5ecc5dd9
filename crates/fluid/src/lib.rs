#![doc = include_str!("../README.md")]

mod annulus;
mod cage;
mod churning;
mod drag;
mod fluid;
mod helmholtz;
mod lemmon_jacobsen2004;
mod phase;
mod quinones_cisneros2006;
mod schmidt_wagner1985;
mod setzmann_wagner1991;
mod short_bearing;
mod span2000;
mod squeeze;

pub use annulus::AnnulusDrag;
pub use cage::{CageChurning, CageMoments, cylinder_coefficient};
pub use churning::{Churning, TRANSITION_REYNOLDS, Transition};
pub use drag::{BallDrag, effective_density, frontal_area, sphere_drag_coefficient};
pub use fluid::{Fluid, FluidState, MAX_PRESSURE, Saturation};
pub use phase::{HeatedFlow, MAX_TEMPERATURE, Phase};
pub use short_bearing::{FilmExtent, FilmMotion, ShortBearing};
pub use squeeze::SqueezeFilm;

use num_dual::DualNum;

/// The scalar of the formulas: `f64` or a dual number over it.
pub trait Scalar: DualNum<Primitive = f64> + Copy {}
impl<T: DualNum<Primitive = f64> + Copy> Scalar for T {}

/// Errors of a fluid state.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FluidError {
    /// Temperature outside the range of the liquid.
    #[error(
        "{fluid} at {temperature} K is outside {min} to {max} K (triple point to 0.95 of the critical {critical} K)"
    )]
    Temperature {
        /// Name of the fluid.
        fluid: Fluid,
        /// Temperature asked for, K.
        temperature: f64,
        /// Lowest temperature, the triple point, K.
        min: f64,
        /// Highest temperature, K.
        max: f64,
        /// Critical temperature, K.
        critical: f64,
    },
    /// Pressure below saturation: the fluid would boil.
    #[error(
        "{fluid} at {temperature} K and {pressure} Pa is not liquid: the pressure must be at least the saturation \
         pressure, {saturation} Pa"
    )]
    Vapour {
        /// Name of the fluid.
        fluid: Fluid,
        /// Temperature asked for, K.
        temperature: f64,
        /// Pressure asked for, Pa.
        pressure: f64,
        /// Saturation pressure at this temperature, Pa.
        saturation: f64,
    },
    /// Pressure above melting: the fluid would be solid.
    #[error(
        "{fluid} at {temperature} K and {pressure} Pa is not liquid: the pressure must be at most the melting \
         pressure, {melting} Pa"
    )]
    Solid {
        /// Name of the fluid.
        fluid: Fluid,
        /// Temperature asked for, K.
        temperature: f64,
        /// Pressure asked for, Pa.
        pressure: f64,
        /// Melting pressure at this temperature, Pa.
        melting: f64,
    },
    /// Pressure above what this crate is checked for, or not a number.
    #[error("{fluid} at {pressure} Pa: the pressure must be a number up to {max} Pa")]
    Pressure {
        /// Name of the fluid.
        fluid: Fluid,
        /// Pressure asked for, Pa.
        pressure: f64,
        /// Highest pressure, Pa.
        max: f64,
    },
    /// The density iteration did not settle.
    #[error("{fluid} at {temperature} K and {pressure} Pa: no density found in {iterations} iterations")]
    Density {
        /// Name of the fluid.
        fluid: Fluid,
        /// Temperature, K.
        temperature: f64,
        /// Pressure, Pa.
        pressure: f64,
        /// Newton steps made.
        iterations: usize,
    },
}
