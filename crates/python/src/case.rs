//! Cases: text that has been read and checked, and copies of it with other values.

use crate::error;
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;
use tribodyn::{CaseFile, Change, Limits};
use tribodyn_case::{locate, values};
use tribodyn_catalogue::{CatalogueError, Envelope, Fits, Given, NewCase, Ratings, find};
use tribodyn_study::{StudyError, read_case};

/// A case that was accepted. It does not change.
#[pyclass(frozen, name = "Case", module = "tribodyn._native")]
pub struct NativeCase {
    pub file: Arc<CaseFile>,
    pub limits: Limits,
}

fn limits(no_limits: bool) -> Limits {
    if no_limits { Limits::NONE } else { Limits::NORMAL }
}

impl NativeCase {
    fn accept<E: Into<StudyError>>(py: Python<'_>, file: Result<CaseFile, E>, limits: Limits) -> PyResult<Self> {
        let file = file.map_err(|failure| error::study(py, failure))?;
        Ok(Self { file: Arc::new(file), limits })
    }
}

#[pymethods]
impl NativeCase {
    /// Reads a case file.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf, no_limits: bool) -> PyResult<Self> {
        let limits = limits(no_limits);
        Self::accept(py, py.detach(|| read_case(&path, &[], &limits)), limits)
    }

    /// Reads a text; `name` stands for the file in messages.
    #[staticmethod]
    fn parse(py: Python<'_>, text: String, name: &str, no_limits: bool) -> PyResult<Self> {
        let limits = limits(no_limits);
        Self::accept(py, py.detach(|| CaseFile::from_text(name, text, &[], &limits)), limits)
    }

    /// A case from a designation of the catalogue, or from boundary dimensions in mm.
    #[staticmethod]
    fn make(py: Python<'_>, request: NewRequest) -> PyResult<Self> {
        let (name, text) = request.text(py)?;
        Self::accept(py, CaseFile::from_text(&name, text, &[], &Limits::NORMAL), Limits::NORMAL)
    }

    /// A copy with other values at some paths.
    fn replaced(&self, py: Python<'_>, changes: Vec<(String, String)>) -> PyResult<Self> {
        let (file, limits) = (&self.file, self.limits);
        let changed = py.detach(|| {
            let options: Vec<Change> =
                changes.iter().map(|(path, value)| Change::new(format!("{path} = {value}"), path, value)).collect();
            CaseFile::from_text(&file.name, file.text.clone(), &options, &limits)
        });
        Self::accept(py, changed, limits)
    }

    /// The text at a path; None where there is nothing.
    fn value(&self, path: &str) -> Option<String> {
        locate(&self.file.text, path).map(|range| self.file.text[range].to_owned())
    }

    /// Paths and texts of all single values.
    fn values(&self) -> Vec<(String, String)> {
        let text = &self.file.text;
        values(text).into_iter().map(|(path, range)| (path, text[range].to_owned())).collect()
    }

    /// The text that was accepted.
    #[getter]
    fn text(&self) -> &str {
        &self.file.text
    }

    /// The file's name, for messages.
    #[getter]
    fn name(&self) -> &str {
        &self.file.name
    }

    /// The bearing's name.
    #[getter]
    fn bearing(&self) -> &str {
        &self.file.case.name
    }
}

/// Data from which a new case is made.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct NewRequest {
    designation: Option<String>,
    angle: Option<f64>,
    bore: Option<f64>,
    outside: Option<f64>,
    width: Option<f64>,
    balls: Option<usize>,
    ball: Option<f64>,
    dynamic_rating: Option<f64>,
    static_rating: Option<f64>,
    radial: Option<f64>,
    axial: Option<f64>,
    speed: Option<f64>,
    lubricant: Option<String>,
    shaft_fit: Option<String>,
    housing_fit: Option<String>,
}

impl NewRequest {
    /// Name and text of the case.
    fn text(&self, py: Python<'_>) -> PyResult<(String, String)> {
        let positive = |value: f64| value.is_finite() && value > 0.0;
        for (name, value, sound, allowed) in [
            ("dynamic_rating", self.dynamic_rating, positive as fn(f64) -> bool, "allowed is a load above 0 in N"),
            ("static_rating", self.static_rating, positive, "allowed is a load above 0 in N"),
            ("radial", self.radial, f64::is_finite, "allowed is a finite number in N"),
            ("axial", self.axial, f64::is_finite, "allowed is a finite number in N"),
            ("speed", self.speed, f64::is_finite, "allowed is a finite number in r/min"),
            ("angle", self.angle, f64::is_finite, "allowed is a finite number in degrees"),
        ] {
            if let Some(value) = value.filter(|value| !sound(*value)) {
                return Err(error::argument(py, name, &value.to_string(), allowed));
            }
        }
        let refused = |failure: CatalogueError| self.refused(py, &failure);
        let ratings = self.dynamic_rating.zip(self.static_rating);
        let given = Given {
            balls: self.balls,
            ball_mm: self.ball,
            ratings: ratings.map(|(dynamic, at_rest)| Ratings { dynamic, at_rest }),
            radial: self.radial,
            axial: self.axial,
            speed_rpm: self.speed,
            lubricant: self.lubricant.clone(),
            fits: Fits { shaft: self.shaft_fit.clone(), housing: self.housing_fit.clone() },
        };
        let word = self.lubricant.as_deref().unwrap_or("None");
        let unknown = |failure: CatalogueError| error::argument(py, "lubricant", word, &failure.to_string());
        let case = self.bearing(py)?.given(given).map_err(unknown)?;
        let name = case.designation.clone().unwrap_or_else(|| "new case".to_owned());
        Ok((name, case.text().map_err(refused)?))
    }

    fn bearing(&self, py: Python<'_>) -> PyResult<NewCase> {
        match (&self.designation, self.bore, self.outside, self.width) {
            (Some(designation), None, None, None) => {
                let listed = find(designation, self.angle).map_err(|failure| self.refused(py, &failure))?;
                Ok(NewCase::of_listed(listed, designation))
            }
            (None, Some(bore), Some(outside), Some(width)) => {
                let [bore, outside, width] = [bore, outside, width].map(|mm| mm * 1e-3);
                let contact_angle = self.angle.unwrap_or(0.0).to_radians();
                Ok(NewCase::new(Envelope { bore, outside, width, contact_angle }))
            }
            (designation, ..) => {
                let allowed = "allowed is a designation alone, or bore, outside and width in mm";
                Err(error::argument(py, "designation", designation.as_deref().unwrap_or("None"), allowed))
            }
        }
    }

    fn refused(&self, py: Python<'_>, failure: &CatalogueError) -> PyErr {
        let value = self.designation.as_deref().unwrap_or("dimensions");
        error::argument(py, "designation", value, &failure.to_string())
    }
}

/// A number with a unit in SI; None for a word that is no unit.
#[pyfunction]
pub fn in_si(unit: &str, number: f64) -> Option<f64> {
    tribodyn_case::in_si(unit, number)
}

/// Names of all units of case files, a list for each kind of quantity.
#[pyfunction]
pub fn unit_names() -> Vec<Vec<&'static str>> {
    tribodyn_case::unit_names().into_iter().map(<[_]>::to_vec).collect()
}
