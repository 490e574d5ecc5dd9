//! Answers to single questions about a case or a contact: what the command prints and other programs call.

mod contact;
mod curve;
mod derived;
mod equilibrium;
mod film;
mod findings;
mod fits;
mod flow;
mod friction;
mod heat;
mod limited;
mod lubrication;
#[cfg(feature = "modes")]
mod modes;
mod orbit;
mod pair;
mod question;
mod rated;
mod sensitivity;
mod stiffness;
mod torque;
mod unsaid;

pub use contact::{HertzAnswer, HertzQuestion, LineAnswer, hertz, hertz_line};
pub use curve::{CurveAnswer, traction_curve};
pub use derived::{Derived, GrowthAnswer, derived};
pub use equilibrium::{Equilibrium, Lives, equilibrium, solved};
pub use film::{ContactFilm, ContactFilmQuestion, FilmAnswer, OilAnswer, contact_film, films};
pub use findings::{Answer, Beside, Findings};
pub use fits::{Fits, SeatFit, fits};
pub use flow::{HeatedFlowAnswer, heated_flow};
pub use heat::{HeatAnswer, Surroundings, heat};
pub use lubrication::check_lubricant;
#[cfg(feature = "modes")]
pub use modes::{ModesAnswer, modes};
pub use orbit::{OrbitAnswer, OrbitProblem};
pub use pair::{PairSetting, pair};
pub use question::Question;
pub use rated::rated;
pub use sensitivity::Sensitivity;
pub use stiffness::{StiffnessAnswer, stiffness};
pub(crate) use torque::by_formulas;
pub use torque::{TorqueAnswer, torque};

use crate::error::AnswerError;
use serde::{Serialize, Serializer};
use tribodyn_case::{Case, Purpose};
use tribodyn_quasistatic::Model;

/// Equations of an operating point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Equations {
    /// Raceway control, no traction.
    JonesHarris,
    /// Traction integrals of both contacts.
    Traction,
    /// The periodic motion of balls and cage that a run settles to.
    SteadyOrbit,
}

impl Equations {
    /// All of them, with the names that they go by.
    pub const ALL: [(&'static str, Self); 3] = [
        (Model::JonesHarris.name(), Self::JonesHarris),
        (Model::Traction.name(), Self::Traction),
        ("steady-orbit", Self::SteadyOrbit),
    ];

    /// By name.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for any other name.
    pub fn parse(name: &str) -> Result<Self, AnswerError> {
        let found = Self::ALL.iter().find(|(known, _)| *known == name);
        found.map(|(_, equations)| *equations).ok_or_else(|| {
            let allowed = Self::ALL.map(|(known, _)| known).join(", ");
            AnswerError::argument("model", name, format!("allowed are {allowed}"))
        })
    }

    /// The name that [`Self::parse`] reads.
    pub fn name(self) -> &'static str {
        match self {
            Self::JonesHarris => Self::ALL[0].0,
            Self::Traction => Self::ALL[1].0,
            Self::SteadyOrbit => Self::ALL[2].0,
        }
    }

    /// Those of an answer for which nobody chose any: the steady orbit; in oil with dry pockets, where orbits take
    /// minutes, the equilibrium with traction; raceway control where the case has not what traction needs.
    pub fn usual(case: &Case) -> Self {
        let dry_pockets = case.cage.as_ref().is_none_or(|cage| cage.pocket_film.is_none());
        match case.require(Purpose::Traction) {
            Ok(()) if case.lubricant.is_some() && dry_pockets => Self::Traction,
            Ok(()) => Self::SteadyOrbit,
            Err(_) => Self::JonesHarris,
        }
    }

    /// The use of a case that it asks for.
    pub fn purpose(self) -> Purpose {
        match self {
            Self::JonesHarris => Purpose::JonesHarris,
            Self::Traction | Self::SteadyOrbit => Purpose::Traction,
        }
    }

    /// The equations of an equilibrium; none for the steady orbit.
    pub fn equilibrium(self) -> Option<Model> {
        match self {
            Self::JonesHarris => Some(Model::JonesHarris),
            Self::Traction => Some(Model::Traction),
            Self::SteadyOrbit => None,
        }
    }
}

impl From<Model> for Equations {
    fn from(model: Model) -> Self {
        match model {
            Model::JonesHarris => Self::JonesHarris,
            Model::Traction => Self::Traction,
        }
    }
}

/// Under its name.
impl Serialize for Equations {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}
