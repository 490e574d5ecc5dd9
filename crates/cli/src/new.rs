//! `tribodyn new`: a complete case from a few catalogue numbers.

use crate::failure::Failure;
use crate::input::{self, FitArguments, ReplaceArguments};
use crate::table;
use crate::units::in_unit;
use std::io::{BufRead, IsTerminal, Write};
use std::path::{Path, PathBuf};
use tribodyn::{CaseFile, Limits};
use tribodyn_catalogue::{Envelope, Given, NewCase, Ratings, find};
use tribodyn_study::{StagedFiles, StudyError};

/// Make a complete, commented case file from a designation, or from boundary dimensions.
///
/// What the catalogue does not tell is assumed; the sources at the end of the file say so, with reason and usual range.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn new 6206
  tribodyn new \"6206-2RS C3\" --radial 2000 --speed 3000
  tribodyn new 7014CDGA/P4A --axial -500
  tribodyn new 6206 --shaft-fit k5 --housing-fit J6
  tribodyn new 7210 --angle 40 -o pump.ron
  tribodyn new --bearing angular --bore 50 --outside 90 --width 20 --angle 40 --balls 15 --ball 12.7 -o case.ron")]
pub struct Arguments {
    /// Designation, such as 6206-2RS C3 or 7014CDGA/P4A; `tribodyn catalogue` lists the sizes
    #[arg(value_name = "DESIGNATION", required_unless_present_any = ["bore", "ask"], conflicts_with_all = ["bore", "outside", "width", "bearing"])]
    designation: Option<String>,
    /// Type of a bearing that is given by its dimensions
    #[arg(long, value_enum, requires = "bore")]
    bearing: Option<Class>,
    /// Bore, mm
    #[arg(long, value_name = "MM", requires_all = ["outside", "width"], value_parser = in_unit("mm"))]
    bore: Option<f64>,
    /// Outside diameter, mm
    #[arg(long, value_name = "MM", requires = "bore", value_parser = in_unit("mm"))]
    outside: Option<f64>,
    /// Width, mm
    #[arg(long, value_name = "MM", requires = "bore", value_parser = in_unit("mm"))]
    width: Option<f64>,
    /// Nominal contact angle of an angular-contact bearing, degrees
    #[arg(long, value_name = "DEG", value_parser = in_unit("deg"))]
    angle: Option<f64>,
    /// Number of balls [default: from the ratings, else by a rule of thumb]
    #[arg(long, value_name = "N")]
    balls: Option<usize>,
    /// Ball diameter, mm [default: as for --balls]
    #[arg(long, value_name = "MM", value_parser = in_unit("mm"))]
    ball: Option<f64>,
    /// Dynamic load rating C_r, N
    #[arg(long, value_name = "N", requires = "static_rating", value_parser = in_unit("N"))]
    dynamic_rating: Option<f64>,
    /// Static load rating C_0r, N
    #[arg(long, value_name = "N", requires = "dynamic_rating", value_parser = in_unit("N"))]
    static_rating: Option<f64>,
    /// Radial load, N [default: moderate]
    #[arg(long, value_name = "N", value_parser = in_unit("N"))]
    radial: Option<f64>,
    /// Axial load, N [default: moderate]
    #[arg(long, value_name = "N", value_parser = in_unit("N"))]
    axial: Option<f64>,
    /// Speed of the inner ring, r/min [default: moderate]
    #[arg(long, value_name = "RPM", value_parser = in_unit("rpm"))]
    speed: Option<f64>,
    /// Lubricant: vg32 and other grades of mineral oil, an oil such as pao-vg32, grease; ag or ptfe for a solid film
    /// [default: usual, which is grease for sealed bearings and oil VG 68 for open ones]
    #[arg(long, value_name = "NAME", value_parser = input::lubricant)]
    lubricant: Option<String>,
    #[command(flatten)]
    fits: FitArguments,
    /// Ask for missing values on the terminal
    #[arg(long)]
    ask: bool,
    /// Case file to write [default: named after the bearing]
    #[arg(short, long, value_name = "CASE.ron")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
}

