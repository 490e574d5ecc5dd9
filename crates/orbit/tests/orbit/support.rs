//! Bearings to try.

use tribodyn_bearing::{Bearing, CageBody, OperatingPoint, Supports};
use tribodyn_case::{Case, set_value};

/// A case file of `fixtures` with its bearing, operating point and cage.
pub fn fixture(name: &str) -> (Supports, Bearing, OperatingPoint, CageBody) {
    let path = format!("{}/../../fixtures/cases/{name}.ron", env!("CARGO_MANIFEST_DIR"));
    let case = Case::from_ron(&std::fs::read_to_string(path).unwrap()).unwrap();
    let inputs = case.run_inputs().unwrap();
    let cage = CageBody::new(&inputs.cage, &inputs.bearing);
    (inputs.supports, inputs.bearing, case.operating_point(), cage)
}

/// The same with values changed, with the damping of its runs where it has any.
pub fn fixture_with(name: &str, changes: &[(&str, &str)]) -> (Bearing, OperatingPoint, CageBody) {
    let path = format!("{}/../../fixtures/cases/{name}.ron", env!("CARGO_MANIFEST_DIR"));
    let mut text = std::fs::read_to_string(path).unwrap();
    for (path, value) in changes {
        text = set_value(&text, path, value).unwrap();
    }
    case_of(&text)
}

/// Bearing, operating point and cage of a case, with the damping of its runs where it has any.
pub fn case_of(text: &str) -> (Bearing, OperatingPoint, CageBody) {
    let case = Case::from_ron(text).unwrap();
    let mut bearing = case.bearing().unwrap();
    bearing.contact_damping = case.transient.as_ref().map_or(0.0, |transient| transient.contact_damping);
    let cage = CageBody::new(&case.moving_cage().unwrap(), &bearing);
    (bearing, case.operating_point(), cage)
}
