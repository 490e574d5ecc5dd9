//! The cost of oil: bearings of the catalogue solved and run in oil and in silver.

use super::catalogue::written;
use super::changed;
use super::clock::least_per_call;
use super::row::{Limit, Row};
use super::speed::per_second;
use crate::error::Failure;
use tribodyn::answers::OrbitProblem;
use tribodyn_orbit::steady_orbit;
use tribodyn_paper::PaperError;
use tribodyn_quasistatic::{Model, solve};

const GROUP: &str = "oil";
const BEARINGS: [(&str, Option<f64>); 3] = [("6206", None), ("6308", None), ("7210", Some(40.0))];

/// Processor time of an equilibrium with traction and of a steady orbit from a cold start, s.
fn times(text: &str, batches: usize) -> Result<[f64; 2], Failure> {
    let case = changed::<&str>(text, &[])?.case;
    let refused = |source| PaperError::Inputs { run: "bench".to_owned(), source: Box::new(source) };
    let OrbitProblem { bearing, point, cage, settings } = OrbitProblem::of(&case).map_err(refused)?;
    let failed = |what: &'static str, error: String| Failure::Check { what, findings: vec![error] };
    solve(&bearing, &point, Model::Traction).map_err(|error| failed("equilibria of the bench", error.to_string()))?;
    steady_orbit(&bearing, &point, &cage, &settings).map_err(|e| failed("orbits of the bench", e.to_string()))?;
    let equilibrium = least_per_call(batches, 1e-2, || solve(&bearing, &point, Model::Traction));
    Ok([equilibrium, least_per_call(batches.min(5), 1e-2, || steady_orbit(&bearing, &point, &cage, &settings))])
}

pub fn rows(quick: bool) -> Result<Vec<Row>, Failure> {
    let batches = if quick { 3 } else { 20 };
    let mut rows = Vec::new();
    for bearing in BEARINGS {
        let [oil, silver] = [written(bearing, "vg68")?, written(bearing, "ag")?];
        let [in_oil, in_silver] = [times(&oil, batches)?, times(&silver, batches)?];
        for (what, place) in [("equilibrium with traction", 0), ("steady orbit", 1)] {
            let row = Row::new(
                GROUP,
                format!("{}: {what}, VG 68 over silver", bearing.0),
                in_oil[place] / in_silver[place],
                "times",
            );
            let note = format!("{:.1} ms in oil", 1e3 * in_oil[place]);
            rows.push(row.must_be(Limit::AtMost(2.0)).note(note));
        }
    }
    let run = per_second(&written(BEARINGS[2], "vg68")?, &[], 0.02, batches.min(3))?;
    let row = Row::new(GROUP, "7210: run as `new` writes it, simulated over processor time", 1.0 / run, "");
    rows.push(row.must_be(Limit::AtLeast(3.0)));
    Ok(rows)
}
