#![doc = include_str!("../README.md")]

mod answer;
mod curve;
#[cfg(target_arch = "wasm32")]
mod exports;
mod question;
mod vibration;

pub use answer::ask;
