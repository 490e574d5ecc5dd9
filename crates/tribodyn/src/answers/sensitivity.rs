//! How far a steady orbit rests on values that were assumed: what half and twice of each make of it.

use super::OrbitProblem;
use crate::plausibility::shown;
use serde::Serialize;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tribodyn_bearing::{OperatingPoint, SearchObserver, SearchStage, SearchWatch};
use tribodyn_case::{Case, Source};
use tribodyn_orbit::{OrbitStart, SolvedOrbit, SteadyOrbit, steady_orbit_from, steady_orbit_near};
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

/// Ends a search after some looks, or with that of the asker.
struct Limited {
    looks: AtomicUsize,
    asker: SearchWatch,
}

impl SearchObserver for Limited {
    fn stage(&self, _: SearchStage) {}

    fn stops(&self) -> bool {
        self.looks.fetch_add(1, Ordering::Relaxed) >= LOOKS || self.asker.stops()
    }
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

/// Factors that are sought, the share of a step in each direction, and the least one.
const FACTORS: [f64; 2] = [0.5, 2.0];
const STEPS: usize = 8;
const LEAST_STEP: f64 = 0.03;
/// Looks of a search for each factor, some times as many as a cold start takes: what is counted by looks is the same on
/// every machine.
const LOOKS: usize = 5000;
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

/// The orbit at a factor of a value, or as near to it as short steps lead, with that factor.
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
    let at = |by: f64, from: &OrbitStart| -> Option<SolvedOrbit> {
        let OrbitProblem { bearing, cage, settings, .. } = problem_at(by)?;
        steady_orbit_near(&bearing, &problem.point, &cage, &settings, from).ok()?
    };
    let limited = Limited { looks: AtomicUsize::new(0), asker: problem.point.watch.clone() };
    let point = OperatingPoint { watch: SearchWatch::new(Arc::new(limited)), ..problem.point.clone() };
    let OrbitProblem { bearing, cage, settings, .. } = problem_at(factor)?;
    if let Ok(solved) = steady_orbit_from(&bearing, &point, &cage, &settings, start) {
        return Some((factor, solved.solution));
    }
    let mut reached: Option<(f64, SolvedOrbit)> = None;
    let (mut part, mut step) = (0.0, 0.5);
    for _ in 0..STEPS {
        let next = f64::min(part + step, 1.0);
        let from = reached.as_ref().map_or(Some(start), |(_, solved)| solved.start.as_ref())?;
        match at(factor.powf(next), from) {
            Some(solved) => (reached, part) = (Some((factor.powf(next), solved)), next),
            None => step *= 0.4,
        }
        if part == 1.0 || step < LEAST_STEP {
            break;
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
