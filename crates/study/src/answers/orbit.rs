//! The steady orbit of a case: an answer, and where stiffness and modes start.

use crate::case_file::CaseFile;
use crate::error::StudyError;
use serde::Serialize;
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint};
use tribodyn_case::{Case, Purpose};
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
    /// That of a case, with the damping of its runs where it has one.
    ///
    /// # Errors
    /// A case without what traction needs, or without a cage.
    pub fn new(file: &CaseFile) -> Result<Self, StudyError> {
        let mut bearing = file.bearing_for(Purpose::Traction)?;
        let point = file.case.operating_point();
        bearing.contact_damping = contact_damping(&file.case);
        // The requirement of the traction model includes a cage, so that its absence is not met.
        let Some(cage) = file.case.moving_cage() else {
            return Err(StudyError::argument("model", "steady-orbit", format!("{} has no cage", file.name)));
        };
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

fn contact_damping(case: &Case) -> f64 {
    case.transient.as_ref().map_or(0.0, |transient| transient.contact_damping)
}

/// The orbit as `--json` prints it.
#[derive(Debug, Serialize)]
pub struct OrbitAnswer<'a> {
    model: &'static str,
    converged: bool,
    #[serde(flatten)]
    orbit: &'a SteadyOrbit,
    warnings: Vec<String>,
}

impl<'a> OrbitAnswer<'a> {
    /// Of an orbit that was found.
    pub fn new(orbit: &'a SteadyOrbit) -> Self {
        Self { model: "steady-orbit", converged: true, orbit, warnings: orbit.warnings() }
    }
}
