//! Files of a validation, and its table for people.

use super::Report;
use super::document::{HEAD, PRESSURE_HEAD, SPEED_HEAD, cells, notes, summary, tables_4_and_5};
use super::published::Published;
use super::row::Verdict;
use super::runs::Runs;
use crate::error::PaperError;
use crate::{files, table};
use std::path::Path;
use tribodyn_case::InputError;
use tribodyn_plot::{Quantity, SolutionCharts, solution_charts};
use tribodyn_record::{SolutionRecording, write_solution};

/// Wide enough for a page at 200 dots per inch.
const PNG_WIDTH: u32 = 1600;

/// One recording for each run.
pub fn recordings(folder: &Path, runs: &Runs) -> Result<(), PaperError> {
    std::fs::create_dir_all(folder).map_err(|source| PaperError::Write { path: folder.to_owned(), source })?;
    for run in runs.all() {
        let refused =
            |source| PaperError::Inputs { run: run.id.to_owned(), source: Box::new(InputError::Bearing(source)) };
        let bearing = run.case.bearing().map_err(refused)?;
        let recording = SolutionRecording {
            case_text: &run.text,
            name: &run.case.name,
            bearing: &bearing,
            point: &run.case.operating_point(),
            solution: &run.solution,
            generator: concat!("tribodyn xtask ", env!("CARGO_PKG_VERSION")),
        };
        write_solution(&folder.join(recording_name(run.id)), &recording)?;
    }
    Ok(())
}

fn recording_name(id: &str) -> String {
    if id == "jh" { "jones-harris.mcap".to_owned() } else { format!("case-{id}.mcap") }
}

/// Polar charts of cases 1 to 4 with Table 5's points.
pub fn charts(runs: &Runs, published: &Published) -> Result<Vec<SolutionCharts>, PaperError> {
    let lines: Vec<_> = runs.cases.iter().map(|run| (run.label, &run.solution)).collect();
    Ok(solution_charts(&lines, &points(published))?)
}

/// The figures of these charts.
pub fn figures(folder: &Path, runs: &Runs, published: &Published) -> Result<(), PaperError> {
    for charts in charts(runs, published)? {
        let figure = charts.figure()?;
        files::write(&folder.join(format!("{}.svg", figure.name)), figure.svg().as_bytes())?;
        files::write(&folder.join(format!("{}.png", figure.name)), &figure.png(PNG_WIDTH)?)?;
    }
    Ok(())
}

fn points(published: &Published) -> [tribodyn_plot::Published; 2] {
    [(Quantity::PeakPressureInner, 0), (Quantity::PeakPressureOuter, 1)].map(|(quantity, side)| {
        tribodyn_plot::Published {
            quantity,
            label: "published (Table 5)".to_owned(),
            run: None,
            points: published.pressures.iter().map(|p| (p.azimuth, p.pressure[side] * 1e9)).collect(),
            uncertainty: published.pressures.iter().map(|p| p.uncertainty * 1e9).reduce(f64::max),
        }
    })
}

/// The report as JSON with a newline at its end.
pub fn json(report: &Report) -> Result<String, PaperError> {
    Ok(serde_json::to_string_pretty(report)? + "\n")
}

/// The table for people, Tables 4 and 5 last.
pub fn text(report: &Report) -> String {
    let decided: Vec<_> = report.rows.iter().filter(|row| row.verdict != Verdict::NotYet).cloned().collect();
    let open: Vec<_> = report.rows.iter().filter(|row| row.verdict == Verdict::NotYet).cloned().collect();
    let mut out = table::aligned(&HEAD, &cells(&decided));
    out.push_str("\nnot decided:\n");
    out.extend(open.iter().map(|row| format!("  {}  {}\n", row.id, row.published_text())));
    out.push_str("\nhow rows were decided:\n");
    out.extend(notes(&decided).iter().map(|note| format!("  {note}\n")));
    out.push_str("\nwarnings of the solutions:\n");
    out.extend(report.warnings.iter().map(|w| format!("  {}: {}\n", w.run, w.text)));
    if report.warnings.is_empty() {
        out.push_str("  none\n");
    }
    out.push_str(&format!("\n{}\n", summary(report)));
    let [speeds, pressures] = tables_4_and_5(report);
    out.push_str(&format!("\nTable 4, cage speed, r/min\n{}", table::aligned(&SPEED_HEAD, &speeds)));
    out.push_str(&format!(
        "\nTable 5, peak pressure of case 1, GPa ({})\n{}",
        report.interpolation,
        table::aligned(&PRESSURE_HEAD, &pressures)
    ));
    out
}
