//! Generated blocks of documents, each between two lines that stay.

use crate::error::PaperError;

/// The text with the part between the two markers replaced.
///
/// # Errors
///
/// A marker that is missing or there twice, or the second before the first.
pub fn replaced(
    document: &str,
    text: &str,
    block: &str,
    [begin, end]: [&'static str; 2],
) -> Result<String, PaperError> {
    let missing = || PaperError::Markers { document: document.to_owned(), begin, end };
    let once = |marker: &str| text.matches(marker).count() == 1;
    if !once(begin) || !once(end) {
        return Err(missing());
    }
    let (head, rest) = text.split_once(begin).ok_or_else(missing)?;
    let (_, tail) = rest.split_once(end).ok_or_else(missing)?;
    Ok(format!("{head}{begin}\n{block}{end}{tail}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BEGIN: &str = "<!-- begin -->";
    const END: &str = "<!-- end -->";

    #[test]
    fn identity_only_the_block_is_replaced_and_replacing_twice_changes_nothing() {
        let text = format!("before\n{BEGIN}\nold\n{END}\nafter\n");
        let once = replaced("d", &text, "new\n", [BEGIN, END]).unwrap();
        assert_eq!(once, format!("before\n{BEGIN}\nnew\n{END}\nafter\n"));
        assert_eq!(replaced("d", &once, "new\n", [BEGIN, END]).unwrap(), once);
    }

    #[test]
    fn limit_missing_repeated_or_swapped_markers_are_refused() {
        for text in [String::new(), BEGIN.to_owned(), format!("{END}{BEGIN}"), format!("{BEGIN}{BEGIN}{END}")] {
            let refused = replaced("d", &text, "", [BEGIN, END]);
            assert!(matches!(refused, Err(PaperError::Markers { .. })), "{text}");
        }
    }
}
