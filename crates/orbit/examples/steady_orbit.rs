//! The steady orbit of a bearing whose balls lose their inner contact over a part of it: cage speed and pocket force.

use std::{error::Error, fs};
use tribodyn_bearing::CageBody;
use tribodyn_case::Case;
use tribodyn_orbit::{OrbitSettings, steady_orbit};

fn main() -> Result<(), Box<dyn Error>> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/cases/angular-7210.ron");
    let case = Case::from_ron(&fs::read_to_string(path)?)?;
    let inputs = case.run_inputs()?;
    let cage = CageBody::new(&inputs.cage, &inputs.bearing);
    let orbit = steady_orbit(&inputs.bearing, &case.operating_point(), &cage, &OrbitSettings::default())?.solution;
    println!("cage {:.1} r/min, {:.0} W of friction", orbit.cage_speed_rpm, orbit.friction_w.iter().sum::<f64>());
    println!("pocket {:.0} N, met at {:.0?} degrees", orbit.pocket_force_max_n, orbit.pocket_contact_azimuths_deg);
    Ok(())
}
