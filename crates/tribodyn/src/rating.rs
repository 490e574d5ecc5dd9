//! Rating life and static safety of a case: the formulas of `tribodyn-rating` on its catalogue numbers and its
//! solution.

use crate::plausibility::case_loads;
use serde::Serialize;
use tribodyn_bearing::{ContactResult, Side};
use tribodyn_case::{Case, Fit, GeometrySpec};
use tribodyn_lubricant::{GreaseLife, GreasedBearing, Supply};
use tribodyn_quasistatic::Solution;
use tribodyn_rating::{
    BallLoads, Lubrication, PERMISSIBLE_PRESSURE, RatedBearing, RatingError, ReferenceLife, Turning, basic_life_mrev,
    hours, life_modification_factor, reference_viscosity, reliability_factor,
};
use tribodyn_signal::BearingFrequencies;

/// Least equivalent load over C_r for ball bearings, a rule of thumb of SKF's catalogue (requisite minimum load): below
/// it balls slide.
pub(crate) const LEAST_LOAD: f64 = 0.01;

/// Section D − d over ball diameter of a usual bearing.
const SECTION: f64 = 3.3;

/// Where a load rating or a dimension comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RatingSource {
    /// From the catalogue, by the case.
    Catalogue,
    /// Computed from balls and grooves, ratings by ISO 281 and ISO 76.
    Computed,
}

/// Ratings and lives of a bearing under the loads of a solution, or of its case where there is no solution.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Rating {
    /// Nominal contact angle of the formulas, degrees.
    pub nominal_contact_angle_deg: f64,
    /// Basic dynamic load rating C_r, N.
    pub dynamic_rating_n: f64,
    /// Where it comes from.
    pub dynamic_rating_source: RatingSource,
    /// Basic static load rating C_0r, N.
    pub static_rating_n: f64,
    /// Where it comes from.
    pub static_rating_source: RatingSource,
    /// Fatigue load limit C_u, N.
    pub fatigue_load_limit_n: f64,
    /// Where it comes from.
    pub fatigue_load_limit_source: RatingSource,
    /// Radial load F_r, N; absent for a held ring without a solution.
    pub radial_load_n: Option<f64>,
    /// Axial load F_a, N.
    pub axial_load_n: Option<f64>,
    /// Dynamic equivalent load P = X F_r + Y F_a, N.
    pub equivalent_load_n: Option<f64>,
    /// Basic rating life L_10 = (C_r/P)³, 10⁶ revolutions; absent without load.
    pub rating_life_l10_mrev: Option<f64>,
    /// Equivalent load of the load distribution P_ref, N; absent without a solution.
    pub reference_load_n: Option<f64>,
    /// Basic reference rating life L_10r of the load distribution, 10⁶ revolutions; absent without load.
    pub rating_life_l10r_mrev: Option<f64>,
    /// Life modification factor a_ISO; absent where the case does not give the lubrication.
    pub life_modification_factor: Option<f64>,
    /// Viscosity ratio κ of the lubricant; absent where the case does not give the lubrication, and at rest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub viscosity_ratio: Option<f64>,
    /// Contamination factor e_C; absent where the case does not give it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contamination_factor: Option<f64>,
    /// The reason why a_ISO is not worked out; among [`Self::warnings`] too.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lubrication_note: Option<String>,
    /// Life factor for reliability a_1.
    pub reliability_factor: f64,
    /// Modified reference rating life L_nmr, 10⁶ revolutions; absent where the case does not give the lubrication.
    pub rating_life_lnmr_mrev: Option<f64>,
    /// Hours at the speed of the case: of L_nmr where there is one, else of a_1 L_10r; absent at rest.
    pub rating_life_hours: Option<f64>,
    /// Life of a charge of grease that nine of ten bearings reach, an estimate, hours; absent without grease and where
    /// its formula does not reach.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grease_life_hours: Option<f64>,
    /// The same that 99 of 100 reach, the relubrication interval.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grease_interval_hours: Option<f64>,
    /// Why a greased bearing has no estimate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grease_note: Option<String>,
    /// Static equivalent load P_0, N.
    pub static_equivalent_load_n: Option<f64>,
    /// Static safety s_0 = C_0r/P_0; absent without load.
    pub static_safety: Option<f64>,
    /// Highest peak pressure of all contacts, Pa; absent without a solution.
    pub peak_pressure_max_pa: Option<f64>,
    /// Load that would bring it to 4.2 GPa over the load there is; absent without load.
    pub pressure_safety: Option<f64>,
    /// Frequencies of defects, of balls that roll at the mean contact angle of the loaded ones, Hz; absent at rest and
    /// without a solution.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frequencies: Option<BearingFrequencies>,
    /// Sentences on where these numbers do not hold; they are among the warnings of the answer.
    #[serde(skip)]
    pub warnings: Vec<String>,
}

