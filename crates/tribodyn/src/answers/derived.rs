//! Values that follow from a case before anything is solved.

use super::fits::{Fits, fits};
use super::flow::{HeatedFlowAnswer, fluid_warnings, phase};
use super::lubrication::lubrication;
use super::unsaid::{frozen_warning, geometry_warnings};
use super::{Equations, Question};
use crate::error::AnswerError;
use crate::plausibility::{self, StaticEstimate};
use crate::rating::{LEAST_LOAD, frequencies, rated_bearing, rating};
use serde::Serialize;
use std::collections::BTreeMap;
use tribodyn_bearing::{Bearing, BearingError, Geometry, OperatingPoint, Translation};
use tribodyn_case::{Case, Growths, Source};
use tribodyn_signal::BearingFrequencies;

/// The running bearing.
#[derive(Debug, Clone, Serialize)]
pub struct Derived {
    /// Name of the bearing.
    pub name: String,
    /// Free contact angle, degrees.
    pub contact_angle_deg: f64,
    /// Diametral clearance, m.
    pub radial_clearance_m: f64,
    /// Axial play, m.
    pub axial_play_m: f64,
    /// Groove radius over ball diameter, inner.
    pub groove_coefficient_inner: f64,
    /// The same, outer.
    pub groove_coefficient_outer: f64,
    /// Distance of the groove centres, m.
    pub groove_centre_distance_m: f64,
    /// Mass of a ball, kg.
    pub ball_mass_kg: f64,
    /// Moment of inertia of a ball, kg m².
    pub ball_inertia_kg_m2: f64,
    /// Load over approach to the power of 1.5 at the inner race, N/m^1.5.
    pub contact_stiffness_inner_n_per_m_1_5: f64,
    /// The same at the outer race.
    pub contact_stiffness_outer_n_per_m_1_5: f64,
    /// Semi-major over semi-minor axis of the contact at the inner race.
    pub ellipticity_inner: f64,
    /// The same at the outer race.
    pub ellipticity_outer: f64,
    /// Cage speed of balls that roll at the free contact angle, r/min.
    pub cage_speed_free_rpm: f64,
    /// Frequencies of defects of balls that roll at the nominal contact angle, 0 in a deep-groove bearing, Hz; absent
    /// at rest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frequencies: Option<BearingFrequencies>,
    /// Drag on a ball at that speed, N; absent without a fluid.
    pub drag_per_ball_n: Option<f64>,
    /// Moments of the fluid on both faces, on the bore and on the outside of the cage at that speed, N m; absent
    /// without a fluid and without `cage.churning`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cage_churning_nm: Option<[f64; 3]>,
    /// Density of liquid and vapour, kg/m³; absent without a fluid.
    pub effective_fluid_density_kg_m3: Option<f64>,
    /// Phase of the cryogen at the case's temperature and pressure; absent for another fluid and without one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fluid_phase: Option<String>,
    /// State of a flow that takes up the heat of the bearing; absent where it was not asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heated_flow: Option<HeatedFlowAnswer>,
    /// Lubrication of the bearing, in a line.
    pub lubrication: String,
    /// Basic dynamic load rating C_r, N; absent for a bearing that the standards do not rate.
    pub dynamic_rating_n: Option<f64>,
    /// Basic static load rating C_0r, N.
    pub static_rating_n: Option<f64>,
    /// Radial load, N; absent where the ring is held along x, y or z, like all that follows from loads.
    pub radial_load_n: Option<f64>,
    /// Axial load, N.
    pub axial_load_n: Option<f64>,
    /// Least load so that balls roll, by a rule of thumb, 0.01 C_r, N; absent for a bearing that the standards do not
    /// rate.
    pub minimum_load_n: Option<f64>,
    /// Static safety s_0 = C_0r/P_0; absent without load.
    pub static_safety: Option<f64>,
    /// Life of a charge of grease that nine of ten bearings reach, an estimate, hours; absent without grease.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grease_life_hours: Option<f64>,
    /// Peak pressure of the hardest pressed ball by a first estimate, Pa.
    pub peak_pressure_estimate_pa: Option<f64>,
    /// Pitch diameter times the speed of the rings against each other, mm r/min.
    pub pitch_speed_mm_rpm: f64,
    /// Growth by fits and speed; absent where the case asks for none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub growth: Option<GrowthAnswer>,
    /// Fits by tolerance class, and the clearance over their range; absent where no seat has a class.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fits: Option<Fits>,
    /// Where the values of the case come from, by path.
    pub sources: BTreeMap<String, Source>,
    /// Notes on the datum of the axial position.
    pub notes: Vec<String>,
    /// Sentences on what is unusual or beyond what was tested.
    pub warnings: Vec<String>,
}

