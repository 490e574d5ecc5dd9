//! Facts of a run beside its samples: those known before the first step, and those known at the end. They are in the
//! recording, so that a report says what the run said and works nothing out anew.

use super::warnings;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use tribodyn::CaseFile;
use tribodyn::plausibility;
use tribodyn_bearing::PatchSurfaces;
use tribodyn_dynamics::{Run, Statistics, StepChoice, Stiffness};
use tribodyn_quasistatic::Solution;

/// Facts that are known before the first step.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct KnownAtStart {
    /// The fixed step that is taken, s; the fast scheme's divides the time between samples. None where steps follow
    /// from the error.
    pub step_s: Option<f64>,
    /// How that step was chosen, where an accuracy was asked for.
    pub step_choice: Option<StepChoice>,
    /// Rule by which patches are integrated.
    pub patch_rule: String,
    /// Of the solution that the run starts from, over the contact load.
    pub patch_error_estimate: Option<f64>,
    /// Scheme of integration in time, with the step that is taken.
    pub scheme: String,
    /// Of the solution that the run starts from, and what is unusual about it and its case.
    #[serde(skip)]
    pub warnings_at_start: Vec<String>,
}

/// Facts that are known at the end.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct KnownAtEnd {
    /// Steps and evaluations of the scheme.
    pub scheme_statistics: Statistics,
    /// Stiffness of the equations of motion.
    pub stiffness: Stiffness,
    /// Error of the outer ring's acceleration by step, patch and linear traction together, rms, m/s²; none where the
    /// run is too short to tell.
    pub acceleration_error_m_s2: Option<f64>,
}

impl KnownAtStart {
    /// Of a run of a case.
    pub(crate) fn of(run: &Run, file: &CaseFile) -> Self {
        Self {
            step_s: run.step_s(),
            step_choice: run.step_choice(),
            // Elastic patches have strips and cells of their own.
            patch_rule: match file.case.modelling.patch {
                Some(PatchSurfaces::Elastic { strips, cells }) => {
                    format!("Elastic {{ strips: {strips}, cells: {cells} }}")
                }
                _ => format!("{:?}", run.patch_rule()),
            },
            patch_error_estimate: run.solution().patch_error_estimate,
            scheme: format!("{:?}", run.scheme()),
            warnings_at_start: unusual(file, run.solution()),
        }
    }

    /// Keys and values for the metadata of a recording; the scheme is there already.
    pub(crate) fn entries(&self) -> Vec<(&'static str, String)> {
        let number = |value: &Option<f64>| value.map(|value| value.to_string());
        let all = [
            ("step_s", number(&self.step_s)),
            ("step_choice", self.step_choice.as_ref().map(json)),
            ("patch_rule", Some(self.patch_rule.clone())),
            ("patch_error_estimate", number(&self.patch_error_estimate)),
        ];
        all.into_iter().filter_map(|(key, value)| Some((key, value?))).collect()
    }

    /// From a recording; what it does not say is absent.
    pub fn read(run: &tribodyn_record::Run) -> Self {
        let said = |key: &str| run.metadata.get("simulation").and_then(|entries| entries.get(key)).cloned();
        let number = |key: &str| said(key)?.parse().ok();
        let at_start = run.events.iter().filter(|row| row.is_of_start());
        Self {
            step_s: number("step_s"),
            step_choice: said("step_choice").and_then(|text| serde_json::from_str(&text).ok()),
            patch_rule: said("patch_rule").unwrap_or_default(),
            patch_error_estimate: number("patch_error_estimate"),
            scheme: said("scheme").unwrap_or_default(),
            warnings_at_start: at_start.map(|row| row.message.clone()).collect(),
        }
    }
}

impl KnownAtEnd {
    /// Of a run as it stands.
    pub(crate) fn of(run: &Run) -> Self {
        Self {
            scheme_statistics: run.statistics(),
            stiffness: run.stiffness(),
            acceleration_error_m_s2: run.acceleration_error().map(|error| error.error_m_s2),
        }
    }

    /// Keys and values for the metadata at the end of a recording: JSON, as the report of a run has it.
    pub(crate) fn entries(&self) -> Vec<(&'static str, String)> {
        vec![
            ("scheme_statistics", json(&self.scheme_statistics)),
            ("stiffness", json(&self.stiffness)),
            ("acceleration_error_m_s2", json(&self.acceleration_error_m_s2)),
        ]
    }

    /// From a recording; none where it was cut off before its end.
    pub fn read(run: &tribodyn_record::Run) -> Option<Self> {
        let entries = run.metadata.get("outcome")?;
        fn part<T: DeserializeOwned>(text: Option<&String>) -> Option<T> {
            serde_json::from_str(text?).ok()
        }
        Some(Self {
            scheme_statistics: part(entries.get("scheme_statistics"))?,
            stiffness: part(entries.get("stiffness"))?,
            acceleration_error_m_s2: part(entries.get("acceleration_error_m_s2"))?,
        })
    }
}

/// Text of numbers; what has no form in JSON is `null` there.
fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).unwrap_or_else(|_| "null".to_owned())
}

/// Warnings of the solution that a run starts from, and what is unusual about it and its case.
fn unusual(file: &CaseFile, solution: &Solution) -> Vec<String> {
    let mut all = warnings::at_start(solution.warnings.clone());
    // A case that runs has a bearing.
    if let Ok(bearing) = file.bearing() {
        let found = plausibility::of_solution(&file.case, (&file.text, &bearing), solution);
        all.extend(found.into_iter().flat_map(|found| found.sentences));
    }
    all
}
