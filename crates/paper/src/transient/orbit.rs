//! The settled part of a run, and values of the balls over their orbit.

use super::trace::{Impact, StateSample, Trace};
use crate::mean::{mean, rms};
use std::f64::consts::TAU;
use tribodyn_bearing::BallResult;

/// A number of a ball.
pub type Quantity = fn(&BallResult) -> f64;

/// r/min in rad/s.
pub const RPM: f64 = TAU / 60.0;
/// Sectors in which values over the orbit are averaged: one per 10°.
pub const SECTORS: usize = 36;

/// The last whole orbits of a run.
#[derive(Debug, Clone, Copy)]
pub struct Window<'a> {
    pub states: &'a [StateSample],
    pub balls: &'a [(f64, Vec<BallResult>)],
    trace: &'a Trace,
    pub orbits: usize,
}

impl<'a> Window<'a> {
    /// The last whole orbits within the second half.
    pub fn settled(trace: &'a Trace) -> Self {
        let states = &trace.states;
        let half = &states[states.len() / 2..];
        let speed = mean(half.iter().map(|s| s.cage_speed));
        let samples_per_orbit = trace.rate_hz * TAU / speed;
        let orbits = ((half.len() as f64 / samples_per_orbit).floor() as usize).max(1);
        let count = ((orbits as f64 * samples_per_orbit).round() as usize).min(states.len());
        let states = &states[states.len() - count..];
        let from = states[0].time_s;
        let first = trace.balls.partition_point(|(time, _)| *time < from);
        Self { states, balls: &trace.balls[first..], trace, orbits }
    }

    pub fn rate_hz(&self) -> f64 {
        self.trace.rate_hz
    }

    pub fn signal(&self, get: impl Fn(&StateSample) -> f64) -> Vec<f64> {
        self.states.iter().map(get).collect()
    }

    pub fn mean(&self, get: impl Fn(&StateSample) -> f64) -> f64 {
        mean(self.states.iter().map(get))
    }

    /// Greatest distance from the mean.
    pub fn peak(&self, get: impl Fn(&StateSample) -> f64) -> f64 {
        let mean = self.mean(&get);
        self.states.iter().fold(0.0, |most, s| (get(s) - mean).abs().max(most))
    }

    /// Root of the mean square about the mean.
    pub fn rms(&self, get: impl Fn(&StateSample) -> f64) -> f64 {
        let mean = self.mean(&get);
        rms(self.states.iter().map(|s| [get(s) - mean]))
    }

    pub fn cage_rpm(&self) -> f64 {
        self.mean(|s| s.cage_speed) / RPM
    }

    pub fn cage_hz(&self) -> f64 {
        self.cage_rpm() / 60.0
    }

    pub fn mean_orbit_rpm(&self) -> f64 {
        self.mean(|s| s.mean_orbit) / RPM
    }

    /// Least and greatest orbital speed of ball 0, r/min.
    pub fn orbit_limits(&self) -> [f64; 2] {
        let extremes = self
            .states
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], s| [low.min(s.orbit), high.max(s.orbit)]);
        extremes.map(|speed| speed / RPM)
    }

    pub fn pocket_peak(&self) -> f64 {
        self.states.iter().fold(0.0, |most, s| s.pocket_peak.max(most))
    }

    /// Impacts of the window.
    pub fn impacts(&self) -> impl Iterator<Item = &'a Impact> {
        let from = self.states[0].time_s;
        self.trace.impacts.iter().filter(move |i| i.time_s >= from)
    }

    /// All balls at all times of the window.
    pub fn all_balls(&self) -> impl Iterator<Item = &'a BallResult> {
        self.balls.iter().flat_map(|(_, balls)| balls)
    }

    /// Mean over balls and time.
    pub fn ball_mean(&self, get: impl Fn(&BallResult) -> f64) -> f64 {
        mean(self.all_balls().map(get))
    }

    /// Mean over a part of the orbit.
    pub fn zone_mean(&self, heavy_zone: bool, get: impl Fn(&BallResult) -> f64) -> f64 {
        mean(self.all_balls().filter(|b| (b.azimuth_rad.cos() > 0.0) == heavy_zone).map(get))
    }

    /// Means in equal sectors of the orbit, the first around 0°; every ball goes through all of them.
    pub fn sectors(&self, get: Quantity) -> [f64; SECTORS] {
        let mut sums = [(0.0, 0); SECTORS];
        for ball in self.all_balls() {
            let place = ball.azimuth_rad / TAU * SECTORS as f64 + 0.5;
            let sector = &mut sums[place.rem_euclid(SECTORS as f64) as usize % SECTORS];
            *sector = (sector.0 + get(ball), sector.1 + 1);
        }
        sums.map(|(sum, count)| sum / f64::from(count))
    }

    /// Part of the impacts between two azimuths, degrees.
    pub fn impact_share(&self, [from, to]: [f64; 2]) -> f64 {
        let total = self.impacts().count();
        let inside = self.impacts().filter(|i| (from..=to).contains(&i.azimuth_deg)).count();
        inside as f64 / total as f64
    }
}
