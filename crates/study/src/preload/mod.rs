//! Sets of like bearings on one seat, pressed against each other: preload, unloading force, axial rigidity.

mod arrangement;

pub use arrangement::{ARRANGEMENTS, pressed, sides};

use crate::error::StudyError;
use crate::held::{elastic, held_pressure, held_solution};
use serde::Serialize;
use tribodyn::AnswerError;
use tribodyn::plausibility::solution_findings;
use tribodyn_bearing::{Bearing, OperatingPoint};
use tribodyn_case::Case;
use tribodyn_quasistatic::{Model, Solution};
use tribodyn_shaft::{AxialSet, AxialState, Member, RestingBearing, RingForce, ShaftError, TurningBearing};

const RPM_PER_RAD_S: f64 = 30.0 / std::f64::consts::PI;

/// Preload that presses the bearings of a set together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SetPreload {
    /// Force, N, of the bearings off the shaft, as catalogues have it.
    UnmountedN(f64),
    /// Force, N, of the mounted bearings at rest and at the temperature of the drawing.
    MountedN(f64),
    /// Force, N, at the speed and the temperatures of the case.
    RunningN(f64),
    /// How far each bearing is pressed in, m, off the shaft: half of what the faces of a pair are ground off.
    OffsetM(f64),
    /// Force, N, of a soft spring that replaces the bearings that carry −z.
    SpringN(f64),
}

/// A question about a set.
#[derive(Debug, Clone)]
pub struct SetQuestion {
    /// Side of each bearing, from −z to +z: true where it carries a shaft pushed along +z.
    pub sides: Vec<bool>,
    /// Preload of the set.
    pub preload: SetPreload,
    /// Axial loads along +z, N; where none are given, up to the unloading force.
    pub loads: Vec<f64>,
    /// Speeds of a map, r/min; that of the case where only `warmer_k` is given.
    pub speeds_rpm: Vec<f64>,
    /// How much warmer shaft and inner ring of a map are than in the case, K, the balls by half of it.
    pub warmer_k: Vec<f64>,
}

impl SetQuestion {
    /// A question about a set alone, without loads of one's own and without a map.
    pub fn new(sides: Vec<bool>, preload: SetPreload) -> Self {
        Self { sides, preload, loads: Vec::new(), speeds_rpm: Vec::new(), warmer_k: Vec::new() }
    }
}

/// A set under one axial load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SetState {
    /// Axial load along +z, N.
    pub load_n: f64,
    /// Displacement from the unloaded set, m; in tandem from where its bearings touch.
    pub displacement_m: f64,
    /// Axial rigidity dF/dz, N/m.
    pub rigidity_n_per_m: f64,
    /// Axial force on each bearing, N.
    pub bearing_force_n: Vec<f64>,
}

/// A set in one condition.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SetCondition {
    /// Name of the condition.
    pub condition: &'static str,
    /// Speed, r/min.
    pub speed_rpm: f64,
    /// Preload, N: the smaller of what the sides carry without load.
    pub preload_n: f64,
    /// Axial rigidity without load, N/m.
    pub rigidity_n_per_m: f64,
    /// Loads along +z and −z under which the other side lifts off, N; absent where it never does.
    pub unloading_force_n: [Option<f64>; 2],
    /// Unloading forces over the preload.
    pub unloading_over_preload: [Option<f64>; 2],
}

/// A set at one speed and temperature of a map.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SetPoint {
    /// Speed, r/min.
    pub speed_rpm: f64,
    /// How much warmer shaft and inner ring are than in the case, K.
    pub warmer_k: f64,
    /// Preload, N.
    pub preload_n: f64,
    /// Axial rigidity without load, N/m.
    pub rigidity_n_per_m: f64,
    /// Loads along +z and −z under which the other side lifts off, N; absent where it never does.
    pub unloading_force_n: [Option<f64>; 2],
}

/// A set.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SetAnswer {
    /// How far each bearing is pressed in off the shaft, m.
    pub offset_m: Vec<f64>,
    /// Off the shaft, mounted, and at the speed and temperatures of the case, as far as they differ.
    pub conditions: Vec<SetCondition>,
    /// Over speed and temperature, as far as that was asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub map: Vec<SetPoint>,
    /// Under load, in the last of these conditions.
    pub states: Vec<SetState>,
    /// Sentences on what is unusual about the bearing that is pressed hardest, under the load that does it.
    pub warnings: Vec<String>,
}

