//! `tribodyn life --acting`: lives in which wear acts on the bearing.

use super::{Arguments, HOUR};
use crate::failure::Failure;
use crate::search::Search;
use crate::table::{self, number};
use std::ops::ControlFlow;
use tribodyn::CaseFile;
use tribodyn_study::sweep::Format;
use tribodyn_study::{
    ActingLife, ActingOptions, ActingStride, ActingTable, Effects, LifeEnd, Mission, Ours, acting_life, read_text,
};

/// Share of a race's load on bare steel at which a life ends unless another one is asked for.
const HALF: f64 = 0.5;

pub fn run(arguments: &Arguments, effects: &[String], file: &CaseFile) -> Result<(), Failure> {
    let search = Search::of_strides(file);
    let options = ActingOptions {
        effects: Effects::named(effects.iter().map(String::as_str))?,
        strides: arguments.strides,
        until_s: arguments.until.map(|hours| hours * HOUR),
        bare_limit: arguments.bare_limit.unwrap_or(HALF),
        equations: arguments.model.equations(),
        watch: search.watch(),
    };
    let limits = arguments.case.limits();
    let mission = match &arguments.mission {
        Some(path) => Mission::read(&read_text(path, &limits)?, file, &limits)?,
        None => Mission::steady(file, &limits)?,
    };
    for path in arguments.output.iter().chain(&arguments.map) {
        Format::of(path)?;
        arguments.replace.check(path, &arguments.case.path, Ours::Table)?;
    }
    let stride = |_: &ActingStride| {
        search.stride();
        ControlFlow::Continue(())
    };
    let life = match &arguments.output {
        None => acting_life(file, &mission, &options, stride)?,
        Some(path) => {
            let mut table = ActingTable::open(file, &mission, &options, (path, arguments.restart))?;
            let life = table.wear(stride)?;
            table.write(&life)?;
            life
        }
    };
    drop(search);
    if let Some(path) = &arguments.map {
        life.write_map(path)?;
    }
    if arguments.json {
        return table::print_json(&life);
    }
    print(&life)?;
    for path in arguments.output.iter().chain(&arguments.map) {
        table::print_line(&format!("{} is written", path.display()))?;
    }
    Ok(())
}

const HEADER: [&str; 13] = [
    "h_i µm",
    "h_o µm",
    "pre_i",
    "pre_o",
    "self",
    "bare_i",
    "bare_o",
    "V_i mm³",
    "V_o mm³",
    "cage mm³",
    "film mm³",
    "p_i GPa",
    "ω_c r/min",
];

fn print(a: &ActingLife) -> Result<(), Failure> {
    table::print_line(&format!("{}: {}", a.case, crate::harmless::visible(&a.bearing)))?;
    let acting = if a.effects.is_empty() { "nothing".to_owned() } else { a.effects.join(", ") };
    table::print_line(&format!("wear acts on: {acting}\n"))?;
    let (unit, per_hour) = if a.end_h < 1.0 { ("s", HOUR) } else { ("h", 1.0) };
    let time = |hours: f64| number(hours * per_hour, 2);
    let row = |r: &ActingStride| {
        vec![
            time(r.time_h),
            number(r.coating_inner_min_um, 3),
            number(r.coating_outer_min_um, 3),
            number(r.precoated_inner, 3),
            number(r.precoated_outer, 3),
            number(r.self_lubricated, 3),
            number(r.unlubricated_inner, 3),
            number(r.unlubricated_outer, 3),
            number(r.worn_inner_mm3, 3),
            number(r.worn_outer_mm3, 3),
            number(r.scraped_mm3, 3),
            number(r.film_mm3, 3),
            number(r.peak_pressure_inner_max_gpa, 3),
            number(r.cage_speed_rpm, 2),
        ]
    };
    let first = format!("time {unit}");
    let header: Vec<&str> = std::iter::once(first.as_str()).chain(HEADER).collect();
    table::print_rows(&header, a.strides.iter().map(row))?;
    table::print_line("")?;
    if let Some(spot) = &a.first_through {
        let azimuth = spot.azimuth_deg.map_or("all round".to_owned(), |azimuth| format!("at {azimuth:.0}°"));
        table::print_line(&format!(
            "after {} {unit} the first spot is through: {} race, {azimuth}, contact angle {:.2}°",
            time(spot.time_h),
            spot.race,
            spot.angle_deg
        ))?;
    }
    let end = match a.ended_by {
        LifeEnd::WornThrough => format!("bare steel carries {} % of a race's load", number(100.0 * a.bare_limit, 0)),
        _ => "the time is over".to_owned(),
    };
    table::print_line(&format!("after {} {unit}, {:.4e} turns: {end}", time(a.end_h), a.end_revolutions))?;
    table::print_warnings(&a.warnings)
}
