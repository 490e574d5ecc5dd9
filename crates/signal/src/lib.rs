//! Evaluation of sampled signals of a bearing run: spectra, envelopes, orders, characteristic frequencies, statistics.
//!
//! # Equations
//!
//! ```text
//! A_k = 2/Σw |Σ w_n (x_n − x̄) exp(−2πi k n/N)|,   f_k = k f_s/N,   x̄ = Σ w x/Σ w         (amplitude spectrum)
//! Σ A_k²/(2B) = Σ w² (x − x̄)²/Σ w²,   B = N Σw²/(Σw)²                                    (Parseval)
//! L(δ) = sinc δ + Σ_j a_j/(2a_0) [sinc(δ − j) + sinc(δ + j)],   w_n = Σ_j (−1)^j a_j cos(2πjn/N)   (lobe of a sine)
//! S_k = A_k²/(2 B f_s/N), averaged over segments                                       (Welch)
//! e = |x + i H{x}|,   θ(t) = ∫ ω dt,   r(τ) = Σ x x_τ/√(Σ x² Σ x_τ²)                     (envelope, angle, autocorrelation)
//! y_m = Σ_j g((j − ½)/n − m + D) x_j,   g = w(u/D) (2/n) ∫ cos(2πfu)/sinc(f/n) df     (low-pass filter before decimation)
//! f_c = ½ [f_i (1 − γ) + f_o (1 + γ)],   γ = D cos α/d_m                               (cage; others in `BearingFrequencies`)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x, N | samples, their number | unit of the signal, – |
//! | f_s, f_k | sampling rate, frequency of line k | Hz |
//! | w, a_j, B | window, its cosine coefficients, equivalent noise bandwidth | –, –, lines |
//! | L, δ | height of the lobe of a sine, distance from its middle | –, lines |
//! | A, S | amplitude, power spectral density | unit, unit²/Hz |
//! | H | Hilbert transform | |
//! | y, n, D | filtered and decimated samples, inputs to one, delay | unit, –, output intervals |
//! | θ, ω | shaft angle and speed | rad, rad/s |
//! | D, d_m, α | ball diameter, pitch diameter, contact angle | m, m, rad |
//! | f_i, f_o, f_c | turns of inner ring, outer ring and cage | Hz |
//!
//! # Sources
//!
//! - Windows: F. J. Harris, Proc. IEEE 66 (1978) 51, doi:10.1109/PROC.1978.10837; flat top: G. D'Antona, A. Ferrero, "Digital Signal
//!   Processing for Measurement Systems", Springer 2006.
//! - Frequencies between lines: T. Grandke, IEEE Trans. Instrum. Meas. 32 (1983) 350, doi:10.1109/TIM.1983.4314077.
//! - Low-pass filter: J. F. Kaiser, Proc. IEEE Int. Symp. Circuits and Systems 1974, 20.
//! - Density: P. D. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70, doi:10.1109/TAU.1967.1161901.
//! - Bearing frequencies and envelope analysis: R. B. Randall, J. Antoni, Mech. Syst. Signal Process. 25 (2011) 485,
//!   doi:10.1016/j.ymssp.2010.07.017.
//!
//! # Limits
//!
//! - Samples are evenly spaced in time; a run with varying steps must be resampled first.
//! - Two sines closer than a lobe (Hann: 2 lines to each side) are one peak, at a place between them.
//! - Interpolation between lines holds for a sine whose lobe is free of others; the sine's own image at negative frequency disturbs
//!   it below about 5 lines.
//! - The transform takes the record as periodic: envelopes are wrong near the ends where it is not.
//!
//! # What this crate does not know
//!
//! Bearings beyond their characteristic frequencies, runs, files, figures. It uses no other crate of the workspace.
//!
//! # Example
//!
//! ```
//! use tribodyn_signal::{Spectrum, Window};
//!
//! // 0.3 s of a sine of 96.7 Hz, between the lines of the spectrum.
//! let samples: Vec<f64> = (0..3000).map(|n| (2.0 * std::f64::consts::PI * 96.7 * f64::from(n) / 10_000.0).sin()).collect();
//! let spectrum = Spectrum::of(&samples, 10_000.0, Window::Hann)?;
//! let peak = spectrum.peaks(1, 0.0)[0];
//! assert!((peak.frequency_hz - 96.7).abs() < 1e-3 && (peak.amplitude - 1.0).abs() < 1e-3);
//! # Ok::<(), tribodyn_signal::SignalError>(())
//! ```

mod bearing;
mod decimator;
mod envelope;
mod error;
mod harmonics;
mod order;
mod period;
mod settling;
mod spectrum;
mod statistics;
mod transform;
mod welch;
mod window;

pub use bearing::BearingFrequencies;
pub use decimator::{Decimator, DecimatorMemory};
pub use envelope::{envelope, envelope_spectrum};
pub use error::SignalError;
pub use harmonics::{HarmonicFamily, HarmonicLine};
pub use order::{AngleSamples, OrderPeak, OrderSpectrum, order_spectrum, resample_by_angle};
pub use period::{Period, period};
pub use settling::{Settling, SettlingRule, settling};
pub use spectrum::{Peak, Spectrum};
pub use statistics::Statistics;
pub use welch::{PowerDensity, Segments, welch};
pub use window::Window;
