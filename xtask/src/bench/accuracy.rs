//! Errors of the paper's patch and step and of the fast scheme against a converged run from the same start.

use super::row::{Limit, Row};
use super::speed::{FAST, PAPER_RULE, PAPER_STEP, STRIPS_5X3, TARGET, failed};
use super::started;
use crate::error::Failure;
use std::convert::Infallible;
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use tribodyn_dynamics::{Checkpoint, Event, Observer, RunError, Sample};
use tribodyn_paper::{mean, rms};

const GROUP: &str = "error";
/// Scheme and patch rule of the converged run.
const REFERENCE: [&str; 2] = ["RungeKutta4(step: us(2.5))", "SplitStrip(across: 16, along: 8)"];

/// Compared values of one sample.
struct Moment {
    time: f64,
    cage_angle: f64,
    /// Of the outer ring, x and y, m/s².
    acceleration: [f64; 2],
    /// Load at inner and outer contact of each ball, N.
    loads: Vec<[f64; 2]>,
    /// Traction on each ball along the orbit and across the groove, inner and outer, N.
    tractions: Vec<[f64; 4]>,
}

#[derive(Default)]
struct Trace(Vec<Moment>);

impl Observer for Trace {
    type Error = Infallible;

    fn sample(&mut self, s: &Sample, _: bool) -> Result<ControlFlow<()>, Infallible> {
        let [x, y, _] = s.outer.acceleration_point_m_s2;
        self.0.push(Moment {
            time: s.time_s,
            cage_angle: s.cage.angle_rad,
            acceleration: [x, y],
            loads: s.balls.iter().map(|b| [b.contacts.inner.load_n, b.contacts.outer.load_n]).collect(),
            tractions: s
                .balls
                .iter()
                .map(|b| {
                    [
                        b.contacts.inner.friction_or_nan().traction_n[0],
                        b.contacts.inner.friction_or_nan().traction_n[1],
                        b.contacts.outer.friction_or_nan().traction_n[0],
                        b.contacts.outer.friction_or_nan().traction_n[1],
                    ]
                })
                .collect(),
        });
        Ok(ControlFlow::Continue(()))
    }

    fn event(&mut self, _: &Event) -> Result<(), Infallible> {
        Ok(())
    }
}

/// Runs the case; from `start` where there is one.
fn trace(
    text: &str,
    [scheme, rule]: [&str; 2],
    duration: f64,
    start: Option<&Checkpoint>,
) -> Result<(Trace, Checkpoint), Failure> {
    let length = format!("s({duration})");
    let changes = [("transient.scheme", scheme), ("traction.patch", rule), ("transient.duration", &length)];
    let failure = |source| failed(RunError::Dynamics(source));
    let mut run = started(text, &changes)?;
    if let Some(start) = start {
        run.resume(start.clone()).map_err(failure)?;
    }
    let start = run.checkpoint();
    let mut trace = Trace::default();
    let _ = run.advance(f64::INFINITY, &mut trace).map_err(failed)?;
    Ok((trace, start))
}

