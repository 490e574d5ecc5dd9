//! Settled figures of a transient run, as data see them.

use std::convert::Infallible;
use std::f64::consts::{SQRT_2, TAU};
use std::ops::ControlFlow;
use tribodyn_bearing::SearchWatch;
use tribodyn_case::Case;
use tribodyn_dynamics::{Ending, Event, EventKind, Observer, Run, RunError, Sample};
use tribodyn_quasistatic::QuasiStaticError;

use crate::IdentifyError;

/// r/min in rad/s.
const RPM: f64 = TAU / 60.0;

/// Figures of the last whole orbits within the second half of a run, where its start has died out.
#[derive(Debug, Clone, PartialEq)]
pub struct Settled {
    /// Mean orbital speed of the balls, r/min.
    pub orbital_speed_rpm: f64,
    /// Least and greatest orbital speed of ball 0, r/min.
    pub orbital_limits_rpm: [f64; 2],
    /// Greatest distance of the outer ring's acceleration along x from its mean, m/s².
    pub outer_peak_m_s2: f64,
    /// Amplitude of the same as that of a sine of its rms, m/s².
    pub outer_amplitude_m_s2: f64,
    /// Rms of the inner ring's acceleration about its mean along x, y and z, m/s².
    pub inner_rms_m_s2: [f64; 3],
    /// Median azimuth of the first impact of a passage through 180° to 360°, degrees; NaN without impacts there.
    pub first_impact_deg: f64,
    /// Azimuths of all impacts, degrees.
    pub impacts_deg: Vec<f64>,
}

/// Values kept of every sample.
#[derive(Debug, Clone, Copy)]
struct State {
    time: f64,
    outer_x: f64,
    inner: [f64; 3],
    cage_speed: f64,
    mean_orbit: f64,
    orbit: f64,
}

#[derive(Debug, Default)]
struct Keep {
    states: Vec<State>,
    /// Time s, ball, azimuth degrees.
    impacts: Vec<(f64, usize, f64)>,
    watch: SearchWatch,
}

impl Observer for Keep {
    type Error = Infallible;

    fn sample(&mut self, sample: &Sample, _: bool) -> Result<ControlFlow<()>, Infallible> {
        let balls = &sample.balls;
        self.states.push(State {
            time: sample.time_s,
            outer_x: sample.outer.acceleration_m_s2[0],
            inner: sample.inner.acceleration_m_s2,
            cage_speed: sample.cage.speed_rad_s,
            mean_orbit: balls.iter().map(|b| b.orbital_speed_rad_s).sum::<f64>() / balls.len() as f64,
            orbit: balls.first().map_or(f64::NAN, |b| b.orbital_speed_rad_s),
        });
        Ok(if self.watch.stops() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
    }

    fn event(&mut self, event: &Event) -> Result<(), Infallible> {
        if let EventKind::Impact { ball, azimuth_deg, .. } = event.kind {
            self.impacts.push((event.time_s, ball, azimuth_deg));
        }
        Ok(())
    }
}

impl Settled {
    /// Runs a case to the end of its duration, or until it is ended from outside.
    ///
    /// # Errors
    /// A case without what a run needs, a run that fails.
    pub fn of(case: &Case, watch: &SearchWatch) -> Result<Self, IdentifyError> {
        let mut run = Run::new(case.run_inputs()?)?;
        let mut keep = Keep { watch: watch.clone(), ..Keep::default() };
        let ending = run.advance(f64::INFINITY, &mut keep).map_err(|error| match error {
            RunError::Dynamics(error) => IdentifyError::from(error),
            RunError::Observer(never) => match never {},
        })?;
        if let Ending::BeyondStability { step_s, limit_s } = ending {
            return Err(IdentifyError::Unstable { step_s, limit_s });
        }
        if keep.watch.stops() {
            return Err(QuasiStaticError::Ended.into());
        }
        Ok(keep.settled(case.rates().state_rate, case.geometry.ball_count))
    }
}

impl Keep {
    fn settled(&self, rate: f64, balls: usize) -> Settled {
        let half = &self.states[self.states.len() / 2..];
        let cage = mean(half.iter().map(|s| s.cage_speed));
        let per_orbit = rate * TAU / cage.abs();
        let orbits = (half.len() as f64 / per_orbit).floor().max(1.0);
        let count = ((orbits * per_orbit).round() as usize).min(self.states.len());
        let states = &self.states[self.states.len() - count..];
        let from = states[0].time;
        let impacts: Vec<_> = self.impacts.iter().copied().filter(|(time, ..)| *time >= from).collect();
        let outer = about_mean(states.iter().map(|s| s.outer_x).collect());
        let limits = states.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], s| {
            [low.min(s.orbit / RPM), high.max(s.orbit / RPM)]
        });
        Settled {
            orbital_speed_rpm: mean(states.iter().map(|s| s.mean_orbit)) / RPM,
            orbital_limits_rpm: limits,
            outer_peak_m_s2: outer.iter().fold(0.0, |most, v| v.abs().max(most)),
            outer_amplitude_m_s2: SQRT_2 * rms(&outer),
            inner_rms_m_s2: [0, 1, 2].map(|k| rms(&about_mean(states.iter().map(|s| s.inner[k]).collect()))),
            first_impact_deg: first_impact(&impacts, balls, TAU / cage.abs()),
            impacts_deg: impacts.iter().map(|(.., azimuth)| *azimuth).collect(),
        }
    }
}

