//! `tribodyn identify`: unknown parameters from published or measured figures.

use crate::drawn;
use crate::failure::Failure;
use crate::input::{LimitArguments, ReplaceArguments};
use crate::table;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use tribodyn_bearing::SearchWatch;
use tribodyn_identify::{Identification, Problem, Relation, identify};
use tribodyn_plot::{Axis, Figure, LineChart, Panel, Series};
use tribodyn_study::{StagedFiles, read_text};

/// Identify unknown parameters of a case from published or measured figures.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn identify fixtures/identify/paper.ron -o identified")]
pub struct Arguments {
    /// Problem file (RON)
    problem: PathBuf,
    /// Seed of the start points, instead of the problem's
    #[arg(long)]
    seed: Option<u64>,
    /// Number of start points, instead of the problem's
    #[arg(long)]
    starts: Option<usize>,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
    /// Write the answer (JSON), the completed case files and plots to this folder
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    #[command(flatten)]
    limits: LimitArguments,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let path = &arguments.problem;
    let limits = arguments.limits.limits();
    let text = read_text(path, &limits)?;
    let name = path.display().to_string();
    let refused = |source| Failure::Identify { file: name.clone(), source: Box::new(source) };
    let mut problem = Problem::from_ron(&text).map_err(refused)?;
    problem.seed = arguments.seed.unwrap_or(problem.seed);
    problem.starts = arguments.starts.unwrap_or(problem.starts);
    problem.check().map_err(refused)?;
    let case_path = path.parent().unwrap_or(Path::new("")).join(&problem.case);
    let case = read_text(&case_path, &limits)?;
    let starts = problem.starts + usize::from(problem.from_case);
    let progress = progress_bar(starts * problem.hypotheses.len().max(1));
    let answers = identify(&problem, &case, &|| progress.inc(1), &SearchWatch::default()).map_err(refused);
    progress.finish_and_clear();
    let answers = answers?;
    let files = arguments
        .output
        .as_ref()
        .map(|folder| stage(folder, arguments.replace.force, &problem, &answers))
        .transpose()?;
    if arguments.json {
        table::print_json(&answers)?;
    } else {
        for answer in &answers {
            print(answer)?;
        }
        print_comparison(&answers)?;
    }
    Ok(files.map_or(Ok(()), StagedFiles::publish)?)
}

/// On standard error; it hides itself where that is no terminal.
fn progress_bar(count: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} starts, {elapsed} gone, {eta} left");
    let bar = ProgressBar::new(count as u64);
    if let Ok(style) = style { bar.with_style(style) } else { bar }
}

fn title(answer: &Identification) -> &str {
    answer.hypothesis.as_deref().unwrap_or("the case as it is")
}

fn print(answer: &Identification) -> Result<(), Failure> {
    table::print_line(&format!(
        "{}: weighted squares {:.3}, of the data {:.3}, ln of the evidence {:.2} (Laplace)\n",
        title(answer),
        answer.cost,
        answer.data_cost,
        answer.log_evidence
    ))?;
    print_parameters(answer)?;
    table::print_line("")?;
    print_data(answer)?;
    table::print_line("")?;
    print_minima(answer)?;
    let strongest = strongest_correlations(answer);
    if !strongest.is_empty() {
        table::print_line(&format!("strongest correlations: {strongest}"))?;
    }
    let check = answer.sensitivity_check;
    table::print_line(&format!("sensitivities change by {check:.1e} when their step is halved"))?;
    if answer.failed_starts > 0 {
        table::print_line(&format!("{} starts had no equilibrium", answer.failed_starts))?;
    }
    for conflict in &answer.conflicts {
        table::print_line(&format!("conflict: {conflict}"))?;
    }
    for warning in &answer.warnings {
        table::print_line(&format!("warning: {warning}"))?;
    }
    table::print_line("")
}

fn print_parameters(answer: &Identification) -> Result<(), Failure> {
    let rows = answer.parameters.iter().map(|p| {
        let verdict = match (p.determined, p.at_bound) {
            (true, true) => "at its bound",
            (true, false) => "determined",
            (false, true) => "NOT determined, at its bound",
            (false, false) => "NOT determined",
        };
        let value = if p.determined { format!("{:.5}", p.value) } else { "–".into() };
        let spread = if p.determined { format!("{:.2e}", p.spread) } else { "–".into() };
        let prior = p.prior.map_or_else(|| "–".into(), |(mean, spread)| format!("{mean} ± {spread}"));
        let by: Vec<String> =
            p.determined_by.iter().map(|(id, share)| format!("{id} {:.0} %", share * 100.0)).collect();
        vec![p.name.clone(), value, spread, prior, verdict.into(), by.join(", ")]
    });
    table::print_rows(&["parameter", "value", "spread", "prior", "verdict", "determined by"], rows)?;
    for p in answer.parameters.iter().filter(|p| !p.determined) {
        let measure = p.measure.as_deref().unwrap_or("nothing in these runs would determine it");
        let note =
            format!("{} is not determined by these data (the search ended at {:.4}); {measure}", p.name, p.value);
        table::print_line(&note)?;
    }
    Ok(())
}

