//! Figure 9: the traction curves themselves, over the whole range of use.

use super::row::{Claim, Evidence, Row};
use super::tables::PARABOLA;
use crate::error::PaperError;
use tribodyn_traction::{Coating, CoatingLaw, SlipCurve, TractionLaw};

const COATINGS: [&str; 2] = ["ag", "ptfe"];
/// Range of use (section 5.1.1), GPa.
const RANGE: [f64; 2] = [1.5, 4.0];
/// The tested pressures, which Figure 9 shows, GPa.
const TESTS: [f64; 2] = [2.5, 3.5];
/// Steps over the range of use: 0.025 GPa.
const PRESSURES: usize = 100;
/// Greatest slip looked at: six times that of the peak, where κ has come down to its residual.
const SLIP: f64 = 20.0;
/// Steps over the slip.
const SLIPS: usize = 200;

/// F9.1 for each coating and F9.2, each at the tests and over the whole range of use.
pub fn figure_9() -> Result<Vec<Row>, PaperError> {
    let [silver, ptfe] = COATINGS.map(|name| CoatingLaw::varying(&Coating::library(name)?, PARABOLA));
    let (silver, ptfe) = (silver?, ptfe?);
    Ok(vec![
        falling("F9.1.ag.tests", &silver, TESTS),
        falling("F9.1.ag.range", &silver, RANGE),
        falling("F9.1.ptfe.tests", &ptfe, TESTS),
        falling("F9.1.ptfe.range", &ptfe, RANGE),
        steeper("F9.2.tests", &silver, &ptfe, TESTS),
        steeper("F9.2.range", &silver, &ptfe, RANGE),
    ])
}

fn pressure(step: usize) -> f64 {
    RANGE[0] + (RANGE[1] - RANGE[0]) * step as f64 / PRESSURES as f64
}

/// The largest rise of κ over one step of pressure, per GPa, at any slip.
fn steepest_rise(law: &CoatingLaw, step: usize) -> f64 {
    let (low, high) = (law.at(pressure(step) * 1e9), law.at(pressure(step + 1) * 1e9));
    let gap = pressure(step + 1) - pressure(step);
    let rise = |slip: f64| (high.coefficient(slip) - low.coefficient(slip)) / gap;
    (1..=SLIPS).map(|i| rise(SLIP * i as f64 / SLIPS as f64)).fold(f64::NEG_INFINITY, f64::max)
}

/// The steps within a range of pressure.
fn steps([low, high]: [f64; 2]) -> impl Iterator<Item = usize> {
    // Half a step of slack: the ends are grid points up to rounding.
    let slack = 0.5 * (pressure(1) - pressure(0));
    (0..PRESSURES).filter(move |&step| pressure(step) > low - slack && pressure(step + 1) < high + slack)
}

/// Figure 9 shows the tested pressures; what the parabolas do beyond them the paper does not say.
fn evidence(range: [f64; 2]) -> Evidence {
    if range == TESTS { Evidence::Verification } else { Evidence::Beside }
}

/// F9.1: κ falls with pressure at every slip.
fn falling(id: &'static str, law: &CoatingLaw, range: [f64; 2]) -> Row {
    let claim = Claim {
        id,
        evidence: evidence(range),
        text: "κ falls as pressure rises, at every slip",
        measured: if range == TESTS { "largest dκ/dp, 2.5–3.5 GPa" } else { "largest dκ/dp, 1.5–4 GPa" },
        unit: "1/GPa",
    };
    let worst = steps(range).map(|step| steepest_rise(law, step)).fold(f64::NEG_INFINITY, f64::max);
    let rising = spans(steps(range).filter(|&step| steepest_rise(law, step) > 0.0));
    let place = match rising.as_slice() {
        [] => "falls everywhere".to_owned(),
        spans => format!("rises with pressure at some slip at {} GPa", spans.join(", ")),
    };
    let note = format!("parabolas through the three tests; met if negative; κ {place}");
    Row { decimals: 4, ..Row::claim(&claim, worst, worst < 0.0, note) }
}

/// Runs of neighbouring steps as ranges of pressure.
fn spans(steps: impl Iterator<Item = usize>) -> Vec<String> {
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for step in steps {
        match runs.last_mut() {
            Some(run) if run[1] == step => run[1] = step + 1,
            _ => runs.push([step, step + 1]),
        }
    }
    runs.iter().map(|run| format!("{:.3}–{:.3}", pressure(run[0]), pressure(run[1]))).collect()
}

/// F9.2: PTFE's initial slope is steeper.
fn steeper(id: &'static str, silver: &CoatingLaw, ptfe: &CoatingLaw, range: [f64; 2]) -> Row {
    let claim = Claim {
        id,
        evidence: evidence(range),
        text: "PTFE's initial slope is steeper than Ag's",
        measured: if range == TESTS {
            "least slope ratio PTFE/Ag, 2.5–3.5 GPa"
        } else {
            "least slope ratio PTFE/Ag, 1.5–4 GPa"
        },
        unit: "",
    };
    let ratio = |p: f64| ptfe.at(p * 1e9).initial_slope() / silver.at(p * 1e9).initial_slope();
    let least_of = |step: usize| ratio(pressure(step)).min(ratio(pressure(step + 1)));
    let least = steps(range).map(least_of).fold(f64::INFINITY, f64::min);
    let gentler = spans(steps(range).filter(|&step| least_of(step) <= 1.0));
    let place = if gentler.is_empty() { String::new() } else { format!("; not steeper at {} GPa", gentler.join(", ")) };
    Row::claim(&claim, least, least > 1.0, format!("initial slopes; met above 1{place}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_neighbouring_steps_are_one_span() {
        assert_eq!(spans([0, 1, 2, 10].into_iter()), ["1.500–1.575", "1.750–1.775"].map(str::to_owned));
        assert!(spans(std::iter::empty()).is_empty());
    }

    #[test]
    fn identity_ranges_end_where_they_say() {
        let ends = |range| (steps(range).next().map(pressure), steps(range).last().map(|step| pressure(step + 1)));
        assert_eq!(ends(RANGE), (Some(1.5), Some(4.0)));
        assert_eq!(ends(TESTS), (Some(2.5), Some(3.5)));
    }

    #[test]
    fn limit_a_constant_law_neither_rises_nor_falls() {
        let law = CoatingLaw::fixed(&Coating::library("ag").unwrap(), PARABOLA, 2.5e9).unwrap();
        assert!((0..PRESSURES).all(|step| steepest_rise(&law, step) == 0.0));
        assert_eq!(falling("x", &law, RANGE).verdict, super::super::row::Verdict::Missed);
    }
}
