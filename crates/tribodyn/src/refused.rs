//! Refused cases.

use tribodyn_case::CaseError;

/// A refused case with the place to point at.
#[derive(Debug)]
pub struct RefusedCase {
    /// Name of the case file.
    pub file: String,
    /// The changes that brought the value in, each with a colon; empty where it stands in the file.
    pub options: String,
    /// The text that was read, changes made.
    pub text: String,
    /// Reason, with the place in the text.
    pub error: CaseError,
}
