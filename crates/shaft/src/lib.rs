#![doc = include_str!("../README.md")]

mod element;
mod equilibrium;
mod error;
mod internal;
mod linear;
mod modes;
mod ring;
mod rotor;
mod section;
mod set;
mod system;

pub use element::{Element, FREEDOMS};
pub use equilibrium::{Equilibrium, TOLERANCE};
pub use error::ShaftError;
pub use internal::Cut;
pub use modes::{LinearShaft, Mode, Whirl};
pub use ring::{Held, RestingBall, RestingBearing, RingForce, Spring, TurningBearing, Vector};
pub use rotor::{Disc, Shaft};
pub use section::{Material, Section};
pub use set::{AxialSet, AxialState, Member, offset_for};
pub use system::{Seat, Support, System, resultant};
