//! Tables of results.

use super::Answer;
use super::page_table::Table;
use crate::words::acceleration;
use crate::words::number;
use tribodyn_record::Run;
use tribodyn_signal::BearingFrequencies;
use tribodyn_study::evaluation::facts::Rolling;
use tribodyn_study::evaluation::published::Compared;
use tribodyn_study::evaluation::quantities::{Quantities, Values};
use tribodyn_study::run::{CageMotion, Summary, imbalance};

fn row(name: &str, value: String, unit: &str) -> Vec<String> {
    vec![name.to_owned(), value, unit.to_owned()]
}

pub fn results(answer: &Answer) -> Table {
    let s = &answer.summary;
    let range = |a: f64, b: f64, digits| format!("{} … {}", number(a, digits), number(b, digits));
    let pair = |a: f64, b: f64, digits| format!("{} / {}", number(a, digits), number(b, digits));
    let of = |x: f64, y: f64| acceleration(pair(x, y, 3), answer.accelerations_supported);
    let (rms, rms_unit) = of(s.outer_acceleration_x_rms_m_s2, s.outer_acceleration_y_rms_m_s2);
    let (peak, peak_unit) = of(s.outer_acceleration_x_peak_m_s2, s.outer_acceleration_y_peak_m_s2);
    let mut rows = vec![
        row("Cage speed, mean", number(s.cage_speed_mean_rpm, 3), "r/min"),
        row("Orbital speeds of the balls", range(s.orbital_speed_min_rpm, s.orbital_speed_max_rpm, 2), "r/min"),
        row("Acceleration of the outer ring, rms, X / Y", rms, rms_unit),
        row("Acceleration of the outer ring, peak, X / Y", peak, peak_unit),
        row("Largest contact load, inner / outer", pair(s.load_inner_max_n, s.load_outer_max_n, 1), "N"),
        row(
            "Largest pressure, inner / outer",
            pair(s.peak_pressure_inner_max_gpa, s.peak_pressure_outer_max_gpa, 3),
            "GPa",
        ),
        row("Largest pocket force", number(s.pocket_force_max_n, 1), "N"),
        row("Impacts on pockets, whole run", s.impacts.to_string(), ""),
        row("Fewest balls in contact, whole run", s.balls_in_contact_min.to_string(), ""),
    ];
    rows.extend(s.cage.iter().flat_map(cage));
    rows.insert(1, row("Cage speed at the start", number(s.cage_speed_start_rpm, 3), "r/min"));
    let text = format!(
        "Means and extremes from {} to {} s. Rms and peak are about the mean. {}",
        number(s.averaged_from_s, 4),
        number(s.simulated_s, 4),
        s.settled.sentence()
    );
    Table {
        title: "Results".to_owned(),
        text,
        header: vec!["Quantity", "Value", "Unit"],
        rows,
        numbers: 1..2,
        wide: false,
    }
}

/// Of a cage that is free to move.
fn cage(c: &CageMotion) -> Vec<Vec<String>> {
    let pair = |a: f64, b: f64, digits| format!("{} / {}", number(a, digits), number(b, digits));
    let mut rows = vec![
        row("Cage", c.sentence(), ""),
        row("Cage centre, mean X / Y", pair(c.mean_x_um, c.mean_y_um, 2), "µm"),
        row("Cage centre about it, rms / largest", pair(c.radius_rms_um, c.radius_max_um, 2), "µm"),
    ];
    if let (Some(ratio), Some(spread)) = (c.whirl_ratio, c.whirl_ratio_spread) {
        rows.push(row("Whirl over cage speed / spread", pair(ratio, spread, 3), ""));
    }
    rows.push(row("Largest tilt of the cage", number(c.tilt_max_mrad, 3), "mrad"));
    let forces = pair(c.land_force_inner_max_n, c.land_force_outer_max_n, 2);
    rows.push(row("Largest land force, inner / outer", forces, "N"));
    rows.push(row("Smallest land gap", number(c.land_gap_min_um, 2), "µm"));
    rows
}

