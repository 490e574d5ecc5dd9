//! The mean of a run in which cage and rings do not answer to single balls.

use std::{convert::Infallible, error::Error, f64::consts::TAU, ops::ControlFlow};
use tribodyn_bearing::RunInputs;
use tribodyn_dynamics::{Event, Observer, Run, Sample, StartMotion};
use tribodyn_orbit::POINTS;

/// Samples of the rings, Hz.
const RATE: f64 = 26_183.7;

/// Means of a run from a time on.
#[derive(Default)]
pub struct Mean {
    from: f64,
    count: f64,
    /// Cage angle (rad) and time (s) at the beginning and at the end.
    span: [[f64; 2]; 2],
    torque: f64,
    load: [f64; 3],
    /// Count, inner load, pocket force by azimuth.
    pub bins: Vec<[f64; 3]>,
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

impl Mean {
    /// Of a run: first with the cage as it is, until the balls have found their way, then with a heavy one. `turn` is
    /// the time of a turn of the cage, s.
    pub fn of(
        inputs: &RunInputs,
        turn: f64,
        [light, settling, counted]: [f64; 3],
        motion: Option<StartMotion>,
    ) -> Result<Self, Box<dyn Error>> {
        let times = [light, light + settling, light + settling + counted].map(|turns| turns * turn);
        let mut mean = Self { from: f64::INFINITY, bins: vec![[0.0; 3]; POINTS], ..Self::default() };
        let mut inputs = inputs.clone();
        inputs.options.duration = times[2];
        // Supports are without stretch at the start: both parts have the same.
        let begin = |inputs: RunInputs| match &motion {
            Some(motion) => Run::moving(inputs, motion.clone()),
            None => Run::new(inputs),
        };
        let mut first = begin(inputs.clone())?;
        first.advance(times[0], &mut mean)?;
        inputs.cage.inertia *= 200.0;
        let mut run = begin(inputs)?;
        run.resume(first.checkpoint())?;
        mean.from = times[1];
        run.advance(times[2], &mut mean)?;
        Ok(mean)
    }

    /// Cage speed, r/min.
    pub fn cage_speed_rpm(&self) -> f64 {
        let [[angle, time], [end_angle, end_time]] = self.span;
        (end_angle - angle) / (end_time - time) * 60.0 / TAU
    }

    /// Torque of the shaft, N m.
    pub fn torque(&self) -> f64 {
        self.torque / self.count
    }

    /// Force on the balls by the inner ring, N.
    pub fn load(&self) -> [f64; 3] {
        self.load.map(|sum| sum / self.count)
    }

    /// Inner load and pocket force by azimuth; none where no ball came by.
    pub fn by_azimuth(&self) -> impl Iterator<Item = Option<[f64; 2]>> + '_ {
        self.bins.iter().map(|&[count, load, force]| (count > 0.0).then(|| [load / count, force / count]))
    }
}

/// Rings so heavy, by a factor, and damped that they do not answer to single balls; contacts and pockets damped as in
/// the orbit.
pub fn weigh_down(inputs: &mut RunInputs, pocket_damping: f64, heavy: f64) {
    inputs.cage.pocket_damping = inputs.cage.pocket_damping.max(pocket_damping);
    inputs.options.contact_damping = inputs.options.contact_damping.max(0.1);
    // No multiple of the balls' passing: samples would see them at a few azimuths only.
    (inputs.options.state_rate, inputs.options.ball_rate) = (RATE, RATE / 4.0);
    let supports = &mut inputs.supports;
    (supports.inner.mass, supports.outer.mass) = (100.0 * heavy, 100.0 * heavy);
    (supports.inner.damping, supports.outer.damping) = ([3e4 * heavy; 3], [3e4 * heavy; 2]);
}
