//! Recordings of bearing solutions and transient runs: MCAP files that open in Foxglove with a moving 3-D bearing,
//! plots and a log, and that can be read back, also where they were cut off or damaged.
//!
//! # What a recording of a quasi-static solution shows
//! One orbit of the cage in simulated time. Ball j starts at its solved azimuth φ_j and orbits at the cage speed ω_c;
//! what it is at azimuth φ is interpolated over the solved balls:
//! ```text
//! φ_j(t) = φ_j(0) + ω_c t,   0 ≤ t ≤ 2π/|ω_c|,   t in equal steps of whole nanoseconds
//! f(φ) = Σ_k D(φ − φ_k) f_k          periodic trigonometric interpolant, linear where a ball has lost contact
//! ball centre: r_c(φ) e_r(φ) + z(φ) e_a,   e_r = (cos φ, sin φ, 0),   e_a = +Z,   e_t = e_a × e_r
//! ball orientation in (e_a, e_r, e_t): dq/dt = ½ ω(φ) q,   inner ring: ω_i t about its own axis
//! force of a race on the ball: −Q n,   n_o = (sin α_o, cos α_o, 0),   n_i = −(sin α_i, cos α_i, 0)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | X, Y, Z | inertial axes: radial, radial, axial; origin in the plane of the unloaded ball centres | m |
//! | φ | azimuth, from X towards Y | rad |
//! | e_a, e_r, e_t | axial, radial and orbital direction of a ball | – |
//! | ω_c, ω_i | speed of cage and inner ring | rad/s |
//! | ω | spin of a ball relative to its azimuth frame | rad/s |
//! | r_c, z | orbit radius, axial position of a ball centre | m |
//! | α, n, Q | contact angle, outward normal from the ball centre, contact load | rad, –, N |
//!
//! # What a recording of a transient run shows
//! The samples and events of a [`tribodyn_dynamics::Observer`], as they come; nothing is interpolated. Drawn from them:
//! ```text
//! ball centre: r_c e_r(φ) + z e_a;   ball orientation: dq/dt = ½ ω q, by the mean of ω over each step
//! F_c = m r_c ω_m²,   M_g = J ω_m √(ω_r² + ω_t²),   m = ρ π D³/6,   J = m D²/10
//! spectrum: single-sided peak amplitudes of the last 2^k ≤ 4096 samples, Hann window (crate `tribodyn-signal`)
//! ```
//! [`RunRecorder`] makes the messages and hands them to a [`Sink`]: a file ([`FileSink`]), any stream ([`StreamSink`]),
//! with the feature `live` a server for viewers that watch the run as it goes (`LiveServer`), or two sinks at once.
//! [`RunReader`] and [`read_run`] give the numbers back in the recorded units, [`recover()`] makes a whole file from a
//! torn or damaged one.
//!
//! | topic of a run | message | when |
//! |---|---|---|
//! | `/bearing/state` | `tribodyn.v1.TransientState`, f64 | every sample |
//! | `/bearing/balls` | `tribodyn.v1.Balls`, f32 | samples with balls |
//! | `/tf` | `foxglove.FrameTransforms` | samples with balls, at most 70 times a turn |
//! | `/bearing/contacts` | `foxglove.SceneUpdate` | samples with balls, at most 20 times a turn |
//! | `/bearing/azimuth` | `tribodyn.v1.AroundBearing` | with `/bearing/contacts` |
//! | `/bearing/geometry` | `foxglove.SceneUpdate` | once |
//! | `/bearing/coating` | `foxglove.SceneUpdate` | each 0.1 s, and at the end |
//! | `/bearing/orbit`, `/bearing/wear` | `tribodyn.v1.Orbit`, `tribodyn.v1.Wear` | each 0.1 s, and at the end |
//! | `/bearing/spectrum`, `…/inner`, `…/cage` | `tribodyn.v1.Spectrum` | the same, from 256 even samples on |
//! | `/log` | `foxglove.Log` | warnings; of impacts, contacts lost and made one line each in a millisecond |
//!
//! A killed program loses no more than the messages of the last 0.05 s of simulated time: chunks are closed then or
//! when they hold 1 MiB, and of the open one whole compressed blocks (128 KiB of messages) can be read back too. A
//! machine that loses power may lose what its system had not yet put on the disk: the file is synchronised at its end.
//!
//! # The file of a solution
//!
//! | topic | message | when |
//! |---|---|---|
//! | `/bearing/state` | `tribodyn.v1.BearingState`, f64 | at least 360 times an orbit |
//! | `/bearing/balls` | `tribodyn.v1.Balls`, f32 | with the state |
//! | `/tf` | `foxglove.FrameTransforms` | about 70 times a turn of the faster ring |
//! | `/bearing/contacts` | `foxglove.SceneUpdate` | with `/tf` |
//! | `/bearing/azimuth` | `tribodyn.v1.AroundBearing` | with `/tf` |
//! | `/bearing/geometry` | `foxglove.SceneUpdate` | once |
//! | `/log` | `foxglove.Log` | one message for each warning of the solution |
//!
//! # Both files
//! Metadata record `simulation`; attachments: the case file and the Foxglove layout ([`Layout`], to be imported).
//! The same input gives the same bytes: fixed epoch, one compression thread, no clock. The file is written as
//! `<path>.active` and renamed when whole.
//!
//! # Encoding
//! Protobuf from two `.proto` files kept by hand, compiled by `protox` and `prost-build` in the build script, written
//! with the `mcap` crate. The Foxglove SDK would bring its own messages ready-made, but it takes 25 s of clean build on
//! two cores by itself, against 15 s for all of this (68 crates in the program against 40); its channels report no
//! write error until they are flushed; it needs our own `.proto` and compiler anyway; and its live server is no part
//! of a file writer. A test holds our `foxglove.proto` against the SDK's field names, numbers and types.
//!
//! Sources: MCAP specification 0 (mcap.dev/spec); Foxglove message definitions as of SDK 0.30.3 (docs.foxglove.dev);
//! interpolation: Trefethen 2000, doi:10.1137/1.9780898719598.
//!
//! # Limits
//! The azimuths must be equispaced. The ring stays where the solution has it: its small motion as balls pass is not in
//! a quasi-static solution of one cage position. Balls are drawn at the middle of their pockets; the lead over the
//! pocket is a number in `/bearing/balls`. Faces and outside diameters of the rings, shoulders and cage proportions
//! are no part of a case and are drawn in the proportions of a 7224 bearing; balls, grooves, contact angles, pockets
//! and displacements are true to scale, contact ellipses are enlarged by the factor in the metadata.
//!
//! Rings of a run do not tilt. Scales of arrows and colours of a run are round numbers above what
//! its first sample has; longer arrows end at twice the scale. The coating is drawn as balls found it, not as it is. Spectra, paths and
//! lines of the log that were thinned out are for the eye: reports compute theirs from the states, whose count of
//! impacts is complete.
//!
//! The crate deliberately knows no equation of equilibrium and no unit of a case file: it draws and stores what the
//! solver says.

