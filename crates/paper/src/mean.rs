//! Means of what is sampled.

/// Arithmetic mean; NaN of nothing.
pub fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), v| (sum + v, count + 1.0));
    sum / count
}

/// Root of the mean square of the lengths of vectors; a number is a vector of one component.
pub fn rms<const N: usize>(vectors: impl Iterator<Item = [f64; N]>) -> f64 {
    mean(vectors.map(|v| v.iter().map(|x| x * x).sum())).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_mean_and_rms_of_a_square_wave_about_its_mean() {
        let wave = [3.0, -1.0, 3.0, -1.0];
        let middle = mean(wave.into_iter());
        assert_eq!((middle, rms(wave.into_iter().map(|v| [v - middle]))), (1.0, 2.0));
        assert_eq!(rms([[3.0, 4.0], [0.0, 5.0]].into_iter()), 5.0);
    }

    #[test]
    fn limit_nothing_has_no_mean() {
        assert!(mean(std::iter::empty()).is_nan() && rms(std::iter::empty::<[f64; 2]>()).is_nan());
    }
}
