//! Sensitivity of the dynamic rows to the parameters that the paper hides, with the cases of the classical reading.
//!
//! One at a time, each is halved and doubled; and over a grid of pocket gap and pocket stiffness, from which both were
//! chosen, the residuals of the published figures are listed. Runs of 0.2 s with the fast scheme. Then the whole set of
//! runs with one thing changed, hidden or printed, for the rows that are missed: which change turns them, and what it
//! costs; other readings of the missed claims on the unchanged runs; and what the defect's unprinted size does to its
//! rows.

mod changes;
mod defect;
mod hidden;
mod misses;
mod prior;
mod readings;

pub use hidden::Searched;

use crate::error::PaperError;
use crate::files;
use crate::markers::replaced;
use crate::progress::Progress;
use crate::table::{Table, markdown};
use crate::transient::{AUTHORS, CLASSICAL, Change, FAST, Plan, Set, Transient, run_all};

/// File of the committed result, and the document that shows it.
const RESULT: &str = "fixtures/expected/sensitivity.csv";
const DOCUMENT: &str = "docs/validation.md";
const BEGIN: &str = "<!-- sensitivity:begin -->";
const END: &str = "<!-- sensitivity:end -->";

const GAPS_MM: [f64; 9] = [0.12, 0.3, 0.5, 0.65, 0.7, 0.71, 0.72, 0.75, 0.9];
const STIFFNESSES: [f64; 3] = [2.5, 5.0, 10.0];

const HEAD: &str = "change,cage_rpm,balls_rpm,orbit_low_rpm,orbit_high_rpm,peak_ag,rms_ag,peak_ptfe,force_n,share";

/// Both coatings with the same changes.
fn plans(changes: &[(&str, String)]) -> [Plan; 2] {
    [CLASSICAL.ag(), CLASSICAL.ptfe()].map(|plan| {
        let fast = plan.with("transient.scheme", FAST);
        changes.iter().fold(fast, |plan, (path, value)| plan.with(path, value))
    })
}

fn row(name: &str, ag: &Transient, ptfe: &Transient) -> String {
    let [a, p] = [ag, ptfe].map(|run| run.settled());
    let [low, high] = a.orbit_limits();
    let x = |s: &crate::transient::StateSample| s.outer_acceleration[0];
    format!(
        "{name},{:.1},{:.1},{low:.0},{high:.0},{:.1},{:.1},{:.1},{:.0},{}",
        a.cage_rpm(),
        a.mean_orbit_rpm(),
        a.peak(x),
        a.rms(x),
        p.peak(x),
        a.pocket_peak(),
        Some(a.impact_share([245.0, 330.0])).filter(|s| s.is_finite()).map_or("–".to_owned(), |s| format!("{s:.2}")),
    )
}

/// Makes the runs with halved and doubled parameters and over the grid, writes the result and returns its text.
///
/// # Errors
///
/// A run that stops before its end; the result cannot be written.
pub fn pocket() -> Result<String, PaperError> {
    let mut wanted: Vec<(String, Vec<(&str, String)>)> = vec![("as identified".to_owned(), Vec::new())];
    let hidden = changes::hidden(&CLASSICAL)?.into_iter();
    wanted.extend(hidden.map(|(name, path, value)| (name, vec![(path, value)])));
    wanted.push(("no cage".to_owned(), vec![("cage.pocket_stiffness", "N_per_um(0)".to_owned())]));
    for gap in GAPS_MM {
        for stiffness in STIFFNESSES {
            let changes = vec![
                ("cage.pocket_gap", format!("mm({gap})")),
                ("cage.pocket_stiffness", format!("N_per_um({stiffness})")),
            ];
            wanted.push((format!("gap {gap} mm stiffness {stiffness} N/µm"), changes));
        }
    }
    let all: Vec<Plan> = wanted.iter().flat_map(|(_, changes)| plans(changes)).collect();
    let runs = run_all(&all, None)?;
    let rows: Vec<String> =
        wanted.iter().zip(runs.chunks_exact(2)).map(|((name, _), pair)| row(name, &pair[0], &pair[1])).collect();
    let text = format!(
        "# our own output; rewritten by `cargo xtask sensitivity`\n# last orbits of runs of 0.2 s, fast scheme at 20 \
        us; accelerations of the outer ring along x, m/s2; force in pockets and share of impacts between 245 and 330 \
        degrees with Ag\n{HEAD}\n{}\n",
        rows.join("\n")
    );
    files::write(&files::root().join(RESULT), text.as_bytes())?;
    Ok(text)
}

