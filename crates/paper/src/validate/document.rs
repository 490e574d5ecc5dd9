//! The generated blocks of README.md and docs/validation.md.

use super::Report;
use super::row::{Evidence, Row, Verdict};
use super::weight::null;
use crate::error::PaperError;
use crate::markers::replaced;
use crate::{files, table};

const BEGIN: &str = "<!-- validation:begin -->";
const END: &str = "<!-- validation:end -->";

/// Content of a document's block.
#[derive(Clone, Copy)]
enum Extent {
    /// Counts by class of evidence.
    Summary,
    /// All rows with their notes as well.
    Everything,
}

const DOCUMENTS: [(&str, Extent); 2] = [("README.md", Extent::Summary), ("docs/validation.md", Extent::Everything)];

/// Rewrites the blocks; returns the documents that there are not.
pub fn rewrite(report: &Report) -> Result<Vec<String>, PaperError> {
    each(|name, extent| {
        let path = files::root().join(name);
        if !path.exists() {
            return Ok(Some(format!("{name}: there is no such file, so its block is not written")));
        }
        let text = replaced(name, &files::read(&path)?, &block(report, extent), [BEGIN, END])?;
        files::write(&path, text.as_bytes()).map(|()| None)
    })
}

/// Documents whose block is not what the rows give.
pub fn outdated(report: &Report) -> Result<Vec<String>, PaperError> {
    each(|name, extent| {
        let path = files::root().join(name);
        if !path.exists() {
            return Ok(Some(format!("{name}: there is no such file")));
        }
        let text = files::read(&path)?;
        let current = replaced(name, &text, &block(report, extent), [BEGIN, END])? == text;
        Ok((!current).then(|| format!("{name}: the validation block is out of date: run `cargo xtask fixtures`")))
    })
}

fn each(mut one: impl FnMut(&str, Extent) -> Result<Option<String>, PaperError>) -> Result<Vec<String>, PaperError> {
    let mut findings = Vec::new();
    for (name, extent) in DOCUMENTS {
        findings.extend(one(name, extent)?);
    }
    Ok(findings)
}

fn block(report: &Report, extent: Extent) -> String {
    if let Extent::Summary = extent {
        return brief(report);
    }
    let mut out = format!("{}\n\n", summary(report));
    let [speeds, pressures] = tables_4_and_5(report);
    out.push_str(&format!("Cage speeds (Table 4), r/min:\n\n{}\n", table::markdown(&SPEED_HEAD, &speeds)));
    out.push_str(&format!(
        "Peak pressures of case 1 (Table 5), GPa; {}:\n\n{}\n",
        report.interpolation,
        table::markdown(&PRESSURE_HEAD, &pressures)
    ));
    out.push_str(&format!("All rows:\n\n{}\n", table::markdown(&HEAD, &cells(&report.rows))));
    let notes: String = notes(&report.rows).iter().map(|note| format!("- {note}\n")).collect();
    out.push_str(&format!("How the rows were decided:\n\n{notes}\nWarnings of the solutions:\n\n"));
    let warnings: String = report.warnings.iter().map(|w| format!("- {}: {}\n", w.run, w.text)).collect();
    out.push_str(if warnings.is_empty() { "- none\n" } else { &warnings });
    out.push_str(&format!("\nOur own thresholds, varied:\n\n{}", super::thresholds::text(&report.rows)));
    out.push_str("\nReproduced by `cargo xtask validate`.\n");
    out
}

/// Classes of evidence, the strongest first, with their meaning.
const EVIDENCE: [(Evidence, &str); 4] = [
    (Evidence::Validation, "no parameter was chosen with the figure in view"),
    (Evidence::Calibration, "unpublished parameters were chosen with the figure in view"),
    (Evidence::Verification, "the equations give back what follows from their own input"),
    (Evidence::Beside, "not claims of the paper, or counted already"),
];

/// Counts by class of evidence.
fn brief(report: &Report) -> String {
    let count =
        |evidence, verdict| report.rows.iter().filter(|row| row.evidence == evidence && row.verdict == verdict).count();
    let of = |evidence| {
        let met = count(evidence, Verdict::Met);
        format!("{met} of {}", met + count(evidence, Verdict::Missed))
    };
    let row = |(evidence, meaning): (Evidence, &str)| {
        let open = count(evidence, Verdict::Contradictory) + count(evidence, Verdict::NotYet);
        vec![evidence.name().to_owned(), meaning.to_owned(), of(evidence), open.to_string()]
    };
    let head = ["evidence", "meaning", "met", "undecidable"];
    format!(
        "{} claims are met that no parameter was chosen for.{} Case `{}`: {}.\n\n{}\n\
        Reproduced by `cargo xtask validate`.\n",
        of(Evidence::Validation),
        null(&report.rows).map_or(String::new(), |null| format!(" {null}.")),
        report.case,
        report.provenance,
        table::markdown(&head, &EVIDENCE.map(row))
    )
}

