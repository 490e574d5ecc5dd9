//! Wear of both races over many revolutions, by strides between quasi-static solutions.
//!
//! The rates of wear change only as the coating does, over millions of revolutions. A stride takes them as constant
//! (Euler's method, first order in the stride) and is so short that no spot of either race loses more than a given part
//! of its new coating; then the caller solves again. A stride also ends where the first spot is worn through.

use crate::raceway::{BINS, middles};
use crate::{Raceway, WearError};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Wear rate of a race under one ball at an azimuth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallWear {
    /// Azimuth of the ball, rad, in the frame of the load, which stands still.
    pub azimuth: f64,
    /// Volume worn off the race per time by this ball, m³/s.
    pub volume_rate: f64,
    /// Semi-axis of the contact ellipse across the groove, m.
    pub semi_lateral: f64,
}

/// Wear rates of one race: one ball at several azimuths, and how that comes over the ring.
#[derive(Debug, Clone, PartialEq)]
pub struct RaceWear {
    /// One ball at azimuths that rise over one turn; between them its rate is linear. The balls of a solution serve,
    /// all of them being one ball at other times.
    pub along_orbit: Vec<BallWear>,
    /// Number of balls.
    pub ball_count: usize,
    /// True if the ring turns under the load: then every spot of it sees the mean over the orbit. A ring that stands
    /// still wears most where it is loaded most.
    pub turning: bool,
}

impl RaceWear {
    /// Volume worn per time by all balls, m³/s: their number times the mean of the rate over the orbit.
    pub fn volume_rate(&self) -> f64 {
        let spans = self.spans().map(|(from, to, gap)| 0.5 * (from.volume_rate + to.volume_rate) * gap);
        self.ball_count as f64 * spans.sum::<f64>() / TAU
    }

    /// Each azimuth with the next one and their distance, the last with the first.
    fn spans(&self) -> impl Iterator<Item = (&BallWear, &BallWear, f64)> {
        let next = self.along_orbit.iter().cycle().skip(1);
        self.along_orbit.iter().zip(next).map(|(from, to)| {
            let gap = (to.azimuth - from.azimuth).rem_euclid(TAU);
            (from, to, if gap > 0.0 { gap } else { TAU })
        })
    }

    fn check(&self) -> Result<(), WearError> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        for ball in &self.along_orbit {
            if !(ball.volume_rate >= 0.0 && ball.volume_rate.is_finite()) {
                return Err(WearError::Rate { value: ball.volume_rate });
            }
            if !ball.azimuth.is_finite() {
                return Err(WearError::Orbit { azimuth: ball.azimuth });
            }
            if ball.volume_rate > 0.0 && !positive(ball.semi_lateral) {
                return Err(WearError::Length { name: "semi-axis of a contact", value: ball.semi_lateral });
            }
        }
        // Azimuths that rise over one turn have gaps that add up to one.
        let turn: f64 = self.spans().map(|(_, _, gap)| gap).sum();
        match self.along_orbit.first() {
            Some(first) if (turn - TAU).abs() > 1e-9 => Err(WearError::Orbit { azimuth: first.azimuth }),
            _ => Ok(()),
        }
    }

    /// Depth per time of each bin of a raceway of the radius given, m/s; together they hold [`Self::volume_rate`] where
    /// the track is equally wide all round.
    fn depth_rates(&self, radius: f64) -> Vec<f64> {
        let rate: Vec<(f64, f64)> = middles().map(|azimuth| self.at(azimuth)).collect();
        let mean = rate.iter().map(|r| r.0).sum::<f64>() / BINS as f64;
        let total = self.volume_rate();
        if total <= 0.0 || mean <= 0.0 {
            return vec![0.0; BINS];
        }
        // Sampling a piecewise linear rate at the bins misses its mean by a little.
        let scale = total / (mean * TAU * radius);
        let mut depth: Vec<f64> =
            rate.iter().map(|&(v, a)| if v > 0.0 { scale * v / (2.0 * a) } else { 0.0 }).collect();
        if self.turning {
            let even = depth.iter().sum::<f64>() / BINS as f64;
            depth.fill(even);
        }
        depth
    }

    /// Rate and semi-axis of one ball at an azimuth.
    fn at(&self, azimuth: f64) -> (f64, f64) {
        let inside = self.spans().find_map(|(from, to, gap)| {
            let share = (azimuth - from.azimuth).rem_euclid(TAU) / gap;
            (share < 1.0).then(|| {
                let mix = |a: f64, b: f64| a + (b - a) * share;
                // A ball out of contact has no ellipse: the track keeps the width of the neighbour.
                let (a, b) = match (from.volume_rate > 0.0, to.volume_rate > 0.0) {
                    (true, false) => (from.semi_lateral, from.semi_lateral),
                    (false, true) => (to.semi_lateral, to.semi_lateral),
                    _ => (from.semi_lateral, to.semi_lateral),
                };
                (mix(from.volume_rate, to.volume_rate), mix(a, b))
            })
        });
        inside.unwrap_or((0.0, 1.0))
    }
}

