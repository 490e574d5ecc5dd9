//! The equilibrium of a case, with what stands beside it in an answer.

use super::{Equations, Findings, Question};
use crate::error::AnswerError;
use crate::rating::rating;
use serde::{Serialize, Serializer};
use tribodyn_bearing::Bearing;
use tribodyn_case::Case;
use tribodyn_quasistatic::{BallRoots, Model, Solution, Solved, other_roots, root_warnings, solve};

/// Rating life of the steel and static safety, under the names of `tribodyn rating`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Lives {
    /// Basic rating life, 10⁶ revolutions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rating_life_l10_mrev: Option<f64>,
    /// Basic reference rating life of the load distribution, 10⁶ revolutions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rating_life_l10r_mrev: Option<f64>,
    /// Hours at the speed of the case.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rating_life_hours: Option<f64>,
    /// Static safety.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub static_safety: Option<f64>,
}

impl Lives {
    /// Of a case under the loads of a solution; none for a bearing that the standards do not rate, or that carries
    /// nothing.
    pub(super) fn of(case: &Case, solution: &Solution, loaded: bool) -> Option<Self> {
        let rated = rating(case, Some(solution)).ok().filter(|_| loaded)?;
        Some(Self {
            rating_life_l10_mrev: rated.rating_life_l10_mrev,
            rating_life_l10r_mrev: rated.rating_life_l10r_mrev,
            rating_life_hours: rated.rating_life_hours,
            static_safety: rated.static_safety,
        })
    }
}

/// A solution with its warnings, lives and, where they were asked for, the other equilibria of each ball.
#[derive(Debug, Clone, Serialize)]
pub struct Equilibrium {
    /// Ring and balls.
    #[serde(flatten)]
    pub solution: Solution,
    /// Findings on it; its warnings are those of the solution.
    #[serde(flatten, serialize_with = "beside")]
    pub findings: Findings,
    /// Absent for a bearing that the standards do not rate; `tribodyn rating` says why.
    #[serde(flatten)]
    pub lives: Option<Lives>,
    /// Other equilibria of each ball, the ring held.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roots: Option<Vec<BallRoots>>,
}

/// Model and warnings are the solution's already.
fn beside<S: Serializer>(findings: &Findings, serializer: S) -> Result<S::Ok, S::Error> {
    findings.beside().serialize(serializer)
}

/// The equilibrium of a case; `roots` also searches each ball for other equilibria.
///
/// # Errors
/// A case that the model cannot use, or an equilibrium that is not found.
pub fn equilibrium(question: &Question<'_>, model: Model, roots: bool) -> Result<Equilibrium, AnswerError> {
    if roots && model == Model::JonesHarris {
        let message = "without traction there are no other equilibria to search for";
        return Err(AnswerError::argument("roots", "with --model jones-harris", message));
    }
    let (bearing, Solved { mut solution, warm_start, .. }) = solved(question, model)?;
    let start = warm_start.filter(|_| roots);
    let point = question.point();
    let failed = |source| AnswerError::Solver { file: question.name.to_owned(), source };
    let roots = start.map(|start| other_roots(&bearing, &point, &start)).transpose().map_err(failed)?;
    solution.warnings.extend(roots.iter().flat_map(|roots| root_warnings(roots)));
    let findings = Findings::of(question, &bearing, (model.into(), &solution))?;
    solution.warnings = findings.warnings().to_vec();
    let lives = Lives::of(question.case, &solution, findings.loaded());
    Ok(Equilibrium { solution, findings, lives, roots })
}

/// The bearing of a case and its equilibrium alone.
///
/// # Errors
/// As [`equilibrium`].
pub fn solved(question: &Question<'_>, model: Model) -> Result<(Bearing, Solved), AnswerError> {
    let bearing = question.bearing_for(Equations::from(model).purpose())?;
    question.bearable(&bearing)?;
    let failed = |source| AnswerError::Solver { file: question.name.to_owned(), source };
    let solved = solve(&bearing, &question.point(), model).map_err(failed)?;
    Ok((bearing, solved))
}
