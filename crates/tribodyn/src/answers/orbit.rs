//! The steady orbit of a case: an answer, and where stiffness and modes start.

use super::findings::Beside;
use super::limited::limited;
use super::sensitivity::{Sensitivity, sensitivities};
use super::{Equations, Findings, Lives, Question};
use crate::error::AnswerError;
use serde::{Serialize, Serializer};
use tribodyn_bearing::quantities::Fields;
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint};
use tribodyn_case::{Case, InputError, Purpose};
use tribodyn_orbit::{
    OrbitSettings, OrbitStart, SolvedOrbit, SteadyOrbit, cold_rule, less_damped_orbit, steady_orbit, steady_orbit_near,
};
use tribodyn_quasistatic::Solution;

/// Looks of the search for an orbit with less damping, more than most cold starts take.
const LOOKS: usize = 2000;

/// A bearing with its cage at an operating point.
pub struct OrbitProblem {
    /// The bearing, with the damping of its runs.
    pub bearing: Bearing,
    /// Loads and speeds.
    pub point: OperatingPoint,
    /// The cage that turns.
    pub cage: CageBody,
    /// Tolerances of the solver.
    pub settings: OrbitSettings,
}

impl OrbitProblem {
    /// That of a question, its searches linked to the asker.
    ///
    /// # Errors
    /// A case without what traction needs.
    pub fn new(question: &Question<'_>) -> Result<Self, AnswerError> {
        let mut problem = Self::of(question.case).map_err(|source| question.not_usable(source))?;
        problem.point.watch = question.watch.clone();
        question.bearable(&problem.bearing)?;
        Ok(problem)
    }

    /// That of a case, with the damping of its runs where it has one.
    ///
    /// # Errors
    /// [`InputError::Lacking`] for a case without what traction needs, a cage among it; [`InputError::Bearing`].
    pub fn of(case: &Case) -> Result<Self, InputError> {
        case.require(Purpose::Traction)?;
        let Some(cage) = case.moving_cage() else { unreachable!("traction needs a cage") };
        let mut bearing = case.bearing()?;
        let point = case.operating_point();
        bearing.contact_damping = case.transient.as_ref().map_or(0.0, |transient| transient.contact_damping);
        let settings = OrbitSettings { tolerance: point.numerics.tolerance, ..OrbitSettings::default() };
        Ok(Self { cage: CageBody::new(&cage, &bearing), bearing, point, settings })
    }

    /// The orbit; `name` is that of the case in messages.
    ///
    /// # Errors
    /// [`AnswerError::Orbit`].
    pub fn solve(&self, name: &str) -> Result<SolvedOrbit, AnswerError> {
        let failed = |source| AnswerError::Orbit { file: name.to_owned(), source };
        steady_orbit(&self.bearing, &self.point, &self.cage, &self.settings).map_err(failed)
    }

    /// The orbit from that of a neighbour, by the patch rule of a cold start; none where such a start is as short. The
    /// neighbour's rule would change the torque: its error is one of the load, of which friction is a small part.
    pub fn beside(&self, near: OrbitStart) -> Option<SolvedOrbit> {
        let Self { bearing, point, cage, settings } = self;
        let near = near.by_rule(cold_rule(bearing, point, settings).ok()?);
        steady_orbit_near(bearing, point, cage, settings, &near).ok()?
    }
}

/// A steady orbit, with what stands beside it in an answer.
#[derive(Debug, Clone)]
pub struct OrbitAnswer {
    /// The motion.
    pub orbit: SteadyOrbit,
    /// The balls where those of an equilibrium stand, in the form of one, with all warnings.
    pub solution: Solution,
    /// A ball round its orbit, in the same form.
    pub round: Solution,
    /// Under the loads of the balls where they stand; absent for a bearing that the standards do not rate.
    pub lives: Option<Lives>,
    /// Findings on it; its warnings are those of the solutions too.
    pub findings: Findings,
    /// How far it rests on assumed values, as far as that was asked for.
    pub sensitivities: Vec<Sensitivity>,
}

impl OrbitAnswer {
    /// The steady orbit of a case.
    ///
    /// # Errors
    /// A case without what traction needs, or an orbit that is not found.
    pub fn of(question: &Question<'_>) -> Result<Self, AnswerError> {
        Self::with_start(question, None).map(|(_, answer, _)| answer)
    }

