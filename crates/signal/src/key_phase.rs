//! The speed of a shaft by the pulses of a key phase or tachometer.

use std::f64::consts::TAU;

use crate::error::{SignalError, check_rate, check_samples, check_setting};

/// Part of the range of the pulse signal below and above its middle that has to be crossed before another pulse
/// counts: noise on the edge of a pulse is none.
const HYSTERESIS: f64 = 0.2;

/// Speed of the shaft at each sample, rad/s, from a signal with some pulses in each turn, evenly spaced.
///
/// A pulse is where the signal rises through the middle of its range, between samples by a straight line. The mean
/// speed between two pulses holds in the middle between them; from middle to middle the speed is linear, before the
/// first and after the last one constant.
///
/// # Errors
///
/// A sample that is not finite, a rate (Hz) or number of pulses that is not positive, fewer than three pulses.
pub fn speed_by_pulses(pulses: &[f64], rate_hz: f64, pulses_per_turn: f64) -> Result<Vec<f64>, SignalError> {
    check_rate(rate_hz)?;
    check_samples(pulses, 3)?;
    check_setting("pulses in a turn", pulses_per_turn, false)?;
    let at = rises(pulses);
    if at.len() < 3 {
        return Err(SignalError::TooFewPulses { pulses: at.len() });
    }
    let speed = |pair: &[f64]| TAU / pulses_per_turn * rate_hz / (pair[1] - pair[0]);
    let known: Vec<(f64, f64)> = at.windows(2).map(|pair| (0.5 * (pair[0] + pair[1]), speed(pair))).collect();
    let mut next = 1;
    let speed = |n: usize| {
        let place = n as f64;
        while next + 1 < known.len() && known[next].0 < place {
            next += 1;
        }
        let ((from, low), (to, high)) = (known[next - 1], known[next]);
        low + (high - low) * ((place - from) / (to - from)).clamp(0.0, 1.0)
    };
    Ok((0..pulses.len()).map(speed).collect())
}

/// Places in samples where the signal rises through its middle.
fn rises(pulses: &[f64]) -> Vec<f64> {
    let (least, most) = pulses.iter().fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(*x), b.max(*x)));
    let (middle, dead) = (0.5 * (least + most), HYSTERESIS * 0.5 * (most - least));
    let (mut armed, mut at) = (false, Vec::new());
    let mut crossing = 0.0;
    for (n, pair) in pulses.windows(2).enumerate() {
        armed |= pair[0] < middle - dead;
        if pair[0] < middle && pair[1] >= middle {
            crossing = n as f64 + (middle - pair[0]) / (pair[1] - pair[0]);
        }
        if armed && pair[1] > middle + dead {
            at.push(crossing);
            armed = false;
        }
    }
    at
}
