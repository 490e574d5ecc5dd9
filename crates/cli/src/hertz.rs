//! `tribodyn hertz`: one Hertz contact.

use crate::failure::Failure;
use crate::table;
use serde::Serialize;
use tribodyn_contact::{Body, ElasticBody, HertzContact, effective_modulus, relative_curvatures};

/// Hertz contact of two bodies, given by their principal radii in mm (negative: concave, inf: flat).
#[derive(clap::Args)]
pub struct Arguments {
    /// Radii of body 1 in the planes x and y, mm, as RX,RY
    #[arg(long, allow_hyphen_values = true, value_parser = radii)]
    body1: Body,
    /// Radii of body 2 in the planes x and y, mm, as RX,RY
    #[arg(long, allow_hyphen_values = true, value_parser = radii)]
    body2: Body,
    /// Normal load, N
    #[arg(long, allow_hyphen_values = true)]
    load: f64,
    /// Young's modulus of body 1, GPa
    #[arg(long, default_value_t = 206.0, allow_hyphen_values = true)]
    young1: f64,
    /// Poisson's ratio of body 1
    #[arg(long, default_value_t = 0.3, allow_hyphen_values = true)]
    poisson1: f64,
    /// Young's modulus of body 2, GPa
    #[arg(long, default_value_t = 206.0, allow_hyphen_values = true)]
    young2: f64,
    /// Poisson's ratio of body 2
    #[arg(long, default_value_t = 0.3, allow_hyphen_values = true)]
    poisson2: f64,
    /// Angle between the x planes of the two bodies, degrees
    #[arg(long, default_value_t = 0.0, allow_hyphen_values = true)]
    angle: f64,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

fn radii(text: &str) -> Result<Body, String> {
    let allowed = "two radii in mm as RX,RY, each a number other than 0 (negative for concave) or inf";
    let numbers: Vec<f64> = text.split(',').map_while(|part| part.trim().parse().ok()).collect();
    match numbers[..] {
        [x, y] if text.split(',').count() == 2 && [x, y].iter().all(|r: &f64| !r.is_nan() && *r != 0.0) => {
            Ok(Body { radius_x: x / 1000.0, radius_y: y / 1000.0 })
        }
        _ => Err(format!("allowed are {allowed}")),
    }
}

#[derive(Serialize)]
struct Answer {
    ellipticity: f64,
    semi_major_m: f64,
    semi_minor_m: f64,
    peak_pressure_pa: f64,
    approach_m: f64,
    stiffness_n_per_m_1_5: f64,
}

fn within(option: &'static str, value: f64, allowed: &str, ok: bool) -> Result<f64, Failure> {
    if ok && value.is_finite() {
        return Ok(value);
    }
    Err(Failure::Option { option, value: value.to_string(), message: format!("allowed is {allowed}") })
}

/// JSON has no infinity: numbers that overflow are refused instead.
fn check_range(answer: &Answer) -> Result<(), Failure> {
    let values = [
        ("the ellipticity", answer.ellipticity),
        ("the semi-major axis", answer.semi_major_m),
        ("the semi-minor axis", answer.semi_minor_m),
        ("the peak pressure", answer.peak_pressure_pa),
        ("the approach", answer.approach_m),
        ("the stiffness", answer.stiffness_n_per_m_1_5),
    ];
    match values.into_iter().find(|(_, value)| !value.is_finite()) {
        Some((quantity, value)) => Err(Failure::OutOfRange { quantity, value }),
        None => Ok(()),
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let a = arguments;
    within("load", a.load, "a force in N, 0 or more", a.load >= 0.0)?;
    within("young1", a.young1, "a modulus in GPa above 0", a.young1 > 0.0)?;
    within("young2", a.young2, "a modulus in GPa above 0", a.young2 > 0.0)?;
    let poisson = |v: f64| (0.0..0.5).contains(&v);
    within("poisson1", a.poisson1, "a ratio from 0 to below 0.5", poisson(a.poisson1))?;
    within("poisson2", a.poisson2, "a ratio from 0 to below 0.5", poisson(a.poisson2))?;
    within("angle", a.angle, "an angle in degrees", true)?;
    let body = |young: f64, poisson| ElasticBody { young: young * 1e9, poisson };
    let modulus = effective_modulus(&body(a.young1, a.poisson1), &body(a.young2, a.poisson2));
    let gap = relative_curvatures(&a.body1, &a.body2, a.angle.to_radians())?;
    let contact = HertzContact::new(gap.x, gap.y, modulus)?;
    let ellipse = contact.ellipse(a.load);
    let answer = Answer {
        ellipticity: contact.ellipticity,
        semi_major_m: ellipse.semi_major,
        semi_minor_m: ellipse.semi_minor,
        peak_pressure_pa: ellipse.peak_pressure,
        approach_m: contact.approach(a.load),
        stiffness_n_per_m_1_5: contact.stiffness(),
    };
    check_range(&answer)?;
    if a.json {
        return table::print_json(&answer);
    }
    table::print_pairs(&[
        ("ellipticity a/b", format!("{:.6}", answer.ellipticity), ""),
        ("semi-major axis a", format!("{:.6}", answer.semi_major_m * 1e3), "mm"),
        ("semi-minor axis b", format!("{:.6}", answer.semi_minor_m * 1e3), "mm"),
        ("peak pressure", format!("{:.6}", answer.peak_pressure_pa * 1e-9), "GPa"),
        ("approach", format!("{:.6}", answer.approach_m * 1e6), "µm"),
        ("stiffness Q/δ^1.5", format!("{:.6e}", answer.stiffness_n_per_m_1_5), "N/m^1.5"),
    ])
}