pub fn powers(s: &Summary) -> Table {
    let p = &s.power;
    let total = p.mean.shaft_w + p.mean.load_w;
    let share = |w: f64| if total == 0.0 { String::new() } else { number(100.0 * w / total, 2) };
    let mut rows = vec![
        vec!["In: shaft".to_owned(), number(p.mean.shaft_w, 1), share(p.mean.shaft_w)],
        vec!["In: loads on the rings".to_owned(), number(p.mean.load_w, 1), share(p.mean.load_w)],
    ];
    rows.extend(p.out().into_iter().map(|(name, w)| vec![format!("Out: {name}"), number(w, 1), share(w)]));
    let text = format!(
        "Means from {} to {} s. Work missing over the whole run: {} % of all work put in.",
        number(s.averaged_from_s, 4),
        number(s.simulated_s, 4),
        imbalance(p.imbalance_percent)
    );
    Table {
        title: "Power balance".to_owned(),
        text,
        header: vec!["Power", "W", "% of the input"],
        rows,
        numbers: 1..3,
        wide: false,
    }
}

/// Characteristic frequencies by name and formula: of pure rolling, and of the mean speeds with all their slip.
pub fn frequencies(measured: &BearingFrequencies, rolling: Option<&Rolling>) -> Table {
    type Line = (&'static str, &'static str, fn(&BearingFrequencies) -> f64);
    let lines: [Line; 6] = [
        ("Shaft against outer ring, f_r", "f_i − f_o", |f| f.shaft_hz),
        ("FTF, cage", "½ [f_i (1 − γ) + f_o (1 + γ)]", |f| f.cage_hz),
        ("BPFO, balls over a point of the outer race", "N (FTF − f_o)", |f| f.ball_pass_outer_hz),
        ("BPFI, balls over a point of the inner race", "N (f_i − FTF)", |f| f.ball_pass_inner_hz),
        ("BSF, turns of a ball", "d_m/(2D) (1 − γ²) (f_i − f_o)", |f| f.ball_spin_hz),
        ("2 BSF, a spot of a ball on either race", "2 BSF", |f| f.ball_defect_hz),
    ];
    let rows = lines.map(|(name, formula, get)| {
        let dash = || "–".to_owned();
        let order = if measured.shaft_hz > 0.0 { number(get(measured) / measured.shaft_hz, 4) } else { dash() };
        let by_formula = rolling.map_or_else(dash, |r| number(get(&r.frequencies), 2));
        vec![name.to_owned(), formula.to_owned(), by_formula, number(get(measured), 2), order]
    });
    let mut text = "Computed: from the mean speeds of rings, cage and balls, slip included.".to_owned();
    if let Some(r) = rolling {
        text += &format!(
            " Formula: pure rolling with N = {}, γ = D cos α/d_m = {:.5} at the mean operating contact angle α = {:.3}°.",
            r.ball_count, r.gamma, r.contact_angle_deg
        );
    }
    Table {
        title: "Characteristic frequencies".to_owned(),
        text,
        header: vec!["Frequency", "Formula", "By formula, Hz", "Computed, Hz", "Per turn of the shaft"],
        rows: rows.to_vec(),
        numbers: 2..5,
        wide: true,
    }
}

/// Angles, loads, slip and spin of the contacts, torque, displacement and load zone.
pub fn operation(all: &Quantities, text: &str) -> Table {
    let rows = all.0.iter().map(|q| {
        let shown = |value: f64| number(value, q.digits);
        let [min, mean, max] = match q.values {
            Values::One(value) => [String::new(), shown(value), String::new()],
            Values::Span { min, mean, max } => [min, mean, max].map(shown),
        };
        vec![q.name.to_string(), min, mean, max, q.unit.to_owned()]
    });
    Table {
        title: "Operation".to_owned(),
        text: text.to_owned(),
        header: vec!["Quantity", "Least", "Mean", "Greatest", "Unit"],
        rows: rows.collect(),
        numbers: 1..4,
        wide: true,
    }
}

