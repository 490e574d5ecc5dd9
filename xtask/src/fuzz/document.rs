//! The generated block of docs/reliability.md.

use super::{HEAD, Tried, cells};
use crate::error::Failure;
use tribodyn_paper::{PaperError, files, markers, table};

const BEGIN: &str = "<!-- fuzz:begin -->";
const END: &str = "<!-- fuzz:end -->";
const DOCUMENT: &str = "docs/reliability.md";

pub fn rewrite(tried: &[Tried]) -> Result<(), Failure> {
    let path = files::root().join(DOCUMENT);
    let text = replaced(&files::read(&path)?, &table::markdown(&HEAD, &cells(tried)))?;
    Ok(files::write(&path, text.as_bytes())?)
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
