//! The stiffness of random bearings against differences of solutions, along a random direction.

use super::bearing::{RandomBearing, random_bearing};
use super::trial::Verdict;
use rayon::prelude::*;
use std::fmt::Display;
use tribodyn::answers::{Equations, OrbitProblem};
use tribodyn_bearing::{OperatingPoint, RingFreedom};
use tribodyn_case::{Case, CaseError};
use tribodyn_orbit::{OrbitStart, orbit_stiffness, steady_orbit, steady_orbit_from};
use tribodyn_quasistatic::{
    Model, Solution, StiffnessMatrix, WarmStart, checked_traction_stiffness, jones_harris_stiffness, solve, solve_from,
};
use tribodyn_wear::Random;

/// Largest deviation from differences, over √(K_ii K_jj), of a matrix that is right.
const ALLOWED: f64 = 1e-3;
/// Largest error of the differences themselves by which a matrix is judged, a third of that.
const JUDGED: f64 = ALLOWED / 3.0;
/// Part of the largest approach by which a ring may seem to be moved between a solution and the same one held.
const SAME: f64 = 1e-5;
/// Step of the differences over the largest approach of a ball and a race; the first that is smooth enough judges.
const STEPS: [f64; 3] = [3e-3, 3e-4, 3e-2];

/// A stiffness matrix beside differences of the solutions that it comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct Compared {
    /// Good within 10⁻³; explained where there is no solution, the matrix is refused, or it states the error itself.
    pub verdict: Verdict,
    /// Deviation from the differences over √(K_ii K_jj), where these are smooth enough to judge by.
    pub deviation: Option<f64>,
}

/// Compares so many random bearings of a family, from one on, by the threads of the current rayon pool.
///
/// # Errors
/// A bearing that the reader of case files refuses.
pub fn survey_stiffness(
    (seed, first): (u64, u64),
    bearings: u64,
    model: Equations,
    finished: &(dyn Fn() + Sync),
) -> Result<Vec<Compared>, CaseError> {
    let one = |index| {
        let compared = compare_stiffness(&random_bearing(seed, index)?, model);
        finished();
        Ok(compared)
    };
    (first..first + bearings).into_par_iter().map(one).collect()
}

/// Compares the stiffness of a bearing with differences.
pub fn compare_stiffness(bearing: &RandomBearing, model: Equations) -> Compared {
    match compared(bearing, model) {
        Ok(compared) => compared,
        Err(verdict) => Compared { verdict, deviation: None },
    }
}

fn failed(error: impl Display) -> Verdict {
    Verdict::Failed(error.to_string())
}

fn explained(error: impl Display) -> Verdict {
    Verdict::Explained(error.to_string())
}

fn compared(bearing: &RandomBearing, model: Equations) -> Result<Compared, Verdict> {
    let case = Case::from_ron(&bearing.text).map_err(failed)?;
    let problem = OrbitProblem::of(&case).map_err(failed)?;
    let found = Found::of(&problem, model)?;
    let mut random = Random::new(bearing.origin.0 ^ 0x0d1f_f5ee, bearing.origin.1);
    let radius = 0.5 * problem.bearing.geometry.pitch_diameter;
    let direction: [f64; 5] = std::array::from_fn(|k| {
        let part = random.between(0.3, 1.0) * random.one_of(&[(0.5, 1.0), (0.5, -1.0)]);
        if k < 3 { part } else { part / radius }
    });
    let k = &found.stiffness;
    let scale: f64 = (0..5).map(|j| k[j][j].abs().sqrt() * direction[j].abs()).sum();
    let slope: [f64; 5] = std::array::from_fn(|i| (0..5).map(|j| k[i][j] * direction[j]).sum());
    let off = |other: &[f64; 5], than: &[f64; 5]| {
        let parts = (0..5).map(|i| (other[i] - than[i]).abs() / (k[i][i].abs().sqrt() * scale));
        parts.fold(0.0, f64::max)
    };
    let held = OperatingPoint { ring: found.ring.map(RingFreedom::Held), ..problem.point.clone() };
    let again = found.loads(&problem, &held);
    if !again.is_some_and(|again| off(&again, &found.carried) < SAME * found.approach) {
        return Err(explained("with the ring held where it is, the balls come to another equilibrium"));
    }
    for step in STEPS {
        let Some([coarse, fine]) = found.differences(&problem, &direction, step * found.approach) else { continue };
        if off(&coarse, &fine) > JUDGED {
            continue;
        }
        let deviation = off(&slope, &fine);
        let stated = found.error_estimate.unwrap_or(0.0);
        let verdict = if deviation <= ALLOWED {
            Verdict::Good
        } else if deviation <= 3.0 * stated {
            Verdict::Explained(format!("off by {deviation:.1e}, and states an error of {stated:.1e}"))
        } else {
            Verdict::Failed(format!("{}: off by {deviation:.1e}, states {stated:.1e}", model.name()))
        };
        return Ok(Compared { verdict, deviation: Some(deviation) });
    }
    Err(Verdict::Explained("solutions near by are not smooth enough to judge by".to_owned()))
}

/// From where a neighbour is solved.
enum Near {
    Elastic,
    Traction(Box<WarmStart>),
    Orbit(Box<OrbitStart>),
}

