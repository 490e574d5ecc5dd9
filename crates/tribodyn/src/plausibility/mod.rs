//! Plausibility: values and results that are possible, but not usual.
//!
//! A validated case may still say that steel has 208 MPa. What lies outside its usual range is named with value,
//! range and source of the range, and where another unit or a decimal point would bring it back, that is said too.
//! Nothing is refused.

mod balls;
mod curves;
mod estimate;
mod findings;
mod implausible;
mod ranges;
mod side;

pub use curves::{curve_findings, tested_gpa};
pub use estimate::{NO_LOAD, StaticEstimate, case_loads, estimate, hopeless, inelastic, is_loaded, peak_pressure};
pub(crate) use estimate::{PRESSURE_MOST, not_elastic};
pub use findings::{SolutionFindings, case_findings, solution_findings, speed_finding};
pub use implausible::{Implausible, advice, names};
pub use ranges::{USUAL_RANGES, UsualRange, usual_range};
pub use side::little_thrust;

use tribodyn_bearing::{Bearing, BearingError};
use tribodyn_case::{Case, Quantity, quantities};
use tribodyn_quasistatic::Solution;

/// All that is unusual about the values of a case, given with its text.
pub fn of_case(case: &Case, (text, bearing): (&str, &Bearing)) -> Vec<String> {
    let load = estimate(case, bearing).and_then(|estimate| estimate.warning(case, (text, bearing)));
    load.into_iter().chain(unusual_values(text)).chain(case_findings(case, bearing)).collect()
}

/// All that is unusual about the values of a case, given with its text, and about its solution.
///
/// # Errors
/// [`BearingError`] where the case has no geometry.
pub fn of_solution(
    case: &Case,
    (text, bearing): (&str, &Bearing),
    solution: &Solution,
) -> Result<SolutionFindings, BearingError> {
    let mut found = solution_findings(case, bearing, solution)?;
    found.sentences.splice(0..0, of_case(case, (text, bearing)));
    Ok(found)
}

/// Sentences on single values of a case's text outside their usual ranges.
pub fn unusual_values(text: &str) -> Vec<String> {
    let mut sentences: Vec<String> = quantities(text).iter().filter_map(unusual).collect();
    // Alike springs about two axes are said once.
    sentences.dedup();
    sentences
}

fn unusual(quantity: &Quantity) -> Option<String> {
    let range = usual_range(&quantity.path)?;
    if range.holds(quantity.value) {
        return None;
    }
    let Quantity { path, written, .. } = quantity;
    let (unit, size) = range.unit;
    let in_unit =
        |value: f64| format!("{}{}{unit}", shown(value / size), if matches!(unit, "" | "°") { "" } else { " " });
    let usual = format!("usual is {} to {}", shown(range.least / size), in_unit(range.most));
    let slip = slip(quantity, range).map(|slip| format!("; {slip}")).unwrap_or_default();
    Some(format!("`{path}` is {written}, {}: {usual} ({}){slip}", in_unit(quantity.value), range.source))
}

/// The slip of the unit or of the decimal point that the value looks like.
fn slip(quantity: &Quantity, range: &UsualRange) -> Option<String> {
    let meant = quantity.otherwise().into_iter().filter(|(_, si)| range.holds(*si)).map(|(text, _)| text);
    let meant: Vec<String> = meant.collect();
    if !meant.is_empty() {
        return Some(format!("{} would be: a slip of the unit?", meant.join(" or ")));
    }
    let factors = [(10.0, "ten"), (1e3, "a thousand"), (1e6, "a million")];
    let times = |factor: f64| range.holds(quantity.value * factor) && quantity.value != 0.0;
    factors.iter().find_map(|(factor, word)| {
        let how = match (times(*factor), times(1.0 / factor)) {
            (true, _) => "small",
            (_, true) => "large",
            _ => return None,
        };
        Some(format!("{word} times too {how}: a slip of the unit or of the decimal point?"))
    })
}

/// A number with three digits, as a person writes it.
pub(crate) fn shown(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        let digits = (2 - value.abs().max(1e-3).log10().floor() as i32).clamp(0, 6) as usize;
        let text = format!("{value:.digits$}");
        return if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text };
    }
    format!("{value:.2e}")
}

#[cfg(test)]
mod tests;
