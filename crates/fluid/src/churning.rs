//! Churning: the moment by which the fluid brakes the rotation of a ball.
//!
//! The coefficients are those of a disk wetted on both sides (Schlichting, Gersten, Boundary-Layer Theory, chapters on
//! the rotating disk): laminar from the similarity solution, where 3.87 = 2π · 0.616, turbulent from the one-seventh
//! power law. Rumbarger, Filetti, Gubernick (J. Lubr. Technol. 95 (1973) 401) and Gupta (Advanced Dynamics of Rolling
//! Elements, 1984) take the same law for the elements of a rolling bearing.

use crate::Scalar;

/// Reynolds number ρ ω r²/μ at which the published law changes from laminar to turbulent.
pub const TRANSITION_REYNOLDS: f64 = 3e5;

/// Angular velocity below which a ball counts as at rest, rad/s: far below anything physical, and high enough that
/// neither the squares of the components nor the reciprocals in the derivatives leave the range of f64.
const REST: f64 = 1e-100;

/// Passage of the churning coefficient from laminar to turbulent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Transition {
    /// The published switch at [`TRANSITION_REYNOLDS`]. The two laws do not meet there: C_n jumps from 0.00707 to
    /// 0.01172, which can keep a Newton iteration from settling.
    Published,
    /// The published laws outside TRANSITION_REYNOLDS/ratio to TRANSITION_REYNOLDS·ratio, and between them ln C_n
    /// passes from one to the other by a polynomial of the fifth degree in ln Re with continuous second derivative.
    /// The moment rises with the speed throughout for a ratio up to 5, where the two laws still lie in that order. A
    /// ratio of 1 or less is the published switch.
    Blended {
        /// Half width of the band as a ratio of Reynolds numbers, above 1.
        ratio: f64,
    },
}

impl Transition {
    /// The band Re = 2.5e5 to 3.6e5. Narrow, because inside it the coefficient is ours and not the published one; a
    /// band ten times narrower lets the moment grow with about the 25th power of the speed, this one with the 4th.
    pub const BLENDED: Transition = Transition::Blended { ratio: 1.2 };

    /// Churning coefficient C_n at a Reynolds number above 0.
    #[inline(always)]
    pub fn coefficient<D: Scalar>(self, reynolds: D) -> D {
        match self {
            Transition::Blended { ratio } if ratio > 1.0 => blended(reynolds, ratio),
            // Both are worked out, so that a loop over many balls needs no branch.
            _ => {
                let (low, high) = (laminar(reynolds), turbulent(reynolds));
                if reynolds.re() < TRANSITION_REYNOLDS { low } else { high }
            }
        }
    }
}

fn blended<D: Scalar>(reynolds: D, ratio: f64) -> D {
    let re = reynolds.re();
    if re < TRANSITION_REYNOLDS / ratio {
        return laminar(reynolds);
    }
    if re >= TRANSITION_REYNOLDS * ratio {
        return turbulent(reynolds);
    }
    let s = (reynolds / TRANSITION_REYNOLDS).ln() / (2.0 * ratio.ln()) + 0.5;
    let weight = s.powi(3) * ((s * 6.0 - 15.0) * s + 10.0);
    let low = laminar(reynolds).ln();
    let high = turbulent(reynolds).ln();
    (low + (high - low) * weight).exp()
}

#[inline(always)]
fn laminar<D: Scalar>(reynolds: D) -> D {
    reynolds.sqrt().recip() * 3.87
}

#[inline(always)]
fn turbulent<D: Scalar>(reynolds: D) -> D {
    reciprocal_fifth_root(reynolds) * 0.146
}

/// x^(−1/5) of a normal number above 0, without a call or a branch. A fifth of the bits is a fifth of the logarithm to
/// a few per cent; Newton's method squares the error, and its last two steps carry first and second derivatives.
#[inline(always)]
fn reciprocal_fifth_root<D: Scalar>(x: D) -> D {
    // 6/5 of the exponent of 1 in the upper half of the bits, less what halves the largest error of the guess.
    const OF_ONE: u64 = 0x4CB8_A000;
    // The upper half over five, by its reciprocal in units of 2^-34.
    let fifth = ((x.re().to_bits() >> 32) * 0xCCCC_CCCD) >> 34;
    let real = x.re();
    let mut root = f64::from_bits((OF_ONE - fifth) << 32);
    for _ in 0..3 {
        let square = root * root;
        root += root * 0.2 * (1.0 - real * (square * square * root));
    }
    let mut root = D::from(root);
    for _ in 0..2 {
        let square = root * root;
        root += root * (-(x * (square * square * root)) + 1.0) * 0.2;
    }
    root
}

