//! Reading case files.

use crate::failure::{CaseFailure, Failure};
use miette::NamedSource;
use std::path::Path;
use tribodyn_bearing::Bearing;
use tribodyn_bearing::case::{Case, CaseError};

/// A case file's text and what it says.
pub struct CaseFile {
    pub name: String,
    pub text: String,
    pub case: Case,
}

impl CaseFile {
    /// Reads, parses and validates.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let read = |source| Failure::Read { path: path.to_owned(), source };
        let bytes = std::fs::read(path).map_err(read)?;
        let text = String::from_utf8(bytes)
            .map_err(|_| read(std::io::Error::new(std::io::ErrorKind::InvalidData, "it is not UTF-8 text")))?;
        let name = path.display().to_string();
        let case = Case::from_ron(&text).map_err(|error| refused(&name, &text, error))?;
        Ok(Self { name, text, case })
    }

    /// The bearing that the solvers work with.
    pub fn bearing(&self) -> Result<Bearing, Failure> {
        Bearing::new(&self.case).map_err(|source| Failure::Bearing { file: self.name.clone(), source })
    }
}

fn refused(file: &str, text: &str, error: CaseError) -> Failure {
    let span = (error.offset, error.length).into();
    let text = NamedSource::new(file, text.to_owned());
    Failure::Case(Box::new(CaseFailure { file: file.to_owned(), text, span, error }))
}
