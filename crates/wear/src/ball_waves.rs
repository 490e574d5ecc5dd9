//! Waviness of balls: waves about an axis one by one, and a drawn form whose spectrum is given.
//!
//! A wave of order n about an axis is the sectoral harmonic cosⁿλ cos(n θ + ψ): along its equator a wave like those of
//! races, towards its poles nothing. A drawn form is a sum of zonal harmonics P_n(u_k · d) about a few axes u_k, which
//! is as rough in one direction as in another; along a great circle its part of degree n has the orders n, n − 2 and so
//! on.

use crate::{Random, Wave, WaveSpectrum, WearError};
use std::f64::consts::TAU;

/// Highest order of a wave of a ball.
pub const HIGHEST_OF_BALL: u32 = 200;
/// Axes of a drawn form, as many as fill a register.
const AXES: usize = 8;

/// Waves of the balls of a bearing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BallWaves {
    /// Waves of single balls.
    pub waves: Vec<BallWave>,
    /// A spectrum that all balls have, each with a form of its own.
    pub spectrum: Option<WaveSpectrum>,
}

/// A wave of one ball, along the rolling circle on which its contacts run at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallWave {
    /// Number of the ball.
    pub ball: usize,
    /// The wave; its angle counts from the outer contact at time 0, in the direction of the orbit.
    pub wave: Wave,
}

/// The form of a ball: the depth by which it is lower than the sphere in a direction of its own frame.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BallForm {
    sectoral: Vec<Sectoral>,
    zonal: Option<Zonal>,
}

/// A wave about an axis across two directions, which are at angles of 0° and 90°.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sectoral {
    wave: Wave,
    equator: [[f64; 3]; 2],
}

/// Zonal harmonics about several axes.
#[derive(Debug, Clone, PartialEq)]
struct Zonal {
    /// Components of the axes.
    axes: [[f64; AXES]; 3],
    /// Amplitudes by degree from 2 on, m.
    amplitudes: Vec<[f64; AXES]>,
}

impl BallWaves {
    /// True if all balls are round.
    pub fn are_none(&self) -> bool {
        let flat = |spectrum: &WaveSpectrum| spectrum.amplitude == 0.0;
        self.waves.iter().all(|wave| wave.wave.amplitude == 0.0) && self.spectrum.as_ref().is_none_or(flat)
    }

    /// The form of a ball that has not turned; `equator` are the directions of its outer contact and of rolling.
    ///
    /// # Errors
    /// [`WearError::Wave`] for an order beyond 2 to [`HIGHEST_OF_BALL`], and amplitudes and phases that are not finite.
    pub fn form(&self, ball: usize, equator: [[f64; 3]; 2]) -> Result<BallForm, WearError> {
        let own = self.waves.iter().filter(|wave| wave.ball == ball && wave.wave.amplitude != 0.0);
        let sectoral: Vec<_> = own.map(|of_ball| Sectoral { wave: of_ball.wave, equator }).collect();
        let drawn = self.spectrum.as_ref().filter(|spectrum| spectrum.amplitude != 0.0);
        let drawn_waves = drawn.into_iter().flat_map(WaveSpectrum::waves);
        let waves = sectoral.iter().map(|sectoral| sectoral.wave).chain(drawn_waves);
        waves.into_iter().try_for_each(|wave| wave.check((2, HIGHEST_OF_BALL), "2 to 200"))?;
        Ok(BallForm { sectoral, zonal: drawn.map(|spectrum| Zonal::drawn(spectrum, ball)) })
    }
}

impl BallForm {
    /// Depth in a direction (a unit vector) of the ball's frame, m, and a vector whose part across that direction is
    /// its gradient on the unit sphere.
    #[inline(always)]
    pub fn at(&self, direction: [f64; 3]) -> (f64, [f64; 3]) {
        // No closure: it would not be compiled for the vector instructions of the caller.
        let mut sum = if let Some(zonal) = &self.zonal { zonal.at(direction) } else { (0.0, [0.0; 3]) };
        for sectoral in &self.sectoral {
            let (depth, gradient) = sectoral.at(direction);
            sum.0 += depth;
            (0..3).for_each(|k| sum.1[k] += gradient[k]);
        }
        sum
    }
}

impl Sectoral {
    /// With c = d · (e₁ + i e₂): A Re(cⁿ e^(iψ)).
    fn at(&self, direction: [f64; 3]) -> (f64, [f64; 3]) {
        let Wave { order, amplitude, phase } = self.wave;
        let [x, y] = self.equator.map(|e| dot(e, direction));
        let (radius, angle, n) = (x.hypot(y), y.atan2(x), f64::from(order));
        // cⁿ⁻¹ e^(iψ), whose product with c is the wave, and with n that of the slope.
        let below = amplitude * radius.powi(order as i32 - 1);
        let (sin, cos) = ((n - 1.0) * angle + phase).sin_cos();
        let (real, imaginary) = (below * cos, below * sin);
        let [first, second] = self.equator;
        let gradient = std::array::from_fn(|k| n * (real * first[k] - imaginary * second[k]));
        (real * x - imaginary * y, gradient)
    }
}

