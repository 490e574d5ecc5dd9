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

/// Descriptor set of [`foxglove`] with its imports, as the schema record holds it.
pub(crate) const FOXGLOVE_DESCRIPTORS: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/foxglove.binpb"));

/// Descriptor set of [`tribodyn`] with its imports, as the schema record holds it.
pub(crate) const TRIBODYN_DESCRIPTORS: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/tribodyn.binpb"));
