//! Signals as text: numbers in columns, with names above them or without.

use super::signal_file::{Column, SignalFile};
use crate::error::StudyError;
use std::path::Path;

/// Reads columns that are separated by commas, semicolons, tabs or blanks; with semicolons and tabs numbers may have
/// decimal commas. Lines that begin with `#` or `%` are left out.
pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<SignalFile, StudyError> {
    let refused = |line: usize, column: usize, why: String| {
        StudyError::Signals(path.to_owned(), format!("{line}:{column}: {why}"))
    };
    let text = std::str::from_utf8(bytes).map_err(|_| refused(1, 1, "it is not UTF-8 text".to_owned()))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let is_content = |line: &str| !line.trim().is_empty() && !line.starts_with(['#', '%']);
    let mut lines = text.lines().enumerate().filter(|(_, line)| is_content(line)).peekable();
    let Some((_, first)) = lines.peek().copied() else {
        return Err(refused(1, 1, "the file is empty".to_owned()));
    };
    let by = Separator::of(first);
    let head: Vec<&str> = by.split(first).collect();
    let named = head.iter().any(|cell| by.number(cell).is_none() && !cell.is_empty());
    let mut columns: Vec<Column> = Vec::new();
    for (index, cell) in head.iter().enumerate() {
        let name = if named { cell.trim_matches('"').to_owned() } else { (index + 1).to_string() };
        if named && columns.iter().any(|column| column.name == name) {
            return Err(refused(1, index + 1, format!("a second column `{name}`")));
        }
        columns.push(Column { name, values: Vec::new() });
    }
    if named {
        lines.next();
    }
    let first_line = lines.peek().map(|(line, _)| line + 1);
    for (line, text) in lines {
        let mut count = 0;
        for cell in by.split(text) {
            let Some(column) = columns.get_mut(count) else {
                let why = format!("column {} is one more than the first line has", count + 1);
                return Err(refused(line + 1, count + 1, why));
            };
            let number = by.number(cell).filter(|number| number.is_finite()).ok_or_else(|| {
                let shown: String = cell.chars().take(40).collect();
                refused(line + 1, count + 1, format!("`{shown}` in column {}: allowed is a finite number", column.name))
            })?;
            column.values.push(number);
            count += 1;
        }
        if count < columns.len() {
            let why = format!("{count} columns where the first line has {}", columns.len());
            return Err(refused(line + 1, count + 1, why));
        }
    }
    Ok(SignalFile { first_line, ..SignalFile::of(columns, None) })
}

/// Separator of numbers.
#[derive(Clone, Copy)]
enum Separator {
    Sign(char),
    Blanks,
}

impl Separator {
    fn of(line: &str) -> Self {
        let sign = ['\t', ';', ','].into_iter().find(|sign| line.trim_end().contains(*sign));
        sign.map_or(Self::Blanks, Self::Sign)
    }

    fn split(self, line: &str) -> Box<dyn Iterator<Item = &str> + '_> {
        match self {
            Self::Sign(sign) => Box::new(line.trim_end_matches([sign, ' ', '\r']).split(sign).map(str::trim)),
            Self::Blanks => Box::new(line.split_whitespace()),
        }
    }

    fn number(self, cell: &str) -> Option<f64> {
        match self {
            Self::Sign(';' | '\t') if cell.contains(',') => cell.replace(',', ".").parse().ok(),
            _ => cell.parse().ok(),
        }
    }
}