/// Loads of a table, over the unloading force.
const STEPS: u32 = 10;
/// Load of a table for a set without unloading force, over the preload.
const OVER_PRELOAD: f64 = 3.0;

/// A bearing in one condition; the offset that mounting and heat add to that off the shaft, m.
struct Condition {
    name: &'static str,
    case: Case,
    bearing: Bearing,
    point: OperatingPoint,
    speed: f64,
    added: f64,
}

impl Condition {
    /// A case at a speed (rad/s); off the shaft its groove centres reach so far along the axis, m.
    fn new(name: &str, condition: &'static str, mut case: Case, speed: f64, reach: f64) -> Result<Self, StudyError> {
        case.speed.inner = tribodyn_bearing::SpeedHistory::Constant(speed);
        let failed = |source| AnswerError::Bearing { file: name.to_owned(), source };
        let bearing = case.bearing().map_err(failed)?;
        // Rings that grow bring the groove centres nearer at the same place along the axis.
        let geometry = &bearing.geometry;
        let added = reach - geometry.centre_distance() * geometry.sin_contact_angle();
        Ok(Self { name: condition, point: case.operating_point(), case, bearing, speed, added })
    }

    /// The bearing that a set presses hardest: its highest peak pressure, Pa, and its balls.
    fn hardest(&self, set: &AxialSet<'_>, state: &AxialState) -> (f64, Option<Solution>) {
        let of_spring = |index: &usize| set.spring.is_some() && !set.members[*index].carries_plus_z;
        let pressed = (0..set.members.len()).filter(|index| !of_spring(index));
        let deepest = pressed.map(|index| set.pressed(index, state.displacement)).fold(f64::NEG_INFINITY, f64::max);
        let ring = [0.0, 0.0, deepest, 0.0, 0.0];
        let solution = held_solution(&self.bearing, &self.point, ring);
        (held_pressure(&self.bearing, ring, solution.as_ref()), solution)
    }

    /// At rest the bearing is elastic.
    fn ring(&self) -> Box<dyn RingForce + '_> {
        match self.speed == 0.0 {
            true => Box::new(RestingBearing { bearing: &self.bearing, first_ball: 0.0 }),
            false => Box::new(TurningBearing::new(&self.bearing, &self.point, Model::JonesHarris)),
        }
    }

    fn set<'a>(&'a self, question: &SetQuestion, offsets: &[f64]) -> AxialSet<'a> {
        let members = question.sides.iter().map(|&carries_plus_z| Member { carries_plus_z, ring: self.ring() });
        AxialSet {
            members: members.collect(),
            offsets: offsets.iter().map(|offset| offset + self.added).collect(),
            spring: match question.preload {
                SetPreload::SpringN(force) => Some(force),
                _ => None,
            },
        }
    }
}

/// Preload, unloading force and rigidity of a set of bearings of a case, and its displacement under loads.
///
/// # Errors
/// [`StudyError::Shaft`] where nothing carries a load or a bearing has no equilibrium; a preload of bearings in tandem,
/// and loads under which no contact is elastic.
pub fn bearing_set(name: &str, case: &Case, question: &SetQuestion) -> Result<SetAnswer, StudyError> {
    arrangement::check(&question.sides, question.preload)?;
    let conditions = conditions(name, case)?;
    let offsets = offsets(name, &conditions, question)?;
    let mut answers = Vec::with_capacity(conditions.len());
    for condition in &conditions {
        let Unloaded { preload_n, rigidity_n_per_m, unloading_force_n } =
            Unloaded::of(name, condition, question, &offsets)?;
        answers.push(SetCondition {
            condition: condition.name,
            speed_rpm: condition.speed * RPM_PER_RAD_S,
            preload_n,
            rigidity_n_per_m,
            unloading_force_n,
            unloading_over_preload: unloading_force_n.map(|force| force.map(|force| force / preload_n)),
        });
    }
    let (Some(last), Some(answer)) = (conditions.last(), answers.last()) else { unreachable!("there is one at least") };
    let loads = if question.loads.is_empty() { table(answer, question) } else { question.loads.clone() };
    let (states, warnings) = states(name, last, question, (&offsets, &loads))?;
    let map = map(name, case, question, &offsets)?;
    Ok(SetAnswer { offset_m: offsets, conditions: answers, map, states, warnings })
}

