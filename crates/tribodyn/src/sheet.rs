//! One bearing under one load on one page: life, safety, deflection, stiffness, torque, frequencies, limits.

use crate::answers::{Fits, Question, by_formulas, fits};
use crate::error::AnswerError;
use crate::plausibility::solution_findings;
use crate::rating::{LEAST_LOAD, Rating, loaded_contacts, rating};
use serde::Serialize;
use std::f64::consts::PI;
use tribodyn_bearing::{SpeedHistory, Tilt, Translation};
use tribodyn_case::{Case, Purpose, RingSpec};
use tribodyn_quasistatic::{Model, StiffnessMatrix, jones_harris_stiffness, solve};

/// Loads and speed of a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetQuestion {
    /// Radial load, N.
    pub radial: f64,
    /// Axial load, N.
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
    /// Displacement of the inner ring under the load: x, y, z, m; z from where the balls just touch.
    pub ring_displacement_m: [f64; 3],
    /// Moment that keeps the rings aligned, N m.
    pub tilting_moment_nm: f64,
    /// Stiffness of the inner ring at this load, by rows: N, N m over m, rad.
    pub stiffness: StiffnessMatrix,
    /// Balls that carry load on the inner race.
    pub loaded_balls: usize,
    /// Largest load of a ball on the inner race, N.
    pub ball_load_max_n: f64,
    /// Least and largest contact angle of the loaded balls on the inner race, rad.
    pub contact_angle_rad: [f64; 2],
    /// Friction torque by a rule of thumb, N m; absent without load.
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
/// Speed factor up to which grease is usual, mm r/min.
const GREASE: f64 = 500_000.0;

/// The sheet of a case under loads.
///
/// # Errors
/// A bearing that has no equilibrium there, or that the standards do not rate.
pub fn sheet(name: &str, case: &Case, question: &SheetQuestion) -> Result<Sheet, AnswerError> {
    let case = loaded(case, question);
    let file = || name.to_owned();
    case.require(Purpose::JonesHarris).map_err(|source| AnswerError::Lacking { file: file(), source })?;
    let bearing = case.bearing().map_err(|source| AnswerError::Bearing { file: file(), source })?;
    let point = case.operating_point();
    let failed = |source| AnswerError::Solver { file: file(), source };
    let solution = solve(&bearing, &point, Model::JonesHarris).map_err(failed)?.solution;
    let stiffness = jones_harris_stiffness(&bearing, &point).map_err(failed)?;
    let rating = rating(&case, Some(&solution)).map_err(|source| AnswerError::Rating { file: file(), source })?;
    let loaded = loaded_contacts(&solution);
    let most = loaded.iter().map(|contact| contact.load_n).fold(0.0, f64::max);
    let angles = loaded.iter().map(|contact| contact.angle_rad);
    let range = angles.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], a| [low.min(a), high.max(a)]);
    let fits = fits(&case).map_err(|source| AnswerError::Bearing { file: file(), source })?;
    let geometry = &bearing.geometry;
    let angular = rating.nominal_contact_angle_deg > 0.0;
    let bore = geometry.pitch_diameter - 2.0 * geometry.ball_diameter;
    let torque = rating.equivalent_load_n.map(|load| 0.5 * FRICTION[usize::from(angular)] * load * bore);
    let [skf_torque_nm, palmgren_torque_nm] = lubricated_torque(name, &case, question)?;
    let speed_rpm = question.speed * RPM_PER_RAD_S;
    let speed_factor_mm_rpm = geometry.pitch_diameter * 1e3 * speed_rpm.abs();
    let mut warnings = limits(&rating, speed_factor_mm_rpm);
    let found = solution_findings(&case, &bearing, &solution);
    warnings.extend(found.map_err(|source| AnswerError::Bearing { file: file(), source })?.sentences);
    Ok(Sheet {
        name: case.name,
        ball_count: geometry.ball_count,
        ball_diameter_m: geometry.ball_diameter,
        pitch_diameter_m: geometry.pitch_diameter,
        radial_clearance_m: geometry.radial_clearance(),
        fits,
        radial_load_n: question.radial,
        axial_load_n: question.axial,
        speed_rpm,
        ring_displacement_m: solution.ring_displacement_m,
        tilting_moment_nm: solution.ring_moment_nm[0].hypot(solution.ring_moment_nm[1]),
        stiffness,
        loaded_balls: loaded.len(),
        ball_load_max_n: most,
        contact_angle_rad: if loaded.is_empty() { [0.0; 2] } else { range },
        friction_torque_estimate_nm: torque,
        friction_power_estimate_w: torque.map(|torque| torque * question.speed.abs()),
        skf_torque_nm,
        palmgren_torque_nm,
        speed_factor_mm_rpm,
        rating,
        warnings,
    })
}

/// Friction torques by SKF's and Palmgren's formulas; absent at rest.
fn lubricated_torque(name: &str, case: &Case, sheet: &SheetQuestion) -> Result<[Option<f64>; 2], AnswerError> {
    if sheet.speed == 0.0 {
        return Ok([None; 2]);
    }
    let watch = tribodyn_bearing::SearchWatch::default();
    by_formulas(&Question { name, text: "", case, watch }, [sheet.radial, sheet.axial], sheet.speed)
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

fn limits(rating: &Rating, speed_factor: f64) -> Vec<String> {
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
    if speed_factor > GREASE {
        warnings
            .push(format!("pitch diameter times speed is {speed_factor:.0} mm r/min: above 500000 grease is unusual"));
    }
    warnings
}
