//! The topics of a run.

use crate::output::Channel;
use crate::wire::{FOXGLOVE_DESCRIPTORS, TRIBODYN_DESCRIPTORS};

/// The topics, by their place in [`CHANNELS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Topic {
    Geometry,
    Log,
    Transforms,
    Contacts,
    State,
    Balls,
    Orbit,
    Wear,
    SpectrumOuter,
    SpectrumInner,
    SpectrumCage,
}

const fn public(topic: &'static str, schema: &'static str) -> Channel {
    Channel { topic, schema, descriptors: FOXGLOVE_DESCRIPTORS }
}

const fn own(topic: &'static str, schema: &'static str) -> Channel {
    Channel { topic, schema, descriptors: TRIBODYN_DESCRIPTORS }
}

/// The topics of a recorded run with the types of their messages.
pub(crate) const CHANNELS: [Channel; 11] = [
    public("/bearing/geometry", "foxglove.SceneUpdate"),
    public("/log", "foxglove.Log"),
    public("/tf", "foxglove.FrameTransforms"),
    public("/bearing/contacts", "foxglove.SceneUpdate"),
    own("/bearing/state", "tribodyn.v1.TransientState"),
    own("/bearing/balls", "tribodyn.v1.Balls"),
    own("/bearing/orbit", "tribodyn.v1.Orbit"),
    own("/bearing/wear", "tribodyn.v1.Wear"),
    own("/bearing/spectrum", "tribodyn.v1.Spectrum"),
    own("/bearing/spectrum/inner", "tribodyn.v1.Spectrum"),
    own("/bearing/spectrum/cage", "tribodyn.v1.Spectrum"),
];
