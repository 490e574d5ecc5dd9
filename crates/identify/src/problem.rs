//! The problem file: which case, which free parameters, which data.

use crate::IdentifyError;
use crate::quantity::Quantity;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// An identification problem as its RON file has it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Problem {
    /// A title for reports.
    pub name: String,
    /// Case file, relative to the problem file.
    pub case: String,
    /// Seed of the start points.
    pub seed: u64,
    /// Number of start points.
    pub starts: usize,
    /// True if the values of the case are a start too, the first.
    #[serde(default)]
    pub from_case: bool,
    /// Free parameters.
    pub parameters: Vec<Parameter>,
    /// Variants of the case that data refer to.
    pub runs: BTreeMap<String, Run>,
    /// Figures to meet.
    pub data: Vec<Datum>,
    /// Values that hold only while searching, such as a coarser patch rule; the completed case keeps its own.
    #[serde(default)]
    pub search: BTreeMap<String, String>,
    /// Step of the difference quotients over the bounds of a parameter. Figures of runs are rough: impacts are a
    /// threshold, so that small differences tell nothing of their trend.
    #[serde(default = "smooth")]
    pub difference: f64,
    /// Alternatives to be fitted one after the other; without any, the case as it is.
    #[serde(default)]
    pub hypotheses: Vec<Hypothesis>,
}

/// Step of the differences in coordinates. Solutions are good to 1e-10 and smooth over 1e-3 of the bounds, so that
/// 1e-5 costs five digits to either side; halving it is checked at the solution.
fn smooth() -> f64 {
    1e-5
}

/// A free number of the case file.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Parameter {
    /// Name in reports.
    pub name: String,
    /// Places of the number, inside its unit: `geometry.pitch_diameter.mm`. Several places take the same number.
    pub paths: Vec<String>,
    /// Smallest and largest value, in the unit of the file.
    pub bounds: (f64, f64),
    /// Prior knowledge: mean and standard deviation, in the unit of the file (of ln value on a log scale).
    #[serde(default)]
    pub prior: Option<Prior>,
    /// Linear or logarithmic steps.
    #[serde(default)]
    pub scale: Scale,
    /// Names of the runs that it is free in; without any, in all, and in the completed case.
    #[serde(default)]
    pub runs: Vec<String>,
}

/// A normal prior.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Prior {
    /// Mean, in the unit of the file.
    pub mean: f64,
    /// Standard deviation, in the unit of the file; on a log scale, relative.
    pub spread: f64,
}

/// The scale of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub enum Scale {
    /// Steps in the value.
    #[default]
    Linear,
    /// Steps in the logarithm; bounds must be positive.
    Log,
}

/// A variant of the case.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The equations.
    pub model: ModelName,
    /// Values that replace the case's, by path.
    #[serde(default)]
    pub set: BTreeMap<String, String>,
}

/// The models by the names of the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum ModelName {
    /// Raceway control.
    JonesHarris,
    /// Traction integrals.
    Traction,
    /// A run in time, from the equilibrium with traction on: its last whole orbits within the second half.
    Transient,
}

/// A figure that the model should meet.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Datum {
    /// Name in reports.
    pub id: String,
    /// Name of the run it belongs to.
    pub run: String,
    /// Measured quantity.
    pub quantity: Quantity,
    /// Comparison that the figure is about.
    #[serde(default)]
    pub relation: Relation,
    /// The figure, in the unit of the quantity; of a ratio without one.
    pub value: f64,
    /// Its standard uncertainty, in the same unit.
    pub uncertainty: f64,
}

/// Kinds of data.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Relation {
    /// The quantity is the figure.
    #[default]
    Value,
    /// The quantity is the figure times another one: papers often print ratios, or units that cancel in them.
    RatioTo {
        /// Name of the other's run.
        run: String,
        /// The other quantity.
        quantity: Quantity,
    },
    /// The quantity exceeds another one by the figure or more: an order that a text states. Beyond the figure nothing
    /// more is gained.
    Above {
        /// Name of the other's run.
        run: String,
        /// The other quantity, in the same unit.
        quantity: Quantity,
    },
    /// The quantity is the figure times another one or more: an order between numbers of unknown size.
    RatioAbove {
        /// Name of the other's run.
        run: String,
        /// The other quantity.
        quantity: Quantity,
    },
}

impl Relation {
    /// The other run and quantity, where there is one.
    pub fn other(&self) -> Option<(&str, Quantity)> {
        match self {
            Self::Value => None,
            Self::RatioTo { run, quantity } | Self::Above { run, quantity } | Self::RatioAbove { run, quantity } => {
                Some((run, *quantity))
            }
        }
    }
}

/// Values that hold throughout one fit.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Hypothesis {
    /// Name in reports.
    pub name: String,
    /// Values that replace the case's, by path.
    pub set: BTreeMap<String, String>,
    /// Parameters that stay as the case (or `set`) has them.
    #[serde(default)]
    pub hold: Vec<String>,
    /// Parameters that take the value of another one.
    #[serde(default)]
    pub tie: BTreeMap<String, String>,
    /// Priors instead of those of the parameters.
    #[serde(default)]
    pub priors: BTreeMap<String, Prior>,
}

impl Problem {
    /// Reads and checks a problem.
    ///
    /// # Errors
    /// [`IdentifyError::Syntax`] with line and column, [`IdentifyError::Value`] with the field.
    pub fn from_ron(text: &str) -> Result<Self, IdentifyError> {
        let options = ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
        let problem: Self = options.from_str(text).map_err(|error| IdentifyError::Syntax {
            line: error.span.start.line,
            column: error.span.start.col,
            message: error.code.to_string(),
        })?;
        problem.check()?;
        Ok(problem)
    }