/// A sentence on the part of a run that the table of its operation is of.
pub fn steady(answer: &Answer) -> String {
    let s = &answer.summary;
    format!(
        "Over all balls from {} to {} s, where they carry load. {} The load zone is where the inner race carries a ball with more than 1 % of the highest load.",
        number(s.averaged_from_s, 4),
        number(s.simulated_s, 4),
        s.settled.sentence()
    )
}

/// Table of the start, before the part that the means are of.
pub fn start(answer: &Answer) -> Option<Table> {
    let text = format!("The first {} s, which are in no mean.", number(answer.summary.averaged_from_s, 4));
    (!answer.start.0.is_empty()).then(|| Table { title: "Start".to_owned(), ..operation(&answer.start, &text) })
}

pub fn wear(answer: &Answer) -> Table {
    let w = &answer.summary.wear;
    let rows = vec![
        row("Thinnest coating left, inner race", number(w.coating_inner_min_um, 4), "µm"),
        row("Thinnest coating left, outer race", number(w.coating_outer_min_um, 4), "µm"),
        row("Worn off the inner race", number(w.volume_inner_um3, 0), "µm³"),
        row("Worn off the outer race", number(w.volume_outer_um3, 0), "µm³"),
        row("Worn off the cage pockets", number(w.volume_cage_um3, 0), "µm³"),
    ];
    let text = format!(
        "Since the start, as recorded at {} s; any acceleration of wear is not in the volumes.",
        number(w.at_s, 4)
    );
    Table {
        title: "Wear".to_owned(),
        text,
        header: vec!["Quantity", "Value", "Unit"],
        rows,
        numbers: 1..2,
        wide: false,
    }
}

/// The figures of `--against`.
pub fn validation(all: &[Compared]) -> Table {
    let met = all.iter().filter(|row| row.met).count();
    let rows = all.iter().map(|row| {
        let value = |number: Option<f64>| number.map_or_else(|| "–".to_owned(), |n| format!("{n:.4}"));
        let short = |text: String| text.trim_end_matches('0').trim_end_matches('.').to_owned();
        vec![
            row.id.clone(),
            row.quantity.clone(),
            row.published.to_string(),
            short(value(row.computed)),
            short(value(row.computed.map(|computed| computed - row.published))),
            row.tolerance.to_string(),
            if row.met { "met" } else { "missed" }.to_owned(),
            row.source.clone(),
        ]
    });
    Table {
        title: "Validation".to_owned(),
        text: format!("{met} of {} figures are met; units stand at the end of a quantity's name.", all.len()),
        header: vec!["Row", "Quantity", "Published", "Computed", "Deviation", "Tolerance", "Verdict", "Source"],
        rows: rows.collect(),
        numbers: 2..6,
        wide: true,
    }
}

pub fn facts(answer: &Answer, run: &Run) -> Table {
    let mut rows = vec![
        vec!["Recording".to_owned(), answer.recording.display().to_string()],
        vec!["Simulated time, s".to_owned(), number(answer.summary.simulated_s, 6)],
        vec!["Samples of rings and cage".to_owned(), run.states.len().to_string()],
        vec!["Samples of the balls".to_owned(), run.balls.len().to_string()],
    ];
    if let Some(error) = answer.known.patch_error_estimate {
        rows.push(vec!["Patch error estimate (of the load)".to_owned(), format!("{error:.1e}")]);
    }
    let entries = run.metadata.get("simulation").into_iter().flatten();
    rows.extend(entries.map(|(key, value)| vec![key.clone(), value.clone()]));
    let text = "What the recording says of itself.".to_owned();
    Table { title: "Run".to_owned(), text, header: vec!["Entry", "Value"], rows, numbers: 0..0, wide: true }
}
