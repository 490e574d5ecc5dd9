//! The rows of the validation: published, computed, deviation, tolerance, verdict; the files that hold them.

mod conclusions;
mod contact;
mod curves;
mod document;
mod dynamic;
mod expected;
mod friction;
mod output;
mod over_azimuth;
mod pairs;
mod published;
mod row;
mod runs;
mod split;
mod tables;
mod tally;
mod thresholds;
mod weight;

use crate::error::PaperError;
use crate::files;
use crate::progress::{Progress, in_time};
use crate::transient::{AUTHORS, CLASSICAL, Reading, Set};
pub(crate) use dynamic::{defect_rows, first_impacts_of, rows as dynamic_rows};
use published::Published;
pub(crate) use row::{Evidence, Row, Verdict};
use runs::Runs;
use serde::Serialize;
use std::path::{Path, PathBuf};
use tables::PressuresOver;
pub(crate) use tally::{Share, Tally};
use tribodyn_identify::Adapt;
use tribodyn_quasistatic::Model;
pub(crate) use weight::DRAWS as PRIOR_DRAWS;

/// Paths of a case and their values.
type Changes = [(String, String)];

/// Warnings of a solution.
#[derive(Debug, Serialize)]
struct Warning {
    run: String,
    text: String,
}

/// All rows and what belongs to them.
#[derive(Debug, Serialize)]
struct Report {
    /// Case file.
    case: String,
    /// Origin of the case's unpublished values.
    provenance: String,
    /// Rule by which Table 5's values follow from those of the balls.
    interpolation: String,
    rows: Vec<Row>,
    warnings: Vec<Warning>,
    #[serde(skip)]
    published: Published,
}

impl Report {
    /// Rows that are claims of the paper, each counted once.
    fn claims(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|row| row.evidence != Evidence::Beside)
    }

    fn count(&self, verdict: Verdict) -> usize {
        self.claims().filter(|row| row.verdict == verdict).count()
    }
}

/// The case file that the committed results and verdicts are of.
pub fn paper_case() -> PathBuf {
    files::root().join(AUTHORS.ag)
}

fn build(
    case: &Path,
    changes: &Changes,
    recordings: Option<&Path>,
    progress: Progress,
) -> Result<(Report, Runs), PaperError> {
    let published = Published::read()?;
    let runs = Runs::changed(case, changes)?;
    let dynamic = match Reading::of(case) {
        None => None,
        Some(reading) => Some(in_time("dynamic runs", progress, || Set::run(reading, changes, recordings))?),
    };
    let with = if changes.is_empty() { "" } else { " with " };
    let changes: Vec<String> = changes.iter().map(|(path, value)| format!("{path} = {value}")).collect();
    let report = Report {
        case: format!("{}{with}{}", runs.file, changes.join(", ")),
        provenance: runs.provenance(),
        interpolation: PressuresOver::new(&runs.cases[0]).explanation(),
        rows: decided(&published, &runs, dynamic.as_ref())?,
        warnings: warnings(&published, &runs, dynamic.as_ref()),
        published,
    };
    Ok((report, runs))
}

/// All rows, each with the part that the search had it in.
fn decided(published: &Published, runs: &Runs, dynamic: Option<&Set>) -> Result<Vec<Row>, PaperError> {
    let rows = [
        tables::table_2(published)?,
        tables::table_4(published, runs),
        tables::table_5(published, runs),
        curves::figure_9()?,
        contact::figure_14(runs),
        friction::figures_16_to_18(runs),
        conclusions::rows(published, runs),
        dynamic.map_or_else(|| Ok(dynamic::not_yet()), dynamic::rows)?,
    ];
    weight::weighed(pairs::joined(split::declared(rows.concat())?))
}

