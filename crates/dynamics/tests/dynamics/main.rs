//! Whole runs: equilibria that stay, orders of convergence, symmetries, schemes against each other, trouble.

mod accuracy;
mod aliasing;
mod ball_spall;
mod cage;
mod companion;
mod equilibrium;
mod faults;
mod own_law;
mod schemes;
mod symmetry;
mod tilt;
mod trouble;
mod wear;

use std::convert::Infallible;
use std::ops::ControlFlow;
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{Event, Observer, Run, Sample};

/// The cryogenic bearing of the paper with its silver coating.
const PAPER_AG: &str = include_str!("../../../../fixtures/cases/paper-ag.ron");
const OIL_6206: &str = include_str!("../../../../fixtures/cases/oil-6206.ron");
/// A cheap patch rule: the tests here are about motion, not about quadrature.
const STRIPS: (&str, &str) = ("traction.patch", "SplitStrip(across: 5, along: 3)");

/// The paper's case with some of its values replaced.
fn case(changes: &[(&str, &str)]) -> Case {
    let changed = std::iter::once(&STRIPS).chain(changes).fold(PAPER_AG.to_owned(), |text, (path, value)| {
        set_value(&text, path, value).unwrap_or_else(|e| panic!("{path}: {e}"))
    });
    Case::from_ron(&changed).unwrap_or_else(|e| panic!("{e}"))
}

/// Keeps everything.
#[derive(Default)]
struct Keep {
    samples: Vec<Sample>,
    with_balls: usize,
    events: Vec<Event>,
    /// Breaks off after so many samples, where above 0.
    stop_after: usize,
}

impl Observer for Keep {
    type Error = Infallible;

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, Infallible> {
        self.samples.push(sample.clone());
        self.with_balls += usize::from(with_balls);
        let stop = self.stop_after > 0 && self.samples.len() >= self.stop_after;
        Ok(if stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
    }

    fn event(&mut self, event: &Event) -> Result<(), Infallible> {
        self.events.push(event.clone());
        Ok(())
    }
}

/// Runs a case to its end.
fn run(case: &Case) -> (Run, Keep) {
    let mut run = Run::new(case.run_inputs().unwrap()).unwrap_or_else(|e| panic!("{e}"));
    let mut keep = Keep::default();
    let _ = run.advance(f64::INFINITY, &mut keep).unwrap_or_else(|e| panic!("{e}"));
    (run, keep)
}