/// Each error with what it is called, its unit, and whether it is part of the verdict.
fn errors(run: &Trace, reference: &Trace) -> [(&'static str, f64, &'static str, bool); 6] {
    let [run, exact] = [&run.0, &reference.0];
    let pairs = || run.iter().zip(exact);
    let load = |k: usize| {
        let apart = pairs().flat_map(|(a, b)| a.loads.iter().zip(&b.loads).map(move |(a, b)| [a[k] - b[k]]));
        rms(apart) / mean(exact.iter().flat_map(|m| m.loads.iter().map(move |l| l[k])))
    };
    let all_loads = mean(exact.iter().flat_map(|m| m.loads.iter().flatten().copied()));
    let friction = pairs().flat_map(|(a, b)| {
        let contacts = a.tractions.iter().zip(&b.tractions);
        contacts.flat_map(|(a, b)| [[a[0] - b[0], a[1] - b[1]], [a[2] - b[2], a[3] - b[3]]])
    });
    let shaking = |t: &[Moment]| {
        let steady = [0, 1].map(|k| mean(t.iter().map(|m| m.acceleration[k])));
        rms(t.iter().map(|m| [m.acceleration[0] - steady[0], m.acceleration[1] - steady[1]]))
    };
    let [ours, theirs] = [shaking(run), shaking(exact)];
    let apart = rms(pairs().map(|(a, b)| [0, 1].map(|k| a.acceleration[k] - b.acceleration[k])));
    [
        ("mean cage speed over whole orbits", (cage_speed(run) / cage_speed(exact) - 1.0).abs(), "of it", true),
        ("inner load, rms over balls and time", load(0), "of its mean", true),
        ("outer load, rms over balls and time", load(1), "of its mean", true),
        ("traction, rms over balls and time", rms(friction) / all_loads, "of the mean load", true),
        ("outer-ring acceleration, its rms", (ours / theirs - 1.0).abs(), "of it", true),
        ("outer-ring acceleration, sample by sample", apart / theirs, "of its rms", false),
    ]
}

/// Mean over the whole orbits from the start, rad/s; over the whole run where it is shorter than one.
fn cage_speed(t: &[Moment]) -> f64 {
    let (Some(first), Some(last)) = (t.first(), t.last()) else { return f64::NAN };
    let orbits = ((last.cage_angle - first.cage_angle) / TAU).floor();
    if orbits < 1.0 {
        return (last.cage_angle - first.cage_angle) / (last.time - first.time);
    }
    let end = first.cage_angle + orbits * TAU;
    let after = t.iter().position(|m| m.cage_angle >= end).unwrap_or(t.len() - 1).max(1);
    let (a, b) = (&t[after - 1], &t[after]);
    let time = a.time + (end - a.cage_angle) / (b.cage_angle - a.cage_angle) * (b.time - a.time);
    orbits * TAU / (time - first.time)
}

pub fn rows(text: &str, quick: bool) -> Result<Vec<Row>, Failure> {
    // One orbit of the cage takes 10.3 ms.
    let duration = if quick { 0.011 } else { 0.042 };
    let (reference, start) = trace(text, REFERENCE, duration, None)?;
    let run = |scheme_and_rule| {
        let (trace, _) = trace(text, scheme_and_rule, duration, Some(&start))?;
        Ok::<_, Failure>(errors(&trace, &reference))
    };
    let paper = run([PAPER_STEP, PAPER_RULE])?;
    let mut rows: Vec<Row> =
        paper.iter().map(|(what, error, unit, _)| Row::new(GROUP, format!("(b) {what}"), *error, unit)).collect();
    let half = "Fast(step: us(10))";
    for (name, plan) in
        [("(d)", [FAST, TARGET]), ("(e)", [FAST, STRIPS_5X3]), ("(d) at half the step:", [half, TARGET])]
    {
        for ((what, error, unit, decides), (_, limit, ..)) in run(plan)?.iter().zip(&paper) {
            let row = Row::new(GROUP, format!("{name} {what}"), *error, unit);
            rows.push(if *decides && name == "(d)" { row.must_be(Limit::AtMost(*limit)) } else { row });
        }
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turning(speed: f64, until: f64) -> Vec<Moment> {
        let moment = |k: usize| {
            let time = 1e-4 * k as f64;
            let (loads, tractions) = (Vec::new(), Vec::new());
            Moment { time, cage_angle: speed * time, acceleration: [time, -time], loads, tractions }
        };
        (0..(until / 1e-4) as usize).map(moment).collect()
    }

    #[test]
    fn identity_mean_speed_is_that_of_a_steady_cage() {
        for until in [0.5e-2, 4.2e-2] {
            assert!((cage_speed(&turning(612.0, until)) / 612.0 - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn limit_a_run_has_no_error_against_itself() {
        let trace = Trace(turning(612.0, 0.02));
        let found = errors(&trace, &trace);
        assert_eq!((found[0].1, found[4].1, found[5].1), (0.0, 0.0, 0.0));
    }
}
