//! What each model needs of a bearing and an operating point.

use crate::{Model, QuasiStaticError};
use tribodyn_bearing::{Bearing, OperatingPoint};

/// Checks that everything is there that a model uses.
pub(crate) fn check(bearing: &Bearing, point: &OperatingPoint, model: Model) -> Result<(), QuasiStaticError> {
    let modelling = &bearing.modelling;
    let parts: &[(bool, &'static str)] = match model {
        Model::JonesHarris => &[
            (modelling.race_control.is_some(), "which race controls"),
            (modelling.centrifugal_at_free_pitch.is_some(), "where the centrifugal force is taken"),
        ],
        Model::Traction => &[
            (bearing.tribology.is_some(), "traction and wear of the contacts"),
            (modelling.ring_centre.is_some(), "the axis about which a displaced ring turns"),
            (point.patch.is_some(), "a rule for the contact patches"),
            (point.cage.is_some(), "a cage"),
        ],
    };
    let missing: Vec<&str> = parts.iter().filter(|(there, _)| !there).map(|(_, name)| *name).collect();
    if missing.is_empty() { Ok(()) } else { Err(QuasiStaticError::Missing { model, missing }) }
}
