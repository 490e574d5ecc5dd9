//! From nothing to twice the paper's loads and speeds, from the library's own initial guess.

use crate::{PAPER_AG, STRIPS, variant};
use tribodyn_quasistatic::Model::Traction;
use tribodyn_quasistatic::{RingFreedom, solve};

/// Multiples of the paper's axial load. At 0.07 drag is near the most that friction can carry, and balls fall into
/// skidding as the ring moves.
const AXIAL: [f64; 7] = [0.0, 0.02, 0.07, 0.1, 0.3, 1.0, 2.0];
/// Multiples of its radial load.
const RADIAL: [f64; 4] = [0.0, 0.3, 1.0, 2.0];
/// Multiples of its speed.
const SPEED: [f64; 5] = [0.0, 0.1, 0.5, 1.0, 2.0];
/// Multiples of a drag of about 200 N per ball at full speed.
const DRAG: [f64; 3] = [0.0, 1.0, 2.0];

#[test]
fn limit_converges_from_nothing_to_twice_the_loads_and_speeds() {
    let mut lost_contact = 0;
    for (varying, differential) in [("true", "true"), ("false", "false")] {
        for [axial, radial, speed, drag] in points() {
            let drag = format!("{}", 0.32 * drag);
            let case = variant(
                PAPER_AG,
                &[
                    STRIPS,
                    ("traction.varying", varying),
                    ("traction.differential_slip", differential),
                    ("fluid.drag_coefficient", &drag),
                ],
            );
            let mut point = case.operating_point();
            point.ring[0] = RingFreedom::Loaded(20e3 * radial);
            point.ring[2] = RingFreedom::Loaded(44e3 * axial);
            point.inner_speed *= speed;
            let name = format!("axial {axial}, radial {radial}, speed {speed}, drag {drag}, varying {varying}");
            let solved = solve(&case.bearing().unwrap(), &point, Traction);
            let s = solved.unwrap_or_else(|e| panic!("{name}: {e}")).solution;
            assert!(s.converged && s.residual <= 1e-10, "{name}: {}", s.residual);
            assert!(s.balls.iter().all(|ball| ball.orbital_speed_rad_s.is_finite()), "{name}");
            let lost = s.balls.iter().filter(|ball| ball.contacts.inner.load_n == 0.0).count();
            let warned = s.warnings.iter().any(|text| text.starts_with("no contact with the inner race"));
            // At rest nothing drives a ball, and one that carries nothing is as it should be.
            assert_eq!(lost > 0 && speed > 0.0, warned, "{name}: {:?}", s.warnings);
            lost_contact += lost;
        }
    }
    assert!(lost_contact > 0, "the range includes balls without inner contact");
}

/// The grid of loads and speeds, the drags in turn.
fn points() -> impl Iterator<Item = [f64; 4]> {
    let count = AXIAL.len() * RADIAL.len() * SPEED.len();
    (0..count).map(|n| {
        let speeds = SPEED.len();
        let (speed, radial) = (SPEED[n % speeds], RADIAL[n / speeds % RADIAL.len()]);
        [AXIAL[n / (speeds * RADIAL.len())], radial, speed, DRAG[n % DRAG.len()]]
    })
}
