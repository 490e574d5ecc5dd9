//! The generated block of docs/performance.md.

use super::{Report, row};
use crate::error::Failure;
use tribodyn_paper::{PaperError, files, markers, table};

const BEGIN: &str = "<!-- bench:begin -->";
const END: &str = "<!-- bench:end -->";
const DOCUMENT: &str = "docs/performance.md";

pub fn rewrite(report: &Report) -> Result<(), Failure> {
    let path = files::root().join(DOCUMENT);
    let text = replaced(&files::read(&path)?, &block(report))?;
    Ok(files::write(&path, text.as_bytes())?)
}

fn block(report: &Report) -> String {
    let table = table::markdown(&row::HEAD, &row::cells(&report.rows));
    format!("Measured on: {}. Case `{}`.\n\n{table}", report.machine.line(), report.case)
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
