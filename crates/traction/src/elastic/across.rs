//! Strips across the patch, crowded where the longitudinal slip changes sign.

use crate::Scalar;
use crate::fast::elementary::exp;
use crate::fast::lanes::Lanes;
use fearless_simd::prelude::*;

/// Square of the width of a crowd over that of the zone in which traction turns round. At a half errors of stiff
/// surfaces are up to twice as large, at 4 those of steep curves.
const WIDTH: f64 = 2.0;
/// Smallest width of a crowd over the semi-axis across. Without it errors of stiff surfaces (a fifth of the yielding of
/// steel) are up to three times as large, for steel it makes no difference.
const SMALLEST_WIDTH: f64 = 0.02;
/// A zero farther out than this, over the semi-axis, stands here: nothing crowds about it.
const FAR: f64 = 1e4;

/// Where strips stand: at shares τ of the integral of a density of Y from edge to edge,
/// ```text
/// F(Y) = ∫ Σ_i 1/√((Y − Y_i)² + w²) dY = Σ_i asinh((Y − Y_i)/w),   i = 1, 2
/// ```
/// with Y_1 and Y_2 the zeros of the longitudinal slip u = γ − β Y − α Y². Traction turns round within the distance of
/// them over which u grows to the slip C κ that the surfaces take up by yielding, C κ/|u'|, and w is √2 times that.
/// Where u only comes near zero both stand at its vertex, with the distance of the complex zeros added to w. A zero may
/// stand outside of the patch: nothing jumps when it comes in.
///
/// F is inverted in closed form: with G = w exp(F/2), H = w²/G and Q = exp asinh((Y_2 − Y_1)/(G + H)),
/// ```text
/// Y = Y_1 + (G Q − H/Q)/2 = Y_2 + (G/Q − H Q)/2
/// ```
///
/// Panels between the zeros with nodes graded towards their ends, as the rigid patch has them, need about twice as many
/// strips: elastic tractions have no kink at a zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crowding<D = f64> {
    /// The lower one first.
    zeros: [D; 2],
    /// w².
    width2: D,
    /// G at Y = −1, the root of the product of Y − Y_i + √((Y − Y_i)² + w²).
    start: D,
    /// F(1) − F(−1).
    total: D,
}

impl<D: Scalar> Crowding<D> {
    /// Of a slip u and of C κ in the same unit.
    pub(super) fn new([gamma, beta, alpha]: [D; 3], taken_up: D) -> Self {
        let near = |x: D| if x.re().abs() < FAR { x } else { D::from(FAR.copysign(x.re())) };
        let discriminant = beta * beta + alpha * gamma * 4.0;
        let bend = alpha * taken_up;
        // |u'| at the zeros is the root of the discriminant; where that vanishes too u grows as α (Y − Y_1)².
        let slope2 = (discriminant * discriminant + bend * bend + f64::MIN_POSITIVE).sqrt();
        let width2 = taken_up * taken_up * WIDTH / slope2 + SMALLEST_WIDTH * SMALLEST_WIDTH;
        let (zeros, width2) = if discriminant.re() > 0.0 {
            let root = discriminant.sqrt();
            let q = if beta.re() < 0.0 { root - beta } else { -root - beta } * 0.5;
            ([near(q / alpha), near(-gamma / q)], width2)
        } else if alpha.re() == 0.0 {
            ([D::from(FAR), D::from(-FAR)], width2)
        } else {
            let half = alpha.recip() * 0.5;
            ([near(-beta * half); 2], width2 - discriminant * half * half)
        };
        let [first, second] = zeros;
        let zeros = if second.re() < first.re() { [second, first] } else { zeros };
        let width2 = if width2.re() < FAR * FAR { width2 } else { D::from(FAR * FAR) };
        let mut crowding = Self { zeros, width2, start: D::one(), total: D::one() };
        let product = crowding.product(-D::one());
        crowding.start = product.sqrt();
        crowding.total = (crowding.product(D::one()) / product).ln();
        crowding
    }

    /// Product of both Y − Y_i + √((Y − Y_i)² + w²).
    fn product(&self, y: D) -> D {
        let [first, second] = self.zeros.map(|zero| {
            let d = y - zero;
            let distance = (d * d + self.width2).sqrt();
            if d.re() < 0.0 { self.width2 / (distance - d) } else { distance + d }
        });
        first * second
    }

    /// Y and dY/dτ at τ in [0, 1], with derivatives.
    pub(super) fn place(&self, t: f64) -> (D, D) {
        let [first, second] = self.zeros;
        let up = (self.total * (0.5 * t)).exp() * self.start;
        let up2 = up * up;
        let over = (up * (up2 + self.width2)).recip();
        let down = (up2 + self.width2) * over * self.width2;
        let ratio = up2 * over * (second - first);
        let turn = ratio + (ratio * ratio + 1.0).sqrt();
        let back = turn.recip();
        // Half of G Q, H/Q, G/Q and H Q.
        let [up, down] = [up * 0.5, down * 0.5];
        let (from_first, from_second) = ([up * turn, down * back], [up * back, down * turn]);
        // From the zero that is nearer to the patch, where fewer digits are lost.
        let nearer = first.re().abs() < second.re().abs();
        let ([a, b], zero) = if nearer { (from_first, first) } else { (from_second, second) };
        // With G H = w² the sum of what makes a distance from a zero by its difference is the root of its square + w².
        let (first, second) = (from_first[0] + from_first[1], from_second[0] + from_second[1]);
        (a - b + zero, first * second * self.total / (first + second))
    }
}