fn failed(name: &str) -> impl Fn(ShaftError) -> StudyError {
    move |source| StudyError::Shaft { file: name.to_owned(), source }
}

/// How far each bearing is pressed in off the shaft, m.
fn offsets(name: &str, conditions: &[Condition], question: &SetQuestion) -> Result<Vec<f64>, StudyError> {
    let offsets = vec![0.0; question.sides.len()];
    let (condition, force) = match question.preload {
        SetPreload::OffsetM(offset) => return Ok(vec![offset; question.sides.len()]),
        SetPreload::SpringN(_) => return Ok(offsets),
        SetPreload::UnmountedN(force) => (&conditions[0], force),
        SetPreload::MountedN(force) => (conditions.iter().find(|c| c.name == MOUNTED).unwrap_or(&conditions[0]), force),
        SetPreload::RunningN(force) => (&conditions[conditions.len() - 1], force),
    };
    let mut set = condition.set(question, &offsets);
    // Bearings in tandem have none, and stand where they are drawn.
    if !arrangement::is_tandem(&question.sides) {
        set.preload(force).map_err(failed(name))?;
    }
    Ok(set.offsets.iter().map(|offset| offset - condition.added).collect())
}

/// A set without load.
struct Unloaded {
    preload_n: f64,
    rigidity_n_per_m: f64,
    unloading_force_n: [Option<f64>; 2],
}

impl Unloaded {
    fn of(name: &str, condition: &Condition, question: &SetQuestion, offsets: &[f64]) -> Result<Self, StudyError> {
        let mut set = condition.set(question, offsets);
        let state = set.unloaded().map_err(failed(name))?;
        elastic(name, condition.hardest(&set, &state).0)?;
        let preload_n = set.preload_force().map_err(failed(name))?;
        let unloading_force_n = if preload_n > 0.0 { set.unloading_forces().map_err(failed(name))? } else { [None; 2] };
        Ok(Self { preload_n, rigidity_n_per_m: state.stiffness, unloading_force_n })
    }
}

/// A set under loads, N, with what is unusual about the hardest pressed bearing.
fn states(
    name: &str,
    condition: &Condition,
    question: &SetQuestion,
    (offsets, loads): (&[f64], &[f64]),
) -> Result<(Vec<SetState>, Vec<String>), StudyError> {
    let mut set = condition.set(question, offsets);
    let rest = set.unloaded().map_err(failed(name))?.displacement;
    let mut states = Vec::with_capacity(loads.len());
    let mut hardest: Option<(f64, f64, Solution)> = None;
    for &load_n in loads {
        let state = set.under(load_n).map_err(failed(name))?;
        let (pressure, solution) = condition.hardest(&set, &state);
        elastic(&format!("{name}: {load_n} N along z"), pressure)?;
        if let Some(solution) = solution
            && hardest.as_ref().is_none_or(|(most, ..)| pressure > *most)
        {
            hardest = Some((pressure, load_n, solution));
        }
        states.push(SetState {
            load_n,
            displacement_m: state.displacement - rest,
            rigidity_n_per_m: state.stiffness,
            bearing_force_n: state.forces,
        });
    }
    let Some((_, load_n, solution)) = hardest else { return Ok((states, Vec::new())) };
    let found = solution_findings(&condition.case, &condition.bearing, &solution)
        .map_err(|source| AnswerError::Bearing { file: name.to_owned(), source })?;
    let named = |sentence: String| format!("under {load_n} N: {sentence}");
    Ok((states, found.sentences.into_iter().map(named).collect()))
}

