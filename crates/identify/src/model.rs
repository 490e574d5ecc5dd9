//! The figures that a set of parameter values gives.

use crate::IdentifyError;
use crate::problem::{Datum, Hypothesis, ModelName, Problem, Relation};
use crate::quantity::Quantity;
use crate::settled::Settled;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use tribodyn_bearing::{Bearing, OperatingPoint, SearchWatch};
use tribodyn_case::{Case, Purpose, locate, set_value};
use tribodyn_quasistatic::{Model, QuasiStaticError, Solution, WarmStart, solve, solve_from};

/// A case file's text with holes where the free parameters stand.
#[derive(Debug, Clone)]
struct Template {
    text: String,
    /// Byte range of each hole and which parameter fills it, by position.
    holes: Vec<(Range<usize>, usize)>,
}

impl Template {
    fn new(text: String, paths: &[(usize, &str)]) -> Result<Self, IdentifyError> {
        let mut holes = Vec::new();
        for &(index, path) in paths {
            let range = locate(&text, path).ok_or_else(|| IdentifyError::Path { path: path.to_owned() })?;
            if text[range.clone()].trim().parse::<f64>().is_err() {
                let value = text[range].to_owned();
                return Err(IdentifyError::NotANumber { path: path.to_owned(), value });
            }
            holes.push((range, index));
        }
        holes.sort_by_key(|(range, _)| range.start);
        Ok(Self { text, holes })
    }

    fn fill(&self, values: &[f64]) -> String {
        let mut out = String::with_capacity(self.text.len() + 16 * self.holes.len());
        let mut from = 0;
        for (range, index) in &self.holes {
            out.push_str(&self.text[from..range.start]);
            out.push_str(&format!("{:?}", values[*index]));
            from = range.end;
        }
        out.push_str(&self.text[from..]);
        out
    }
}

/// One variant of the case, ready to be solved for parameter values.
#[derive(Debug, Clone)]
struct Variant {
    template: Template,
    model: ModelName,
}

type Change = dyn Fn(&mut Bearing, &OperatingPoint) + Send + Sync;

/// A change of the bearing of every equilibrium that a case file cannot express, such as a misprint of equations.
#[derive(Clone)]
pub struct Adapt(pub Arc<Change>);

impl std::fmt::Debug for Adapt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Adapt")
    }
}

/// The model under one hypothesis: parameter values in, figures out.
#[derive(Debug, Clone)]
pub struct ForwardModel {
    variants: BTreeMap<String, Variant>,
    base: Template,
    /// By which searches and runs are ended.
    pub watch: SearchWatch,
    /// Changes of the bearing of each equilibrium; transient runs take the case as it is.
    pub adapt: Option<Adapt>,
}

/// Solutions by run, and starts for the neighbourhood.
#[derive(Debug, Clone, Default)]
pub struct Evaluation {
    /// Solutions by the name of the run.
    pub solutions: BTreeMap<String, Solution>,
    /// Settled figures of transient runs, by their names.
    pub settled: BTreeMap<String, Settled>,
    warm: BTreeMap<String, WarmStart>,
}

impl ForwardModel {
    /// Prepares the case's text: hypothesis and run replace values, free parameters become holes.
    ///
    /// # Errors
    /// A path that leads nowhere, a value that is no number, a case that is refused.
    pub fn new(problem: &Problem, case_text: &str, hypothesis: Option<&Hypothesis>) -> Result<Self, IdentifyError> {
        let mut text = case_text.to_owned();
        for (path, value) in hypothesis.iter().flat_map(|h| &h.set) {
            text = set_value(&text, path, value)?;
        }
        let base = Template::new(text.clone(), &holes(problem, hypothesis, None))?;
        let variants = problem.runs.iter().map(|(name, run)| {
            let mut text = text.clone();
            for (path, value) in problem.search.iter().chain(&run.set) {
                text = set_value(&text, path, value)?;
            }
            Case::from_ron(&text)?;
            let paths = holes(problem, hypothesis, Some(name));
            Ok((name.clone(), Variant { template: Template::new(text, &paths)?, model: run.model }))
        });
        let variants = variants.collect::<Result<_, IdentifyError>>()?;
        Ok(Self { variants, base, watch: SearchWatch::default(), adapt: None })
    }

    /// The case file's text with these values.
    pub fn case_text(&self, values: &[f64]) -> String {
        self.base.fill(values)
    }

