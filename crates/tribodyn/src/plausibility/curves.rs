//! Traction curves that are used outside the pressures at which they were tested, or that nobody tested.

use std::ops::RangeInclusive;
use tribodyn_bearing::Side;
use tribodyn_case::{Case, CoatingSpec, CurveSpec};
use tribodyn_quasistatic::Solution;
use tribodyn_traction::Coating;

/// Lowest and highest tested pressure of a curve, GPa.
pub fn tested_gpa(curve: &CurveSpec) -> Option<RangeInclusive<f64>> {
    let pressures: Vec<f64> = match curve {
        CurveSpec::Library(name) => Coating::library(name).ok()?.tested.iter().map(|test| test.pressure).collect(),
        CurveSpec::Tested(points) => points.iter().map(|point| point.pressure).collect(),
    };
    let extreme = |start: f64, pick: fn(f64, f64) -> f64| 1e-9 * pressures.iter().copied().fold(start, pick);
    (!pressures.is_empty()).then(|| extreme(f64::INFINITY, f64::min)..=extreme(0.0, f64::max))
}

/// Pressures between which a curve follows the pressure, GPa.
fn valid_gpa(curve: &CurveSpec) -> Option<RangeInclusive<f64>> {
    match curve {
        CurveSpec::Library(name) => {
            let [low, high] = Coating::library(name).ok()?.valid_pressure;
            Some(1e-9 * low..=1e-9 * high)
        }
        CurveSpec::Tested(_) => tested_gpa(curve),
    }
}

/// Sentences on the curves of a solution whose balls slide: pressures beyond those of the tests, and curves that nobody
/// tested.
pub fn curve_findings(case: &Case, solution: &Solution) -> Vec<String> {
    let (Some(coatings), Some(traction)) = (&case.coatings, &case.traction) else { return Vec::new() };
    let slides = solution.balls.iter().any(|ball| ball.contacts.inner.friction.is_some()) && solution.turns();
    if !slides {
        return Vec::new();
    }
    let races: [(&str, Side, &CoatingSpec); 2] =
        [("inner", Side::Inner, &coatings.inner), ("outer", Side::Outer, &coatings.outer)];
    let one = |(race, side, coating): (&str, Side, &CoatingSpec)| {
        let tested = tested_gpa(&coating.curve)?;
        if let CurveSpec::Library(name) = &coating.curve
            && let Some(assumed) = Coating::library(name).ok()?.source.strip_prefix("Assumed: ")
        {
            return Some(format!("the traction curve `{name}` of the {race} race is assumed, not tested: {assumed}"));
        }
        if traction.varying {
            at_pressures((race, side), (tested, valid_gpa(&coating.curve)?), solution)
        } else {
            at_one((race, 1e-9 * traction.reference_pressure), &tested)
        }
    };
    races.into_iter().filter_map(one).collect()
}

fn at_pressures(
    (race, side): (&str, Side),
    (tested, valid): (RangeInclusive<f64>, RangeInclusive<f64>),
    solution: &Solution,
) -> Option<String> {
    let loaded = solution.balls.iter().map(|ball| &ball.contacts[side]).filter(|contact| contact.load_n > 0.0);
    let pressures: Vec<f64> = loaded.map(|contact| 1e-9 * contact.peak_pressure_pa).collect();
    let share = |range: &RangeInclusive<f64>| {
        let outside = pressures.iter().filter(|pressure| !range.contains(pressure)).count();
        100.0 * outside as f64 / pressures.len() as f64
    };
    if pressures.is_empty() || share(&tested) == 0.0 {
        return None;
    }
    let least = pressures.iter().copied().fold(f64::INFINITY, f64::min);
    let most = pressures.iter().copied().fold(0.0, f64::max);
    let beyond = match share(&valid) {
        0.0 => String::new(),
        part => format!(", in {part:.0} % beyond {} to {} GPa, where it is held constant", valid.start(), valid.end()),
    };
    Some(format!(
        "pressures on the {race} race are {least:.3} to {most:.3} GPa, its traction curve was tested at {} to {} GPa: \
         it is extrapolated in {:.0} % of the contacts{beyond}",
        tested.start(),
        tested.end(),
        share(&tested)
    ))
}

fn at_one((race, reference): (&str, f64), tested: &RangeInclusive<f64>) -> Option<String> {
    (!tested.contains(&reference)).then(|| {
        format!(
            "the traction curve of the {race} race is taken at {reference} GPa and was tested at {} to {} GPa: it is \
             extrapolated",
            tested.start(),
            tested.end()
        )
    })
}
