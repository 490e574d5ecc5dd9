//! Solid lubricants as data: tested points of the traction curve.

use crate::{Kragelskii, Peak, TractionError};

/// A traction curve measured at one contact pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TestedCurve {
    /// Peak contact pressure of the test, Pa.
    pub pressure: f64,
    /// Peak slip, peak and residual coefficient.
    pub peak: Peak,
}

/// A solid lubricant.
#[derive(Debug, Clone, PartialEq)]
pub struct Coating {
    /// Its name in case files.
    pub name: String,
    /// Where the data come from.
    pub source: String,
    /// Tested curves, by rising pressure.
    pub tested: Vec<TestedCurve>,
    /// Pressures between which the fit may be used, Pa; outside, the pressure is clamped.
    pub valid_pressure: [f64; 2],
}

/// Pressures of the tests, Pa: Lubricants 2025, 13(8), 352, Table 1.
const TEST_PRESSURES: [f64; 3] = [2.5e9, 3.0e9, 3.5e9];
/// The range to which section 5.1.1 of the same paper limits the fits, Pa.
const PAPER_RANGE: [f64; 2] = [1.5e9, 4.0e9];

/// A, B, C of the same paper's Table 2 (D = −A), at the three test pressures.
type TableTwo = [(f64, f64, f64); 3];
/// Table 2, Ag coating.
const AG: TableTwo = [(-0.124, 0.079, 0.698), (-0.116, 0.066, 0.648), (-0.102, 0.062, 0.513)];
/// Table 2, PTFE coating.
const PTFE: TableTwo = [(-0.109, 0.103, 0.724), (-0.105, 0.096, 0.683), (-0.100, 0.086, 0.666)];
const LIBRARY: [(&str, TableTwo); 2] = [("ag", AG), ("ptfe", PTFE)];

/// The names that [`Coating::library`] knows.
pub fn coating_names() -> Vec<&'static str> {
    LIBRARY.iter().map(|(name, _)| *name).collect()
}

impl Coating {
    /// A coating of the built-in library, tested in liquid nitrogen.
    ///
    /// # Errors
    /// [`TractionError::UnknownCoating`] for a name that is not in [`coating_names`].
    pub fn library(name: &str) -> Result<Self, TractionError> {
        let (_, table) = LIBRARY
            .iter()
            .find(|(known, _)| *known == name)
            .ok_or_else(|| TractionError::UnknownCoating { name: name.into(), known: coating_names().join(", ") })?;
        let tested = TEST_PRESSURES
            .iter()
            .zip(table)
            .map(|(&pressure, &(a, b, c))| TestedCurve { pressure, peak: Kragelskii { a, b, c }.peak() })
            .collect();
        Ok(Self {
            name: name.into(),
            source: "Lubricants 2025, 13(8), 352, Table 2".into(),
            tested,
            valid_pressure: PAPER_RANGE,
        })
    }

    /// A coating from a user's own tests; its fit is used within the tested pressures and clamped outside.
    ///
    /// # Errors
    /// [`TractionError::NoTests`] without points.
    pub fn from_tests(name: &str, tested: Vec<TestedCurve>) -> Result<Self, TractionError> {
        let (Some(first), Some(last)) = (tested.first(), tested.last()) else {
            return Err(TractionError::NoTests);
        };
        let valid_pressure = [first.pressure, last.pressure];
        Ok(Self { name: name.into(), source: "case file".into(), tested, valid_pressure })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paper_table_2_gives_the_peak_data_of_the_model_page() {
        let rows = [
            ("ag", [(3.0023, 0.13792, 0.124), (3.3008, 0.12800, 0.116), (3.5945, 0.12112, 0.102)]),
            ("ptfe", [(2.4395, 0.13333, 0.109), (2.5579, 0.12950, 0.105), (2.6643, 0.12190, 0.100)]),
        ];
        for (name, expected) in rows {
            for (test, (slip, top, residual)) in Coating::library(name).unwrap().tested.iter().zip(expected) {
                assert!((test.peak.slip - slip).abs() < 6e-5);
                assert!((test.peak.coefficient - top).abs() < 6e-6);
                assert_eq!(test.peak.residual, residual);
            }
        }
    }

    #[test]
    fn limit_unknown_name_lists_the_known_ones() {
        let error = Coating::library("gold").unwrap_err().to_string();
        assert!(error.contains("gold") && error.contains("ag") && error.contains("ptfe"));
    }
}
