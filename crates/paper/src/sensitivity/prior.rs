//! Rows of Figures 13 to 24 with all that the paper does not print drawn from its prior at once: what a bearing that
//! was fitted to nothing meets.

use super::hidden::{changes, even, root};
use crate::error::PaperError;
use crate::files;
use crate::progress::Progress;
use crate::transient::{AUTHORS, Change, Set, on_all_cores};
use crate::validate::{PRIOR_DRAWS, Row, Verdict, azimuth_rows, declared_dynamic_rows};
use std::f64::consts::TAU;
use tribodyn_identify::{Parameter, Problem};

/// The problem whose parameters and priors the draws have.
const PROBLEM: &str = include_str!("../../../../fixtures/identify/paper-weighed.ron");
/// Prime numbers behind those of the places of the hidden values: two for each parameter.
const PRIMES: [u8; 16] = [47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97, 101, 103, 107, 109, 113];

/// From one try of a draw to the next, places of the sequence.
const NEXT_TRY: usize = 1_000_003;

/// The value of the parameter with a number in the problem in a draw: of its normal prior (G. E. P. Box and M. E.
/// Muller's way), tried again until it lies within the bounds, or even over the bounds where it has none.
fn value(parameter: &Parameter, k: usize, n: usize) -> f64 {
    let (low, high) = parameter.bounds;
    let place = |draw: usize| [0, 1].map(|i| root(draw, PRIMES[2 * k + i]));
    let Some(prior) = parameter.prior else { return parameter.value(place(n)[0]) };
    let normal = |[u, v]: [f64; 2]| prior.mean + prior.spread * (-2.0 * u.ln()).sqrt() * (TAU * v).cos();
    let tries = (0..).map(|t| normal(place(n + t * NEXT_TRY)));
    tries.take(1000).find(|value| (low..=high).contains(value)).unwrap_or(prior.mean)
}

/// Changes of a draw in all runs.
fn change(problem: &Problem, n: usize) -> Change {
    let mut out = Change { values: changes(&even(n)).to_vec(), ..Change::none(&format!("draw {n}")) };
    for (k, parameter) in problem.parameters.iter().enumerate() {
        let drawn = value(parameter, k, n);
        // The parts of the axial load are set by the runs.
        if parameter.name == "axial load" {
            out.axial_share = 1e3 * drawn / AUTHORS.axial_load;
            continue;
        }
        let written = parameter.paths.iter().map(|path| (path.clone(), format!("{drawn:?}")));
        out.values.extend(written);
    }
    out
}

/// Rows of a draw, joined to what it misses.
fn missed(change: &Change) -> Result<String, PaperError> {
    let axial = ("ring.z".to_owned(), format!("Force(N({}))", AUTHORS.axial_load * change.axial_share));
    let steady = azimuth_rows(AUTHORS.ag, &[change.values.clone(), vec![axial]].concat())?;
    let moving = declared_dynamic_rows(&Set::changed(&AUTHORS, change)?)?;
    let missed = |row: &&Row| row.of_figures() && row.verdict == Verdict::Missed;
    let ids: Vec<&str> = steady.iter().chain(&moving).filter(missed).map(|row| row.id.as_str()).collect();
    Ok(if ids.is_empty() { "none".to_owned() } else { ids.join(" ") })
}

/// Makes so many draws and writes which rows each misses.
///
/// # Errors
///
/// The result cannot be written. A draw without equilibrium, or whose runs fail, is noted in the result.
pub fn run(draws: usize, progress: Progress) -> Result<(), PaperError> {
    let wrong = |source| PaperError::Identify { hypothesis: "priors".to_owned(), source: Box::new(source) };
    let problem = Problem::from_ron(PROBLEM).map_err(wrong)?;
    let all: Vec<usize> = (0..draws).collect();
    let mut lines = Vec::new();
    // Parts, so that there is a sign of life.
    for part in all.chunks(10) {
        lines.extend(on_all_cores(part.len(), |k| {
            let change = change(&problem, part[k]);
            format!("{},{}", change.name, missed(&change).unwrap_or_else(|_| "–".to_owned()))
        }));
        progress(&format!("{} draws", lines.len()));
    }
    let text = format!(
        "# our own output; rewritten by `cargo xtask sensitivity --part prior`\n# rows of Figures 13 to 24 that are \
        missed with all values that the paper does not print drawn from their priors at once, fast scheme at 20 us; – \
        where there is no equilibrium or a run fails\ndraw,missed\n{}\n",
        lines.join("\n")
    );
    files::write(&files::root().join("fixtures/expected").join(PRIOR_DRAWS), text.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_case::{Case, set_value};

    /// Shares of a normal distribution within the bounds: that of 205 ± 5 GPa is whole, half of it within 0.6745
    /// spreads; of 167.5 ± 10 mm from 148 to 170 mm the part above the mean is 0.0987 of 0.5730.
    #[test]
    fn limit_draws_have_the_distribution_of_the_prior() {
        let problem = Problem::from_ron(PROBLEM).unwrap();
        let share = |name: &str, of: &dyn Fn(f64) -> bool| {
            let k = problem.parameters.iter().position(|parameter| parameter.name == name).unwrap();
            let drawn = (0..2000).filter(|n| of(value(&problem.parameters[k], k, *n))).count();
            drawn as f64 / 2000.0
        };
        let half = share("Young's modulus", &|young| (young - 205.0).abs() < 0.6745 * 5.0);
        assert!((half - 0.5).abs() < 0.04, "{half}");
        let above = share("pitch diameter", &|diameter| diameter > 167.5);
        assert!((above - 0.0987 / 0.5730).abs() < 0.03, "{above}");
        assert_eq!(share("pitch diameter", &|diameter| (148.0..=170.0).contains(&diameter)), 1.0);
    }

    #[test]
    fn identity_every_draw_is_a_case() {
        let problem = Problem::from_ron(PROBLEM).unwrap();
        let text = files::read(&files::root().join(AUTHORS.ag)).unwrap();
        for n in 0..30 {
            let set = |text: String, (path, value): &(String, String)| set_value(&text, path, value).unwrap();
            let text = change(&problem, n).values.iter().fold(text.clone(), set);
            Case::from_ron(&text).unwrap_or_else(|e| panic!("{n}: {e}"));
        }
    }
}
