//! The steady orbit of a case: an answer, and where stiffness and modes start.

use super::{Equations, Lives};
use crate::case_file::CaseFile;
use crate::error::StudyError;
use crate::plausibility;
use serde::{Serialize, Serializer};
use tribodyn_bearing::quantities::Fields;
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint};
use tribodyn_case::{Case, InputError, Purpose};
use tribodyn_dynamics::StartMotion;
use tribodyn_orbit::{OrbitError, OrbitSettings, SolvedOrbit, SteadyOrbit, steady_orbit};
use tribodyn_quasistatic::Solution;

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
    /// That of a case file.
    ///
    /// # Errors
    /// A case without what traction needs.
    pub fn new(file: &CaseFile) -> Result<Self, StudyError> {
        Self::of(&file.case).map_err(|source| file.not_usable(source))
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

    /// The motion of the orbit at an instant, for a run to start from.
    ///
    /// # Errors
    /// [`OrbitError`]; of a standstill there is no orbit.
    pub(crate) fn motion(&self) -> Result<StartMotion, OrbitError> {
        let SolvedOrbit { solution: orbit, start, .. } =
            steady_orbit(&self.bearing, &self.point, &self.cage, &self.settings)?;
        let solution = orbit.as_solution(&orbit.balls, [self.point.inner_speed, self.point.outer_speed]);
        let start = start.ok_or(OrbitError::AtRest)?;
        Ok(StartMotion { motion: start.motion(orbit.balls.len()), rule: start.rule(), solution })
    }

    /// The orbit.
    ///
    /// # Errors
    /// [`StudyError::Orbit`].
    pub fn solve(&self, file: &CaseFile) -> Result<SolvedOrbit, StudyError> {
        let failed = |source| StudyError::Orbit { file: file.name.clone(), source };
        steady_orbit(&self.bearing, &self.point, &self.cage, &self.settings).map_err(failed)
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
}

impl OrbitAnswer {
    /// The steady orbit of a case.
    ///
    /// # Errors
    /// A case without what traction needs, or an orbit that is not found.
    pub fn of(file: &CaseFile) -> Result<Self, StudyError> {
        let problem = OrbitProblem::new(file)?;
        let orbit = problem.solve(file)?.solution;
        let speeds = [problem.point.inner_speed, problem.point.outer_speed];
        let mut round = orbit.as_solution(&orbit.points, speeds);
        let found = plausibility::of_solution(&file.case, (&file.text, &problem.bearing), &round);
        let found = found.map_err(|source| StudyError::Bearing { file: file.name.clone(), source })?;
        round.warnings.extend(found.warnings(Equations::SteadyOrbit));
        let solution = Solution { balls: orbit.balls.clone(), ..round.clone() };
        let lives = Lives::of(&file.case, &solution);
        Ok(Self { orbit, solution, round, lives })
    }
}

/// An orbit as `solve --json` prints it.
#[derive(Serialize)]
struct Printed<'a> {
    #[serde(flatten)]
    solution: &'a Solution,
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
    swing_damping: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ball_mass_factor: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pocket_stiffness_share: Option<f64>,
    points: Vec<Fields<'a>>,
}

impl Serialize for OrbitAnswer {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let orbit = &self.orbit;
        let [inner, outer] = orbit.friction_w;
        let printed = Printed {
            solution: &self.solution,
            lives: self.lives,
            power_loss_inner_w: inner,
            power_loss_outer_w: outer,
            power_loss_fluid_w: orbit.fluid_w,
            power_loss_pocket_w: orbit.pocket_w,
            pocket_force_max_n: orbit.pocket_force_max_n,
            pocket_contact_azimuths_deg: &orbit.pocket_contact_azimuths_deg,
            intervals: orbit.intervals,
            swing_damping: orbit.swing_damping,
            ball_mass_factor: orbit.ball_mass_factor,
            pocket_stiffness_share: orbit.pocket_stiffness_share,
            points: orbit.points.iter().map(Fields).collect(),
        };
        printed.serialize(serializer)
    }
}
