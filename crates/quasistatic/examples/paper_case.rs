//! Equilibrium of the paper's bearing (case 1, silver coating): cage speed and peak pressure of each ball.

use std::{error::Error, fs};
use tribodyn_case::Case;
use tribodyn_quasistatic::{Model, solve};

const CASE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/cases/paper-ag.ron");

fn main() -> Result<(), Box<dyn Error>> {
    let case = Case::from_ron(&fs::read_to_string(CASE)?)?;
    let solution = solve(&case.bearing()?, &case.operating_point(), Model::Traction)?.solution;
    println!("cage speed {:.1} r/min", solution.cage_speed_rpm);
    for ball in &solution.balls {
        let [inner, outer] = [ball.contacts.inner.peak_pressure_pa, ball.contacts.outer.peak_pressure_pa]
            .map(|pressure| pressure * 1e-9);
        println!("{:>5.1} deg: inner {inner:.3} GPa, outer {outer:.3} GPa", ball.azimuth_rad.to_degrees());
    }
    Ok(())
}