    /// The same with its sensitivities to assumed values, the leading ones among the warnings, and with what it changes
    /// that a search damps the pockets.
    ///
    /// # Errors
    /// As [`Self::of`].
    pub fn with_sensitivities(question: &Question<'_>) -> Result<Self, AnswerError> {
        let (problem, mut answer, start) = Self::with_start(question, None)?;
        if let Some(start) = start.filter(|_| answer.findings.loaded()) {
            answer.sensitivities = sensitivities(question.case, (&problem, &start));
            let torque = answer.orbit.shaft_torque_nm;
            let assumed = answer.sensitivities.iter().filter_map(|found| found.warning(torque));
            let warnings: Vec<String> = assumed.chain(less_damped(&problem, (&mut answer.orbit, &start))).collect();
            for warning in warnings {
                answer.findings = answer.findings.with(warning.clone());
                answer.solution.warnings.push(warning.clone());
                answer.round.warnings.push(warning);
            }
        }
        Ok(answer)
    }

    /// The same, from the orbit of a neighbour where one is given, with its problem, and with what neighbours and
    /// linearisations begin with; a bearing at rest has none.
    pub(crate) fn with_start(
        question: &Question<'_>,
        near: Option<&OrbitStart>,
    ) -> Result<(OrbitProblem, Self, Option<OrbitStart>), AnswerError> {
        let problem = OrbitProblem::new(question)?;
        let solved = near.and_then(|near| problem.beside(near.clone()));
        let solved = solved.map_or_else(|| problem.solve(question.name), Ok);
        let SolvedOrbit { solution: orbit, start, .. } = solved?;
        let answer = Self::answer(question, &problem, orbit)?;
        Ok((problem, answer, start))
    }

    fn answer(question: &Question<'_>, problem: &OrbitProblem, orbit: SteadyOrbit) -> Result<Self, AnswerError> {
        let mut round = orbit.as_solution(&orbit.points, [problem.point.inner_speed, problem.point.outer_speed]);
        let findings = Findings::of(question, &problem.bearing, (Equations::SteadyOrbit, &round))?;
        round.warnings = findings.warnings().to_vec();
        let solution = Solution { balls: orbit.balls.clone(), ..round.clone() };
        let lives = Lives::of(question.case, &solution, findings.loaded());
        Ok(Self { orbit, solution, round, lives, findings, sensitivities: Vec::new() })
    }
}

/// Effect of the pocket damping that the search has raised, as a sentence where it is worth one.
fn less_damped(problem: &OrbitProblem, (orbit, start): (&mut SteadyOrbit, &OrbitStart)) -> Option<String> {
    orbit.raised_pocket_damping_s_per_m?;
    let OrbitProblem { bearing, point, cage, settings } = problem;
    let found = less_damped_orbit(bearing, &limited(point, LOOKS), cage, settings, start);
    orbit.less_damped = found.ok().flatten();
    orbit.damping_sentence()
}

/// An orbit as `solve --json` prints it.
#[derive(Serialize)]
struct Printed<'a> {
    #[serde(flatten)]
    solution: &'a Solution,
    #[serde(flatten)]
    beside: Beside,
    #[serde(flatten)]
    lives: Option<Lives>,
    power_loss_inner_w: f64,
    power_loss_outer_w: f64,
    power_loss_fluid_w: f64,
    power_loss_pocket_w: f64,
    pocket_force_max_n: f64,
    pocket_contact_azimuths_deg: &'a [f64],
    intervals: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    mesh_error: Option<f64>,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pocket_force_unresolved: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    swing_damping: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ball_mass_factor: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pocket_stiffness_share: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    raised_contact_damping: Option<f64>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    sensitivities: &'a [Sensitivity],
    points: Vec<Fields<'a>>,
}

impl Serialize for OrbitAnswer {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let orbit = &self.orbit;
        let [inner, outer] = orbit.friction_w;
        let printed = Printed {
            solution: &self.solution,
            beside: self.findings.beside(),
            lives: self.lives,
            power_loss_inner_w: inner,
            power_loss_outer_w: outer,
            power_loss_fluid_w: orbit.fluid_w,
            power_loss_pocket_w: orbit.pocket_w,
            pocket_force_max_n: orbit.pocket_force_max_n,
            pocket_contact_azimuths_deg: &orbit.pocket_contact_azimuths_deg,
            intervals: orbit.intervals,
            mesh_error: orbit.mesh_error,
            pocket_force_unresolved: orbit.pocket_force_unresolved,
            swing_damping: orbit.swing_damping,
            ball_mass_factor: orbit.ball_mass_factor,
            pocket_stiffness_share: orbit.pocket_stiffness_share,
            raised_contact_damping: orbit.raised_contact_damping,
            sensitivities: &self.sensitivities,
            points: orbit.points.iter().map(Fields).collect(),
        };
        printed.serialize(serializer)
    }
}
