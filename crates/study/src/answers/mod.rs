//! Answers to single questions about a case or a contact: what the command prints and other programs call.

mod contact;
mod curve;
mod derived;
mod equilibrium;
mod modes;
mod orbit;
mod stiffness;

pub use contact::{HertzAnswer, HertzQuestion, hertz};
pub use curve::{CurveAnswer, traction_curve};
pub use derived::{Derived, GrowthAnswer, derived};
pub use equilibrium::{Equilibrium, Lives, equilibrium, solved};
pub use modes::{ModesAnswer, modes};
pub use orbit::{OrbitAnswer, OrbitProblem};
pub use stiffness::{StiffnessAnswer, stiffness};

use crate::case_file::CaseFile;
use crate::error::StudyError;
use crate::rating::{Rating, rating};
use tribodyn_case::Purpose;
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
    /// [`StudyError::Argument`] for any other name.
    pub fn parse(name: &str) -> Result<Self, StudyError> {
        let found = Self::ALL.iter().find(|(known, _)| *known == name);
        found.map(|(_, equations)| *equations).ok_or_else(|| {
            let allowed = Self::ALL.map(|(known, _)| known).join(", ");
            StudyError::argument("model", name, format!("allowed are {allowed}"))
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

    /// The use of a case that it asks for.
    pub(crate) fn purpose(self) -> Purpose {
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

/// Rating life and static safety under the loads that some equations give.
///
/// # Errors
/// A case that these equations do not solve, or a bearing that the standards do not rate.
pub fn rated(file: &CaseFile, equations: Equations) -> Result<Rating, StudyError> {
    let solution = match equations.equilibrium() {
        Some(model) => solved(file, model)?.1.solution,
        None => OrbitAnswer::of(file)?.solution,
    };
    let refused = |source| StudyError::Rating { file: file.name.clone(), source };
    rating(&file.case, &solution).map_err(refused)
}
