//! Fits of a new case: the section `mounting`, of seats by tolerance class.

use super::{NewCase, Sources, millimetres};
use crate::CatalogueError;

/// Classes of the seats on shaft and in housing (ISO 286), where known.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Fits {
    /// Of the shaft, such as `k5`.
    pub shaft: Option<String>,
    /// Of the housing, such as `H7`.
    pub housing: Option<String>,
}

impl Fits {
    /// Refuses what is no class by its letters; the reader of cases knows the classes themselves.
    ///
    /// # Errors
    /// [`CatalogueError::Fit`].
    pub(super) fn check(&self) -> Result<(), CatalogueError> {
        let plain = |word: &&String| !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric());
        match self.shaft.iter().chain(&self.housing).find(|word| !plain(word)) {
            Some(word) => Err(CatalogueError::Fit { word: word.clone() }),
            None => Ok(()),
        }
    }
}

/// Roughness R_z of a ground shaft and of a turned housing, each with its ring, µm.
const ROUGHNESS: [u32; 2] = [4, 8];
/// Outside diameter of the housing over that of the bearing.
const HOUSING: f64 = 1.5;
/// Thermal expansion of bearing steel.
const EXPANSION: &str = "per_K(12.5e-6)";

impl NewCase {
    /// Tolerance class of the bearing: that of the designation, or the normal one.
    fn ring_class(&self) -> &'static str {
        let named = |text: &str| match text {
            "ABEC3" => Some("P6"),
            "ABEC5" => Some("P5"),
            "ABEC7" => Some("P4"),
            "ABEC9" => Some("P2"),
            _ => ["P6", "P5", "P4", "P2"].into_iter().find(|class| text.starts_with(class)),
        };
        self.parts.iter().find_map(|part| named(&part.text)).unwrap_or("Normal")
    }

    /// The section `mounting`; empty where no class is known.
    pub(super) fn mounting(&self, sources: &mut Sources) -> String {
        if self.fits == Fits::default() {
            return String::new();
        }
        let steel = "material: (young: GPa(208), poisson: 0.3, density: kg_per_m3(7800))";
        let seat = |class: Option<&String>, roughness: u32, far: String| {
            class.map_or_else(String::new, |class| {
                format!(
                    "            seat: (
                fit: (class: \"{class}\", ring: {}, within: Mean, roughness: um({roughness})),
                far_diameter: mm({far}),
                {steel},
                expansion: {EXPANSION},
                temperature_rise: K(0),
            ),
",
                    self.ring_class()
                )
            })
        };
        let ring = |name: &str, diameter: f64, seat: String| {
            format!(
                "        {name}: (
            seat_diameter: mm({}),
            expansion: {EXPANSION},
            temperature_rise: K(0),
{seat}        ),
",
                millimetres(diameter)
            )
        };
        let [ground, turned] = ROUGHNESS;
        let on_shaft = seat(self.fits.shaft.as_ref(), ground, "0".to_owned());
        let in_housing = seat(self.fits.housing.as_ref(), turned, millimetres(HOUSING * self.envelope.outside));
        self.mounting_sources(sources);
        format!(
            "    // Fits by the classes of ISO 286 and ISO 492; `tribodyn check` has the clearance over their range.
    mounting: (
{}{}        ball: (expansion: {EXPANSION}, temperature_rise: K(0)),
    ),

",
            ring("inner", self.envelope.bore, on_shaft),
            ring("outer", self.envelope.outside, in_housing),
        )
    }

    fn mounting_sources(&self, sources: &mut Sources) {
        let given = [("inner", self.fits.shaft.is_some()), ("outer", self.fits.housing.is_some())];
        for (ring, given) in given {
            if given {
                sources.reference(&format!("mounting.{ring}.seat.fit.class"), "as given");
                let path = format!("mounting.{ring}.seat.fit.within");
                sources.assumed(&path, "the middle of both tolerances; LikelyTightest and LikelyLoosest bound 99.7 %");
                let path = format!("mounting.{ring}.seat.fit.roughness");
                sources.assumed(&path, "R_z of seat and ring: 4 um where the seat is ground, 8 um where it is turned");
                let far = if ring == "inner" { "a solid shaft" } else { "a housing 1.5 times as large as the bearing" };
                sources.assumed(&format!("mounting.{ring}.seat.far_diameter"), far);
            }
        }
        sources.assumed("mounting", "steel throughout, all at one temperature: put in the rises over it");
    }
}