/// Wear rates of both races.
#[derive(Debug, Clone, PartialEq)]
pub struct WearRates {
    /// Inner race.
    pub inner: RaceWear,
    /// Outer race.
    pub outer: RaceWear,
}

/// Result of one stride.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stride {
    /// Its duration, s; the caller's longest where nothing wears.
    pub duration: f64,
    /// Time since the start, at its end, s.
    pub elapsed: f64,
    /// Largest rate of depth on the inner race during it, m/s.
    pub inner_depth_rate: f64,
    /// Largest rate of depth on the outer race during it, m/s.
    pub outer_depth_rate: f64,
    /// Azimuth at which the coating of the inner race is worn through at its end, rad.
    pub inner_through: Option<f64>,
    /// Azimuth at which the coating of the outer race is worn through at its end, rad.
    pub outer_through: Option<f64>,
}

/// Both races of a bearing and the time they have run.
///
/// ```
/// use tribodyn_wear::{BallWear, CoatingLife, RaceWear, Raceway, WearError, WearRates};
///
/// let race = Raceway::new(10e-6, 0.0, 0.07, &[])?;
/// let mut life = CoatingLife::new(race.clone(), race, 0.02)?;
/// while life.worn_through().is_none() {
///     // Here a bearing is solved with the raceways as they are.
///     let rates = |_inner: &Raceway, _outer: &Raceway| {
///         let ball = |azimuth: f64| BallWear { azimuth, volume_rate: 1e-15, semi_lateral: 2e-3 };
///         let race = |turning| RaceWear { along_orbit: vec![ball(0.0), ball(3.0)], ball_count: 13, turning };
///         Ok::<_, WearError>(WearRates { inner: race(true), outer: race(false) })
///     };
///     life.advance(1e9, rates)?;
/// }
/// let expected = 10e-6 * 2.0 * std::f64::consts::PI * 0.07 * 4e-3 / 13e-15;
/// assert!((life.elapsed() / expected - 1.0).abs() < 1e-9);
/// # Ok::<(), WearError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CoatingLife {
    inner: Raceway,
    outer: Raceway,
    loss: f64,
    elapsed: f64,
}

impl CoatingLife {
    /// Starts with two raceways; no spot loses more than the part `loss_per_stride` of its new coating in one stride.
    ///
    /// # Errors
    /// [`WearError::Fraction`] unless 0 < `loss_per_stride` ≤ 1.
    pub fn new(inner: Raceway, outer: Raceway, loss_per_stride: f64) -> Result<Self, WearError> {
        if !(loss_per_stride > 0.0 && loss_per_stride <= 1.0) {
            return Err(WearError::Fraction { name: "loss of coating per stride", value: loss_per_stride });
        }
        Ok(Self { inner, outer, loss: loss_per_stride, elapsed: 0.0 })
    }