/// Searches for what the paper hides of cage and supports, with a reading's cases, among so many sets and about the
/// best of them, by the rows that the search may see, and writes the best.
///
/// # Errors
///
/// The result cannot be written. A set whose runs fail is left out.
pub fn hidden(searched: Searched, sets: usize, progress: Progress) -> Result<(), PaperError> {
    hidden::run(searched, sets, progress)
}

/// Draws all that the paper does not print from its priors, so many times, and writes which rows each draw misses.
///
/// # Errors
///
/// The result cannot be written. A draw whose runs fail is noted in the result.
pub fn prior(draws: usize, progress: Progress) -> Result<(), PaperError> {
    prior::run(draws, progress)
}

/// The runs of the dynamic rows as identified, with the fast scheme: what every change is held against.
///
/// # Errors
///
/// A run that stops before its end.
pub fn base() -> Result<Base, PaperError> {
    Set::changed(&CLASSICAL, &Change::none("as identified")).map(Base)
}

/// Runs that every change is held against.
#[derive(Debug)]
pub struct Base(Set);

impl Base {
    /// Works out other readings of the missed rows and writes them.
    ///
    /// # Errors
    ///
    /// The result cannot be written.
    pub fn readings(&self) -> Result<(), PaperError> {
        readings::write(&self.0)
    }

    /// Makes the runs with each change, of these cases and of the paper's, and writes which missed rows it turns; with
    /// `only`, the lines of changes that do not have it in their names stay.
    ///
    /// # Errors
    ///
    /// The result cannot be read or written. A run that fails is noted in the result.
    pub fn rows(&self, only: Option<&str>, progress: Progress) -> Result<(), PaperError> {
        let authors = Set::changed(&AUTHORS, &Change::none("as identified"))?;
        misses::AUTHORS_CASE.run(&authors, only, progress)?;
        misses::CLASSICAL_CASE.run(&self.0, only, progress)
    }

    /// Makes the runs with defects of other sizes and writes their rows.
    ///
    /// # Errors
    ///
    /// A run that stops before its end; the result cannot be written.
    pub fn defects(&self) -> Result<(), PaperError> {
        defect::run(&self.0)
    }
}

/// Rewrites the document's block from the committed results.
///
/// # Errors
///
/// A result or the document cannot be read, or the document cannot be written.
pub fn rewrite() -> Result<(), PaperError> {
    let [_, now] = document()?;
    files::write(&files::root().join(DOCUMENT), now.as_bytes())
}

/// Says so where the document's block is not that of the committed results.
///
/// # Errors
///
/// A result or the document cannot be read.
pub fn outdated() -> Result<Option<String>, PaperError> {
    let [was, now] = document()?;
    Ok((was != now).then(|| {
        format!("{DOCUMENT}: the sensitivity table is not that of the committed result: run `cargo xtask fixtures`")
    }))
}

/// The document before and after its block is made from the committed results.
fn document() -> Result<[String; 2], PaperError> {
    let text = files::read(&files::root().join(DOCUMENT))?;
    let now = replaced(DOCUMENT, &text, &block()?, [BEGIN, END])?;
    Ok([text, now])
}

/// The document's block, from the committed result.
fn block() -> Result<String, PaperError> {
    let text = files::read(&files::root().join(RESULT))?;
    let table = Table::read(RESULT, &text)?;
    let head = [
        "change",
        "cage r/min",
        "balls r/min",
        "one ball r/min",
        "peak Ag m/s²",
        "rms Ag m/s²",
        "peak PTFE m/s²",
        "pocket force N",
        "impacts 245–330°",
    ];
    let mut rows = Vec::new();
    // The grid of gap and stiffness is in the committed result alone.
    for row in table.rows().filter(|row| !row.first().starts_with("gap ")) {
        let cell = |column: &str| row.text(column).map(str::to_owned);
        let range = format!("{}–{}", cell("orbit_low_rpm")?, cell("orbit_high_rpm")?);
        rows.push(vec![
            cell("change")?,
            cell("cage_rpm")?,
            cell("balls_rpm")?,
            range,
            cell("peak_ag")?,
            cell("rms_ag")?,
            cell("peak_ptfe")?,
            cell("force_n")?,
            cell("share")?,
        ]);
    }
    let misses = [misses::AUTHORS_CASE.block()?, misses::CLASSICAL_CASE.block()?];
    let tables = [misses.join("\n"), readings::block()?, defect::block()?].join("\n");
    Ok(format!(
        "{}\nThe grid of pocket gap and stiffness is in `{RESULT}`.\n\n{tables}\nReproduced by `cargo xtask sensitivity`.\n",
        markdown(&head, &rows)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_the_page_shows_the_committed_results() {
        assert_eq!(outdated().unwrap(), None);
    }
}
