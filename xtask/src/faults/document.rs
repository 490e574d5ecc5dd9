//! The generated block of docs/reliability.md.

use super::row::{HEAD, Row};
use crate::error::Failure;
use tribodyn_paper::{PaperError, files, markers, table};

const BEGIN: &str = "<!-- faults:begin -->";
const END: &str = "<!-- faults:end -->";
const DOCUMENT: &str = "docs/reliability.md";

/// Puts the rows of these trials into the table; rows of faults that were not tried this time stay.
pub fn rewrite(rows: &[Row]) -> Result<(), Failure> {
    let path = files::root().join(DOCUMENT);
    let text = files::read(&path)?;
    let cells: Vec<Vec<String>> = rows.iter().map(Row::cells).collect();
    let all = merged(before(&text), &cells);
    Ok(files::write(&path, replaced(&text, &table::markdown(&HEAD, &all))?.as_bytes())?)
}

/// The rows that stand in the document.
fn before(text: &str) -> Vec<Vec<String>> {
    let block = text.split_once(BEGIN).and_then(|(_, rest)| rest.split_once(END)).map_or("", |(block, _)| block);
    let rows = block.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |"));
    // Below the head and the line under it.
    rows.skip(2).map(|row| row.split(" | ").map(|cell| cell.trim().to_owned()).collect()).collect()
}

/// New rows in the places of those of the same fault, the others after them.
fn merged(mut all: Vec<Vec<String>>, new: &[Vec<String>]) -> Vec<Vec<String>> {
    for row in new {
        match all.iter_mut().find(|old| old.first() == row.first()) {
            Some(old) => old.clone_from(row),
            None => all.push(row.clone()),
        }
    }
    all
}

fn replaced(text: &str, block: &str) -> Result<String, PaperError> {
    markers::replaced(DOCUMENT, text, block, [BEGIN, END])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_the_document_has_its_block() {
        let text = files::read(&files::root().join(DOCUMENT)).unwrap();
        assert!(replaced(&text, "").is_ok());
    }

    #[test]
    fn identity_rows_that_were_not_tried_again_stay() {
        let row = |fault: &str, tried: &str| [fault, tried, tried, "", "passed"].map(str::to_owned).to_vec();
        let old = vec![row("kill", "10"), row("disk", "20")];
        let text = format!("{BEGIN}\n{}{END}", table::markdown(&HEAD, &old));
        assert_eq!(before(&text), old);
        let all = merged(before(&text), &[row("clock", "6"), row("kill", "100")]);
        assert_eq!(all, [row("kill", "100"), row("disk", "20"), row("clock", "6")]);
    }
}
