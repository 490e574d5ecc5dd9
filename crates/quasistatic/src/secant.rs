//! Broyden's update of the blocks: what a step has shown about the slopes goes into them, ball by ball.
//!
//! The slopes of the traction integral hold the nodes of a strip rule fast and are off by up to a tenth where few nodes
//! meet a steep slip scale; and they age as the state moves. With J the slopes of the eleven forces of a ball and Δ the
//! step, the least change of J (in units of Δ that shift a ball's own balance by its size) that makes J Δ the change
//! seen is J + (ΔF − J Δ) Δᵀ/(Δᵀ Δ).
//!
//! Source: Broyden, Math. Comp. 19 (1965) 577, doi:10.1090/S0025-5718-1965-0198670-6; block by block as in partitioned
//! updates: Griewank and Toint, Numer. Math. 39 (1982) 119, doi:10.1007/BF01399316.

use crate::block::{BALL, BlockState, Linearised, RING, Residuals};
use nalgebra::SVector;

impl Linearised {
    /// Learns from a step between two states, and takes the residuals of the second.
    pub fn learn(&mut self, (from, before): (&BlockState, &Residuals), (to, after): (&BlockState, &Residuals)) {
        let ring = SVector::<f64, RING>::from_fn(|k, _| to.ring[k] - from.ring[k]);
        for (index, block) in self.balls.iter_mut().enumerate() {
            let ball = SVector::<f64, BALL>::from_fn(|k, _| to.balls[index][k] - from.balls[index][k]);
            let (was, is) = (&before.balls[index], &after.balls[index]);
            let on_ball = is.0 - was.0 - (block.own * ball + block.by_ring * ring);
            let on_ring = is.1 - was.1 - (block.on_ring * ball + block.ring * ring);
            let (ball_weight, ring_weight) = (block.weight.0.component_mul(&ball), block.weight.1.component_mul(&ring));
            let square = ball_weight.norm_squared() + ring_weight.norm_squared();
            // A ball that has not moved, or a slope that was never finite, teaches nothing.
            if !(square > 0.0 && square.is_finite()) {
                continue;
            }
            let towards_ball = block.weight.0.component_mul(&ball_weight).transpose() / square;
            let towards_ring = block.weight.1.component_mul(&ring_weight).transpose() / square;
            block.own += on_ball * towards_ball;
            block.by_ring += on_ball * towards_ring;
            block.on_ring += on_ring * towards_ball;
            block.ring += on_ring * towards_ring;
        }
        self.move_to(after);
    }
}
