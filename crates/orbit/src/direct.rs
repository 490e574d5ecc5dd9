//! An orbit straight from the balls of an equilibrium: Newton's method on all unknowns of a mesh, which is made finer
//! where its intervals err (U. M. Ascher, R. M. M. Mattheij, R. D. Russell, Numerical Solution of Boundary Value
//! Problems, 1995, section 9.3). No ball is sent round, so that motions which grow on the falling part of a traction
//! curve do not carry it away.

use crate::coarse::Coarse;
use crate::collocation::Orbit;
use crate::homotopy::Homotopy;
use crate::newton::Newton;
use crate::residual::Found;
use crate::start::Profile;
use crate::system::{BALL, LEAD, ORBIT, RING};

/// Intervals of the first mesh.
const COARSE: usize = 16;
/// Most intervals of a mesh.
const MOST: usize = 400;
/// Meshes, each made from the errors on the one before.
const MESHES: usize = 7;
/// Error that a new mesh aims at, over what is allowed.
const AIM: f64 = 0.3;
/// Times that intervals of a turn are halved; pocket force that may be too large over its peak or over a slight part of
/// the load, and looks at an interval.
const HALVINGS: usize = 3;
const OF_POCKET: f64 = 0.05;
const SLIGHT: f64 = 1e-3;
const LOOKS: usize = 7;
/// Half a turn, rad, in which an error of the orbital speed becomes one of the lead.
const HALF_TURN: f64 = 3.0;
/// By how much an interval may become shorter and longer from mesh to mesh.
const SHORTER: f64 = 8.0;
const LONGER: f64 = 1.5;

/// Jacobians of an attempt on the homotopy and of all of them, residual that is enough there, and shortest step.
const PATIENCE: usize = 16;
const ROUGH: f64 = 1e-6;
const JACOBIANS: usize = 250;
const LEAST_STEP: f64 = 0.01;

/// How far the homotopy led.
pub(crate) struct Reached {
    pub share: f64,
    pub found: Found,
    /// True if the intervals of its mesh err by no more than is allowed.
    pub refined: bool,
}

/// A mesh of even intervals with the balls of a start on it.
pub(crate) fn even(newton: &Newton<'_>, profile: &Profile, border: (f64, [f64; RING])) -> Orbit {
    let ends: Vec<f64> = (0..=COARSE).map(|j| j as f64 / COARSE as f64).collect();
    Orbit::of(&newton.radau, ends, border, |turn| profile.at(newton.system.azimuth(turn)))
}

impl<'a> Newton<'a> {
    /// Meets the equations on the mesh of an orbit to a tolerance; none where Newton's method does not.
    pub fn met(&mut self, orbit: Orbit, (tolerance, patience): (f64, usize)) -> Option<Found> {
        let found = self.run(orbit, tolerance, patience);
        (found.1.worst.relative <= tolerance).then_some(found)
    }

    /// Follows the orbit from balls that soft springs hold in their pockets, and that are heavy enough to stay on the
    /// outer race, towards those of the bearing: as far as that goes.
    pub fn followed(
        &mut self,
        start: Orbit,
        homotopy: &Homotopy<'a>,
        (allowed, tolerance): (f64, f64),
    ) -> Option<Reached> {
        let mut at: Option<Reached> = None;
        let mut step: f64 = 0.25;
        let most = self.statistics.jacobians + JACOBIANS;
        while self.statistics.jacobians < most {
            let next = at.as_ref().map_or(0.0, |at| (at.share + step).min(1.0));
            homotopy.set(&mut self.system, next);
            let last = next == 1.0;
            let from = at.as_ref().map_or(&start, |at| &at.found.0).clone();
            let goal = (if last { tolerance } else { ROUGH }, PATIENCE);
            let found = self.met(from.clone(), goal).or_else(|| self.closed(from, goal.0));
            let Some(found) = found else {
                step *= 0.4;
                if at.is_none() || step < LEAST_STEP {
                    break;
                }
                continue;
            };
            let fine = self.refined(found.clone(), if last { allowed } else { 4.0 * allowed }, goal);
            let refined = fine.is_some();
            at = Some(Reached { share: next, found: fine.unwrap_or(found), refined });
            if last {
                break;
            }
            step *= 1.5;
        }
        at
    }

    /// Meets them on meshes made finer until intervals err by no more than `allowed`; none where that does not succeed.
    pub fn refined(&mut self, mut found: Found, allowed: f64, (tolerance, patience): (f64, usize)) -> Option<Found> {
        for _ in 0..MESHES {
            let errors = self.errors(&found.0, allowed);
            if errors.iter().all(|error| *error <= 1.0) {
                self.coarse = None;
                return Some(found);
            }
            let finer = self.finer(&found.0, &errors)?;
            found = self.met(finer, (tolerance, patience))?;
        }
        None
    }

    /// The orbit with the intervals halved that err by more than is allowed, the others kept: a mesh that a ball was
    /// sent round on has its steps where contacts begin and end. What is left where that does not succeed is kept in
    /// `coarse`.
    pub fn halved(&mut self, mut found: Found, allowed: f64, (tolerance, patience): (f64, usize)) -> Found {
        self.coarse = None;
        for halvings in 0..=HALVINGS {
            let errors = self.with_pockets(&found.0, allowed);
            let worst = errors.iter().copied().fold(0.0, f64::max);
            if worst <= 1.0 {
                break;
            }
            let finer = self.with_halves(&found.0, &errors);
            let next = (halvings < HALVINGS).then(|| self.met(finer, (tolerance, patience))).flatten();
            let Some(next) = next else {
                let motion = self.errors(&found.0, allowed).into_iter().fold(0.0, f64::max);
                self.coarse = Some(Coarse { motion, pocket: worst });
                break;
            };
            found = next;
        }
        found
    }

