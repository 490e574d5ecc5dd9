//! Why data make no lubricant.

/// Faults in the data of a lubricant.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LubricantError {
    /// A quantity that must be above 0.
    #[error("{quantity} is {value} {unit}: allowed are finite values above 0")]
    NotPositive {
        /// Its name.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A quantity outside the range that oils have.
    #[error("{quantity} is {} {unit}: oils have {low} to {high} {unit}", rounded(*.value))]
    Range {
        /// Its name.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// Least value.
        low: f64,
        /// Largest value.
        high: f64,
    },
    /// A quantity outside the range in which the life of grease is known.
    #[error("{quantity} is {value:.3} {unit}: the life of grease is known from {low} to {high:.3} {unit}")]
    Grease {
        /// Its name.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// Least value.
        low: f64,
        /// Largest value.
        high: f64,
    },
    /// Viscosity that does not fall with temperature.
    #[error(
        "viscosity {} mm²/s at {} °C and {} mm²/s at {} °C: the viscosity of an oil falls with temperature",
        rounded(*.cold),
        rounded(*.cold_c),
        rounded(*.hot),
        rounded(*.hot_c)
    )]
    Rising {
        /// At the lower temperature, mm²/s.
        cold: f64,
        /// The lower temperature, °C.
        cold_c: f64,
        /// At the higher temperature, mm²/s.
        hot: f64,
        /// The higher temperature, °C.
        hot_c: f64,
    },
    /// A viscosity grade that ISO 3448 does not have.
    #[error("viscosity grade VG {grade}: ISO 3448 has {known}")]
    Grade {
        /// The grade.
        grade: f64,
        /// The grades that exist.
        known: String,
    },
    /// An oil that the library does not have.
    #[error("no oil \"{name}\" in the library; allowed are {known}")]
    Unknown {
        /// The name.
        name: String,
        /// How names are made.
        known: String,
    },
    /// An elliptical contact across which the film formulas do not hold.
    #[error(
        "ellipticity {ellipticity}: the film formulas hold where the contact is at least as long across rolling as along it, 1 or more"
    )]
    Ellipticity {
        /// a/b, across rolling over along it.
        ellipticity: f64,
    },
}

/// A number with six digits and no more than it needs.
fn rounded(value: f64) -> String {
    let text = format!("{value:.5e}");
    text.parse::<f64>().map_or(text, |rounded| rounded.to_string())
}
