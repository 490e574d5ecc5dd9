//! Rotations as unit quaternions (x, y, z, w), as far as frames of a bearing need them.

use crate::wire::foxglove;
use serde::{Deserialize, Serialize};

/// A unit quaternion: a vector v of its own frame is q v q* in the parent's.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Rotation {
    pub(crate) vector: [f64; 3],
    pub(crate) real: f64,
}

impl Rotation {
    pub(crate) const IDENTITY: Self = Self { vector: [0.0; 3], real: 1.0 };

    /// Axes (x, y, z) of the frame along (Z, X, Y) of the parent: at azimuth 0 (axial, radial, tangential) is (Z, X,
    /// Y).
    pub(crate) const AXIAL_RADIAL_TANGENTIAL: Self = Self { vector: [-0.5; 3], real: 0.5 };

    /// Rotation by a vector of length equal to the angle, rad, exp(v/2).
    pub(crate) fn by_vector(v: [f64; 3]) -> Self {
        let square = v.iter().map(|x| x * x).sum::<f64>();
        if square > SMALL_ANGLE * SMALL_ANGLE {
            let angle = square.sqrt();
            let scale = (0.5 * angle).sin() / angle;
            return Self { vector: v.map(|x| x * scale), real: (0.5 * angle).cos() };
        }
        // The series of sin(θ/2)/θ and cos(θ/2) in (θ/2)²; what is left out is below rounding.
        let z = 0.25 * square;
        let scale = 0.5 * (1.0 - z / 6.0 * (1.0 - z / 20.0 * (1.0 - z / 42.0 * (1.0 - z / 72.0 * (1.0 - z / 110.0)))));
        let real = 1.0 - z / 2.0 * (1.0 - z / 12.0 * (1.0 - z / 30.0 * (1.0 - z / 56.0 * (1.0 - z / 90.0))));
        Self { vector: v.map(|x| x * scale), real }
    }

    /// Rotation about z, rad.
    pub(crate) fn about_z(angle: f64) -> Self {
        let (sin, cos) = (0.5 * angle).sin_cos();
        Self { vector: [0.0, 0.0, sin], real: cos }
    }

    /// Half a turn farther about z, for a rotation about z.
    pub(crate) fn turned_round(self) -> Self {
        Self { vector: [0.0, 0.0, self.real], real: -self.vector[2] }
    }

    /// Cosine and sine of the angle of a rotation about z.
    pub(crate) fn direction(self) -> [f64; 2] {
        let (sin, cos) = (self.vector[2], self.real);
        [(cos - sin) * (cos + sin), 2.0 * sin * cos]
    }

    /// First `inner`, then `self`.
    pub(crate) fn after(self, inner: Self) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (self.vector, inner.vector);
        let (aw, bw) = (self.real, inner.real);
        Self {
            vector: [
                aw * bx + ax * bw + ay * bz - az * by,
                aw * by - ax * bz + ay * bw + az * bx,
                aw * bz + ax * by - ay * bx + az * bw,
            ],
            real: aw * bw - ax * bx - ay * by - az * bz,
        }
    }

    /// The same rotation with rounding errors of the length taken out.
    pub(crate) fn unit(self) -> Self {
        let norm = (self.vector.iter().map(|x| x * x).sum::<f64>() + self.real * self.real).sqrt();
        Self { vector: self.vector.map(|x| x / norm), real: self.real / norm }
    }

    /// As the message has it.
    pub(crate) fn message(self) -> foxglove::Quaternion {
        let [x, y, z] = self.vector.map(grid);
        foxglove::Quaternion { x, y, z, w: grid(self.real) }
    }
}

/// Angle up to which a rotation comes from series, rad: balls turn by less from one sample to the next, and there are
/// many samples.
const SMALL_ANGLE: f64 = 0.4;