/// Counts, and the rows that missed.
pub fn summary(report: &Report) -> String {
    let [met, missed, contradictory, not_yet] = Verdict::ALL.map(|verdict| report.count(verdict));
    let ids: Vec<&str> =
        report.claims().filter(|row| row.verdict == Verdict::Missed).map(|row| row.id.as_str()).collect();
    let figures = || figures(report.claims());
    let which = if ids.is_empty() { String::new() } else { format!(" Missed: {}.", ids.join(", ")) };
    format!(
        "Of {} rows {met} are met, {missed} missed, {contradictory} undecidable because the paper contradicts itself, \
        {not_yet} not decided; {} more are not claims of the paper or counted already. Of the {} rows of Figures 13 to \
        24 {} are met. Case `{}`: {}.{which}",
        report.claims().count(),
        report.rows.len() - report.claims().count(),
        figures().count(),
        figures().filter(|row| row.verdict == Verdict::Met).count(),
        report.case,
        report.provenance
    )
}

/// The claims of Figures 13 to 24 among rows that are met or missed.
pub fn figures<'a>(rows: impl Iterator<Item = &'a Row>) -> impl Iterator<Item = &'a Row> {
    let decided = |row: &&Row| matches!(row.verdict, Verdict::Met | Verdict::Missed);
    rows.filter(|row| row.of_figures()).filter(decided)
}

/// `T4.1, T4.2: note`: decided rows by note, in their order.
pub fn notes(rows: &[Row]) -> Vec<String> {
    let mut groups: Vec<(&str, Vec<&str>)> = Vec::new();
    for row in rows.iter().filter(|row| !row.note.is_empty() && row.verdict != Verdict::NotYet) {
        match groups.iter_mut().find(|(note, _)| *note == row.note) {
            Some((_, ids)) => ids.push(&row.id),
            None => groups.push((&row.note, vec![&row.id])),
        }
    }
    groups.iter().map(|(note, ids)| format!("{}: {note}", ids.join(", "))).collect()
}

pub const HEAD: [&str; 10] = [
    "id",
    "evidence",
    "quantity",
    "published",
    "computed",
    "deviation",
    "tolerance",
    "verdict",
    "missed in changes",
    "missed in draws",
];

pub fn cells(rows: &[Row]) -> Vec<Vec<String>> {
    let with_unit = |text: String, row: &Row| {
        if row.unit.is_empty() || text == "–" { text } else { format!("{text} {}", row.unit) }
    };
    let one = |row: &Row| {
        vec![
            row.id.clone(),
            row.evidence.name().to_owned(),
            row.quantity.clone(),
            row.published_text(),
            with_unit(row.computed_text(), row),
            row.deviation_text(),
            row.tolerance_text(),
            row.verdict.name().to_owned(),
            row.weight_text(),
            row.draws_text(),
        ]
    };
    rows.iter().map(one).collect()
}

pub const SPEED_HEAD: [&str; 5] = ["model", "published", "computed", "deviation", "verdict"];
pub const PRESSURE_HEAD: [&str; 7] =
    ["φ °", "p_i published", "p_i computed", "verdict", "p_o published", "p_o computed", "verdict"];

/// Tables 4 and 5, published beside computed.
pub fn tables_4_and_5(report: &Report) -> [Vec<Vec<String>>; 2] {
    let find = |id: &str| report.rows.iter().find(|row| row.id == id);
    let speeds = report.published.speeds.iter().filter_map(|printed| {
        let row = find(&format!("T4.{}", printed.id))?;
        let verdict = row.verdict.name().to_owned();
        Some(vec![printed.model.clone(), row.published_text(), row.computed_text(), row.deviation_text(), verdict])
    });
    let pressures = report.published.pressures.iter().filter_map(|printed| {
        let sides = [find(&format!("T5.{}.i", printed.azimuth))?, find(&format!("T5.{}.o", printed.azimuth))?];
        let of = |row: &Row| [row.published_text(), row.computed_text(), row.verdict.name().to_owned()];
        let [inner, outer] = sides.map(of);
        Some([vec![printed.azimuth.to_string()], inner.to_vec(), outer.to_vec()].concat())
    });
    [speeds.collect(), pressures.collect()]
}
