//! Modelling choices: where the equations can be read in more than one way, and a calculation has to say how.

use serde::{Deserialize, Serialize};

/// The modelling choices of a calculation, each under its name in case files. None has a default: a choice that a model
/// uses must be made, one that it does not use may be left out.
///
/// A further choice is a field here with an enumeration of its readings, and a line in [`Self::open`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Modelling {
    /// True if contact constants follow the actual contact angle, false if they stay those of the free one. For all
    /// models.
    pub contact_at_actual_angle: bool,
    /// The axis about which a displaced ring turns. For models with traction.
    #[serde(default)]
    pub ring_centre: Option<RingCentre>,
    /// The race that controls a ball. For Jones–Harris.
    #[serde(default)]
    pub race_control: Option<RaceControl>,
    /// True if the centrifugal force is taken at the undeformed pitch radius, false if at the actual orbit. For
    /// Jones–Harris.
    #[serde(default)]
    pub centrifugal_at_free_pitch: Option<bool>,
}

/// Models by the modelling choices that they use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Equations {
    /// Jones–Harris with raceway control.
    JonesHarris,
    /// Balances with traction, in equilibrium or in motion.
    Traction,
}

/// A choice that a model uses and that is not made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OpenChoice {
    /// Its path in a case.
    pub path: &'static str,
    /// Its readings.
    pub readings: &'static str,
}

impl Modelling {
    /// The choices that a model uses and that are not made.
    pub fn open(&self, equations: Equations) -> Vec<OpenChoice> {
        use Equations::{JonesHarris, Traction};
        let (centre, control, pitch) = (self.ring_centre, self.race_control, self.centrifugal_at_free_pitch);
        let choices = [
            (Traction, centre.is_some(), "modelling.ring_centre", "Displaced or Inertial"),
            (JonesHarris, control.is_some(), "modelling.race_control", "Outer, Inner or Criterion"),
            (JonesHarris, pitch.is_some(), "modelling.centrifugal_at_free_pitch", "true or false"),
        ];
        let open = choices.into_iter().filter(|(of, made, ..)| *of == equations && !made);
        open.map(|(_, _, path, readings)| OpenChoice { path, readings }).collect()
    }

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
