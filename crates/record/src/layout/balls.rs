//! Panels of balls: over azimuth, one ball over time, states.

use super::panels::{Panel, over_array, over_time, states};

const AZIMUTH: (&str, &str) = ("/bearing/azimuth.azimuth_deg[:]", "azimuth from X towards Y [°]");

/// A quantity of both contacts of all balls over azimuth.
fn both(name: &str, quantity: (&str, &str), inner: &str, outer: &str) -> Panel {
    let paths = [inner, outer].map(|field| format!("/bearing/azimuth.{field}[:]"));
    over_array(name, quantity, AZIMUTH, &[(&paths[0], "inner"), (&paths[1], "outer")]).up_to(360.0)
}

pub(super) fn load() -> Panel {
    both("azimuth_load", ("Contact load over azimuth", "N"), "load_inner_n", "load_outer_n")
}

pub(super) fn pressure() -> Panel {
    let quantity = ("Peak pressure over azimuth", "GPa");
    both("azimuth_pressure", quantity, "peak_pressure_inner_gpa", "peak_pressure_outer_gpa")
}

pub(super) fn contact_angle() -> Panel {
    let quantity = ("Contact angle over azimuth", "°");
    both("azimuth_angle", quantity, "contact_angle_inner_deg", "contact_angle_outer_deg")
}

pub(super) fn slide() -> Panel {
    let quantity = ("Slide-to-roll ratio over azimuth", "%");
    both("azimuth_slide", quantity, "slide_to_roll_inner_percent", "slide_to_roll_outer_percent")
}

pub(super) fn speed() -> Panel {
    let curve = [("/bearing/azimuth.orbital_speed_rpm[:]", "orbital speed")];
    over_array("azimuth_speed", ("Orbital speed over azimuth", "r/min"), AZIMUTH, &curve).up_to(360.0)
}

pub(super) fn one_ball() -> Panel {
    let curves = [("/bearing/balls.balls[0].load_inner_n", "inner"), ("/bearing/balls.balls[0].load_outer_n", "outer")];
    over_time("ball_load", "Contact load of ball 0", "N", &curves)
}

/// Pocket forces of three balls a third of the circle apart.
pub(super) fn pocket(ball_count: usize) -> Panel {
    let mut chosen = [0, ball_count / 3, 2 * ball_count / 3].to_vec();
    chosen.dedup();
    let texts: Vec<[String; 2]> = chosen
        .into_iter()
        .map(|ball| [format!("/bearing/balls.balls[{ball}].pocket_force_n"), format!("ball {ball}")])
        .collect();
    let curves: Vec<(&str, &str)> = texts.iter().map(|[path, label]| (path.as_str(), label.as_str())).collect();
    over_time("pocket", "Pocket force on the ball along its orbit", "N", &curves)
}

fn states_of(ball_count: usize, field: &str) -> Vec<(String, String)> {
    (0..ball_count).map(|ball| (format!("/bearing/balls.balls[{ball}].{field}"), format!("ball {ball}"))).collect()
}

pub(super) fn motion(ball_count: usize) -> Panel {
    states("motion", "Rolling, skidding, contact lost", &states_of(ball_count, "motion"))
}

pub(super) fn pocket_contact(ball_count: usize) -> Panel {
    states("pockets", "Contact with the pocket", &states_of(ball_count, "pocket"))
}
