//! The topics of a run.

use crate::output::Channel;

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
    Azimuth,
    Coating,
}

/// The topics of a recorded run with the types of their messages.
pub(crate) const CHANNELS: [Channel; 13] = [
    Channel::foxglove("/bearing/geometry", "foxglove.SceneUpdate"),
    Channel::foxglove("/log", "foxglove.Log"),
    Channel::foxglove("/tf", "foxglove.FrameTransforms"),
    Channel::foxglove("/bearing/contacts", "foxglove.SceneUpdate"),
    Channel::own("/bearing/state", "tribodyn.v1.TransientState"),
    Channel::own("/bearing/balls", "tribodyn.v1.Balls"),
    Channel::own("/bearing/orbit", "tribodyn.v1.Orbit"),
    Channel::own("/bearing/wear", "tribodyn.v1.Wear"),
    Channel::own("/bearing/spectrum", "tribodyn.v1.Spectrum"),
    Channel::own("/bearing/spectrum/inner", "tribodyn.v1.Spectrum"),
    Channel::own("/bearing/spectrum/cage", "tribodyn.v1.Spectrum"),
    Channel::own("/bearing/azimuth", "tribodyn.v1.AroundBearing"),
    Channel::foxglove("/bearing/coating", "foxglove.SceneUpdate"),
];
