//! One Hertz contact of two bodies.

use crate::error::AnswerError;
use serde::Serialize;
use tribodyn_contact::{
    Body, ElasticBody, HertzContact, LineContact, RelativeCurvatures, Subsurface, effective_modulus,
    relative_curvatures,
};

/// Two bodies that are pressed together. Messages about a value call it by the name of the command's option.
#[derive(Debug, Clone, PartialEq)]
pub struct HertzQuestion {
    /// Principal radii of the bodies, m: negative for concave, infinite for flat.
    pub bodies: [Body; 2],
    /// Normal load, N.
    pub load_n: f64,
    /// Young's moduli, GPa.
    pub young_gpa: [f64; 2],
    /// Poisson's ratios.
    pub poisson: [f64; 2],
    /// Angle between the x planes of the two bodies, degrees.
    pub angle_deg: f64,
}

/// The contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HertzAnswer {
    /// Semi-major over semi-minor axis.
    pub ellipticity: f64,
    /// Semi-major axis, m.
    pub semi_major_m: f64,
    /// Semi-minor axis, m.
    pub semi_minor_m: f64,
    /// Highest pressure, Pa.
    pub peak_pressure_pa: f64,
    /// Elastic approach of the bodies, m.
    pub approach_m: f64,
    /// Load over approach to the power of 1.5, N/m^1.5.
    pub stiffness_n_per_m_1_5: f64,
    /// Largest shear stress below the middle of the contact, in body 1 and in body 2, Pa; absent without load.
    pub max_shear_pa: Option<[f64; 2]>,
    /// Depth of that stress, m.
    pub max_shear_depth_m: Option<[f64; 2]>,
    /// Von Mises stress at that depth, Pa.
    pub von_mises_pa: Option<[f64; 2]>,
}

fn within(option: &'static str, value: f64, allowed: &str, ok: bool) -> Result<(), AnswerError> {
    if ok && value.is_finite() {
        return Ok(());
    }
    Err(AnswerError::argument(option, value, format!("allowed is {allowed}")))
}

/// A line contact: two cylinders with parallel axes, its ends left out.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LineAnswer {
    /// Length of the contact, m.
    pub length_m: f64,
    /// Load per length, N/m.
    pub load_per_length_n_per_m: f64,
    /// Half the width of the strip, m.
    pub half_width_m: f64,
    /// Highest pressure, Pa.
    pub peak_pressure_pa: f64,
    /// Largest shear stress across the strip below its middle, in body 1 and in body 2, Pa; absent without load.
    pub max_shear_pa: Option<[f64; 2]>,
    /// Depth of that stress, m.
    pub max_shear_depth_m: Option<[f64; 2]>,
    /// Von Mises stress at that depth, Pa.
    pub von_mises_pa: Option<[f64; 2]>,
}

/// Effective modulus and curvatures of a question, its values checked.
fn checked(question: &HertzQuestion) -> Result<(f64, RelativeCurvatures), AnswerError> {
    let HertzQuestion { bodies, load_n, young_gpa, poisson, angle_deg } = question;
    within("load", *load_n, "a force in N, 0 or more", *load_n >= 0.0)?;
    for (option, value) in ["young1", "young2"].into_iter().zip(*young_gpa) {
        // A rigid body has an infinite modulus.
        if value != f64::INFINITY {
            within(option, value, "a modulus in GPa above 0, or inf for a rigid body", value > 0.0)?;
        }
    }
    if young_gpa.iter().all(|young| young.is_infinite()) {
        return Err(AnswerError::argument("young2", f64::INFINITY, "allowed is one rigid body: two do not give way"));
    }
    for (option, value) in ["poisson1", "poisson2"].into_iter().zip(*poisson) {
        within(option, value, "a ratio from 0 to below 0.5", (0.0..0.5).contains(&value))?;
    }
    within("angle", *angle_deg, "an angle in degrees", true)?;
    let body = |i: usize| ElasticBody { young: young_gpa[i] * 1e9, poisson: poisson[i] };
    let modulus = effective_modulus(&body(0), &body(1));
    Ok((modulus, relative_curvatures(&bodies[0], &bodies[1], angle_deg.to_radians())?))
}

