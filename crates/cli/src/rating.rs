//! `tribodyn rating`: fatigue life and static safety by the standards.

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::search::{Search, TimeArguments};
use crate::solve::ModelName;
use crate::table::{self, number};
use tribodyn::answers::rated;
use tribodyn::rating::{Rating, RatingSource};
use tribodyn_signal::BearingFrequencies;

/// Rating life of the bearing's steel by ISO 281 and ISO/TS 16281, and static safety by ISO 76.
///
/// How long the coatings last is another question: `tribodyn life` answers it.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn rating 6206.ron
  tribodyn rating 7210B.ron --set 'ring.x.Force=lbf(400)' --json")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Equations of the load distribution [default: steady-orbit, or jones-harris for a case without traction or cage]
    #[arg(long, value_enum)]
    model: Option<ModelName>,
    #[command(flatten)]
    time: TimeArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let search = Search::begin(&file, &arguments.time);
    let equations = arguments.model.map(ModelName::equations);
    let found = rated(&file.question(search.watch()), equations).map_err(|error| search.failed(error))?;
    drop(search);
    if arguments.json {
        return table::print_json(&found);
    }
    let findings = found.findings();
    let name = format!("{}: {}", file.name, crate::harmless::visible(&file.case.name));
    table::print_head(&name, findings)?;
    let mut printed = rows(found.value(), findings.model().name());
    printed.extend(found.value().frequencies.iter().flat_map(|found| frequency_rows(found, LOADED)));
    table::print_pairs(&printed)?;
    if let Some(note) = &found.value().grease_note {
        table::print_line(&format!("note: {note}"))?;
    }
    table::print_warnings(findings.warnings())
}

pub type Row = (&'static str, String, &'static str);

/// Unit of frequencies of balls that roll at the nominal contact angle.
pub const NOMINAL: &str = "Hz, nominal angle";
/// Unit of those of balls that roll at the mean contact angle of the loaded ones.
pub const LOADED: &str = "Hz, angle under load";

/// Frequencies of defects, a row each, with the unit that says at which contact angle the balls roll.
pub fn frequency_rows(f: &BearingFrequencies, unit: &'static str) -> Vec<Row> {
    vec![
        ("rotation", number(f.shaft_hz, 3), "Hz"),
        ("cage, FTF", number(f.cage_hz, 3), unit),
        ("defect of the outer race, BPFO", number(f.ball_pass_outer_hz, 3), unit),
        ("defect of the inner race, BPFI", number(f.ball_pass_inner_hz, 3), unit),
        ("turns of a ball, BSF", number(f.ball_spin_hz, 3), unit),
        ("defect of a ball, 2 BSF", number(f.ball_defect_hz, 3), unit),
    ]
}

/// Ratings, lives and safeties, a row each.
pub fn rows(r: &Rating, model: &'static str) -> Vec<Row> {
    // Shown beside the value, where other rows have their unit.
    let rated = |value: f64, source| match source {
        RatingSource::Catalogue => (number(value, 0), "N, catalogue"),
        RatingSource::Computed => (number(value, 0), "N, computed"),
    };
    let (dynamic, dynamic_unit) = rated(r.dynamic_rating_n, r.dynamic_rating_source);
    let (at_rest, static_unit) = rated(r.static_rating_n, r.static_rating_source);
    let (limit, limit_unit) = rated(r.fatigue_load_limit_n, r.fatigue_load_limit_source);
    let mut rows = vec![
        ("nominal contact angle", number(r.nominal_contact_angle_deg, 2), "°"),
        ("dynamic load rating C_r", dynamic, dynamic_unit),
        ("static load rating C_0r", at_rest, static_unit),
        ("fatigue load limit C_u", limit, limit_unit),
    ];
    if let (Some(radial), Some(axial)) = (r.radial_load_n, r.axial_load_n) {
        rows.push(("loads, radial axial", format!("{}  {}", number(radial, 1), number(axial, 1)), "N"));
    }
    rows.push(("ball loads by the model", model.to_owned(), ""));
    let mut row = |name, value: Option<f64>, digits, unit| {
        rows.extend(value.map(|value| (name, number(value, digits), unit)));
    };
    let turns = "million turns";
    row("equivalent load P", r.equivalent_load_n, 1, "N");
    row("equivalent load of the ball loads P_ref", r.reference_load_n, 1, "N");
    row("basic rating life L_10, from P", r.rating_life_l10_mrev, 2, turns);
    row("reference rating life L_10r, from ball loads", r.rating_life_l10r_mrev, 2, turns);
    row("viscosity ratio κ", r.viscosity_ratio, 3, "");
    row("contamination factor e_C", r.contamination_factor, 2, "");
    row("life modification factor a_ISO", r.life_modification_factor, 3, "");
    row("reliability factor a_1", (r.reliability_factor != 1.0).then_some(r.reliability_factor), 3, "");
    row("modified reference rating life L_nmr", r.rating_life_lnmr_mrev, 2, turns);
    row("rating life of the steel", r.rating_life_hours, 0, "h");
    row("life of the grease, 9 of 10 (estimate)", r.grease_life_hours, 0, "h");
    row("relubrication interval, 99 of 100", r.grease_interval_hours, 0, "h");
    row("static safety s_0", r.static_safety, 2, "");
    row("load to 4.2 GPa over load", r.pressure_safety, 2, "");
    rows
}