/// Rounds what is only drawn to multiples of 2⁻²⁴ (60 nm, or 6e-8 of a quaternion): nobody can see the difference,
/// and the file of a 13-ball bearing takes 0.96 MB instead of 1.37 MB. The numbers themselves are in state and balls.
pub(crate) fn grid(value: f64) -> f64 {
    const STEPS: f64 = (1_u32 << 24) as f64;
    // So large that the fraction falls off in the sum. Only below that can there be one.
    const SHIFT: f64 = 1.5 * (1_u64 << 52) as f64;
    let steps = value * STEPS;
    let whole = if steps.abs() < 0.25 * SHIFT { (steps + SHIFT) - SHIFT } else { steps };
    // Adding 0 turns −0 into +0, which the encoding leaves out.
    whole / STEPS + 0.0
}

/// A vector message on the drawing grid, m.
pub(crate) fn vector([x, y, z]: [f64; 3]) -> foxglove::Vector3 {
    foxglove::Vector3 { x: grid(x), y: grid(y), z: grid(z) }
}

/// A pose message on the drawing grid, m.
pub(crate) fn pose(position: [f64; 3], rotation: Rotation) -> foxglove::Pose {
    foxglove::Pose { position: Some(vector(position)), orientation: Some(rotation.message()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned(q: Rotation, v: [f64; 3]) -> [f64; 3] {
        let pure = Rotation { vector: v, real: 0.0 };
        let back = Rotation { vector: q.vector.map(|x| -x), real: q.real };
        q.after(pure).after(back).vector
    }

    fn close(a: [f64; 3], b: [f64; 3]) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14)
    }

    #[test]
    fn identity_azimuth_frame_has_the_axes_of_the_model() {
        for azimuth in [0.0_f64, 0.7, 2.0, 4.5] {
            let q = Rotation::about_z(azimuth).after(Rotation::AXIAL_RADIAL_TANGENTIAL);
            let (sin, cos) = azimuth.sin_cos();
            assert!(close(turned(q, [1.0, 0.0, 0.0]), [0.0, 0.0, 1.0]), "axial");
            assert!(close(turned(q, [0.0, 1.0, 0.0]), [cos, sin, 0.0]), "radial");
            assert!(close(turned(q, [0.0, 0.0, 1.0]), [-sin, cos, 0.0]), "tangential");
        }
    }

    #[test]
    fn identity_a_rotation_about_z_knows_its_direction_and_the_opposite() {
        for angle in [-7.0, -1.0, 0.0, 0.3, 2.0, 6.0] {
            let q = Rotation::about_z(angle);
            let [cos, sin] = q.direction();
            assert!((cos - angle.cos()).abs() < 4e-16 && (sin - angle.sin()).abs() < 4e-16, "{angle}");
            let (round, exact) = (q.turned_round(), Rotation::about_z(angle + std::f64::consts::PI));
            assert!(close(round.vector, exact.vector) && (round.real - exact.real).abs() < 1e-15, "{angle}");
        }
    }

    #[test]
    fn identity_small_rotations_are_as_large_ones() {
        for angle in [0.0, 1e-200, 1e-9, 1e-3, 0.1, SMALL_ANGLE * (1.0 - 1e-9), SMALL_ANGLE * (1.0 + 1e-9), 3.0] {
            let q = Rotation::by_vector([0.6 * angle, 0.0, 0.8 * angle]);
            let (sin, cos) = (0.5 * angle).sin_cos();
            assert!(close(q.vector, [0.6 * sin, 0.0, 0.8 * sin]) && (q.real - cos).abs() < 3e-16, "{angle}: {q:?}");
        }
    }

    #[test]
    fn identity_the_grid_is_the_nearest_multiple() {
        for k in -5000..5000 {
            let value = f64::from(k) * 1.237e-5;
            assert!((grid(value) - value).abs() <= 0.5_f64.powi(25), "{value}: {}", grid(value));
        }
        assert_eq!([1e300, -7e15, -0.0].map(grid), [1e300, -7e15, 0.0]);
    }

    #[test]
    fn identity_rotation_vectors_about_one_axis_add_up() {
        let step = Rotation::by_vector([0.0, 0.0, 0.01]);
        let many = (0..100).fold(Rotation::IDENTITY, |q, _| step.after(q));
        let once = Rotation::about_z(1.0);
        assert!(close(many.vector, once.vector) && (many.real - once.real).abs() < 1e-14);
    }
}