impl Zonal {
    /// A form whose part of degree n has the mean square A_n²/2 over the sphere.
    fn drawn(spectrum: &WaveSpectrum, ball: usize) -> Self {
        // Streams that no race has: those count orders from 1 on.
        let mut random = Random::new(spectrum.seed, (1 << 40) + ball as u64);
        let [mut x, mut y, mut z] = [[0.0; AXES]; 3];
        for ((x, y), z) in x.iter_mut().zip(&mut y).zip(&mut z) {
            *z = random.between(-1.0, 1.0);
            let (sin, cos) = random.between(0.0, TAU).sin_cos();
            let across = (1.0 - *z * *z).sqrt();
            (*x, *y) = (across * cos, across * sin);
        }
        let axes = [x, y, z];
        let mut amplitudes: Vec<_> =
            (2..=spectrum.last).map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let shares = mean_squares(&axes, &amplitudes);
        for ((degree, amplitudes), share) in (2..).zip(&mut amplitudes).zip(shares) {
            let wanted = spectrum.amplitude * f64::from(degree).powf(-spectrum.exponent);
            let scale = if degree < spectrum.first { 0.0 } else { (0.5 * wanted * wanted / share).sqrt() };
            amplitudes.iter_mut().for_each(|amplitude| *amplitude *= scale);
        }
        Self { axes, amplitudes }
    }

    /// By the recurrences of Legendre polynomials and of their derivatives.
    #[inline(always)]
    fn at(&self, [x, y, z]: [f64; 3]) -> (f64, [f64; 3]) {
        let [a, b, c] = &self.axes;
        let mut cosines = [0.0; AXES];
        for (k, cosine) in cosines.iter_mut().enumerate() {
            *cosine = a[k] * x + b[k] * y + c[k] * z;
        }
        let (mut before, mut value) = ([1.0; AXES], cosines);
        let (mut slope_before, mut slope) = ([0.0; AXES], [1.0; AXES]);
        let (mut depth, mut by_cosine) = ([0.0; AXES], [0.0; AXES]);
        for (n, amplitudes) in (1u32..).map(f64::from).zip(&self.amplitudes) {
            let (twice, share) = (2.0 * n + 1.0, 1.0 / (n + 1.0));
            for k in 0..AXES {
                let next = (twice * cosines[k] * value[k] - n * before[k]) * share;
                let next_slope = slope_before[k] + twice * value[k];
                (before[k], value[k]) = (value[k], next);
                (slope_before[k], slope[k]) = (slope[k], next_slope);
                depth[k] += amplitudes[k] * next;
                by_cosine[k] += amplitudes[k] * next_slope;
            }
        }
        let (mut sum, mut gradient) = (0.0, [0.0; 3]);
        for k in 0..AXES {
            sum += depth[k];
            (gradient[0], gradient[1], gradient[2]) = (
                gradient[0] + by_cosine[k] * a[k],
                gradient[1] + by_cosine[k] * b[k],
                gradient[2] + by_cosine[k] * c[k],
            );
        }
        (sum, gradient)
    }
}