    /// Checks the values of a problem, also of one made or changed in code.
    ///
    /// # Errors
    /// [`IdentifyError::Value`] with the field.
    pub fn check(&self) -> Result<(), IdentifyError> {
        if self.starts == 0 || self.starts > 10_000 {
            return refuse("starts".into(), self.starts.to_string(), "1 to 10000");
        }
        if !(1e-9..=0.25).contains(&self.difference) {
            return refuse("difference".into(), self.difference.to_string(), "1e-9 to 0.25");
        }
        if self.parameters.is_empty() {
            return refuse("parameters".into(), "[]".into(), "at least one free parameter");
        }
        for (index, parameter) in self.parameters.iter().enumerate() {
            parameter.check(index, &self.runs)?;
        }
        if self.data.is_empty() {
            return refuse("data".into(), "[]".into(), "at least one datum");
        }
        for (index, datum) in self.data.iter().enumerate() {
            datum.check(index, &self.runs)?;
        }
        self.hypotheses.iter().enumerate().try_for_each(|(index, h)| h.check(index, &self.parameters))
    }
}

impl Hypothesis {
    fn check(&self, index: usize, parameters: &[Parameter]) -> Result<(), IdentifyError> {
        let known = |name: &String| parameters.iter().any(|p| p.name == *name);
        let field = |name: &str| format!("hypotheses[{index}].{name}");
        if let Some(name) = self.hold.iter().find(|name| !known(name)) {
            return refuse(field("hold"), name.clone(), "names of parameters");
        }
        for (name, other) in &self.tie {
            let free = known(other) && !self.hold.contains(other) && !self.tie.contains_key(other);
            if !(known(name) && free) || self.hold.contains(name) {
                let allowed = "names of parameters that are not held, each the name of another that is free";
                return refuse(field("tie"), format!("{name}: {other}"), allowed);
            }
        }
        for (name, prior) in &self.priors {
            let Some(parameter) = parameters.iter().find(|p| p.name == *name) else {
                return refuse(field("priors"), name.clone(), "names of parameters");
            };
            prior.check(field("priors"), parameter.scale)?;
        }
        Ok(())
    }
}

impl Prior {
    fn check(&self, field: String, scale: Scale) -> Result<(), IdentifyError> {
        let inside = self.mean.is_finite() && (scale == Scale::Linear || self.mean > 0.0);
        if inside && self.spread > 0.0 && self.spread.is_finite() {
            return Ok(());
        }
        refuse(field, format!("{self:?}"), "finite mean (positive on a log scale), spread above 0")
    }
}

fn refuse(field: String, value: String, allowed: &'static str) -> Result<(), IdentifyError> {
    Err(IdentifyError::Value { field, value, allowed })
}

impl Parameter {
    fn check(&self, index: usize, runs: &BTreeMap<String, Run>) -> Result<(), IdentifyError> {
        let field = |name: &str| format!("parameters[{index}].{name} ({})", self.name);
        let (low, high) = self.bounds;
        if !(low.is_finite() && high.is_finite() && low < high) {
            return refuse(field("bounds"), format!("({low}, {high})"), "finite, lower below upper");
        }
        if self.scale == Scale::Log && low <= 0.0 {
            return refuse(field("bounds"), format!("({low}, {high})"), "positive on a log scale");
        }
        if self.paths.is_empty() {
            return refuse(field("paths"), "[]".into(), "at least one path into the case");
        }
        if let Some(run) = self.runs.iter().find(|run| !runs.contains_key(*run)) {
            return refuse(field("runs"), run.clone(), "names of runs");
        }
        self.prior.map_or(Ok(()), |prior| prior.check(field("prior"), self.scale))
    }
}

/// Quantities that a datum may have.
const OF_THE_MODEL: &str = "a quantity of the model: runs (Transient) have speeds of balls, accelerations and impacts";

impl Datum {
    fn check(&self, index: usize, runs: &BTreeMap<String, Run>) -> Result<(), IdentifyError> {
        let field = |name: &str| format!("data[{index}].{name} ({})", self.id);
        let Some(run) = runs.get(&self.run) else {
            return refuse(field("run"), self.run.clone(), "the name of one of the runs");
        };
        if self.quantity.of_run() != (run.model == ModelName::Transient) {
            return refuse(field("quantity"), format!("{:?}", self.quantity), OF_THE_MODEL);
        }
        if let Some((run, quantity)) = self.relation.other() {
            let Some(other) = runs.get(run) else {
                return refuse(field("relation.run"), run.to_owned(), "the name of one of the runs");
            };
            if quantity.of_run() != (other.model == ModelName::Transient) {
                return refuse(field("relation.quantity"), format!("{quantity:?}"), OF_THE_MODEL);
            }
            let order = matches!(self.relation, Relation::Above { .. });
            if order && quantity.unit() != self.quantity.unit() {
                return refuse(field("relation.quantity"), format!("{quantity:?}"), "a quantity of the same unit");
            }
        }
        if !self.value.is_finite() {
            return refuse(field("value"), self.value.to_string(), "a finite number");
        }
        if !(self.uncertainty > 0.0 && self.uncertainty.is_finite()) {
            return refuse(field("uncertainty"), self.uncertainty.to_string(), "a finite number above 0");
        }
        Ok(())
    }
}
