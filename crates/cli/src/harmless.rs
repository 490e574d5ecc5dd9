//! Texts from files and other people that must not steer a terminal.

/// A text of several lines that cannot steer a terminal.
pub fn harmless(text: &str) -> String {
    text.chars().map(|c| if steers(c) { '\u{fffd}' } else { c }).collect()
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
