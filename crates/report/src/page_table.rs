//! A table of a report, before it is HTML or Markdown.

/// Title, words and cells.
pub struct Table {
    pub title: String,
    /// A sentence below the title; may be empty.
    pub text: String,
    pub header: Vec<&'static str>,
    pub rows: Vec<Vec<String>>,
    /// Columns with numbers, aligned right.
    pub numbers: std::ops::Range<usize>,
    /// As wide as the page.
    pub wide: bool,
}
