#![doc = include_str!("../README.md")]

mod chebyshev;
mod choose;
mod coating;
mod elastic;
mod fast;
mod film;
mod kragelskii;
mod law;
mod own;
mod patch;
mod quadrature;
mod settings;
mod strips;
mod varying;

pub use choose::{Probe, REFERENCE_RULE, RuleUse, choose_rule, rule_error};
pub use coating::{Coating, TestedCurve, coating_names};
pub use elastic::{
    CreepCoefficients, ElasticProbe, Fastsim, FastsimRule, Flexibility, KalkerCoefficients, TangentialElasticity,
    choose_fastsim_rule, elastic_patch_traction, fast_elastic_patch_traction, fastsim_rule_error,
    linear_elastic_patch_traction,
};
pub use fast::{FastPatch, PatchDerivative, fast_patch_traction, linear_patch_traction};
pub use film::{FilmLaw, FilmShear, FilmState, FilmStress, FilmTemperature, STEEL_HYSTERESIS, asperity_share};
pub use kragelskii::{Fall, Kragelskii, Peak, SlipCurve};
pub use law::{Law, LawCurve};
pub use own::{CurveNumber, CustomCurve, CustomLaw, OverSlip, OwnLaw};
pub use patch::{MovingPatch, Patch, PatchLaw, PatchTraction, RelativeMotion, SlipField, patch_traction};
pub use quadrature::Quadrature;
pub use settings::{PatchChoice, PatchRule, PressureChoice, SlipUnit};
pub use tribodyn_contact::Scalar;
pub use varying::{CoatingLaw, Conditions, PressureFit, TractionLaw};

/// Faults in traction data or a patch rule.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TractionError {
    /// Peak data that no Kragelskii curve has.
    #[error(
        "no curve has peak slip {slip}, peak coefficient {coefficient} and residual coefficient {residual}: the peak coefficient must exceed the residual one, which must exceed 0, at a peak slip above 0"
    )]
    Peak {
        /// Peak slip.
        slip: f64,
        /// Peak coefficient.
        coefficient: f64,
        /// Residual coefficient.
        residual: f64,
    },
    /// A polynomial that leaves the curves.
    #[error(
        "polynomials of order {order} leave the curves at {pressure_gpa:.3} GPa: peak slip {slip:.4}, peak coefficient {coefficient:.5}, residual coefficient {residual:.5}"
    )]
    FitNotACurve {
        /// Order of the polynomials.
        order: usize,
        /// Pressure, GPa.
        pressure_gpa: f64,
        /// Peak slip there.
        slip: f64,
        /// Peak coefficient there.
        coefficient: f64,
        /// Residual coefficient there.
        residual: f64,
    },
    /// Fewer tests than the polynomial has coefficients.
    #[error("polynomials of order {order} need {needed} tested pressures, got {count}")]
    TooFewTests {
        /// Order asked for.
        order: usize,
        /// Tests given.
        count: usize,
        /// Tests needed.
        needed: usize,
    },
    /// A coating without data.
    #[error("a coating needs at least one tested pressure")]
    NoTests,
    /// A coating that the library does not have.
    #[error("unknown coating \"{name}\": allowed are {known}")]
    UnknownCoating {
        /// The name.
        name: String,
        /// The names that exist.
        known: String,
    },
    /// A rule without points.
    #[error("a patch rule needs at least one point in each direction")]
    NoPoints,
    /// A shear modulus that no body has.
    #[error("shear modulus is {value} Pa: it must be finite and above 0")]
    ShearModulus {
        /// The modulus given, Pa.
        value: f64,
    },
    /// A Poisson's ratio outside the table of creep coefficients.
    #[error("Poisson's ratio is {value}: it must lie between 0 and 0.5")]
    PoissonRatio {
        /// The ratio given.
        value: f64,
    },
    /// A target finer than the finest rule.
    #[error("no patch rule reaches a relative error of {target:e}: the finest has {reached:e}")]
    TargetNotReached {
        /// Error asked for.
        target: f64,
        /// Error reached.
        reached: f64,
    },
}
