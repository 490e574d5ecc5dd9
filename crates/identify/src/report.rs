//! The answer of an identification, as data: values with spreads, what determines them, residuals, the completed case.

use crate::IdentifyError;
use crate::fit::LeastSquares;
use crate::model::{Adapt, Evaluation};
use crate::problem::{Datum, Hypothesis, Parameter, Problem, Relation};
use crate::search::{Search, search};
use crate::uncertainty::{Uncertainty, uncertainty};
use serde::Serialize;
use tribodyn_bearing::SearchWatch;
use tribodyn_case::{locate, set_value};

/// The answer under one hypothesis.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Identification {
    /// Name of the hypothesis; absent where the case was taken as it is.
    pub hypothesis: Option<String>,
    /// Sum of squared residuals over uncertainties, priors included.
    pub cost: f64,
    /// The same of the data alone.
    pub data_cost: f64,
    /// Natural logarithm of the evidence by Laplace's approximation, up to a constant of the data: what a hypothesis
    /// gains over another one on the same data, its free parameters and priors taken into account.
    pub log_evidence: f64,
    /// Signs that a figure is read wrongly or that the model lacks something.
    pub conflicts: Vec<String>,
    /// Parameters at the best minimum.
    pub parameters: Vec<ParameterResult>,
    /// Correlation coefficients, in the order of the parameters.
    pub correlation: Vec<Vec<f64>>,
    /// Data at the best minimum.
    pub data: Vec<DatumResult>,
    /// Distinct minima, the best first.
    pub minima: Vec<MinimumResult>,
    /// Starts without an equilibrium.
    pub failed_starts: usize,
    /// Largest relative change of the sensitivities when the difference step is halved.
    pub sensitivity_check: f64,
    /// Warnings of the solutions, by run.
    pub warnings: Vec<String>,
    /// The case file with the identified values and their sources.
    pub case_text: String,
}

/// One parameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ParameterResult {
    /// Name.
    pub name: String,
    /// Paths in the case file.
    pub paths: Vec<String>,
    /// Value in the unit of the file.
    pub value: f64,
    /// Standard deviation in the unit of the file.
    pub spread: f64,
    /// Bounds in the unit of the file.
    pub bounds: (f64, f64),
    /// Prior mean and spread, where there is one.
    pub prior: Option<(f64, f64)>,
    /// True where the data determine it; elsewhere the value is only what prior or bounds make of it.
    pub determined: bool,
    /// Share of the prior's variance that the data remove.
    pub information: f64,
    /// True where it lies at a bound.
    pub at_bound: bool,
    /// Distance from the prior's mean in spreads of the prior, where there is one.
    pub prior_deviation: Option<f64>,
    /// The residuals with the largest shares in its variance.
    pub determined_by: Vec<(String, f64)>,
    /// The measurement that would determine it best: run, quantity, and the spread it would then have.
    pub measure: Option<String>,
}

/// One datum.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DatumResult {
    /// Name.
    pub id: String,
    /// Run.
    pub run: String,
    /// Kind of the datum.
    pub relation: Relation,
    /// Unit of the next four.
    pub unit: &'static str,
    /// The figure to be met.
    pub value: f64,
    /// The model's figure.
    pub computed: f64,
    /// computed − value; of an order that holds by more than its margin, 0.
    pub deviation: f64,
    /// Uncertainty of the figure.
    pub uncertainty: f64,
    /// deviation/uncertainty.
    pub normalised: f64,
}

/// One minimum.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MinimumResult {
    /// Sum of squared residuals.
    pub cost: f64,
    /// Values in the order of the parameters.
    pub values: Vec<f64>,
    /// Starts that ended here.
    pub starts: usize,
}

/// Residuals whose share in a parameter's variance is named.
const NAMED_SHARES: usize = 4;

/// Identifies under every hypothesis of a problem.
///
/// `finished` is called after each start, from any thread; `watch` ends the search.
///
/// # Errors
/// See [`IdentifyError`].
pub fn identify(
    problem: &Problem,
    case_text: &str,
    finished: &(dyn Fn() + Sync),
    watch: &SearchWatch,
) -> Result<Vec<Identification>, IdentifyError> {
    let hypotheses: Vec<Option<&Hypothesis>> =
        if problem.hypotheses.is_empty() { vec![None] } else { problem.hypotheses.iter().map(Some).collect() };
    let one = |hypothesis| identify_one(problem, case_text, hypothesis, None, finished, watch);
    hypotheses.into_iter().map(one).collect()
}

