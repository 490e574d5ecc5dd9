//! The steady orbit of an angular-contact bearing 7210 from its designation.

use tribodyn::answers::OrbitAnswer;
use tribodyn::{AnswerError, CaseFile, Limits, NewCase, SearchWatch, find_bearing};

fn main() -> Result<(), AnswerError> {
    let mut new = NewCase::of_listed(find_bearing("7210", Some(40.0))?, "7210");
    (new.radial_load, new.axial_load, new.speed) = (Some(500.0), Some(2000.0), Some(1000.0));
    let file = CaseFile::from_text("7210", new.text()?, &[], &Limits::NORMAL)?;
    let OrbitAnswer { orbit, solution, .. } = OrbitAnswer::of(&file.question(SearchWatch::default()))?;
    println!("cage speed {:.1} r/min, shaft torque {:.4} N m", orbit.cage_speed_rpm, orbit.shaft_torque_nm);
    for ball in &solution.balls {
        let inner = &ball.contacts[tribodyn::Side::Inner];
        println!("{:5.1} N at {:5.2}°", inner.load_n, inner.angle_rad.to_degrees());
    }
    Ok(())
}
