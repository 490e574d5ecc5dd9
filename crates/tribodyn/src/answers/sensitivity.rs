//! How far a steady orbit rests on values that were assumed: what half and twice of each make of it.

use super::OrbitProblem;
use super::limited::limited;
use crate::plausibility::shown;
use serde::Serialize;
use tribodyn_case::{Case, Source};
use tribodyn_orbit::{OrbitStart, SolvedOrbit, SteadyOrbit, steady_orbit, steady_orbit_near};
use tribodyn_traction::SlipUnit;

/// An orbit with one assumed value halved and doubled.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sensitivity {
    /// Path of the value in the case.
    pub path: &'static str,
    /// Factors of the value, 0.5 and 2, or as near to them as orbits were found; absent where none was.
    pub factors: [Option<f64>; 2],
    /// Shaft torque with each, N m.
    pub shaft_torque_nm: [Option<f64>; 2],
    /// Cage speed with each, r/min.
    pub cage_speed_rpm: [Option<f64>; 2],
}

/// A value of a case that can be multiplied.
type Scale = fn(&mut Case, f64);

/// Values that are seldom known.
const VALUES: [(&str, Scale); 5] = [
    ("cage.pocket_gap", |case, by| case.cage.iter_mut().for_each(|cage| cage.pocket_gap *= by)),
    ("cage.pocket_friction", |case, by| case.cage.iter_mut().for_each(|cage| cage.pocket_friction *= by)),
    ("fluid.drag_coefficient", |case, by| case.fluid.iter_mut().for_each(|fluid| fluid.drag_coefficient *= by)),
    ("fluid.liquid_fraction", |case, by| {
        case.fluid.iter_mut().for_each(|fluid| fluid.liquid_fraction = (fluid.liquid_fraction * by).min(1.0));
    }),
    ("traction.slip_unit", |case, by| {
        if let Some(SlipUnit::Scaled { per_m_s }) = case.traction.as_mut().map(|traction| &mut traction.slip_unit) {
            *per_m_s *= by;
        }
    }),
];

/// Factors that are sought, the shares of the way to them that are tried first and last, and how many steps are.
const FACTORS: [f64; 2] = [0.5, 2.0];
const STEP: f64 = 0.5;
const LEAST_STEP: f64 = 0.06;
const STEPS: usize = 8;
/// Looks of a step, of which most take 400, and of a cold start where steps do not lead all the way.
const LOOKS: usize = 1000;
const LOOKS_COLD: usize = 3000;
/// Part of the torque beyond which a warning names a value.
const NAMED: f64 = 0.1;

/// Sensitivities to the assumed values of a case, the largest change of torque first. Values that the case does not
/// have, that are 0, or that have a source better than an assumption are left out.
pub(super) fn sensitivities(case: &Case, of_orbit: (&OrbitProblem, &OrbitStart)) -> Vec<Sensitivity> {
    let of = |(path, scale): &(&'static str, Scale)| {
        let mut other = case.clone();
        scale(&mut other, 0.5);
        if other == *case || !is_assumed(case, path) {
            return None;
        }
        let found = FACTORS.map(|factor| moved(case, of_orbit, *scale, factor));
        let both = |number: fn(&(f64, SteadyOrbit)) -> f64| found.each_ref().map(|found| found.as_ref().map(number));
        Some(Sensitivity {
            path,
            factors: both(|found| found.0),
            shaft_torque_nm: both(|found| found.1.shaft_torque_nm),
            cage_speed_rpm: both(|found| found.1.cage_speed_rpm),
        })
    };
    let mut found: Vec<Sensitivity> = VALUES.iter().filter_map(of).collect();
    found.sort_by(|a, b| b.span().total_cmp(&a.span()));
    found
}

/// True for a value whose source is an assumption, or that has none.
fn is_assumed(case: &Case, path: &str) -> bool {
    let within = |place: &str| path.strip_prefix(place).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
    let nearest = case.sources.iter().filter(|(place, _)| within(place)).max_by_key(|(place, _)| place.len());
    nearest.is_none_or(|(_, source)| matches!(source, Source::Assumed(_)))
}

/// The orbit at a factor of a value, or as near to it as short steps lead, with that factor. Steps keep to the motion
/// that they begin with and are mostly quicker than a search.
fn moved(
    case: &Case,
    (problem, start): (&OrbitProblem, &OrbitStart),
    scale: Scale,
    factor: f64,
) -> Option<(f64, SteadyOrbit)> {
    let problem_at = |by: f64| {
        let mut other = case.clone();
        scale(&mut other, by);
        OrbitProblem::of(&other).ok()
    };
    let step_to = |by: f64, from: &OrbitStart| -> Option<SolvedOrbit> {
        let OrbitProblem { bearing, cage, settings, .. } = problem_at(by)?;
        steady_orbit_near(&bearing, &limited(&problem.point, LOOKS), &cage, &settings, from).ok()?
    };
    let mut reached: Option<(f64, SolvedOrbit)> = None;
    let (mut part, mut step) = (0.0, STEP);
    for _ in 0..STEPS {
        let next = f64::min(part + step, 1.0);
        let from = reached.as_ref().map_or(Some(start), |(_, solved)| solved.start.as_ref())?;
        match step_to(factor.powf(next), from) {
            Some(solved) => (reached, part) = (Some((factor.powf(next), solved)), next),
            None => step *= 0.5,
        }
        if part == 1.0 || step < LEAST_STEP {
            break;
        }
    }
    if part < 1.0 {
        let OrbitProblem { bearing, cage, settings, .. } = problem_at(factor)?;
        if let Ok(solved) = steady_orbit(&bearing, &limited(&problem.point, LOOKS_COLD), &cage, &settings) {
            return Some((factor, solved.solution));
        }
    }
    reached.map(|(by, solved)| (by, solved.solution))
}

impl Sensitivity {
    /// Largest difference of the torques that were found, N m.
    fn span(&self) -> f64 {
        let [half, twice] = self.shaft_torque_nm.map(|torque| torque.unwrap_or(f64::NAN));
        (half - twice).abs().max(0.0)
    }

    /// A sentence where the torque moves by more than a tenth.
    pub fn warning(&self, torque_nm: f64) -> Option<String> {
        let moved = |torque: f64| (torque - torque_nm).abs() > NAMED * torque_nm.abs();
        let named = |torque: &Option<f64>| torque.is_some_and(moved);
        if !self.shaft_torque_nm.iter().any(named) {
            return None;
        }
        let both = self.factors.into_iter().zip(self.shaft_torque_nm);
        let told = both.filter_map(|(factor, torque)| Some((factor?, torque?)));
        let told: Vec<String> =
            told.map(|(factor, torque)| format!("{torque:.4} N m with {} times of it", shown(factor))).collect();
        Some(format!(
            "the shaft torque of {torque_nm:.4} N m rests on the assumed `{}`: {}",
            self.path,
            told.join(", ")
        ))
    }
}