/// Mean squares over the sphere of the parts of each degree: by the addition theorem zonal harmonics of degree n about
/// two axes have the mean product P_n(u · v)/(2n + 1).
fn mean_squares(axes: &[[f64; AXES]; 3], amplitudes: &[[f64; AXES]]) -> Vec<f64> {
    let mut sums = vec![0.0; amplitudes.len()];
    for j in 0..AXES {
        for k in 0..AXES {
            let cosine: f64 = axes.iter().map(|axis| axis[j] * axis[k]).sum();
            let (mut before, mut value) = (1.0, cosine);
            for ((n, sum), of_degree) in (1u32..).map(f64::from).zip(&mut sums).zip(amplitudes) {
                let next = ((2.0 * n + 1.0) * cosine * value - n * before) / (n + 1.0);
                (before, value) = (value, next);
                *sum += of_degree[j] * of_degree[k] * next / (2.0 * n + 3.0);
            }
        }
    }
    sums
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    const EQUATOR: [[f64; 3]; 2] = [[0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];

    fn waves(waves: &[BallWave], spectrum: Option<WaveSpectrum>) -> BallForm {
        BallWaves { waves: waves.to_vec(), spectrum }.form(3, EQUATOR).unwrap()
    }

    fn direction(azimuth: f64, height: f64) -> [f64; 3] {
        let across = (1.0 - height * height).sqrt();
        [across * azimuth.cos(), across * azimuth.sin(), height]
    }

    /// Mean of a product over the sphere, by 64 azimuths and the midpoints of 4000 heights.
    fn mean(of: impl Fn([f64; 3]) -> f64) -> f64 {
        let (around, high) = (64, 4000);
        let rows = (0..high).flat_map(|i| (0..around).map(move |j| (i, j)));
        let place = |(i, j)| {
            direction(TAU * f64::from(j) / f64::from(around), (2.0 * f64::from(i) + 1.0) / f64::from(high) - 1.0)
        };
        rows.map(place).map(of).sum::<f64>() / f64::from(around * high)
    }

    #[test]
    fn limit_a_wave_runs_round_its_equator_and_dies_out_at_its_poles() {
        let wave = Wave { order: 6, amplitude: 1e-6, phase: 0.4 };
        let form = waves(&[BallWave { ball: 3, wave }, BallWave { ball: 2, wave }], None);
        let [first, second] = EQUATOR;
        for k in 0..40 {
            let angle = 0.17 * f64::from(k);
            let (sin, cos) = angle.sin_cos();
            let here = std::array::from_fn(|k| cos * first[k] + sin * second[k]);
            let onwards: [f64; 3] = std::array::from_fn(|k| cos * second[k] - sin * first[k]);
            let (depth, gradient) = form.at(here);
            let (expected, slope) = wave.at(angle);
            assert!((depth - expected).abs() < 1e-20 && (dot(gradient, onwards) - slope).abs() < 1e-19);
        }
        assert!(form.at([0.8, -0.6, 0.0]).0.abs() < 1e-30);
    }

    #[test]
    fn identity_the_gradient_is_that_of_the_depth() {
        let wave = Wave { order: 5, amplitude: 1e-6, phase: 1.1 };
        let spectrum = WaveSpectrum { first: 2, last: 30, amplitude: 1e-6, exponent: 1.0, seed: 4 };
        let form = waves(&[BallWave { ball: 3, wave }], Some(spectrum));
        for k in 0..50 {
            let (azimuth, height) = (0.37 * f64::from(k), (0.61 * f64::from(k)).sin() * 0.99);
            let d = direction(azimuth, height);
            let across = [-azimuth.sin(), azimuth.cos(), 0.0];
            let moved = |by: f64| {
                let (sin, cos) = by.sin_cos();
                form.at(std::array::from_fn(|k| cos * d[k] + sin * across[k])).0
            };
            let difference = (moved(1e-5) - moved(-1e-5)) / 2e-5;
            assert!((difference - dot(form.at(d).1, across)).abs() < 1e-12, "{k}");
        }
    }

    #[test]
    fn identity_a_drawn_form_has_the_mean_square_of_its_spectrum() {
        let spectrum = |first, last| WaveSpectrum { first, last, amplitude: 1e-6, exponent: 1.5, seed: 11 };
        let variance = |first: u32, last: u32| {
            let form = waves(&[], Some(spectrum(first, last)));
            let level = mean(|d| form.at(d).0);
            (mean(|d| form.at(d).0.powi(2)), level)
        };
        for (first, last) in [(2, 2), (7, 7), (2, 12)] {
            let (found, level) = variance(first, last);
            let wanted: f64 = spectrum(first, last).waves().map(|wave| 0.5 * wave.amplitude.powi(2)).sum();
            assert!((found / wanted - 1.0).abs() < 1e-5 && level.abs() < 1e-12, "{first}: {found:e} {wanted:e}");
        }
    }

    #[test]
    fn symmetry_even_degrees_are_alike_on_both_sides_and_odd_ones_opposite() {
        for (degree, sign) in [(2, 1.0), (3, -1.0), (8, 1.0)] {
            let spectrum = WaveSpectrum { first: degree, last: degree, amplitude: 1e-6, exponent: 0.0, seed: 1 };
            let form = waves(&[], Some(spectrum));
            let d = direction(0.3, 0.2);
            let (here, there) = (form.at(d).0, form.at(d.map(|v| -v)).0);
            assert!((here - sign * there).abs() < 1e-18 && here.abs() > 1e-9, "{degree}");
        }
    }

    #[test]
    fn limit_waves_that_are_none_are_refused_or_left_out() {
        let flat = Wave { order: 4, amplitude: 0.0, phase: 0.0 };
        let none = BallWaves { waves: vec![BallWave { ball: 0, wave: flat }], spectrum: None };
        assert!(none.are_none() && none.form(0, EQUATOR) == Ok(BallForm::default()));
        for order in [1, 201] {
            let wave = BallWave { ball: 0, wave: Wave { order, amplitude: 1e-6, phase: 0.0 } };
            let waves = BallWaves { waves: vec![wave], spectrum: None };
            assert!(matches!(waves.form(0, EQUATOR), Err(WearError::Wave { name: "order", .. })), "{order}");
        }
    }
}
