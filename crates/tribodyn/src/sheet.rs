//! One bearing under one load on one page: life, safety, deflection, stiffness, torque, frequencies, limits.

use crate::answers::{Fits, Question, by_formulas, fits, solved};
use crate::error::AnswerError;
use crate::plausibility::{self, NO_LOAD, little_thrust};
use crate::rating::{LEAST_LOAD, Rating, RatingSource, boundaries, loaded_contacts, rating};
use serde::Serialize;
use std::f64::consts::PI;
use tribodyn_bearing::{Bearing, SearchWatch, SpeedHistory, Tilt, Translation};
use tribodyn_case::{Case, RingSpec, SPEED_MAX};
use tribodyn_quasistatic::{Model, QuasiStaticError, Solution, StiffnessMatrix, jones_harris_stiffness};

/// Loads and speed of a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetQuestion {
    /// Radial load, N.
    pub radial: f64,
    /// Axial load, N; negative along −z.
    pub axial: f64,
    /// Speed of the inner ring, rad/s.
    pub speed: f64,
}

/// All that is asked of a bearing first.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sheet {
    /// Name of the bearing.
    pub name: String,
    /// Number of balls.
    pub ball_count: usize,
    /// Their diameter, m.
    pub ball_diameter_m: f64,
    /// Pitch diameter, m.
    pub pitch_diameter_m: f64,
    /// Bore, m.
    pub bore_m: f64,
    /// Where it comes from.
    pub bore_source: RatingSource,
    /// Radial internal clearance in operation, m.
    pub radial_clearance_m: f64,
    /// Fits by tolerance class, and the clearance over their range; absent where no seat has a class.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fits: Option<Fits>,
    /// Radial load, N.
    pub radial_load_n: f64,
    /// Axial load, N.
    pub axial_load_n: f64,
    /// Speed of the inner ring, r/min.
    pub speed_rpm: f64,
    /// Ratings, equivalent loads, lives, safety.
    pub rating: Rating,
    /// Displacement of the inner ring under the load: x, y, z, m; z from where the balls just touch on the side of the
    /// axial load.
    pub ring_displacement_m: [f64; 3],
    /// Moment that keeps the rings aligned, N m.
    pub tilting_moment_nm: f64,
    /// Stiffness of the inner ring at this load, by rows: N, N m over m, rad.
    pub stiffness: StiffnessMatrix,
    /// Balls that carry load on the inner race.
    pub loaded_balls: usize,
    /// Largest load of a ball on the inner race, N.
    pub ball_load_max_n: f64,
    /// Least and largest contact angle of the loaded balls on the inner race, rad; absent without load.
    pub contact_angle_rad: Option<[f64; 2]>,
    /// Friction torque by a rule of thumb, M = ½ µ P d with the bore d, N m; absent without load.
    pub friction_torque_estimate_nm: Option<f64>,
    /// Power of it, W; absent without load.
    pub friction_power_estimate_w: Option<f64>,
    /// Friction torque in the lubricant by SKF's model, without seals, N m; absent without a lubricant and at rest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub skf_torque_nm: Option<f64>,
    /// The same by Palmgren's formula, N m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub palmgren_torque_nm: Option<f64>,
    /// Pitch diameter times speed, mm r/min.
    pub speed_factor_mm_rpm: f64,
    /// Warnings.
    pub warnings: Vec<String>,
}

const RPM_PER_RAD_S: f64 = 30.0 / PI;
/// Coefficients of friction of the rule M = ½ µ P d for good lubrication and P ≈ C/10: deep-groove and angular-contact
/// bearings in the makers' catalogues.
const FRICTION: [f64; 2] = [0.0015, 0.0020];
/// Largest equivalent load over C_r for which the life formula stands (ISO 281).
const LARGEST_LOAD: f64 = 0.5;

/// The sheet of a case under loads.
///
/// # Errors
/// A speed beyond those of case files, loads beyond what the bearing carries, a bearing that has no equilibrium there,
/// or that the standards do not rate.
pub fn sheet(name: &str, case: &Case, question: &SheetQuestion) -> Result<Sheet, AnswerError> {
    let speed_rpm = question.speed * RPM_PER_RAD_S;
    if question.speed.abs() > SPEED_MAX {
        let most = SPEED_MAX * RPM_PER_RAD_S;
        let allowed = format!("allowed is up to {most:.0} r/min either way");
        return Err(AnswerError::argument("speed", format!("{speed_rpm:.0}"), allowed));
    }
    let case = loaded(case, question);
    let asked = Question { name, text: "", case: &case, watch: SearchWatch::default() };
    let (bearing, solved) = solved(&asked, Model::JonesHarris).map_err(|error| unheld(&asked, error))?;
    let solution = solved.solution;
    let failed = |source| AnswerError::Solver { file: name.to_owned(), source };
    let stiffness = jones_harris_stiffness(&bearing, &asked.point()).map_err(failed)?;
    let is_loaded = plausibility::is_loaded(&bearing, &solution);
    let rating = rated(&asked, &solution, is_loaded)?;
    let balls = if is_loaded { loaded_contacts(&solution) } else { Vec::new() };
    let angles = balls.iter().map(|contact| [contact.angle_rad; 2]);
    let [(bore_m, bore_source), _] = boundaries(&case);
    let friction = FRICTION[usize::from(rating.nominal_contact_angle_deg > 0.0)];
    let torque = rating.equivalent_load_n.filter(|_| is_loaded).map(|load| 0.5 * friction * load * bore_m);
    let [skf_torque_nm, palmgren_torque_nm] = lubricated_torque(&asked, question)?;
    let geometry = &bearing.geometry;
    Ok(Sheet {
        warnings: warnings(&asked, (&bearing, &solution), &rating, is_loaded)?,
        fits: fits(&case).map_err(|source| asked.not_usable(source.into()))?,
        ball_count: geometry.ball_count,
        ball_diameter_m: geometry.ball_diameter,
        pitch_diameter_m: geometry.pitch_diameter,
        bore_m,
        bore_source,
        radial_clearance_m: geometry.radial_clearance(),
        radial_load_n: question.radial,
        axial_load_n: question.axial,
        speed_rpm,
        ring_displacement_m: from_touching(&solution, question.axial, geometry.axial_play()),
        tilting_moment_nm: solution.ring_moment_nm[0].hypot(solution.ring_moment_nm[1]),
        stiffness,
        loaded_balls: balls.len(),
        ball_load_max_n: balls.iter().map(|contact| contact.load_n).fold(0.0, f64::max),
        contact_angle_rad: angles.reduce(|[low, high], [angle, _]| [low.min(angle), high.max(angle)]),
        friction_torque_estimate_nm: torque,
        friction_power_estimate_w: torque.map(|torque| torque * question.speed.abs()),
        skf_torque_nm,
        palmgren_torque_nm,
        speed_factor_mm_rpm: geometry.pitch_diameter * 1e3 * speed_rpm.abs(),
        rating,
        name: case.name,
    })
}

