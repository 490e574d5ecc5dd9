#![doc = include_str!("../README.md")]

mod bearing;
mod dataset;
mod deviations;
mod error;
mod locate;
mod lubricant;
mod missing;
mod mounting;
mod needs;
mod operation;
mod optional;
mod outline;
mod quantity;
mod schema;
mod shaft;
mod sources;
mod tokens;
mod units;
mod validate;
mod validate_ball_spalls;
mod validate_bounds;
mod validate_cage;
mod validate_shaft;
mod validate_tilt;
mod validate_transient;

#[cfg(test)]
mod tests;
#[cfg(test)]
mod tests_cage;
#[cfg(test)]
mod tests_lubricant;
#[cfg(test)]
mod tests_mounting;
#[cfg(test)]
mod tests_needs;
#[cfg(test)]
mod tests_tilt;
#[cfg(test)]
mod tests_transient;

pub use dataset::*;
pub use error::CaseError;
pub use locate::{Template, locate, set_value, values};
pub use mounting::Growths;
pub use needs::{Lacking, Purpose};
pub use operation::InputError;
pub use quantity::{Quantity, quantities};
pub use schema::*;
pub use shaft::*;
pub use units::{in_si, unit_names};
pub use validate::SPEED_MAX;

use outline::{Outline, Path};
use ron::extensions::Extensions;
use serde::de::DeserializeOwned;
use serde_path_to_error::Track;

impl Case {
    /// Reads a case from RON text and checks it: every value is possible, and every source names a value of the text.
    ///
    /// # Errors
    /// [`CaseError`] with position, path, value and what is allowed, for the first thing that is wrong; of missing
    /// fields it names all.
    pub fn from_ron(text: &str) -> Result<Self, CaseError> {
        let (case, outline) = checked(text, validate::validate)?;
        sources::check(text, &case, &outline)?;
        Ok(case)
    }
}

impl ShaftSystem {
    /// Reads a shaft with its bearings from RON text and checks that every value is possible.
    ///
    /// # Errors
    /// [`CaseError`] as for [`Case::from_ron`].
    pub fn from_ron(text: &str) -> Result<Self, CaseError> {
        checked(text, validate_shaft::validate).map(|(system, _)| system)
    }
}

impl DatasetPlan {
    /// Reads the plan of a data set from RON text and checks that every value is possible.
    ///
    /// # Errors
    /// [`CaseError`] as for [`Case::from_ron`].
    pub fn from_ron(text: &str) -> Result<Self, CaseError> {
        checked(text, dataset::validate).map(|(plan, _)| plan)
    }
}

/// A text read and found possible, with its outline.
fn checked<'t, T: DeserializeOwned>(
    text: &'t str,
    validate: impl Fn(&T) -> validate::Verdict,
) -> Result<(T, Outline<'t>), CaseError> {
    let read: T = parse(text)?;
    // What the reader accepts has an outline; without one there would be nothing to point at.
    let Some(outline) = Outline::new(text) else {
        let message = "the file cannot be outlined: brackets or strings do not match".to_owned();
        return Err(CaseError::new(text, 0..text.len(), &Path::default(), message));
    };
    validate(&read).map_err(|refusal| refused(text, &outline, refusal))?;
    Ok((read, outline))
}

/// A refusal with its place in the text.
fn refused(text: &str, outline: &Outline<'_>, refusal: validate::Refusal) -> CaseError {
    let path = Path::parse(&refusal.path).unwrap_or_default();
    // A default that the text leaves out stands in the section around it.
    let range = outline.find(&path).unwrap_or_else(|missing| missing.deepest);
    CaseError::new(text, range, &path, refusal.message)
}

/// Text to case, without a look at what the values mean. A text that lacks fields is told all of them.
fn parse<T: DeserializeOwned>(text: &str) -> Result<T, CaseError> {
    read(text).map_err(|(error, lacks)| match lacks {
        true => missing::with_all_missing(text, error, |text| read::<T>(text).err()),
        false => error,
    })
}

/// Text to case; an error with whether a field is missing.
fn read<T: DeserializeOwned>(text: &str) -> Result<T, missing::Refused> {
    let options = ron::Options::default().with_default_extension(Extensions::IMPLICIT_SOME);
    let mut track = Track::new();
    let mut reader = ron::Deserializer::from_str_with_options(text, &options)
        .map_err(|error| (CaseError::from_reader(text, &error, &Track::new().path()), false))?;
    let case = T::deserialize(serde_path_to_error::Deserializer::new(&mut reader, &mut track));
    let case = case.and_then(|case: T| reader.end().map(|()| case));
    case.map_err(|error| {
        let lacks = matches!(error, ron::Error::MissingStructField { .. });
        (CaseError::from_reader(text, &reader.span_error(error), &track.path()), lacks)
    })
}
