//! Rating life and static safety of a case.

use super::{Answer, Equations, Findings, OrbitAnswer, Question, solved};
use crate::error::AnswerError;
use crate::plausibility;
use crate::rating::{Rating, rating};

/// Rating life and static safety under the loads that some equations give, the usual ones where none are chosen. Where
/// no load distribution is found, what the standards make of the loads alone, with the reason among the warnings.
///
/// # Errors
/// A case that these equations cannot use, or a bearing that the standards do not rate.
pub fn rated(question: &Question<'_>, equations: Option<Equations>) -> Result<Answer<Rating>, AnswerError> {
    let equations = equations.unwrap_or_else(|| Equations::usual(question.case));
    let refused = |source| AnswerError::Rating { file: question.name.to_owned(), source };
    let found = match equations.equilibrium() {
        Some(model) => solved(question, model).and_then(|(bearing, solved)| {
            Ok((Findings::of(question, &bearing, (equations, &solved.solution))?, solved.solution))
        }),
        None => OrbitAnswer::of(question).map(|answer| (answer.findings, answer.solution)),
    };
    let (findings, solution) = match found {
        Ok((findings, solution)) => (findings, Some(solution)),
        // Ratings and static safety need no load distribution.
        Err(error) if error.leaves_a_rating() && plausibility::case_loads(question.case).is_some() => {
            (Findings::unsolved(question, equations, &error)?, None)
        }
        Err(error) => return Err(error),
    };
    let rating = rating(question.case, solution.as_ref()).map_err(refused)?;
    let rating = if findings.loaded() { rating } else { rating.unloaded() };
    let findings = rating.warnings.iter().cloned().fold(findings, Findings::with);
    Ok(Answer::new(findings, rating))
}
