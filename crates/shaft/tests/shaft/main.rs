//! Shafts against formulas, another program's numbers, and conservation.

mod beams;
mod modes;
mod random;
mod sets;
mod support;
mod two_bearings;
