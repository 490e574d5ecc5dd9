//! `cargo xtask survey`: random bearings by the hundred, solved by every model and run by every scheme.
//!
//! The bearings and what is tried on them are `tribodyn_study::survey`; here are arguments, the table, and a case file
//! for each failure.

use crate::error::Failure;
use crate::terminal::{print, progress};
use std::fmt::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;
use tribodyn::answers::Equations;
use tribodyn_case::CaseError;
use tribodyn_paper::{PaperError, files, markers, table};
use tribodyn_study::survey::{
    AtRest, Compared, ModelCounts, Options, RandomBearing, Regime, SchemeCounts, Tally, Trial, Verdict, survey,
    survey_at_rest, survey_stiffness,
};

/// Marks of the blocks of equilibria, of orbits and of runs: what was not tried this time stays.
const EQUILIBRIA: [&str; 2] = ["<!-- survey:begin -->", "<!-- survey:end -->"];
const ORBITS: [&str; 2] = ["<!-- survey-orbits:begin -->", "<!-- survey-orbits:end -->"];
const RUNS: [&str; 2] = ["<!-- survey-runs:begin -->", "<!-- survey-runs:end -->"];
const STIFFNESS: [&str; 2] = ["<!-- survey-stiffness:begin -->", "<!-- survey-stiffness:end -->"];
const DOCUMENT: &str = "docs/reliability.md";

/// Options of `cargo xtask survey`.
#[derive(Debug, Clone, clap::Args)]
pub struct Arguments {
    /// Bearings to solve
    #[arg(long, default_value_t = 200)]
    cases: u64,
    /// Models to solve them by [default: all]
    #[arg(long = "model", value_name = "MODEL", value_parser = model)]
    models: Vec<Equations>,
    /// Bearings to run, from the first on
    #[arg(long, default_value_t = 0)]
    runs: u64,
    /// Bearings to solve at rest, by every model and in pairs on a shaft, from the first on
    #[arg(long, default_value_t = 0)]
    at_rest: u64,
    /// Bearings whose stiffness is compared with differences of solutions, from the first on
    #[arg(long, default_value_t = 0)]
    stiffness: u64,
    /// Seed of the family of bearings
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Number of the first bearing
    #[arg(long, default_value_t = 0)]
    first: u64,
    /// Wall time after which a run is stopped, s
    #[arg(long, default_value_t = 60.0)]
    longest_run: f64,
    /// Folder for a case file of each failure
    #[arg(long, default_value = "target/survey")]
    out: PathBuf,
    /// Rewrite the block in docs/reliability.md
    #[arg(long)]
    write: bool,
}

fn model(name: &str) -> Result<Equations, String> {
    Equations::parse(name).map_err(|failure| failure.to_string())
}

/// Tries, prints, and writes the cases that failed.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let all = Equations::ALL.map(|(_, model)| model).to_vec();
    let options = Options {
        seed: arguments.seed,
        first: arguments.first,
        cases: arguments.cases,
        models: if arguments.models.is_empty() { all } else { arguments.models.clone() },
        runs: arguments.runs,
        longest_run: Duration::from_secs_f64(arguments.longest_run.max(0.0)),
    };
    let (end, mut done) = (options.cases.max(options.runs), 0);
    let refused = |source| PaperError::Case { file: "a random bearing".to_owned(), source: Box::new(source) };
    let mut written = Ok(());
    let trials = survey(&options, |chunk| {
        done += chunk.len();
        progress(&format!("{done} of {end}"));
        for trial in chunk {
            written = std::mem::replace(&mut written, Ok(())).and_then(|()| write_failure(&arguments.out, trial));
        }
    })
    .map_err(refused)?;
    written?;
    let tally = Tally::of(&trials);
    let tried = |orbits: bool| {
        let of_kind = |model: &Equations| (*model == Equations::SteadyOrbit) == orbits;
        options.models.iter().copied().filter(of_kind).collect::<Vec<_>>()
    };
    let [equilibria, orbits] = [false, true].map(tried);
    let cases = |models: &[Equations]| if models.is_empty() { 0 } else { options.cases };
    let blocks = [
        (EQUILIBRIA, cases(&equilibria), solutions(&tally, &equilibria)),
        (ORBITS, cases(&orbits), solutions(&tally, &orbits)),
        (RUNS, options.runs, runs(&tally, options.longest_run)),
    ];
    for (marks, count, block) in blocks.into_iter().filter(|(_, count, _)| *count > 0) {
        show(arguments, marks, count, &block)?;
    }
    let (block, off) = stiffness(arguments, &options.models).map_err(refused)?;
    if arguments.stiffness > 0 {
        show(arguments, STIFFNESS, arguments.stiffness, &block)?;
    }
    let missed = off + at_rest(arguments).map_err(refused)?;
    let failed = missed
        + tally.solutions.values().map(|of| of.counts.failed).sum::<usize>()
        + tally.runs.values().map(|scheme| scheme.counts.failed).sum::<usize>();
    if failed > 0 {
        let findings =
            vec![format!("{failed} trials failed without a reason; their cases are in {}", arguments.out.display())];
        return Err(Failure::Check { what: "survey", findings });
    }
    Ok(())
}

