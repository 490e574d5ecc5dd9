//! Traction of solid lubricants: the Kragelskii curve with pressure-varying parameters and its integral over a
//! contact patch with spin, lateral and differential (Heathcote) slip.
//!
//! # Equations
//! ```text
//! κ(s) = (A + B s) exp(−C s) + D,   D = −A                                        (curve, Eq. 1)
//! S_m, K_m, K = polynomials in p;   e^(−x)/(x−1) = (K_m−K)/K,  C = x/S_m,  B = K C/(x−1)      (Eq. 2)
//! Δv_x = W_x + w_y h(y) − w_n y,    Δv_y = W_y − w_x h(y) + w_n x,   h = r_b − y²/(2R_c)       (Eqs. 3–5)
//! T = −∬ κ(|Δv|) p Δv/|Δv| dA,      M = ∬ P × dT,   power = ∬ κ p |Δv| dA,  wear integral = ∬ p |Δv| dA
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s | slip, in the [`SlipUnit`] of the coating's data | its own |
//! | κ, K_m, K | traction coefficient, its peak, its value at infinite slip | – |
//! | S_m | slip at the peak | unit of s |
//! | p | contact pressure | Pa |
//! | x, y, n | along rolling, across the groove, outward normal | m |
//! | W, w | velocity and angular velocity of the ball against the race | m/s, rad/s |
//! | r_b, R_c | ball radius, radius of the deformed contact across the groove | m |
//! | T, M | traction on the ball, its moment about the ball centre | N, N m |
//!
//! Sources: Zhang et al., Lubricants 2025, 13(8), 352, doi:10.3390/lubricants13080352 (curve, coatings, patch rule);
//! Heathcote's differential slip as in its Eq. 4.
//!
//! Limits: Hertz pressure, sliding friction at each point by its own slip (the rigid patch: no tangential elasticity), no
//! heating. The built-in data hold in liquid nitrogen at 2.5–3.5 GPa and are extrapolated between 1.5 and 4 GPa.
//!
//! # Elastic bodies
//! [`elastic_patch_traction`] lets the surfaces give way tangentially (Kalker's simplified theory, FASTSIM): below a creep
//! of about 2e-3 the rigid patch has too much traction, and no lateral force by spin. [`fast_elastic_patch_traction`] and
//! [`Fastsim::derivative`] are its counterparts in vector instructions.
//!
//! The crate does not know what a bearing is: it sees one patch and one relative motion.
//!
//! # Two ways through the integral
//! [`patch_traction`] is generic over the scalar, dual numbers included, and over the law: the reference. [`FastPatch`]
//! sums the same nodes in double precision with vector instructions, for Kragelskii curves taken at the peak pressure,
//! and agrees to 1e-12; it also has the derivatives in closed form. [`fast_patch_traction`] picks between the two.
//!
//! # A law of one's own
//! The integral takes any [`TractionLaw`]; Coulomb friction shows what is needed.
//! ```
//! use tribodyn_traction::{
//!     MomentArm, Patch, PatchLaw, PatchRule, PressureChoice, Quadrature, RelativeMotion, Scalar, SlipCurve, SlipUnit,
//!     TractionLaw, patch_traction,
//! };
//!
//! #[derive(Clone, Copy)]
//! struct Coulomb(f64);
//!
//! impl<D: Scalar> SlipCurve<D> for Coulomb {
//!     fn over_slip(&self, slip: D) -> D {
//!         if slip.re() > 1e-12 { slip.recip() * self.0 } else { D::zero() }
//!     }
//! }
//!
//! impl TractionLaw for Coulomb {
//!     type Curve<D: Scalar> = Self;
//!     fn at<D: Scalar>(&self, _pressure: D) -> Self {
//!         *self
//!     }
//!     fn clamps(&self, _pressure: f64) -> bool {
//!         false
//!     }
//! }
//!
//! let patch = Patch {
//!     semi_lateral: 4e-3,
//!     semi_rolling: 0.5e-3,
//!     peak_pressure: 2e9,
//!     ball_radius: 0.015,
//!     surface_radius: f64::INFINITY,
//!     moment_arm: MomentArm::Curved,
//! };
//! let motion = RelativeMotion { rolling: 0.2, lateral: 0.0, spin: 0.0, about_lateral: 0.0, about_rolling: 0.0 };
//! let law = PatchLaw { law: &Coulomb(0.1), slip_unit: SlipUnit::MeterPerSecond, pressure: PressureChoice::Peak };
//! let quadrature = Quadrature::new(PatchRule::SplitStrip { across: 8, along: 4 })?;
//! let traction = patch_traction(&patch, &motion, 60.0, &law, &quadrature);
//! let load = 2.0 / 3.0 * std::f64::consts::PI * 2e9 * 4e-3 * 0.5e-3;
//! assert!((traction.force_rolling + 0.1 * load).abs() < 1e-12 * load);
//! # Ok::<(), tribodyn_traction::TractionError>(())
//! ```

mod chebyshev;
mod choose;
mod coating;
mod elastic;
mod fast;
mod kragelskii;
mod law;
mod patch;
mod quadrature;
mod settings;
mod strips;
mod varying;

pub use choose::{Probe, REFERENCE_RULE, choose_rule, rule_error};
pub use coating::{Coating, TestedCurve, coating_names};
pub use elastic::{
    CreepCoefficients, ElasticProbe, Fastsim, FastsimRule, Flexibility, KalkerCoefficients, TangentialElasticity,
    choose_fastsim_rule, elastic_patch_traction, fast_elastic_patch_traction, fastsim_rule_error,
    linear_elastic_patch_traction,
};
pub use fast::{FastPatch, PatchDerivative, fast_patch_traction, linear_patch_traction};
pub use kragelskii::{Fall, Kragelskii, Peak, SlipCurve};
pub use law::{CustomLaw, Law, LawCurve, OverSlip};
pub use patch::{Patch, PatchLaw, PatchTraction, RelativeMotion, SlipField, patch_traction};
pub use quadrature::Quadrature;
pub use settings::{MomentArm, PatchRule, PressureChoice, SlipUnit};
pub use tribodyn_contact::Scalar;
pub use varying::{CoatingLaw, PressureFit, TractionLaw};

/// What can be wrong with traction data or a patch rule.
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
    /// A target error where nodes are needed.
    #[error("a rule by target error must be chosen for contacts before its nodes exist")]
    RuleNotChosen,
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
