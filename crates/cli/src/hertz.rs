//! `tribodyn hertz`: one Hertz contact.

use crate::failure::Failure;
use crate::table;
use crate::units::in_unit;
use tribodyn::answers::{HertzQuestion, hertz, hertz_line};
use tribodyn_contact::Body;

/// Hertz contact of two bodies, given by their principal radii in mm (negative: concave, inf: flat).
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn hertz --body1 6.35,6.35 --body2 inf,inf --load 100
  tribodyn hertz --body1 6.35,6.35 --body2 20,-6.6 --load 700 --json
  tribodyn hertz --body1 0.25in,0.25in --body2 inf,inf --load 20lbf
  tribodyn hertz --body1 5,inf --body2 25,inf --length 12 --load 4000

With --length the bodies are cylinders that touch along a line.")]
pub struct Arguments {
    /// Radii of body 1 in the planes x and y, mm, as RX,RY
    #[arg(long, allow_hyphen_values = true, value_parser = radii)]
    body1: Body,
    /// Radii of body 2 in the planes x and y, mm, as RX,RY
    #[arg(long, allow_hyphen_values = true, value_parser = radii)]
    body2: Body,
    /// Normal load, N
    #[arg(long, allow_hyphen_values = true, value_parser = in_unit("N"))]
    load: f64,
    /// Length of the line contact of two cylinders, mm (radii RX,inf)
    #[arg(long, value_name = "MM", allow_hyphen_values = true, value_parser = in_unit("mm"))]
    length: Option<f64>,
    /// Young's modulus of body 1, GPa; inf for a rigid body
    #[arg(long, default_value_t = 206.0, allow_hyphen_values = true, value_parser = in_unit("GPa"))]
    young1: f64,
    /// Poisson's ratio of body 1
    #[arg(long, default_value_t = 0.3, allow_hyphen_values = true)]
    poisson1: f64,
    /// Young's modulus of body 2, GPa; inf for a rigid body
    #[arg(long, default_value_t = 206.0, allow_hyphen_values = true, value_parser = in_unit("GPa"))]
    young2: f64,
    /// Poisson's ratio of body 2
    #[arg(long, default_value_t = 0.3, allow_hyphen_values = true)]
    poisson2: f64,
    /// Angle between the x planes of the two bodies, degrees
    #[arg(long, default_value_t = 0.0, allow_hyphen_values = true, value_parser = in_unit("deg"))]
    angle: f64,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

fn radii(text: &str) -> Result<Body, String> {
    let allowed = "two radii in mm as RX,RY, each a number other than 0 (negative for concave) or inf, or with a unit \
                   as 0.25in";
    let numbers: Vec<f64> = text.split(',').map_while(|part| in_unit("mm")(part).ok()).collect();
    match numbers[..] {
        [x, y] if text.split(',').count() == 2 && [x, y].iter().all(|r: &f64| !r.is_nan() && *r != 0.0) => {
            Ok(Body { radius_x: x / 1000.0, radius_y: y / 1000.0 })
        }
        _ => Err(format!("allowed are {allowed}")),
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let a = arguments;
    let question = HertzQuestion {
        bodies: [a.body1, a.body2],
        load_n: a.load,
        young_gpa: [a.young1, a.young2],
        poisson: [a.poisson1, a.poisson2],
        angle_deg: a.angle,
    };
    if let Some(length) = a.length {
        return line(a, &question, length);
    }
    let answer = hertz(&question)?;
    if a.json {
        return table::print_json(&answer);
    }
    let mut rows = vec![
        ("ellipticity a/b", format!("{:.6}", answer.ellipticity), ""),
        ("semi-major axis a", format!("{:.6}", answer.semi_major_m * 1e3), "mm"),
        ("semi-minor axis b", format!("{:.6}", answer.semi_minor_m * 1e3), "mm"),
        ("peak pressure", format!("{:.6}", answer.peak_pressure_pa * 1e-9), "GPa"),
        ("approach", format!("{:.6}", answer.approach_m * 1e6), "µm"),
        ("stiffness Q/δ^1.5", format!("{:.6e}", answer.stiffness_n_per_m_1_5), "N/m^1.5"),
    ];
    rows.extend(below(a, answer.max_shear_pa, answer.max_shear_depth_m, answer.von_mises_pa));
    table::print_pairs(&rows)
}

/// Two cylinders along a line.
fn line(a: &Arguments, question: &HertzQuestion, length: f64) -> Result<(), Failure> {
    let answer = hertz_line(question, length * 1e-3)?;
    if a.json {
        return table::print_json(&answer);
    }
    let mut rows = vec![
        ("load per length", format!("{:.6}", answer.load_per_length_n_per_m * 1e-3), "N/mm"),
        ("half width b", format!("{:.6}", answer.half_width_m * 1e3), "mm"),
        ("peak pressure", format!("{:.6}", answer.peak_pressure_pa * 1e-9), "GPa"),
    ];
    rows.extend(below(a, answer.max_shear_pa, answer.max_shear_depth_m, answer.von_mises_pa));
    table::print_pairs(&rows)
}

type Both = Option<[f64; 2]>;

/// Stresses below the surface: bodies differ by their Poisson's ratios alone.
fn below(a: &Arguments, shear: Both, depth: Both, mises: Both) -> Vec<(&'static str, String, &'static str)> {
    let both = |values: [f64; 2], per_unit: f64| {
        let shown = values.map(|value| format!("{:.6}", value * per_unit));
        if a.poisson1 == a.poisson2 { shown[0].clone() } else { shown.join("  ") }
    };
    let rows = [
        ("largest shear stress below it", shear, 1e-9, "GPa"),
        ("depth of it", depth, 1e3, "mm"),
        ("von Mises stress at that depth", mises, 1e-9, "GPa"),
    ];
    rows.into_iter().filter_map(|(name, value, factor, unit)| Some((name, both(value?, factor), unit))).collect()
}
