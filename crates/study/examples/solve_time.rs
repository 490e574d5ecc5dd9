//! Least wall time of some solves of a case by one model, ms: what the same call from Python is compared with.
//!
//!     cargo run --release -p tribodyn-study --example solve_time -- CASE [jones-harris|traction|steady-orbit] [TIMES]

use std::time::Instant;
use tribodyn::Limits;
use tribodyn::answers::{OrbitProblem, equilibrium};
use tribodyn_bearing::SearchWatch;
use tribodyn_quasistatic::Model;
use tribodyn_study::{StudyError, read_case};

fn main() -> Result<(), StudyError> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().unwrap_or_else(|| "fixtures/cases/paper-ag.ron".to_owned());
    let model = arguments.next().unwrap_or_else(|| "traction".to_owned());
    let times = arguments.next().and_then(|count| count.parse().ok()).unwrap_or(20);
    let file = read_case(path.as_ref(), &[], &Limits::NORMAL)?;
    let question = file.question(SearchWatch::default());
    let mut least = f64::INFINITY;
    for _ in 0..times {
        let began = Instant::now();
        match model.as_str() {
            "jones-harris" => drop(equilibrium(&question, Model::JonesHarris, false)?),
            "traction" => drop(equilibrium(&question, Model::Traction, false)?),
            _ => drop(OrbitProblem::new(&question)?.solve(question.name)?),
        }
        least = least.min(began.elapsed().as_secs_f64());
    }
    println!("{:.4}", 1e3 * least);
    Ok(())
}