/// Moment of the fluid against the rotation of a ball, M = ½ ρ ω² r⁵ C_n.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Churning {
    /// Density of the fluid, or effective density of a mixture, kg/m³.
    pub density: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
    /// Ball radius, m.
    pub radius: f64,
}

impl Churning {
    /// Reynolds number ρ ω r²/μ at the angular speed ω, rad/s.
    #[inline(always)]
    pub fn reynolds<D: Scalar>(&self, omega: D) -> D {
        omega * (self.density * self.radius * self.radius / self.viscosity)
    }

    /// Magnitude of the moment, N m, at the angular speed ω, rad/s, of either sign, by the published law.
    pub fn moment<D: Scalar>(&self, omega: D) -> D {
        self.moment_with(omega, Transition::Published)
    }

    /// Magnitude of the moment, N m, at the angular speed ω, rad/s, of either sign.
    pub fn moment_with<D: Scalar>(&self, omega: D, transition: Transition) -> D {
        let speed = if omega.re() < 0.0 { -omega } else { omega };
        if speed.re() < REST {
            return D::zero();
        }
        self.moment_per_speed(speed, transition) * speed
    }

    /// Moment on a ball, N m, at the angular velocity ω, rad/s: against ω, by the published law. Its derivatives at
    /// rest are zero, as M grows with |ω|^1.5 there.
    #[inline(always)]
    pub fn moment_vector<D: Scalar>(&self, omega: [D; 3]) -> [D; 3] {
        self.moment_vector_with(omega, Transition::Published)
    }

