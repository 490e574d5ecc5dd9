//! Balls on the side of their groove that has no shoulder, or of which the case does not say.

use super::estimate::case_loads;
use super::implausible::Implausible;
use super::shown;
use crate::rating::rated_bearing;
use tribodyn_bearing::{Bearing, OperatingPoint, Side, WrongSide, uncarried_thrust, wrong_sides};
use tribodyn_case::Case;
use tribodyn_quasistatic::{QuasiStaticError, Solution};

/// Balls that are named one by one.
const NAMED: usize = 3;

/// Findings on the sides on which balls bear.
#[derive(Default)]
pub(super) struct SideFindings {
    /// Balls where no shoulder is.
    pub implausible: Option<(Implausible, String)>,
    /// Balls of which the case does not say whether there is one.
    pub open: Option<String>,
}

/// Of a case before it is solved: an axial load that its shoulders do not carry.
pub(super) fn of_point(bearing: &Bearing, point: &OperatingPoint) -> Option<String> {
    uncarried_thrust(&bearing.geometry, point).map(|axial_n| QuasiStaticError::NoShoulder { axial_n }.to_string())
}

/// Of a case without an equilibrium: thrust that is too little for the radial load. Where the loaded balls bear at the
/// nominal angle α the radial load F_r pushes the rings apart with F_r tan α (Sjövall's integrals, one ball loaded).
pub fn little_thrust(case: &Case) -> Option<String> {
    let angle = rated_bearing(case).contact_angle;
    let [radial, axial] = case_loads(case)?;
    let needed = radial * angle.tan();
    (axial < needed).then(|| {
        format!(
            "the axial load of {} N is too little for the radial load of {} N, and no equilibrium was found: \
             balls at {}° push the rings apart with about {} N (F_r tan α); give the bearing at \
             least as much axial load, or a preload",
            shown(axial),
            shown(radial),
            shown(angle.to_degrees()),
            shown(needed)
        )
    })
}

/// Of a solution.
pub(super) fn of_solution(bearing: &Bearing, solution: &Solution) -> SideFindings {
    let wrong = wrong_sides(&bearing.geometry, &solution.balls);
    let (known, open): (Vec<WrongSide>, Vec<WrongSide>) = wrong.into_iter().partition(|wrong| wrong.known);
    let implausible = (!known.is_empty()).then(|| {
        let sentence = format!(
            "balls bear on a side of their groove that has no shoulder (`geometry.shoulders`): {}; a positive `ring.z` presses them on the other side",
            named(solution, &known)
        );
        (Implausible::ContactAngle, sentence)
    });
    let open = (!open.is_empty()).then(|| {
        format!(
            "balls bear on the side of negative contact angles, and the case does not say whether their grooves have a shoulder there (`geometry.shoulders`): {}; a positive `ring.z` presses them on the other side",
            named(solution, &open)
        )
    });
    SideFindings { implausible, open }
}

/// The balls with the largest loads.
fn named(solution: &Solution, wrong: &[WrongSide]) -> String {
    let mut wrong: Vec<&WrongSide> = wrong.iter().collect();
    wrong.sort_by(|a, b| b.load_n.total_cmp(&a.load_n));
    let race = |side| if side == Side::Inner { "inner" } else { "outer" };
    let one = |wrong: &&WrongSide| {
        format!(
            "{}° at the {} race, ball at {:.1}°",
            shown(wrong.angle_rad.to_degrees()),
            race(wrong.side),
            solution.balls[wrong.ball].azimuth_rad.to_degrees()
        )
    };
    let names = wrong.iter().take(NAMED).map(one).collect::<Vec<_>>().join("; ");
    let more = wrong.len().saturating_sub(NAMED);
    if more == 0 { names } else { format!("{names}; and {more} more") }
}
