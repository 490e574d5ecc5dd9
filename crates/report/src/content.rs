//! The words and tables of a report, before they are HTML or Markdown.

use super::Answer;
use super::opening;
use super::page_table::Table;
use super::tables;
use super::values::CaseValue;
use crate::words::number;
use crate::words::shown;
use tribodyn::CaseFile;
use tribodyn_record::{Damage, Run};

/// Everything but the figures.
pub struct Content {
    pub title: String,
    /// The kind of report.
    pub subtitle: &'static str,
    /// Warnings that the reader must see first.
    pub warnings: Vec<String>,
    /// Results, the most important first.
    pub tables: Vec<Table>,
    /// Tables of what was run or compared, after the results.
    pub opening: Vec<Table>,
    /// Every value of the case, folded.
    pub inputs: Vec<Table>,
    pub notes: Vec<String>,
    /// Text of the case file.
    pub case_text: Option<String>,
}

impl Content {
    pub fn of_run(answer: &Answer, case: Option<&CaseFile>, run: &Run) -> Self {
        let mut tables = vec![
            tables::results(answer),
            tables::operation(&answer.operation, &tables::steady(answer)),
            tables::powers(&answer.summary),
            tables::frequencies(&answer.frequencies, answer.rolling.as_ref()),
        ];
        tables.extend(tables::start(answer));
        tables.extend([tables::wear(answer), tables::facts(answer, run)]);
        if !answer.validation.is_empty() {
            tables.push(tables::validation(&answer.validation));
        }
        let title = if answer.bearing.is_empty() { "Transient run".to_owned() } else { answer.bearing.clone() };
        Self {
            title,
            subtitle: "Transient run",
            warnings: warnings(answer),
            tables,
            opening: vec![opening::of_run(answer, case, run)],
            inputs: values(&answer.case_values),
            notes: answer.notes.clone(),
            case_text: run.case_text.clone(),
        }
    }
}

fn warnings(answer: &Answer) -> Vec<String> {
    let mut all = damage(&answer.damage, answer.summary.simulated_s);
    all.extend(answer.warnings_at_start.iter().map(|warning| format!("At the start: {warning}")));
    all.extend(answer.untested_pressures.iter().cloned());
    all.extend(answer.summary.warnings.iter().cloned());
    shown(&all)
}

/// Warnings of a recording that is not whole.
pub fn damage(damage: &Damage, end_s: f64) -> Vec<String> {
    let mut all = Vec::new();
    if damage.truncated {
        let end = number(end_s, 6);
        all.push(format!("The recording ends before its end mark: the run was killed or is still going on. The last sample is at {end} s."));
    }
    if damage.chunks_bad > 0 {
        all.push(format!(
            "{} parts of the recording are damaged; what lies behind the fault in each is missing.",
            damage.chunks_bad
        ));
    } else if damage.bytes_lost > 0 && !damage.truncated {
        all.push(format!("{} bytes of the recording are damaged and were skipped.", damage.bytes_lost));
    }
    if damage.messages_unchecked > 0 {
        all.push(format!(
            "No checksum vouches for {} messages before a fault or before the end of a cut file; they are used here.",
            damage.messages_unchecked
        ));
    }
    if damage.checksum_bad && damage.chunks_bad == 0 {
        all.push(
            "The recording was altered after it was written: its checksum does not match. Metadata may be wrong."
                .to_owned(),
        );
    }
    if damage.summary_bad {
        all.push(
            "The summary at the end of the recording is damaged; names and types were taken from the data.".to_owned(),
        );
    }
    all
}

/// All values of the case, a table for each section.
pub fn values(all: &[CaseValue]) -> Vec<Table> {
    let mut tables: Vec<Table> = Vec::new();
    for value in all {
        let title = format!("Case: {}", value.section());
        if tables.last().is_none_or(|table| table.title != title) {
            let text = match (tables.len(), value.section()) {
                (0, _) => {
                    "Values as they were run, with the sources that the case file gives them, also where an option changed the value."
                }
                _ => "",
            };
            tables.push(Table {
                title,
                text: text.to_owned(),
                header: vec!["Path", "Value", "Class", "Source"],
                rows: Vec::new(),
                numbers: 0..0,
                wide: true,
            });
        }
        if let Some(table) = tables.last_mut() {
            let class = if value.class.is_empty() { "no source" } else { value.class };
            table.rows.push(vec![value.path.clone(), value.value.clone(), class.to_owned(), value.source.clone()]);
        }
    }
    tables
}
