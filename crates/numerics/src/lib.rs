#![doc = include_str!("../README.md")]

mod dp54;
mod periodic;
mod radau;
mod rk4;
mod roots;

pub use dp54::{DormandPrince, StepControl};
pub use periodic::{Change, Interval, Periodic, Singular};
pub use radau::Radau;
pub use rk4::Rk4;
pub use roots::{bisect, hermite};
