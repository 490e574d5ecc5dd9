//! `tribodyn sheet`: one bearing under one load on one page.

use crate::failure::Failure;
use crate::input::{self, FitArguments, LimitArguments, ReplaceArguments, change};
use crate::rating::{LOADED, Row, frequency_rows};
use crate::table::{self, number};
use crate::units::in_unit;
use std::path::PathBuf;
use tribodyn::Change;
use tribodyn::answers::Equations;
use tribodyn::rating::RatingSource;
use tribodyn::sheet::{Sheet, SheetQuestion, sheet};
use tribodyn_study::StagedFiles;
use tribodyn_study::shaft::named_case;

/// Life, safety, deflection, stiffness, torque, frequencies of defects and limits of a bearing under a load.
///
/// The rings stay aligned. What a catalogue does not tell of a listed bearing is assumed: `tribodyn new` shows it.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn sheet 6206 --radial 2000 --axial 300 --speed 3000
  tribodyn sheet 6206 --radial 450lbf --speed 3000
  tribodyn sheet 6206-2RS --radial 2000 --speed 3000 --oil usual
  tribodyn sheet 6206 --radial 2000 --speed 3000 --shaft-fit k5 --housing-fit J6
  tribodyn sheet 7210B --radial 3000 --axial 2500 --speed 1500 --html sheet.html")]
pub struct Arguments {
    /// Designation from the catalogue, such as 6206 or 7210B, or a case file (RON)
    #[arg(value_name = "BEARING")]
    bearing: String,
    /// Radial load, N
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = in_unit("N"))]
    radial: f64,
    /// Axial load, N; a bearing with shoulders on both sides carries a negative one too
    #[arg(long, value_name = "N", default_value_t = 0.0, allow_hyphen_values = true, value_parser = in_unit("N"))]
    axial: f64,
    /// Speed of the inner ring, r/min
    #[arg(long, value_name = "RPM", value_parser = in_unit("rpm"))]
    speed: f64,
    /// Replace one value of the case, such as 'geometry.fit=RadialClearance(um(8))'; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = change)]
    changes: Vec<Change>,
    /// Lubricant of a listed bearing, as for `new`: usual, vg68 and other grades, an oil such as pao-vg32, grease; adds
    /// the modified life
    #[arg(long, visible_alias = "oil", value_name = "NAME", value_parser = input::lubricant)]
    lubricant: Option<String>,
    #[command(flatten)]
    fits: FitArguments,
    #[command(flatten)]
    limits: LimitArguments,
    /// Write the sheet as a page (HTML)
    #[arg(long, value_name = "FILE.html")]
    html: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    for (option, value, least, allowed) in [
        ("radial", arguments.radial, 0.0, "0 N or more"),
        ("axial", arguments.axial, f64::MIN, "a finite force in N"),
        ("speed", arguments.speed, f64::MIN, "a finite speed in r/min"),
    ] {
        if !(value.is_finite() && value >= least) {
            let message = format!("allowed is {allowed}");
            return Err(Failure::Option { option, value: value.to_string(), message });
        }
    }
    let (fits, lubricant) = (arguments.fits.fits(), arguments.lubricant.clone());
    let listed = tribodyn_catalogue::Given { fits, lubricant, ..Default::default() };
    let case = named_case(&arguments.bearing, listed, &arguments.changes, &arguments.limits.limits())?;
    let speed = arguments.speed * std::f64::consts::PI / 30.0;
    let question = SheetQuestion { radial: arguments.radial, axial: arguments.axial, speed };
    let found = sheet(&arguments.bearing, &case, &question)?;
    let parts = parts(&found);
    if let Some(path) = &arguments.html {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or("sheet.html").to_owned();
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let mut staged = StagedFiles::new(folder.unwrap_or(std::path::Path::new(".")), arguments.replace.force)?;
        staged.write(name, page(&found, &parts).as_bytes())?;
        staged.publish()?;
    }
    if arguments.json {
        return table::print_json(&found);
    }
    table::print_line(&found.name)?;
    for (title, rows) in &parts {
        table::print_line(&format!("\n{title}"))?;
        table::print_pairs(rows)?;
    }
    table::print_line("")?;
    if let Some(note) = &found.rating.grease_note {
        table::print_line(&format!("note: {note}"))?;
    }
    table::print_warnings(&found.warnings)
}

/// A row of what there is under load only.
fn under_load(name: &'static str, value: Option<String>, unit: &'static str) -> Row {
    match value {
        Some(value) => (name, value, unit),
        None => (name, "no load: not defined".to_owned(), ""),
    }
}

/// Rows of the bearing itself.
fn bearing(s: &Sheet) -> Vec<Row> {
    let bore = match s.bore_source {
        RatingSource::Catalogue => "mm",
        RatingSource::Computed => "mm, estimated from the balls",
    };
    vec![
        ("balls", s.ball_count.to_string(), ""),
        ("ball diameter", number(s.ball_diameter_m * 1e3, 3), "mm"),
        ("pitch diameter", number(s.pitch_diameter_m * 1e3, 2), "mm"),
        ("bore", number(s.bore_m * 1e3, 2), bore),
        ("radial internal clearance", number(s.radial_clearance_m * 1e6, 1), "µm"),
    ]
}

