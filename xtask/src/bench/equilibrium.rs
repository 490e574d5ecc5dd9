//! Time of quasi-static solves: cold, warm, along a line of loads on one and two threads, and over the number of balls.

use super::changed;
use super::clock::{least_per_call, timed};
use super::row::{Limit, Row};
use super::speed::{FAST, STRIPS_8X3, per_second};
use crate::error::Failure;
use cpu_time::ProcessTime;
use std::time::Instant;
use tribodyn_bearing::Bearing;
use tribodyn_case::Case;
use tribodyn_paper::PaperError;
use tribodyn_quasistatic::{Model, OperatingPoint, QuasiStaticError, RingFreedom, WarmStart, solve, solve_from};

const GROUP: &str = "quasi-static";
const RUN: &str = "bench";

/// Case 1 with `balls` of the same balls as close together as the paper's 13, each carrying as much, moving as fast.
struct Size {
    bearing: Bearing,
    point: OperatingPoint,
}

fn changes_for(balls: usize) -> Vec<(&'static str, String)> {
    let ratio = balls as f64 / 13.0;
    vec![
        ("geometry.ball_count", balls.to_string()),
        ("geometry.pitch_diameter", format!("mm({})", 151.663 * ratio)),
        ("ring.x.Force", format!("kN({})", 22.98 * ratio)),
        ("ring.z.Force", format!("kN({})", 54.76 * ratio)),
        ("speed.inner.Constant", format!("rpm({})", 14_000.0 / ratio)),
    ]
}

impl Size {
    fn new(case: &Case) -> Result<Self, Failure> {
        let bearing = case.bearing().map_err(|source| PaperError::Bearing { run: RUN, source })?;
        Ok(Self { point: case.operating_point(), bearing })
    }

    fn cold(&self, point: &OperatingPoint) -> Result<WarmStart, Failure> {
        let solved = solve(&self.bearing, point, Model::Traction).map_err(unsolved)?;
        Ok(solved.warm_start.unwrap_or_else(|| unreachable!("a traction solution has unknowns")))
    }

    /// Radial load and speed larger by so much.
    fn neighbour(&self, load: f64, speed: f64) -> OperatingPoint {
        let mut point = self.point.clone();
        if let RingFreedom::Loaded(force) = &mut point.ring[0] {
            *force *= 1.0 + load;
        }
        point.inner_speed *= 1.0 + speed;
        point
    }

    fn cold_time(&self, batches: usize) -> Result<f64, Failure> {
        self.cold(&self.point)?;
        Ok(least_per_call(batches, 1e-3, || solve(&self.bearing, &self.point, Model::Traction)))
    }

    /// Back and forth between two neighbours, each from the solution of the other.
    fn warm_time(&self, distance: f64, batches: usize) -> Result<f64, Failure> {
        let there = self.neighbour(0.02 * distance, 0.01 * distance);
        let starts = [self.cold(&self.point)?, self.cold(&there)?];
        for (point, start) in [(&there, &starts[0]), (&self.point, &starts[1])] {
            solve_from(&self.bearing, point, start).map_err(unsolved)?;
        }
        let both = || {
            let forth = solve_from(&self.bearing, &there, &starts[0]);
            (forth, solve_from(&self.bearing, &self.point, &starts[1]))
        };
        Ok(0.5 * least_per_call(batches, 2e-3, both))
    }

    /// Solves `count` loads from half to one and a half of the case's, each from the one before it.
    fn line(&self, from: usize, to: usize, count: usize) -> Result<(), QuasiStaticError> {
        let mut start: Option<WarmStart> = None;
        for k in from..to {
            let point = self.neighbour(k as f64 / count as f64 - 0.5, 0.0);
            let warm = start.as_ref().and_then(|start| solve_from(&self.bearing, &point, start).ok());
            let solved = match warm {
                Some(solved) => solved,
                None => solve(&self.bearing, &point, Model::Traction)?,
            };
            start = solved.warm_start;
        }
        Ok(())
    }

    /// Rows per second of wall time, and processor time of a row, s.
    fn sweep(&self, count: usize, threads: usize) -> Result<[f64; 2], Failure> {
        let (wall, processor) = (Instant::now(), ProcessTime::now());
        let part = |t: usize| self.line(t * count / threads, (t + 1) * count / threads, count);
        std::thread::scope(|scope| {
            let workers: Vec<_> = (0..threads).map(|t| scope.spawn(move || part(t))).collect();
            workers.into_iter().try_for_each(|w| w.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
        })
        .map_err(unsolved)?;
        Ok([count as f64 / wall.elapsed().as_secs_f64(), processor.elapsed().as_secs_f64() / count as f64])
    }
}

fn unsolved(source: QuasiStaticError) -> PaperError {
    PaperError::Solver { run: RUN, source }
}

pub fn rows(text: &str, quick: bool) -> Result<Vec<Row>, Failure> {
    let batches = if quick { 3 } else { 10 };
    let paper = Size::new(&changed::<&str>(text, &[])?.case)?;
    let row = |quantity: &str, value: f64, unit| Row::new(GROUP, quantity, value, unit);
    let mut rows = vec![
        row("cold", paper.cold_time(batches)? * 1e3, "ms").must_be(Limit::AtMost(3.0)),
        row("warm, 2 % in load and 1 % in speed", paper.warm_time(1.0, batches)? * 1e3, "ms")
            .must_be(Limit::AtMost(0.6)),
        row("warm, a tenth as far", paper.warm_time(0.1, batches)? * 1e3, "ms"),
    ];
    let jones = timed(|| solve(&paper.bearing, &paper.point, Model::JonesHarris).map_err(unsolved));
    jones.1?;
    let jones = least_per_call(batches, 1e-3, || solve(&paper.bearing, &paper.point, Model::JonesHarris));
    rows.push(row("Jones–Harris", jones * 1e3, "ms"));
    rows.extend(sweeps(&paper, quick)?);
    for balls in [9, 13, 17] {
        let changes = changes_for(balls);
        let case = changed(text, &changes)?.case;
        let size = Size::new(&case)?;
        let of = |what: &str, value: f64| Row::new("balls", format!("{balls} balls, {what}"), value, "ms");
        rows.push(of("cold solve", size.cold_time(batches)? * 1e3));
        rows.push(of("warm solve, 2 % in load and 1 % in speed", size.warm_time(1.0, batches)? * 1e3));
        let mut all: Vec<(&str, &str)> = changes.iter().map(|(path, value)| (*path, value.as_str())).collect();
        all.extend([("transient.scheme", FAST), ("traction.patch", STRIPS_8X3)]);
        let cost = per_second(text, &all, 0.03, batches.min(4))?;
        rows.push(of("fast scheme 20 µs, 1 ms of time", cost));
    }
    Ok(rows)
}

/// A line of loads on one thread and on two, the better of some repetitions.
fn sweeps(paper: &Size, quick: bool) -> Result<Vec<Row>, Failure> {
    let (count, repetitions) = if quick { (32, 1) } else { (128, 3) };
    let mut rows = Vec::new();
    for threads in [1, 2] {
        let mut best = [0.0, f64::INFINITY];
        for _ in 0..repetitions {
            let [rate, cost] = paper.sweep(count, threads)?;
            best = [rate.max(best[0]), cost.min(best[1])];
        }
        let note = format!("wall time, {count} loads; {:.2} ms of processor time a row", best[1] * 1e3);
        let name = if threads == 1 { "sweep of loads, 1 thread" } else { "sweep of loads, 2 threads" };
        rows.push(Row::new(GROUP, name, best[0], "rows/s").note(note));
    }
    Ok(rows)
}