    /// The case's own number at a path.
    pub(crate) fn own(&self, path: &str) -> Option<f64> {
        self.base.text.get(locate(&self.base.text, path)?)?.trim().parse().ok()
    }

    /// The text of the case of a run with these values, by its name.
    pub fn run_text(&self, run: &str, values: &[f64]) -> Option<String> {
        self.variants.get(run).map(|variant| variant.template.fill(values))
    }

    /// Works out all runs, equilibria from neighbouring solutions where there are some.
    ///
    /// # Errors
    /// A case that is refused or does not converge.
    pub fn evaluate(&self, values: &[f64], near: Option<&Evaluation>) -> Result<Evaluation, IdentifyError> {
        let mut out = Evaluation::default();
        for (name, variant) in &self.variants {
            if self.watch.stops() {
                return Err(QuasiStaticError::Ended.into());
            }
            let case = Case::from_ron(&variant.template.fill(values))?;
            let (model, purpose) = match variant.model {
                ModelName::JonesHarris => (Model::JonesHarris, Purpose::JonesHarris),
                ModelName::Traction => (Model::Traction, Purpose::Traction),
                ModelName::Transient => {
                    out.settled.insert(name.clone(), Settled::of(&case, &self.watch)?);
                    continue;
                }
            };
            case.require(purpose)?;
            let mut bearing = case.bearing()?;
            let point = OperatingPoint { watch: self.watch.clone(), ..case.operating_point() };
            if let Some(Adapt(change)) = &self.adapt {
                change(&mut bearing, &point);
            }
            let warm = near.and_then(|n| n.warm.get(name));
            let solved = match warm {
                Some(start) => solve_from(&bearing, &point, start).or_else(|_| solve(&bearing, &point, model)),
                None => solve(&bearing, &point, model),
            }?;
            if let Some(start) = solved.warm_start {
                out.warm.insert(name.clone(), start);
            }
            out.solutions.insert(name.clone(), solved.solution);
        }
        Ok(out)
    }
}

/// Indices of the parameters that are free under a hypothesis.
pub(crate) fn free(problem: &Problem, hypothesis: Option<&Hypothesis>) -> Vec<usize> {
    let held = |name: &String| hypothesis.is_some_and(|h| h.hold.contains(name) || h.tie.contains_key(name));
    (0..problem.parameters.len()).filter(|&i| !held(&problem.parameters[i].name)).collect()
}

/// Places of free numbers in a run, or in the completed case: which coordinate fills each.
fn holes<'a>(problem: &'a Problem, hypothesis: Option<&Hypothesis>, run: Option<&String>) -> Vec<(usize, &'a str)> {
    let free = free(problem, hypothesis);
    let mut out = Vec::new();
    for parameter in &problem.parameters {
        let tied = hypothesis.and_then(|h| h.tie.get(&parameter.name));
        let name = tied.unwrap_or(&parameter.name);
        let here = parameter.runs.is_empty() || run.is_some_and(|run| parameter.runs.contains(run));
        if let Some(index) = free.iter().position(|&k| problem.parameters[k].name == *name).filter(|_| here) {
            out.extend(parameter.paths.iter().map(|path| (index, path.as_str())));
        }
    }
    out
}

impl Datum {
    /// The model's figure: the value, the ratio, or the difference to the other quantity.
    pub fn computed(&self, evaluation: &Evaluation) -> f64 {
        let of = |run: &str, quantity: Quantity| match evaluation.settled.get(run) {
            Some(settled) => quantity.of_settled(settled),
            None => quantity.of(&evaluation.solutions[run]),
        };
        let here = of(&self.run, self.quantity);
        match &self.relation {
            Relation::Value => here,
            Relation::RatioTo { run, quantity } | Relation::RatioAbove { run, quantity } => here / of(run, *quantity),
            Relation::Above { run, quantity } => here - of(run, *quantity),
        }
    }

    /// Deviation of the model's figure: computed − value, and 0 where an order holds by more than its margin.
    pub fn deviation(&self, computed: f64) -> f64 {
        let deviation = computed - self.value;
        let order = matches!(self.relation, Relation::Above { .. } | Relation::RatioAbove { .. });
        if order { deviation.min(0.0) } else { deviation }
    }

    /// Unit of the figure.
    pub fn unit(&self) -> &'static str {
        let ratio = matches!(self.relation, Relation::RatioTo { .. } | Relation::RatioAbove { .. });
        if ratio { "–" } else { self.quantity.unit() }
    }
}
