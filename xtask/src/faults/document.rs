//! The generated block of docs/reliability.md.

use super::row::{HEAD, Row};
use crate::error::Failure;
use tribodyn_paper::{PaperError, files, markers, table};

const BEGIN: &str = "<!-- faults:begin -->";
const END: &str = "<!-- faults:end -->";
const DOCUMENT: &str = "docs/reliability.md";

pub fn rewrite(command: &str, rows: &[Row]) -> Result<(), Failure> {
    let path = files::root().join(DOCUMENT);
    let text = replaced(&files::read(&path)?, &block(command, rows))?;
    Ok(files::write(&path, text.as_bytes())?)
}

fn block(command: &str, rows: &[Row]) -> String {
    let cells: Vec<Vec<String>> = rows.iter().map(Row::cells).collect();
    format!("Written by `{command}`.\n\n{}", table::markdown(&HEAD, &cells))
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
}
