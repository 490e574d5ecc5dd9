//! Case files as text, with changes to single values.

use crate::answers::Question;
use crate::error::AnswerError;
use crate::limits::Limits;
use crate::refused::RefusedCase;
use std::fmt;
use tribodyn_bearing::{Bearing, RunInputs, SearchWatch};
use tribodyn_case::{Case, CaseError, InputError, Purpose, set_value};

/// The halves of `PATH=VALUE`, without the blanks around them.
///
/// # Errors
/// A text that says what is allowed.
pub fn path_and_value(text: &str) -> Result<[&str; 2], String> {
    match text.split_once('=').map(|(path, value)| [path.trim(), value.trim()]) {
        Some(halves) if halves.iter().all(|half| !half.is_empty()) => Ok(halves),
        _ => Err("allowed is PATH=VALUE, the value as in a case file, such as ring.z.Force=kN(30)".to_owned()),
    }
}

/// A value of the case file to be replaced.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// The option as it was given, for messages.
    option: String,
    path: String,
    value: String,
}

impl Change {
    /// A value for the place `path`; `option` names the change in messages.
    pub fn new(option: String, path: &str, value: &str) -> Self {
        Self { option, path: path.to_owned(), value: value.to_owned() }
    }

    /// The text with the change made.
    pub fn apply(&self, text: &str) -> Result<String, CaseError> {
        set_value(text, &self.path, &self.value)
    }

    /// True if an error at `path` can be about the change: one of the two lies within the other.
    pub fn concerns(&self, path: &str) -> bool {
        let within = |inner: &str, outer: &str| {
            inner.strip_prefix(outer).is_some_and(|r| r.is_empty() || r.starts_with(['.', '[']))
        };
        within(&self.path, path) || within(path, &self.path)
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.option)
    }
}

/// A case file's text, changes made, and what it says.
pub struct CaseFile {
    /// Name for messages.
    pub name: String,
    /// The text that was read, changes made.
    pub text: String,
    /// The case in SI units.
    pub case: Case,
}

impl CaseFile {
    /// Makes the changes to a text, parses and validates; `name` is for messages. A byte order mark is left out.
    pub fn from_text(name: &str, original: String, changes: &[Change], limits: &Limits) -> Result<Self, AnswerError> {
        let original = without_mark(original);
        let mut text = original.clone();
        for change in changes {
            text = match change.apply(&text) {
                Ok(changed) => changed,
                // A file that cannot be read has no values to replace: then that is the news.
                Err(error) => {
                    Case::from_ron(&original).map_err(|error| refused(name, &original, String::new(), error))?;
                    return Err(AnswerError::Change { option: change.to_string(), error: Box::new(error) });
                }
            };
        }
        let within = |case: Case| limits.check(&text, &case).map(|()| case);
        match Case::from_ron(&text).and_then(within) {
            Ok(case) => Ok(Self { name: name.to_owned(), text, case }),
            Err(error) => Err(refused_after(name, (&original, &text), changes, limits, error)),
        }
    }

    /// A question about the case, its searches linked to the asker.
    pub fn question(&self, watch: SearchWatch) -> Question<'_> {
        Question { name: &self.name, text: &self.text, case: &self.case, watch }
    }

    /// The bearing that the solvers work with.
    pub fn bearing(&self) -> Result<Bearing, AnswerError> {
        self.plain().bearing()
    }

    /// [`Self::bearing`], where the case has all that a model needs.
    pub fn bearing_for(&self, purpose: Purpose) -> Result<Bearing, AnswerError> {
        self.plain().bearing_for(purpose)
    }

    /// Inputs of a transient run.
    pub fn run_inputs(&self) -> Result<RunInputs, AnswerError> {
        self.plain().run_inputs()
    }

    /// The error of an input that makes no bearing, with the name of the case.
    pub fn not_usable(&self, error: InputError) -> AnswerError {
        self.plain().not_usable(error)
    }

    /// A question that nobody follows.
    fn plain(&self) -> Question<'_> {
        self.question(SearchWatch::default())
    }
}

/// A text without the byte order mark that some editors put in front.
pub fn without_mark(mut text: String) -> String {
    if text.starts_with('\u{feff}') {
        text.drain(..'\u{feff}'.len_utf8());
    }
    text
}

/// Blames the file for what is wrong without the changes too, and otherwise the change that the error is about, or all.
fn refused_after(
    name: &str,
    (original, text): (&str, &str),
    changes: &[Change],
    limits: &Limits,
    error: CaseError,
) -> AnswerError {
    if changes.is_empty() {
        return refused(name, text, String::new(), error);
    }
    if let Err(before) = Case::from_ron(original).and_then(|case| limits.check(original, &case))
        && (&before.path, &before.message) == (&error.path, &error.message)
    {
        return refused(name, original, String::new(), before);
    }
    let mut blamed: Vec<_> = changes.iter().filter(|change| change.concerns(&error.path)).collect();
    if blamed.is_empty() {
        blamed = changes.iter().collect();
    }
    let options: String = blamed.iter().map(|change| format!("{change}: ")).collect();
    refused(name, text, options, error)
}

fn refused(file: &str, text: &str, options: String, error: CaseError) -> AnswerError {
    AnswerError::Case(Box::new(RefusedCase { file: file.to_owned(), options, text: text.to_owned(), error }))
}

#[cfg(test)]
mod tests {
    use super::Change;

    #[test]
    fn limit_a_change_concerns_what_lies_within_it_or_around_it() {
        let change = Change::new("fit".to_owned(), "geometry.fit", "deg(1)");
        assert!(change.concerns("geometry.fit.ContactAngle") && change.concerns("geometry"));
        assert!(!change.concerns("geometry.fitted") && !change.concerns("cage"));
    }
}
