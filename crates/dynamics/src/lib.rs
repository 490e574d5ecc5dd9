//! Transient dynamics of a ball bearing: 6 N_b + 6 degrees of freedom, balls, cage and rings, from a case to samples in
//! time.
//!
//! # Equations
//! Per ball, in its azimuth frame (a, r, t) at the azimuth φ, with N the normal forces, T the tractions, M the moments:
//! ```text
//! axial       m z̈ = N_i sin α_i − N_o sin α_o + T_a + f_a
//! radial      m (r̈ − r ω_m²) = N_i cos α_i − N_o cos α_o + T_r + f_r
//! tangential  m (r ω̇_m + 2 ṙ ω_m) = T_t + N_t + F_cb r_p/r − F_d
//! rotation    J (dΩ/dt + ω_m e_a × Ω) = M_i + M_o + M_churning + M_pocket
//! offset      N_t: part of the normal forces along the orbit where a ring is off centre or its groove not round,
//!             N_t = (1/r)[N_o cos α_o (x_o·e_t) − N_i cos α_i (x_i·e_t) + Σ N d'(φ)] to first order in x/r
//! contact     N = max(0, Q + c δ̇),  c = 2ζ sqrt(m dQ/dδ),  Q = K_n (δ − d)^1.5
//! pocket      F_cb = −sign(Δθ) K u (1 + χ u̇),  u = r_p (|Δθ| − θ_cl) > 0,  Δθ = φ − θ_c − 2πk/N_b
//! cage        I_c θ̈_c = Σ (−r_p F_cb ± r_b f_r) + M_land − M_drag
//! rings       M ẍ + C ẋ + K (x − x_ref) = F_load − Σ (forces on the balls),   inner x, y, z, outer x, y
//! power       shaft + loads = friction + drag + churning + damping + pocket + cage + supports + d(energy)/dt
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | m, J; M; I_c | mass and inertia of a ball; mass of a ring; inertia of the cage | kg, kg m² |
//! | z, r, φ; ω_m; Ω | ball centre, its azimuth; orbital speed; absolute spin | m, rad; rad/s |
//! | x_i, x_o | displacements of the rings | m |
//! | d(φ) | depth of a worn or pitted groove in the ring's own frame | m |
//! | r_p, θ_cl, K, χ | radius of the pocket circle, play, stiffness, damping of a pocket | m, rad, N/m, s/m |
//! | f | pocket friction, μ F_cb against the ball's sliding at ±r_b e_t | N |
//! | c, ζ | damping of a ball–race contact, its fraction of the critical | N s/m, – |
//! | C, K, x_ref | supports of the rings; where their springs carry nothing | N s/m, N/m, m |
//!
//! Sources: Zhang et al., Lubricants 2025, 13(8), 352, doi:10.3390/lubricants13080352; pocket damping, Hunt and Crossley,
//! J. Appl. Mech. 42 (1975) 440, doi:10.1115/1.3423596. Each scheme names its own.
//!
//! Where we depart from the paper: its pocket force jumps at contact (the play is not subtracted), and its damper would pull;
//! its supports' signs; the part of the normal forces along the orbit where a ring is off centre, without which power is not
//! conserved, and its reaction on the ring, without which linear momentum is not.
//!
//! # Schemes
//! The classical Runge–Kutta method with fixed steps, cut where a ball meets its pocket wall; the pair of Dormand and Prince
//! with adaptive ones; and a fast scheme with contact springs explicit and friction linearly implicit. The bound on
//! the stiffness ([`Stiffness`]) is worked out at the start and on the way, and a step beyond it is warned of.
//!
//! # Samples
//! Contacts vibrate at 10 kHz and more. Accelerations of the rings are therefore low-pass filtered before they are sampled, as a measuring
//! chain does ([`FilterBands`]): ∫ a dt over short intervals are differences of the velocities, which cost no forces. All else in a
//! [`Sample`] is the state at its time, and folds where it vibrates faster than half the sampling rate.
//!
//! # Limits
//! Ring tilts are held; rings turn at prescribed speeds; the cage turns about the bearing's axis and does nothing else; the
//! races wear along their azimuth, and the energy that wear takes out of the elastic contacts is not accounted for. The
//! energy of contacts is that of frozen constants: with contact constants at the actual angle the power does not balance.
//!
//! The crate prints nothing and writes nothing: an [`Observer`] is handed [`Sample`]s and [`Event`]s.

mod detail;
mod dp54;
mod equations;
mod error;
mod fast;
mod forces;
mod layout;
mod linear;
mod machine;
mod observer;
mod pocket;
mod rk4;
mod run;
mod sample;
mod start;
mod stiffness;

#[cfg(test)]
mod balance_test;
#[cfg(test)]
mod conservation_test;
#[cfg(test)]
mod fast_test;

pub use error::DynamicsError;
pub use observer::{Event, EventKind, Observer};
pub use run::{ACCELERATION_ERROR, Checkpoint, Ending, FilterBands, Run, RunError, Statistics};
pub use sample::{BallSample, CageSample, ContactSample, PowerSample, RingSample, Sample, WearSample};
pub use stiffness::Stiffness;
