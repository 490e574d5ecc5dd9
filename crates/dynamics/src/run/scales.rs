//! Sizes that errors of the adaptive scheme are compared with.

use crate::layout::{BALL, ORBIT, VELOCITY};
use crate::machine::Machine;
use tribodyn_bearing::Side;

/// Typical size of each unknown, what the error of the adaptive scheme is compared with.
pub(super) fn scales(machine: &Machine, state: &[f64]) -> Vec<f64> {
    let l = machine.layout;
    let speed = (0..l.balls).map(|k| state[l.ball(k) + ORBIT].abs()).fold(1.0, f64::max);
    let g = &machine.bearing.geometry;
    let turning = speed * g.pitch_diameter / g.ball_diameter;
    // Approaches are some 1e-5 m; a contact mode of 1e5 rad/s turns a hundredth of that into 1e-2 m/s.
    let (length, velocity) = (1e-5, 1e-2);
    let mut scale = vec![f64::INFINITY; l.len()];
    for k in 0..l.balls {
        let b = &mut scale[l.ball(k)..][..BALL];
        b.copy_from_slice(&[length, length, 1.0, velocity, velocity, speed, turning, turning, turning]);
        debug_assert_eq!(VELOCITY, 3);
    }
    scale[l.cage()..l.cage() + 2].copy_from_slice(&[1.0, speed]);
    scale[l.inner()..l.inner() + 6].copy_from_slice(&[length, length, length, velocity, velocity, velocity]);
    scale[l.outer()..l.outer() + 4].copy_from_slice(&[length, length, velocity, velocity]);
    scale[l.angles()..l.angles() + 2].fill(1.0);
    if l.free_cage {
        let (tilt, turn) = (length / g.pitch_diameter, velocity / g.pitch_diameter);
        let sizes = [[length; 3].as_slice(), &[velocity; 3], &[turn; 2], &[tilt; 4]].concat();
        scale[l.free()].copy_from_slice(&sizes);
    }
    for side in Side::BOTH.into_iter().filter(|&side| l.tilting[side]) {
        let (tilt, turn) = (length / g.pitch_diameter, velocity / g.pitch_diameter);
        scale[l.tilt(side)].copy_from_slice(&[tilt, tilt, turn, turn]);
    }
    scale[l.orientations()].fill(1.0);
    scale
}