    /// Moment on a ball, N m, at the angular velocity ω, rad/s: against ω.
    #[inline(always)]
    pub fn moment_vector_with<D: Scalar>(&self, omega: [D; 3], transition: Transition) -> [D; 3] {
        let square = omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2];
        if square.re() < REST * REST {
            return [D::zero(); 3];
        }
        let factor = -self.moment_per_speed(square.sqrt(), transition);
        [omega[0] * factor, omega[1] * factor, omega[2] * factor]
    }

    /// M/ω at a speed above 0, N m s.
    #[inline(always)]
    fn moment_per_speed<D: Scalar>(&self, speed: D, transition: Transition) -> D {
        let coefficient = transition.coefficient(self.reynolds(speed));
        speed * coefficient * (0.5 * self.density * self.radius.powi(5))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::{Dual64, first_derivative, second_derivative};
    use proptest::prelude::*;

    const BALL: Churning = Churning { density: 770.5, viscosity: 119.7e-6, radius: 15.08e-3 };

    fn speed_at(reynolds: f64) -> f64 {
        reynolds / BALL.reynolds(1.0)
    }

    #[test]
    fn paper_laminar_coefficient_is_that_of_the_similarity_solution() {
        // von Kármán's disk: wall gradient 0.6159 of the circumferential velocity (Schlichting, Gersten), both sides.
        let coefficient = Transition::Published.coefficient(1.0f64);
        assert!((coefficient - 2.0 * std::f64::consts::PI * 0.6159).abs() < 5e-3);
    }

    #[test]
    fn identity_fifth_root_is_that_of_the_library_with_two_derivatives() {
        for x in (-40..40).map(|k| 10f64.powf(0.37 * f64::from(k))) {
            let (value, first, second) = second_derivative(reciprocal_fifth_root, x);
            let expected = x.powf(-0.2);
            assert!((reciprocal_fifth_root(x) / expected - 1.0).abs() < 1e-15, "{x}");
            assert!((value / expected - 1.0).abs() < 1e-15, "{x}");
            assert!((first / (-0.2 * expected / x) - 1.0).abs() < 1e-13, "{x}");
            assert!((second / (0.24 * expected / (x * x)) - 1.0).abs() < 1e-12, "{x}");
        }
    }

    #[test]
    fn paper_coefficient_jumps_at_transition() {
        let below = Transition::Published.coefficient(TRANSITION_REYNOLDS * (1.0 - 1e-12));
        let above = Transition::Published.coefficient(TRANSITION_REYNOLDS);
        assert!((below - 0.00707).abs() < 5e-6, "{below}");
        assert!((above - 0.01172).abs() < 5e-6, "{above}");
    }

    #[test]
    fn identity_blend_is_exact_outside_and_smooth_at_its_edges() {
        let blend = Transition::BLENDED;
        for reynolds in [1e3, 2.4e5, 3.7e5, 5e6] {
            assert_eq!(blend.coefficient(reynolds), Transition::Published.coefficient(reynolds));
        }
        for edge in [TRANSITION_REYNOLDS / 1.2, TRANSITION_REYNOLDS * 1.2] {
            let left = second_derivative(|re| blend.coefficient(re), edge * (1.0 - 1e-9));
            let right = second_derivative(|re| blend.coefficient(re), edge * (1.0 + 1e-9));
            // Scales of value, first and second derivative inside the band: C, C/Re·10, C/Re²·100.
            assert!((left.0 - right.0).abs() < 1e-8 * left.0);
            assert!((left.1 - right.1).abs() < 1e-6 * left.0 / edge);
            assert!((left.2 - right.2).abs() < 1e-5 * left.0 / (edge * edge));
        }
    }

    #[test]
    fn identity_blended_moment_rises_with_speed() {
        for ratio in [1.01, 1.2, 2.0, 5.0] {
            let transition = Transition::Blended { ratio };
            for step in 0..=400 {
                let reynolds = TRANSITION_REYNOLDS * (6.0f64).powf(step as f64 / 200.0 - 1.0);
                let speed = speed_at(reynolds);
                let (_, slope) = first_derivative(|w| BALL.moment_with(w, transition), speed);
                assert!(slope > 0.0, "ratio {ratio}, Re {reynolds}: {slope}");
            }
        }
    }

    #[test]
    fn limit_blend_of_no_width_is_the_published_switch() {
        for ratio in [1.0, 0.5, f64::NAN] {
            for reynolds in [2.999e5, 3e5, 3.001e5] {
                let blended = Transition::Blended { ratio }.coefficient(reynolds);
                assert_eq!(blended, Transition::Published.coefficient(reynolds));
            }
        }
    }

    #[test]
    fn limit_at_rest_moment_and_derivatives_vanish() {
        for omega in [0.0, -0.0, 1e-160, -1e-310] {
            assert_eq!(first_derivative(|w| BALL.moment(w), omega), (0.0, 0.0));
            for axis in 0..3 {
                let mut turning = [Dual64::from_re(0.0), Dual64::from_re(omega), Dual64::from_re(0.0)];
                turning[axis].eps = 1.0;
                for component in BALL.moment_vector(turning) {
                    assert_eq!((component.re, component.eps), (0.0, 0.0));
                }
            }
        }
        // Towards rest the slope falls with the square root of the speed: no step at the guard.
        let (_, slope) = first_derivative(|w| BALL.moment(w), 1e-90);
        assert!(slope > 0.0 && slope < 1e-50, "{slope}");
    }

    #[test]
    fn identity_moment_is_even_and_of_order_one_and_a_half_or_nine_fifths() {
        for (reynolds, order) in [(1e4, 1.5), (1e6, 1.8)] {
            let speed = speed_at(reynolds);
            assert_eq!(BALL.moment(-speed), BALL.moment(speed));
            let (moment, slope) = first_derivative(|w| BALL.moment(w), speed);
            assert!((slope * speed / moment - order).abs() < 1e-12);
        }
    }

    proptest! {
        #[test]
        fn identity_vector_opposes_spin(w in prop::array::uniform3(-5e3..5e3f64)) {
            let moment = BALL.moment_vector(w);
            let speed = w.iter().map(|c| c * c).sum::<f64>().sqrt();
            let power: f64 = moment.iter().zip(w).map(|(m, c)| m * c).sum();
            prop_assert!((power + BALL.moment(speed) * speed).abs() <= 1e-12 * power.abs());
            let cross = moment[0] * w[1] - moment[1] * w[0];
            prop_assert!(cross.abs() <= 1e-12 * power.abs());
        }

        #[test]
        fn identity_vector_derivatives_match_differences(
            w in prop::array::uniform3(-4e3..4e3f64),
            axis in 0usize..3,
        ) {
            let transition = Transition::BLENDED;
            let mut turning = w.map(Dual64::from_re);
            turning[axis].eps = 1.0;
            let step = 1e-2;
            let shifted = |sign: f64| {
                let mut w = w;
                w[axis] += sign * step;
                BALL.moment_vector_with(w, transition)
            };
            let (left, right) = (shifted(-1.0), shifted(1.0));
            let scale = BALL.moment_vector_with(w, transition).iter().fold(0.0f64, |m, c| m.max(c.abs()));
            for (i, exact) in BALL.moment_vector_with(turning, transition).iter().enumerate() {
                let difference = (right[i] - left[i]) / (2.0 * step);
                prop_assert!((exact.eps - difference).abs() < 1e-5 * scale.max(1e-6));
            }
        }
    }
}
