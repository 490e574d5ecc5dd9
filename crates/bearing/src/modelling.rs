//! Modelling choices: where the equations can be read in more than one way, and a calculation has to say how.

use serde::{Deserialize, Serialize};

/// The modelling choices of a calculation, each under its name in case files. None has a default: a choice that a model
/// uses must be made, one that it does not use may be left out.
///
/// A further choice is a field here with an enumeration of its readings; the model that uses it asks for it by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Modelling {
    /// True if contact constants follow the actual contact angle, false if they stay those of the free one. For all models.
    pub contact_at_actual_angle: bool,
    /// The axis about which a displaced ring turns. For models with traction.
    #[serde(default)]
    pub ring_centre: Option<RingCentre>,
    /// The race that controls a ball. For Jones–Harris.
    #[serde(default)]
    pub race_control: Option<RaceControl>,
    /// True if the centrifugal force is taken at the undeformed pitch radius, false if at the actual orbit. For Jones–Harris.
    #[serde(default)]
    pub centrifugal_at_free_pitch: Option<bool>,
}

impl Modelling {
    /// The choices that models with traction use.
    pub fn with_traction(contact_at_actual_angle: bool, ring_centre: RingCentre) -> Self {
        Self {
            contact_at_actual_angle,
            ring_centre: Some(ring_centre),
            race_control: None,
            centrifugal_at_free_pitch: None,
        }
    }
}

/// The axis about which a displaced ring turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum RingCentre {
    /// Its own centre, displaced with it: as a ring on a shaft does.
    Displaced,
    /// The inertial axis: as in equations without the displacement in the surface velocity.
    Inertial,
}

/// The race that carries the gyroscopic moment in the Jones–Harris model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum RaceControl {
    /// Outer raceway control for every ball.
    Outer,
    /// Inner raceway control for every ball.
    Inner,
    /// Per ball, by Harris's criterion on the spin-resisting moments of the two contacts.
    Criterion,
}
