//! Numbers and sentences as people read them, on pages and on a terminal.

/// Lines of warnings on a terminal or a page, the one that counts the rest included.
pub const MOST_LINES: usize = 12;

/// The lines that are shown: the first ones, and how many more there are.
pub fn shown(all: &[String]) -> Vec<String> {
    if all.len() <= MOST_LINES {
        return all.to_vec();
    }
    let kept = MOST_LINES - 1;
    let rest = format!("… and {} more warnings; --json has all of them", all.len() - kept);
    all[..kept].iter().cloned().chain([rest]).collect()
}

/// A number with fixed digits; what rounds to zero has no sign.
pub fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    match text.strip_prefix('-') {
        Some(magnitude) if magnitude.bytes().all(|byte| matches!(byte, b'0' | b'.')) => magnitude.to_owned(),
        _ => text,
    }
}

/// Value and unit of an acceleration in a table: only where patch rule and scheme carry it.
pub fn acceleration(value: String, carried: bool) -> (String, &'static str) {
    if carried { (value, "m/s²") } else { ("–".to_owned(), "not resolved") }
}

/// True for a character that can steer a terminal: control characters but for line ends and tabs, and marks that turn
/// the direction of writing.
pub fn steers(c: char) -> bool {
    (c.is_control() && !matches!(c, '\n' | '\t')) || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// A text on one line that cannot steer a terminal: line ends and tabs are spaces, other control characters, and marks
/// that turn the direction of writing, are `\u{fffd}`.
pub fn visible(text: &str) -> String {
    let one = |c: char| match c {
        '\n' | '\r' | '\t' => ' ',
        c if steers(c) => '\u{fffd}',
        c => c,
    };
    text.chars().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_no_more_lines_than_a_person_reads() {
        let many = |count: usize| (0..count).map(|k| k.to_string()).collect::<Vec<_>>();
        assert_eq!(shown(&many(12)).len(), 12);
        let lines = shown(&many(30));
        assert_eq!((lines.len(), lines[10].as_str()), (12, "10"));
        assert!(lines[11].contains("19 more"), "{lines:?}");
    }
}
