//! The study of one paper: its figures and tables rebuilt from our own runs, row by row with a verdict, drawn, and
//! varied where the paper hides a parameter.
//!
//! # Decisions
//! ```text
//! number:        deviation = computed − published,   met if |deviation| ≤ tolerance
//! order, shape:  met if the measured quantity is on the stated side of its limit; the row's note names both
//! regression:    |ours now − ours then| ≤ 1e-6 |ours then|
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | κ, s | traction coefficient, slip | –, unit of the tests |
//! | p, Q | peak contact pressure, contact load | GPa, N |
//! | T, ξ | longitudinal traction, slide-to-roll ratio | N, – |
//! | φ | azimuth; heavy zone −90° to 90°, light zone the rest | ° |
//!
//! Source of the published figures: Zhang, Jia, Zhao, Wei, Zi, Lubricants 2025, 13(8), 352,
//! doi:10.3390/lubricants13080352; they are in `fixtures/reference/zhang2025`.
//!
//! Limits: words such as "about" and "clearly" are given one number for all rows. Nothing here changes a parameter to
//! meet a row.
//!
//! It does not know any physics, which it asks the crates for, nor a terminal: it returns text, and reports
//! [`Progress`] to its caller. It reads the workspace that it was built in, and writes the committed results only where
//! it is asked to.

mod error;
pub mod figures;
pub mod files;
pub mod markers;
mod mean;
mod progress;
pub mod sensitivity;
pub mod table;
mod transient;
pub mod validate;

pub use error::{PaperError, listed};
pub use mean::{mean, rms};
pub use progress::Progress;