impl Rating {
    /// Without what a bearing that carries nothing does not have.
    #[must_use]
    pub fn unloaded(self) -> Self {
        Self {
            rating_life_l10_mrev: None,
            reference_load_n: None,
            rating_life_l10r_mrev: None,
            life_modification_factor: None,
            rating_life_lnmr_mrev: None,
            rating_life_hours: None,
            static_safety: None,
            peak_pressure_max_pa: None,
            pressure_safety: None,
            lubrication_note: None,
            frequencies: None,
            warnings: Vec::new(),
            ..self
        }
    }
}

/// Reference life, peak pressure and relative speed of the rings by the ball loads of a solution.
struct Distribution {
    reference: ReferenceLife,
    peak_pressure: f64,
    relative_speed: f64,
}

/// Ratings and lives of a case under the ball loads of one of its solutions, or under its loads alone.
///
/// # Errors
/// [`RatingError`] for a bearing that the standards do not rate.
pub fn rating(case: &Case, solution: Option<&Solution>) -> Result<Rating, RatingError> {
    let spec = case.rating.unwrap_or_default();
    let rated = rated_bearing(case);
    let (dynamic, dynamic_source) = rated_or(spec.dynamic, || rated.dynamic_rating())?;
    let (at_rest, static_source) = rated_or(spec.static_load, || rated.static_rating())?;
    let (limit, limit_source) = rated_or(spec.fatigue_limit, || rated.fatigue_load_limit(at_rest))?;
    let loads = match solution.map(|solution| solution.ring_load_n) {
        Some([x, y, z]) => Some([x.hypot(y), z.abs()]),
        None => case_loads(case),
    };
    let equivalent = loads.map(|[radial, axial]| rated.equivalent_load(radial, axial)).transpose()?;
    let static_load = loads.map(|[radial, axial]| rated.static_equivalent_load(radial, axial)).transpose()?;
    let distribution = solution.map(|solution| distribution(&rated, dynamic, solution)).transpose()?;
    let reference = distribution.as_ref().map(|found| &found.reference);
    let reliability = reliability_factor(spec.reliability.unwrap_or(90.0))?;
    let reference_load = reference.map(|reference| reference.equivalent_load);
    let (viscosity_ratio, contamination) = lubrication(case, solution)?;
    let too_thin = viscosity_ratio.filter(|ratio| *ratio < KAPPA_MIN);
    let thick = viscosity_ratio.filter(|_| too_thin.is_none());
    let lubrication_note = too_thin.map(thin_film);
    let beyond = loads.map(|[_, axial]| rated.beyond_table(axial)).transpose()?.flatten();
    let modification = modification(thick, contamination, (limit, reference_load))?;
    let life = reference.and_then(|reference| reference.life_mrev);
    let modified = modification.zip(life).map(|(factor, life)| reliability * factor * life);
    let counted = modified.or(life.map(|life| reliability * life));
    let (grease, grease_note) = grease_life(case, solution, equivalent.map(|load| load / dynamic));
    let (relative_speed, peak) = distribution.as_ref().map(|found| (found.relative_speed, found.peak_pressure)).unzip();
    Ok(Rating {
        nominal_contact_angle_deg: rated.contact_angle.to_degrees(),
        dynamic_rating_n: dynamic,
        dynamic_rating_source: dynamic_source,
        static_rating_n: at_rest,
        static_rating_source: static_source,
        fatigue_load_limit_n: limit,
        fatigue_load_limit_source: limit_source,
        radial_load_n: loads.map(|loads| loads[0]),
        axial_load_n: loads.map(|loads| loads[1]),
        equivalent_load_n: equivalent,
        rating_life_l10_mrev: equivalent.and_then(|load| basic_life_mrev(dynamic, load)),
        reference_load_n: reference_load,
        rating_life_l10r_mrev: life,
        life_modification_factor: modification,
        viscosity_ratio,
        contamination_factor: contamination,
        warnings: lubrication_note.iter().cloned().chain(beyond.map(beyond_table)).collect(),
        lubrication_note,
        reliability_factor: reliability,
        rating_life_lnmr_mrev: modified,
        rating_life_hours: counted.zip(relative_speed).and_then(|(life, speed)| hours(life, speed)),
        grease_life_hours: grease.map(|grease| grease.life),
        grease_interval_hours: grease.map(|grease| grease.interval),
        grease_note,
        static_equivalent_load_n: static_load,
        static_safety: static_load.filter(|load| *load > 0.0).map(|load| at_rest / load),
        peak_pressure_max_pa: peak,
        pressure_safety: peak.filter(|peak| *peak > 0.0).map(|peak| (PERMISSIBLE_PRESSURE / peak).powi(3)),
        frequencies: solution.and_then(|solution| frequencies_loaded(case, solution)),
    })
}

