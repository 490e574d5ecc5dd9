//! Many starts in parallel, and the distinct minima they end in.

use crate::IdentifyError;
use crate::fit::{LeastSquares, Point, fit};
use nalgebra::DVector;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rayon::prelude::*;

/// A minimum and how many starts ended there.
#[derive(Debug, Clone)]
pub struct Minimum {
    /// Its place.
    pub point: Point,
    /// Starts that ended here.
    pub starts: usize,
}

/// Result of all starts.
#[derive(Debug, Clone)]
pub struct Search {
    /// Distinct minima, the best first.
    pub minima: Vec<Minimum>,
    /// Starts that found no equilibrium to begin with, and why the first of them did not.
    pub failed: (usize, Option<IdentifyError>),
}

/// Largest distance in any coordinate at which two ends count as one minimum.
const SAME: f64 = 0.02;
/// Share of the bounds' range next to each bound in which no start lies: there the model is most often unreasonable.
const MARGIN: f64 = 0.1;

/// Fits from `count` starts spread over the bounds by a Latin hypercube of the given seed, and from the values of the
/// case where the problem asks for that; the same seed gives the same
/// answer on any number of threads.
///
/// # Errors
/// [`IdentifyError::NoStart`] where no start finds an equilibrium.
pub fn search(
    squares: &LeastSquares<'_>,
    seed: u64,
    count: usize,
    finished: &(dyn Fn() + Sync),
) -> Result<Search, IdentifyError> {
    let mut starts = latin_hypercube(squares.free.len(), count, seed);
    if squares.problem.from_case {
        starts.insert(0, own_start(squares));
    }
    let ends: Vec<Result<Point, IdentifyError>> = starts
        .into_par_iter()
        .map(|start| {
            let end = fit(squares, start);
            finished();
            end
        })
        .collect();
    let mut failed = (0, None);
    let mut points = Vec::new();
    for end in ends {
        match end {
            Ok(point) => points.push(point),
            Err(error) => {
                failed.0 += 1;
                failed.1.get_or_insert(error);
            }
        }
    }
    points.sort_by(|a, b| a.cost().total_cmp(&b.cost()));
    let mut minima: Vec<Minimum> = Vec::new();
    for point in points {
        let near = |m: &&mut Minimum| (&m.point.coordinates - &point.coordinates).amax() < SAME;
        match minima.iter_mut().find(near) {
            Some(minimum) => minimum.starts += 1,
            None => minima.push(Minimum { point, starts: 1 }),
        }
    }
    if minima.is_empty() {
        let reason = failed.1.map_or_else(String::new, |e| e.to_string());
        return Err(IdentifyError::NoStart { count, reason });
    }
    Ok(Search { minima, failed })
}

/// The values of the case, those beyond their bounds at these.
fn own_start(squares: &LeastSquares<'_>) -> DVector<f64> {
    let own = squares.parameters().map(|parameter| {
        let value = parameter.paths.first().and_then(|path| squares.model.own(path));
        let coordinate = value.map(|value| parameter.coordinate(value)).filter(|c| c.is_finite());
        coordinate.map_or(0.5, |c| c.clamp(0.0, 1.0))
    });
    DVector::from_iterator(squares.free.len(), own)
}

/// `count` points in the unit cube, each coordinate visiting each of `count` equal layers once.
fn latin_hypercube(dimensions: usize, count: usize, seed: u64) -> Vec<DVector<f64>> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut points = vec![DVector::zeros(dimensions); count];
    for k in 0..dimensions {
        let mut layers: Vec<usize> = (0..count).collect();
        for i in (1..count).rev() {
            layers.swap(i, (random.next_u64() % (i as u64 + 1)) as usize);
        }
        for (point, layer) in points.iter_mut().zip(layers) {
            let within = uniform(&mut random);
            point[k] = MARGIN + (1.0 - 2.0 * MARGIN) * (layer as f64 + within) / count as f64;
        }
    }
    points
}

/// A number in [0, 1) from the upper 53 bits.
fn uniform(random: &mut ChaCha8Rng) -> f64 {
    (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_latin_hypercube_visits_every_layer_once() {
        let points = latin_hypercube(3, 20, 7);
        for k in 0..3 {
            let layer = |p: &DVector<f64>| ((p[k] - MARGIN) / (1.0 - 2.0 * MARGIN) * 20.0) as usize;
            let mut layers: Vec<usize> = points.iter().map(layer).collect();
            layers.sort_unstable();
            assert_eq!(layers, (0..20).collect::<Vec<_>>());
        }
        assert_eq!(points, latin_hypercube(3, 20, 7));
        assert_ne!(points, latin_hypercube(3, 20, 8));
    }
}
