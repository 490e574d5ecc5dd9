//! Bearings to try.

use tribodyn_bearing::{Bearing, CageBody, OperatingPoint, Supports};
use tribodyn_case::Case;

/// A case file of `fixtures` with its bearing, operating point and cage.
pub fn fixture(name: &str) -> (Supports, Bearing, OperatingPoint, CageBody) {
    let path = format!("{}/../../fixtures/cases/{name}.ron", env!("CARGO_MANIFEST_DIR"));
    let case = Case::from_ron(&std::fs::read_to_string(path).unwrap()).unwrap();
    let inputs = case.run_inputs().unwrap();
    let cage = CageBody::new(&inputs.cage, &inputs.bearing);
    (inputs.supports, inputs.bearing, case.operating_point(), cage)
}
