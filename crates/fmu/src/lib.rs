#![doc = include_str!("../README.md")]

mod binary;
mod description;
mod header;
mod table;
mod zip;

pub use binary::{Binary, Platform};

use tribodyn_bearing::{Bearing, Equations, Races, RingState};
use zip::Zip;

/// Why a bearing makes no FMU.
#[derive(Debug, thiserror::Error)]
pub enum FmuError {
    /// A modelling choice that raceway control uses and that is not made.
    #[error("`{path}` is not given, and raceway control needs it: allowed is {readings}")]
    OpenChoice {
        /// Its path in a case.
        path: &'static str,
        /// Its readings.
        readings: &'static str,
    },
    /// Waves, or balls of unequal size.
    #[error("an FMU has round races and equal balls: leave out `deviations`")]
    Deviations,
    /// A number that is none.
    #[error("`{name}` is {value}")]
    NotFinite {
        /// Variable of the FMU.
        name: &'static str,
        /// Its value.
        value: f64,
    },
}

/// A file of the FMU's sources: its name and its text.
pub type Source = (&'static str, String);

/// The sources that are the same for all bearings. Those that end in `.c` are compiled, each by itself.
const SOURCES: [(&str, &str); 10] = [
    ("ball.c", include_str!("../sources/ball.c")),
    ("ball.h", include_str!("../sources/ball.h")),
    ("bearing.c", include_str!("../sources/bearing.c")),
    ("bearing.h", include_str!("../sources/bearing.h")),
    ("dual.h", include_str!("../sources/dual.h")),
    ("fmi2.c", include_str!("../sources/fmi2.c")),
    ("fmi2.h", include_str!("../sources/fmi2.h")),
    ("fmi2_kinds.c", include_str!("../sources/fmi2_kinds.c")),
    ("hertz.c", include_str!("../sources/hertz.c")),
    ("hertz.h", include_str!("../sources/hertz.h")),
];
/// The one that holds the numbers of a bearing.
const MODEL_HEADER: &str = "model.h";

/// A bearing as an FMU that is not packed yet.
#[derive(Debug, Clone)]
pub struct Fmu {
    name: String,
    identifier: String,
    guid: String,
    starts: Vec<f64>,
}

impl Fmu {
    /// The FMU of a bearing that starts with its rings in a given state: displacement, tilt and speed of the inner
    /// ring, speed of the outer one. The model's name is for people; the identifier follows from it.
    ///
    /// # Errors
    /// [`FmuError`] for a bearing that raceway control cannot take, or that is not round.
    pub fn new(name: &str, bearing: &Bearing, rings: Races<&RingState>) -> Result<Self, FmuError> {
        if let Some(open) = bearing.modelling.open(Equations::JonesHarris).first() {
            return Err(FmuError::OpenChoice { path: open.path, readings: open.readings });
        }
        if !bearing.deviations.are_none() {
            return Err(FmuError::Deviations);
        }
        let starts: Vec<f64> = table::VARIABLES.iter().map(|v| (v.start)(bearing, rings)).collect();
        let finite = |(variable, value): (&table::Variable, &f64)| {
            if value.is_finite() { Ok(()) } else { Err(FmuError::NotFinite { name: variable.name, value: *value }) }
        };
        table::VARIABLES.iter().zip(&starts).try_for_each(finite)?;
        let guid = guid(name, &starts);
        Ok(Self { name: name.to_owned(), identifier: identifier(name), guid, starts })
    }

    /// The name of the compiled library without its ending, and the prefix of its functions where several FMUs are
    /// linked into one program.
    pub fn identifier(&self) -> &str {
        &self.identifier
    }

    /// All sources, C99: those that end in `.c` make the library, linked with the C library's mathematics.
    pub fn sources(&self) -> Vec<Source> {
        let fixed = SOURCES.into_iter().map(|(name, text)| (name, text.to_owned()));
        fixed.chain([(MODEL_HEADER, header::text(self))]).collect()
    }

    /// `modelDescription.xml`.
    pub fn description(&self) -> String {
        description::text(self)
    }

    /// The bytes of the FMU, with what was compiled of its sources. They start with the description, not compressed.
    pub fn archive(&self, binary: Option<&Binary>) -> Vec<u8> {
        let mut zip = Zip::default();
        zip.put("modelDescription.xml", self.description().as_bytes());
        for (name, text) in self.sources() {
            zip.put(&format!("sources/{name}"), text.as_bytes());
        }
        if let Some(Binary { platform, bytes }) = binary {
            let path = format!("binaries/{}/{}.{}", platform.name(), self.identifier, platform.ending());
            zip.put(&path, bytes);
        }
        zip.finish()
    }
}

/// A name as C has them: letters, digits and underscores, no digit first.
fn identifier(name: &str) -> String {
    let legal = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let made: String = name.chars().map(legal).take(64).collect();
    if made.starts_with(|c: char| c.is_ascii_alphabetic()) { made } else { format!("bearing_{made}") }
}

/// The mark that a library and a description share that belong together.
fn guid(name: &str, starts: &[f64]) -> String {
    let mut sum = crc32fast::Hasher::new();
    sum.update(name.as_bytes());
    SOURCES.iter().for_each(|(_, text)| sum.update(text.as_bytes()));
    starts.iter().for_each(|start| sum.update(&start.to_bits().to_le_bytes()));
    format!("tribodyn-{}-{:08x}", env!("CARGO_PKG_VERSION"), sum.finalize())
}

#[cfg(test)]
mod tests {
    use super::identifier;

    #[test]
    fn limit_identifiers_are_those_of_c() {
        for (name, expected) in
            [("paper-ag", "paper_ag"), ("6206", "bearing_6206"), ("", "bearing_"), ("ä b", "bearing___b")]
        {
            assert_eq!(identifier(name), expected);
        }
    }
}
