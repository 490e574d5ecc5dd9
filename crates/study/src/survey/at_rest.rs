//! Random bearings at rest: one by every model, and two of them on a shaft.

use super::bearing::{RandomBearing, random_bearing};
use super::trial::Verdict;
use rayon::prelude::*;
use tribodyn::answers::OrbitProblem;
use tribodyn::pair::{Arrangement, Pair, PairModel, Preload, solve_pair};
use tribodyn_bearing::{Bearing, OperatingPoint, RingFreedom};
use tribodyn_case::{Case, CaseError};
use tribodyn_orbit::steady_orbit;
use tribodyn_quasistatic::{Model, Solution, jones_harris_stiffness, solve};
use tribodyn_wear::Random;

/// Ring loads that are returned may differ from those of the case by this many tolerances of the loads on the balls.
const TOLERANCES: f64 = 10.0;
/// Peak pressure of a light contact, Pa.
const LIGHT_PA: f64 = 1e8;

/// How a random bearing at rest is solved.
#[derive(Debug, Clone, PartialEq)]
pub struct AtRest {
    /// Alone, by every model and with its stiffness.
    pub alone: Verdict,
    /// With another one on a rigid shaft.
    pub pair: Verdict,
}

/// Solves a random bearing with rings that stand still, and a random pair of it.
pub fn solve_at_rest(bearing: &RandomBearing) -> AtRest {
    let failed = |error: &dyn std::fmt::Display| Verdict::Failed(error.to_string());
    let problem = Case::from_ron(&bearing.text).map_err(|error| failed(&error));
    let problem = problem.and_then(|case| OrbitProblem::of(&case).map_err(|error| failed(&error)));
    let mut problem = match problem {
        Ok(problem) => problem,
        Err(verdict) => return AtRest { alone: verdict.clone(), pair: verdict },
    };
    (problem.point.inner_speed, problem.point.outer_speed) = (0.0, 0.0);
    let verdict = |result: Result<(), Verdict>| result.err().unwrap_or(Verdict::Good);
    let pair = verdict(pair(bearing.origin, &problem.bearing, &problem.point));
    AtRest { alone: verdict(alone(&problem)), pair }
}

/// Solves so many random bearings of a family at rest, from one on, by the threads of the current rayon pool.
///
/// # Errors
/// A bearing that the reader of case files refuses.
pub fn survey_at_rest(seed: u64, first: u64, bearings: u64) -> Result<Vec<AtRest>, CaseError> {
    let one = |index| random_bearing(seed, index).map(|bearing| solve_at_rest(&bearing));
    (first..first + bearings).into_par_iter().map(one).collect()
}

fn explained(error: &dyn std::fmt::Display) -> Verdict {
    Verdict::Explained(error.to_string())
}

fn alone(problem: &OrbitProblem) -> Result<(), Verdict> {
    let OrbitProblem { bearing, point, cage, settings } = problem;
    for model in [Model::JonesHarris, Model::Traction] {
        let solved = solve(bearing, point, model).map_err(|error| explained(&error))?;
        loads_returned(bearing, point, &solved.solution).map_err(Verdict::Failed)?;
    }
    jones_harris_stiffness(bearing, point).map_err(|error| explained(&error))?;
    let orbit = steady_orbit(bearing, point, cage, settings).map_err(|error| explained(&error))?.solution;
    loads_returned(bearing, point, &orbit.as_solution(&orbit.balls, [0.0; 2])).map_err(Verdict::Failed)
}

/// Checks that a solution carries the loads of its case, or says by how much not.
pub fn loads_returned(bearing: &Bearing, point: &OperatingPoint, solution: &Solution) -> Result<(), String> {
    let ([x, y, z], [mx, my]) = (solution.ring_load_n, solution.ring_moment_nm);
    // As in the solvers: the load of a light but real contact, below which balances are rounding.
    let least = 1e-3 * bearing.races.inner.frozen::<f64>().load_from_peak_pressure(LIGHT_PA);
    let pressed: f64 = solution.balls.iter().map(|ball| ball.contacts.inner.load_n + least).sum();
    let lever = solution.balls.iter().fold(0.0, |most: f64, ball| most.max(ball.orbit_radius_m));
    let names = ["x", "y", "z", "tilt_x", "tilt_y"];
    for (k, (freedom, returned)) in point.ring.iter().zip([x, y, z, mx, my]).enumerate() {
        let RingFreedom::Loaded(load) = *freedom else { continue };
        let size = load.abs() + pressed * if k < 3 { 1.0 } else { lever };
        if (returned - load).abs() > TOLERANCES * point.numerics.tolerance * size {
            return Err(format!("{} carries {returned} where the case has {load}", names[k]));
        }
    }
    Ok(())
}

