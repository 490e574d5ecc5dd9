//! A worn bearing solved, and the wear that follows from it.

use super::{Effects, Grooves};
use crate::error::StudyError;
use crate::life::Start;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};
use tribodyn::answers::{Equations, OrbitProblem};
use tribodyn::{AnswerError, CaseFile};
use tribodyn_bearing::{BallResult, Bearing, Races, SearchWatch, Side, TransferredFilm};
use tribodyn_case::{Case, Fit};
use tribodyn_orbit::{steady_orbit, steady_orbit_from};
use tribodyn_quasistatic::{Model, OperatingPoint, Solved, solve, solve_near};
use tribodyn_wear::{GrooveWear, TransferRates, UnderContact};

/// Least groove radius over that of the ball: where wear conforms more, the contact is no longer Hertz's.
const CLOSEST: f64 = 1.01;

/// A bearing at one time of its life, solved.
pub struct State {
    /// A ball round its orbit.
    pub round: Vec<BallResult>,
    /// Wear of both races without a film on them.
    pub wear: Races<GrooveWear>,
    /// Rates at the transfer film.
    pub film: TransferRates,
    /// Speed of the inner ring against the outer, rad/s.
    pub speed: f64,
    /// Free contact angle, rad.
    pub free_angle: f64,
    pub cage_speed_rpm: f64,
    pub warnings: Vec<String>,
}

/// Effect of the wear of both races on the bearing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Acting {
    pub under: Races<UnderContact>,
    /// Part of every contact under a film from the cage.
    pub cover: f64,
}

/// The case with the clearance that wear has added.
fn worn_case(file: &CaseFile, effects: &Effects, acting: &Acting) -> Result<Case, StudyError> {
    let mut case = file.case.clone();
    let growth = 2.0 * (acting.under.inner.depth + acting.under.outer.depth);
    if effects.clearance && growth > 0.0 {
        let drawn = case.geometry.resolve().map_err(|source| file.not_usable(source.into()))?;
        case.geometry.fit = Fit::RadialClearance(drawn.radial_clearance() + growth);
    }
    if let Some(coatings) = &mut case.coatings {
        (coatings.inner.worn, coatings.outer.worn) = (0.0, 0.0);
    }
    Ok(case)
}

/// Lets profile and surfaces act on a bearing; a sentence where the profile does as much as it can.
fn act(
    bearing: &mut Bearing,
    (file, effects): (&CaseFile, &Effects),
    acting: &Acting,
) -> Result<Option<String>, StudyError> {
    let mut conforming = None;
    for side in Side::BOTH {
        let under = &acting.under[side];
        if effects.curvature && under.curvature != 0.0 {
            let ball = bearing.geometry.ball_radius();
            let groove = bearing.geometry.coefficient(side) * bearing.geometry.ball_diameter;
            let worn = 1.0 / (1.0 / groove + under.curvature).max(1e-9);
            if worn < CLOSEST * ball {
                let race = if side == Side::Inner { "inner" } else { "outer" };
                conforming = Some(format!(
                    "the worn profile of the {race} race fits the ball closer than f = {}: f is kept at that value, and pressures are too high from then on",
                    0.5 * CLOSEST
                ));
            }
            let radius = worn.max(CLOSEST * ball);
            bearing.reshape(side, radius).map_err(|source| file.not_usable(source.into()))?;
        }
        bearing.worn[side].bare = if effects.traction { under.bare } else { 0.0 };
    }
    if effects.transfer && acting.cover > 0.0 {
        let law = file.case.transferred_law().map_err(|source| file.not_usable(source.into()))?;
        if let (Some(tribology), Some(law)) = (&mut bearing.tribology, law) {
            tribology.transferred = Some(TransferredFilm { law, share: acting.cover });
        }
    }
    Ok(conforming)
}

