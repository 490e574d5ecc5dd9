//! Strips across the patch, crowded where the longitudinal slip changes sign.

use crate::Scalar;
use crate::fast::elementary::ln;
use crate::fast::lanes::Lanes;
use fearless_simd::prelude::*;

/// Density of strips that is the same everywhere, beside those about the two zeros of the slip. From 0.3 to 1.5 the
/// errors hardly change; 3 doubles them.
const EVEN: f64 = 1.0;
/// Smallest width of a crowd over the semi-axis across. Without it errors of stiff surfaces (a fifth of the yielding of
/// steel) are up to three times as large, for steel it makes no difference.
const SMALLEST_WIDTH: f64 = 0.02;
/// A zero farther out than this, over the semi-axis, stands here: nothing crowds about it.
const FAR: f64 = 1e4;
/// Change of the place in a step of Newton's method, over its scale, behind which only rounding is left.
const SETTLED: f64 = 1e-8;
/// More steps than bisection with a step of Newton's method after each would take.
const MOST_STEPS: usize = 120;

/// Where strips stand: at shares τ of the integral of a density of Y from edge to edge,
/// ```text
/// F(Y) = ∫ 1 + Σ_i 1/√((Y − Y_i)² + w²) dY = Y + Σ_i asinh((Y − Y_i)/w),   i = 1, 2
/// ```
/// with Y_1 and Y_2 the zeros of the longitudinal slip u = γ − β Y − α Y². Traction turns round within the distance of
/// them over which u grows to the slip C κ that the surfaces take up by yielding, w = C κ/|u'|. Where u only comes near
/// zero both stand at its vertex, with the distance of the complex zeros added to w. A zero may stand outside of the
/// patch: nothing jumps when it comes in.
///
/// Panels between the zeros with nodes graded towards their ends, as the rigid patch has them, need about twice as many
/// strips: elastic tractions have no kink at a zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crowding<D = f64> {
    zeros: [D; 2],
    /// w².
    width2: D,
    /// Product of Y − Y_i + √((Y − Y_i)² + w²) at Y = −1.
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
        let width2 = taken_up * taken_up / slope2 + SMALLEST_WIDTH * SMALLEST_WIDTH;
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
        let width2 = if width2.re() < FAR * FAR { width2 } else { D::from(FAR * FAR) };
        let mut crowding = Self { zeros, width2, start: D::one(), total: D::one() };
        crowding.start = crowding.product(-D::one());
        crowding.total = crowding.share(D::one());
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

    /// F(Y) − F(−1).
    fn share(&self, y: D) -> D {
        (y + 1.0) * EVEN + (self.product(y) / self.start).ln()
    }

    fn density(&self, y: D) -> D {
        let [first, second] = self.zeros.map(|zero| ((y - zero) * (y - zero) + self.width2).sqrt().recip());
        first + second + EVEN
    }

    /// Y and dY/dτ at τ in [0, 1], with derivatives.
    pub(super) fn place(&self, t: f64) -> (D, D) {
        let real = Crowding {
            zeros: self.zeros.map(|z| z.re()),
            width2: self.width2.re(),
            start: self.start.re(),
            total: self.total.re(),
        };
        let start = D::from(real.find(t));
        // One step of Newton's method carries the derivatives.
        let y = start - (self.share(start) - self.total * t) / self.density(start);
        (y, self.total / self.density(y))
    }
}

impl Crowding {
    /// Y at τ by bisection and Newton's method.
    fn find(&self, t: f64) -> f64 {
        let (mut low, mut high) = (-1.0, 1.0);
        let (mut y, mut before) = (0.0, f64::INFINITY);
        for _ in 0..MOST_STEPS {
            let over = self.share(y) - self.total * t;
            if over < 0.0 {
                low = y;
            } else {
                high = y;
            }
            let next = y - over / self.density(y);
            // Behind a step like this only rounding is left.
            if (next - y).abs() < 1e-12 {
                return next.clamp(low, high);
            }
            // Between two crowds Newton's steps may go to and fro for long.
            let leads = next > low && next < high && over.abs() < 0.5 * before;
            (y, before) = if leads { (next, over.abs()) } else { (0.5 * (low + high), f64::INFINITY) };
        }
        y
    }

    /// Y and dY/dτ at eight τ in [0, 1].
    ///
    /// A step goes along z = asinh((Y − Y_i)/w) of the nearer zero, over which F is nearly a straight line.
    #[inline(always)]
    pub(super) fn places<S: Simd>(&self, t: Lanes<S>) -> [Lanes<S>; 2] {
        let lanes = |x: f64| Lanes::splat(t.token(), x);
        let (one, width2) = (lanes(1.0), lanes(self.width2));
        let target = t * self.total;
        let (mut low, mut high) = (-one, one);
        let mut y = t * 2.0 - 1.0;
        let distances = |y: Lanes<S>| {
            let d = self.zeros.map(|zero| y - zero);
            (d, d.map(|d| (d * d + width2).sqrt()))
        };
        for _ in 0..MOST_STEPS {
            let (d, s) = distances(y);
            let (mut over, mut under) = (one, lanes(self.start));
            for (d, s) in d.into_iter().zip(s) {
                let before = d.simd_lt(0.0);
                over *= before.select(width2, s + d);
                under *= before.select(s - d, one);
            }
            let excess = (y + 1.0) * EVEN + ln((over / under).max(0.75)) - target;
            let first = s[0].simd_lt(s[1]);
            let (d, near, other) = (first.select(d[0], d[1]), first.select(s[0], s[1]), first.select(s[1], s[0]));
            let step = -excess * other / (near * other * EVEN + (near + other));
            let square = step * step;
            let next = y + (d * square * 0.5 + near * step * (square * (1.0 / 6.0) + 1.0));
            let below = excess.simd_lt(0.0);
            low = below.select(y, low);
            high = below.select(high, y);
            let within = next.simd_ge(low) & next.simd_le(high);
            y = within.select(next, (low + high) * 0.5);
            if (within & step.abs().simd_le(SETTLED)).all_true() {
                break;
            }
        }
        let (_, [first, second]) = distances(y);
        let both = first * second;
        [y, both * self.total / (both * EVEN + (first + second))]
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
                prop_assert!((y[k] - place).abs() < 2e-14 && (stretch[k] / slope - 1.0).abs() < 1e-12);
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

    /// Newton's steps went to and fro between the two crowds until none was left.
    #[test]
    fn regress_a_place_between_two_crowds_is_found() {
        let slip = [-0.391_948_644_070_240_3 * 10f64.powf(-1.714_484_050_316_594), 0.0];
        let alpha = -0.047_203_920_326_466_79 * 10f64.powf(0.656_558_479_147_708_4);
        let of = Crowding::new([slip[0], slip[1], alpha], 10f64.powf(-3.382_541_256_670_066));
        let (place, _) = of.place(0.3);
        assert!((of.share(place) / of.total - 0.3).abs() < 1e-14, "{place}");
    }

    #[test]
    fn limit_without_a_zero_in_sight_strips_stand_as_they_are() {
        for slip in [[1.0, 0.0, 0.0], [0.0; 3], [1.0, 1e-9, 0.0], [1.0, 0.0, 1e-12]] {
            for t in SHARES {
                let (y, stretch) = Crowding::new(slip, 0.1).place(t);
                assert!((y - (2.0 * t - 1.0)).abs() < 1e-3 && (stretch - 2.0).abs() < 1e-3, "{slip:?} {t} {y}");
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
