//! One hypothesis: its fit, and what the fitted set meets.

use super::adapt;
use crate::error::PaperError;
use crate::progress::Progress;
use crate::transient::{AUTHORS, Change, Set};
use crate::validate::{Row, Share, Tally, azimuth_rows_of, declared_dynamic_rows};
use tribodyn_bearing::SearchWatch;
use tribodyn_case::locate;
use tribodyn_identify::{Hypothesis, Identification, IdentifyError, LeastSquares, Problem, identify_one};

/// Runs of the figures, where they have a set of their own.
const OF_FIGURES: &str = "figures, case 1";
/// The same of the tables.
const OF_TABLES: &str = "case 1";
/// Columns behind the names.
const COLUMNS: usize = 12;

/// The cells of a fit that failed.
pub fn nothing() -> String {
    ["–"; COLUMNS].join(",")
}

/// Fits a hypothesis and returns its cells.
pub fn fit(problem: &Problem, case: &str, hypothesis: &Hypothesis, progress: Progress) -> Result<String, PaperError> {
    let failed = |source| PaperError::Identify { hypothesis: hypothesis.name.clone(), source: Box::new(source) };
    let adapt = adapt::named(&hypothesis.name);
    let watch = SearchWatch::default();
    let found = identify_one(problem, case, Some(hypothesis), adapt.clone(), &|| (), &watch).map_err(failed)?;
    let values: Vec<f64> = found.parameters.iter().map(|p| p.value).collect();
    let text = set_of_figures(problem, case, hypothesis, &values).map_err(failed)?;
    let steady = azimuth_rows_of(&hypothesis.name, &text, adapt.as_ref())?;
    let change = Change { adapt, ..change(&hypothesis.name, case, &text) };
    let moving = Set::changed(&AUTHORS, &change).and_then(|set| declared_dynamic_rows(&set));
    let moving = moving.inspect_err(|reason| progress(&format!("{}: {reason}", hypothesis.name)));
    Ok(cells(&found, steady, moving.ok()))
}

/// The case of a fitted set, the one of the figures where these have their own, with the patch rule of the case.
pub fn set_of_figures(
    problem: &Problem,
    case: &str,
    hypothesis: &Hypothesis,
    values: &[f64],
) -> Result<String, IdentifyError> {
    let plain = Problem { search: std::collections::BTreeMap::new(), ..problem.clone() };
    let model = LeastSquares::new(&plain, case, Some(hypothesis))?.model;
    let text = model.run_text(OF_FIGURES, values).or_else(|| model.run_text(OF_TABLES, values));
    Ok(text.unwrap_or_else(|| model.case_text(values)))
}

/// Differences of a run of the study from the case: all that a fit may change.
fn change(name: &str, before: &str, after: &str) -> Change {
    const FITTED: [&str; 12] = [
        "geometry.pitch_diameter",
        "geometry.inner_groove",
        "geometry.outer_groove",
        "materials.ball.young",
        "materials.inner.young",
        "materials.outer.young",
        "traction.slip_unit",
        "fluid.drag_coefficient",
        "ring.x",
        "ring.tilt_y",
        "modelling.gyroscopic_friction",
        "modelling.gyroscopic_moment",
    ];
    let at = |text: &str, path: &str| locate(text, path).map(|range| text[range].to_owned());
    let changed = |path: &str| {
        let value = at(after, path)?;
        (at(before, path).as_ref() != Some(&value)).then(|| (path.to_owned(), value))
    };
    let values = FITTED.into_iter().filter_map(changed).collect();
    let axial = at(after, "ring.z.Force.kN").and_then(|text| text.parse::<f64>().ok());
    let axial_share = axial.map_or(1.0, |kilonewtons| 1e3 * kilonewtons / AUTHORS.axial_load);
    Change { values, axial_share, ..Change::none(name) }
}

/// The cells of a fit with its rows over azimuth, and those of its runs where these reached their end.
fn cells(found: &Identification, steady: Vec<Row>, moving: Option<Vec<Row>>) -> String {
    let worst = |prefix: &str, relative: bool| {
        let data = found.data.iter().filter(|d| d.id.starts_with(prefix));
        data.map(|d| (d.deviation / if relative { 0.01 * d.value } else { 1.0 }).abs()).fold(0.0, f64::max)
    };
    let few = Tally::of(steady.clone());
    let all = moving.map(|moving| Tally::of([steady, moving].concat()));
    let of_all = |share: fn(&Tally) -> Share| all.as_ref().map_or("–".to_owned(), |tally| share(tally).to_string());
    let bounds: Vec<&str> = found.parameters.iter().filter(|p| p.at_bound).map(|p| p.name.as_str()).collect();
    let diameter = found.parameters.iter().find(|p| p.name == "pitch diameter");
    let cells = [
        format!("{:.1}", found.cost),
        format!("{:.1}", found.data_cost),
        format!("{:.1}", found.log_evidence),
        if bounds.is_empty() { "none".to_owned() } else { bounds.join(" and ") },
        format!("{:.2}", worst("T4", true)),
        format!("{:.3}", worst("T5", false)),
        few.view.to_string(),
        few.kept.to_string(),
        of_all(|tally| tally.view),
        of_all(|tally| tally.kept),
        diameter.map_or_else(|| "–".to_owned(), |d| format!("{:.2} ± {:.2}", d.value, d.spread)),
        found.parameters.iter().map(|p| format!("{:.8e}", p.value)).collect::<Vec<_>>().join(" "),
    ];
    cells.join(",")
}
