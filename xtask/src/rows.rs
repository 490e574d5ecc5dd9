//! Tables of documents whose rows are written by several calls of a command: rows tried again are replaced, others
//! stay.

use crate::error::Failure;
use tribodyn_paper::{PaperError, files, markers, table};

/// A table between two marks of a document; the first cell of a row names what the row is of.
pub struct Rows<'a> {
    pub document: &'static str,
    pub marks: [&'static str; 2],
    pub head: &'a [&'a str],
}

impl Rows<'_> {
    /// Puts rows into the table, in the places of those of the same name, the others after them.
    pub fn rewrite(&self, rows: &[Vec<String>]) -> Result<(), Failure> {
        let path = files::root().join(self.document);
        let text = files::read(&path)?;
        let all = merged(self.before(&text), rows);
        Ok(files::write(&path, self.replaced(&text, &table::markdown(self.head, &all))?.as_bytes())?)
    }

    /// The rows that stand in the document, as far as they have as many columns as new ones.
    fn before(&self, text: &str) -> Vec<Vec<String>> {
        let [begin, end] = self.marks;
        let block = text.split_once(begin).and_then(|(_, rest)| rest.split_once(end)).map_or("", |(block, _)| block);
        let rows = block.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |"));
        // Below the head and the line under it.
        let cells = rows.skip(2).map(|row| row.split(" | ").map(|cell| cell.trim().to_owned()).collect());
        cells.filter(|row: &Vec<String>| row.len() == self.head.len()).collect()
    }

    fn replaced(&self, text: &str, block: &str) -> Result<String, PaperError> {
        markers::replaced(self.document, text, block, self.marks)
    }
}

fn merged(mut all: Vec<Vec<String>>, new: &[Vec<String>]) -> Vec<Vec<String>> {
    for row in new {
        match all.iter_mut().find(|old| old.first() == row.first()) {
            Some(old) => old.clone_from(row),
            None => all.push(row.clone()),
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_the_document_has_its_blocks() {
        for rows in [crate::faults::document::ROWS, crate::fuzz::document::ROWS] {
            let text = files::read(&files::root().join(rows.document)).unwrap();
            assert!(rows.replaced(&text, "").is_ok(), "{}", rows.marks[0]);
            assert!(!rows.before(&text).is_empty(), "{}", rows.marks[0]);
        }
    }

    #[test]
    fn identity_rows_that_were_not_tried_again_stay() {
        let rows = Rows { document: "none", marks: ["<!-- a -->", "<!-- b -->"], head: &["fault", "tried", "worst"] };
        let row = |fault: &str, tried: &str| [fault, tried, ""].map(str::to_owned).to_vec();
        let old = vec![row("kill", "10"), row("disk", "20")];
        let text = format!("{}\n{}{}", rows.marks[0], table::markdown(rows.head, &old), rows.marks[1]);
        assert_eq!(rows.before(&text), old);
        let all = merged(rows.before(&text), &[row("clock", "6"), row("kill", "100")]);
        assert_eq!(all, [row("kill", "100"), row("disk", "20"), row("clock", "6")]);
    }
}
