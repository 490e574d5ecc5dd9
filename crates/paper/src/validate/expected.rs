//! Committed results of our own: regression, never validation.

use super::published::Published;
use super::row::{Row, Verdict};
use super::runs::Runs;
use super::tables::PressuresOver;
use crate::error::PaperError;
use crate::files;
use crate::table::Table;
use std::path::{Path, PathBuf};

/// Relative difference that a change of machine or compiler explains.
const REGRESSION: f64 = 1e-6;

pub fn folder() -> PathBuf {
    files::root().join("fixtures/expected")
}

/// A result as a file: name and text.
pub type Fixture = (&'static str, String);

const ORIGIN: &str = "# our own output, for regression only; rewritten by `cargo xtask fixtures`\n";

/// Tables 4 and 5 as computed, all digits.
pub fn fixtures(published: &Published, runs: &Runs) -> [Fixture; 2] {
    let speeds: String = runs.all().map(|run| format!("{},{}\n", run.id, run.solution.cage_speed_rpm)).collect();
    let pressures = PressuresOver::new(&runs.cases[0]);
    let row = |azimuth: f64| {
        let [inner, outer] = pressures.at(azimuth);
        format!("{azimuth},{inner},{outer}\n")
    };
    let at_azimuths: String = published.pressures.iter().map(|p| row(p.azimuth)).collect();
    let case = &runs.file;
    [
        (
            "table4.csv",
            format!("{ORIGIN}# case: {case}; cage speeds of Table 4\n# units: r/min\nid,cage_speed_rpm\n{speeds}"),
        ),
        (
            "table5.csv",
            format!(
                "{ORIGIN}# case: {case}; peak pressures of case 1 at the azimuths of Table 5\n# units: degrees, GPa, \
                GPa\nazimuth_deg,inner_gpa,outer_gpa\n{at_azimuths}"
            ),
        ),
    ]
}

/// Differences from the committed fixtures, in words.
pub fn regressions(fixtures: &[Fixture]) -> Result<Vec<String>, PaperError> {
    let mut findings = Vec::new();
    for (name, text) in fixtures {
        let committed = files::read(&folder().join(name))?;
        findings.extend(differences(name, &committed, text)?);
    }
    Ok(findings)
}

fn differences(name: &str, committed: &str, now: &str) -> Result<Vec<String>, PaperError> {
    let (old, new) = (Table::read(name, committed)?, Table::read(name, now)?);
    if old.columns() != new.columns() || old.rows().count() != new.rows().count() {
        return Ok(vec![format!("{name}: other columns or another number of rows than committed")]);
    }
    let mut findings = Vec::new();
    for (old, new) in old.rows().zip(new.rows()) {
        for column in new.columns() {
            let (was, is) = (old.text(column)?, new.text(column)?);
            let close = match (was.parse::<f64>(), is.parse::<f64>()) {
                (Ok(was), Ok(is)) => (was - is).abs() <= REGRESSION * was.abs(),
                _ => was == is,
            };
            if !close {
                let row = new.first();
                findings.push(format!(
                    "{name}, row {row}, {column}: committed {was}, now {is}; if the change is meant, run `cargo xtask \
                    fixtures` and say in CHANGELOG.md what moved"
                ));
            }
        }
    }
    Ok(findings)
}

const VERDICTS: &str = "verdicts.csv";

pub fn verdicts_text(rows: &[Row]) -> Fixture {
    let body: String = rows.iter().map(|row| format!("{},{}\n", row.id, row.verdict.name())).collect();
    (VERDICTS, format!("# declared verdicts; rewritten by `cargo xtask fixtures`\nid,verdict\n{body}"))
}

/// Findings of a comparison with the declared verdicts.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Declared {
    /// Rows that are declared met and are not, or that the declaration does not match.
    pub broken: Vec<String>,
    /// Rows that do better than declared.
    pub outdated: Vec<String>,
}

pub fn compare_verdicts(rows: &[Row]) -> Result<Declared, PaperError> {
    let path = folder().join(VERDICTS);
    declared(rows, &Table::read(VERDICTS, &files::read(&path)?)?)
}

fn declared(rows: &[Row], table: &Table) -> Result<Declared, PaperError> {
    let mut out = Declared::default();
    let mut ids = Vec::new();
    for line in table.rows() {
        let (id, verdict) = (line.text("id")?, line.text("verdict")?);
        ids.push(id.to_owned());
        if !Verdict::ALL.iter().any(|v| v.name() == verdict) {
            return Err(line.fail(format!("`{verdict}`: allowed are met, missed, contradictory and not-yet")));
        }
        let Some(row) = rows.iter().find(|row| row.id == id) else {
            out.broken.push(format!("{id}: declared {verdict}, but there is no such row"));
            continue;
        };
        let now = row.verdict.name();
        match (verdict, row.verdict) {
            (declared, _) if declared == now => {}
            ("met", _) => out.broken.push(format!(
                "{id}: declared met, now {now} (computed {} {}, tolerance {})",
                row.computed_text(),
                row.unit,
                row.tolerance_text()
            )),
            _ => out.outdated.push(format!("{id}: declared {verdict}, now {now}: run `cargo xtask fixtures`")),
        }
    }
    let undeclared = rows.iter().filter(|row| !ids.contains(&row.id));
    out.broken.extend(undeclared.map(|row| format!("{}: no declared verdict: run `cargo xtask fixtures`", row.id)));
    Ok(out)
}

/// Writes fixtures into a folder.
pub fn write(folder: &Path, fixtures: &[Fixture]) -> Result<(), PaperError> {
    fixtures.iter().try_for_each(|(name, text)| files::write(&folder.join(name), text.as_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regress_only_differences_beyond_the_tolerance_are_found() {
        let with = |speed: f64| format!("# head\nid,speed\n1,{speed}\n");
        assert!(differences("t", &with(5800.0), &with(5800.0 * (1.0 + 5e-7))).unwrap().is_empty());
        let found = differences("t", &with(5800.0), &with(5800.1)).unwrap();
        assert!(found.len() == 1 && found[0].contains("row 1, speed: committed 5800, now 5800.1"), "{found:?}");
        assert_eq!(differences("t", &with(1.0), "id,speed\n1,1\n2,1\n").unwrap().len(), 1);
        assert_eq!(differences("t", "id,speed\na,1\n", "id,speed\nb,1\n").unwrap().len(), 1);
    }

    #[test]
    fn identity_declarations_are_held_against_rows_both_ways() {
        let row = |id: &str, computed: f64| Row::number(id.into(), String::new(), [1.0, computed, 0.1]);
        let rows = [row("good", 1.0), row("fell", 2.0), row("rose", 1.0), row("new", 1.0)];
        let text = "id,verdict\ngood,met\nfell,met\nrose,missed\ngone,met\n";
        let found = declared(&rows, &Table::read("v", text).unwrap()).unwrap();
        assert_eq!(found.outdated.len(), 1);
        assert!(found.outdated[0].starts_with("rose"));
        let ids: Vec<_> = found.broken.iter().map(|f| f.split(':').next().unwrap()).collect();
        assert_eq!(ids, ["fell", "gone", "new"]);
        assert!(declared(&rows, &Table::read("v", "id,verdict\ngood,fine\n").unwrap()).is_err());
    }
}
