//! Rating life and static safety of a case: the formulas of `tribodyn-rating` on its catalogue numbers and its
//! solution.

use serde::Serialize;
use tribodyn_bearing::Side;
use tribodyn_case::{Case, Fit, RatingSpec};
use tribodyn_quasistatic::Solution;
use tribodyn_rating::{
    BallLoads, Lubrication, PERMISSIBLE_PRESSURE, RatedBearing, RatingError, Turning, basic_life_mrev, hours,
    life_modification_factor, reliability_factor,
};

/// Where a load rating comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RatingSource {
    /// From the catalogue, by the case.
    Catalogue,
    /// Computed by ISO 281 or ISO 76 from balls and grooves.
    Computed,
}

/// Ratings and lives of a bearing under the loads of a solution.
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
    /// Radial load F_r of the solution, N.
    pub radial_load_n: f64,
    /// Axial load F_a of the solution, N.
    pub axial_load_n: f64,
    /// Dynamic equivalent load P = X F_r + Y F_a, N.
    pub equivalent_load_n: f64,
    /// Basic rating life L_10 = (C_r/P)³, 10⁶ revolutions; absent without load.
    pub rating_life_l10_mrev: Option<f64>,
    /// Equivalent load of the load distribution P_ref, N.
    pub reference_load_n: f64,
    /// Basic reference rating life L_10r of the load distribution, 10⁶ revolutions; absent without load.
    pub rating_life_l10r_mrev: Option<f64>,
    /// Life modification factor a_ISO; absent where the case does not give the lubrication.
    pub life_modification_factor: Option<f64>,
    /// Life factor for reliability a_1.
    pub reliability_factor: f64,
    /// Modified reference rating life L_nmr, 10⁶ revolutions; absent where the case does not give the lubrication.
    pub rating_life_lnmr_mrev: Option<f64>,
    /// Hours at the speed of the case: of L_nmr where there is one, else of a_1 L_10r; absent at rest.
    pub rating_life_hours: Option<f64>,
    /// Static equivalent load P_0, N.
    pub static_equivalent_load_n: f64,
    /// Static safety s_0 = C_0r/P_0; absent without load.
    pub static_safety: Option<f64>,
    /// Highest peak pressure of all contacts, Pa.
    pub peak_pressure_max_pa: f64,
    /// Load that would bring it to 4.2 GPa over the load there is; absent without load.
    pub pressure_safety: Option<f64>,
}

/// Ratings and lives of a case under the ball loads of one of its solutions.
///
/// # Errors
/// [`RatingError`] for a bearing that the standards do not rate.
pub fn rating(case: &Case, solution: &Solution) -> Result<Rating, RatingError> {
    let spec = case.rating.unwrap_or_default();
    let rated = rated_bearing(case, &spec)?;
    let (dynamic, dynamic_source) = rated_or(spec.dynamic, || rated.dynamic_rating())?;
    let (at_rest, static_source) = rated_or(spec.static_load, || rated.static_rating())?;
    let (limit, limit_source) = rated_or(spec.fatigue_limit, || rated.fatigue_load_limit(at_rest))?;
    let [x, y, z] = solution.ring_load_n;
    let (radial, axial) = (x.hypot(y), z.abs());
    let equivalent = rated.equivalent_load(radial, axial)?;
    let loads = Side::BOTH.map(|side| solution.balls.iter().map(|b| b.contacts[side].load_n).collect::<Vec<_>>());
    let turning = Turning::of_speeds(solution.inner_speed_rad_s, solution.outer_speed_rad_s);
    let reference = rated.reference_life(dynamic, &BallLoads { inner: &loads[0], outer: &loads[1], turning })?;
    let reliability = reliability_factor(spec.reliability.unwrap_or(90.0))?;
    let modification = match (spec.viscosity_ratio, spec.contamination) {
        (Some(viscosity_ratio), Some(contamination)) if reference.equivalent_load > 0.0 => {
            let film = Lubrication { viscosity_ratio, contamination };
            Some(life_modification_factor(film, limit, reference.equivalent_load)?)
        }
        _ => None,
    };
    let modified = modification.zip(reference.life_mrev).map(|(factor, life)| reliability * factor * life);
    let counted = modified.or(reference.life_mrev.map(|life| reliability * life));
    let relative_speed = solution.inner_speed_rad_s - solution.outer_speed_rad_s;
    let static_load = rated.static_equivalent_load(radial, axial)?;
    let pressures = solution.balls.iter().flat_map(|b| Side::BOTH.map(|side| b.contacts[side].peak_pressure_pa));
    let peak = pressures.fold(0.0, f64::max);
    Ok(Rating {
        nominal_contact_angle_deg: rated.contact_angle.to_degrees(),
        dynamic_rating_n: dynamic,
        dynamic_rating_source: dynamic_source,
        static_rating_n: at_rest,
        static_rating_source: static_source,
        fatigue_load_limit_n: limit,
        fatigue_load_limit_source: limit_source,
        radial_load_n: radial,
        axial_load_n: axial,
        equivalent_load_n: equivalent,
        rating_life_l10_mrev: basic_life_mrev(dynamic, equivalent),
        reference_load_n: reference.equivalent_load,
        rating_life_l10r_mrev: reference.life_mrev,
        life_modification_factor: modification,
        reliability_factor: reliability,
        rating_life_lnmr_mrev: modified,
        rating_life_hours: counted.and_then(|life| hours(life, relative_speed)),
        static_equivalent_load_n: static_load,
        static_safety: (static_load > 0.0).then_some(at_rest / static_load),
        peak_pressure_max_pa: peak,
        pressure_safety: (peak > 0.0).then_some((PERMISSIBLE_PRESSURE / peak).powi(3)),
    })
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
fn rated_bearing(case: &Case, spec: &RatingSpec) -> Result<RatedBearing, RatingError> {
    let contact_angle = spec.contact_angle.unwrap_or(match case.geometry.fit {
        Fit::ContactAngle(angle) => angle,
        Fit::RadialClearance(_) => 0.0,
    });
    let [inner_coefficient, outer_coefficient] = case.geometry.coefficients();
    Ok(RatedBearing {
        ball_count: case.geometry.ball_count,
        ball_diameter: case.geometry.ball_diameter,
        pitch_diameter: case.geometry.pitch_diameter,
        contact_angle,
        inner_coefficient,
        outer_coefficient,
    })
}