impl Crowding {
    /// [`Crowding::place`] at eight τ in [0, 1].
    #[inline(always)]
    pub(super) fn places<S: Simd>(&self, t: Lanes<S>) -> [Lanes<S>; 2] {
        let [first, second] = self.zeros;
        let one = Lanes::splat(t.token(), 1.0);
        let up = exp(t * (0.5 * self.total)) * self.start;
        let up2 = up * up;
        let over = one / (up * (up2 + self.width2));
        let down = (up2 + self.width2) * over * self.width2;
        let ratio = up2 * over * (second - first);
        let turn = ratio + (ratio * ratio + 1.0).sqrt();
        let back = one / turn;
        let [up, down] = [up * 0.5, down * 0.5];
        let (from_first, from_second) = ([up * turn, down * back], [up * back, down * turn]);
        let ([a, b], zero) = if first.abs() < second.abs() { (from_first, first) } else { (from_second, second) };
        let (first, second) = (from_first[0] + from_first[1], from_second[0] + from_second[1]);
        [a - b + zero, first * second * self.total / (first + second)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fast::lanes::LANES;
    use fearless_simd::{Level, dispatch};
    use num_dual::Dual64;
    use proptest::prelude::*;

    const SHARES: [f64; LANES] = [1e-3, 0.02, 0.1, 0.3, 0.5, 0.8, 0.97, 0.9995];

    fn in_lanes(level: Level, of: &Crowding) -> [[f64; LANES]; 2] {
        dispatch!(level, simd => of.places(Lanes::simd_from(simd, SHARES)).map(|v| v.to_array()))
    }

    proptest! {
        #[test]
        fn identity_lanes_and_plain_places_agree(
            slip in proptest::array::uniform3(-1.0..1.0f64),
            sizes in proptest::array::uniform4(-4.0..1.0f64),
        ) {
            let [gamma, beta, alpha] = std::array::from_fn(|k| slip[k] * 10f64.powf(sizes[k]));
            let of = Crowding::new([gamma, beta, alpha], 10f64.powf(sizes[3]));
            let [y, stretch] = in_lanes(Level::new(), &of);
            prop_assert_eq!([y, stretch], in_lanes(Level::baseline(), &of));
            for (k, t) in SHARES.into_iter().enumerate() {
                let (place, slope) = of.place(t);
                // Zeros far out leave fewer digits of the place.
                prop_assert!((y[k] - place).abs() < 2e-12 && (stretch[k] / slope - 1.0).abs() < 1e-10);
                prop_assert!(place > -1.0 && place < 1.0 && (k == 0 || y[k] > y[k - 1]));
            }
        }
    }

    #[test]
    fn identity_stretch_is_the_derivative_and_duals_follow_the_zeros() {
        let slip = |x: f64| [0.3 + x, 1.2, -2.0];
        let real = Dual64::from;
        let dual = Crowding::new([Dual64::new(0.3, 1.0), real(1.2), real(-2.0)], real(0.1));
        let h = 1e-6;
        for t in SHARES {
            let at = |x: f64, t: f64| Crowding::new(slip(x), 0.1).place(t).0;
            let (y, stretch) = dual.place(t);
            assert!((stretch.re - (at(0.0, t + h * t) - at(0.0, t - h * t)) / (2.0 * h * t)).abs() < 1e-6 / t.min(0.1));
            assert!((y.eps - (at(h, t) - at(-h, t)) / (2.0 * h)).abs() < 1e-7);
        }
    }

    #[test]
    fn limit_without_a_zero_in_sight_strips_stand_as_they_are() {
        for slip in [[1.0, 0.0, 0.0], [0.0; 3], [1.0, 1e-9, 0.0], [1.0, 0.0, 1e-12]] {
            for t in SHARES {
                let (y, stretch) = Crowding::new(slip, 0.1).place(t);
                assert!((y - (2.0 * t - 1.0)).abs() < 1e-3 && (stretch - 2.0).abs() < 4e-3, "{slip:?} {t} {y}");
            }
        }
    }

    #[test]
    fn identity_places_do_not_jump_where_zeros_enter_meet_or_go_to_infinity() {
        let of = |slip| SHARES.map(|t| Crowding::new(slip, 0.1).place(t).0);
        let near = |a: [f64; 3], b: [f64; 3]| {
            let apart = of(a).into_iter().zip(of(b)).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
            assert!(apart < 1e-6, "{a:?} {b:?}: {apart:e}");
        };
        near([1.0 - 1e-9, 1.0, 0.0], [1.0 + 1e-9, 1.0, 0.0]);
        near([-0.125 - 1e-13, 0.5, -0.5], [-0.125 + 1e-13, 0.5, -0.5]);
        near([0.3, 1.0, 1e-9], [0.3, 1.0, -1e-9]);
        near([0.3, 1e-12, 1.0], [0.3, -1e-12, 1.0]);
    }
}
