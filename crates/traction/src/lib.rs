//! (filled by the traction work)
mod settings;
pub use settings::{MomentArm, PatchRule, PressureChoice, SlipUnit};
