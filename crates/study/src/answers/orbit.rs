//! The steady orbit of a case: an answer, and where stiffness and modes start.

use super::Equations;
use crate::case_file::CaseFile;
use crate::error::StudyError;
use crate::plausibility;
use serde::Serialize;
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint};
use tribodyn_case::{Case, InputError, Purpose};
use tribodyn_orbit::{OrbitSettings, SolvedOrbit, SteadyOrbit, steady_orbit};
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

    /// The orbit with a ball at each of its nodes, in the form of an equilibrium.
    ///
    /// # Errors
    /// [`StudyError::Orbit`].
    pub fn round(&self, file: &CaseFile) -> Result<Solution, StudyError> {
        let orbit = self.solve(file)?.solution;
        Ok(orbit.as_solution(&orbit.points, [self.point.inner_speed, self.point.outer_speed]))
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

/// Warnings on an orbit: those of its own, what is unusual about it and its case, and whether that can be meant.
///
/// # Errors
/// [`StudyError::Bearing`] where the case has no geometry.
pub fn orbit_warnings(file: &CaseFile, problem: &OrbitProblem, orbit: &SteadyOrbit) -> Result<Vec<String>, StudyError> {
    let speeds = [problem.point.inner_speed, problem.point.outer_speed];
    let round = orbit.as_solution(&orbit.points, speeds);
    let found = plausibility::of_solution(&file.case, (&file.text, &problem.bearing), &round);
    let found = found.map_err(|source| StudyError::Bearing { file: file.name.clone(), source })?;
    Ok(orbit.warnings().into_iter().chain(found.warnings(Equations::SteadyOrbit)).collect())
}

/// The orbit as `--json` prints it.
#[derive(Debug, Serialize)]
pub struct OrbitAnswer<'a> {
    model: &'static str,
    converged: bool,
    #[serde(flatten)]
    orbit: &'a SteadyOrbit,
    warnings: &'a [String],
}

impl<'a> OrbitAnswer<'a> {
    /// Of an orbit that was found, with its warnings.
    pub fn new(orbit: &'a SteadyOrbit, warnings: &'a [String]) -> Self {
        Self { model: Equations::SteadyOrbit.name(), converged: true, orbit, warnings }
    }
}