fn print_data(answer: &Identification) -> Result<(), Failure> {
    let rows = answer.data.iter().map(|d| {
        let digits = if d.unit == "GPa" { 4 } else { 2 };
        vec![
            d.id.clone(),
            d.run.clone(),
            if matches!(d.relation, Relation::Above { .. }) { format!("≥ {}", d.value) } else { d.value.to_string() },
            format!("{:.digits$}", d.computed),
            format!("{:+.digits$}", d.deviation),
            format!("{}", d.uncertainty),
            format!("{:+.2}", d.normalised),
            d.unit.to_owned(),
        ]
    });
    table::print_rows(&["datum", "run", "figure", "computed", "deviation", "σ", "deviation/σ", "unit"], rows)
}

fn print_minima(answer: &Identification) -> Result<(), Failure> {
    let rows = answer.minima.iter().take(SHOWN_MINIMA).map(|m| {
        let values: Vec<String> = m.values.iter().map(|v| format!("{v:.5}")).collect();
        vec![format!("{:.3}", m.cost), m.starts.to_string(), values.join("  ")]
    });
    table::print_rows(&["minimum", "starts", "values in the order above"], rows)
}

/// Distinct minima in the table.
const SHOWN_MINIMA: usize = 5;

fn strongest_correlations(answer: &Identification) -> String {
    let names: Vec<&str> = answer.parameters.iter().map(|p| p.name.as_str()).collect();
    let mut pairs: Vec<(f64, String)> = Vec::new();
    for (i, row) in answer.correlation.iter().enumerate() {
        for (j, c) in row.iter().enumerate().take(i) {
            pairs.push((c.abs(), format!("{} – {} {c:+.2}", names[j], names[i])));
        }
    }
    pairs.retain(|(size, _)| *size > 0.7);
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
    pairs.into_iter().take(4).map(|(_, text)| text).collect::<Vec<_>>().join(", ")
}

fn print_comparison(answers: &[Identification]) -> Result<(), Failure> {
    if answers.len() < 2 {
        return Ok(());
    }
    let best = answers.iter().map(|a| a.log_evidence).fold(f64::NEG_INFINITY, f64::max);
    let rows = answers.iter().map(|a| {
        let worst = a.data.iter().max_by(|x, y| x.normalised.abs().total_cmp(&y.normalised.abs()));
        let worst = worst.map_or_else(String::new, |d| format!("{} {:+.4} {}", d.id, d.deviation, d.unit));
        let evidence = format!("{:+.2}", a.log_evidence - best);
        vec![title(a).to_owned(), format!("{:.3}", a.cost), format!("{:.3}", a.data_cost), evidence, worst]
    });
    table::print_rows(&["hypothesis", "squares", "of the data", "ln evidence to the best", "worst datum"], rows)
}

fn stage(folder: &Path, force: bool, problem: &Problem, answers: &[Identification]) -> Result<StagedFiles, Failure> {
    let mut staged = StagedFiles::new(folder, force)?;
    staged.write("identification.json".into(), serde_json::to_string_pretty(answers)?.as_bytes())?;
    for answer in answers {
        staged.write(format!("case-{}.ron", file_name(title(answer))), answer.case_text.as_bytes())?;
    }
    figures(problem, answers)?.iter().try_for_each(|figure| drawn::stage(&mut staged, figure))?;
    Ok(staged)
}

fn file_name(title: &str) -> String {
    let plain: String = title.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    plain.split('-').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("-").to_lowercase()
}

/// Residuals of every datum, and the squares of the distinct minima.
fn figures(problem: &Problem, answers: &[Identification]) -> Result<Vec<Figure>, Failure> {
    let numbered = |v: Vec<f64>| v.into_iter().enumerate().map(|(i, v)| (i as f64 + 1.0, v)).collect::<Vec<_>>();
    let residuals = |a: &Identification| numbered(a.data.iter().map(|d| d.normalised).collect());
    let costs = |a: &Identification| numbered(a.minima.iter().map(|m| m.cost).collect());
    // A margin of one on either side keeps the first and the last point off the frame.
    let most = answers.iter().map(|a| a.minima.len()).max().unwrap_or(1);
    let residuals = LineChart::new(
        "Residuals",
        Axis::new("datum, in the order of the problem file", "").covering(0.0, problem.data.len() as f64 + 1.0),
        Axis::new("deviation / uncertainty", "").covering(-2.0, 2.0),
        answers.iter().map(|a| Series::marked(title(a), residuals(a))).collect(),
    );
    let minima = LineChart::new(
        "Distinct minima",
        Axis::new("rank", "").covering(0.0, most as f64 + 1.0),
        Axis::new("sum of weighted squares", ""),
        answers.iter().map(|a| Series::points(title(a), costs(a))).collect(),
    );
    let figure = |name, heading, chart| Figure::new(name, heading, &[Panel::Cartesian(chart)]);
    Ok(vec![
        figure("identification-residuals", "Deviation of every datum over its uncertainty", residuals)?,
        figure("identification-minima", "Weighted squares of the minima found", minima)?,
    ])
}
