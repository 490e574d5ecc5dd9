//! What the fast scheme works on: the balls in lanes.

use super::drift::Stand;
use super::grip::{Forms, Grips, Places};
use super::lanes::Lane;
use crate::layout::{BALL, VELOCITIES};
use fearless_simd::Level;

/// The balls in lanes: all of it follows from the rest of the memory and the state.
#[derive(Debug)]
pub(super) struct Scratch {
    /// The vector instructions of this processor.
    pub level: Level,
    pub balls: Vec<[Lane; BALL]>,
    /// Common accelerations, and as the kick gives them back.
    pub common: Vec<[Lane; 3]>,
    pub given_back: Vec<[Lane; 3]>,
    /// Mean accelerations by the drift over the last step.
    pub mean: Vec<[Lane; 3]>,
    /// Second halves of kicks, and velocities at the start of a piece of the drift.
    pub half: Vec<[Lane; VELOCITIES]>,
    pub beyond: Vec<[Lane; VELOCITIES]>,
    pub before: Vec<[Lane; 3]>,
    /// Azimuths of the balls that are not round at the start of a piece, rad.
    pub azimuths: Vec<f64>,
    pub stands: Vec<Stand>,
    /// The middles of the balls' pockets.
    pub places: Vec<Places>,
    pub forms: Vec<Forms>,
    pub grips: Vec<Grips>,
    /// Mean forces of inner and outer contacts on the balls in the last kick (a, r, t), N.
    pub mean_forces: Vec<[Lane; 6]>,
}

impl Default for Scratch {
    fn default() -> Self {
        let level = Level::new();
        let (balls, common, given_back, mean) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (half, beyond, before, stands) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (azimuths, places, forms, grips, mean_forces) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self {
            level,
            balls,
            common,
            given_back,
            mean,
            half,
            beyond,
            before,
            azimuths,
            stands,
            places,
            forms,
            grips,
            mean_forces,
        }
    }
}

impl Clone for Scratch {
    /// A memory that goes its own way makes its own.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for Scratch {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
