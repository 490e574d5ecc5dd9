//! Friction torque of a bearing by cause, beside the formulas of SKF and of Palmgren.

use super::friction::{WithFriction, turning};
use super::{Answer, Equations, Question};
use crate::error::AnswerError;
use crate::rating::noted_boundaries;
use serde::Serialize;
use tribodyn_bearing::Side;
use tribodyn_case::{Fit, OilSpec};
use tribodyn_lubricant::{PalmgrenBearing, SkfBearing, SkfLoads, SkfSeries};

/// Torque that the shaft needs, N m, by cause.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TorqueAnswer {
    /// Speed of the rings against each other, r/min.
    pub speed_rpm: f64,
    /// Radial load, N.
    pub radial_load_n: f64,
    /// Axial load, N.
    pub axial_load_n: f64,
    /// All of it.
    pub torque_nm: f64,
    /// Resistance of the films' inlets to rolling.
    pub rolling_nm: f64,
    /// Elastic hysteresis of balls and rings as they are rolled over.
    pub hysteresis_nm: f64,
    /// Shear of the films at the inner race.
    pub sliding_inner_nm: f64,
    /// The same at the outer race.
    pub sliding_outer_nm: f64,
    /// Drag and churning of the fluid around the balls.
    pub fluid_nm: f64,
    /// Cage: pockets, and drag of guiding land and surroundings.
    pub cage_nm: f64,
    /// SKF's model: rolling.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub skf_rolling_nm: Option<f64>,
    /// SKF's model: sliding.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub skf_sliding_nm: Option<f64>,
    /// SKF's model, without seals and the drag of an oil bath.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub skf_torque_nm: Option<f64>,
    /// Palmgren's formula: of the lubricant.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub palmgren_viscous_nm: Option<f64>,
    /// Palmgren's formula: of the load.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub palmgren_load_nm: Option<f64>,
    /// Palmgren's formula.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub palmgren_torque_nm: Option<f64>,
    /// Assumptions of the formulas, and what they lack.
    pub notes: Vec<String>,
}

impl TorqueAnswer {
    /// Loads (N) and speed (rad/s), without a torque.
    fn without(radial: f64, axial: f64, speed: f64) -> Self {
        Self {
            speed_rpm: speed.abs() * 30.0 / std::f64::consts::PI,
            radial_load_n: radial,
            axial_load_n: axial,
            torque_nm: 0.0,
            rolling_nm: 0.0,
            hysteresis_nm: 0.0,
            sliding_inner_nm: 0.0,
            sliding_outer_nm: 0.0,
            fluid_nm: 0.0,
            cage_nm: 0.0,
            skf_rolling_nm: None,
            skf_sliding_nm: None,
            skf_torque_nm: None,
            palmgren_viscous_nm: None,
            palmgren_load_nm: None,
            palmgren_torque_nm: None,
            notes: Vec::new(),
        }
    }
}

/// Friction torques of a lubricated bearing under loads (N) at a speed (rad/s) by the formulas of SKF and of Palmgren,
/// N m; absent without a lubricant and where they have no constants.
pub(crate) fn by_formulas(
    question: &Question<'_>,
    [radial, axial]: [f64; 2],
    speed: f64,
) -> Result<[Option<f64>; 2], AnswerError> {
    let mut answer = TorqueAnswer::without(radial, axial.abs(), speed);
    formulas(question, speed, &mut answer)?;
    Ok([answer.skf_torque_nm, answer.palmgren_torque_nm])
}

