//! Time of transient runs: the paper's method, the same with the fast kernel, fewer points, the fast scheme.

use super::clock::timed;
use super::patch::mean_points;
use super::row::{Limit, Row};
use super::started;
use crate::error::Failure;
use std::convert::Infallible;
use tribodyn_dynamics::{Checkpoint, Run, RunError};
use tribodyn_paper::PaperError;
use tribodyn_traction::PatchRule;

const GROUP: &str = "transient";
/// Of the shaft at 14 000 r/min, s.
const REVOLUTION: f64 = 60.0 / 14_000.0;

/// The paper's rule and step, the fast scheme and its rules, in words of the case file.
pub const PAPER_RULE: &str = "PolarMidpoint(radial: 10, circumferential: 40)";
pub const PAPER_STEP: &str = "RungeKutta4(step: us(10))";
pub const FAST: &str = "Fast(step: us(20))";
pub const STRIPS_5X3: &str = "SplitStrip(across: 5, along: 3)";
/// Patch rule of a case as it is written for the fast scheme.
pub const TARGET: &str = "TargetError(relative: 1e-4)";
pub const STRIPS_8X3: &str = "SplitStrip(across: 8, along: 3)";
pub const RIG_RATE: &str = "kHz(25.6)";

/// One way to run the case.
struct Plan {
    name: &'static str,
    scheme: &'static str,
    rule: &'static str,
    rate: &'static str,
    plain: bool,
    /// Simulated, s.
    duration: f64,
}

const fn plan(name: &'static str, scheme: &'static str, rule: &'static str, duration: f64) -> Plan {
    Plan { name, scheme, rule, rate: RIG_RATE, plain: false, duration }
}

/// The first is the baseline of all ratios.
const PLANS: [Plan; 6] = [
    Plan { plain: true, ..plan("(a) paper's method: RK4 10 µs, 10 × 40, plain", PAPER_STEP, PAPER_RULE, 2e-3) },
    plan("(b) the same, fast kernel", PAPER_STEP, PAPER_RULE, 4e-3),
    plan("(c) RK4 10 µs, split strips 8 × 3", PAPER_STEP, STRIPS_8X3, 2e-2),
    plan("(d) fast scheme 20 µs, target 1e-4", FAST, TARGET, 0.1),
    plan("(e) fast scheme 20 µs, split strips 5 × 3", FAST, STRIPS_5X3, 0.1),
    Plan { rate: "kHz(1)", ..plan("(f) as (d), samples at 1 kHz", FAST, TARGET, 0.1) },
];
const FAST_KERNEL: usize = 1;
const FAST_SCHEME: usize = 3;

/// A run that starts over from its beginning.
pub struct Prepared {
    run: Run,
    start: Checkpoint,
    least: f64,
    evaluations: f64,
    patches: [f64; 2],
}

impl Prepared {
    pub fn new<V: AsRef<str>>(text: &str, changes: &[(&str, V)], plain: bool) -> Result<Self, Failure> {
        let run = started(text, changes)?;
        let run =
            if plain { run.with_plain_kernel().map_err(|source| failed(RunError::Dynamics(source)))? } else { run };
        Ok(Self { start: run.checkpoint(), run, least: f64::INFINITY, evaluations: 0.0, patches: [0.0; 2] })
    }

    /// Least processor time of a repetition so far, s.
    pub fn least(&self) -> f64 {
        self.least
    }

    /// The fixed step of the run, µs.
    pub fn step_us(&self) -> Option<f64> {
        Some(self.run.step_s()? * 1e6)
    }

    /// Once more from the start to `until`; only stepping and sampling are timed.
    pub fn repeat(&mut self, until: f64) -> Result<(), Failure> {
        self.run.resume(self.start.clone()).map_err(|source| failed(RunError::Dynamics(source)))?;
        let before = self.run.statistics();
        let (time, result) = timed(|| self.run.advance(until, &mut ()));
        let _ = result.map_err(failed)?;
        let after = self.run.statistics();
        self.least = self.least.min(time);
        self.evaluations = (after.evaluations - before.evaluations) as f64;
        self.patches = [after.patches_integrated as f64, after.patches_used as f64];
        Ok(())
    }
}

