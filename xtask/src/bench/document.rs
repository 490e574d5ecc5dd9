//! The generated block of docs/performance.md.

use super::{Report, row};
use crate::error::Failure;
use crate::{files, table};

const BEGIN: &str = "<!-- bench:begin -->";
const END: &str = "<!-- bench:end -->";
const DOCUMENT: &str = "docs/performance.md";

pub fn rewrite(report: &Report) -> Result<(), Failure> {
    let path = files::root().join(DOCUMENT);
    let text = replaced(&files::read(&path)?, &block(report))?;
    files::write(&path, text.as_bytes())
}

fn block(report: &Report) -> String {
    let table = table::markdown(&row::HEAD, &row::cells(&report.rows));
    format!("Measured on: {}. Case `{}`.\n\n{table}", report.machine.line(), report.case)
}

fn replaced(text: &str, block: &str) -> Result<String, Failure> {
    let missing = || Failure::Markers { document: DOCUMENT.to_owned(), begin: BEGIN, end: END };
    if text.matches(BEGIN).count() != 1 || text.matches(END).count() != 1 {
        return Err(missing());
    }
    let (head, rest) = text.split_once(BEGIN).ok_or_else(missing)?;
    let (_, tail) = rest.split_once(END).ok_or_else(missing)?;
    Ok(format!("{head}{BEGIN}\n{block}{END}{tail}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_only_the_block_is_replaced() {
        let once = replaced(&format!("a\n{BEGIN}\nold\n{END}\nb\n"), "new\n").unwrap();
        assert_eq!(once, format!("a\n{BEGIN}\nnew\n{END}\nb\n"));
        assert_eq!(replaced(&once, "new\n").unwrap(), once);
        assert!(replaced(END, "").is_err());
    }

    #[test]
    fn identity_the_document_has_its_block() {
        let text = files::read(&files::root().join(DOCUMENT)).unwrap();
        assert!(replaced(&text, "").is_ok());
    }
}
