//! Form and size that differ from the drawing: waviness of races and balls, balls of unequal diameter.

use crate::units;
use serde::Deserialize;

/// Deviations of form and size; without them races are round and balls equal.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct DeviationsSpec {
    /// Of the inner race.
    pub inner: WavinessSpec,
    /// Of the outer race.
    pub outer: WavinessSpec,
    /// Of the balls' diameters.
    pub balls: Option<BallSizeSpec>,
    /// Waviness of the balls.
    pub ball_waves: BallWavesSpec,
    /// Where balls and rings stand at time 0, and in an equilibrium.
    pub position: PositionSpec,
}

/// Waviness of a race: waves one by one, a spectrum, or both.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct WavinessSpec {
    /// Waves one by one.
    pub waves: Vec<WaveSpec>,
    /// Waves over a range of orders.
    pub spectrum: Option<SpectrumSpec>,
}

/// Waviness of the balls: waves of single balls, a spectrum of all, or both.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct BallWavesSpec {
    /// Waves one by one.
    pub waves: Vec<BallWaveSpec>,
    /// Forms at random, with amplitudes by order.
    pub spectrum: Option<SpectrumSpec>,
}

/// A wave round a ball, A cosⁿλ cos(n θ + ψ) lower than the round one: θ along the rolling circle from the outer
/// contact at time 0, λ across it.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BallWaveSpec {
    /// Number of the ball.
    pub ball: usize,
    /// Order n, the waves in one turn.
    pub order: u32,
    /// Amplitude A, m.
    #[serde(deserialize_with = "units::length")]
    pub amplitude: f64,
    /// Phase ψ, rad.
    #[serde(deserialize_with = "units::angle")]
    pub phase: f64,
}

/// A wave round a race: A cos(n φ + ψ) deeper than the round one, φ in the ring's own frame.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WaveSpec {
    /// Order n, the waves in one turn.
    pub order: u32,
    /// Amplitude A, m.
    #[serde(deserialize_with = "units::length")]
    pub amplitude: f64,
    /// Phase ψ, rad.
    #[serde(deserialize_with = "units::angle")]
    pub phase: f64,
}

/// Waves of a range of orders with the amplitudes A_n = A_1 n^(−p) and phases at random.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpectrumSpec {
    /// Lowest order.
    pub first: u32,
    /// Highest order.
    pub last: u32,
    /// Amplitude A_1 that order 1 would have, m.
    #[serde(deserialize_with = "units::length")]
    pub amplitude: f64,
    /// Exponent p.
    pub exponent: f64,
    /// Seed of the phases.
    pub seed: u64,
}

/// Diameters of the balls.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum BallSizeSpec {
    /// Diameter of each ball over the nominal one, in the order of their azimuths.
    Excess(Vec<LengthSpec>),
    /// A lot of a grade of ISO 3290-1, drawn at random.
    Grade {
        /// The grade: 10 for G10.
        grade: u32,
        /// Seed of the draw.
        seed: u64,
    },
}

/// A length, m.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(transparent)]
pub struct LengthSpec(#[serde(deserialize_with = "units::length")] pub f64);

/// Angles at time 0, rad.
#[derive(Debug, Clone, Copy, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct PositionSpec {
    /// Azimuth of ball 0.
    #[serde(deserialize_with = "units::angle")]
    pub ball: f64,
    /// How far the inner ring has turned.
    #[serde(deserialize_with = "units::angle")]
    pub inner: f64,
    /// How far the outer ring has turned.
    #[serde(deserialize_with = "units::angle")]
    pub outer: f64,
}
