//! Meshes that could not be made as fine as is asked for.

use crate::homotopy::said;
use serde::{Deserialize, Serialize};

/// Error of an interval, over what is allowed, that is worth a warning: the mesh of a neighbour may have as much.
const WORTH_SAYING: f64 = 2.0;

/// Errors of the worst interval over what is allowed, where a mesh could not be made finer.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Coarse {
    /// Of the motion of a ball.
    pub motion: f64,
    /// The same, where it is also what changes a pocket force.
    pub pocket: f64,
}

impl Coarse {
    /// The error of the motion where it is worth a warning.
    pub fn of_motion(&self) -> Option<f64> {
        (self.motion > WORTH_SAYING).then_some(self.motion)
    }

    /// True where pocket forces are not resolved.
    pub fn hides_pocket_forces(&self) -> bool {
        self.pocket > WORTH_SAYING
    }
}

/// Sentence on a mesh that could not be made as fine as is asked for, by the error of its worst interval over what is
/// allowed; of pocket forces alone where there is none.
pub(crate) fn coarse_sentence(error: Option<f64>) -> String {
    let of = error.map_or("the pocket forces".to_owned(), |error| {
        format!("the motion of a ball, which errs by up to {} times what is allowed", said(error, 2))
    });
    let off = if error.is_some() { "peaks of contact loads and pocket forces" } else { "the largest of them" };
    format!("no orbit was found on a mesh fine enough for {of}: {off} may be off")
}
