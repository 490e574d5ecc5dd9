//! Shafts for the tests.

use tribodyn_shaft::{Seat, Shaft, Spring, Support, System, Vector};

/// A shaft on linear springs in rigid seats.
pub fn on_springs(shaft: Shaft, springs: &[(usize, Vector)], loads: Vec<Vector>) -> System<'static> {
    let support = |&(node, stiffness): &(usize, Vector)| Support {
        node,
        carries_plus_z: true,
        offset: 0.0,
        ring: Box::new(Spring::diagonal(stiffness)) as _,
        seat: Seat::default(),
    };
    System { shaft, supports: springs.iter().map(support).collect(), housing: None, loads }
}
