//! Two like bearings on one shaft, with what must be known of both.

use super::{Answer, Equations, Findings, OrbitProblem, Question};
use crate::error::AnswerError;
use crate::pair::{Arrangement, Pair, PairError, PairModel, PairSolution, Preload, solve_pair};
use crate::plausibility::{inelastic, peak_pressure};

/// How two bearings of a case stand on their shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairSetting {
    /// How they stand to each other.
    pub arrangement: Arrangement,
    /// Distance between their middles, m.
    pub distance: f64,
    /// Preload between them.
    pub preload: Preload,
}

/// Two bearings of a case on one rigid shaft.
///
/// # Errors
/// A case that the equations cannot use, or a pair without an equilibrium that is found.
pub fn pair(
    question: &Question<'_>,
    equations: Equations,
    PairSetting { arrangement, distance, preload }: PairSetting,
) -> Result<Answer<PairSolution>, AnswerError> {
    let (bearing, model) = match equations.equilibrium() {
        Some(model) => {
            let bearing = question.bearing_for(equations.purpose())?;
            question.bearable(&bearing)?;
            (bearing, PairModel::QuasiStatic(model))
        }
        None => {
            let OrbitProblem { bearing, cage, settings, .. } = OrbitProblem::new(question)?;
            (bearing, PairModel::SteadyOrbit(cage, settings))
        }
    };
    let point = question.point();
    let pair = Pair { bearing: &bearing, point: &point, model, arrangement, distance, preload };
    let failed = |error: PairError| {
        let source = if question.watch.stops() { PairError::Ended } else { error };
        AnswerError::Pair { file: question.name.to_owned(), source }
    };
    let solution = solve_pair(&pair).map_err(failed)?;
    let pressures = solution.bearings.each_ref().map(|bearing| peak_pressure(&bearing.solution));
    if let Some(why) = inelastic(pressures[0].max(pressures[1])) {
        return Err(AnswerError::Overload { file: question.name.to_owned(), why });
    }
    let [first, second] = solution.bearings.each_ref();
    let of = |bearing_of_pair: &crate::pair::PairBearing| {
        Findings::of(question, &bearing, (equations, &bearing_of_pair.solution))
    };
    let findings = Findings::of_pair([of(first)?, of(second)?]);
    Ok(Answer::new(findings, solution))
}