/// Identifies under one hypothesis, or with the case as it is, of bearings that may be changed by what no case file
/// can express; transient runs take the case as it is.
///
/// `finished` and `watch` as with [`identify`].
///
/// # Errors
/// See [`IdentifyError`].
pub fn identify_one(
    problem: &Problem,
    case_text: &str,
    hypothesis: Option<&Hypothesis>,
    adapt: Option<Adapt>,
    finished: &(dyn Fn() + Sync),
    watch: &SearchWatch,
) -> Result<Identification, IdentifyError> {
    let mut squares = LeastSquares::new(problem, case_text, hypothesis)?;
    squares.model.watch = watch.clone();
    squares.model.adapt = adapt;
    let found = search(&squares, problem.seed, problem.starts, finished)?;
    answer(&squares, &found, hypothesis)
}

fn answer(
    squares: &LeastSquares<'_>,
    found: &Search,
    hypothesis: Option<&Hypothesis>,
) -> Result<Identification, IdentifyError> {
    let best = &found.minima[0].point;
    let curvature = uncertainty(squares, best)?;
    let values = squares.values(&best.coordinates);
    let data = data_results(squares.problem, &best.evaluation);
    let parameters = parameter_results(squares, &curvature, &values);
    let case_text = completed_case(squares, &values, &parameters, hypothesis)?;
    let solutions = best.evaluation.solutions.iter();
    let warnings = solutions.flat_map(|(run, solution)| solution.warnings.iter().map(move |w| format!("{run}: {w}")));
    let minima = found.minima.iter().map(|m| MinimumResult {
        cost: m.point.cost(),
        values: squares.values(&m.point.coordinates),
        starts: m.starts,
    });
    Ok(Identification {
        hypothesis: hypothesis.map(|h| h.name.clone()),
        cost: best.cost(),
        data_cost: data.iter().map(|d| d.normalised.powi(2)).sum(),
        log_evidence: curvature.log_evidence,
        conflicts: conflicts(&parameters, &data),
        correlation: curvature.correlation.row_iter().map(|row| row.iter().copied().collect()).collect(),
        data,
        minima: minima.collect(),
        failed_starts: found.failed.0,
        sensitivity_check: curvature.sensitivity_check,
        warnings: warnings.collect(),
        parameters,
        case_text,
    })
}

/// Distance from its prior, in spreads, beyond which a parameter speaks against the problem.
const FAR_FROM_PRIOR: f64 = 1.5;
/// The same of a datum, in uncertainties.
const FAR_FROM_DATUM: f64 = 3.0;

fn conflicts(parameters: &[ParameterResult], data: &[DatumResult]) -> Vec<String> {
    let reason = "a figure is read wrongly, or the model lacks something";
    let bounds = parameters.iter().filter(|p| p.at_bound);
    let bounds = bounds.map(|p| format!("{} lies at a bound of {:?}: {reason}", p.name, p.bounds));
    let far = |p: &&ParameterResult| p.prior_deviation.is_some_and(|d| d.abs() > FAR_FROM_PRIOR);
    let priors = parameters
        .iter()
        .filter(far)
        .map(|p| format!("{} is {:+.1} prior spreads off: {reason}", p.name, p.prior_deviation.unwrap_or_default()));
    let missed = data.iter().filter(|d| d.normalised.abs() > FAR_FROM_DATUM);
    let missed = missed.map(|d| format!("{} is missed by {:+.1} uncertainties: {reason}", d.id, d.normalised));
    bounds.chain(priors).chain(missed).collect()
}

fn data_results(problem: &Problem, evaluation: &Evaluation) -> Vec<DatumResult> {
    let result = |d: &Datum| {
        let computed = d.computed(evaluation);
        let deviation = d.deviation(computed);
        DatumResult {
            id: d.id.clone(),
            run: d.run.clone(),
            relation: d.relation.clone(),
            unit: d.unit(),
            value: d.value,
            computed,
            deviation,
            uncertainty: d.uncertainty,
            normalised: deviation / d.uncertainty,
        }
    };
    problem.data.iter().map(result).collect()
}