/// The bearing of the drawing, mounted and running; the fields of [`Derived`] are those of the running one.
#[derive(Debug, Clone, Serialize)]
pub struct GrowthAnswer {
    /// Contact angle of the drawing, degrees.
    pub contact_angle_drawn_deg: f64,
    /// Mounted, at rest, degrees.
    pub contact_angle_mounted_deg: f64,
    /// At speed, degrees.
    pub contact_angle_running_deg: f64,
    /// Diametral clearance of the drawing, m.
    pub radial_clearance_drawn_m: f64,
    /// Mounted, at rest, m.
    pub radial_clearance_mounted_m: f64,
    /// At speed, m.
    pub radial_clearance_running_m: f64,
    /// Growth of the radius of the inner raceway, m.
    pub raceway_growth_inner_m: f64,
    /// The same of the outer raceway, m.
    pub raceway_growth_outer_m: f64,
    /// Pressure in the seat of the inner ring, Pa; absent without a fit.
    pub seat_pressure_inner_pa: Option<f64>,
    /// The same of the outer ring.
    pub seat_pressure_outer_pa: Option<f64>,
}

/// Derived geometry, masses, contact constants and fluid forces of a case.
///
/// # Errors
/// A case that makes no bearing.
pub fn derived(question: &Question<'_>) -> Result<Derived, AnswerError> {
    let bearing = question.bearing()?;
    let growth = growth(question.case).map_err(|source| question.not_usable(source.into()))?;
    let fits = fits(question.case).map_err(|source| question.not_usable(source.into()))?;
    Ok(answer(question, &bearing, (growth, fits)))
}

/// A number with so many decimals, without the sign of a zero.
fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    match text.strip_prefix('-') {
        Some(magnitude) if magnitude.bytes().all(|byte| matches!(byte, b'0' | b'.')) => magnitude.to_owned(),
        _ => text,
    }
}

fn growth(case: &Case) -> Result<Option<GrowthAnswer>, BearingError> {
    let drawn = case.geometry.resolve()?;
    let Some(Growths { mounted, running }) = case.growths()? else { return Ok(None) };
    let degrees = |geometry: &Geometry| geometry.contact_angle().to_degrees();
    Ok(Some(GrowthAnswer {
        contact_angle_drawn_deg: degrees(&drawn),
        contact_angle_mounted_deg: degrees(&mounted.geometry),
        contact_angle_running_deg: degrees(&running.geometry),
        radial_clearance_drawn_m: drawn.radial_clearance(),
        radial_clearance_mounted_m: mounted.geometry.radial_clearance(),
        radial_clearance_running_m: running.geometry.radial_clearance(),
        raceway_growth_inner_m: running.raceway_growth.inner,
        raceway_growth_outer_m: running.raceway_growth.outer,
        seat_pressure_inner_pa: running.seat_pressure.inner,
        seat_pressure_outer_pa: running.seat_pressure.outer,
    }))
}

/// Where z = 0 is, and what a held axial position means.
fn notes(case: &Case, bearing: &Bearing) -> Vec<String> {
    let half = 0.5e6 * bearing.geometry.axial_play();
    let datum = format!(
        "axial position z = 0: the balls just touch both races without load, {} µm from the middle of the axial play",
        number(half, 1)
    );
    let mut notes = vec![datum];
    if bearing.geometry.contact_angle() == 0.0 {
        notes.push("the free contact angle is 0: under thrust it grows with the load".to_owned());
    }
    if let Translation::Held(z) = case.ring.z
        && half > 0.0
    {
        notes.push(format!(
            "the ring is held at z = {} µm: from z = 0 on every ball bears on one side; for a bearing that floats in its play take the middle, z = Held(um({}))",
            number(z * 1e6, 3),
            number(-half, 1)
        ));
    }
    notes
}

/// A warning of drag (N on each ball) that takes more than 100 kW at an orbital speed, rad/s.
fn costly_drag(g: &Geometry, orbit: f64, drag: f64) -> Option<String> {
    let power = drag * g.ball_count as f64 * orbit.abs() * 0.5 * g.pitch_diameter;
    (power > 1e5).then(|| {
        format!(
            "drag of {drag:.0} N on each ball takes {:.0} kW from the shaft: check drag coefficient and liquid fraction",
            power * 1e-3
        )
    })
}

