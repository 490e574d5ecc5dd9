//! Discrete Fourier transforms of real data of any length.

use realfft::RealFftPlanner;
use realfft::num_complex::Complex;
use rustfft::FftPlanner;

use crate::error::SignalError;

/// `X_k = Σ x_n exp(−2πi k n/N)` for k from 0 to N/2.
pub(crate) fn forward(mut samples: Vec<f64>) -> Result<Vec<Complex<f64>>, SignalError> {
    let plan = RealFftPlanner::<f64>::new().plan_fft_forward(samples.len());
    let mut lines = plan.make_output_vec();
    plan.process(&mut samples, &mut lines).map_err(|e| SignalError::Transform(e.to_string()))?;
    Ok(lines)
}

/// The inverse of [`forward`] with its factor 1/N; imaginary parts that a real signal cannot have are dropped.
pub(crate) fn inverse(mut lines: Vec<Complex<f64>>, count: usize) -> Result<Vec<f64>, SignalError> {
    let plan = RealFftPlanner::<f64>::new().plan_fft_inverse(count);
    lines[0].im = 0.0;
    if count.is_multiple_of(2)
        && let Some(last) = lines.last_mut()
    {
        last.im = 0.0;
    }
    let mut samples = plan.make_output_vec();
    plan.process(&mut lines, &mut samples).map_err(|e| SignalError::Transform(e.to_string()))?;
    let scale = 1.0 / count as f64;
    samples.iter_mut().for_each(|x| *x *= scale);
    Ok(samples)
}

/// `x_n = Σ X_k exp(2πi k n/N)`, without a factor.
pub(crate) fn inverse_complex(mut lines: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
    FftPlanner::<f64>::new().plan_fft_inverse(lines.len()).process(&mut lines);
    lines
}

/// True if a line of a transform of `count` samples has a partner at negative frequency.
pub(crate) fn has_partner(line: usize, count: usize) -> bool {
    line != 0 && 2 * line != count
}
