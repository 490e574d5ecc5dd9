//! Findings on the operating point that an answer rests on, for its reader.

use super::lubrication::lubrication;
use super::{Equations, Question};
use crate::error::AnswerError;
use crate::plausibility::{self, Implausible};
use serde::Serialize;
use tribodyn_bearing::Bearing;
use tribodyn_case::Case;
use tribodyn_quasistatic::Solution;

/// Warnings of an operating point, and what the bearing runs with.
///
/// They can be had from a solution only, and an [`Answer`] from them only: so none is without them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Findings {
    /// Equations of the operating point.
    model: Equations,
    /// Lubrication of the bearing, in a line.
    lubrication: String,
    /// False where nothing loads the bearing: then lives, safeties and contact angles are not defined.
    loaded: bool,
    /// Sentences on what is unusual, beyond what was tested, or more than the model can mean.
    warnings: Vec<String>,
    /// Names of what no bearing does.
    implausible: Vec<Implausible>,
}

/// The part of [`Findings`] that a solution does not print by itself.
#[derive(Debug, Clone, Serialize)]
pub struct Beside {
    /// Lubrication of the bearing, in a line.
    pub lubrication: String,
    /// False where nothing loads the bearing.
    pub loaded: bool,
    /// Names of what no bearing does.
    pub implausible: Vec<Implausible>,
}

/// Sentence on the freedoms of a cage that the steady orbit leaves out.
fn of_free_cage(case: &Case, equations: Equations) -> Option<String> {
    let free = case.cage.as_ref().is_some_and(|cage| cage.free.is_some());
    (free && equations == Equations::SteadyOrbit).then(|| {
        "the cage of the steady orbit turns about the bearing's axis only: of cage.free and its lands nothing is in \
         it; a run has them"
            .to_owned()
    })
}

impl Findings {
    /// Of an operating point, by its solution: all balls, or one ball round its orbit.
    ///
    /// # Errors
    /// A case without a geometry.
    pub fn of(
        question: &Question<'_>,
        bearing: &Bearing,
        (equations, solution): (Equations, &Solution),
    ) -> Result<Self, AnswerError> {
        let found = plausibility::of_solution(question.case, (question.text, bearing), solution);
        let found = found.map_err(|source| question.not_usable(source.into()))?;
        let loaded = plausibility::is_loaded(bearing, solution);
        let implausible: Vec<Implausible> = found.kinds();
        let no_load = (!loaded).then(|| plausibility::NO_LOAD.to_owned());
        let mut warnings = solution.warnings.clone();
        warnings.extend(no_load);
        warnings.extend(found.warnings(equations));
        // What is implausible stays last. A run counts the pressures of all its samples instead.
        let at = warnings.len() - usize::from(!implausible.is_empty());
        let one_freedom = of_free_cage(question.case, equations);
        warnings.splice(at..at, plausibility::curve_findings(question.case, solution).into_iter().chain(one_freedom));
        let lubrication = lubrication(question.case, equations);
        Ok(Self { model: equations, lubrication, loaded, warnings, implausible })
    }

    /// Of an operating point that was not found, for an answer that does not need it.
    ///
    /// # Errors
    /// A case that makes no bearing.
    pub(super) fn unsolved(
        question: &Question<'_>,
        equations: Equations,
        why: &AnswerError,
    ) -> Result<Self, AnswerError> {
        let bearing = question.bearing()?;
        let mut warnings = plausibility::of_case(question.case, (question.text, &bearing));
        warnings.push(format!("no load distribution: {why}"));
        let lubrication = lubrication(question.case, equations);
        let loaded = plausibility::case_loads(question.case).is_none_or(|loads| loads != [0.0; 2]);
        Ok(Self { model: equations, lubrication, loaded, warnings, implausible: Vec::new() })
    }

    /// Those of two bearings on one shaft, each named in its sentences.
    pub fn of_pair([first, second]: [Self; 2]) -> Self {
        let named = |findings: &Self, name: &str| {
            findings.warnings.iter().map(|warning| format!("{name}: {warning}")).collect::<Vec<_>>()
        };
        let mut warnings: Vec<String> = Vec::new();
        for warning in &first.warnings {
            // What both say is said of the bearings, as their loads have no part in it.
            let both = second.warnings.contains(warning);
            warnings.push(if both { warning.clone() } else { format!("bearing at -z: {warning}") });
        }
        let of_second = named(&second, "bearing at +z");
        let own = second.warnings.iter().zip(of_second).filter(|(warning, _)| !first.warnings.contains(warning));
        warnings.extend(own.map(|(_, named)| named));
        let mut implausible = [first.implausible, second.implausible].concat();
        implausible.sort();
        implausible.dedup();
        Self { loaded: first.loaded || second.loaded, warnings, implausible, ..first }
    }

    /// With one more sentence.
    #[must_use]
    pub fn with(mut self, warning: String) -> Self {
        self.warnings.push(warning);
        self
    }

    /// Equations of the operating point.
    pub fn model(&self) -> Equations {
        self.model
    }

    /// Lubrication of the bearing, in a line.
    pub fn lubrication(&self) -> &str {
        &self.lubrication
    }

    /// False where nothing loads the bearing.
    pub fn loaded(&self) -> bool {
        self.loaded
    }

    /// Sentences.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Names of what no bearing does, for a field of a table; empty where nothing is.
    pub fn implausible(&self) -> String {
        self.implausible.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
    }

    /// The findings to print beside a solution, which prints its model and its warnings itself.
    pub fn beside(&self) -> Beside {
        let Self { lubrication, loaded, implausible, .. } = self.clone();
        Beside { lubrication, loaded, implausible }
    }
}

/// An answer that rests on an operating point. JSON has the fields of both.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer<T> {
    #[serde(flatten)]
    findings: Findings,
    #[serde(flatten)]
    value: T,
}

impl<T> Answer<T> {
    /// An answer with the findings of its operating point.
    pub fn new(findings: Findings, value: T) -> Self {
        Self { findings, value }
    }

    /// Findings on the operating point.
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// The answer alone.
    pub fn value(&self) -> &T {
        &self.value
    }
}