/// Solves the bearing from where it was solved last.
pub fn solved(
    file: &CaseFile,
    (equations, effects, watch): (Equations, &Effects, &SearchWatch),
    acting: &Acting,
    start: &mut Option<Start>,
) -> Result<State, StudyError> {
    let case = worn_case(file, effects, acting)?;
    if equations == Equations::SteadyOrbit {
        return orbit(file, &case, (effects, watch), acting, start);
    }
    let failed = |source| AnswerError::Solver { file: file.name.clone(), source };
    let mut bearing = case.bearing().map_err(|source| file.not_usable(source.into()))?;
    let conforming = act(&mut bearing, (file, effects), acting)?;
    let point = OperatingPoint { watch: watch.clone(), ..case.operating_point() };
    let fine = |solved: &Solved| point.patch.is_none_or(|patch| patch.allows(solved.solution.patch_error_estimate));
    let near = match start {
        Some(Start::Equilibrium(start)) => solve_near(&bearing, &point, start).ok().filter(fine),
        _ => None,
    };
    let solved = match near {
        Some(solved) => solved,
        None => solve(&bearing, &point, Model::Traction).map_err(failed)?,
    };
    *start = solved.warm_start.map(Start::Equilibrium);
    let solution = solved.solution;
    let warnings = solution.warnings.into_iter().chain(conforming).collect();
    Ok(state(&bearing, &point, (solution.balls, solution.cage_speed_rpm), warnings))
}

fn orbit(
    file: &CaseFile,
    case: &Case,
    (effects, watch): (&Effects, &SearchWatch),
    acting: &Acting,
    start: &mut Option<Start>,
) -> Result<State, StudyError> {
    let failed = |source| AnswerError::Orbit { file: file.name.clone(), source };
    let mut problem = OrbitProblem::of(case).map_err(|source| file.not_usable(source))?;
    let conforming = act(&mut problem.bearing, (file, effects), acting)?;
    let OrbitProblem { bearing, cage, settings, .. } = &problem;
    let point = OperatingPoint { watch: watch.clone(), ..problem.point.clone() };
    let solved = match start {
        Some(Start::Orbit(near)) => steady_orbit_from(bearing, &point, cage, settings, near),
        _ => steady_orbit(bearing, &point, cage, settings),
    };
    let solved = solved.map_err(failed)?;
    *start = solved.start.map(|start| Start::Orbit(Box::new(start)));
    let orbit = solved.solution;
    let warnings = orbit.warnings().into_iter().chain(conforming).collect();
    Ok(state(bearing, &point, (orbit.points, orbit.cage_speed_rpm), warnings))
}

fn state(
    bearing: &Bearing,
    point: &OperatingPoint,
    (round, cage_speed_rpm): (Vec<BallResult>, f64),
    warnings: Vec<String>,
) -> State {
    let speeds = Races { inner: point.inner_speed, outer: point.outer_speed };
    let wear = Races::from_fn(|side| GrooveWear {
        along_orbit: round.iter().map(|ball| bearing.contact_wear(side, ball, speeds[side])).collect(),
        ball_count: bearing.geometry.ball_count,
        turning: speeds[side] != 0.0,
    });
    let film = film_rates(bearing, &round, &wear);
    let (speed, free_angle) = (speeds.inner - speeds.outer, bearing.geometry.contact_angle());
    State { round, wear, film, speed, free_angle, cage_speed_rpm, warnings }
}

/// Rates at the transfer film: loss of the pockets, sliding of all contacts, and surface of balls and tracks.
fn film_rates(bearing: &Bearing, round: &[BallResult], wear: &Races<GrooveWear>) -> TransferRates {
    let g = &bearing.geometry;
    let balls = g.ball_count as f64;
    let mean =
        |of: &dyn Fn(usize) -> f64| -> f64 { (0..round.len()).map(|k| wear.inner.part_of_orbit(k) * of(k)).sum() };
    let scraped = balls * mean(&|k| round[k].pocket.map_or(0.0, |pocket| pocket.wear_rate_m3_s));
    // Load times the mean sliding speed is ∬ p |Δv|.
    let sliding = |side: Side| {
        balls
            * mean(&|k| {
                let contact = &round[k].contacts[side];
                if contact.load_n > 0.0 { contact.load_n * contact.friction_or_nan().sliding_speed_m_s } else { 0.0 }
            })
    };
    let track = |side: Side| TAU * g.pitch_diameter * 0.5 * 2.0 * mean(&|k| round[k].contacts[side].semi_axes_m[0]);
    TransferRates {
        scraped,
        sliding: sliding(Side::Inner) + sliding(Side::Outer),
        area: balls * PI * g.ball_diameter.powi(2) + track(Side::Inner) + track(Side::Outer),
    }
}

impl Grooves {
    /// Effect of a state's wear on its contacts.
    pub fn acting(&self, state: &State, cover: f64) -> Acting {
        Acting { under: Races::from_fn(|side| self.fields[side].under(&state.wear[side])), cover }
    }
}
