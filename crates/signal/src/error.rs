//! Errors of samples and settings, and the checks that all functions share.

/// Errors of the evaluation of a signal.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SignalError {
    /// Fewer samples than the evaluation needs.
    #[error("{count} samples, but at least {needed} are needed")]
    TooFewSamples {
        /// Samples given.
        count: usize,
        /// Samples needed.
        needed: usize,
    },
    /// A sample that is NaN or infinite.
    #[error("sample {index} is {value}")]
    NotFinite {
        /// Index of the sample, from 0.
        index: usize,
        /// The sample.
        value: f64,
    },
    /// A sampling rate that is not a positive number.
    #[error("a sampling rate of {rate_hz} Hz is not a positive number")]
    Rate {
        /// The rate, Hz.
        rate_hz: f64,
    },
    /// A band that is empty, not within 0 to half the sampling rate, or without a line of the spectrum.
    #[error("the band {low_hz} Hz to {high_hz} Hz must rise, lie within 0 to {nyquist_hz} Hz and hold a spectral line")]
    Band {
        /// Lower edge, Hz.
        low_hz: f64,
        /// Upper edge, Hz.
        high_hz: f64,
        /// Half the sampling rate, Hz.
        nyquist_hz: f64,
    },
    /// Segments that do not move on, or are longer than the signal.
    #[error("segments of {segment} samples that overlap by {overlap} do not divide {count} samples")]
    Segments {
        /// Samples in a segment.
        segment: usize,
        /// Samples shared by neighbouring segments.
        overlap: usize,
        /// Samples given.
        count: usize,
    },
    /// A fundamental whose harmonics the spectrum cannot separate, or that is no positive number below half the
    /// sampling rate.
    #[error(
        "harmonics of {fundamental_hz} Hz need a fundamental from {least_hz} Hz to {nyquist_hz} Hz to be told apart"
    )]
    Fundamental {
        /// Fundamental asked for, Hz.
        fundamental_hz: f64,
        /// Least fundamental whose harmonics do not run into each other, Hz.
        least_hz: f64,
        /// Half the sampling rate, Hz.
        nyquist_hz: f64,
    },
    /// A setting that must be a positive (or, where it says so, not negative) number.
    #[error("{name} is {value}, which is outside its range")]
    Setting {
        /// Name of the setting.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// Speeds that do not belong to the samples one by one.
    #[error("{speeds} speeds for {count} samples")]
    SpeedCount {
        /// Speeds given.
        speeds: usize,
        /// Samples given.
        count: usize,
    },
    /// A shaft that stands or turns back, so that the angle does not grow.
    #[error("the shaft speed at sample {index} is {speed_rad_s} rad/s: the angle must grow with every sample")]
    Speed {
        /// Index of the sample, from 0.
        index: usize,
        /// The speed, rad/s.
        speed_rad_s: f64,
    },
    /// A speed range so wide that resampling at the density of the slowest part would take too many points.
    #[error("the slowest speed, {slowest_rad_s} rad/s, is below a {limit}th of the mean, {mean_rad_s} rad/s")]
    SpeedRange {
        /// Slowest speed, rad/s.
        slowest_rad_s: f64,
        /// Mean speed, rad/s.
        mean_rad_s: f64,
        /// Greatest ratio of the mean to the slowest.
        limit: usize,
    },
    /// A key phase without pulses.
    #[error("the key phase has {pulses} pulses, but at least 3 are needed for a speed")]
    TooFewPulses {
        /// Pulses found.
        pulses: usize,
    },
    /// Less than one turn of the shaft.
    #[error("the samples span {turns} turns of the shaft, but one is needed")]
    TooFewTurns {
        /// Turns spanned.
        turns: f64,
    },
    /// Too few turns of the shaft to tell the lines of a bearing apart.
    #[error(
        "the samples span {turns:.1} turns of the shaft, but {needed} are needed to tell the lines of a bearing apart"
    )]
    FewTurns {
        /// Turns spanned.
        turns: f64,
        /// Turns needed.
        needed: f64,
    },
    /// A rate too low for the lines of a bearing.
    #[error(
        "a sampling rate of {rate_hz} Hz is too low for the lines of this bearing at this speed: {needed_hz:.0} Hz are needed"
    )]
    SlowRate {
        /// The rate, Hz.
        rate_hz: f64,
        /// Least rate, Hz.
        needed_hz: f64,
    },
    /// A signal that does not change.
    #[error("the signal is constant but for its trend")]
    Still,
    /// No maximum of the autocorrelation between the bounds.
    #[error("the autocorrelation has no positive maximum between {shortest_s} s and {longest_s} s")]
    NoPeriod {
        /// Shortest period looked for, s.
        shortest_s: f64,
        /// Longest period looked for, s.
        longest_s: f64,
    },
    /// A geometry that no bearing has.
    #[error(
        "{ball_count} balls of {} mm on a pitch circle of {} mm at {}° do not make a bearing",
        rounded(1e3 * ball_diameter_m),
        rounded(1e3 * pitch_diameter_m),
        rounded(contact_angle_rad.to_degrees())
    )]
    Geometry {
        /// Number of balls.
        ball_count: usize,
        /// Ball diameter, m.
        ball_diameter_m: f64,
        /// Pitch diameter, m.
        pitch_diameter_m: f64,
        /// Contact angle, rad.
        contact_angle_rad: f64,
    },
    /// The Fourier transform refused its input.
    #[error("Fourier transform: {0}")]
    Transform(String),
}

/// A number without the rounding of its unit.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// Refuses a rate that is not a positive number.
pub(crate) fn check_rate(rate_hz: f64) -> Result<(), SignalError> {
    if rate_hz.is_finite() && rate_hz > 0.0 { Ok(()) } else { Err(SignalError::Rate { rate_hz }) }
}

/// Refuses too few samples and numbers that are not finite.
pub(crate) fn check_samples(samples: &[f64], needed: usize) -> Result<(), SignalError> {
    if samples.len() < needed {
        return Err(SignalError::TooFewSamples { count: samples.len(), needed });
    }
    match samples.iter().position(|x| !x.is_finite()) {
        Some(index) => Err(SignalError::NotFinite { index, value: samples[index] }),
        None => Ok(()),
    }
}

/// Refuses a setting that is not finite and at least `least`; `least` itself only where it is allowed.
pub(crate) fn check_setting(name: &'static str, value: f64, zero_allowed: bool) -> Result<(), SignalError> {
    let allowed = value.is_finite() && (value > 0.0 || (zero_allowed && value == 0.0));
    if allowed { Ok(()) } else { Err(SignalError::Setting { name, value }) }
}