/// The set over speeds and temperatures, at the offsets that it has off the shaft.
fn map(name: &str, case: &Case, question: &SetQuestion, offsets: &[f64]) -> Result<Vec<SetPoint>, StudyError> {
    let (mut speeds, mut rises) = (question.speeds_rpm.clone(), question.warmer_k.clone());
    match (speeds.is_empty(), rises.is_empty()) {
        (true, true) => return Ok(Vec::new()),
        (true, false) => speeds.push(case.operating_point().inner_speed * RPM_PER_RAD_S),
        (false, true) => rises.push(0.0),
        (false, false) => {}
    }
    if let Some(kelvin) = rises.iter().find(|kelvin| **kelvin != 0.0 && case.mounting.is_none()) {
        let why = "without fits or a section mounting no ring grows: give them";
        return Err(StudyError::argument("warmer", kelvin, why));
    }
    let reach = drawn_reach(name, case)?;
    let mut points = Vec::with_capacity(speeds.len() * rises.len());
    for &warmer_k in &rises {
        for &speed_rpm in &speeds {
            let condition = Condition::new(name, "", warmed(case, warmer_k), speed_rpm / RPM_PER_RAD_S, reach)?;
            let name = format!("{name} at {speed_rpm} r/min, {warmer_k} K warmer");
            let Unloaded { preload_n, rigidity_n_per_m, unloading_force_n } =
                Unloaded::of(&name, &condition, question, offsets)?;
            points.push(SetPoint { speed_rpm, warmer_k, preload_n, rigidity_n_per_m, unloading_force_n });
        }
    }
    Ok(points)
}

/// A case whose shaft and inner ring are warmer, and its balls by half of that.
fn warmed(case: &Case, kelvin: f64) -> Case {
    let mut case = case.clone();
    if let Some(mounting) = &mut case.mounting {
        mounting.ball.temperature_rise += 0.5 * kelvin;
        mounting.inner.temperature_rise += kelvin;
        if let Some(seat) = &mut mounting.inner.seat {
            seat.temperature_rise += kelvin;
        }
    }
    case
}

fn table(answer: &SetCondition, question: &SetQuestion) -> Vec<f64> {
    let spring = match question.preload {
        SetPreload::SpringN(force) => force,
        _ => 0.0,
    };
    let most = answer.unloading_force_n[0].unwrap_or(OVER_PRELOAD * answer.preload_n.max(spring));
    if most == 0.0 {
        return vec![0.0];
    }
    (0..=STEPS).map(|k| 1.2 * most * f64::from(k) / f64::from(STEPS)).collect()
}

/// Names of the conditions.
const OFF: &str = "off the shaft, at rest";
const MOUNTED: &str = "mounted, at rest";
const RUNNING: &str = "at speed and temperature";

fn conditions(name: &str, case: &Case) -> Result<Vec<Condition>, StudyError> {
    let lacking = |source| AnswerError::Lacking { file: name.to_owned(), source };
    case.require(tribodyn_case::Purpose::JonesHarris).map_err(lacking)?;
    let speed = case.operating_point().inner_speed;
    let reach = drawn_reach(name, case)?;
    let mut all = vec![Condition::new(name, OFF, unmounted(case), 0.0, reach)?];
    if case.mounting.is_some() {
        let mut cold = case.clone();
        if let Some(mounting) = &mut cold.mounting {
            mounting.ball.temperature_rise = 0.0;
            for ring in [&mut mounting.inner, &mut mounting.outer] {
                ring.temperature_rise = 0.0;
                if let Some(seat) = &mut ring.seat {
                    seat.temperature_rise = 0.0;
                }
            }
        }
        all.push(Condition::new(name, MOUNTED, cold, 0.0, reach)?);
    }
    if speed != 0.0 || case.mounting.is_some() {
        all.push(Condition::new(name, RUNNING, case.clone(), speed, reach)?);
    }
    Ok(all)
}

fn unmounted(case: &Case) -> Case {
    Case { mounting: None, ..case.clone() }
}

/// How far the groove centres of the bearing off the shaft are apart along the axis, m.
fn drawn_reach(name: &str, case: &Case) -> Result<f64, StudyError> {
    let drawn = unmounted(case).bearing().map_err(|source| AnswerError::Bearing { file: name.to_owned(), source })?;
    Ok(drawn.geometry.centre_distance() * drawn.geometry.sin_contact_angle())
}
