//! The outer loop of all iterations here.

use crate::block::{BlockSystem, Iterate};

/// No step from here is acceptable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Stuck;

/// A way to take one accepted step.
pub(crate) trait Method: Clone {
    fn advance<S: BlockSystem>(&mut self, system: &S, iterate: &mut Iterate) -> Result<(), Stuck>;
}

/// Steps until every balance is within `tolerance`, no step is acceptable any more, or `max_iterations` steps are
/// taken; the caller judges the residual.
pub(crate) fn run<S: BlockSystem, M: Method>(
    system: &S,
    mut iterate: Iterate,
    mut method: M,
    tolerance: f64,
    max_iterations: usize,
) -> Iterate {
    for _ in 0..max_iterations {
        if iterate.worst().residual <= tolerance || method.advance(system, &mut iterate).is_err() || !system.goes_on() {
            break;
        }
    }
    iterate
}
