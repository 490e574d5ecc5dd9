//! Forces of gears, belts and couplings on the nodes of a shaft.
//!
//! ```text
//! gear at (r cos φ, r sin φ), torque T about +z:   F_t = T/r,  F_r = |F_t| tan α_n/cos β inwards,  F_z = −F_t tan β
//! ```
//! β > 0 is a right-hand helix, whose teeth run along e_z cos β + e_t sin β; without friction the force stands square
//! to them.

use tribodyn_case::LoadSpec;
use tribodyn_shaft::Vector;

/// Force and moment on the shaft at the load's place, and its torque about +z, N m.
pub(super) fn force(load: &LoadSpec) -> (Vector, f64) {
    match *load {
        LoadSpec::Force { x, y, z, .. } => ([x, y, z, 0.0, 0.0], 0.0),
        LoadSpec::Moment { x, y, .. } => ([0.0, 0.0, 0.0, x, y], 0.0),
        LoadSpec::Torque { torque, .. } => ([0.0; 5], torque),
        LoadSpec::Belt { pull, direction, torque, .. } => {
            let (sin, cos) = direction.sin_cos();
            ([pull * cos, pull * sin, 0.0, 0.0, 0.0], torque)
        }
        LoadSpec::Gear { pitch_diameter, torque, pressure_angle, helix_angle, contact, .. } => {
            let radius = 0.5 * pitch_diameter;
            let tangential = torque / radius;
            let radial = -tangential.abs() * pressure_angle.tan() / helix_angle.cos();
            let axial = -tangential * helix_angle.tan();
            let (sin, cos) = contact.sin_cos();
            let (x, y) = (radial * cos - tangential * sin, radial * sin + tangential * cos);
            ([x, y, axial, radius * sin * axial, -radius * cos * axial], torque)
        }
        // It turns with the shaft: no part of the equilibrium.
        LoadSpec::Unbalance { .. } => ([0.0; 5], 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::force;
    use tribodyn_case::LoadSpec;

    /// Force times lever is the torque, and a gear of a right-hand helix that drives (the mesh holds it back) is pushed
    /// where the thumb of the right hand points.
    #[test]
    fn identity_forces_of_a_gear_have_its_torque() {
        for contact in [0.0, 1.0, 2.5, -0.7] {
            let gear = LoadSpec::Gear {
                at: 0.1,
                pitch_diameter: 0.08,
                torque: -30.0,
                pressure_angle: 20f64.to_radians(),
                helix_angle: 15f64.to_radians(),
                contact,
            };
            let ([x, y, z, mx, my], torque) = force(&gear);
            let (rx, ry) = (0.04 * contact.cos(), 0.04 * contact.sin());
            assert!((rx * y - ry * x - torque).abs() < 1e-12);
            assert!((ry * z - mx).abs() < 1e-12 && (-rx * z - my).abs() < 1e-12);
            assert!(z > 0.0 && (z - 750.0 * 15f64.to_radians().tan()).abs() < 1e-9);
            // Inwards.
            assert!(x * rx + y * ry < 0.0);
        }
    }
}
