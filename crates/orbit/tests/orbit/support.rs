//! Bearings to try.

use tribodyn_bearing::{Bearing, CageBody, Guidance, OperatingPoint, Pocket};
use tribodyn_case::Case;
use tribodyn_fluid::AnnulusDrag;

/// A case file of `fixtures` with its bearing, operating point and cage.
pub fn fixture(name: &str) -> (Case, Bearing, OperatingPoint, CageBody) {
    let path = format!("{}/../../fixtures/cases/{name}.ron", env!("CARGO_MANIFEST_DIR"));
    let case = Case::from_ron(&std::fs::read_to_string(path).unwrap()).unwrap();
    let bearing = case.bearing().unwrap();
    let point = case.operating_point();
    let cage = cage_body(&case, &bearing);
    (case, bearing, point, cage)
}

/// The cage of a case.
pub fn cage_body(case: &Case, bearing: &Bearing) -> CageBody {
    let (c, radius) = (&case.cage, 0.5 * bearing.geometry.pitch_diameter);
    let pocket = Pocket {
        radius,
        clearance: c.pocket_gap / radius,
        stiffness: c.pocket_stiffness,
        damping: c.pocket_damping,
        friction: c.pocket_friction,
        ball_radius: bearing.geometry.ball_radius(),
    };
    let guidance = c.guidance.and_then(|g| {
        let f = bearing.fluid?;
        let (radius, width, gap) = (g.radius, g.width, g.gap);
        let land = AnnulusDrag { density: f.density, viscosity: f.viscosity, radius, width, gap };
        Some(Guidance { land, side: g.land })
    });
    CageBody { pocket, inertia: c.inertia.unwrap_or(0.0), drag_torque: c.drag_torque, guidance }
}
