//! Start of a problem from the solution of a neighbouring one.

use crate::block::{AXIAL, BALL, BlockState, OMEGA, ORBIT, RADIAL, RING};
use serde::{Deserialize, Serialize};
use tribodyn_bearing::{Races, Side};
use tribodyn_traction::PatchRule;

/// A solution's unknowns, to start a neighbouring problem from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WarmStart {
    pub(crate) state: BlockState,
    pub(crate) rule: PatchRule,
    /// Of inner and outer ring, rad/s.
    pub(crate) speeds: Races<f64>,
}

impl WarmStart {
    /// Position and motion of each ball, to the last digit.
    pub fn balls(&self) -> impl Iterator<Item = BallMotion> {
        self.state.balls.iter().map(|ball| BallMotion {
            position: [ball[AXIAL], ball[RADIAL]],
            angular_velocity: [ball[OMEGA], ball[OMEGA + 1], ball[OMEGA + 2]],
            orbital_speed: ball[ORBIT],
        })
    }

    /// Displacement x, y, z (m) and tilt about X and Y (rad) of the inner ring.
    pub fn ring(&self) -> [f64; 5] {
        self.state.ring
    }

    /// The patch rule of the solution.
    pub fn rule(&self) -> PatchRule {
        self.rule
    }

    /// The fourth corner of a parallelogram of problems: what this solution says of one that is as far from it as `to`
    /// is from `from`. With `from` and `to` = `self` it goes on in a straight line. None where the solutions are not of
    /// one bearing by one patch rule.
    pub fn moved(&self, from: &Self, to: &Self) -> Option<Self> {
        let alike = |other: &Self| other.rule == self.rule && other.state.balls.len() == self.state.balls.len();
        if !alike(from) || !alike(to) {
            return None;
        }
        let mut moved = self.clone();
        let shift = |x: &mut f64, from: f64, to: f64| *x += to - from;
        for (ball, (a, b)) in moved.state.balls.iter_mut().zip(from.state.balls.iter().zip(&to.state.balls)) {
            (0..BALL).for_each(|k| shift(&mut ball[k], a[k], b[k]));
        }
        (0..RING).for_each(|k| shift(&mut moved.state.ring[k], from.state.ring[k], to.state.ring[k]));
        for side in Side::BOTH {
            shift(&mut moved.speeds[side], from.speeds[side], to.speeds[side]);
        }
        Some(moved)
    }

    /// The state at other speeds of the rings: rolling is linear in them, seen from the outer ring. A change of 1 %
    /// would else be slip far past the peak of the traction curve.
    pub(crate) fn at_speeds(&self, now: Races<f64>) -> BlockState {
        let was = self.speeds;
        let mut state = self.state.clone();
        let share = (now.inner - now.outer) / (was.inner - was.outer);
        if share.is_finite() && now != was {
            for ball in &mut state.balls {
                (OMEGA..ORBIT).for_each(|k| ball[k] *= share);
                ball[ORBIT] = now.outer + (ball[ORBIT] - was.outer) * share;
            }
        }
        state
    }
}

/// Where a ball stands and how it moves in an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallMotion {
    /// Ball centre against the outer groove centre, axial X1 and radial X2, m.
    pub position: [f64; 2],
    /// Angular velocity relative to the orbiting frame (axial, radial, tangential), rad/s.
    pub angular_velocity: [f64; 3],
    /// Orbital speed, rad/s.
    pub orbital_speed: f64,
}