/// Median azimuth of the first impacts in the half orbit from 180° on; those of one passage lie within half a period.
fn first_impact(impacts: &[(f64, usize, f64)], balls: usize, period: f64) -> f64 {
    let mut firsts = Vec::new();
    for ball in 0..balls {
        let mut last = f64::NEG_INFINITY;
        for &(time, _, azimuth) in impacts.iter().filter(|(_, of, _)| *of == ball) {
            if azimuth >= 180.0 && time - last > 0.5 * period {
                firsts.push(azimuth);
                last = time;
            }
        }
    }
    median(firsts)
}

/// The middle value, the upper one of two; NaN without any.
pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

pub(crate) fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (count, sum) = values.fold((0.0, 0.0), |(count, sum), v| (count + 1.0, sum + v));
    sum / count
}

fn about_mean(mut values: Vec<f64>) -> Vec<f64> {
    let mean = mean(values.iter().copied());
    values.iter_mut().for_each(|v| *v -= mean);
    values
}

fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two balls, 2.5 orbits of 10 ms sampled at 10 kHz: a sine about an offset, one impact an orbit.
    #[test]
    fn identity_figures_are_of_the_last_whole_orbits() {
        let states = (0..251).map(|i| {
            let time = f64::from(i) * 1e-4;
            let wave = (TAU * 300.0 * time).sin();
            // What happens in the first half is not looked at.
            let start = if time < 0.01 { 50.0 } else { 0.0 };
            State {
                time,
                outer_x: 7.0 + 4.0 * wave + start,
                inner: [wave, 0.0, 2.0 * wave],
                cage_speed: TAU * 100.0,
                mean_orbit: TAU * 100.0,
                orbit: TAU * (100.0 + wave),
            }
        });
        let impacts = vec![(0.002, 0, 200.0), (0.017, 0, 250.0), (0.018, 0, 300.0), (0.02, 1, 270.0), (0.021, 1, 20.0)];
        let s = Keep { states: states.collect(), impacts, ..Keep::default() }.settled(1e4, 2);
        assert!((s.orbital_speed_rpm - 6000.0).abs() < 1e-9);
        assert!((s.orbital_limits_rpm[0] - 5940.0).abs() < 0.2 && (s.orbital_limits_rpm[1] - 6060.0).abs() < 0.2);
        assert!((s.outer_amplitude_m_s2 - 4.0).abs() < 1e-9 && (s.outer_peak_m_s2 - 4.0).abs() < 0.02);
        assert!((s.inner_rms_m_s2[2] - SQRT_2).abs() < 1e-9 && s.inner_rms_m_s2[1] == 0.0);
        assert_eq!(s.impacts_deg, [250.0, 300.0, 270.0, 20.0]);
        assert_eq!(s.first_impact_deg, 270.0);
    }
}