/// Friction torque at the operating point of a case.
///
/// # Errors
/// Equations without friction, a case that they do not solve, that stands still, or that the standards do not rate.
pub fn torque(question: &Question<'_>, equations: Equations) -> Result<Answer<TorqueAnswer>, AnswerError> {
    turning(question, "a friction torque")?;
    let found = WithFriction::solve(question, equations)?;
    let speed = found.solution.inner_speed_rad_s - found.solution.outer_speed_rad_s;
    let of = |power: f64| power / speed.abs();
    let powers = Side::BOTH
        .map(|side| [0, 1].map(|part| found.sum(side, |contact| found.bearing.rolling_powers(side, contact)[part])));
    let rolling = powers.map(|[inlet, bodies]| inlet + bodies);
    let (torque, friction, fluid) = (found.torque_nm, found.friction_w, found.fluid_w);
    let [x, y, z] = found.solution.ring_load_n;
    let known = of(friction.iter().sum::<f64>() + fluid);
    let mut answer = TorqueAnswer {
        torque_nm: torque.abs(),
        rolling_nm: of(powers[0][0] + powers[1][0]),
        hysteresis_nm: of(powers[0][1] + powers[1][1]),
        sliding_inner_nm: of(friction[0] - rolling[0]),
        sliding_outer_nm: of(friction[1] - rolling[1]),
        fluid_nm: of(fluid),
        cage_nm: torque.abs() - known,
        ..TorqueAnswer::without(x.hypot(y), z.abs(), speed)
    };
    formulas(question, speed, &mut answer)?;
    Ok(Answer::new(found.findings, answer))
}

/// Contact angle from which a bearing counts as an angular contact bearing, rad.
const ANGULAR: f64 = 0.2;

fn formulas(question: &Question<'_>, speed: f64, answer: &mut TorqueAnswer) -> Result<(), AnswerError> {
    let case = question.case;
    let Some(lubricant) = &case.lubricant else {
        answer.notes.push("SKF and Palmgren need a lubricant, which the case does not have".to_owned());
        return Ok(());
    };
    let spec = case.rating.unwrap_or_default();
    let refused = |source| AnswerError::Rating { file: question.name.to_owned(), source };
    let static_rating = crate::rating::static_rating(case).map_err(refused)?;
    let nominal = spec.contact_angle.unwrap_or(match case.geometry.fit {
        Fit::ContactAngle(angle) => angle,
        Fit::RadialClearance(_) => 0.0,
    });
    let angular_contact = nominal > ANGULAR;
    let [bore, outside] = noted_boundaries(case, &mut answer.notes);
    let series =
        if angular_contact { Some(SkfSeries::angular_contact()) } else { deep_groove(spec.series, &mut answer.notes) };
    let viscosity = lubricant.oil.oil()?.viscosity.kinematic(lubricant.temperature);
    let synthetic = match &lubricant.oil {
        OilSpec::Library(name) => !name.starts_with("mineral"),
        OilSpec::Grade { stock, .. } | OilSpec::Viscosities { stock, .. } => stock.name() != "mineral",
    };
    if let Some(series) = series {
        let bearing = SkfBearing { bore, outside, series, static_rating };
        let skf = bearing.torque(&SkfLoads {
            radial: answer.radial_load_n,
            axial: answer.axial_load_n,
            speed,
            viscosity,
            supply: lubricant.supply,
            synthetic,
        })?;
        (answer.skf_rolling_nm, answer.skf_sliding_nm) = (Some(skf.rolling), Some(skf.sliding));
        answer.skf_torque_nm = Some(skf.total());
    }
    let bearing = PalmgrenBearing { pitch_diameter: case.geometry.pitch_diameter, angular_contact, static_rating };
    let loads = [answer.radial_load_n, answer.axial_load_n];
    let palmgren = bearing.torque(loads, speed, viscosity, lubricant.supply)?;
    (answer.palmgren_viscous_nm, answer.palmgren_load_nm) = (Some(palmgren.viscous), Some(palmgren.load));
    answer.palmgren_torque_nm = Some(palmgren.total());
    Ok(())
}

/// SKF's constants of a series of deep-groove bearings; what had to be assumed goes to the notes.
fn deep_groove(series: Option<u16>, notes: &mut Vec<String>) -> Option<SkfSeries> {
    if series.is_none() {
        notes.push("SKF's constants are those of series 62: give rating.series".to_owned());
    }
    let found = SkfSeries::deep_groove(series.unwrap_or(62));
    if found.is_none() {
        notes.push("SKF has no constants for rating.series".to_owned());
    }
    found
}
