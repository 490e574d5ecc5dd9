//! A refused case file: what is wrong, where it stands in the text and what would be allowed.

use super::outline::{Outline, Path, Segment};
use super::{tokens, units};
use ron::error::{Error, Position, SpannedError};
use std::ops::Range;

/// A refused case file, or a path that is not in it.
///
/// Its text is one line without the position, so that a caller puts `file:line:column` in front.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}", self.summary())]
pub struct CaseError {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Path of the field, such as `geometry.ball_diameter`; empty for the file as a whole.
    pub path: String,
    /// The value as the file has it, abridged where it is a whole section; empty where it is missing.
    pub value: String,
    /// The fault and what is allowed.
    pub message: String,
    /// Byte offset of the value in the text.
    pub offset: usize,
    /// Length of the value in bytes.
    pub length: usize,
}

/// Characters of a value that are repeated in an error.
const VALUE_LENGTH: usize = 80;

impl CaseError {
    /// An error about the part `range` of `text`.
    pub(super) fn new(text: &str, range: Range<usize>, path: &Path, message: String) -> Self {
        let before = &text[..range.start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Self {
            line: 1 + before.matches('\n').count(),
            column: 1 + before[line_start..].chars().count(),
            path: path.to_string(),
            value: abridged(&text[range.clone()]),
            message,
            offset: range.start,
            length: range.len(),
        }
    }

    /// An error about the value at a path of a text, or about the section around it.
    pub fn at(text: &str, path: &str, message: String) -> Self {
        let path = Path::parse(path).unwrap_or_default();
        let found = Outline::new(text).map(|outline| outline.find(&path).unwrap_or_else(|missing| missing.deepest));
        Self::new(text, found.unwrap_or(0..0), &path, message)
    }

    /// An error of the reader, which stopped at `path`.
    pub(super) fn from_reader(text: &str, spanned: &SpannedError, path: &serde_path_to_error::Path) -> Self {
        let mut path = field_path(path);
        let outline = Outline::new(text);
        let reader = reader_range(text, spanned);
        let message = explain(&spanned.code, outline.is_some());
        let Some(outline) = outline else {
            return Self::new(text, reader, &path, format!("the file is not well-formed RON: {message}"));
        };
        let value = outline.find(&path).ok();
        match &spanned.code {
            Error::MissingStructField { field, .. } => {
                path.0.push(Segment::Name((*field).to_owned()));
                // There is no value to show: the position is that of the section without it.
                Self { value: String::new(), ..Self::new(text, value.unwrap_or(reader), &path, message) }
            }
            Error::ExpectedComma => match outline.entry_at(reader.start) {
                Some((path, _, value)) => Self::new(text, value, &path, message),
                None => Self::new(text, reader, &path, message),
            },
            // The position is that of the name before the value.
            Error::NoSuchStructField { .. } | Error::DuplicateStructField { .. } | Error::ExpectedString => {
                match outline.entry_at(reader.start) {
                    Some((path, pointed, value)) => {
                        Self { value: abridged(&text[value]), ..Self::new(text, pointed, &path, message) }
                    }
                    None => Self::new(text, reader, &path, message),
                }
            }
            _ => Self::new(text, value.unwrap_or(reader), &path, message),
        }
    }

    fn summary(&self) -> String {
        let Self { path, value, message, .. } = self;
        match (path.is_empty(), value.is_empty()) {
            (true, _) => message.clone(),
            (false, true) => format!("{path}: {message}"),
            (false, false) => format!("{path} = {value}: {message}"),
        }
    }
}

/// A value for an error message, on one line: a section of several lines is abridged to its name and brackets, other
/// text ends in an ellipsis where it is too long or breaks.
fn abridged(text: &str) -> String {
    let text = text.trim_matches(tokens::is_blank);
    let line = text.lines().next().unwrap_or_default();
    if line.len() < text.len() && text.ends_with([')', ']', '}']) {
        let open = line.find(['(', '[', '{']).map_or(line.len(), |at| at + 1);
        return format!("{}…{}", &line[..open], &text[text.len() - 1..]);
    }
    let end = line.char_indices().nth(VALUE_LENGTH).map_or(line.len(), |(end, _)| end);
    if end < text.len() { format!("{}…", &line[..end]) } else { text.to_owned() }
}

/// The reader's path in the form of [`Path`]: the only map of a case is `sources`, and units are no part of a path.
fn field_path(path: &serde_path_to_error::Path) -> Path {
    use serde_path_to_error::Segment as Step;
    let mut segments = Vec::new();
    for step in path {
        segments.push(match step {
            Step::Seq { index } => Segment::Index(*index),
            Step::Map { key } if segments == [Segment::Name("sources".into())] => Segment::Key(key.clone()),
            Step::Map { key } => Segment::Name(key.clone()),
            Step::Enum { variant } if units::is_unit(variant) => break,
            Step::Enum { variant } => Segment::Name(variant.clone()),
            Step::Unknown => break,
        });
    }
    Path(segments)
}

/// The part of the text that the reader had before it when it stopped, without white space around.
fn reader_range(text: &str, spanned: &SpannedError) -> Range<usize> {
    let (start, end) = (offset(text, spanned.span.start), offset(text, spanned.span.end));
    let (start, end) = (start.min(end), end.max(start));
    let part = &text[start..end];
    let trimmed = part.trim_start_matches(tokens::is_blank);
    let start = start + part.len() - trimmed.len();
    start..start + trimmed.trim_end_matches(tokens::is_blank).len()
}

/// Byte offset of a position in lines and columns of characters, both from 1.
fn offset(text: &str, position: Position) -> usize {
    let line = text.split_inclusive('\n').take(position.line.saturating_sub(1)).map(str::len).sum::<usize>();
    let column = text[line..].chars().take(position.col.saturating_sub(1)).map(char::len_utf8).sum::<usize>();
    line + column
}

/// The reader's error in the words of case files.
fn explain(error: &Error, well_formed: bool) -> String {
    match error {
        Error::NoSuchStructField { expected, found, .. } => {
            format!("unknown field `{found}`; allowed: {}", expected.join(", "))
        }
        Error::MissingStructField { field, .. } => format!("field `{field}` is missing"),
        Error::DuplicateStructField { field, .. } => format!("field `{field}` stands here twice"),
        Error::NoSuchEnumVariant { expected, found, .. } => {
            format!("`{found}` is not known here; allowed: {}", expected.join(", "))
        }
        Error::ExpectedInteger => "expected a whole number".to_owned(),
        // In a text whose brackets match, only the fraction of a number stands between a value and its comma.
        Error::ExpectedComma if well_formed => "expected a whole number".to_owned(),
        Error::ExpectedStructLikeEnd if well_formed => "more values than belong in these parentheses".to_owned(),
        Error::IntegerOutOfBounds => "expected a whole number, not negative and not too large".to_owned(),
        Error::ExpectedFloat => "expected a plain number".to_owned(),
        Error::ExpectedBoolean => "expected true or false".to_owned(),
        Error::ExpectedString => "expected a string in quotes".to_owned(),
        Error::ExpectedNamedStructLike(_) | Error::ExpectedDifferentStructName { .. } => {
            "expected fields in parentheses, `(name: value, …)`".to_owned()
        }
        Error::ExpectedStructLike => "expected values in parentheses, `(…, …)`".to_owned(),
        Error::ExpectedArray => "expected a list in brackets, `[…, …]`".to_owned(),
        Error::ExpectedIdentifier | Error::InvalidIdentifier(_) | Error::SuggestRawIdentifier(_) => {
            "expected a name".to_owned()
        }
        Error::TrailingCharacters => "nothing may follow the end of the case".to_owned(),
        Error::Eof => "unexpected end of the file: a bracket or string is not closed".to_owned(),
        Error::Message(message) => message.clone(),
        other => {
            let text = other.to_string();
            text.strip_prefix("Expected ").map_or(text.clone(), |rest| format!("expected {rest}"))
        }
    }
}