    /// One stride: asks for the rates of wear with the raceways as they are and lets them act until a spot has lost the
    /// part allowed, until the first spot of a coating is worn through, or for `longest` seconds. A raceway that is
    /// worn through already goes on into the steel by strides of the same depth; one without a coating sets no limit.
    ///
    /// # Errors
    /// The error of `rates`, and [`WearError`] for a longest stride that is not finite and above 0, rates that are
    /// negative or not finite, an ellipse without width, and azimuths that do not rise over one turn.
    pub fn advance<E: From<WearError>>(
        &mut self,
        longest: f64,
        rates: impl FnOnce(&Raceway, &Raceway) -> Result<WearRates, E>,
    ) -> Result<Stride, E> {
        if !(longest > 0.0 && longest.is_finite()) {
            return Err(WearError::Time { value: longest }.into());
        }
        let rates = rates(&self.inner, &self.outer)?;
        rates.inner.check()?;
        rates.outer.check()?;
        let inner = rates.inner.depth_rates(self.inner.track_radius());
        let outer = rates.outer.depth_rates(self.outer.track_radius());
        let duration = longest.min(stride(&self.inner, &inner, self.loss)).min(stride(&self.outer, &outer, self.loss));
        for (raceway, depth, wear) in [(&mut self.inner, &inner, &rates.inner), (&mut self.outer, &outer, &rates.outer)]
        {
            let volume = wear.volume_rate();
            if volume > 0.0 {
                raceway.remove_depths(depth.iter().map(|rate| rate * duration), volume * duration);
            }
        }
        self.elapsed += duration;
        let largest = |rates: &[f64]| rates.iter().copied().fold(0.0, f64::max);
        Ok(Stride {
            duration,
            elapsed: self.elapsed,
            inner_depth_rate: largest(&inner),
            outer_depth_rate: largest(&outer),
            inner_through: self.inner.worn_through(),
            outer_through: self.outer.worn_through(),
        })
    }

    /// Mean over the azimuth of the depth per time on the inner and the outer raceway at some rates of wear, m/s.
    ///
    /// # Errors
    /// [`WearError`] for rates that [`Self::advance`] would refuse.
    pub fn mean_depth_rates(&self, rates: &WearRates) -> Result<[f64; 2], WearError> {
        let mean = |wear: &RaceWear, raceway: &Raceway| {
            wear.check()?;
            Ok(wear.depth_rates(raceway.track_radius()).iter().sum::<f64>() / BINS as f64)
        };
        Ok([mean(&rates.inner, &self.inner)?, mean(&rates.outer, &self.outer)?])
    }

    /// Inner raceway.
    pub fn inner(&self) -> &Raceway {
        &self.inner
    }

    /// Outer raceway.
    pub fn outer(&self) -> &Raceway {
        &self.outer
    }

    /// Time since the start, s. Times a rotational speed it is revolutions.
    pub fn elapsed(&self) -> f64 {
        self.elapsed
    }

    /// Azimuth at which a coating is worn through, rad: the inner race's place before the outer's.
    pub fn worn_through(&self) -> Option<f64> {
        self.inner.worn_through().or_else(|| self.outer.worn_through())
    }
}

/// Longest stride of one raceway, s: infinite where nothing wears.
fn stride(raceway: &Raceway, rates: &[f64], loss: f64) -> f64 {
    let coating = raceway.new_thickness();
    if coating == 0.0 {
        return f64::INFINITY;
    }
    let through = raceway.worn_through().is_some();
    let spots = middles().zip(smoothed(rates)).filter(|(_, rate)| *rate > 0.0).map(|(azimuth, rate)| {
        let left = raceway.thickness_at(azimuth);
        // The last stride goes a rounding further, so that it ends with the spot through and not just before.
        let depth = if through { loss * coating } else { (loss * coating).min(left * (1.0 + 1e-12) + 1e-12 * coating) };
        depth / rate
    });
    spots.fold(f64::INFINITY, f64::min)
}

/// Rates of the spline at the middles of the bins.
fn smoothed(rates: &[f64]) -> impl Iterator<Item = f64> + '_ {
    let n = rates.len();
    (0..n).map(move |k| 0.125 * (rates[(k + n - 1) % n] + rates[(k + 1) % n]) + 0.75 * rates[k])
}
