//! Parts of a case that each model needs: sections by the table here, modelling choices by that of
//! [`tribodyn_bearing::Modelling`].

use crate::Case;
use std::fmt;
use tribodyn_bearing::Equations;

/// A model that a case is used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// Equilibrium by Jones–Harris.
    JonesHarris,
    /// Equilibrium with traction.
    Traction,
    /// A transient run.
    Transient,
}

impl fmt::Display for Purpose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::JonesHarris => "the Jones–Harris model",
            Self::Traction => "the traction model",
            Self::Transient => "a transient run",
        })
    }
}

/// A part of a case that some models need.
struct Part {
    path: &'static str,
    /// Its required contents.
    holds: &'static str,
    needed_by: &'static [Purpose],
    present: fn(&Case) -> bool,
}

const WITH_TRACTION: &[Purpose] = &[Purpose::Traction, Purpose::Transient];

const PARTS: &[Part] = &[
    Part {
        path: "coatings",
        holds: "inner and outer, each with curve and thickness; or a `lubricant` in their place",
        needed_by: WITH_TRACTION,
        present: |case| case.coatings.is_some() || case.lubricant.is_some(),
    },
    Part {
        path: "traction",
        holds: "slip_unit, order, varying, reference_pressure, differential_slip, pressure, patch",
        needed_by: WITH_TRACTION,
        present: |case| case.traction.is_some() || case.lubricant.is_some(),
    },
    Part {
        path: "cage",
        holds: "pocket_gap, pocket_stiffness, pocket_friction, drag_torque; for a transient run inertia",
        needed_by: WITH_TRACTION,
        present: |case| case.cage.is_some(),
    },
    Part {
        path: "cage.inertia",
        holds: "a moment of inertia about the bearing's axis, such as kg_m2(0.002)",
        needed_by: &[Purpose::Transient],
        present: |case| case.cage.as_ref().is_none_or(|cage| cage.inertia.is_some()),
    },
    Part {
        path: "wear",
        holds: "inner, outer and cage, each with coefficient and hardness",
        needed_by: WITH_TRACTION,
        present: |case| case.wear.is_some(),
    },
    Part {
        path: "supports",
        holds: "inner and outer, each with mass, stiffness and damping",
        needed_by: &[Purpose::Transient],
        present: |case| case.supports.is_some(),
    },
    Part {
        path: "transient",
        holds: "duration, start, scheme, contact_damping, wear_acceleration",
        needed_by: &[Purpose::Transient],
        present: |case| case.transient.is_some(),
    },
];

/// Parts of a case that a model needs and that are not there.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{purpose} needs what the case does not have: {}", self.list())]
pub struct Lacking {
    /// The model.
    pub purpose: Purpose,
    /// Paths of all that is missing, each with what it must hold.
    pub missing: Vec<(&'static str, &'static str)>,
}

impl Lacking {
    fn list(&self) -> String {
        let one = |(path, holds): &(&str, &str)| format!("`{path}` ({holds})");
        self.missing.iter().map(one).collect::<Vec<_>>().join(", ")
    }
}

impl Case {
    /// Checks that the case has what a model needs.
    ///
    /// # Errors
    /// [`Lacking`] with all that is missing.
    pub fn require(&self, purpose: Purpose) -> Result<(), Lacking> {
        let lacking = self.lacking(purpose);
        if lacking.missing.is_empty() { Ok(()) } else { Err(lacking) }
    }

    pub(crate) fn lacking(&self, purpose: Purpose) -> Lacking {
        let parts = PARTS.iter().filter(|part| part.needed_by.contains(&purpose) && !(part.present)(self));
        let equations = match purpose {
            Purpose::JonesHarris => Equations::JonesHarris,
            Purpose::Traction | Purpose::Transient => Equations::Traction,
        };
        let choices = self.modelling.open(equations).into_iter().map(|choice| (choice.path, choice.readings));
        Lacking { purpose, missing: parts.map(|part| (part.path, part.holds)).chain(choices).collect() }
    }
}