fn parameter_results(squares: &LeastSquares<'_>, curvature: &Uncertainty, values: &[f64]) -> Vec<ParameterResult> {
    let priors = squares.parameters().filter(|p| p.prior.is_some()).map(|p| format!("prior of {}", p.name));
    let residuals: Vec<String> = squares.problem.data.iter().map(|d| d.id.clone()).chain(priors).collect();
    let result = |(k, p): (usize, &Parameter)| ParameterResult {
        name: p.name.clone(),
        paths: p.paths.clone(),
        value: values[k],
        spread: curvature.spread[k],
        bounds: p.bounds,
        prior: p.prior.map(|prior| (prior.mean, prior.spread)),
        determined: curvature.determined[k],
        information: curvature.information[k],
        at_bound: curvature.at_bound[k],
        prior_deviation: p.prior_residual(values[k]),
        determined_by: largest_shares(&residuals, curvature.shares.row(k).iter().copied()),
        measure: curvature.wanted[k].as_ref().map(|(run, quantity, spread)| {
            format!("{quantity:?} of run \"{run}\" would bring its spread to {spread:.3e}")
        }),
    };
    squares.parameters().enumerate().map(result).collect()
}

/// The residuals with the largest shares above 1 %, the largest first.
fn largest_shares(names: &[String], shares: impl Iterator<Item = f64>) -> Vec<(String, f64)> {
    let mut named: Vec<(String, f64)> = names.iter().cloned().zip(shares).filter(|(_, share)| *share > 0.01).collect();
    named.sort_by(|a, b| b.1.total_cmp(&a.1));
    named.truncate(NAMED_SHARES);
    named
}

/// The case with the identified values rounded to a hundredth of their spread, and where each comes from.
fn completed_case(
    squares: &LeastSquares<'_>,
    values: &[f64],
    parameters: &[ParameterResult],
    hypothesis: Option<&Hypothesis>,
) -> Result<String, IdentifyError> {
    let rounded: Vec<f64> = values.iter().zip(parameters).map(|(v, p)| round_to(*v, 0.01 * p.spread)).collect();
    let mut text = squares.model.case_text(&rounded);
    let from =
        hypothesis.map_or_else(|| squares.problem.name.clone(), |h| format!("{}, {}", squares.problem.name, h.name));
    for parameter in parameters {
        let source = if parameter.determined {
            format!("Identified(spread: {:?}, from: {from:?})", significant(parameter.spread))
        } else {
            format!("Assumed({:?})", format!("not determined by the data of: {from}"))
        };
        for path in &parameter.paths {
            text = with_source(&text, path, &source);
        }
    }
    Ok(text)
}

/// The text with the source of the field that a path leads into: replaced where it has one, added where not.
fn with_source(text: &str, path: &str, source: &str) -> String {
    let field = field_of(text, path);
    if let Ok(changed) = set_value(text, &format!("sources[{field:?}]"), source) {
        return changed;
    }
    let entry = format!("\n        {field:?}: {source},");
    match locate(text, "sources") {
        Some(range) => [&text[..=range.start], &entry, &text[range.start + 1..]].concat(),
        // A case without the section: it goes before the bracket that closes the file.
        None => match text.rfind(')') {
            Some(end) => [&text[..end], "    sources: {", &entry, "\n    },\n", &text[end..]].concat(),
            None => text.to_owned(),
        },
    }
}

/// The field that holds the number at `path`: units and enum variants, written around a value, are left off.
fn field_of<'a>(text: &str, path: &'a str) -> &'a str {
    let mut field = path;
    while let Some((parent, _)) = field.rsplit_once('.') {
        let last = parent.rsplit('.').next().unwrap_or(parent);
        let variant = last.starts_with(char::is_uppercase);
        let wrapped = locate(text, parent).is_some_and(|r| text[r].starts_with(char::is_alphabetic));
        if !(variant || wrapped) {
            break;
        }
        field = parent;
    }
    field
}

/// `value` to the power of ten at or below `step`.
fn round_to(value: f64, step: f64) -> f64 {
    if !(step > 0.0 && step.is_finite()) {
        return value;
    }
    let digits = (-step.log10().floor()).clamp(0.0, 15.0) as usize;
    format!("{value:.digits$}").parse().unwrap_or(value)
}

/// Two significant digits.
fn significant(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}
