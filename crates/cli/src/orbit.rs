//! The steady orbit as an answer: of `solve --model steady-orbit`, and where `stiffness` and `modes` start.

use crate::failure::Failure;
use crate::input::ReplaceArguments;
use crate::table::{self, number};
use serde::Serialize;
use std::path::Path;
use tribodyn_bearing::{BallResult, Bearing, CageBody, OperatingPoint};
use tribodyn_case::{Case, Purpose};
use tribodyn_orbit::{OrbitSettings, SolvedOrbit, SteadyOrbit, steady_orbit};
use tribodyn_quasistatic::Solution;
use tribodyn_study::{CaseFile, Ours, StagedFiles, StudyError};

/// A bearing with its cage at an operating point.
pub struct Problem {
    pub bearing: Bearing,
    pub point: OperatingPoint,
    pub cage: CageBody,
    pub settings: OrbitSettings,
}

impl Problem {
    /// That of a case, with the damping of its runs where it has one.
    pub fn new(file: &CaseFile) -> Result<Self, Failure> {
        let mut bearing = file.bearing_for(Purpose::Traction)?;
        let point = file.case.operating_point();
        bearing.contact_damping = contact_damping(&file.case);
        let Some(cage) = file.case.moving_cage() else { return Err(no_cage(file)) };
        let settings = OrbitSettings { tolerance: point.numerics.tolerance, ..OrbitSettings::default() };
        Ok(Self { cage: CageBody::new(&cage, &bearing), bearing, point, settings })
    }

    /// The orbit with a ball at each of its nodes.
    pub fn round(&self, file: &CaseFile) -> Result<Solution, Failure> {
        let orbit = self.solve(file)?.solution;
        Ok(orbit.as_solution(&orbit.points, [self.point.inner_speed, self.point.outer_speed]))
    }

    pub fn solve(&self, file: &CaseFile) -> Result<SolvedOrbit, Failure> {
        let failed = |source| StudyError::Orbit { file: file.name.clone(), source };
        Ok(steady_orbit(&self.bearing, &self.point, &self.cage, &self.settings).map_err(failed)?)
    }
}

fn contact_damping(case: &Case) -> f64 {
    case.transient.as_ref().map_or(0.0, |transient| transient.contact_damping)
}

/// The requirement of the traction model includes a cage, so that this is not met.
fn no_cage(file: &CaseFile) -> Failure {
    let message = format!("{} has no cage", file.name);
    Failure::Option { option: "model", value: "steady-orbit".to_owned(), message }
}

/// The orbit as `--json` prints it.
#[derive(Serialize)]
struct Answer<'a> {
    model: &'static str,
    converged: bool,
    #[serde(flatten)]
    orbit: &'a SteadyOrbit,
    warnings: Vec<String>,
}

pub fn print_json(orbit: &SteadyOrbit) -> Result<(), Failure> {
    table::print_json(&Answer { model: "steady-orbit", converged: true, orbit, warnings: orbit.warnings() })
}

/// Summary and balls; `rows` prints the table of balls.
pub fn print(
    name: &str,
    s: &SteadyOrbit,
    rows: impl FnOnce(&[BallResult]) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let triple = |v: [f64; 3], factor: f64, digits: usize| v.map(|c| number(c * factor, digits)).join("  ");
    let contacts = s.pocket_contact_azimuths_deg.iter().map(|a| number(*a, 1)).collect::<Vec<_>>();
    let mut pairs = vec![
        ("cage speed", number(s.cage_speed_rpm, 3), "r/min"),
        ("ring displacement x y z", triple(s.ring_displacement_m, 1e6, 3), "µm"),
        ("ring tilt about x y", s.ring_tilt_rad.map(|t| number(t * 1e3, 4)).join("  "), "mrad"),
        ("ring load x y z", triple(s.ring_load_n, 1.0, 2), "N"),
        ("shaft torque", number(s.shaft_torque_nm, 3), "N m"),
        ("friction of inner, outer contacts", s.friction_w.map(|w| number(w, 2)).join("  "), "W"),
        ("drag and churning", number(s.fluid_w, 2), "W"),
        ("friction in the pockets", number(s.pocket_w, 3), "W"),
        ("largest pocket force", number(s.pocket_force_max_n, 2), "N"),
    ];
    if !contacts.is_empty() {
        pairs.push(("balls meet their pockets at", contacts.join("  "), "°"));
    }
    pairs.push(("largest relative residual", format!("{:.1e}", s.residual), ""));
    pairs.push(("patch error estimate (of load)", format!("{:.1e}", s.patch_error_estimate), ""));
    table::print_line(&format!("{name}\n"))?;
    table::print_pairs(&pairs)?;
    table::print_line("")?;
    rows(&s.balls)?;
    for warning in s.warnings() {
        table::print_line(&format!("warning: {warning}"))?;
    }
    Ok(())
}

/// Writes a table under a temporary name first; it may not replace the case, nor a file of others unasked.
pub fn write_table(path: &Path, case: &Path, text: &str, replace: &ReplaceArguments) -> Result<(), Failure> {
    replace.check(path, case, Ours::Table)?;
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
        let message = "allowed is the path of a file".to_owned();
        return Err(Failure::Option { option: "csv", value: path.display().to_string(), message });
    };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut staged = StagedFiles::new(folder, replace.force)?;
    staged.write(name.to_owned(), text.as_bytes())?;
    Ok(staged.publish()?)
}
