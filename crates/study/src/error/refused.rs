//! Refused cases, and messages with their causes.

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

/// The message of an error with those of its causes that it does not repeat: a full disk lies deep.
pub fn with_causes(error: &dyn std::error::Error) -> String {
    let mut message = error.to_string();
    let mut cause = error.source();
    while let Some(error) = cause {
        let text = error.to_string();
        if !message.contains(&text) {
            message = format!("{message}: {text}");
        }
        cause = error.source();
    }
    message
}
