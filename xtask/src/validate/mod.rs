//! `cargo xtask validate` and `cargo xtask fixtures`.

mod contact;
mod curves;
mod document;
mod dynamic;
mod expected;
mod friction;
mod output;
mod over_azimuth;
mod published;
mod row;
mod runs;
mod tables;

use crate::error::Failure;
use crate::files;
use crate::transient::{Set, in_time};
pub use dynamic::{defect_rows, rows as dynamic_rows};
use published::Published;
pub use row::{Evidence, Row, Verdict};
use runs::Runs;
use serde::Serialize;
use std::io::Write;
use std::path::{Path, PathBuf};
use tables::PressuresOver;
use tribodyn_quasistatic::Model;

/// Options of `validate`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Another case file; committed results and verdicts are those of the paper's case and are not compared then
    #[arg(long, value_name = "FILE")]
    case: Option<PathBuf>,
    /// Folder for tables, recordings and figures
    #[arg(short, long, value_name = "DIR", default_value = "target/validation")]
    output: PathBuf,
    /// Fail where documents or declared verdicts are out of date
    #[arg(long, conflicts_with = "case")]
    check: bool,
}

/// What a solution warns of.
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
    /// How the case's unpublished values were found.
    provenance: String,
    /// How Table 5's values come from those of the balls.
    interpolation: String,
    rows: Vec<Row>,
    warnings: Vec<Warning>,
    #[serde(skip)]
    published: Published,
}

impl Report {
    fn count(&self, verdict: Verdict) -> usize {
        self.rows.iter().filter(|row| row.verdict == verdict).count()
    }
}

fn paper_case() -> PathBuf {
    files::root().join("fixtures/cases/paper-ag.ron")
}

fn build(case: &Path, recordings: Option<&Path>) -> Result<(Report, Runs), Failure> {
    let published = Published::read()?;
    let runs = Runs::solve(case)?;
    let dynamic = match case == paper_case() {
        false => None,
        true => Some(in_time("dynamic runs", || Set::run(recordings))?),
    };
    let rows = [
        tables::table_2(&published)?,
        tables::table_4(&published, &runs),
        tables::table_5(&published, &runs),
        curves::figure_9()?,
        contact::figure_14(&runs),
        friction::figures_16_to_18(&runs),
        dynamic.as_ref().map_or_else(|| Ok(dynamic::not_yet()), dynamic::rows)?,
    ];
    let report = Report {
        case: runs.file.clone(),
        provenance: runs.provenance(),
        interpolation: PressuresOver::new(&runs.cases[0]).explanation(),
        rows: rows.concat(),
        warnings: warnings(&published, &runs, dynamic.as_ref()),
        published,
    };
    Ok((report, runs))
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
        if run.solution.model == Model::JonesHarris || !run.case.traction.varying {
            continue;
        }
        let pressures: Vec<f64> = over_azimuth::values(run, |b| b.peak_pressure_inner_pa * 1e-9)
            .chain(over_azimuth::values(run, |b| b.peak_pressure_outer_pa * 1e-9))
            .collect();
        let [low, high] = over_azimuth::limits(pressures.iter().copied());
        let below = pressures.iter().filter(|&&p| p < lowest).count();
        if below > 0 {
            let text = format!(
                "peak pressures {low:.2} to {high:.2} GPa: {below} of {} contacts lie below the lowest test at {lowest} GPa, where the curve is extrapolated",
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

/// Rebuilds all rows, writes the files and compares with what is committed.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let case = arguments.case.clone().unwrap_or_else(paper_case);
    let folder = &arguments.output;
    let (report, runs) = build(&case, Some(folder))?;
    let fixtures = expected::fixtures(&report.published, &runs);
    expected::write(folder, &fixtures)?;
    let json = output::json(&report)?;
    files::write(&folder.join("validation.json"), json.as_bytes())?;
    output::recordings(folder, &runs)?;
    output::figures(folder, &runs, &report.published)?;
    print(&if arguments.json { json } else { output::text(&report) })?;
    if arguments.case.is_some() {
        return Ok(());
    }
    compare(&report, &fixtures, arguments.check)
}

/// Regressions and declared verdicts; with `check` also whether documents are current.
fn compare(report: &Report, fixtures: &[expected::Fixture], check: bool) -> Result<(), Failure> {
    let mut findings = expected::regressions(fixtures)?;
    let declared = expected::compare_verdicts(&report.rows)?;
    findings.extend(declared.broken);
    if check {
        findings.extend(declared.outdated);
        findings.extend(document::outdated(report)?);
        findings.extend(document::outdated_sensitivity()?);
    } else {
        declared.outdated.iter().for_each(|finding| eprintln!("note: {finding}"));
    }
    if findings.is_empty() {
        return Ok(());
    }
    Err(Failure::Check { what: "validation differs from what is committed", findings })
}

/// The same as `cargo xtask validate --check`, into the given folder.
pub fn check(output: PathBuf) -> Result<(), Failure> {
    run(&Arguments { json: false, case: None, output, check: true })
}

/// Rewrites fixtures, declared verdicts and the documents' blocks.
pub fn rewrite_fixtures() -> Result<(), Failure> {
    let (report, runs) = build(&paper_case(), None)?;
    let folder = expected::folder();
    expected::write(&folder, &expected::fixtures(&report.published, &runs))?;
    expected::write(&folder, &[expected::verdicts_text(&report.rows)])?;
    document::rewrite(&report)?.iter().for_each(|finding| eprintln!("note: {finding}"));
    document::rewrite_sensitivity()?;
    print(&format!("{}\n", document::summary(&report)))
}

/// The charts of the quasi-static cases with the paper's points.
pub fn solution_charts() -> Result<Vec<tribodyn_plot::SolutionCharts>, Failure> {
    output::charts(&Runs::solve(&paper_case())?, &Published::read()?)
}

/// Rewrites the table of sensitivities from its committed result.
pub fn rewrite_sensitivity() -> Result<(), Failure> {
    document::rewrite_sensitivity()
}

fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = std::io::stdout().lock();
    stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()).map_err(Failure::Print)
}
