//! The elastic patch: traction under surfaces that give way tangentially, by Kalker's simplified theory (FASTSIM).
//!
//! # Equations
//! ```text
//! u = L q                                          (displacement of ball against race, traction on the ball)
//! s = Δv + V ∂u/∂x,   q = −κ(|s|) p s/|s|                          (true slip, along each strip from the leading edge)
//! L_x = 8b/(3 C11 G),   L_y from 8b/(3 C22 G) and πb²/(4 c C23 G)      (Kalker's slopes at small creep)
//! T = ∬ q dA,   M = ∬ P × q dA,   power = ∬ κ p |s| dA,   wear integral = ∬ p |s| dA
//! ```
//! x is along rolling, V the mean speed of both surfaces through the contact, Δv the rigid slip of
//! [`crate::RelativeMotion`] with spin and differential slip, b the semi-axis along rolling and c² the product of both.
//! Where q needs less than the law allows the surfaces stick, s = 0 or nearly so, and q grows as −Δv/(L V) from the
//! leading edge.
//!
//! Source: J. J. Kalker, A fast algorithm for the simplified theory of rolling contact, Vehicle System Dynamics 11
//! (1982) 1, doi:10.1080/00423118208968684; the coefficients from his book of 1990, doi:10.1007/978-94-015-7889-9.
//!
//! # Departures
//! - The bound is κ p with the pressure of Hertz, not the parabola that goes with the simplified theory: spin moments
//!   are 10–17 % off with the parabola.
//! - Two flexibilities, L_x and L_y, the latter weighted by the squares of lateral creep and spin. With Kalker's three
//!   the rigid slip itself is weighted, and sliding turns away from its true direction; with one of all three, the
//!   direction is kept but F_y in spin is 2.8 % of the friction bound off instead of 2.2 %. F_x keeps Kalker's slope in
//!   every mixture.
//! - The curve is taken at the true slip, so a cell is an equation for σ = |s|:
//!   Σ (s_t,k/(σ + C_k κ(σ)))² = 1, with s_t the slip that it would have without traction. See [`Fastsim`].
//! - A falling κ(σ) makes that equation ambiguous, and the strip's differential equation without a bounded solution,
//!   unless friction takes some path to fall. It is given twice the shortest that makes the root unique in every cell,
//!   however fine (twice, so that the root's derivative is bounded too): with d = 1 − κ/K_m the share lost beyond the
//!   peak, d_i = r Σ_j A_j d_(i−j) + (1 − r) d(σ_i), r = m/(m + k), m = 2 C max(−dκ/dσ), a memory over the length
//!   2 V L p max(−dκ/dσ); A and k are the difference's of [`Fastsim`]. At the leading edge d is that of the rigid slip
//!   there, so that sliding everywhere is the rigid patch. Rising curves and Coulomb's law have no memory. On the
//!   contacts of the tests (silver, 22 and 100 per m/s) doubling the length changes no force by more than 1.1e-3 of the
//!   load.
//!
//! # Validity
//! Steady rolling: the slip must not change much while material passes, in 2b/V. There is no state that Cattaneo's
//! problem, shear without rolling, would need: at V = 0 the patch is the rigid one. Ellipses small against the radii,
//! bodies of like elastic constants. Against exact half-spaces (CONTACT) at Coulomb friction: forces within 2.7 % of
//! the friction bound μQ and spin moments within 4.1 % of μQ c on the contact of `fixtures/reference/contact25`, 2.9 %
//! and 4.4 % on an ellipse twice as long along rolling. Against strip theory in pure longitudinal creep F_x is up to
//! 2.2 % of μQ high at half the bound and 6.3 % low just below full sliding (a test holds both): a tail of adhesion
//! remains at the leading edge that exact theory does not have.
//!
//! Frictional power is that of the true slip and never negative. In the limit of fine cells it is the power of forces
//! and moments on the rigid motion ([`crate::PatchTraction::work_on`], curved arm), since q vanishes at both ends of a
//! strip.
//!
//! Results are continuous in load and motion but for V = 0, where the leading edge changes ends: there they jump by the
//! error that the rule has on a rigid patch (at 6 cells up to 3e-4 of the load, at 24 up to 8e-5).

mod across;
mod cell;
mod choose;
mod elasticity;
mod fast;
mod fastsim;
mod grid;
mod kalker;

pub use choose::{ElasticProbe, choose_fastsim_rule, fastsim_rule_error};
pub use elasticity::{Flexibility, TangentialElasticity};
pub use fast::{fast_elastic_patch_traction, linear_elastic_patch_traction};
pub use fastsim::elastic_patch_traction;
pub use grid::{Fastsim, FastsimRule};
pub use kalker::{CreepCoefficients, KalkerCoefficients};
