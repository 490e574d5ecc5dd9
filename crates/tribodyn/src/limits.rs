//! How much work and memory a file may ask for.
//!
//! A case of a few lines can name a hundred million balls, and a recording may hold such a case, or content that grows
//! a thousandfold when it is decompressed. Files come from elsewhere too, so that what they ask for is bounded, far
//! above what bearings have. Who knows a file can lift the limits.

use std::fmt::Display;
use tribodyn_bearing::Scheme;
use tribodyn_case::{Case, CaseError, locate};
use tribodyn_traction::{PatchChoice, PatchRule};

/// Bounds on what a file may ask for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Size of a case, a problem or a table of figures, bytes. The cases of the project have 5 to 8 kB.
    pub text_bytes: u64,
    /// Balls. The largest slewing bearings have some 200.
    pub balls: usize,
    /// Nodes of the patch rule at all contacts together. The finest rule in use has 6400 at each of 13 balls.
    pub nodes: usize,
    /// Iterations of the solver: those of the project's cases stop at 200.
    pub iterations: usize,
    /// Fixed steps of a run: a day of computing at 13 balls.
    pub steps: f64,
    /// Samples of a run: some 30 GB.
    pub samples: f64,
    /// Numbers of a recording in memory, bytes: 80 s of a run with 13 balls at the usual rates.
    pub recording_bytes: u64,
}

impl Limits {
    /// For files from anywhere.
    pub const NORMAL: Self = Self {
        text_bytes: 1 << 20,
        balls: 500,
        nodes: 1_000_000,
        iterations: 1000,
        steps: 1e9,
        samples: 1e8,
        recording_bytes: 2 << 30,
    };
    /// None at all.
    pub const NONE: Self = Self {
        text_bytes: u64::MAX,
        balls: usize::MAX,
        nodes: usize::MAX,
        iterations: usize::MAX,
        steps: f64::INFINITY,
        samples: f64::INFINITY,
        recording_bytes: u64::MAX,
    };

    /// Holds a case against the limits; the error points into its text.
    ///
    /// # Errors
    /// The first value that asks for too much.
    pub fn check(&self, text: &str, case: &Case) -> Result<(), CaseError> {
        let balls = case.geometry.ball_count;
        above("geometry.ball_count", balls as f64, self.balls as f64, "balls", text)?;
        let nodes = case.patch().map_or(0.0, |patch| 2.0 * nodes(patch) * balls as f64);
        let path = if case.lubricant.is_some() { "lubricant.patch" } else { "traction.patch" };
        above(path, nodes, self.nodes as f64, "nodes at all contacts", text)?;
        let iterations = case.numerics.max_iterations;
        above("numerics.max_iterations", iterations as f64, self.iterations as f64, "iterations", text)?;
        let Some(transient) = &case.transient else { return Ok(()) };
        if let Scheme::RungeKutta4 { step } | Scheme::Fast { step } = transient.scheme {
            above("transient.scheme", transient.duration / step, self.steps, "steps", text)?;
        }
        let rate = case.recording.map_or(0.0, |recording| recording.state_rate);
        above("recording.state_rate", transient.duration * rate, self.samples, "samples", text)
    }
}

impl Default for Limits {
    fn default() -> Self {
        Self::NORMAL
    }
}

/// Nodes of a rule in one contact; a rule that is chosen by its error is as fine as the solver makes it.
fn nodes(choice: PatchChoice) -> f64 {
    let [a, b] = match choice {
        PatchChoice::Named(PatchRule::PolarMidpoint { radial, circumferential }) => [radial, circumferential],
        PatchChoice::Named(PatchRule::GaussJacobi { radial, angles }) => [radial, angles],
        PatchChoice::Named(PatchRule::SplitStrip { across, along }) => [across, along],
        PatchChoice::TargetError { .. } => [1, 1],
    };
    a as f64 * b as f64
}

fn above(path: &str, value: f64, limit: f64, of: &str, text: &str) -> Result<(), CaseError> {
    if value <= limit {
        return Ok(());
    }
    let range = locate(text, path).unwrap_or(0..0);
    let before = &text[..range.start];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    Err(CaseError {
        line: 1 + before.matches('\n').count(),
        column: 1 + before[line_start..].chars().count(),
        path: path.to_owned(),
        value: text[range.clone()].chars().take(80).collect(),
        message: format!("{} {of}; {}", short(value), lifted(short(limit))),
        offset: range.start,
        length: range.len(),
    })
}

/// Up to a million in full.
fn short(value: f64) -> String {
    if value <= 1e6 { format!("{value:.0}") } else { format!("{value:.3e}") }
}

/// The end of a message about a limit.
pub fn lifted(limit: impl Display) -> String {
    format!("the limit for files that may come from elsewhere is {limit}, which --no-limits lifts")
}

#[cfg(test)]
mod tests {
    use super::Limits;
    use tribodyn_case::{Case, set_value};

    const CASE: &str = include_str!("../../../fixtures/cases/paper-ag-worn.ron");

    fn refused(changes: &[(&str, &str)]) -> String {
        let text = changes.iter().fold(CASE.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap());
        let case = Case::from_ron(&text).unwrap();
        assert_eq!(Limits::NONE.check(&text, &case), Ok(()));
        Limits::NORMAL.check(&text, &case).unwrap_err().to_string()
    }

    #[test]
    fn limit_what_asks_for_too_much_is_named() {
        let case = Case::from_ron(CASE).unwrap();
        assert_eq!(Limits::NORMAL.check(CASE, &case), Ok(()));
        let land = ("cage.guidance.radius", "m(20.01)");
        let far = [("geometry.ball_count", "800"), ("geometry.pitch_diameter", "m(40)"), land];
        assert_eq!(
            refused(&far),
            "geometry.ball_count = 800: 800 balls; the limit for files that may come from elsewhere is 500, which --no-limits lifts"
        );
        let fine = [("traction.patch", "PolarMidpoint(radial: 1000, circumferential: 1000)")];
        assert!(refused(&fine).starts_with("traction.patch = PolarMidpoint(radial: 1000"), "{}", refused(&fine));
        assert!(refused(&[("numerics.max_iterations", "100000")]).starts_with("numerics.max_iterations = 100000"));
        let long = [("transient.scheme", "Fast(step: us(0.001))"), ("transient.duration", "s(100)")];
        assert!(refused(&long).starts_with("transient.scheme = Fast"), "{}", refused(&long));
        let dense = [("recording.state_rate", "kHz(1000)"), ("transient.duration", "s(900)")];
        assert!(refused(&dense).contains("samples"), "{}", refused(&dense));
    }
}