mod ball;
mod check;
mod colour;
mod contacts;
mod error;
mod frames;
mod guide;
mod layout;
#[cfg(feature = "live")]
mod live;
mod mesh;
mod messages;
mod output;
mod quaternion;
mod raceway;
mod read;
mod recover;
mod replay;
mod run;
mod scan;
mod scene;
#[cfg(test)]
mod tests;
mod timeline;
mod units;
pub mod wire;
mod write;

pub use error::RecordError;
pub use layout::{Layout, LayoutKind};
#[cfg(feature = "live")]
pub use live::{LIVE_ADDRESS, LiveServer, LiveSummary, LiveWarning};
pub use output::Channel;
pub use read::{AttachmentSummary, RecordingSummary, TopicSummary, read_summary};
pub use recover::{RECOVERY_METADATA, Recovered, recover, recover_stream};
pub use replay::{
    BallRow, LogRow, OrbitRow, Run, RunItem, RunReader, SolutionRow, SpectrumRow, StateRow, WearRow, read_recording,
    read_run,
};
pub use run::{FileSink, Preamble, RecorderMemory, RunRecorder, RunRecording, Sink, StreamSink};
pub use write::{CASE_ATTACHMENT, LAYOUT_ATTACHMENT, SolutionRecording, write_solution};
