//! The words and tables of a report, before they are HTML or Markdown.

use super::Answer;
use crate::input::CaseFile;
use crate::run::{Summary, acceleration};
use crate::table::number;
use tribodyn_bearing::case::{Source, locate};
use tribodyn_record::Run;

/// Everything but the figures.
pub struct Content {
    pub title: String,
    /// What the reader must know first.
    pub warnings: Vec<String>,
    pub tables: Vec<Table>,
    pub notes: Vec<String>,
    /// Text of the case file.
    pub case_text: Option<String>,
}

pub struct Table {
    pub title: &'static str,
    /// A sentence below the title; may be empty.
    pub text: String,
    pub header: Vec<&'static str>,
    pub rows: Vec<Vec<String>>,
    /// Columns with numbers, aligned right.
    pub numbers: std::ops::Range<usize>,
    /// As wide as the page.
    pub wide: bool,
}

/// Warnings of one kind of which more are counted only.
const MOST_WARNINGS: usize = 12;
/// Characters of a value of the case that are shown.
const MOST_CHARACTERS: usize = 90;

impl Content {
    pub fn new(answer: &Answer, case: Option<&CaseFile>, run: &Run) -> Self {
        let mut tables =
            vec![results(answer), powers(&answer.summary), frequencies(answer), wear(answer), facts(answer, run)];
        if !answer.validation.is_empty() {
            tables.push(validation(answer));
        }
        tables.extend(case.map(values));
        let title = if answer.bearing.is_empty() { "Transient run".to_owned() } else { answer.bearing.clone() };
        Self {
            title,
            warnings: warnings(answer),
            tables,
            notes: answer.notes.clone(),
            case_text: run.case_text.clone(),
        }
    }
}

fn warnings(answer: &Answer) -> Vec<String> {
    let mut all = Vec::new();
    if answer.truncated {
        let end = number(answer.summary.simulated_s, 6);
        all.push(format!("The recording ends before its end mark: the run was killed or is still going on. The last sample is at {end} s."));
    }
    if answer.chunks_bad > 0 {
        all.push(format!("{} damaged parts of the recording are missing.", answer.chunks_bad));
    }
    all.extend(answer.warnings_at_start.iter().map(|warning| format!("At the start: {warning}")));
    all.extend(answer.untested_pressures.iter().cloned());
    let of_run = &answer.summary.warnings;
    all.extend(of_run.iter().take(MOST_WARNINGS).cloned());
    if of_run.len() > MOST_WARNINGS {
        all.push(format!("… and {} more; all of them are in the log of the recording.", of_run.len() - MOST_WARNINGS));
    }
    all
}

fn row(name: &str, value: String, unit: &str) -> Vec<String> {
    vec![name.to_owned(), value, unit.to_owned()]
}

fn results(answer: &Answer) -> Table {
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
        row("Largest pressure, inner / outer", pair(s.pressure_inner_max_gpa, s.pressure_outer_max_gpa, 3), "GPa"),
        row("Largest pocket force", number(s.pocket_force_max_n, 1), "N"),
        row("Impacts on pockets, whole run", s.impacts.to_string(), ""),
        row("Fewest balls in contact, whole run", s.balls_in_contact_min.to_string(), ""),
    ];
    if let Some(speed) = answer.cage_speed_quasi_static_rpm {
        rows.insert(1, row("Cage speed, quasi-static solution", number(speed, 3), "r/min"));
    }
    let text = format!(
        "Means and extremes of the second half of the run, {} to {} s. Rms and peak are about the mean.",
        number(s.averaged_from_s, 4),
        number(s.simulated_s, 4)
    );
    Table { title: "Results", text, header: vec!["Quantity", "Value", "Unit"], rows, numbers: 1..2, wide: false }
}

fn powers(s: &Summary) -> Table {
    let p = &s.power;
    let total = p.shaft_w + p.load_w;
    let share = |w: f64| if total == 0.0 { String::new() } else { number(100.0 * w / total, 2) };
    let mut rows = vec![
        vec!["In: shaft".to_owned(), number(p.shaft_w, 1), share(p.shaft_w)],
        vec!["In: loads on the rings".to_owned(), number(p.load_w, 1), share(p.load_w)],
    ];
    rows.extend(p.out().map(|(name, w)| vec![format!("Out: {name}"), number(w, 1), share(w)]));
    let text = format!(
        "Means of the second half. Work missing over the whole run: {} parts per billion of all work put in.",
        number(p.imbalance_ppb, 3)
    );
    Table {
        title: "Power balance",
        text,
        header: vec!["Power", "W", "% of the input"],
        rows,
        numbers: 1..3,
        wide: false,
    }
}