/// The curvature of the gap between bodies that are straight in the other plane; none where they are not.
fn along_a_line(question: &HertzQuestion, gap: &RelativeCurvatures) -> Option<f64> {
    let straight = |radius: fn(&Body) -> f64| question.bodies.iter().all(|body| radius(body).is_infinite());
    match (gap.x == 0.0 && straight(|body| body.radius_x), gap.y == 0.0 && straight(|body| body.radius_y)) {
        (_, true) => Some(gap.x),
        (true, _) => Some(gap.y),
        _ => None,
    }
}

/// A value of both bodies, where there is a load.
fn of(both: [Option<Subsurface>; 2], value: fn(&Subsurface) -> f64) -> Option<[f64; 2]> {
    let [first, second] = &both;
    first.as_ref().zip(second.as_ref()).map(|(a, b)| [value(a), value(b)])
}

/// Width and pressure of the contact of two cylinders, flats among them, along a length in m.
///
/// # Errors
/// Bodies that are curved along the length too, a value that makes no contact, or numbers beyond what can be calculated
/// with.
pub fn hertz_line(question: &HertzQuestion, length_m: f64) -> Result<LineAnswer, AnswerError> {
    within("length", length_m * 1e3, "a length in mm above 0", length_m > 0.0)?;
    let (modulus, gap) = checked(question)?;
    let Some(curvature) = along_a_line(question, &gap) else {
        let allowed = "allowed with a length are cylinders with parallel axes: radii RX,inf of both bodies, at angle 0";
        return Err(AnswerError::argument("length", length_m * 1e3, allowed));
    };
    let load = question.load_n / length_m;
    let line = LineContact::new(curvature, modulus, load)?;
    let below = question.poisson.map(|poisson| line.subsurface(poisson));
    let answer = LineAnswer {
        length_m,
        load_per_length_n_per_m: load,
        half_width_m: line.half_width,
        peak_pressure_pa: line.peak_pressure,
        max_shear_pa: of(below, |found| found.max_shear),
        max_shear_depth_m: of(below, |found| found.max_shear_depth),
        von_mises_pa: of(below, |found| found.von_mises),
    };
    let values = [("the load per length", load), ("the half width", line.half_width)];
    match values.into_iter().chain([("the peak pressure", line.peak_pressure)]).find(|(_, value)| !value.is_finite()) {
        Some((quantity, value)) => Err(AnswerError::OutOfRange { quantity, value }),
        None => Ok(answer),
    }
}

/// Size and pressure of the contact.
///
/// # Errors
/// A value that makes no contact, or numbers beyond what can be calculated with.
pub fn hertz(question: &HertzQuestion) -> Result<HertzAnswer, AnswerError> {
    let (modulus, gap) = checked(question)?;
    if along_a_line(question, &gap).is_some_and(|curvature| curvature > 0.0) {
        let allowed = "two cylinders with parallel axes touch along a line; allowed is its length in mm";
        return Err(AnswerError::argument("length", "missing", allowed));
    }
    let contact = HertzContact::new(gap.x, gap.y, modulus)?;
    let ellipse = contact.ellipse(question.load_n);
    let below = question.poisson.map(|poisson| ellipse.subsurface(poisson));
    let answer = HertzAnswer {
        ellipticity: contact.ellipticity,
        semi_major_m: ellipse.semi_major,
        semi_minor_m: ellipse.semi_minor,
        peak_pressure_pa: ellipse.peak_pressure,
        approach_m: contact.approach(question.load_n),
        stiffness_n_per_m_1_5: contact.stiffness(),
        max_shear_pa: of(below, |found| found.max_shear),
        max_shear_depth_m: of(below, |found| found.max_shear_depth),
        von_mises_pa: of(below, |found| found.von_mises),
    };
    check_range(&answer)?;
    Ok(answer)
}

/// JSON has no infinity: numbers that overflow are refused instead.
fn check_range(answer: &HertzAnswer) -> Result<(), AnswerError> {
    let values = [
        ("the ellipticity", answer.ellipticity),
        ("the semi-major axis", answer.semi_major_m),
        ("the semi-minor axis", answer.semi_minor_m),
        ("the peak pressure", answer.peak_pressure_pa),
        ("the approach", answer.approach_m),
        ("the stiffness", answer.stiffness_n_per_m_1_5),
    ];
    match values.into_iter().find(|(_, value)| !value.is_finite()) {
        Some((quantity, value)) => Err(AnswerError::OutOfRange { quantity, value }),
        None => Ok(()),
    }
}
