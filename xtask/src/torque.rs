//! `cargo xtask torque`: friction torque of catalogue bearings beside SKF's model, `docs/torque.md`.

use crate::error::Failure;
use crate::terminal::{print, progress};
use std::fmt::Write;
use tribodyn::answers::{Equations, TorqueAnswer, films, torque};
use tribodyn::{CaseFile, Limits};
use tribodyn_bearing::SearchWatch;
use tribodyn_catalogue::{NewCase, NewLubricant, find};
use tribodyn_paper::{files, markers};

const PAGE: &str = "docs/torque.md";
const MARKS: [&str; 2] = ["<!-- torque:begin -->", "<!-- torque:end -->"];
/// Designation, and contact angle in degrees of those that have one.
const BEARINGS: [(&str, Option<f64>); 5] =
    [("6204", None), ("6206", None), ("6308", None), ("7210", Some(40.0)), ("7014", Some(15.0))];
const GRADES: [&str; 2] = ["vg32", "vg68"];
/// Dynamic load rating over the load: radial for a deep-groove bearing, axial for an angular-contact one.
const LOADS: [f64; 3] = [50.0, 20.0, 10.0];
/// Speeds, r/min.
const SPEEDS: [f64; 6] = [500.0, 1000.0, 2000.0, 5000.0, 10_000.0, 15_000.0];
/// Oil and load of the rows on the page.
const ON_PAGE: (&str, f64) = ("vg68", 20.0);
/// Film parameter from which surfaces hardly touch.
const FULL_FILM: f64 = 3.0;
/// Deviation from SKF's model that is met.
const MET: f64 = 0.3;

/// Options of `cargo xtask torque`.
#[derive(Debug, Clone, clap::Args)]
pub struct Arguments {
    /// Rewrite the table in docs/torque.md
    #[arg(long)]
    write: bool,
}

/// One operating point.
struct Row {
    bearing: &'static str,
    grade: &'static str,
    load_share: f64,
    rpm: f64,
    /// Least λ of the loaded contacts.
    lambda: f64,
    torque: TorqueAnswer,
}

/// Prints the table, and writes it where asked to.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut rows = Vec::new();
    for (bearing, angle) in BEARINGS {
        for grade in GRADES {
            progress(&format!("{bearing} in {grade}"));
            for load_share in LOADS {
                for rpm in SPEEDS {
                    rows.push(row((bearing, angle), grade, load_share, rpm)?);
                }
            }
        }
    }
    print(&table(&rows, |_| true))?;
    if arguments.write {
        let path = files::root().join(PAGE);
        let on_page = |row: &Row| row.grade == ON_PAGE.0 && row.load_share == ON_PAGE.1;
        let page = markers::replaced(PAGE, &files::read(&path)?, &table(&rows, on_page), MARKS)?;
        files::write(&path, page.as_bytes())?;
    }
    Ok(())
}

fn row(
    (bearing, angle): (&'static str, Option<f64>),
    grade: &'static str,
    load_share: f64,
    rpm: f64,
) -> Result<Row, Failure> {
    let seed = |error: &dyn std::fmt::Display| Failure::Seed(format!("{bearing}, {rpm} r/min: {error}"));
    let listed = find(bearing, angle).map_err(|error| seed(&error))?;
    let load = listed.ratings.map_or(0.0, |ratings| ratings.dynamic) / load_share;
    let mut case = NewCase::of_listed(listed, bearing);
    case.lubricant = Some(NewLubricant::parse(grade).map_err(|error| seed(&error))?);
    [case.radial_load, case.axial_load] =
        if angle.is_some() { [Some(0.0), Some(load)] } else { [Some(load), Some(0.0)] };
    case.speed = Some(rpm * std::f64::consts::PI / 30.0);
    let text = case.text().map_err(|error| seed(&error))?;
    let file = CaseFile::from_text(bearing, text, &[], &Limits::NORMAL).map_err(|error| seed(&error))?;
    let question = file.question(SearchWatch::default());
    let found = torque(&question, Equations::Traction).map_err(|error| seed(&error))?;
    let films = films(&question, Equations::Traction).map_err(|error| seed(&error))?;
    let lambda = films.value().contacts.iter().map(|contact| contact.lambda_ratio).fold(f64::INFINITY, f64::min);
    Ok(Row { bearing, grade, load_share, rpm, lambda, torque: found.value().clone() })
}

/// The sums over all rows, and those rows that are shown.
fn table(rows: &[Row], shown: impl Fn(&Row) -> bool) -> String {
    let ratio = |row: &Row| row.torque.skf_torque_nm.map(|skf| row.torque.torque_nm / skf);
    let near = |row: &&Row| ratio(row).is_some_and(|ratio| (ratio - 1.0).abs() <= MET);
    let full: Vec<&Row> = rows.iter().filter(|row| row.lambda >= FULL_FILM).collect();
    let met = full.iter().copied().filter(near).count();
    let all = rows.iter().filter(near).count();
    let mut text = format!(
        "Within {:.0} % of SKF's model: {met} of {} points with λ ≥ {FULL_FILM} in every contact, {all} of all {}.\n\n",
        100.0 * MET,
        full.len(),
        rows.len()
    );
    text += "| bearing | oil | load | r/min | least λ | rolling | sliding | sum | SKF: rolling | sliding | sum | Palmgren | \
             sum/SKF |\n";
    text += "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for row in rows.iter().filter(|row| shown(row)) {
        let t = &row.torque;
        let milli = |torque: Option<f64>| torque.map_or_else(String::new, |torque| format!("{:.2}", 1e3 * torque));
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "| {} | {} | C/{} | {} | {:.2} | {:.2} | {:.2} | {:.2} | {} | {} | {} | {} | {} |",
            row.bearing,
            row.grade,
            row.load_share,
            row.rpm,
            row.lambda,
            1e3 * (t.rolling_nm + t.hysteresis_nm),
            1e3 * (t.sliding_inner_nm + t.sliding_outer_nm),
            1e3 * t.torque_nm,
            milli(t.skf_rolling_nm),
            milli(t.skf_sliding_nm),
            milli(t.skf_torque_nm),
            milli(t.palmgren_torque_nm),
            ratio(row).map_or_else(String::new, |ratio| format!("{ratio:.2}")),
        );
    }
    text
}