/// The solvers' warnings, balls without one clear equilibrium, and contacts whose pressure lies below the tests.
fn warnings(published: &Published, runs: &Runs, dynamic: Option<&Set>) -> Vec<Warning> {
    let lowest = published.curves.iter().map(|row| row.pressure).fold(f64::INFINITY, f64::min);
    let mut out = Vec::new();
    for run in runs.all() {
        out.extend(
            run.solution
                .warnings
                .iter()
                .chain(&run.roots)
                .map(|text| Warning { run: run.label.to_owned(), text: text.clone() }),
        );
        // Only where the curve follows the pressure is it extrapolated.
        if run.solution.model == Model::JonesHarris
            || !run.case.traction.as_ref().is_some_and(|traction| traction.varying)
        {
            continue;
        }
        let pressures: Vec<f64> = over_azimuth::values(run, |b| b.contacts.inner.peak_pressure_pa * 1e-9)
            .chain(over_azimuth::values(run, |b| b.contacts.outer.peak_pressure_pa * 1e-9))
            .collect();
        let [low, high] = over_azimuth::limits(pressures.iter().copied());
        let below = pressures.iter().filter(|&&p| p < lowest).count();
        if below > 0 {
            let text = format!(
                "peak pressures {low:.2} to {high:.2} GPa: {below} of {} contacts lie below the lowest test at \
                {lowest} GPa, where the curve is extrapolated",
                pressures.len()
            );
            out.push(Warning { run: run.label.to_owned(), text });
        }
    }
    for run in dynamic.iter().flat_map(|set| set.all()) {
        out.extend(run.warnings().map(|text| Warning { run: format!("run {}", run.label), text: text.to_owned() }));
    }
    out
}

/// Rows of Figures 14 and 16 to 18 of a case, relative to the workspace, with values changed.
pub(crate) fn azimuth_rows(case: &str, changes: &Changes) -> Result<Vec<Row>, PaperError> {
    let runs = Runs::changed(&files::root().join(case), changes)?;
    split::declared([contact::figure_14(&runs), friction::figures_16_to_18(&runs)].concat())
}

/// The same rows of a case's text, its bearings changed by what no case file can express.
pub(crate) fn azimuth_rows_of(name: &str, text: &str, adapt: Option<&Adapt>) -> Result<Vec<Row>, PaperError> {
    let runs = Runs::of(name.to_owned(), text, adapt)?;
    split::declared([contact::figure_14(&runs), friction::figures_16_to_18(&runs)].concat())
}

/// The same rows with the steady orbits of the four cases in place of their equilibria.
pub(crate) fn azimuth_rows_by_orbits(name: &str, text: &str) -> Result<Vec<Row>, PaperError> {
    let runs = Runs::of(name.to_owned(), text, None)?.by_orbits()?;
    split::declared([contact::figure_14(&runs), friction::figures_16_to_18(&runs)].concat())
}

/// Rows met of those of Figures 13 to 24 that decide something, and of Tables 4 and 5 with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Counts {
    /// Of those that the search may see.
    pub calibration: usize,
    /// Of those that are kept out of it.
    pub validation: usize,
    /// Of Tables 4 and 5.
    pub tables: usize,
}

impl Counts {
    /// Of rows as they are decided.
    fn of(rows: &[Row]) -> Self {
        let met = || rows.iter().filter(|row| row.verdict == Verdict::Met);
        let figures = |part| document::figures(met()).filter(|row| row.evidence == part).count();
        let table = |row: &&Row| row.evidence == Evidence::Calibration && row.id.starts_with('T');
        Self {
            calibration: figures(Evidence::Calibration),
            validation: figures(Evidence::Validation),
            tables: met().filter(table).count(),
        }
    }
}

/// Rows met of a reading's silver case with values changed, by the steps of the validation, and the dynamic rows.
pub(crate) fn counted(reading: &Reading, changes: &Changes) -> Result<(Counts, Vec<Row>), PaperError> {
    let runs = Runs::changed(&files::root().join(reading.ag), changes)?;
    let set = Set::healthy(reading, changes)?;
    let rows = decided(&Published::read()?, &runs, Some(&set))?;
    Ok((Counts::of(&rows), declared_dynamic_rows(&set)?))
}

/// Rows of the dynamic model, each with the part that the search had it in.
pub(crate) fn declared_dynamic_rows(set: &Set) -> Result<Vec<Row>, PaperError> {
    split::declared(dynamic_rows(set)?)
}

/// All rows of a case with the quasi-static solutions behind them.
#[derive(Debug)]
pub struct Validation {
    report: Report,
    runs: Runs,
    fixtures: [expected::Fixture; 2],
}

