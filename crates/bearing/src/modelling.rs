//! Modelling choices: where the equations can be read in more than one way, and a calculation has to say how.

use crate::races::Races;
use serde::{Deserialize, Serialize};

/// The modelling choices of a calculation, each under its name in case files.
///
/// Of the first four none has a default: a choice that a model uses must be made, one that it does not use may be left
/// out. The others are departures from equations that hold where nothing is said: from the whole of Euler's equations,
/// from rigid surfaces, from the undeformed ball, from a pocket force that starts at the wall.
///
/// A further choice is a field here with an enumeration of its readings, and a line in [`Self::open`] where it must be
/// made.
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
    /// Friction that holds the gyroscopic moment in Jones–Harris; by the controlling race where left out.
    #[serde(default)]
    pub gyroscopic_friction: Option<GyroscopicFriction>,
    /// The gyroscopic moment in the balances with traction; whole where left out.
    #[serde(default)]
    pub gyroscopic_moment: Option<GyroscopicMoment>,
    /// The radius at which a ball rolls, for models with traction; undeformed where left out.
    #[serde(default)]
    pub rolling_radius: Option<RollingRadius>,
    /// Behaviour of the surfaces under a patch in shear, for models with traction; rigid where left out.
    #[serde(default)]
    pub patch: Option<PatchSurfaces>,
    /// Where the force of a cage pocket starts; at the wall where left out.
    #[serde(default)]
    pub pocket_force: Option<PocketForce>,
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
            gyroscopic_friction: None,
            gyroscopic_moment: None,
            rolling_radius: None,
            patch: None,
            pocket_force: None,
        }
    }

    /// Shares λ of the gyroscopic moment that friction at inner and outer race holds in Jones–Harris, by whether the
    /// inner race controls: the force is λ M_g/D.
    pub fn gyroscopic_shares(&self, inner_control: bool) -> Races<f64> {
        let controlling = |share: f64| {
            if inner_control { Races { inner: share, outer: 0.0 } } else { Races { inner: 0.0, outer: share } }
        };
        match self.gyroscopic_friction.unwrap_or(GyroscopicFriction::Controlling) {
            GyroscopicFriction::Controlling => controlling(2.0),
            GyroscopicFriction::ControllingAsPrinted => controlling(-2.0),
            GyroscopicFriction::Shared => Races { inner: 1.0, outer: 1.0 },
            GyroscopicFriction::Absent => Races { inner: 0.0, outer: 0.0 },
        }
    }

    /// True unless the gyroscopic moment is left out of the balances with traction.
    pub fn has_gyroscopic_moment(&self) -> bool {
        self.gyroscopic_moment != Some(GyroscopicMoment::Absent)
    }
}

/// Friction that holds the gyroscopic moment M_g of a ball in Jones–Harris, at a race λ M_g/D across the groove.
///
/// Source: T. A. Harris, Rolling Bearing Analysis, high-speed chapter: λ = 2 at the controlling race, or 1 at either.
/// Harris prints M_g with a negative ω_R; programs that take its magnitude with his signs push the ball the other way.
/// Lubricants 2025, 13(8), 352 calls its quasi-static model "unable to consider the traction effect" and does not say
/// which of these it has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum GyroscopicFriction {
    /// All at the race that controls: λ = 2 there, 0 at the other.
    Controlling,
    /// Half at either race: λ = 1.
    Shared,
    /// Nothing holds it: λ = 0.
    Absent,
    /// All at the race that controls, with the sign that follows from the printed equations and M_g > 0: λ = −2.
    ControllingAsPrinted,
}

/// The gyroscopic moment J ω_m e_a × Ω in the balances with traction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum GyroscopicMoment {
    /// Whole, as Euler's equations in the turning frame have it.
    Full,
    /// Left out: the angular momentum of a ball does not turn with its azimuth. A reading of equations, not mechanics:
    /// angular momentum is lost, energy is not.
    Absent,
}

/// The radius at which a ball rolls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum RollingRadius {
    /// That of the undeformed ball.
    Undeformed,
    /// Less the ball's own part of the elastic approach: the middle of the patch stands that much nearer its centre.
    /// Source: K. L. Johnson, Contact Mechanics, chapter 4 (the approach as a sum over both bodies, in proportion to
    /// (1 − ν²)/E).
    Deformed,
}

/// Behaviour of the surfaces under a patch in shear.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum PatchSurfaces {
    /// They give way normally only, as in Lubricants 2025, 13(8), 352: the traction of a point follows from the slip of
    /// the rigid bodies there.
    Rigid,
    /// They give way along the patch too: Kalker's simplified theory with the traction curve at the true slip, on
    /// strips with `cells` each, `strips` for either line of pure rolling ([`tribodyn_traction::FastsimRule`]).
    Elastic {
        /// Strips across the groove for each of the two lines of pure rolling: twice as many altogether.
        strips: usize,
        /// Cells along a strip.
        cells: usize,
    },
}

/// Where the force of a cage pocket starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum PocketForce {
    /// At the wall: K r_p (|Δθ| − θ_cl) beyond the clearance θ_cl.
    FromWall,
    /// At the middle of the pocket, as Lubricants 2025, 13(8), 352 prints it: K r_p Δθ beyond the clearance, which
    /// jumps at the wall.
    AsPrinted,
}

/// The axis about which a displaced ring turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum RingCentre {
    /// Its own centre, displaced with it: as a ring on a shaft does.
    Displaced,
    /// The inertial axis: as in equations without the displacement in the surface velocity.
    Inertial,
}

/// The race on which a ball does not spin in the Jones–Harris model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum RaceControl {
    /// Outer raceway control for every ball.
    Outer,
    /// Inner raceway control for every ball.
    Inner,
    /// Per ball, by Harris's criterion on the spin-resisting moments of the two contacts.
    Criterion,
}
