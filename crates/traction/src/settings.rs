//! The choices a user makes about traction: unit of slip, quadrature, pressure, slip terms.

#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

/// The quantity s that enters the traction curve κ(s), made from the sliding speed |Δv| and the rolling speed V.
///
/// The source paper gives no unit for its slip axis, so the unit is an input.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize), serde(deny_unknown_fields))]
pub enum SlipUnit {
    /// s = |Δv| in m/s.
    MeterPerSecond,
    /// s = 100 |Δv| / V.
    PercentOfRolling,
    /// s = 1000 |Δv| / V.
    PerMilleOfRolling,
    /// s = λ |Δv|.
    Scaled {
        /// The slip scale λ, 1/(m/s).
        per_m_s: f64,
    },
}

/// Rule for the integral over the contact ellipse.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize), serde(deny_unknown_fields))]
pub enum PatchRule {
    /// The paper's rule (its Table 1): midpoints of `radial` × `circumferential` polar cells of the unit circle.
    PolarMidpoint {
        /// Cells along the radius.
        radial: usize,
        /// Cells along the circumference.
        circumferential: usize,
    },
    /// Gauss–Jacobi in the squared radius (weight √(1−u)) times equispaced angles, every other ring turned by half.
    GaussJacobi {
        /// Nodes along the radius.
        radial: usize,
        /// Equispaced angles.
        angles: usize,
    },
    /// Strips across the groove, cut where the longitudinal slip vanishes, with nodes drawn to the pole of the slip.
    SplitStrip {
        /// Gauss–Legendre nodes across the groove, per panel.
        across: usize,
        /// Nodes along the rolling direction, per strip.
        along: usize,
    },
    /// The cheapest rule whose estimated error of force and moment stays below `relative` × load.
    TargetError {
        /// Error of the traction force over the contact load.
        relative: f64,
    },
}

/// The pressure at which the curve's parameters are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub enum PressureChoice {
    /// The peak pressure of the contact, one curve per contact.
    Peak,
    /// The local Hertz pressure at each point of the patch.
    Local,
}
