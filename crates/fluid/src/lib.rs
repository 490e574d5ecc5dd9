//! Properties of liquid nitrogen, oxygen and methane from their reference equations, the drag and churning that such a
//! fluid exerts on a bearing ball, and the drag of its film between a cage and the land that guides it.
//!
//! # Equations
//! ```text
//! p = ρ R T (1 + δ ∂α/∂δ),   δ = ρ/ρ_c,  τ = T_c/T
//! α(τ, δ) = Σ n δ^d τ^t exp(−δ^l [l > 0]) + Σ n δ^d τ^t exp(−η(δ−1)² − β(τ−γ)²)     (residual Helmholtz energy)
//! μ(T, ρ) = μ_0(T) + μ_r(T, ρ)                                                       (dilute gas + residual)
//! F_d = ½ C_d ρ_e A v|v|,     ρ_e = X ρ_liquid + (1−X) ρ_gas,   A = (πD²/4)(1 − shaded)
//! M   = ½ ρ ω² r⁵ C_n,        C_n = 3.87/√Re (Re < 3e5), 0.146/Re^0.2 above,  Re = ρ ω r²/μ
//! τ   = max(μ U/c, ½ ρ u² n (ρ u c/μ)^m),   u = U/2,  n = 0.055,  m = −¼,   M_c = 2π R² L τ    (film under a land)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | T, p, ρ | temperature, pressure, density | K, Pa, kg/m³ |
//! | R | specific gas constant (molar gas constant over molar mass) | J/(kg K) |
//! | α | residual Helmholtz energy over R T | – |
//! | μ | dynamic viscosity | Pa s |
//! | F_d, C_d, A, v | drag, its coefficient, frontal area, speed of the ball against the fluid | N, –, m², m/s |
//! | X, ρ_e | volume fraction of liquid, effective density | –, kg/m³ |
//! | M, C_n, ω, r | churning moment, its coefficient, spin of the ball, ball radius | N m, –, rad/s, m |
//! | τ, U, c | shear stress of the film, relative speed of its walls, gap | Pa, m/s, m |
//! | M_c, R, L | torque on the cage, radius and width of the land | N m, m, m |
//!
//! # Sources
//! - Nitrogen: Span, Lemmon, Jacobsen, Wagner, Yokozeki 2000, doi:10.1063/1.1349047.
//! - Oxygen: Schmidt, Wagner 1985, doi:10.1016/0378-3812(85)87016-3.
//! - Methane: Setzmann, Wagner 1991, doi:10.1063/1.555898.
//! - Viscosity of nitrogen and oxygen: Lemmon, Jacobsen 2004, doi:10.1023/B:IJOT.0000022327.04529.f3.
//! - Viscosity of methane: Quiñones-Cisneros, Deiters 2006, doi:10.1021/jp0618577.
//! - Churning: Schlichting, Gersten, Boundary-Layer Theory, 9th ed., doi:10.1007/978-3-662-52919-5 (rotating disk);
//!   Gupta, Advanced Dynamics of Rolling Elements, Springer 1984, doi:10.1007/978-1-4612-5276-4 (use in bearings).
//! - Film under a land: Hirs 1973, doi:10.1115/1.3451752.
//!
//! # Limits of validity
//! [`Fluid::state`] answers for the liquid between the triple point and 0.95 T_c, from saturation or above up to the
//! melting pressure, at most 30 MPa. The viscosities are good to 2 % (nitrogen) and 5 % (oxygen) by their authors' own
//! estimate. Drag and churning are those of a single ball in an unbounded fluid. The film under a land is concentric, smooth-walled,
//! without flow along the axis and without swirl of its own.
//!
//! # What the crate does not know
//! Bearings, cages, the flow between the rings (swirl, liquid fraction and drag coefficient are inputs), boiling in the
//! contacts, heat.

mod annulus;
mod churning;
mod drag;
mod fluid;
mod helmholtz;
mod lemmon_jacobsen2004;
mod quinones_cisneros2006;
mod schmidt_wagner1985;
mod setzmann_wagner1991;
mod span2000;

pub use annulus::AnnulusDrag;
pub use churning::{Churning, TRANSITION_REYNOLDS, Transition};
pub use drag::{BallDrag, effective_density, frontal_area};
pub use fluid::{Fluid, FluidState, MAX_PRESSURE, Saturation};

use num_dual::DualNum;

/// What the formulas compute with: `f64` or a dual number over it.
pub trait Scalar: DualNum<Primitive = f64> + Copy {}
impl<T: DualNum<Primitive = f64> + Copy> Scalar for T {}

/// Why a fluid state cannot be given.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FluidError {
    /// Temperature outside the range of the liquid.
    #[error(
        "{fluid} at {temperature} K is outside {min} to {max} K (triple point to 0.95 of the critical {critical} K)"
    )]
    Temperature {
        /// Which fluid.
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
        /// Which fluid.
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
        /// Which fluid.
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
        /// Which fluid.
        fluid: Fluid,
        /// Pressure asked for, Pa.
        pressure: f64,
        /// Highest pressure, Pa.
        max: f64,
    },
    /// The density iteration did not settle.
    #[error("{fluid} at {temperature} K and {pressure} Pa: no density found in {iterations} iterations")]
    Density {
        /// Which fluid.
        fluid: Fluid,
        /// Temperature, K.
        temperature: f64,
        /// Pressure, Pa.
        pressure: f64,
        /// Newton steps made.
        iterations: usize,
    },
}
