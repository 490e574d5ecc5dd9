#![doc = include_str!("../README.md")]

mod ball_surfaces;
mod blame;
mod cage;
mod detail;
mod equations;
mod error;
mod fast;
mod forces;
mod layout;
mod linear;
mod machine;
mod observer;
mod orientation;
mod power;
mod run;
mod sample;
mod start;
mod stiffness;
mod tilt;
mod tilting;
mod traction_errors;
mod watch;

#[cfg(test)]
mod balance_test;
#[cfg(test)]
mod ball_surfaces_test;
#[cfg(test)]
mod ball_waves_test;
#[cfg(test)]
mod conservation_test;
#[cfg(test)]
mod fast_test;
#[cfg(test)]
mod free_cage_test;
#[cfg(test)]
mod oil_test;
#[cfg(test)]
mod stepping_test;
#[cfg(test)]
mod tilt_test;

pub use blame::{Blame, StepBound};
pub use error::DynamicsError;
pub use observer::{BallDetail, Event, EventKind, Observer};
pub use power::{POWER_IN, POWER_LOST, PowerSample};
pub use run::{
    ACCELERATION_ERROR, ACCELERATION_PART, AccelerationError, Checkpoint, Ending, FilterBands, Run, RunError,
    Statistics, StepChoice, StepErrors,
};
pub use sample::{CageSample, FreeCageSample, RingSample, Sample, WearSample};
pub use start::StartMotion;
pub use stiffness::Stiffness;
pub use tribodyn_bearing::{
    Bearing, BearingSpec, Cage, CoatingState, Dimensions, ElasticBody, Fit, Geometry, GuidingLand, Modelling,
    MovingCage, Races, RingCentre, RingLoads, RunInputs, RunOptions, Scheme, SpeedHistory, Start, Support, Supports,
    Tilt, TiltingRing, Translation, Tribology,
};