#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
enum Class {
    /// Deep groove
    DeepGroove,
    /// Angular contact; needs --angle
    Angular,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut case = match &arguments.designation {
        Some(designation) => listed(designation, arguments.angle)?,
        None if arguments.bore.is_some() => by_dimensions(arguments)?,
        None => asked_bearing(arguments.angle)?,
    };
    let ratings = arguments.dynamic_rating.zip(arguments.static_rating);
    let ratings = ratings.map(|(dynamic, at_rest)| Ratings { dynamic, at_rest });
    for (option, value) in ratings.iter().flat_map(|r| [("dynamic-rating", r.dynamic), ("static-rating", r.at_rest)]) {
        number_option(option, value, |value| value > 0.0, "a load above 0 in N")?;
    }
    for (option, value) in [("radial", arguments.radial), ("axial", arguments.axial), ("speed", arguments.speed)] {
        value.map_or(Ok(()), |value| number_option(option, value, f64::is_finite, "a finite number"))?;
    }
    case = case.given(Given {
        balls: arguments.balls,
        ball_mm: arguments.ball,
        ratings,
        radial: arguments.radial,
        axial: arguments.axial,
        speed_rpm: arguments.speed,
        lubricant: arguments.lubricant.clone(),
        fits: arguments.fits.fits(),
    })?;
    if arguments.ask {
        ask_operation(&mut case)?;
    }
    let text = case.text()?;
    let path = arguments.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}.ron", file_name(&case))));
    // A case that `check` would refuse is not written.
    CaseFile::from_text(&path.display().to_string(), text.clone(), &[], &Limits::NORMAL)?;
    write_new(&path, &text, arguments.replace.force)?;
    table::print_line(&format!("wrote {}: check it with `tribodyn check {0}`", path.display()))?;
    let assumed = text.lines().filter(|line| line.contains(": Assumed(")).count();
    table::print_line(&format!("{assumed} assumptions are in its sources, each with its reason: replace what you know"))
}

fn number_option(option: &'static str, value: f64, allowed: impl Fn(f64) -> bool, rule: &str) -> Result<(), Failure> {
    if value.is_finite() && allowed(value) {
        return Ok(());
    }
    Err(Failure::Option { option, value: value.to_string(), message: format!("allowed is {rule}") })
}

fn listed(designation: &str, angle: Option<f64>) -> Result<NewCase, Failure> {
    Ok(NewCase::of_listed(find(designation, angle)?, designation))
}

fn by_dimensions(arguments: &Arguments) -> Result<NewCase, Failure> {
    let [bore, outside, width] =
        [arguments.bore, arguments.outside, arguments.width].map(|value| value.unwrap_or_default() * 1e-3);
    let contact_angle = match (arguments.bearing, arguments.angle) {
        (Some(Class::Angular), None) => {
            let message = "an angular-contact bearing needs its contact angle: add --angle".to_owned();
            return Err(Failure::Option { option: "bearing", value: "angular".to_owned(), message });
        }
        (Some(Class::DeepGroove), Some(angle)) if angle != 0.0 => {
            let message = "a deep-groove bearing has no nominal contact angle".to_owned();
            return Err(Failure::Option { option: "angle", value: angle.to_string(), message });
        }
        (_, angle) => angle.unwrap_or(0.0).to_radians(),
    };
    Ok(NewCase::new(Envelope { bore, outside, width, contact_angle }))
}

/// Name of the file of a case: its designation, or its dimensions.
fn file_name(case: &NewCase) -> String {
    match &case.designation {
        Some(designation) => {
            let plain: String = designation.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
            plain.split('-').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("-")
        }
        None => {
            let Envelope { bore, outside, width, .. } = case.envelope;
            let [bore, outside, width] = [bore, outside, width].map(|m| (m * 1e7).round() / 1e4);
            format!("bearing-{bore}x{outside}x{width}")
        }
    }
}