fn frequencies(answer: &Answer) -> Table {
    let f = &answer.frequencies;
    let rows = [
        ("Shaft against outer ring, f_i", f.shaft_hz),
        ("Cage, f_c", f.cage_hz),
        ("Balls over a point of the outer race", f.ball_pass_outer_hz),
        ("Balls over a point of the inner race", f.ball_pass_inner_hz),
        ("Spin of a ball", f.ball_spin_hz),
        ("A spot of a ball on either race", f.ball_defect_hz),
    ];
    Table {
        title: "Frequencies",
        text: "From the mean speeds of the second half, slip included.".to_owned(),
        header: vec!["Event", "Hz"],
        rows: rows.map(|(name, hz)| vec![name.to_owned(), number(hz, 2)]).to_vec(),
        numbers: 1..2,
        wide: false,
    }
}

fn wear(answer: &Answer) -> Table {
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
    Table { title: "Wear", text, header: vec!["Quantity", "Value", "Unit"], rows, numbers: 1..2, wide: false }
}

/// The figures of `--against`.
fn validation(answer: &Answer) -> Table {
    let met = answer.validation.iter().filter(|row| row.met).count();
    let rows = answer.validation.iter().map(|row| {
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
        title: "Validation",
        text: format!(
            "{met} of {} figures are met; units stand at the end of a quantity's name.",
            answer.validation.len()
        ),
        header: vec!["Row", "Quantity", "Published", "Computed", "Deviation", "Tolerance", "Verdict", "Source"],
        rows: rows.collect(),
        numbers: 2..6,
        wide: true,
    }
}

fn facts(answer: &Answer, run: &Run) -> Table {
    let mut rows = vec![
        vec!["Recording".to_owned(), answer.recording.display().to_string()],
        vec!["Simulated time, s".to_owned(), number(answer.summary.simulated_s, 6)],
        vec!["Samples of rings and cage".to_owned(), run.states.len().to_string()],
        vec!["Samples of the balls".to_owned(), run.balls.len().to_string()],
    ];
    if let Some(error) = answer.patch_error_estimate {
        rows.push(vec!["Patch error estimate (of the load)".to_owned(), format!("{error:.1e}")]);
    }
    let entries = run.metadata.get("simulation").into_iter().flatten();
    rows.extend(entries.map(|(key, value)| vec![key.clone(), value.clone()]));
    let text = "What the recording says of itself.".to_owned();
    Table { title: "Run", text, header: vec!["Entry", "Value"], rows, numbers: 0..0, wide: true }
}

/// The values of the case that have a source, with it.
fn values(file: &CaseFile) -> Table {
    let rows = file.case.sources.iter().map(|(path, source)| {
        let value = locate(&file.text, path).map_or("", |range| &file.text[range]);
        let (class, from) = match source {
            Source::Published(from) => ("published", from.clone()),
            Source::Catalogue(from) => ("catalogue", from.clone()),
            Source::Reference(from) => ("reference", from.clone()),
            Source::Assumed(why) => ("assumed", why.clone()),
            Source::Identified { spread, from } => ("identified", format!("spread {spread}; {from}")),
        };
        vec![path.clone(), short(value), class.to_owned(), from]
    });
    Table {
        title: "Case",
        text: "Values with their sources, which are those of the case file where an option changed the value for this run; the whole case, as it was run, is at the end.".to_owned(),
        header: vec!["Path", "Value", "Class", "Source"],
        rows: rows.collect(),
        numbers: 0..0,
        wide: true,
    }
}

/// A value on one line, cut where it is long.
fn short(value: &str) -> String {
    let line = value.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.chars().count() <= MOST_CHARACTERS {
        return line;
    }
    line.chars().take(MOST_CHARACTERS - 1).chain(['…']).collect()
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn limit_long_values_are_cut_between_characters() {
        assert_eq!(short("(\n    a: 1,\n)"), "( a: 1, )");
        let long = short(&"µ".repeat(200));
        assert_eq!((long.chars().count(), long.chars().last()), (90, Some('…')));
    }
}
