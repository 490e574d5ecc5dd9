//! Time of steady orbits, from a cold start and from a neighbour; and of runs with elastic patches.

use super::changed;
use super::clock::least_per_call;
use super::row::{Limit, Row};
use super::speed::{FAST, per_second};
use crate::error::Failure;
use tribodyn::answers::OrbitProblem;
use tribodyn_bearing::RingFreedom;
use tribodyn_orbit::{OrbitError, steady_orbit, steady_orbit_from};
use tribodyn_paper::PaperError;

const GROUP: &str = "steady orbit";
/// Strips and cells of an elastic patch.
const ELASTIC: &str = "Elastic(strips: 8, cells: 16)";

fn unsolved(source: OrbitError) -> Failure {
    Failure::Check { what: "steady orbits of the bench", findings: vec![source.to_string()] }
}

pub fn rows(text: &str, quick: bool) -> Result<Vec<Row>, Failure> {
    let batches = if quick { 3 } else { 40 };
    let case = changed::<&str>(text, &[])?.case;
    let refused = |source| PaperError::Inputs { run: "bench".to_owned(), source: Box::new(source) };
    let OrbitProblem { bearing, point, cage, settings } = OrbitProblem::of(&case).map_err(refused)?;
    let cold = || steady_orbit(&bearing, &point, &cage, &settings);
    let start = cold().map_err(unsolved)?.start;
    let Some(start) = start else { unreachable!("a bearing that turns has an orbit to go on from") };
    let row = |quantity: &str, value: f64| Row::new(GROUP, quantity, value * 1e3, "ms");
    let mut rows = vec![row("cold", least_per_call(batches, 1e-2, cold)).must_be(Limit::AtMost(30.0))];
    for (name, share, limit) in
        [("0.2 % in load and 0.1 % in speed", 2e-3, Some(5.0)), ("ten times as far", 2e-2, None)]
    {
        let mut near = point.clone();
        for freedom in &mut near.ring {
            if let RingFreedom::Loaded(load) = freedom {
                *load *= 1.0 + share;
            }
        }
        near.inner_speed *= 1.0 + 0.5 * share;
        let warm = || steady_orbit_from(&bearing, &near, &cage, &settings, &start);
        warm().map_err(unsolved)?;
        let measured = row(&format!("warm, {name}"), least_per_call(batches, 1e-2, warm));
        rows.push(match limit {
            Some(limit) => measured.must_be(Limit::AtMost(limit)),
            None => measured,
        });
    }
    let elastic = per_second(text, &[("transient.scheme", FAST), ("modelling.patch", ELASTIC)], 0.1, batches.min(3))?;
    let row = Row::new("elastic patch", "fast scheme 20 µs, simulated over processor time", 1.0 / elastic, "");
    rows.push(row.must_be(Limit::AtLeast(1.0)).note("2 × 8 strips, 16 cells a strip"));
    Ok(rows)
}
