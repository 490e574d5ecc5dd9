//! The surface of a raceway where a ball stands.

/// A spot of a raceway against the new one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalSurface {
    /// Depth of the groove below the new one, m.
    pub depth: f64,
    /// Its derivative by the azimuth in the ring's own frame, m/rad.
    pub slope: f64,
    /// Part of the coating that is gone, 0 to 1.
    pub bare: f64,
    /// Derivative of the depth by a rotation of the ball with what is in it (axial, radial, along the orbit), m/rad;
    /// that of the contact about the ring's axis is in the slope.
    pub turn: [f64; 3],
}

impl LocalSurface {
    /// A new raceway: no depth, all of the coating there.
    pub const NEW: Self = Self { depth: 0.0, slope: 0.0, bare: 0.0, turn: [0.0; 3] };

    /// Adds derivatives of the depth by a rotation of the ball, m/rad: as much comes off where the contact turns about
    /// the ring's axis and the ball does not.
    #[inline]
    pub fn turn_by(&mut self, by_rotation: [f64; 3]) {
        (0..3).for_each(|k| self.turn[k] += by_rotation[k]);
        self.slope -= by_rotation[0];
    }
}