pub fn failed(error: RunError<Infallible>) -> PaperError {
    let RunError::Dynamics(source) = error;
    PaperError::Transient { run: "bench".to_owned(), source: Box::new(source) }
}

/// Least processor time of a second of the case, s.
pub fn per_second(text: &str, changes: &[(&str, &str)], duration: f64, repetitions: usize) -> Result<f64, Failure> {
    let mut prepared = Prepared::new(text, changes, false)?;
    for _ in 0..repetitions {
        prepared.repeat(duration)?;
    }
    Ok(prepared.least / duration)
}

pub fn rows(text: &str, quick: bool) -> Result<Vec<Row>, Failure> {
    let shorter = if quick { 0.5 } else { 1.0 };
    let mut prepared = Vec::new();
    for plan in &PLANS {
        let changes = [
            ("transient.scheme", plan.scheme),
            ("traction.patch", plan.rule),
            ("recording.state_rate", plan.rate),
            ("recording.ball_rate", "kHz(1)"),
        ];
        prepared.push(Prepared::new(text, &changes, plan.plain)?);
    }
    for _ in 0..if quick { 2 } else { 5 } {
        for (plan, prepared) in PLANS.iter().zip(&mut prepared) {
            prepared.repeat(plan.duration * shorter)?;
        }
    }
    let cost = |k: usize| prepared[k].least / (PLANS[k].duration * shorter);
    let mut rows = Vec::new();
    for (k, plan) in PLANS.iter().enumerate() {
        let row = |what: &str, value: f64, unit| Row::new(GROUP, format!("{}, {what}", plan.name), value, unit);
        let one = &prepared[k];
        let stable = one.run.stiffness().runge_kutta_step_s * 1e6;
        let note = if plan.scheme == PAPER_STEP { format!("stable up to {stable:.1} µs") } else { patches(one) };
        rows.push(row(
            if plan.scheme == FAST { "a step" } else { "all forces once" },
            one.least / one.evaluations * 1e6,
            "µs",
        ));
        rows.push(row("a revolution", cost(k) * REVOLUTION * 1e3, "ms").note(note));
        let ratio = row("times faster than (a)", cost(0) / cost(k), "");
        rows.push(match k {
            0 => continue,
            FAST_KERNEL => ratio.must_be(Limit::AtLeast(2.0)),
            FAST_SCHEME => ratio.must_be(Limit::AtLeast(20.0)),
            _ => ratio,
        });
        let real_time = row("simulated over processor time", 1.0 / cost(k), "");
        rows.push(if k == FAST_SCHEME { real_time.must_be(Limit::AtLeast(5.0)) } else { real_time });
    }
    rows.extend(by_points(text, quick)?);
    Ok(rows)
}

fn patches(one: &Prepared) -> String {
    let [integrated, used] = one.patches;
    format!("{:.1} % of the patches integrated, the others linear", 100.0 * integrated / used)
}

/// Cost of the Runge–Kutta method over the number of points.
fn by_points(text: &str, quick: bool) -> Result<Vec<Row>, Failure> {
    let rules = [
        (STRIPS_5X3, PatchRule::SplitStrip { across: 5, along: 3 }),
        (STRIPS_8X3, PatchRule::SplitStrip { across: 8, along: 3 }),
        ("SplitStrip(across: 10, along: 7)", PatchRule::SplitStrip { across: 10, along: 7 }),
        ("SplitStrip(across: 16, along: 8)", PatchRule::SplitStrip { across: 16, along: 8 }),
    ];
    let mut rows = Vec::new();
    for (name, rule) in rules {
        let changes = [("transient.scheme", PAPER_STEP), ("traction.patch", name)];
        let cost = per_second(text, &changes, 4e-3, if quick { 2 } else { 5 })?;
        let quantity = format!("RK4 10 µs, {:.0} points a patch, a revolution", mean_points(rule)?);
        rows.push(Row::new("points", quantity, cost * REVOLUTION * 1e3, "ms").note(name));
    }
    Ok(rows)
}
