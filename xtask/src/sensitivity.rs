//! `cargo xtask sensitivity`: what the parameters that the paper hides do to the dynamic rows.
//!
//! One at a time, each is halved and doubled; and over a grid of pocket gap and pocket stiffness, from which both were
//! chosen, the residuals of the published figures are listed. Runs of 0.2 s with the fast scheme. Then the whole set of runs
//! with one thing changed, hidden or printed, for the rows that are missed: which change turns them, and what it costs; other readings
//! of the missed claims on the unchanged runs; and what the defect's unprinted size does to its rows.

mod changes;
mod defect;
mod misses;
mod readings;

use crate::error::Failure;
use crate::files;
use crate::table::{Table, markdown};
use crate::transient::{Change, FAST, Plan, Set, Transient, run_all};

/// Options of `sensitivity`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Only one of the tables
    #[arg(long)]
    part: Option<Part>,
    /// Only the lines of the table of missed rows whose change has this in its name
    #[arg(long, value_name = "TEXT", conflicts_with = "part")]
    change: Option<String>,
}

/// A table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    /// Hidden parameters halved and doubled, and the grid of the pocket
    Pocket,
    /// Missed rows under changes
    Rows,
    /// Other readings of the missed rows
    Readings,
    /// Size of the defect
    Defect,
}

/// Where the result is committed, and the document that shows it.
const RESULT: &str = "fixtures/expected/sensitivity.csv";
pub const DOCUMENT: &str = "docs/validation.md";
pub const BEGIN: &str = "<!-- sensitivity:begin -->";
pub const END: &str = "<!-- sensitivity:end -->";

const GAPS_MM: [f64; 9] = [0.12, 0.3, 0.5, 0.65, 0.7, 0.71, 0.72, 0.75, 0.9];
const STIFFNESSES: [f64; 3] = [2.5, 5.0, 10.0];

const HEAD: &str = "change,cage_rpm,balls_rpm,orbit_low_rpm,orbit_high_rpm,peak_ag,rms_ag,peak_ptfe,force_n,share";

/// Both coatings with the same changes.
fn plans(changes: &[(&str, String)]) -> [Plan; 2] {
    [Plan::ag(), Plan::ptfe()].map(|plan| {
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

/// The runs with halved and doubled parameters and over the grid.
fn pocket() -> Result<(), Failure> {
    let mut wanted: Vec<(String, Vec<(&str, String)>)> = vec![("as identified".to_owned(), Vec::new())];
    for (path, values) in changes::HIDDEN {
        for (word, value) in ["half", "double"].into_iter().zip(values) {
            wanted.push((format!("{path} {word}"), vec![(path, value.to_owned())]));
        }
    }
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
        "# our own output; rewritten by `cargo xtask sensitivity`\n# last orbits of runs of 0.2 s, fast scheme at 20 us; accelerations of the outer ring along x, m/s2; force in pockets and share of impacts between 245 and 330 degrees with Ag\n{HEAD}\n{}\n",
        rows.join("\n")
    );
    files::write(&files::root().join(RESULT), text.as_bytes())?;
    println!("{text}");
    Ok(())
}

/// Makes the runs, writes the results and the document's block.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let wanted = |part: Part| arguments.part.is_none_or(|only| only == part) && arguments.change.is_none();
    if wanted(Part::Pocket) {
        pocket()?;
    }
    let base = Set::changed(&Change::none("as identified"))?;
    if wanted(Part::Readings) {
        readings::write(&base)?;
    }
    if wanted(Part::Rows) || arguments.change.is_some() {
        misses::run(&base, arguments.change.as_deref())?;
    }
    if wanted(Part::Defect) {
        defect::run(&base)?;
    }
    crate::validate::rewrite_sensitivity()
}

/// The document's block, from the committed result.
pub fn block() -> Result<String, Failure> {
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
    for row in table.rows() {
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
    let tables = [misses::block()?, readings::block()?, defect::block()?].join("\n");
    Ok(format!("{}\n{tables}\nReproduced by `cargo xtask sensitivity`.\n", markdown(&head, &rows)))
}
