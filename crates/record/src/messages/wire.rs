//! The messages as they lie in the file, generated from the `.proto` files of this crate.

/// Foxglove's public messages, as far as a recording uses them.
pub mod foxglove {
    #![allow(missing_docs, clippy::all)] // generated: helper functions of enums carry no text
    include!(concat!(env!("OUT_DIR"), "/foxglove.rs"));
}

/// Our own messages.
pub mod tribodyn {
    #![allow(missing_docs, clippy::all)] // generated, as above
    include!(concat!(env!("OUT_DIR"), "/tribodyn.v1.rs"));
}

/// A message whose single numbers can be reached by name.
pub trait Numbers {
    /// Names of the numbers, in the order of their places.
    const NAMES: &'static [&'static str];

    /// The number at a place; NaN beyond the last one.
    fn number(&self, place: usize) -> f64;

    /// Writes the number at a place, in the precision of its field; nothing beyond the last one.
    fn set_number(&mut self, place: usize, value: f64);

    /// Writes the numbers that `value` has for their places, in the precision of their fields.
    fn set_numbers(&mut self, value: impl Fn(usize) -> Option<f64>);

    /// True if no number is infinite or not a number at all.
    fn are_finite(&self) -> bool;

    /// The place of a name.
    fn place(name: &str) -> Option<usize> {
        Self::NAMES.iter().position(|known| *known == name)
    }
}

mod numbers {
    #![allow(clippy::all)] // generated from the `.proto` file
    include!(concat!(env!("OUT_DIR"), "/tribodyn_numbers.rs"));
}

/// Descriptor set of [`foxglove`] with its imports, as the schema record holds it.
pub(crate) const FOXGLOVE_DESCRIPTORS: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/foxglove.binpb"));

/// Descriptor set of [`tribodyn`] with its imports, as the schema record holds it.
pub(crate) const TRIBODYN_DESCRIPTORS: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/tribodyn.binpb"));
