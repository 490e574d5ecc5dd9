//! `tribodyn catalogue`: the bearings of the list.

use crate::failure::Failure;
use crate::table::{self, number};
use serde::Serialize;
use tribodyn_catalogue::{KnownBalls, ListedBearing, Origin, search};

/// List the bearings that `tribodyn new` knows, with their dimensions, load ratings and balls.
#[derive(clap::Args)]
pub struct Arguments {
    /// Part of a designation, such as 62 or 7210, or a pattern with * for any letters; all without it
    #[arg(value_name = "PATTERN", default_value = "", hide_default_value = true)]
    pattern: String,
    /// Print JSON, and nothing else, to standard output
    #[arg(long)]
    json: bool,
}

/// A bearing of the list.
#[derive(Serialize)]
struct Entry {
    designation: String,
    bore_mm: f64,
    outside_diameter_mm: f64,
    width_mm: f64,
    contact_angle_deg: f64,
    dynamic_rating_n: Option<f64>,
    static_rating_n: Option<f64>,
    ball_count: usize,
    ball_diameter_mm: f64,
    pitch_diameter_mm: f64,
    /// True for balls that are published; the others follow from the ratings.
    balls_published: bool,
    /// The larger deviation of the ratings of these balls from the catalogue's.
    rating_deviation: Option<f64>,
    /// The same of the set that comes second: where it is near, the balls are not certain.
    next_rating_deviation: Option<f64>,
    source: &'static str,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let found = search(&arguments.pattern);
    if found.is_empty() {
        let message = "no bearing of the list; `tribodyn catalogue` without a pattern prints all, and what a designation with prefix and suffixes stands for `tribodyn new` tells".to_owned();
        return Err(Failure::Option { option: "catalogue", value: arguments.pattern.clone(), message });
    }
    let entries: Vec<Entry> = found.into_iter().map(entry).collect::<Result<_, Failure>>()?;
    if arguments.json {
        return table::print_json(&entries);
    }
    let header =
        ["bearing", "d mm", "D mm", "B mm", "α °", "C_r N", "C_0r N", "balls", "D_w mm", "d_m mm", "balls from"];
    table::print_rows(&header, entries.iter().map(row))
}

fn entry(bearing: ListedBearing) -> Result<Entry, Failure> {
    let known = KnownBalls { published: bearing.balls, ..KnownBalls::default() };
    let set = bearing.envelope.ball_set(known, bearing.ratings)?;
    let (deviation, next) = match set.origin {
        Origin::Ratings { dynamic, at_rest, next } => {
            (Some(dynamic.abs().max(at_rest.abs())), next.map(|next| next.deviation))
        }
        _ => (None, None),
    };
    let mm = |metres: f64| (metres * 1e7).round() / 1e4;
    Ok(Entry {
        bore_mm: mm(bearing.envelope.bore),
        outside_diameter_mm: mm(bearing.envelope.outside),
        width_mm: mm(bearing.envelope.width),
        contact_angle_deg: bearing.envelope.contact_angle.to_degrees().round(),
        dynamic_rating_n: bearing.ratings.map(|ratings| ratings.dynamic),
        static_rating_n: bearing.ratings.map(|ratings| ratings.at_rest),
        ball_count: set.ball_count,
        ball_diameter_mm: mm(set.ball_diameter),
        pitch_diameter_mm: mm(set.pitch_diameter),
        balls_published: matches!(set.origin, Origin::Published { .. }),
        rating_deviation: deviation,
        next_rating_deviation: next,
        source: bearing.source,
        designation: bearing.designation,
    })
}

fn row(entry: &Entry) -> Vec<String> {
    let force = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |newtons| number(newtons, 0));
    let percent = |share: f64| format!("{} %", number(100.0 * share, 1));
    let from = match (entry.rating_deviation, entry.next_rating_deviation) {
        (Some(off), Some(next)) => format!("ratings, {}; next {}", percent(off), percent(next)),
        (Some(off), None) => format!("ratings, {}", percent(off)),
        _ if entry.balls_published => "published".to_owned(),
        _ => "rule of thumb".to_owned(),
    };
    vec![
        entry.designation.clone(),
        entry.bore_mm.to_string(),
        entry.outside_diameter_mm.to_string(),
        entry.width_mm.to_string(),
        entry.contact_angle_deg.to_string(),
        force(entry.dynamic_rating_n),
        force(entry.static_rating_n),
        entry.ball_count.to_string(),
        entry.ball_diameter_mm.to_string(),
        entry.pitch_diameter_mm.to_string(),
        from,
    ]
}
