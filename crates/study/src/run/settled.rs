//! When a run has become steady.

use serde::Serialize;
use tribodyn_signal::{SettlingRule, settling};

/// Part of the mean within which the running mean of the cage speed stays in a steady run.
const SPEED: f64 = 1e-3;
/// The same for the power of the drives, which every pass of a ball moves.
const POWER: f64 = 0.02;
/// Fewest turns of the cage in which steadiness can be judged.
const FEWEST_TURNS: f64 = 4.0;

/// How steady a run is by the running means over one turn of the cage.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Settled {
    /// Steady from this time on, s.
    At(f64),
    /// Means still change in the last quarter.
    Not,
    /// Fewer than four turns of the cage.
    TooShort,
}

impl Settled {
    /// Judges the cage speed (r/min) and the power of the drives (W) between two times (s), at a rate in Hz.
    pub(crate) fn of([first_s, last_s]: [f64; 2], rate_hz: f64, cage_speed: &[f64], shaft: &[f64]) -> Self {
        let mean = |samples: &[f64]| {
            let half = &samples[samples.len() / 2..];
            half.iter().sum::<f64>() / half.len() as f64
        };
        let (speed, power) = (mean(cage_speed).abs(), mean(shaft).abs());
        let turn_s = 60.0 / speed;
        if !turn_s.is_finite() || last_s - first_s < FEWEST_TURNS * turn_s {
            return Self::TooShort;
        }
        let time_of = |samples: &[f64], mean: f64, part: f64| {
            // The ripple is none of the question: pockets may rattle for ever.
            let far = samples.iter().fold(f64::MIN_POSITIVE, |most: f64, x| most.max(x.abs()));
            let rule = SettlingRule { window_s: turn_s, mean_tolerance: part * mean, rms_tolerance: 2.0 * far };
            settling(samples, rate_hz, rule).ok()
        };
        let judged = [time_of(cage_speed, speed, SPEED), time_of(shaft, power, POWER)];
        let [Some(speed), Some(power)] = judged else { return Self::TooShort };
        match (speed.time_s, power.time_s) {
            (Some(a), Some(b)) => Self::At(first_s + a.max(b)),
            _ => Self::Not,
        }
    }

    /// Where the averages of a run that ends at a time begin: with its second half, or when it is steady if that is
    /// later and leaves a quarter of the run.
    pub fn averages_from_s(self, end_s: f64) -> f64 {
        match self {
            Self::At(time_s) if time_s <= 0.75 * end_s => time_s.max(0.5 * end_s),
            _ => 0.5 * end_s,
        }
    }

    /// A sentence about it.
    pub fn sentence(self) -> String {
        match self {
            Self::At(0.0) => "The run is steady from its start on.".to_owned(),
            Self::At(time_s) => format!("The run is steady from {time_s:.4} s on."),
            Self::Not => "The run has not become steady: the means are of a motion that still changes.".to_owned(),
            Self::TooShort => format!(
                "The run is shorter than {FEWEST_TURNS} turns of the cage: whether it is steady cannot be told."
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::gathered::Gathered;
    use super::*;
    use tribodyn_record::StateRow;

    fn judged(rows: &[StateRow]) -> Settled {
        let mut gathered = Gathered::default();
        rows.iter().for_each(|row| gathered.add(*row));
        gathered.settled()
    }

    /// A second at 1000 Hz and 3000 r/min with a start that dies away within a time constant, s.
    fn states(constant_s: f64) -> Vec<StateRow> {
        let row = |k: i32| {
            let time_s = 1e-3 * f64::from(k);
            let start = (-time_s / constant_s).exp();
            // Ten samples long, so that whole ripples fit a turn.
            let ripple = (f64::from(k) * std::f64::consts::TAU / 10.0).sin();
            let cage_speed_rpm = 3000.0 * (1.0 - start) + ripple;
            StateRow { time_s, cage_speed_rpm, shaft_w: 100.0 + 50.0 * ripple, ..StateRow::default() }
        };
        (0..=1000).map(row).collect()
    }

    #[test]
    fn limit_a_start_that_dies_away_settles_and_a_drift_does_not() {
        let Settled::At(time_s) = judged(&states(0.02)) else { panic!("it settles") };
        // exp(-t/T) = 1e-3 at 6.9 T, the mean over 20 ms ahead of it a little earlier.
        assert!((0.1..0.15).contains(&time_s), "{time_s}");
        assert_eq!(judged(&states(1.0)), Settled::Not);
        assert_eq!(judged(&states(0.02)[..60]), Settled::TooShort);
        assert_eq!(judged(&[]), Settled::TooShort);
    }

    #[test]
    fn limit_averages_begin_with_the_second_half_at_the_earliest() {
        assert_eq!(Settled::At(0.1).averages_from_s(1.0), 0.5);
        assert_eq!(Settled::At(0.6).averages_from_s(1.0), 0.6);
        assert_eq!(Settled::At(0.9).averages_from_s(1.0), 0.5);
        assert_eq!(Settled::Not.averages_from_s(1.0), 0.5);
    }
}
