//! Small CSV files with `#` lines at their head, and tables on the terminal.

use crate::error::PaperError;

/// A table read from CSV without quoting: comment lines, a line of column names, rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    file: String,
    columns: Vec<String>,
    rows: Vec<(usize, Vec<String>)>,
}

/// One row, read by column name.
#[derive(Debug, Clone, Copy)]
pub struct Row<'a> {
    table: &'a Table,
    line: usize,
    cells: &'a [String],
}

impl Table {
    /// Reads the text of `file`; every row must have as many cells as there are columns.
    ///
    /// # Errors
    ///
    /// No line of column names, a row of another length.
    pub fn read(file: &str, text: &str) -> Result<Self, PaperError> {
        let split = |line: &str| line.split(',').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
        let mut lines =
            text.lines().enumerate().map(|(i, l)| (i + 1, l)).filter(|(_, l)| !l.starts_with('#') && !l.is_empty());
        let fail = |line, message: String| PaperError::Table { file: file.to_owned(), line, message };
        let (_, head) = lines.next().ok_or_else(|| fail(1, "no line of column names".into()))?;
        let columns = split(head);
        let rows: Vec<_> = lines.map(|(number, line)| (number, split(line))).collect();
        if let Some((line, cells)) = rows.iter().find(|(_, cells)| cells.len() != columns.len()) {
            return Err(fail(*line, format!("{} cells, but {} columns", cells.len(), columns.len())));
        }
        Ok(Self { file: file.to_owned(), columns, rows })
    }

    /// Names of the columns.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// Rows from the top.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|(line, cells)| Row { table: self, line: *line, cells })
    }
}

impl<'a> Row<'a> {
    /// Names of the columns.
    pub fn columns(&self) -> &'a [String] {
        &self.table.columns
    }

    /// The first cell, which names the row.
    pub fn first(&self) -> &'a str {
        &self.cells[0]
    }

    /// The cell of a column as it stands.
    ///
    /// # Errors
    ///
    /// No such column.
    pub fn text(&self, column: &str) -> Result<&'a str, PaperError> {
        let place = self.table.columns.iter().position(|c| c == column);
        place.map(|p| self.cells[p].as_str()).ok_or_else(|| self.fail(format!("no column `{column}`")))
    }

    /// The finite number of a column.
    ///
    /// # Errors
    ///
    /// No such column, no finite number.
    pub fn number(&self, column: &str) -> Result<f64, PaperError> {
        let text = self.text(column)?;
        let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
        value.ok_or_else(|| self.fail(format!("{column} = `{text}` is not a finite number")))
    }

    /// Half of the last printed digit: the uncertainty of a tabulated number.
    ///
    /// # Errors
    ///
    /// Those of [`Row::number`].
    pub fn half_digit(&self, column: &str) -> Result<f64, PaperError> {
        self.number(column)?;
        let decimals = self.text(column)?.split_once('.').map_or(0, |(_, digits)| digits.len());
        Ok(0.5 * 10f64.powi(-(decimals as i32)))
    }

    /// An error at this row's line.
    pub fn fail(&self, message: String) -> PaperError {
        PaperError::Table { file: self.table.file.clone(), line: self.line, message }
    }
}

/// Columns padded to their widest cell, for a terminal.
pub fn aligned(head: &[&str], rows: &[Vec<String>]) -> String {
    let width = |column: usize| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells.chain([head[column].chars().count()]).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    let line = |cells: &[&str]| {
        let padded: Vec<String> = cells.iter().zip(&widths).map(|(cell, &w)| format!("{cell:<w$}")).collect();
        format!("{}\n", padded.join("  ").trim_end())
    };
    let body = rows.iter().map(|row| line(&row.iter().map(String::as_str).collect::<Vec<_>>()));
    std::iter::once(line(head)).chain(body).collect()
}

/// The same as a Markdown table.
pub fn markdown(head: &[&str], rows: &[Vec<String>]) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let rule = line(head.iter().map(|_| "---".to_owned()).collect());
    let escaped = |row: &Vec<String>| line(row.iter().map(|cell| cell.replace('|', "\\|")).collect());
    let body: String = rows.iter().map(escaped).collect();
    format!("{}{rule}{body}", line(head.iter().map(|&h| h.to_owned()).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# head\nid,speed\na,5855\nb,2.30\n";

    #[test]
    fn identity_cells_are_found_by_name_with_their_uncertainty() {
        let table = Table::read("t.csv", TEXT).unwrap();
        let rows: Vec<_> = table.rows().collect();
        assert_eq!(rows[0].number("speed").unwrap(), 5855.0);
        assert_eq!(rows[0].half_digit("speed").unwrap(), 0.5);
        assert_eq!(rows[1].half_digit("speed").unwrap(), 0.005);
        assert_eq!(rows[1].text("id").unwrap(), "b");
    }

    #[test]
    fn limit_short_rows_and_words_for_numbers_are_refused_with_their_line() {
        let error = Table::read("t.csv", "# head\nid,speed\na\n").unwrap_err().to_string();
        assert!(error.starts_with("t.csv:3: 1 cells"), "{error}");
        let table = Table::read("t.csv", "id,speed\na,fast\n").unwrap();
        let error = table.rows().next().unwrap().number("speed").unwrap_err().to_string();
        assert!(error.contains("t.csv:2") && error.contains("fast"), "{error}");
    }

    #[test]
    fn identity_terminal_and_markdown_tables_hold_the_same_cells() {
        let rows = vec![vec!["|ξ|".to_owned(), "1".to_owned()]];
        assert_eq!(aligned(&["q", "value"], &rows), "q    value\n|ξ|  1\n");
        assert_eq!(markdown(&["q", "value"], &rows), "| q | value |\n| --- | --- |\n| \\|ξ\\| | 1 |\n");
    }
}
