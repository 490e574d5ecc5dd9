//! Reading case files from disk.

use crate::error::StudyError;
use crate::files::read_at_most;
use std::path::Path;
use tribodyn::{CaseFile, Change, Limits, without_mark};
use tribodyn_bearing::Races;
use tribodyn_record::{Layout, LayoutKind};

/// Reads a case file, makes the changes, parses and validates, within limits.
///
/// # Errors
/// [`StudyError::Read`], and a case that is refused.
pub fn read_case(path: &Path, changes: &[Change], limits: &Limits) -> Result<CaseFile, StudyError> {
    Ok(CaseFile::from_text(&path.display().to_string(), read_text(path, limits)?, changes, limits)?)
}

/// The Foxglove layout for recordings of a case.
///
/// # Errors
/// A case that makes no bearing.
pub fn layout_of(file: &CaseFile, kind: LayoutKind) -> Result<Layout, StudyError> {
    let speeds = Races { inner: file.case.speed.inner.clone(), outer: file.case.speed.outer.clone() };
    Ok(Layout::new(kind, &file.case.name, &file.bearing()?.geometry, &speeds))
}

/// The text of a case, a problem or a table of figures, without the byte order mark that some editors put in front.
///
/// # Errors
/// [`StudyError::Read`] for a file that cannot be read, is longer than the limit, or is not UTF-8 text.
pub fn read_text(path: &Path, limits: &Limits) -> Result<String, StudyError> {
    let read = |source| StudyError::Read { path: path.to_owned(), source };
    let bytes = read_at_most(path, limits.text_bytes).map_err(read)?;
    let text = String::from_utf8(bytes);
    text.map(without_mark)
        .map_err(|_| read(std::io::Error::new(std::io::ErrorKind::InvalidData, "it is not UTF-8 text")))
}
