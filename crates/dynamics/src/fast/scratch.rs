//! The balls in lanes, on which the fast scheme works.

use super::depths::Places;
use super::drift::Pressed;
use super::kick_forces::{Forms, KickForces};
use super::lanes::{Lane, get};
use super::table::Keys;
use crate::layout::{BALL, VELOCITIES};
use fearless_simd::Level;
use tribodyn_bearing::Side;

/// Where a block is without the implicit part (axial, radial), and its accelerations at the start of the piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Explicit {
    pub positions: [Lane; 2],
    pub accelerations: [Lane; 2],
}

impl Explicit {
    pub const NONE: Self = Self { positions: [Lane::ZERO; 2], accelerations: [Lane::ZERO; 2] };
}

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
    pub pressed: Vec<Pressed>,
    /// Where a piece with implicit balls began, and their last correction.
    pub explicit: Vec<Explicit>,
    pub by: Vec<[Lane; 2]>,
    /// The middles of the balls' pockets.
    pub places: Vec<Places>,
    pub forms: Vec<Forms>,
    /// Where the linear forms of the table serve, inner and outer race.
    pub table: [Vec<Keys>; 2],
    pub kick_forces: Vec<KickForces>,
    /// Mean forces of inner and outer contacts on the balls in the last kick (a, r, t), N.
    pub mean_forces: Vec<[Lane; 6]>,
}

impl Default for Scratch {
    fn default() -> Self {
        Self {
            level: Level::new(),
            balls: Vec::new(),
            common: Vec::new(),
            given_back: Vec::new(),
            mean: Vec::new(),
            half: Vec::new(),
            beyond: Vec::new(),
            before: Vec::new(),
            azimuths: Vec::new(),
            pressed: Vec::new(),
            explicit: Vec::new(),
            by: Vec::new(),
            places: Vec::new(),
            forms: Vec::new(),
            table: [Vec::new(), Vec::new()],
            kick_forces: Vec::new(),
            mean_forces: Vec::new(),
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

/// Mean force of a contact on a ball in the last kick (a, r, t), N.
#[inline(always)]
pub(super) fn force_of(mean_forces: &[Lane; 6], side: Side, k: usize) -> [f64; 3] {
    let [i, j, l, outer @ ..] = get(mean_forces, k);
    match side {
        Side::Inner => [i, j, l],
        Side::Outer => outer,
    }
}
