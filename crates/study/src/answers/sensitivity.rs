//! How far a steady orbit rests on values that were assumed: what half and twice of each make of it.

use super::OrbitProblem;
use serde::Serialize;
use tribodyn_case::{Case, Source};
use tribodyn_orbit::{OrbitStart, SolvedOrbit, SteadyOrbit, steady_orbit_near};
use tribodyn_traction::SlipUnit;

/// An orbit with one assumed value halved and doubled.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sensitivity {
    /// Path of the value in the case.
    pub path: &'static str,
    /// Shaft torque with half and with twice the value, N m; absent where no orbit was found near by.
    pub shaft_torque_nm: [Option<f64>; 2],
    /// Cage speed with half and with twice the value, r/min.
    pub cage_speed_rpm: [Option<f64>; 2],
}

/// A value of a case that can be multiplied.
type Scale = fn(&mut Case, f64);

/// Values that are seldom known, the pocket gap first: an answer always says what rests on that.
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

/// Steps to half and to twice of a value: each near enough to start from the one before.
const STEPS: [[f64; 2]; 2] = [[0.7, 0.5], [1.4, 2.0]];
/// Part of the torque or of the cage's slip beyond which a warning names a value.
const NAMED: f64 = 0.1;

/// Which assumed values are tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tried {
    /// The pocket gap alone, some hundredths of the time of a solution.
    PocketGap,
    /// All.
    All,
}

/// Sensitivities to the assumed values of a case, the largest change of torque first. Values that the case does not
/// have, that are 0, or that have a source better than an assumption are left out.
pub(super) fn sensitivities(
    case: &Case,
    (problem, start): (&OrbitProblem, &OrbitStart),
    tried: Tried,
) -> Vec<Sensitivity> {
    let values = if tried == Tried::All { &VALUES[..] } else { &VALUES[..1] };
    let of = |(path, scale): &(&'static str, Scale)| {
        let mut other = case.clone();
        scale(&mut other, 2.0);
        if other == *case || !is_assumed(case, path) {
            return None;
        }
        let [half, twice] = STEPS.map(|steps| moved(case, (problem, start), *scale, steps));
        let both = |number: fn(&SteadyOrbit) -> f64| [half.as_ref().map(number), twice.as_ref().map(number)];
        let (shaft_torque_nm, cage_speed_rpm) =
            (both(|orbit| orbit.shaft_torque_nm), both(|orbit| orbit.cage_speed_rpm));
        Some(Sensitivity { path, shaft_torque_nm, cage_speed_rpm })
    };
    let mut found: Vec<Sensitivity> = values.iter().filter_map(of).collect();
    found.sort_by(|a, b| b.span().total_cmp(&a.span()));
    found
}

/// True for a value whose source is an assumption, or that has none.
fn is_assumed(case: &Case, path: &str) -> bool {
    let within = |place: &str| path.strip_prefix(place).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
    let nearest = case.sources.iter().filter(|(place, _)| within(place)).max_by_key(|(place, _)| place.len());
    nearest.is_none_or(|(_, source)| matches!(source, Source::Assumed(_)))
}

/// The orbit at the last of some steps of a value.
fn moved(
    case: &Case,
    (problem, start): (&OrbitProblem, &OrbitStart),
    scale: Scale,
    steps: [f64; 2],
) -> Option<SteadyOrbit> {
    let mut near: Option<SolvedOrbit> = None;
    for by in steps {
        let mut other = case.clone();
        scale(&mut other, by);
        let OrbitProblem { bearing, cage, settings, .. } = OrbitProblem::of(&other).ok()?;
        let from = near.as_ref().map_or(Some(start), |solved| solved.start.as_ref())?;
        near = steady_orbit_near(&bearing, &problem.point, &cage, &settings, from).ok()?;
        near.as_ref()?;
    }
    near.map(|solved| solved.solution)
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
        let of = |torque: Option<f64>| {
            torque.map_or_else(|| "not found near by".to_owned(), |torque| format!("{torque:.4} N m"))
        };
        let [half, twice] = self.shaft_torque_nm.map(of);
        Some(format!(
            "the shaft torque of {torque_nm:.4} N m rests on the assumed `{}`: with half of it {half}, with twice of it \
             {twice}",
            self.path
        ))
    }
}
