//! Orientations of the balls that are not round as part of the state.

use crate::machine::Machine;
use tribodyn_bearing::BallState;
use tribodyn_bearing::vectors::cross;

impl Machine {
    /// Orientations of the balls that are not round at a state.
    pub fn orientations_at(&self, y: &[f64]) -> Vec<[f64; 4]> {
        y[self.layout.orientations()].as_chunks::<4>().0.to_vec()
    }

    /// Rate of the orientation of a ball that is not round.
    #[inline]
    pub fn turn_ball(&self, index: usize, state: &BallState, (y, dy): (&[f64], &mut [f64])) {
        if self.layout.marked == 0 {
            return;
        }
        let Some(slot) = self.ball_surfaces.slot(index) else { return };
        let at = self.layout.orientations().start + 4 * slot;
        let [x, y_, z, w] = std::array::from_fn(|k| y[at + k]);
        let about =
            [state.angular_velocity[0] - state.orbital_speed, state.angular_velocity[1], state.angular_velocity[2]];
        let turned = cross(about, [x, y_, z]);
        (0..3).for_each(|k| dy[at + k] = 0.5 * (w * about[k] + turned[k]));
        dy[at + 3] = -0.5 * (about[0] * x + about[1] * y_ + about[2] * z);
    }
}
