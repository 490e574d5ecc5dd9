//! The orbit with the damping that a case gives its pockets: a search needs more, so that balls do not bounce on, and
//! the answer says what that changes.

use crate::collocation::Orbit;
use crate::homotopy::said;
use crate::newton::Newton;
use crate::residual::{Found, shaft_torque};
use crate::search::{HASTE, PATIENCE, damped};
use crate::system::LEAD;
use crate::{OrbitError, OrbitSettings};
use serde::Serialize;
use std::f64::consts::TAU;

/// r/min per rad/s.
pub(crate) const RPM_PER_RAD_S: f64 = 60.0 / TAU;
/// Factor of the damping from orbit to orbit, at first and at least as near to 1 as is tried: where none is found half
/// the way on the logarithmic scale is tried.
const LOWER: f64 = 0.316;
const SMALL: f64 = 0.87;
/// Attempts at an orbit with less damping.
const ATTEMPTS: usize = 14;
/// Changes of cage speed, torque and pocket force, over their size, that are worth a sentence.
const CHANGES: [f64; 3] = [1e-4, 1e-3, 1e-2];
/// Largest multiplier of an orbit that a ball keeps to.
pub(crate) const KEEPS: f64 = 1.01;
/// Looks at an interval for its largest pocket force.
const LOOKS: usize = 8;

/// An orbit with less damping in its pockets than the one it stands beside.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LessDamping {
    /// Damping of the pockets of the orbit that it stands beside, χ of Hunt and Crossley, s/m.
    pub raised_s_per_m: f64,
    /// That of the case, s/m.
    pub given_s_per_m: f64,
    /// That of this orbit, s/m: the case's, or the lowest at which an orbit was found.
    pub damping_s_per_m: f64,
    /// Cage speed, r/min.
    pub cage_speed_rpm: f64,
    /// Mean torque that the shaft needs, N m.
    pub shaft_torque_nm: f64,
    /// Largest pocket force of either direction, N.
    pub pocket_force_max_n: f64,
    /// Largest modulus of a Floquet multiplier of a ball over a turn, cage and ring held.
    pub multiplier: f64,
}

impl LessDamping {
    /// True if it has the damping of the case.
    pub fn is_given(&self) -> bool {
        self.damping_s_per_m == self.given_s_per_m
    }

    /// Sentence on what the raised damping changes; none where that is next to nothing.
    /// Given are cage speed, r/min, torque, N m, and pocket force, N, with the raised damping.
    pub(crate) fn sentence(&self, with_raised: [f64; 3]) -> Option<String> {
        let own = [self.cage_speed_rpm, self.shaft_torque_nm, self.pocket_force_max_n];
        let pairs: [(f64, f64); 3] = std::array::from_fn(|k| (with_raised[k], own[k]));
        let moved = pairs.iter().zip(CHANGES).any(|((a, b), least)| (a - b).abs() > least * b.abs());
        if !moved && self.is_given() && self.multiplier <= KEEPS {
            return None;
        }
        let [_, (torque, less_torque), (force, less_force)] = pairs.map(|(a, b)| (said(a, 4), said(b, 4)));
        let with = if self.is_given() {
            "with the damping of the case".to_owned()
        } else {
            format!("with {} s/m, the least at which an orbit was found,", said(self.damping_s_per_m, 4))
        };
        let stays =
            if self.multiplier <= KEEPS { "" } else { "; that orbit is unstable, so that a run swings about it" };
        Some(format!(
            "{} so that balls stop bouncing: {with} the cage turns at {:.2} instead of {:.2} r/min, the shaft needs \
             {less_torque} instead of {torque} N m, and the largest pocket force is {less_force} instead of {force} \
             N{stays}",
            raised(self.raised_s_per_m, self.given_s_per_m),
            self.cage_speed_rpm,
            with_raised[0],
        ))
    }
}

/// Beginning of a sentence on pockets that are damped more than a case says.
fn raised(damping: f64, given: f64) -> String {
    format!("the pocket damping is raised from {given} to {} s/m", said(damping, 4))
}

