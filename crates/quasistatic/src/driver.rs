//! The one file that knows argmin: our Newton iterations as argmin solvers.
//!
//! argmin's own Newton has no convergence test on the residual and no blocks, so the steps are ours; the executor gives
//! iteration limits and termination.

use crate::block::{BlockSystem, Iterate};
use argmin::core::{Error, Executor, IterState, KV, Problem, Solver, TerminationReason, TerminationStatus};

type Iteration = IterState<Vec<f64>, (), (), (), (), f64>;

/// No step from here is acceptable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Stuck;

/// A way to take one accepted step.
pub(crate) trait Method: Clone {
    fn advance<S: BlockSystem>(&mut self, system: &S, iterate: &mut Iterate) -> Result<(), Stuck>;
}

struct Stepper<M> {
    method: M,
    iterate: Iterate,
    tolerance: f64,
    stuck: bool,
    ended: bool,
}

impl<S: BlockSystem, M: Method> Solver<&S, Iteration> for Stepper<M> {
    fn name(&self) -> &str {
        "Newton on ball blocks"
    }

    fn next_iter(&mut self, problem: &mut Problem<&S>, state: Iteration) -> Result<(Iteration, Option<KV>), Error> {
        let advanced = problem.problem("steps", |system| Ok(self.method.advance(*system, &mut self.iterate)))?;
        self.stuck = advanced.is_err();
        self.ended = problem.problem("looks", |system| Ok(!system.goes_on()))?;
        Ok((state.cost(self.iterate.worst().residual), None))
    }

    fn terminate(&mut self, _state: &Iteration) -> TerminationStatus {
        if self.iterate.worst().residual <= self.tolerance {
            TerminationStatus::Terminated(TerminationReason::SolverConverged)
        } else if self.stuck {
            TerminationStatus::Terminated(TerminationReason::SolverExit("no acceptable step".into()))
        } else if self.ended {
            TerminationStatus::Terminated(TerminationReason::SolverExit("ended by the caller".into()))
        } else {
            TerminationStatus::NotTerminated
        }
    }
}

/// Steps until every balance is within `tolerance`, no step is acceptable any more, or `max_iterations` steps are
/// taken; the caller judges the residual.
pub(crate) fn run<S: BlockSystem, M: Method>(
    system: &S,
    start: Iterate,
    method: M,
    tolerance: f64,
    max_iterations: usize,
) -> Iterate {
    let stepper = Stepper { method, iterate: start.clone(), tolerance, stuck: false, ended: false };
    Executor::new(system, stepper)
        .configure(|state| state.max_iters(max_iterations as u64))
        .timer(false)
        .run()
        // Neither our step nor the executor without checkpoints and observers returns an error.
        .map_or(start, |result| result.solver.iterate)
}