/// Contacts of the inner race that carry load, as part of the largest load.
const LOADED: f64 = 1e-6;

/// Contacts on the inner race that carry load.
pub(crate) fn loaded_contacts(solution: &Solution) -> Vec<ContactResult> {
    let inner = solution.balls.iter().map(|ball| ball.contacts.inner);
    let most = inner.clone().map(|contact| contact.load_n).fold(0.0, f64::max);
    inner.filter(|contact| contact.load_n > LOADED * most).collect()
}

/// Frequencies of defects of balls that roll at the mean contact angle of the loaded ones.
fn frequencies_loaded(case: &Case, solution: &Solution) -> Option<BearingFrequencies> {
    let loaded = loaded_contacts(solution);
    let sum: f64 = loaded.iter().map(|contact| contact.angle_rad).sum();
    frequencies(&case.geometry, sum / loaded.len() as f64, [solution.inner_speed_rad_s, solution.outer_speed_rad_s])
}

/// Frequencies of defects of balls that roll at a contact angle, rad, between rings of these speeds, rad/s; none for
/// rings that do not turn against each other.
pub(crate) fn frequencies(spec: &GeometrySpec, angle: f64, [inner, outer]: [f64; 2]) -> Option<BearingFrequencies> {
    let GeometrySpec { ball_count, ball_diameter, pitch_diameter, .. } = *spec;
    let found = BearingFrequencies::from_geometry(ball_count, ball_diameter, pitch_diameter, angle, inner, outer);
    found.ok().filter(|_| inner != outer)
}

/// a_ISO under a load (N) with a fatigue load limit (N), where all that it needs is known.
fn modification(
    viscosity_ratio: Option<f64>,
    contamination: Option<f64>,
    (limit, load): (f64, Option<f64>),
) -> Result<Option<f64>, RatingError> {
    match (viscosity_ratio, contamination, load.filter(|load| *load > 0.0)) {
        (Some(viscosity_ratio), Some(contamination), Some(load)) => {
            life_modification_factor(Lubrication { viscosity_ratio, contamination }, limit, load).map(Some)
        }
        _ => Ok(None),
    }
}

/// Viscosity ratio and contamination factor, as far as the case tells them.
fn lubrication(case: &Case, solution: Option<&Solution>) -> Result<(Option<f64>, Option<f64>), RatingError> {
    let spec = case.rating.unwrap_or_default();
    let viscosity_ratio = match spec.viscosity_ratio {
        Some(ratio) => Some(ratio),
        None => solution.map(|solution| viscosity_ratio(case, solution)).transpose()?.flatten(),
    };
    let pitch = case.geometry.pitch_diameter;
    Ok((viscosity_ratio, spec.contamination.or(spec.cleanliness.map(|class| class.contamination(pitch)))))
}

fn thin_film(ratio: f64) -> String {
    format!("the viscosity ratio is {ratio:.3}: ISO 281 has a_ISO from 0.1 on, below it count on wear")
}

fn beyond_table([relative, last]: [f64; 2]) -> String {
    format!(
        "the relative axial load F_a/(Z D²) is {relative:.1} N/mm² and ISO 281's table ends at {last}: Y is its last \
         value, and what the axial load adds to P is beyond the table"
    )
}

fn distribution(rated: &RatedBearing, dynamic: f64, solution: &Solution) -> Result<Distribution, RatingError> {
    let loads = Side::BOTH.map(|side| solution.balls.iter().map(|b| b.contacts[side].load_n).collect::<Vec<_>>());
    let turning = Turning::of_speeds(solution.inner_speed_rad_s, solution.outer_speed_rad_s);
    let reference = rated.reference_life(dynamic, &BallLoads { inner: &loads[0], outer: &loads[1], turning })?;
    let pressures = solution.balls.iter().flat_map(|b| Side::BOTH.map(|side| b.contacts[side].peak_pressure_pa));
    Ok(Distribution {
        reference,
        peak_pressure: pressures.fold(0.0, f64::max),
        relative_speed: solution.inner_speed_rad_s - solution.outer_speed_rad_s,
    })
}

