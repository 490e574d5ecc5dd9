//! `cargo xtask quantities`: `docs/quantities.md` from the tables of quantities.

use crate::error::Failure;
use std::fmt::Write;
use tribodyn_bearing::quantities::{BALL, CONTACT, Facts, Over, Scope, joined};
use tribodyn_dynamics::{POWER_IN, POWER_LOST};
use tribodyn_paper::files;
use tribodyn_quasistatic::SOLUTION;

const PAGE: &str = "docs/quantities.md";

const HEAD: &str = "# Quantities

Every number of a result has one name, which ends in its unit. `solve --json` and sweeps have it in the unit of the
second column, recordings and reports in that of the third; the rest of the name is the same. A number that a model
does not have is absent: Jones–Harris has those marked \"all\", an equilibrium with traction those marked
\"traction\" too, of a bearing with oil or grease those marked \"lubricated\", a run also those marked \"run\". This page is
made from the tables of the program by `cargo xtask quantities`; `cargo xtask ci` fails where it is out of date.
";

const BALLS: &str = "
## Of a ball

In `balls[]` of `solve --json`, `/bearing/balls` of a recording. Vectors are axial, radial and tangential in the
azimuth frame of the ball. The last column has the columns of sweeps: least and greatest value of any ball, or the
sum. States of recordings have some of them, in the unit of recordings.

";

const CONTACTS: &str = "
## Of a ball–race contact

As those of a ball; `…` is `inner` or `outer`.

";

const BEARING: &str = "
## Of the bearing in equilibrium

At the top of `solve --json`, in sweeps, and in `/bearing/state` of the recording of a solution.

";

const POWERS: &str = "
## Powers of a run

In `power` of `run --json` and `summary.json` (means), and in `/bearing/state` of the recording of a run. Those of
the second table are lost.

";

/// Rewrites the page.
pub fn write() -> Result<(), Failure> {
    Ok(files::write(&files::root().join(PAGE), page().as_bytes())?)
}

/// Fails where the page is not that of the tables.
pub fn check() -> Result<(), Failure> {
    if files::read(&files::root().join(PAGE))? == page() {
        return Ok(());
    }
    let findings = vec![format!("{PAGE} is out of date: run `cargo xtask quantities`")];
    Err(Failure::Check { what: "quantities", findings })
}

fn page() -> String {
    let mut text = HEAD.to_owned();
    text += BALLS;
    table(&mut text, BALL.iter().map(|q| &q.facts), "");
    text += CONTACTS;
    table(&mut text, CONTACT.iter().map(|q| &q.facts), "…");
    text += BEARING;
    table(&mut text, SOLUTION.iter().map(|q| &q.facts), "");
    text += POWERS;
    table(&mut text, POWER_IN.iter().map(|q| &q.facts), "");
    text += "\n";
    table(&mut text, POWER_LOST.iter().map(|q| &q.facts), "");
    text
}

fn table<'a>(text: &mut String, rows: impl Iterator<Item = &'a Facts>, race: &str) {
    text.push_str("| quantity | results | recordings, reports | models | sweeps |\n|---|---|---|---|---|\n");
    for facts in rows {
        let name = |suffix: &str| format!("`{}`", joined(&[facts.name, race, suffix]));
        let unit = |symbol: &str| if symbol.is_empty() { String::new() } else { format!(", {symbol}") };
        let shown = if facts.shown == facts.unit {
            "same".to_owned()
        } else {
            name(facts.shown.suffix) + &unit(facts.shown.symbol)
        };
        let scope = match facts.scope {
            Scope::All => "all",
            Scope::Traction => "traction",
            Scope::Lubricated => "lubricated",
            Scope::Run => "run",
        };
        let column = |over: &Over| {
            let name = joined(&[facts.name, race, over.name(), facts.unit.suffix]);
            format!("`{name}`{}", kind(*over))
        };
        let over: Vec<String> = facts.over_balls.iter().map(column).collect();
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "| {} | {}{} | {shown} | {scope} | {} |",
            facts.about,
            name(facts.unit.suffix),
            unit(facts.unit.symbol),
            over.join(", ")
        );
    }
}

fn kind(over: Over) -> &'static str {
    match over {
        Over::Sum => " (sum)",
        Over::Largest => " (of magnitudes)",
        Over::Min | Over::Max => "",
    }
}
