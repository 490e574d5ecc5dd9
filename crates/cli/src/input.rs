//! Reading case files, with the changes that the command line makes to them.

use crate::failure::{CaseFailure, Failure};
use miette::NamedSource;
use std::fmt;
use std::path::{Path, PathBuf};
use tribodyn_bearing::Bearing;
use tribodyn_case::{Case, CaseError, set_value};

/// A case file and what to change in it for this run.
#[derive(clap::Args)]
pub struct CaseArguments {
    /// Case file (RON)
    #[arg(value_name = "CASE")]
    pub path: PathBuf,
    /// Replace one value of the case for this run, such as 'ring.z.Force=kN(30)'; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = Change::parse)]
    pub changes: Vec<Change>,
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
    fn parse(text: &str) -> Result<Self, String> {
        match text.split_once('=') {
            Some((path, value)) if !path.trim().is_empty() && !value.trim().is_empty() => {
                Ok(Self::new(format!("--set {text}"), path.trim(), value.trim()))
            }
            _ => Err("allowed is PATH=VALUE, the value as in a case file, such as ring.z.Force=kN(30)".to_owned()),
        }
    }

    pub fn new(option: String, path: &str, value: &str) -> Self {
        Self { option, path: path.to_owned(), value: value.to_owned() }
    }

    /// The text with the change made.
    pub fn apply(&self, text: &str) -> Result<String, CaseError> {
        set_value(text, &self.path, &self.value)
    }

    /// Whether the change can be what an error at `path` is about: one of the two lies within the other.
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
    pub name: String,
    pub text: String,
    pub case: Case,
}

impl CaseFile {
    /// Reads, makes the changes, parses and validates.
    pub fn read(path: &Path, changes: &[Change]) -> Result<Self, Failure> {
        Self::from_text(&path.display().to_string(), read_text(path)?, changes)
    }

    /// Makes the changes to a text, parses and validates; `name` is for messages.
    pub fn from_text(name: &str, original: String, changes: &[Change]) -> Result<Self, Failure> {
        let mut text = original.clone();
        for change in changes {
            text = match change.apply(&text) {
                Ok(changed) => changed,
                // A file that cannot be read has no values to replace: then that is the news.
                Err(error) => {
                    Case::from_ron(&original).map_err(|error| refused(name, &original, String::new(), error))?;
                    return Err(Failure::Change { option: change.to_string(), error: Box::new(error) });
                }
            };
        }
        match Case::from_ron(&text) {
            Ok(case) => Ok(Self { name: name.to_owned(), text, case }),
            Err(error) => Err(refused_after(name, &original, &text, changes, error)),
        }
    }

    /// The bearing that the solvers work with.
    pub fn bearing(&self) -> Result<Bearing, Failure> {
        self.case.bearing().map_err(|source| Failure::Bearing { file: self.name.clone(), source })
    }
}

/// The text of a case file.
pub fn read_text(path: &Path) -> Result<String, Failure> {
    let read = |source| Failure::Read { path: path.to_owned(), source };
    let bytes = std::fs::read(path).map_err(read)?;
    String::from_utf8(bytes)
        .map_err(|_| read(std::io::Error::new(std::io::ErrorKind::InvalidData, "it is not UTF-8 text")))
}

/// Blames the file for what is wrong without the changes too, and otherwise the change that the error is about, or all.
fn refused_after(name: &str, original: &str, text: &str, changes: &[Change], error: CaseError) -> Failure {
    if let Err(before) = Case::from_ron(original)
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

fn refused(file: &str, text: &str, options: String, error: CaseError) -> Failure {
    let span = (error.offset, error.length).into();
    let text = NamedSource::new(file, text.to_owned());
    Failure::Case(Box::new(CaseFailure { file: file.to_owned(), options, text, span, error }))
}

#[cfg(test)]
mod tests {
    use super::Change;

    #[test]
    fn limit_a_change_concerns_what_lies_within_it_or_around_it() {
        let change = Change::parse("geometry.fit = deg(1)").unwrap();
        assert_eq!((change.path.as_str(), change.value.as_str()), ("geometry.fit", "deg(1)"));
        assert!(change.concerns("geometry.fit.ContactAngle") && change.concerns("geometry"));
        assert!(!change.concerns("geometry.fitted") && !change.concerns("cage"));
        assert!(Change::parse("geometry.fit").is_err() && Change::parse("=1").is_err() && Change::parse("a=").is_err());
    }
}