/// Writes a file, whole or not at all; one that is there is replaced with `force` only.
fn write_new(path: &Path, text: &str, force: bool) -> Result<(), Failure> {
    let failed = |source| StudyError::Write { path: path.to_owned(), source };
    if force && path.is_file() {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let mut staged = StagedFiles::new(path.parent().unwrap_or(Path::new("")), true)?;
        staged.write(name, text.as_bytes())?;
        return Ok(staged.publish()?);
    }
    let mut file = std::fs::File::create_new(path).map_err(|source| match source.kind() {
        std::io::ErrorKind::AlreadyExists => Failure::Exists { path: path.to_owned() },
        _ => failed(source).into(),
    })?;
    let written = file.write_all(text.as_bytes()).and_then(|()| file.sync_all());
    if let Err(source) = written {
        // What is half-written must not stay; should removing fail too, the first failure is the news.
        let _ = std::fs::remove_file(path);
        return Err(failed(source).into());
    }
    Ok(())
}

fn asked_bearing(angle: Option<f64>) -> Result<NewCase, Failure> {
    let designation = ask("Designation, such as 6206 or 7210B; empty for one by its dimensions", "")?;
    if !designation.is_empty() {
        let bearing = find(&designation, angle);
        if let Err(tribodyn_catalogue::CatalogueError::Angle { .. }) = &bearing {
            return listed(&designation, Some(ask_number("Contact angle, degrees", 40.0)?));
        }
        return listed(&designation, angle);
    }
    let bore = ask_number("Bore, mm", 50.0)? * 1e-3;
    let outside = ask_number("Outside diameter, mm", 90.0)? * 1e-3;
    let width = ask_number("Width, mm", 20.0)? * 1e-3;
    let angle = ask_number("Contact angle, degrees; 0 for a deep-groove bearing", angle.unwrap_or(0.0))?;
    Ok(NewCase::new(Envelope { bore, outside, width, contact_angle: angle.to_radians() }))
}

fn ask_operation(case: &mut NewCase) -> Result<(), Failure> {
    let optional = |question: &str, known: Option<f64>| -> Result<Option<f64>, Failure> {
        if known.is_some() {
            return Ok(known);
        }
        let answer = ask(&format!("{question}; empty for a moderate one"), "")?;
        if answer.is_empty() { Ok(None) } else { parsed(question, &answer).map(Some) }
    };
    case.radial_load = optional("Radial load, N", case.radial_load)?;
    case.axial_load = optional("Axial load, N", case.axial_load)?;
    let rpm = case.speed.map(|speed| speed * 30.0 / std::f64::consts::PI);
    case.speed = optional("Speed, r/min", rpm)?.map(|rpm| rpm * std::f64::consts::PI / 30.0);
    Ok(())
}

fn ask_number(question: &str, usual: f64) -> Result<f64, Failure> {
    let answer = ask(question, &usual.to_string())?;
    parsed(question, &answer)
}

fn parsed(question: &str, answer: &str) -> Result<f64, Failure> {
    let number = answer.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| Failure::Option {
        option: "ask",
        value: answer.to_owned(),
        message: format!("{question}: allowed is a number"),
    })
}

/// Asks on the terminal; an empty answer is the usual one.
fn ask(question: &str, usual: &str) -> Result<String, Failure> {
    let input = std::io::stdin();
    if !input.is_terminal() {
        let message = "no terminal to ask on: give the values as options".to_owned();
        return Err(Failure::Option { option: "ask", value: String::new(), message });
    }
    let mut prompt = std::io::stderr();
    let shown = if usual.is_empty() { String::new() } else { format!(" [{usual}]") };
    write!(prompt, "{question}{shown}: ")?;
    prompt.flush()?;
    let mut answer = String::new();
    input.lock().read_line(&mut answer)?;
    let answer = answer.trim();
    Ok(if answer.is_empty() { usual.to_owned() } else { answer.to_owned() })
}