/// Differences of a validation from what is committed, in words.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Differences {
    /// Results that moved, and rows that are declared met and are not.
    pub broken: Vec<String>,
    /// Rows that do better than declared.
    pub outdated: Vec<String>,
}

impl Validation {
    /// Solves the case, with the values at some paths changed, and decides all rows; those of the dynamic model for the
    /// cases of a reading only, all of which get the changes. Recordings of its runs go into the folder if there is
    /// one.
    ///
    /// # Errors
    ///
    /// A case that is refused, a run that fails, a recording that cannot be written.
    pub fn new(
        case: &Path,
        changes: &[(String, String)],
        recordings: Option<&Path>,
        progress: Progress,
    ) -> Result<Self, PaperError> {
        let (report, runs) = build(case, changes, recordings, progress)?;
        let fixtures = expected::fixtures(&report.published, &runs);
        Ok(Self { report, runs, fixtures })
    }

    /// Writes Tables 4 and 5, `validation.json`, recordings of the solutions and figures into a folder.
    ///
    /// # Errors
    ///
    /// A file that cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(), PaperError> {
        expected::write(folder, &self.fixtures)?;
        files::write(&folder.join("validation.json"), self.json()?.as_bytes())?;
        output::recordings(folder, &self.runs)?;
        output::figures(folder, &self.runs, &self.report.published)
    }

    /// The report as JSON with a newline at its end.
    ///
    /// # Errors
    ///
    /// None with numbers and texts.
    pub fn json(&self) -> Result<String, PaperError> {
        output::json(&self.report)
    }

    /// The table for people.
    pub fn text(&self) -> String {
        output::text(&self.report)
    }

    /// Counts of the verdicts, and the rows that missed.
    pub fn summary(&self) -> String {
        document::summary(&self.report)
    }

    /// Regressions, and verdicts that are not those declared.
    ///
    /// # Errors
    ///
    /// A committed result that cannot be read.
    pub fn compare(&self) -> Result<Differences, PaperError> {
        let mut broken = expected::regressions(&self.fixtures)?;
        let declared = expected::compare_verdicts(&self.report.rows)?;
        broken.extend(declared.broken);
        Ok(Differences { broken, outdated: declared.outdated })
    }

    /// Documents whose generated blocks are not what the rows give.
    ///
    /// # Errors
    ///
    /// A document without the place of its block.
    pub fn outdated_documents(&self) -> Result<Vec<String>, PaperError> {
        document::outdated(&self.report)
    }

    /// Rewrites the committed results, the declared verdicts and the documents' blocks; returns the documents that
    /// there are not.
    ///
    /// # Errors
    ///
    /// A file that cannot be written, a document without the place of its block.
    pub fn rewrite(&self) -> Result<Vec<String>, PaperError> {
        let folder = expected::folder();
        expected::write(&folder, &self.fixtures)?;
        expected::write(&folder, &[expected::verdicts_text(&self.report.rows)])?;
        document::rewrite(&self.report)
    }
}

/// The charts of the quasi-static cases with the paper's points.
pub(crate) fn solution_charts() -> Result<Vec<tribodyn_plot::SolutionCharts>, PaperError> {
    output::charts(&Runs::solve(&files::root().join(CLASSICAL.ag))?, &Published::read()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_rows_met_are_counted_in_the_part_that_they_have() {
        let row = |id: &str, computed: f64| Row::number(id.into(), String::new(), [1.0, computed, 0.1]);
        let ids = ["T4.1", "F13.1", "F18.2", "F19.2", "F16.2", "F24.1.race"];
        let missed = [row("T4.2", 2.0), row("F14.3", 2.0), row("F20.1.load", f64::NAN)];
        let mut rows = split::declared(ids.map(|id| row(id, 1.0)).into_iter().chain(missed).collect()).unwrap();
        // Its own kinds of evidence do not count.
        rows.extend(["T2.ag.2.5.A", "power"].map(|id| Row { evidence: Evidence::Verification, ..row(id, 1.0) }));
        rows.push(Row { evidence: Evidence::Beside, ..row("T4.err.1", 1.0) });
        assert_eq!(Counts::of(&rows), Counts { calibration: 2, validation: 3, tables: 1 });
    }
}
