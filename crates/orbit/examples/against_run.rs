//! The steady orbit of cases beside the mean of their runs: cage speed, torque, loads and pocket force over azimuth.
//!
//! `cargo run --release -p tribodyn-orbit --example against_run -- SETTLING_S CASE.ron…`; runs go on to the end of
//! the case. Loads over azimuth are those of bins of two degrees. With `--heavy` rings and cage are so heavy and
//! damped that they do not answer to single balls, and pockets and contacts are damped alike in run and orbit: what
//! the orbit takes for granted.

use std::{convert::Infallible, error::Error, f64::consts::TAU, fs, ops::ControlFlow};
use tribodyn_bearing::{CageBody, RunInputs};
use tribodyn_case::Case;
use tribodyn_dynamics::{Event, Observer, Run, Sample};
use tribodyn_orbit::{OrbitSettings, POINTS, SteadyOrbit, steady_orbit};

/// Means of a run from a time on.
#[derive(Default)]
struct Mean {
    from: f64,
    count: f64,
    /// Cage angle (rad) and time (s) at the beginning and at the end.
    span: [[f64; 2]; 2],
    torque: f64,
    load: [f64; 3],
    /// Count, inner load, pocket force by azimuth.
    bins: Vec<[f64; 3]>,
}

impl Observer for Mean {
    type Error = Infallible;

    fn sample(&mut self, s: &Sample, with_balls: bool) -> Result<ControlFlow<()>, Infallible> {
        if s.time_s < self.from || !with_balls {
            return Ok(ControlFlow::Continue(()));
        }
        self.span[usize::from(self.count > 0.0)] = [s.cage.angle_rad, s.time_s];
        self.count += 1.0;
        self.torque += s.inner.torque_nm;
        self.load.iter_mut().zip(s.inner.ball_force_n).for_each(|(sum, f)| *sum -= f);
        for ball in &s.balls {
            let bin = (ball.azimuth_rad.rem_euclid(TAU) / TAU * POINTS as f64 + 0.5) as usize % POINTS;
            let values = [1.0, ball.contacts.inner.load_n, ball.pocket.map_or(0.0, |p| p.force_n)];
            self.bins[bin].iter_mut().zip(values).for_each(|(sum, v)| *sum += v);
        }
        Ok(ControlFlow::Continue(()))
    }

    fn event(&mut self, _: &Event) -> Result<(), Infallible> {
        Ok(())
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let heavy = arguments.iter().any(|a| a == "--heavy");
    let mut rest = arguments.iter().filter(|a| *a != "--heavy");
    let from: f64 = rest.next().ok_or("the settling time in s is missing")?.parse()?;
    for path in rest {
        let case = Case::from_ron(&fs::read_to_string(path)?)?;
        let mut inputs = case.run_inputs()?;
        if heavy {
            weigh_down(&mut inputs);
        }
        let (bearing, moving, damping) = (inputs.bearing.clone(), inputs.cage, inputs.options.contact_damping);
        let mut mean = Mean { from, bins: vec![[0.0; 3]; POINTS], ..Mean::default() };
        let mut run = Run::new(inputs)?;
        run.advance(run.duration(), &mut mean)?;
        let cage = CageBody::new(&moving, &bearing);
        let bearing = tribodyn_bearing::Bearing { contact_damping: damping, ..bearing };
        let orbit = steady_orbit(&bearing, &case.operating_point(), &cage, &OrbitSettings::default())?.solution;
        println!("{path}");
        compare(&mean, &orbit);
    }
    Ok(())
}

fn weigh_down(inputs: &mut RunInputs) {
    inputs.cage.inertia *= 200.0;
    inputs.cage.pocket_damping = inputs.cage.pocket_damping.max(110.0);
    inputs.options.contact_damping = inputs.options.contact_damping.max(0.1);
    let supports = &mut inputs.supports;
    (supports.inner.mass, supports.outer.mass) = (100.0, 100.0);
    (supports.inner.damping, supports.outer.damping) = ([2e5; 3], [2e5; 2]);
}

fn compare(mean: &Mean, orbit: &SteadyOrbit) {
    let [[angle, time], [end_angle, end_time]] = mean.span;
    let speed = (end_angle - angle) / (end_time - time) * 60.0 / TAU;
    let torque = mean.torque / mean.count;
    let off = |ours: f64, theirs: f64| ours / theirs - 1.0;
    println!(
        "  cage   {:11.4} run {speed:11.4} r/min  {:+.1e}",
        orbit.cage_speed_rpm,
        off(orbit.cage_speed_rpm, speed)
    );
    println!(
        "  torque {:11.6} run {torque:11.6} N m    {:+.1e}",
        orbit.shaft_torque_nm,
        off(orbit.shaft_torque_nm, torque)
    );
    println!("  load   {:8.2?} run {:8.2?} N", orbit.ring_load_n, mean.load.map(|f| f / mean.count));
    let peak = orbit.points.iter().map(|p| p.contacts.inner.load_n).fold(0.0, f64::max);
    let (mut load, mut pocket) = (0f64, Vec::new());
    for (p, [count, q, f]) in orbit.points.iter().zip(&mean.bins).filter(|(_, bin)| bin[0] > 0.0) {
        load = load.max((p.contacts.inner.load_n - q / count).abs() / peak);
        pocket.push((p.pocket.map_or(0.0, |p| p.force_n) - f / count).abs());
    }
    pocket.sort_by(f64::total_cmp);
    // A bin in which a ball meets its pocket holds a jump.
    let most = pocket[pocket.len() * 97 / 100];
    println!(
        "  inner load within {load:.1e} of the largest; pocket force within {most:.2} N in 97 of 100 bins, \
         largest {:.2} N, met at {:.1?} degrees",
        orbit.pocket_force_max_n, orbit.pocket_contact_azimuths_deg
    );
}
