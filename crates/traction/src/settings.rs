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
}

/// The rule of a problem: named, or found by the error that is allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize), serde(from = "Written", into = "Written"))]
pub enum PatchChoice {
    /// This rule.
    Named(PatchRule),
    /// The cheapest rule whose estimated error of force and moment stays below `relative` × load; found by
    /// [`crate::choose_rule`].
    TargetError {
        /// Error of the traction force over the contact load.
        relative: f64,
    },
}

impl PatchChoice {
    /// True if an estimated error over the load is allowed; named rules are taken as they are.
    pub fn allows(&self, estimate: Option<f64>) -> bool {
        match *self {
            Self::Named(_) => true,
            Self::TargetError { relative } => estimate.is_some_and(|estimate| estimate <= relative),
        }
    }
}

impl From<PatchRule> for PatchChoice {
    fn from(rule: PatchRule) -> Self {
        Self::Named(rule)
    }
}

/// A choice as files have it: the names of rules and of the target stand side by side.
#[cfg(feature = "serde")]
#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
enum Written {
    PolarMidpoint { radial: usize, circumferential: usize },
    GaussJacobi { radial: usize, angles: usize },
    SplitStrip { across: usize, along: usize },
    TargetError { relative: f64 },
}

#[cfg(feature = "serde")]
impl From<Written> for PatchChoice {
    fn from(written: Written) -> Self {
        match written {
            Written::PolarMidpoint { radial, circumferential } => {
                PatchRule::PolarMidpoint { radial, circumferential }.into()
            }
            Written::GaussJacobi { radial, angles } => PatchRule::GaussJacobi { radial, angles }.into(),
            Written::SplitStrip { across, along } => PatchRule::SplitStrip { across, along }.into(),
            Written::TargetError { relative } => Self::TargetError { relative },
        }
    }
}

#[cfg(feature = "serde")]
impl From<PatchChoice> for Written {
    fn from(choice: PatchChoice) -> Self {
        match choice {
            PatchChoice::Named(PatchRule::PolarMidpoint { radial, circumferential }) => {
                Self::PolarMidpoint { radial, circumferential }
            }
            PatchChoice::Named(PatchRule::GaussJacobi { radial, angles }) => Self::GaussJacobi { radial, angles },
            PatchChoice::Named(PatchRule::SplitStrip { across, along }) => Self::SplitStrip { across, along },
            PatchChoice::TargetError { relative } => Self::TargetError { relative },
        }
    }
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