/// A solution with its stiffness.
struct Found {
    stiffness: StiffnessMatrix,
    error_estimate: Option<f64>,
    ring: [f64; 5],
    /// Forces and moments that it carries there, N and N m.
    carried: [f64; 5],
    /// Largest approach of a ball and a race, m.
    approach: f64,
    near: Near,
}

impl Found {
    fn of(problem: &OrbitProblem, model: Equations) -> Result<Self, Verdict> {
        let OrbitProblem { bearing, point, cage, settings } = problem;
        if let Some(model) = model.equilibrium() {
            let solved = solve(bearing, point, model).map_err(explained)?;
            let Some(at) = solved.warm_start else {
                let stiffness = jones_harris_stiffness(bearing, point).map_err(explained)?;
                return Ok(Self::new(&solved.solution, (stiffness, None), Near::Elastic));
            };
            let checked = checked_traction_stiffness(bearing, point, (&solved.solution, &at)).map_err(explained)?;
            return Ok(Self::new(&solved.solution, checked, Near::Traction(Box::new(at))));
        }
        let solved = steady_orbit(bearing, point, cage, settings).map_err(explained)?;
        let solution = solved.solution.as_solution(&solved.solution.balls, [point.inner_speed, point.outer_speed]);
        let at = solved.start.ok_or_else(|| explained("the bearing is at rest"))?;
        let matrix = orbit_stiffness(bearing, point, cage, settings, &at).map_err(explained)?;
        Ok(Self::new(&solution, (matrix.stiffness, Some(matrix.error_estimate)), Near::Orbit(Box::new(at))))
    }

    fn new(solution: &Solution, (stiffness, error_estimate): (StiffnessMatrix, Option<f64>), near: Near) -> Self {
        let ([x, y, z], [tilt_x, tilt_y]) = (solution.ring_displacement_m, solution.ring_tilt_rad);
        let contacts = solution.balls.iter().flat_map(|ball| [&ball.contacts.inner, &ball.contacts.outer]);
        let approach = contacts.map(|contact| contact.approach_m).fold(0.0, f64::max);
        let (ring, carried) = ([x, y, z, tilt_x, tilt_y], carried(solution));
        Self { stiffness, error_estimate, ring, carried, approach, near }
    }

    /// Differences of second and of fourth order of forces and moments along a direction.
    fn differences(&self, problem: &OrbitProblem, direction: &[f64; 5], step: f64) -> Option<[[f64; 5]; 2]> {
        let at = |way: f64| {
            let ring = std::array::from_fn(|k| RingFreedom::Held(self.ring[k] + way * step * direction[k]));
            self.loads(problem, &OperatingPoint { ring, ..problem.point.clone() })
        };
        let (far_down, down, up, far_up) = (at(-2.0)?, at(-1.0)?, at(1.0)?, at(2.0)?);
        let second = std::array::from_fn(|k| (up[k] - down[k]) / (2.0 * step));
        let fourth = std::array::from_fn(|k| (8.0 * (up[k] - down[k]) - (far_up[k] - far_down[k])) / (12.0 * step));
        Some([second, fourth])
    }

    fn loads(
        &self,
        OrbitProblem { bearing, cage, settings, .. }: &OrbitProblem,
        held: &OperatingPoint,
    ) -> Option<[f64; 5]> {
        let solution = match &self.near {
            Near::Elastic => solve(bearing, held, Model::JonesHarris).ok()?.solution,
            Near::Traction(near) => solve_from(bearing, held, near).ok()?.solution,
            Near::Orbit(near) => {
                let orbit = steady_orbit_from(bearing, held, cage, settings, near).ok()?.solution;
                orbit.as_solution(&orbit.balls, [held.inner_speed, held.outer_speed])
            }
        };
        Some(carried(&solution))
    }
}

/// Forces, N, and moments, N m, on the inner ring.
fn carried(solution: &Solution) -> [f64; 5] {
    let ([x, y, z], [mx, my]) = (solution.ring_load_n, solution.ring_moment_nm);
    [x, y, z, mx, my]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two equilibria whose matrix differences did not confirm, and nothing in the answer said so.
    #[test]
    fn regress_a_matrix_that_differences_do_not_confirm_says_so() {
        for index in [173, 177] {
            let compared = compare_stiffness(&random_bearing(1, index).unwrap(), Equations::Traction);
            assert!(!matches!(compared.verdict, Verdict::Failed(_)), "{index}: {compared:?}");
            assert!(compared.deviation.is_some(), "{index}: {compared:?}");
        }
    }

    /// By the equilibria of every tenth bearing, and a few orbits.
    #[test]
    fn identity_stiffness_of_random_bearings_is_that_of_differences() {
        for (model, indices) in [
            (Equations::JonesHarris, (0..200).step_by(10).collect::<Vec<_>>()),
            (Equations::Traction, (0..200).step_by(20).collect()),
            (Equations::SteadyOrbit, vec![60, 80, 100]),
        ] {
            let compared: Vec<Compared> =
                indices.iter().map(|index| compare_stiffness(&random_bearing(3, *index).unwrap(), model)).collect();
            for (index, one) in indices.iter().zip(&compared) {
                assert!(!matches!(one.verdict, Verdict::Failed(_)), "{index} {}: {one:?}", model.name());
            }
            let judged = compared.iter().filter(|one| one.deviation.is_some()).count();
            assert!(2 * judged > compared.len(), "{}: {judged} of {}", model.name(), compared.len());
        }
    }
}
