//! Requirements of each model on a bearing and an operating point.

use crate::{Model, QuasiStaticError};
use tribodyn_bearing::{Bearing, Equations, OperatingPoint, uncarried_thrust};

/// Checks that everything is there that a model uses.
pub(crate) fn check(bearing: &Bearing, point: &OperatingPoint, model: Model) -> Result<(), QuasiStaticError> {
    let (equations, parts): (_, &[(bool, &'static str)]) = match model {
        Model::JonesHarris => (Equations::JonesHarris, &[]),
        Model::Traction => (
            Equations::Traction,
            &[
                (bearing.tribology.is_some(), "traction and wear of the contacts"),
                (point.patch.is_some(), "a rule for the contact patches"),
                (point.cage.is_some(), "a cage"),
            ],
        ),
    };
    let parts = parts.iter().filter(|(there, _)| !there).map(|(_, name)| *name);
    let choices = bearing.modelling.open(equations).into_iter().map(|choice| choice.path);
    let missing: Vec<&str> = parts.chain(choices).collect();
    if !missing.is_empty() {
        return Err(QuasiStaticError::Missing { model, missing });
    }
    check_thrust(bearing, point)
}

/// Refuses a load that presses the balls where their grooves have no shoulder.
///
/// # Errors
/// [`QuasiStaticError::NoShoulder`].
pub fn check_thrust(bearing: &Bearing, point: &OperatingPoint) -> Result<(), QuasiStaticError> {
    let uncarried = uncarried_thrust(&bearing.geometry, point);
    uncarried.map_or(Ok(()), |axial_n| Err(QuasiStaticError::NoShoulder { axial_n }))
}