fn pair((seed, index): (u64, u64), bearing: &Bearing, point: &OperatingPoint) -> Result<(), Verdict> {
    let mut random = Random::new(seed ^ 0x5eed_9a12, index);
    // Where the case gives no load, that of a ball at 1 GPa.
    let usual = bearing.races.inner.frozen::<f64>().load_from_peak_pressure(1e9);
    let load = |k: usize| match point.ring[k] {
        RingFreedom::Loaded(load) => load,
        RingFreedom::Held(_) => usual,
    };
    let (radial, axial) = (load(0), load(2));
    let axial = random.one_of(&[(0.3, 0.0), (0.4, axial), (0.3, -axial)]);
    let radial = if radial == 0.0 && axial == 0.0 { usual } else { radial };
    let tilts = random.one_of(&[(0.5, RingFreedom::Held(0.0)), (0.5, RingFreedom::Loaded(0.0))]);
    let ring = [RingFreedom::Loaded(radial), RingFreedom::Loaded(0.0), RingFreedom::Loaded(axial), tilts, tilts];
    let point = OperatingPoint { ring, ..point.clone() };
    let arrangement =
        random.one_of(&[(0.4, Arrangement::BackToBack), (0.3, Arrangement::FaceToFace), (0.3, Arrangement::Tandem)]);
    let offset = bearing.geometry.ball_diameter * random.between(-1e-3, 4e-3);
    let preload = match arrangement {
        Arrangement::Tandem => Preload::OffsetM(0.0),
        _ if random.chance(0.3) => Preload::SpringN(random.decades(0.01, 0.5) * (radial.abs() + axial.abs())),
        _ => Preload::OffsetM(offset),
    };
    let distance = bearing.geometry.pitch_diameter * random.between(0.3, 3.0);
    let model = PairModel::QuasiStatic(Model::JonesHarris);
    let solved = solve_pair(&Pair { bearing, point: &point, model, arrangement, distance, preload });
    let what = format!("{arrangement:?}, {preload:?}, {radial:.4e} N radial, {axial:.4e} N axial");
    let solved = solved.map_err(|error| Verdict::Explained(format!("{what}: {error}")))?;
    let carried: Vec<f64> = (0..3).map(|k| solved.bearings.iter().map(|bearing| bearing.load_n[k]).sum()).collect();
    let size: f64 = solved.bearings.iter().flat_map(|bearing| bearing.load_n).map(f64::abs).sum();
    for (k, asked) in [radial, 0.0, axial].into_iter().enumerate() {
        if (carried[k] - asked).abs() > 1e-6 * (size + asked.abs()) {
            return Err(Verdict::Failed(format!("the pair carries {} N where the shaft has {asked} N", carried[k])));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every bearing stands still in one way: no model and no pair may miss it.
    #[test]
    fn identity_bearings_and_pairs_at_rest_are_solved_and_carry_their_loads() {
        for index in 0..60 {
            let bearing = random_bearing(7, index).unwrap();
            let AtRest { alone, pair } = solve_at_rest(&bearing);
            assert_eq!((&alone, &pair), (&Verdict::Good, &Verdict::Good), "{index}: {}", bearing.text);
        }
    }

    /// Loads come from the balance itself, whatever the model and the speed.
    #[test]
    fn identity_loads_returned_are_those_of_the_case_at_speed() {
        let mut solved = 0;
        for index in 0..40 {
            let case = Case::from_ron(&random_bearing(11, index).unwrap().text).unwrap();
            let (bearing, point) = (case.bearing().unwrap(), case.operating_point());
            for model in [Model::JonesHarris, Model::Traction] {
                if let Ok(found) = solve(&bearing, &point, model) {
                    loads_returned(&bearing, &point, &found.solution)
                        .unwrap_or_else(|what| panic!("{index} {model:?}: {what}"));
                    solved += 1;
                }
            }
        }
        assert!(solved > 60, "{solved}");
    }
}
