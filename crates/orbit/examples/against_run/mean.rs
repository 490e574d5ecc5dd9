//! The mean of a run in which cage and rings do not answer to single balls.

use std::{
    convert::Infallible,
    error::Error,
    f64::consts::{PI, TAU},
    ops::ControlFlow,
};
use tribodyn_bearing::{RunInputs, Scheme};
use tribodyn_dynamics::{Event, Observer, Run, Sample, StartMotion};
use tribodyn_orbit::POINTS;

/// Samples while a ball takes the place of the next: by the golden section, so that no small multiple of them is a
/// whole number. Torque jumps where balls meet their pockets, and harmonics near one would look like its mean.
const SAMPLES: f64 = 60.618_033_988_749_89;
/// Steps by their error: the friction of a light ball under load is too stiff for fixed steps of a microsecond.
const SCHEME: Scheme = Scheme::DormandPrince { tolerance: 1e-6, longest: 1e-5 };
/// Factor on the cage's inertia: in its pocket a ball is pressed by a micrometre.
const HEAVY_CAGE: f64 = 1e6;
/// Mass of rings that nothing moves, kg.
const HEAVY_RING: f64 = 1e12;

/// Means over a part of a run, weighted so that they do not depend on where within the passing of a ball it begins and
/// ends: torque swings by many times its mean where balls meet their pockets.
#[derive(Default)]
pub struct Mean {
    /// Beginning and end, s.
    span: [f64; 2],
    weight: f64,
    /// Torque on the cage, N m.
    pub cage_torque: f64,
    /// Torque of the shaft, N m.
    pub torque: f64,
    /// Force on the balls by the inner ring, N.
    pub load: [f64; 3],
    /// Orbital speed of the balls, rad/s.
    pub orbital_speed: f64,
    /// Count, inner load, pocket force by azimuth.
    bins: Vec<[f64; 3]>,
}

impl Observer for Mean {
    type Error = Infallible;

    fn sample(&mut self, s: &Sample, _: bool) -> Result<ControlFlow<()>, Infallible> {
        let [from, until] = self.span;
        if s.time_s < from {
            return Ok(ControlFlow::Continue(()));
        }
        let weight = (PI * (s.time_s - from) / (until - from)).sin().powi(2);
        self.weight += weight;
        self.cage_torque += weight * (s.cage.ball_torque_nm + s.cage.fluid_torque_nm);
        self.torque += weight * s.inner.torque_nm;
        self.load.iter_mut().zip(s.inner.ball_force_n).for_each(|(sum, f)| *sum -= weight * f);
        for ball in &s.balls {
            self.orbital_speed += weight * ball.orbital_speed_rad_s / s.balls.len() as f64;
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
    /// Of a run of so many turns to settle and to count. `turn` is the time of a turn of the cage, s.
    pub fn of(
        inputs: &RunInputs,
        turn: f64,
        [settling, counted]: [f64; 2],
        motion: StartMotion,
    ) -> Result<Self, Box<dyn Error>> {
        let mut inputs = inputs.clone();
        inputs.options.duration = (settling + counted) * turn;
        let rate = SAMPLES * inputs.bearing.geometry.ball_count as f64 / turn;
        (inputs.options.state_rate, inputs.options.ball_rate) = (rate, rate);
        let until = inputs.options.duration;
        let mut mean = Self { span: [settling * turn, until], bins: vec![[0.0; 3]; POINTS], ..Self::default() };
        let _ = Run::moving(inputs, motion)?.advance(until, &mut mean)?;
        let sums = [&mut mean.cage_torque, &mut mean.torque, &mut mean.orbital_speed];
        sums.into_iter().chain(&mut mean.load).for_each(|sum| *sum /= mean.weight);
        Ok(mean)
    }

    /// Inner load and pocket force by azimuth; none where no ball came by.
    pub fn by_azimuth(&self) -> impl Iterator<Item = Option<[f64; 2]>> + '_ {
        self.bins.iter().map(|&[count, load, force]| (count > 0.0).then(|| [load / count, force / count]))
    }
}

/// Cage and rings so heavy that they do not answer to single balls; contacts and pockets damped as in the orbit.
pub fn weigh_down(inputs: &mut RunInputs, pocket_damping: f64) {
    inputs.cage.pocket_damping = inputs.cage.pocket_damping.max(pocket_damping);
    inputs.cage.inertia *= HEAVY_CAGE;
    let options = &mut inputs.options;
    options.contact_damping = options.contact_damping.max(0.1);
    options.scheme = SCHEME;
    let supports = &mut inputs.supports;
    (supports.inner.mass, supports.outer.mass) = (HEAVY_RING, HEAVY_RING);
}
