//! How deep balls are in the walls of their pockets.

use super::drift::Pressed;
use super::lanes::{Lane, WIDTH, ball_in, get};
use crate::equations::Frame;
use crate::layout::{AXIAL, AZIMUTH, BALL, RADIUS};
use crate::machine::Machine;
use tribodyn_bearing::AzimuthFrame;

/// The middles of the pockets of a block's balls in the cage.
#[derive(Debug, Clone, Copy)]
pub(super) struct Places {
    /// Their azimuths, rad.
    azimuth: Lane,
    /// sin and cos of these.
    direction: [Lane; 2],
}

impl Places {
    pub fn new(machine: &Machine, block: usize) -> Self {
        let ball = |k: usize| ball_in(machine.layout, block, k);
        let directions: [AzimuthFrame; WIDTH] = std::array::from_fn(|k| machine.directions[ball(k)]);
        Self {
            azimuth: Lane(std::array::from_fn(|k| machine.place_in_cage(ball(k)))),
            direction: [Lane(directions.map(|at| at.sin)), Lane(directions.map(|at| at.cos))],
        }
    }
}

/// How deep the balls of a block are in their pockets, m.
#[inline(always)]
pub(super) fn depths(
    machine: &Machine,
    (frame, places): (&Frame, &Places),
    (balls, pressed): (&[Lane; BALL], &Pressed),
) -> Lane {
    let (mut depth, pocket) = (Lane::ZERO, machine.cage.pocket);
    if let (Some(cage), Some(pose)) = (&machine.free_cage, frame.free_cage) {
        let (wall, plane) = (pocket.wall(cage.pockets), machine.plane());
        for k in pressed.in_use.lanes() {
            let [sin, cos] = get(&places.direction, k);
            let at = [balls[AXIAL].0[k] - plane, balls[RADIUS].0[k], 0.0];
            depth.0[k] = pocket.depth_in(&wall, (&pose, AzimuthFrame { sin, cos }), (pressed.axes(k), at));
        }
    } else {
        let cage_angle = frame.cage[0];
        for k in pressed.in_use.lanes() {
            depth.0[k] = pocket.penetration(balls[AZIMUTH].0[k] - cage_angle - places.azimuth.0[k]);
        }
    }
    depth
}
