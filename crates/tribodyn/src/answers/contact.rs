//! One Hertz contact of two bodies.

use crate::error::AnswerError;
use serde::Serialize;
use tribodyn_contact::{Body, ElasticBody, HertzContact, Subsurface, effective_modulus, relative_curvatures};

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

/// Size and pressure of the contact.
///
/// # Errors
/// A value that makes no contact, or numbers beyond what can be calculated with.
pub fn hertz(question: &HertzQuestion) -> Result<HertzAnswer, AnswerError> {
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
    let gap = relative_curvatures(&bodies[0], &bodies[1], angle_deg.to_radians())?;
    let contact = HertzContact::new(gap.x, gap.y, modulus)?;
    let ellipse = contact.ellipse(*load_n);
    let [first, second] = poisson.map(|poisson| ellipse.subsurface(poisson));
    let of = |value: fn(&Subsurface) -> f64| first.as_ref().zip(second.as_ref()).map(|(a, b)| [value(a), value(b)]);
    let answer = HertzAnswer {
        ellipticity: contact.ellipticity,
        semi_major_m: ellipse.semi_major,
        semi_minor_m: ellipse.semi_minor,
        peak_pressure_pa: ellipse.peak_pressure,
        approach_m: contact.approach(*load_n),
        stiffness_n_per_m_1_5: contact.stiffness(),
        max_shear_pa: of(|found| found.max_shear),
        max_shear_depth_m: of(|found| found.max_shear_depth),
        von_mises_pa: of(|found| found.von_mises),
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
