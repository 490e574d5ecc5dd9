//! Answers on standard output: tables for people, JSON for programs.

use crate::failure::Failure;
use crate::harmless::{harmless, steers};
use comfy_table::{CellAlignment, Table, presets};
use serde::Serialize;
use std::io::Write;
use tribodyn::answers::Findings;
pub use tribodyn_report::words::number;

/// Prints a value as indented JSON.
pub fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    // What steers a terminal stands in strings only, where it may be escaped; JSON asks for that below a blank only.
    let text = serde_json::to_string_pretty(value)?;
    let text: String =
        text.chars().map(|c| if steers(c) { format!("\\u{:04x}", u32::from(c)) } else { c.to_string() }).collect();
    print_line(&text)
}

/// Prints a line, or several; what would steer a terminal, from names in files for instance, is `\u{fffd}`. A closed
/// pipe is an error to the caller, not a panic.
pub fn print_line(text: &str) -> Result<(), Failure> {
    Ok(writeln!(std::io::stdout(), "{}", harmless(text))?)
}

/// The first lines of an answer: of which case it is, and what its bearing runs with.
pub fn print_head(name: &str, findings: &Findings) -> Result<(), Failure> {
    print_line(&format!("{name}\nlubrication: {}\n", findings.lubrication()))
}

/// Prints the warnings about the operating point that an answer rests on, a line each.
pub fn print_warnings(warnings: &[String]) -> Result<(), Failure> {
    warnings.iter().try_for_each(|warning| print_line(&format!("warning: {warning}")))
}

/// A text as a field of a CSV table.
pub fn csv_text(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

/// Prints name, value and unit, a line each.
pub fn print_pairs(rows: &[(&str, String, &str)]) -> Result<(), Failure> {
    let mut table = plain();
    for (name, value, unit) in rows {
        table.add_row([*name, value, *unit]);
    }
    right_align(&mut table, 1..2);
    print_line(&table.trim_fmt())
}

/// Prints a table with a header; all but the first column aligned right.
pub fn print_rows(header: &[&str], rows: impl Iterator<Item = Vec<String>>) -> Result<(), Failure> {
    let mut table = plain();
    table.set_header(header);
    for row in rows {
        table.add_row(row);
    }
    right_align(&mut table, 1..header.len());
    print_line(&table.trim_fmt())
}

fn plain() -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    table
}

fn right_align(table: &mut Table, columns: std::ops::Range<usize>) {
    for column in columns {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::number;
    use crate::harmless::visible;

    #[test]
    fn limit_a_text_cannot_steer_a_terminal() {
        assert_eq!(visible("a\nb\u{1b}[31m µ|\u{202e}x\u{9b}"), "a b\u{fffd}[31m µ|\u{fffd}x\u{fffd}");
    }

    #[test]
    fn limit_only_zero_loses_its_sign() {
        assert_eq!(
            [number(-0.004, 2), number(-0.006, 2), number(-10.0, 0), number(0.0, 1)],
            ["0.00", "-0.01", "-10", "0.0"]
        );
    }
}