/// Sentence on an orbit that could not be followed to less damping.
pub(crate) fn not_followed(damping: f64, given: f64) -> String {
    format!(
        "{} so that balls stop bouncing, and no orbit with less was found: cage speed, torque and pocket force of a \
         run can differ",
        raised(damping, given)
    )
}

/// The orbit with the case's own damping of the pockets, as near to it as one is found; none where no ball touches its
/// pocket, or where they have that damping.
pub(crate) fn less_damped(
    newton: &mut Newton<'_>,
    found: Found,
    (given, settings): (f64, &OrbitSettings),
) -> Result<Option<LessDamping>, OrbitError> {
    let raised = newton.system.cage.pocket.damping;
    if given >= raised || pocket_force_max(newton, &found) == 0.0 {
        return Ok(None);
    }
    let followed = newton.within(2 * HASTE, |newton| followed_down(newton, &found, ([raised, given], settings)));
    let Some((damping, reached)) = followed else { return Ok(None) };
    newton.system.cage.pocket.damping = damping;
    Ok(Some(LessDamping {
        raised_s_per_m: raised,
        given_s_per_m: given,
        damping_s_per_m: damping,
        cage_speed_rpm: reached.0.cage_speed * RPM_PER_RAD_S,
        shaft_torque_nm: shaft_torque(&newton.system, &reached.0, &reached.1.means),
        pocket_force_max_n: pocket_force_max(newton, &reached),
        multiplier: newton.multiplier(&reached.0)?,
    }))
}

/// The orbit with the least damping that it can be followed to, and that damping.
fn followed_down(
    newton: &mut Newton<'_>,
    found: &Found,
    ([raised, given], settings): ([f64; 2], &OrbitSettings),
) -> Option<(f64, Found)> {
    let mut at: Option<(f64, Found)> = None;
    let (mut reached, mut factor) = (raised, LOWER);
    for _ in 0..ATTEMPTS {
        let next = (factor * reached).max(given);
        newton.system.cage.pocket.damping = next;
        let near = at.as_ref().map_or(found, |(_, near)| near).0.clone();
        match nearby(newton, near, settings) {
            Some(less) => {
                at = Some((next, less));
                (reached, factor) = (next, (factor * factor).max(LOWER));
            }
            None => factor = factor.sqrt(),
        }
        if reached <= given || factor > SMALL || newton.is_spent() {
            break;
        }
    }
    at
}

/// An orbit with the damping that the system has now, from one with a little more.
fn nearby(newton: &mut Newton<'_>, near: Orbit, settings: &OrbitSettings) -> Option<Found> {
    let settling = [newton.system.settling / newton.system.pace(near.cage_speed)];
    let goal = (settings.tolerance, PATIENCE);
    let same_mesh = newton.met(near.clone(), goal).map(|met| newton.halved(met, settings.mesh_error, goal));
    same_mesh.or_else(|| damped(newton, &near, settings, (&settling, HASTE / 2)).ok())
}

/// Largest pocket force of either direction, at the points of the mesh and between them, N.
pub(crate) fn pocket_force_max(newton: &Newton<'_>, (orbit, _): &Found) -> f64 {
    let pocket = &newton.system.cage.pocket;
    let touches = |j: usize| {
        let all = orbit.values[j].iter().chain([orbit.begin(j)]);
        all.into_iter().any(|y| pocket.penetration(y[LEAD]) > 0.0)
    };
    let of = |j: usize| {
        let [begin, width] = orbit.interval(j);
        let looks = (1..=LOOKS).map(|look| begin + width * look as f64 / LOOKS as f64);
        let at = |turn: f64| newton.system.in_pocket(&orbit.at(&newton.radau, turn), orbit.cage_speed).force.abs();
        looks.map(at).fold(0.0, f64::max)
    };
    (0..orbit.intervals()).filter(|j| touches(*j)).map(of).fold(0.0, f64::max)
}