/// Moments of the fluid on the faces, the bore and the outside of the cage at a speed, rad/s, N m.
fn churned(bearing: &Bearing, point: &OperatingPoint, speed: f64) -> Option<[f64; 3]> {
    let swirl = bearing.fluid.as_ref()?.swirl;
    let moments = point.cage?.churning(bearing)?.moments(speed - swirl * point.inner_speed);
    Some([moments.faces, moments.bore, moments.outside])
}

fn answer(question: &Question<'_>, bearing: &Bearing, (growth, fits): (Option<GrowthAnswer>, Option<Fits>)) -> Derived {
    let case = question.case;
    let g = &bearing.geometry;
    let point = case.operating_point();
    let (inner, outer) = (bearing.races.inner.frozen::<f64>(), bearing.races.outer.frozen::<f64>());
    // No-slip orbit at the free contact angle: the speed at which drag is quoted.
    let gamma = g.ball_diameter * g.cos_contact_angle() / g.pitch_diameter;
    let orbit = 0.5 * (point.inner_speed * (1.0 - gamma) + point.outer_speed * (1.0 + gamma));
    let turning = (point.inner_speed - point.outer_speed).abs();
    let mut warnings = plausibility::of_case(case, (question.text, bearing));
    let drag =
        bearing.fluid.as_ref().map(|f| f.drag.force(0.5 * g.pitch_diameter * (orbit - f.swirl * point.inner_speed)));
    warnings.extend(drag.and_then(|drag| costly_drag(g, orbit, drag)));
    warnings.extend(fluid_warnings(case));
    warnings.extend(geometry_warnings(case, bearing));
    warnings.extend(frozen_warning(question, bearing));
    let estimate = plausibility::estimate(case, bearing);
    let of_load = |of: fn(&StaticEstimate) -> f64| estimate.as_ref().map(of);
    let unloaded = estimate.is_some_and(|found| found.ball_load_n == 0.0);
    warnings.extend(unloaded.then(|| plausibility::NO_LOAD.to_owned()));
    let rated = rating(case, None).ok();
    let nominal = rated_bearing(case).contact_angle;
    Derived {
        name: case.name.clone(),
        contact_angle_deg: g.contact_angle().to_degrees(),
        radial_clearance_m: g.radial_clearance(),
        axial_play_m: g.axial_play(),
        groove_coefficient_inner: g.inner_coefficient,
        groove_coefficient_outer: g.outer_coefficient,
        groove_centre_distance_m: g.centre_distance(),
        ball_mass_kg: bearing.ball_mass,
        ball_inertia_kg_m2: bearing.ball_inertia,
        contact_stiffness_inner_n_per_m_1_5: inner.stiffness(),
        contact_stiffness_outer_n_per_m_1_5: outer.stiffness(),
        ellipticity_inner: inner.ellipticity,
        ellipticity_outer: outer.ellipticity,
        cage_speed_free_rpm: orbit * 30.0 / std::f64::consts::PI,
        frequencies: frequencies(&case.geometry, nominal, [point.inner_speed, point.outer_speed]),
        drag_per_ball_n: drag,
        cage_churning_nm: churned(bearing, &point, orbit),
        effective_fluid_density_kg_m3: bearing.fluid.as_ref().map(|f| f.drag.density_effective),
        fluid_phase: phase(case).map(|phase| phase.to_string()),
        heated_flow: None,
        lubrication: lubrication(case, Equations::usual(case)),
        dynamic_rating_n: rated.as_ref().map(|rated| rated.dynamic_rating_n),
        static_rating_n: rated.as_ref().map(|rated| rated.static_rating_n),
        radial_load_n: of_load(|found| found.radial_load_n),
        axial_load_n: of_load(|found| found.axial_load_n),
        minimum_load_n: rated.as_ref().map(|rated| LEAST_LOAD * rated.dynamic_rating_n),
        static_safety: estimate.and_then(|found| found.static_safety),
        grease_life_hours: rated.as_ref().and_then(|rated| rated.grease_life_hours),
        peak_pressure_estimate_pa: of_load(|found| found.peak_pressure_pa),
        pitch_speed_mm_rpm: turning * 30.0 / std::f64::consts::PI * g.pitch_diameter * 1e3,
        growth,
        fits,
        sources: case.sources.clone(),
        notes: notes(case, bearing),
        warnings,
    }
}
