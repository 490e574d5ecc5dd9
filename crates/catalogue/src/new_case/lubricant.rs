//! The lubricant of a new case: oil or grease by the class of the bearing, or a solid one.

use super::Sources;
use crate::CatalogueError;

/// Lubricant of a new case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NewLubricant {
    /// An oil of the library, such as `mineral-vg68`, in a bath.
    Oil(String),
    /// Grease: base oil, and a film as starved as in bearings that have run in.
    Grease,
    /// A solid lubricant of the library, `ag` or `ptfe`: a dry or a cryogenic bearing.
    Coating(&'static str),
}

/// Base oil of a usual grease NLGI 2.
const GREASE_OIL: &str = "mineral-vg100";
/// Oil of an open bearing.
const OPEN_OIL: &str = "mineral-vg68";

impl NewLubricant {
    /// By a word: `ag`, `ptfe`, `grease`, a grade such as `vg68` (mineral oil), or an oil of the library such as
    /// `pao-vg32`.
    ///
    /// # Errors
    /// [`CatalogueError::Lubricant`] for any other word. Whether the library has an oil of this name, the case says
    /// that is made of it.
    pub fn parse(word: &str) -> Result<Self, CatalogueError> {
        let plain = word.to_ascii_lowercase();
        match plain.as_str() {
            "ag" => Ok(Self::Coating("ag")),
            "ptfe" => Ok(Self::Coating("ptfe")),
            "grease" => Ok(Self::Grease),
            grade if grade.starts_with("vg") => Ok(Self::Oil(format!("mineral-{grade}"))),
            oil if oil.contains("-vg") => Ok(Self::Oil(plain)),
            _ => Err(CatalogueError::Lubricant { word: word.to_owned() }),
        }
    }

    /// The usual lubricant: grease where seals or shields close the bearing, else oil.
    pub fn usual(closed: bool) -> Self {
        if closed { Self::Grease } else { Self::Oil(OPEN_OIL.to_owned()) }
    }

    /// True for oil and grease.
    pub(super) fn is_wet(&self) -> bool {
        !matches!(self, Self::Coating(_))
    }

    /// The class of cleanliness in the rating section; none for a dry bearing.
    pub(super) fn cleanliness(&self) -> Option<(&'static str, &'static str)> {
        match self {
            Self::Grease => Some(("High", "sealed and greased for life: e_C 0.6 to 0.8, ISO 281 table 13")),
            Self::Oil(_) => Some(("Slight", "an open bearing in oil that is not filtered finely: e_C 0.3 to 0.5")),
            Self::Coating(_) => None,
        }
    }

    /// The section of the case, with wear; its sources are added.
    pub(super) fn section(&self, sources: &mut Sources) -> String {
        let (oil, supply) = match self {
            Self::Coating(name) => return super::sections::coating(name, sources),
            Self::Oil(name) => (name.as_str(), "Bath"),
            Self::Grease => (GREASE_OIL, "Grease"),
        };
        let why = match self {
            Self::Grease => "base oil of a lithium grease NLGI 2; usual VG 68 to 220. Its film is 0.7 of a flooded one",
            _ => "a mineral oil of the library for moderate speeds; viscosity index 95, usual VG 32 to 150",
        };
        sources.assumed("lubricant.oil", why);
        sources.assumed("lubricant.supply", "grease in a closed bearing, an oil bath in an open one");
        sources.assumed("lubricant.temperature", "a bearing at moderate load and speed; usual 40 to 100 degC");
        sources.assumed(
            "lubricant.roughness",
            "ground and honed races, balls of grade 10; usual R_q 0.03 to 0.15 and 0.01 to 0.03 um",
        );
        sources.assumed("lubricant.shear", "friction of disc machines, 0.03 to 0.08; Eyring stresses are 3 to 10 MPa");
        sources.assumed("lubricant.boundary_friction", "steel on steel with additives; usual 0.08 to 0.15");
        sources.assumed(
            "lubricant.patch",
            "torque within 0.2 % and cage speed within 1e-5 of those at 1e-5; 1e-3 for a look",
        );
        sources.assumed(
            "wear",
            "order of magnitude of steel in oil where asperities touch, 1e-9 to 1e-7; 7 GPa, cage 60 to 200 MPa",
        );
        format!(
            "    // Oil or grease in the contacts. Dry: leave this out and give `coatings` and `traction`, as
    // `tribodyn new --lubricant ag` does.
    lubricant: (
        oil: Library(\"{oil}\"),
        temperature: degC(70),
        supply: {supply},
        roughness: (ball: um(0.02), inner: um(0.06), outer: um(0.06)),
        shear: LimitingShear,
        boundary_friction: 0.12,
        patch: TargetError(relative: 1e-4),
    ),

    // No `fluid`: the drag of the oil on balls and cage is left out.

    wear: (
        inner: (coefficient: 1e-8, hardness: GPa(7)),
        outer: (coefficient: 1e-8, hardness: GPa(7)),
        cage: (coefficient: 1e-7, hardness: MPa(100)),
    ),

"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::NewLubricant;
    use crate::{NewCase, find};

    #[test]
    fn limit_words_and_classes() {
        let parse = |word: &str| NewLubricant::parse(word).unwrap();
        assert_eq!(parse("AG"), NewLubricant::Coating("ag"));
        assert_eq!(parse("vg32"), NewLubricant::Oil("mineral-vg32".into()));
        assert_eq!(parse("pao-vg46"), NewLubricant::Oil("pao-vg46".into()));
        assert!(NewLubricant::parse("butter").unwrap_err().to_string().contains("ag, ptfe, grease, vg68"));
        for (designation, lubricant) in [
            ("6206-2RS", NewLubricant::Grease),
            ("6206 2Z", NewLubricant::Grease),
            ("6206ZZ", NewLubricant::Grease),
            ("6206LLU", NewLubricant::Grease),
            ("6206", NewLubricant::usual(false)),
            ("6206 C3", NewLubricant::usual(false)),
            ("7210B", NewLubricant::Oil("mineral-vg68".into())),
        ] {
            let case = NewCase::of_listed(find(designation, None).unwrap(), designation);
            assert_eq!(case.usual_lubricant(), lubricant, "{designation}");
            assert_eq!(case.lubricant(), lubricant, "{designation}");
        }
    }
}
