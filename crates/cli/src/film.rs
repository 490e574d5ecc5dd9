//! `tribodyn film`: lubricant films of a case, or of one contact.

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::search::{Search, TimeArguments};
use crate::solve::FrictionArguments;
use crate::table::{self, number};
use crate::units::in_unit;
use serde::Serialize;
use tribodyn::answers::{ContactFilm, ContactFilmQuestion, FilmAnswer, OilAnswer, contact_film, films};

/// Film thickness by Hamrock and Dowson with inlet heating and starvation, film parameter and viscosity ratio.
///
/// Of every loaded contact of a case with a lubricant: `tribodyn film case CASE.ron`. Of one contact of two steel
/// bodies: `tribodyn film contact --oil mineral-vg68 …`.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn film case 6206.ron
  tribodyn film contact --oil mineral-vg68 --temperature 70 --load 555 --speed 3.46 --radius 3.78 --across 120")]
pub struct Arguments {
    #[command(subcommand)]
    of: Of,
}

#[derive(clap::Subcommand)]
enum Of {
    /// Every loaded contact of a case
    Case(OfCase),
    /// One contact
    Contact(OfContact),
}

#[derive(clap::Args)]
struct OfCase {
    #[command(flatten)]
    case: CaseArguments,
    #[command(flatten)]
    time: TimeArguments,
    #[command(flatten)]
    model: FrictionArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

#[derive(clap::Args)]
struct OfContact {
    /// Oil of the library: mineral, pao, ester or polyglycol with a grade, such as mineral-vg68; vg68 alone is mineral
    #[arg(long)]
    oil: String,
    /// Temperature of the oil before the contact, °C
    #[arg(long, value_name = "DEG_C", value_parser = in_unit("degC"))]
    temperature: f64,
    /// Normal load, N
    #[arg(long, value_name = "N", value_parser = in_unit("N"))]
    load: f64,
    /// Entrainment speed, the mean of both surface speeds, m/s
    #[arg(long, value_name = "M_S")]
    speed: f64,
    /// Radius of relative curvature along rolling, mm
    #[arg(long, value_name = "MM", value_parser = in_unit("mm"))]
    radius: f64,
    /// Radius of relative curvature across rolling, mm [default: as along it]
    #[arg(long, value_name = "MM", value_parser = in_unit("mm"))]
    across: Option<f64>,
    /// Slide-to-roll ratio
    #[arg(long, default_value_t = 0.0)]
    slide_to_roll: f64,
    /// Root-mean-square roughness of both surfaces together, µm
    #[arg(long, value_name = "UM", default_value_t = 0.07, value_parser = in_unit("um"))]
    roughness: f64,
    /// Film thickness over that of a flooded contact; 0.7 for grease
    #[arg(long, default_value_t = 1.0)]
    starvation: f64,
    /// Young's modulus of both bodies, GPa
    #[arg(long, default_value_t = 208.0)]
    young: f64,
    /// Poisson's ratio of both bodies
    #[arg(long, default_value_t = 0.3)]
    poisson: f64,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct ContactAnswer {
    oil: OilAnswer,
    #[serde(flatten)]
    film: ContactFilm,
}

type Row = (&'static str, String, &'static str);

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.of {
        Of::Case(arguments) => of_case(arguments),
        Of::Contact(arguments) => of_contact(arguments),
    }
}

fn oil_rows(oil: &OilAnswer) -> Vec<Row> {
    vec![
        ("temperature of the oil", number(oil.temperature_deg_c, 1), "°C"),
        ("kinematic viscosity", number(oil.kinematic_viscosity_mm2_s, 3), "mm²/s"),
        ("dynamic viscosity", number(oil.dynamic_viscosity_pa_s * 1e3, 3), "mPa s"),
        ("pressure-viscosity coefficient", number(oil.pressure_viscosity_per_pa * 1e9, 2), "1/GPa"),
    ]
}

fn of_contact(a: &OfContact) -> Result<(), Failure> {
    let (oil, film) = contact_film(&ContactFilmQuestion {
        oil: a.oil.clone(),
        temperature_deg_c: a.temperature,
        starvation: a.starvation,
        roughness_um: a.roughness,
        load_n: a.load,
        speed_m_s: a.speed,
        slide_to_roll: a.slide_to_roll,
        rolling_radius_mm: a.radius,
        lateral_radius_mm: a.across.unwrap_or(a.radius),
        young_gpa: a.young,
        poisson: a.poisson,
    })?;
    if a.json {
        return table::print_json(&ContactAnswer { oil, film });
    }
    let mut rows = oil_rows(&oil);
    rows.push(("central film thickness", number(film.film_central_m * 1e6, 4), "µm"));
    rows.push(("least film thickness", number(film.film_minimum_m * 1e6, 4), "µm"));
    rows.push(("film parameter λ", number(film.lambda_ratio, 2), ""));
    table::print_pairs(&rows)
}

fn of_case(arguments: &OfCase) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let search = Search::begin(&file, &arguments.time);
    let answer =
        films(&file.question(search.watch()), arguments.model.equations()).map_err(|error| search.failed(error))?;
    drop(search);
    if arguments.json {
        return table::print_json(&answer);
    }
    let (findings, found) = (answer.findings(), answer.value());
    table::print_head(&format!("{}: {}", file.name, crate::harmless::visible(&file.case.name)), findings)?;
    table::print_pairs(&case_rows(found))?;
    table::print_line("")?;
    let header = ["ball", "race", "Q, N", "u, m/s", "h central, µm", "h least, µm", "λ", "film rise, K"];
    table::print_rows(&header, found.contacts.iter().map(contact_row))?;
    table::print_warnings(findings.warnings())
}

fn case_rows(found: &FilmAnswer) -> Vec<Row> {
    let mut rows = oil_rows(&found.oil);
    rows.push(("film over that of flooded contacts", number(found.starvation, 2), ""));
    let reference = found.reference_viscosity_mm2_s.map(|value| number(value, 3));
    rows.extend(reference.map(|value| ("viscosity asked for by ISO 281, ν_1", value, "mm²/s")));
    rows.extend(found.viscosity_ratio.map(|value| ("viscosity ratio κ", number(value, 3), "")));
    rows.push(("speed times pitch diameter", number(found.speed_factor_mm_rpm, 0), "mm r/min"));
    rows
}

fn contact_row(contact: &ContactFilm) -> Vec<String> {
    vec![
        contact.ball.map_or_else(String::new, |ball| ball.to_string()),
        contact.race.unwrap_or_default().to_owned(),
        number(contact.load_n, 1),
        number(contact.entrainment_speed_m_s, 3),
        number(contact.film_central_m * 1e6, 3),
        number(contact.film_minimum_m * 1e6, 3),
        number(contact.lambda_ratio, 2),
        contact.film_temperature_rise_k.map_or_else(String::new, |rise| number(rise, 1)),
    ]
}
