//! `tribodyn catalogue`: the bearings of the list.

use crate::failure::Failure;
use crate::table::{self, number};
use tribodyn::AnswerError;
use tribodyn_study::{Listed, StudyError, listed};

/// List the bearings that `tribodyn new` knows, with their dimensions, load ratings and balls.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn catalogue 62
  tribodyn catalogue 7012
  tribodyn catalogue '60*' --json")]
pub struct Arguments {
    /// Part of a designation, such as 62 or 7210, or a pattern with * for any letters [default: all]
    #[arg(value_name = "PATTERN", default_value = "", hide_default_value = true)]
    pattern: String,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let entries = listed(&arguments.pattern).map_err(of_pattern)?;
    if arguments.json {
        return table::print_json(&entries);
    }
    let header =
        ["bearing", "d mm", "D mm", "B mm", "α °", "C_r N", "C_0r N", "balls", "D_w mm", "d_m mm", "balls from"];
    table::print_rows(&header, entries.iter().map(row))
}

/// The pattern has no option's name.
fn of_pattern(error: StudyError) -> Failure {
    match error {
        StudyError::Answer(AnswerError::Argument { value, message, .. }) => Failure::Place { value, message },
        other => other.into(),
    }
}

fn row(entry: &Listed) -> Vec<String> {
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