/// The static load rating C_0r of a case, N: of the catalogue, or by ISO 76.
///
/// # Errors
/// [`RatingError`] for a bearing that the standard does not rate.
pub fn static_rating(case: &Case) -> Result<f64, RatingError> {
    rated_or(case.rating.unwrap_or_default().static_load, || rated_bearing(case).static_rating())
        .map(|(value, _)| value)
}

/// Life of the grease of a bearing under P/C, or why there is none; neither without grease or a load, nor at rest.
fn grease_life(
    case: &Case,
    solution: Option<&Solution>,
    load_share: Option<f64>,
) -> (Option<GreaseLife>, Option<String>) {
    let greased = case.lubricant.as_ref().filter(|lubricant| lubricant.supply == Supply::Grease);
    let (Some(lubricant), Some(load_share)) = (greased, load_share) else { return (None, None) };
    let speed = match solution {
        Some(solution) => solution.inner_speed_rad_s - solution.outer_speed_rad_s,
        None => case.operating_point().inner_speed - case.operating_point().outer_speed,
    };
    if speed == 0.0 {
        return (None, None);
    }
    let [(bore, _), _] = boundaries(case);
    match (GreasedBearing { bore, speed, temperature: lubricant.temperature, load_share }).life() {
        Ok(life) => (Some(life), None),
        Err(error) => (None, Some(format!("no estimate of the life of the grease: {error}"))),
    }
}

/// Bore and outside diameter of a case's bearing, m: of the catalogue, or those of a usual section of its balls.
pub(crate) fn boundaries(case: &Case) -> [(f64, RatingSource); 2] {
    let (spec, geometry) = (case.rating.unwrap_or_default(), &case.geometry);
    let half_section = 0.5 * SECTION * geometry.ball_diameter;
    let or = |given: Option<f64>, usual| {
        given.map_or((usual, RatingSource::Computed), |given| (given, RatingSource::Catalogue))
    };
    [or(spec.bore, geometry.pitch_diameter - half_section), or(spec.outside, geometry.pitch_diameter + half_section)]
}

/// The same, with a note where one of them is estimated, m.
pub(crate) fn noted_boundaries(case: &Case, notes: &mut Vec<String>) -> [f64; 2] {
    let both = boundaries(case);
    if both.iter().any(|(_, source)| *source == RatingSource::Computed) {
        notes.push("bore and outside diameter estimated: give rating.bore and rating.outside".to_owned());
    }
    both.map(|(diameter, _)| diameter)
}

/// Least viscosity ratio for which ISO 281 has a_ISO.
const KAPPA_MIN: f64 = 0.1;

/// κ = ν/ν_1 of the case's lubricant at the speed of the rings against each other; absent without one or at rest.
fn viscosity_ratio(case: &Case, solution: &Solution) -> Result<Option<f64>, RatingError> {
    let Some(lubricant) = &case.lubricant else { return Ok(None) };
    let speed = solution.inner_speed_rad_s - solution.outer_speed_rad_s;
    // A case with an oil that is none is refused when it is read.
    let (Ok(oil), true) = (lubricant.oil.oil(), speed != 0.0) else { return Ok(None) };
    let reference = reference_viscosity(speed, case.geometry.pitch_diameter)?;
    Ok(Some(oil.viscosity.kinematic(lubricant.temperature) / reference))
}

fn rated_or(
    given: Option<f64>,
    computed: impl FnOnce() -> Result<f64, RatingError>,
) -> Result<(f64, RatingSource), RatingError> {
    match given {
        Some(value) => Ok((value, RatingSource::Catalogue)),
        None => Ok((computed()?, RatingSource::Computed)),
    }
}

/// The bearing of the drawing as the standards see it. Its contact angle is nominal: 0 where the case gives a
/// clearance.
pub(crate) fn rated_bearing(case: &Case) -> RatedBearing {
    let contact_angle = case.rating.and_then(|spec| spec.contact_angle).unwrap_or(match case.geometry.fit {
        Fit::ContactAngle(angle) => angle,
        Fit::RadialClearance(_) => 0.0,
    });
    let [inner_coefficient, outer_coefficient] = case.geometry.coefficients();
    RatedBearing {
        ball_count: case.geometry.ball_count,
        ball_diameter: case.geometry.ball_diameter,
        pitch_diameter: case.geometry.pitch_diameter,
        contact_angle,
        inner_coefficient,
        outer_coefficient,
    }
}