/// Prints a table, and writes it into the document where that is asked for.
fn show(arguments: &Arguments, marks: [&'static str; 2], count: u64, block: &str) -> Result<(), Failure> {
    let Arguments { seed, first, .. } = arguments;
    let block = format!("Bearings {first} to {} of seed {seed}.\n\n{block}\n", first + count - 1);
    print(&block)?;
    if arguments.write {
        let path = files::root().join(DOCUMENT);
        let text = markers::replaced(DOCUMENT, &files::read(&path)?, &block, marks)?;
        files::write(&path, text.as_bytes())?;
    }
    Ok(())
}

/// Stiffness beside differences, as a table; how many matrices are off without a word.
fn stiffness(arguments: &Arguments, models: &[Equations]) -> Result<(String, usize), CaseError> {
    let Arguments { seed, first, stiffness: count, .. } = *arguments;
    let mut off = 0;
    let mut rows = Vec::new();
    for model in models {
        let done = AtomicU64::new(0);
        let finished = || {
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            if done.is_multiple_of(16) {
                progress(&format!("stiffness, {}: {done} of {count}", model.name()));
            }
        };
        let compared = survey_stiffness((seed, first), count, *model, &finished)?;
        for (index, one) in compared.iter().enumerate() {
            if let Verdict::Failed(why) = &one.verdict {
                progress(&format!("stiffness of bearing {}: {why}", first + index as u64));
            }
        }
        rows.push(stiffness_row(*model, &compared));
        off += compared.iter().filter(|one| matches!(one.verdict, Verdict::Failed(_))).count();
    }
    let head = ["model", "bearings", "judged", "within 1e-3", "say it themselves", "off", "median", "99 %", "largest"];
    Ok((table::markdown(&head, &rows), off))
}

fn stiffness_row(model: Equations, compared: &[Compared]) -> Vec<String> {
    let mut deviations: Vec<f64> = compared.iter().filter_map(|one| one.deviation).collect();
    deviations.sort_by(f64::total_cmp);
    let at = |share: f64| {
        let index = (share * deviations.len().saturating_sub(1) as f64).round() as usize;
        deviations.get(index).map_or_else(|| "–".to_owned(), |deviation| format!("{deviation:.1e}"))
    };
    let count = |of: fn(&Compared) -> bool| compared.iter().filter(|one| of(one)).count().to_string();
    let counts = [
        count(|one| one.deviation.is_some()),
        count(|one| one.verdict == Verdict::Good),
        count(|one| one.deviation.is_some() && matches!(one.verdict, Verdict::Explained(_))),
        count(|one| matches!(one.verdict, Verdict::Failed(_))),
    ];
    let head = [model.name().to_owned(), compared.len().to_string()];
    head.into_iter().chain(counts).chain([0.5, 0.99, 1.0].map(at)).collect()
}

/// The verdict on a part of a trial.
type Part = fn(&AtRest) -> &Verdict;

/// Solves bearings that stand still and prints how many are solved; says how many are wrong.
fn at_rest(arguments: &Arguments) -> Result<usize, CaseError> {
    let tried = survey_at_rest(arguments.seed, arguments.first, arguments.at_rest)?;
    let mut wrong = 0;
    let parts: [(&str, Part); 2] = [("alone", |t| &t.alone), ("in pairs", |t| &t.pair)];
    for (what, of) in parts {
        let good = tried.iter().filter(|trial| *of(trial) == Verdict::Good).count();
        for (index, trial) in tried.iter().enumerate() {
            let (Verdict::Explained(why) | Verdict::Failed(why)) = of(trial) else { continue };
            wrong += usize::from(matches!(of(trial), Verdict::Failed(_)));
            progress(&format!("bearing {} at rest, {what}: {why}", arguments.first + index as u64));
        }
        if !tried.is_empty() {
            let share = 100.0 * good as f64 / tried.len() as f64;
            progress(&format!("at rest {what}: {good} of {} solved ({share:.2} %)", tried.len()));
        }
    }
    Ok(wrong)
}

/// The case of a trial that was not good, or only good by a rescue, with what there was at its head.
fn write_failure(folder: &std::path::Path, trial: &Trial) -> Result<(), Failure> {
    let mut head = String::new();
    let note = |head: &mut String, what: String, verdict: &Verdict| {
        let (word, message) = match verdict {
            Verdict::Good => return,
            Verdict::Explained(message) => ("explained", message),
            Verdict::Failed(message) => ("FAILED", message),
        };
        let _ = writeln!(head, "// {what}, {word}: {}", message.replace('\n', " "));
    };
    for solving in &trial.solvings {
        if solving.rescued {
            let _ = writeln!(head, "// solve {}, {:.2} s, rescued", solving.model.name(), solving.wall.as_secs_f64());
        }
        note(
            &mut head,
            format!("solve {}, {:.2} s", solving.model.name(), solving.wall.as_secs_f64()),
            &solving.verdict,
        );
    }
    if let Some(running) = &trial.running {
        note(&mut head, format!("run {}, {:.2} s", running.scheme, running.wall.as_secs_f64()), &running.verdict);
    }
    if head.is_empty() {
        return Ok(());
    }
    std::fs::create_dir_all(folder).map_err(|source| PaperError::Write { path: folder.to_owned(), source })?;
    let RandomBearing { origin: (seed, index), text, .. } = &trial.bearing;
    Ok(files::write(&folder.join(format!("{seed}-{index:05}.ron")), format!("{head}{text}").as_bytes())?)
}

/// How many bearings have a solution, by regime and model.
fn solutions(tally: &Tally, models: &[Equations]) -> String {
    let row = |((Regime { pressure, pitch_speed }, model), of): (&(Regime, Equations), &ModelCounts)| {
        let counts = of.counts;
        let regime = [Regime::PRESSURES[*pressure], Regime::PITCH_SPEEDS[*pitch_speed], model.name()];
        let counts = [counts.all(), counts.good, counts.rescued, counts.explained, counts.failed];
        let times = [of.median(), of.slowest()].map(|wall| format!("{:.1}", 1e3 * wall.as_secs_f64()));
        let regime = regime.map(str::to_owned).into_iter();
        regime.chain(counts.map(|count| count.to_string())).chain(times).collect::<Vec<_>>()
    };
    let of_models = tally.solutions.iter().filter(|((_, model), _)| models.contains(model));
    let rows: Vec<Vec<String>> = of_models.map(row).collect();
    let rescued = if models == [Equations::SteadyOrbit] { "of these eased" } else { "of these rescued" };
    let head = [
        "nominal pressure",
        "d_m n",
        "model",
        "bearings",
        "solved",
        rescued,
        "with reason",
        "failed",
        "median, ms",
        "slowest, ms",
    ];
    let mut text = table::markdown(&head, &rows);
    for model in models {
        let counts = tally.working(*model);
        let share = 100.0 * counts.good as f64 / counts.all().max(1) as f64;
        let (good, all, name) = (counts.good, counts.all(), model.name());
        let _ = write!(text, "\n`{name}` at 0.5 GPa and more: {good} of {all} solved ({share:.2} %).\n");
    }
    text
}

/// How runs end, by scheme.
fn runs(tally: &Tally, longest: Duration) -> String {
    let row = |(scheme, of): (&&str, &SchemeCounts)| {
        let [linear, angular] = of.worst_momentum_percent.map(|percent| format!("{percent:.1e} %"));
        vec![
            (*scheme).to_owned(),
            of.counts.all().to_string(),
            of.counts.good.to_string(),
            of.counts.explained.to_string(),
            of.counts.failed.to_string(),
            of.above_one_percent.to_string(),
            format!("{:.1e} %", of.worst_good_percent),
            linear,
            angular,
            of.stopped.to_string(),
            format!("{:.1} s", of.longest_s),
        ]
    };
    let head = [
        "scheme",
        "runs",
        "balanced",
        "with reason",
        "failed",
        "above 1 %",
        "worst balanced",
        "linear momentum",
        "angular momentum",
        "stopped by the clock",
        "longest",
    ];
    let rows: Vec<Vec<String>> = tally.runs.iter().map(row).collect();
    format!("{}\nStopped after {:.0} s of wall time each.\n", table::markdown(&head, &rows), longest.as_secs_f64())
}