    /// Error of each interval over what is allowed, pocket forces included.
    pub fn with_pockets(&mut self, orbit: &Orbit, allowed: f64) -> Vec<f64> {
        let errors = self.closer(orbit, allowed).into_iter().zip(self.pocket_errors(orbit));
        errors.map(|(of_step, of_pocket)| of_step.max(of_pocket)).collect()
    }

    /// An orbit on its mesh with those intervals halved whose errors are above 1.
    fn with_halves(&self, orbit: &Orbit, errors: &[f64]) -> Orbit {
        let halves = errors.iter().zip(orbit.ends.windows(2)).flat_map(|(error, pair)| {
            let middle = (*error > 1.0).then(|| 0.5 * (pair[0] + pair[1]));
            middle.into_iter().chain([pair[1]])
        });
        let ends = [0.0].into_iter().chain(halves).collect();
        Orbit::of(&self.radau, ends, (orbit.cage_speed, orbit.ring), |turn| orbit.at(&self.radau, turn))
    }

    /// Error of each interval over what is allowed, where balls meet their pockets also over what changes the pocket
    /// force by a part of its peak, by the lead or by the orbital speed over half a turn: these forces may be small
    /// beside those of the races.
    fn closer(&mut self, orbit: &Orbit, allowed: f64) -> Vec<f64> {
        let (pocket, ball) = (&self.system.cage.pocket, &self.scales.ball);
        let lead = OF_POCKET * self.pocket_peak(orbit) / (pocket.stiffness * pocket.radius * allowed);
        let usual = self.scales.errors;
        if orbit.values.iter().flatten().any(|y| pocket.penetration(y[LEAD]) > 0.0) {
            let speed = lead / HALF_TURN * orbit.cage_speed.abs();
            for (k, error) in [(LEAD, lead), (ORBIT, speed)] {
                self.scales.errors[k] = usual[k].min(error / ball[k]);
            }
        }
        let errors = self.errors(orbit, allowed);
        self.scales.errors = usual;
        errors
    }

    /// Largest pocket force at the points of a mesh, or a slight part of the load, N.
    pub fn pocket_peak(&self, orbit: &Orbit) -> f64 {
        let force = |y: &[f64; BALL]| self.system.in_pocket(y, orbit.cage_speed).force.abs();
        orbit.values.iter().flatten().map(force).fold(SLIGHT * self.scales.force, f64::max)
    }

    /// By how much each interval's pocket force rises between its points above the values there, over what is allowed.
    ///
    /// A stiff pocket makes much of a lead that errs by little.
    fn pocket_errors(&self, orbit: &Orbit) -> Vec<f64> {
        let force = |y: &[f64; BALL]| self.system.in_pocket(y, orbit.cage_speed).force.abs();
        let most = |forces: &[f64]| forces.iter().copied().fold(0.0, f64::max);
        let at_points: Vec<f64> = orbit.values.iter().map(|values| most(&values.each_ref().map(force))).collect();
        let allowed = OF_POCKET * self.pocket_peak(orbit);
        let of = |j: usize| {
            let [begin, width] = orbit.interval(j);
            let between: [f64; LOOKS] = std::array::from_fn(|k| {
                let share = (k + 1) as f64 / (LOOKS + 1) as f64;
                force(&orbit.at(&self.radau, begin + share * width))
            });
            (most(&between) - at_points[j].max(force(orbit.begin(j)))) / allowed
        };
        (0..orbit.intervals()).map(of).collect()
    }

    /// Error of each interval over what is allowed.
    pub fn errors(&self, orbit: &Orbit, allowed: f64) -> Vec<f64> {
        let border = (orbit.cage_speed, orbit.ring);
        let of = |j: usize| {
            let [begin, width] = orbit.interval(j);
            let place = self.place(begin, orbit.begin(j), border);
            self.error_of(&place, width, &orbit.values[j]).unwrap_or(f64::INFINITY) / allowed
        };
        (0..orbit.intervals()).map(of).collect()
    }

    /// The orbit on a mesh that its errors ask for; none where that has too many intervals.
    fn finer(&self, orbit: &Orbit, errors: &[f64]) -> Option<Orbit> {
        // Intervals of the new mesh within each of the old one, and up to its end.
        let within = |error: &f64| (error / AIM).powf(0.25).clamp(1.0 / LONGER, SHORTER);
        let mut counts = vec![0.0];
        errors.iter().for_each(|error| counts.push(counts[counts.len() - 1] + within(error)));
        let total = counts[counts.len() - 1];
        let count = total.ceil() as usize;
        if count > MOST {
            return None;
        }
        let end = |n: usize| {
            let at = total * n as f64 / count as f64;
            let j = counts.partition_point(|c| *c <= at).clamp(1, errors.len()) - 1;
            let [begin, width] = orbit.interval(j);
            begin + width * (at - counts[j]) / (counts[j + 1] - counts[j])
        };
        let mut ends: Vec<f64> = (0..count).map(end).collect();
        ends.push(1.0);
        Some(Orbit::of(&self.radau, ends, (orbit.cage_speed, orbit.ring), |turn| orbit.at(&self.radau, turn)))
    }
}