/// A sheet part by part.
fn parts(s: &Sheet) -> Vec<(&'static str, Vec<Row>)> {
    let list = |values: &[f64], factor: f64, digits: usize| {
        values.iter().map(|v| number(v * factor, digits)).collect::<Vec<_>>().join("  ")
    };
    let degrees = 180.0 / std::f64::consts::PI;
    let scaled = |value: Option<f64>, factor: f64, digits: usize| value.map(|value| number(value * factor, digits));
    let operation = vec![
        ("radial load", number(s.radial_load_n, 1), "N"),
        ("axial load", number(s.axial_load_n, 1), "N"),
        ("speed", number(s.speed_rpm, 0), "r/min"),
        ("pitch diameter times speed", number(s.speed_factor_mm_rpm, 0), "mm r/min"),
    ];
    let deflection = vec![
        ("radial displacement", number(s.ring_displacement_m[0] * 1e6, 2), "µm"),
        ("axial displacement from touching", number(s.ring_displacement_m[2] * 1e6, 2), "µm"),
        ("radial stiffness along and across the load", list(&[s.stiffness[0][0], s.stiffness[1][1]], 1e-6, 2), "N/µm"),
        ("axial stiffness", number(s.stiffness[2][2] * 1e-6, 2), "N/µm"),
        ("tilting stiffness", list(&[s.stiffness[3][3], s.stiffness[4][4]], 1e-3, 3), "N m/mrad"),
        ("moment that keeps the rings aligned", number(s.tilting_moment_nm, 3), "N m"),
    ];
    let balls = vec![
        ("balls under load", s.loaded_balls.to_string(), ""),
        ("largest ball load", number(s.ball_load_max_n, 1), "N"),
        under_load("contact angles, inner race", s.contact_angle_rad.map(|angles| list(&angles, degrees, 2)), "°"),
        under_load("highest peak pressure", scaled(s.rating.peak_pressure_max_pa, 1e-9, 3), "GPa"),
    ];
    let mut friction = vec![
        under_load("friction torque, rule of thumb", scaled(s.friction_torque_estimate_nm, 1e3, 2), "N mm"),
        under_load("power of it", scaled(s.friction_power_estimate_w, 1.0, 2), "W"),
    ];
    for (name, torque) in
        [("SKF's model, without seals", s.skf_torque_nm), ("Palmgren's formula", s.palmgren_torque_nm)]
    {
        friction.extend(torque.map(|torque| (name, number(torque * 1e3, 2), "N mm")));
    }
    let mut parts = vec![
        ("Bearing", bearing(s)),
        ("Fits", s.fits.iter().flat_map(crate::fits::rows).collect()),
        ("Operation", operation),
        ("Life and safety", crate::rating::rows(&s.rating, Equations::JonesHarris.name())),
        ("Balls", balls),
        ("Deflection and stiffness", deflection),
        ("Friction", friction),
    ];
    if let Some(found) = &s.rating.frequencies {
        parts.push(("Frequencies", frequency_rows(found, LOADED)));
    }
    parts.retain(|(_, rows)| !rows.is_empty());
    parts
}

/// The sheet as a page of its own.
fn page(s: &Sheet, parts: &[(&'static str, Vec<Row>)]) -> String {
    let escape =
        |text: &str| crate::harmless::visible(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"generator\" \
         content=\"tribodyn\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{0}</title>\n<style>:root{{color-scheme:light dark}}body{{font:15px/1.45 system-ui,sans-serif;\
         max-width:60rem;margin:2rem auto;padding:0 1rem}}main{{columns:2 24rem;column-gap:3rem}}\
         section{{break-inside:avoid}}\
         h2{{font-size:1.05rem;margin:1rem 0 .3rem}}table{{border-collapse:collapse;width:100%}}\
         td{{padding:.1rem .3rem;border-bottom:1px solid #8884}}td:nth-child(2){{text-align:right;\
         font-variant-numeric:tabular-nums}}.warning{{border-left:4px solid #c60;padding-left:.6rem}}</style>\n\
         </head>\n\
         <body>\n<h1>{0}</h1>\n",
        escape(&s.name)
    );
    for warning in &s.warnings {
        html += &format!("<p class=\"warning\">{}</p>\n", escape(warning));
    }
    html += "<main>\n";
    for (title, rows) in parts {
        html += &format!("<section>\n<h2>{title}</h2>\n<table>\n");
        for (name, value, unit) in rows {
            html += &format!("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", escape(name), escape(value), escape(unit));
        }
        html += "</table>\n</section>\n";
    }
    html + "</main>\n</body>\n</html>\n"
}
