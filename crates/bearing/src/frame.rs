//! The moving axes of a ball.

use tribodyn_contact::Scalar;

/// The azimuth frame of a ball at φ: e_a axial (+Z), e_r radial outward, e_t = e_a × e_r along the orbit.
///
/// Vectors are [a, r, t] in this frame and [x, y, z] in the inertial one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AzimuthFrame<D = f64> {
    /// sin φ.
    pub sin: D,
    /// cos φ.
    pub cos: D,
}

impl AzimuthFrame {
    /// The frame at an azimuth, rad.
    #[inline]
    pub fn at(azimuth: f64) -> Self {
        let (sin, cos) = azimuth.sin_cos();
        Self { sin, cos }
    }

    /// The same frame for another scalar, without derivatives.
    pub fn lift<D: Scalar>(self) -> AzimuthFrame<D> {
        AzimuthFrame { sin: D::from(self.sin), cos: D::from(self.cos) }
    }
}

impl<D: Scalar> AzimuthFrame<D> {
    /// An inertial vector in the axes of the ball.
    #[inline(always)]
    pub fn from_inertial(self, [x, y, z]: [D; 3]) -> [D; 3] {
        [z, x * self.cos + y * self.sin, y * self.cos - x * self.sin]
    }

    /// A vector in the axes of the ball as an inertial one.
    #[inline(always)]
    pub fn to_inertial(self, [a, r, t]: [D; 3]) -> [D; 3] {
        [r * self.cos - t * self.sin, r * self.sin + t * self.cos, a]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At 90° the radial direction is +Y and the orbit runs towards −X.
    #[test]
    fn limit_axes_at_a_quarter_turn() {
        let frame = AzimuthFrame::at(std::f64::consts::FRAC_PI_2);
        let close = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-15);
        assert!(close(frame.to_inertial([0.0, 1.0, 0.0]), [0.0, 1.0, 0.0]));
        assert!(close(frame.to_inertial([0.0, 0.0, 1.0]), [-1.0, 0.0, 0.0]));
        assert!(close(frame.to_inertial([1.0, 0.0, 0.0]), [0.0, 0.0, 1.0]));
    }

    #[test]
    fn identity_there_and_back() {
        let frame = AzimuthFrame::at(2.1);
        let back = frame.from_inertial(frame.to_inertial([1.0, -2.0, 3.0]));
        assert!(back.iter().zip([1.0, -2.0, 3.0]).all(|(a, b)| (a - b).abs() < 1e-15));
    }
}