/// Ratings and lives; of a bearing without load only what it has all the same.
fn rated(asked: &Question<'_>, solution: &Solution, is_loaded: bool) -> Result<Rating, AnswerError> {
    let refused = |source| AnswerError::Rating { file: asked.name.to_owned(), source };
    let rating = rating(asked.case, Some(solution)).map_err(refused)?;
    Ok(if is_loaded { rating } else { rating.unloaded() })
}

/// The error of a bearing that has no equilibrium, with the reason where its thrust is too little.
fn unheld(asked: &Question<'_>, error: AnswerError) -> AnswerError {
    let lost = matches!(
        error,
        AnswerError::Solver {
            source: QuasiStaticError::NotConverged { .. } | QuasiStaticError::NoLoadedBall { .. },
            ..
        }
    );
    let why = lost.then(|| little_thrust(asked.case)).flatten();
    why.map_or(error, |why| AnswerError::not_asked(asked.name, &why))
}

/// Displacement of the inner ring, m, its z from where the balls just touch on the side of the axial load (N).
fn from_touching(solution: &Solution, axial: f64, play: f64) -> [f64; 3] {
    let [x, y, z] = solution.ring_displacement_m;
    [x, y, if axial < 0.0 { z + play } else { z }]
}

/// Friction torques by SKF's and Palmgren's formulas; absent at rest.
fn lubricated_torque(asked: &Question<'_>, sheet: &SheetQuestion) -> Result<[Option<f64>; 2], AnswerError> {
    if sheet.speed == 0.0 { Ok([None; 2]) } else { by_formulas(asked, [sheet.radial, sheet.axial], sheet.speed) }
}

/// The case under the loads of the question, its rings aligned.
fn loaded(case: &Case, question: &SheetQuestion) -> Case {
    let ring = RingSpec {
        x: Translation::Force(question.radial),
        y: Translation::Force(0.0),
        z: Translation::Force(question.axial),
        tilt_x: Tilt::Held(0.0),
        tilt_y: Tilt::Held(0.0),
    };
    // The sheet tells nothing of the cage.
    let mut case = Case { ring, cage: None, ..case.clone() };
    case.speed.inner = SpeedHistory::Constant(question.speed);
    case
}

/// All that must be known of the numbers.
fn warnings(
    asked: &Question<'_>,
    (bearing, solution): (&Bearing, &Solution),
    rating: &Rating,
    is_loaded: bool,
) -> Result<Vec<String>, AnswerError> {
    let found = plausibility::solution_findings(asked.case, bearing, solution);
    let found = found.map_err(|source| asked.not_usable(source.into()))?;
    let mut warnings = if is_loaded { limits(rating) } else { vec![NO_LOAD.to_owned()] };
    warnings.extend(rating.warnings.iter().cloned());
    warnings.extend(plausibility::speed_finding(asked.case, bearing));
    warnings.extend(found.sentences);
    Ok(warnings)
}

fn limits(rating: &Rating) -> Vec<String> {
    let mut warnings = Vec::new();
    let over = rating.equivalent_load_n.map(|load| load / rating.dynamic_rating_n);
    if let Some(over) = over.filter(|over| *over > LARGEST_LOAD) {
        warnings.push(format!("the equivalent load is {over:.2} C_r: the life formula stands up to 0.5 C_r"));
    }
    if let Some(over) = over.filter(|over| *over < LEAST_LOAD) {
        warnings.push(format!("the equivalent load is {over:.4} C_r: below 0.01 C_r balls slide instead of rolling"));
    }
    if let Some(safety) = rating.static_safety.filter(|safety| *safety < 1.0) {
        warnings.push(format!("the static safety is {safety:.2}: below 1 the races are dented for good"));
    }
    if let Some(pressure) = rating.peak_pressure_max_pa.filter(|pressure| *pressure > 4.2e9) {
        let pressure = pressure * 1e-9;
        warnings.push(format!("the peak pressure is {pressure:.2} GPa: above 4.2 GPa races yield"));
    }
    warnings
}
