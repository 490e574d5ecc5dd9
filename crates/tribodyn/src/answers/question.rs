//! A question about a case, and the link to whoever asks it.

use crate::error::AnswerError;
use crate::plausibility;
use tribodyn_bearing::{Bearing, OperatingPoint, RunInputs, SearchWatch};
use tribodyn_case::{Case, InputError, Purpose};

/// A case with the text that it was read from, and the link to whoever asks.
#[derive(Debug, Clone)]
pub struct Question<'a> {
    /// Name of the case in messages.
    pub name: &'a str,
    /// The text that was read: single values of it are held against what is usual.
    pub text: &'a str,
    /// The case in SI units.
    pub case: &'a Case,
    /// By which searches are followed and ended.
    pub watch: SearchWatch,
}

impl Question<'_> {
    /// The case's operating point, its searches linked to the asker.
    pub fn point(&self) -> OperatingPoint {
        OperatingPoint { watch: self.watch.clone(), ..self.case.operating_point() }
    }

    /// The bearing that the solvers work with.
    ///
    /// # Errors
    /// A case that makes no bearing.
    pub fn bearing(&self) -> Result<Bearing, AnswerError> {
        self.case.bearing().map_err(|source| self.not_usable(source.into()))
    }

    /// [`Self::bearing`], where the case has all that a model needs.
    ///
    /// # Errors
    /// As [`Self::bearing`]; all that is missing.
    pub fn bearing_for(&self, purpose: Purpose) -> Result<Bearing, AnswerError> {
        self.case.require(purpose).map_err(|source| self.not_usable(source.into()))?;
        self.bearing()
    }

    /// Refuses loads to which no search gives an answer that means anything: a slip of a unit would cost minutes.
    ///
    /// # Errors
    /// [`AnswerError::Overload`] with a first estimate.
    pub fn bearable(&self, bearing: &Bearing) -> Result<(), AnswerError> {
        match plausibility::hopeless(self.case, (self.text, bearing)) {
            Some(why) => Err(AnswerError::Overload { file: self.name.to_owned(), why }),
            None => Ok(()),
        }
    }

    /// Inputs of a transient run.
    ///
    /// # Errors
    /// A case without what a run needs.
    pub fn run_inputs(&self) -> Result<RunInputs, AnswerError> {
        self.case.run_inputs().map_err(|source| self.not_usable(source))
    }

    /// The error of an input that makes no bearing, with the name of the case.
    pub fn not_usable(&self, error: InputError) -> AnswerError {
        let file = self.name.to_owned();
        match error {
            InputError::Lacking(source) => AnswerError::Lacking { file, source },
            InputError::Bearing(source) => AnswerError::Bearing { file, source },
        }
    }
}
