//! Traction laws and wear of the contacts of a bearing.

use crate::races::Races;
use tribodyn_traction::{Law, PatchLaw, PressureChoice, SlipUnit};
use tribodyn_wear::Archard;

/// Traction and wear of the contacts. A bearing without it is enough for Jones–Harris, whose contacts carry normal
/// loads only.
#[derive(Debug, Clone)]
pub struct Tribology {
    /// Traction law of the coating on each race.
    pub laws: Races<Law>,
    /// Traction law of the bare steel under the coatings, where one is known.
    pub bare_law: Option<Law>,
    /// Film of transferred lubricant between balls and races; absent where nothing is transferred.
    pub transferred: Option<TransferredFilm>,
    /// True if the deformed contact is curved across the groove, so that it has differential (Heathcote) slip. Read
    /// when the bearing is made.
    pub differential_slip: bool,
    /// Unit of the slip axis.
    pub slip_unit: SlipUnit,
    /// Pressure at which the curve is taken.
    pub pressure_choice: PressureChoice,
    /// Wear of the races.
    pub wear: Races<Archard>,
    /// Wear of the cage.
    pub wear_cage: Archard,
}

/// Solid lubricant that the balls have scraped off the cage: where it covers a contact it slides in the place of
/// coating and steel.
#[derive(Debug, Clone)]
pub struct TransferredFilm {
    /// Traction law of the film.
    pub law: Law,
    /// Part of every contact that it covers, 0 to 1.
    pub share: f64,
}

impl Tribology {
    /// One coating on both races, sheared at the peak pressure of each contact and with differential slip, and one wear
    /// constant for races and cage.
    pub fn of_one(law: Law, slip_unit: SlipUnit, wear: Archard) -> Self {
        Self {
            laws: Races { inner: law.clone(), outer: law },
            bare_law: None,
            transferred: None,
            differential_slip: true,
            slip_unit,
            pressure_choice: PressureChoice::Peak,
            wear: Races { inner: wear, outer: wear },
            wear_cage: wear,
        }
    }

    /// A traction law with the choices of the bearing.
    pub fn patch_law<'a>(&self, law: &'a Law) -> PatchLaw<'a, Law> {
        PatchLaw { law, slip_unit: self.slip_unit, pressure: self.pressure_choice }
    }
}
