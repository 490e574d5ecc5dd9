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
    /// Source of the data.
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
const PAPER: &str = "Lubricants 2025, 13(8), 352, Table 2";

/// Bare steel on steel without lubricant, the same at every pressure (Amontons): an order of magnitude, no test.
///
/// No curve of dry AISI 440C or 52100 in liquid nitrogen against slip could be found. The residual coefficient is the
/// handbook's for hard steel sliding dry on hard steel, 0.42 (Marks' Standard Handbook for Mechanical Engineers,
/// section 3.2; its static value is 0.78, and other collections give 0.1 to 0.6 for dry sliding steel). That it may
/// stand for low temperatures rests on Burton, Taborek, Rutledge, Tribol. Lett. 23 (2006) 131, who saw no systematic
/// change for bearing steel on stainless steel between 4 and 200 K. Chaudhuri, Slifka, Siegwarth, Wear 160 (1993) 43,
/// doi:10.1016/0043-1648(93)90404-A, slid 440C on itself in oxygen from 88 K up, the nearest test known; its
/// coefficients could not be had. The shape is assumed: slip at the peak and peak over residual are those of silver at
/// 3 GPa.
const BARE: Peak = Peak { slip: 3.3, coefficient: 0.46, residual: 0.42 };
const BARE_SOURCE: &str = "Assumed: dry hard steel, 0.42 (Marks' Handbook, 3.2), with the shape of the curve of silver";

/// An entry of the library.
enum Data {
    /// A coating of the paper.
    Paper(TableTwo),
    /// The same curve at every pressure.
    Constant(Peak, &'static str),
}

const LIBRARY: [(&str, Data); 3] =
    [("ag", Data::Paper(AG)), ("ptfe", Data::Paper(PTFE)), ("bare-440c", Data::Constant(BARE, BARE_SOURCE))];

/// The names that [`Coating::library`] knows.
pub fn coating_names() -> Vec<&'static str> {
    LIBRARY.iter().map(|(name, _)| *name).collect()
}

impl Coating {
    /// A coating of the built-in library: `ag` and `ptfe` as tested in liquid nitrogen, and `bare-440c`, steel without
    /// a coating, whose coefficients are an order of magnitude from a handbook (0.42) on an assumed shape, the same at
    /// all pressures.
    ///
    /// # Errors
    /// [`TractionError::UnknownCoating`] for a name that is not in [`coating_names`].
    pub fn library(name: &str) -> Result<Self, TractionError> {
        let (_, data) = LIBRARY
            .iter()
            .find(|(known, _)| *known == name)
            .ok_or_else(|| TractionError::UnknownCoating { name: name.into(), known: coating_names().join(", ") })?;
        let (peaks, source) = match data {
            Data::Paper(table) => (table.map(|(a, b, c)| Kragelskii { a, b, c }.peak()), PAPER),
            Data::Constant(peak, source) => ([*peak; 3], *source),
        };
        let tested = TEST_PRESSURES.iter().zip(peaks).map(|(&pressure, peak)| TestedCurve { pressure, peak }).collect();
        Ok(Self { name: name.into(), source: source.into(), tested, valid_pressure: PAPER_RANGE })
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
    use crate::{CoatingLaw, SlipCurve, TractionLaw};

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
    fn identity_bare_steel_is_the_same_at_all_pressures_and_above_both_coatings() {
        let bare = Coating::library("bare-440c").unwrap();
        assert!(bare.source.starts_with("Assumed"));
        let law = CoatingLaw::varying(&bare, 2).unwrap();
        for pressure in [1.0e9, 1.7e9, 2.5e9, 3.9e9] {
            let peak: Peak = law.at(pressure).peak();
            assert!((peak.coefficient - 0.46).abs() < 1e-12 && (peak.residual - 0.42).abs() < 1e-12);
        }
        for name in ["ag", "ptfe"] {
            let coating = CoatingLaw::varying(&Coating::library(name).unwrap(), 2).unwrap();
            for slip in [0.01, 0.3, 3.0, 30.0, 3000.0] {
                assert!(law.at(2.2e9).coefficient(slip) > 2.0 * coating.at(2.2e9).coefficient(slip), "{name} {slip}");
            }
        }
    }

    #[test]
    fn limit_unknown_name_lists_the_known_ones() {
        let error = Coating::library("gold").unwrap_err().to_string();
        assert!(error.contains("gold") && error.contains("ag") && error.contains("ptfe"));
    }
}
