//! A ball in its cage pocket: dead band, spring and damper, friction.

/// The cage's constants, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pocket {
    /// Radius of the circle of pocket centres, m: arm of the pocket force on both ball and cage.
    pub radius: f64,
    /// Play on either side of the centred ball, rad.
    pub clearance: f64,
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Damping χ of Hunt and Crossley, s/m.
    pub damping: f64,
    /// Friction coefficient.
    pub friction: f64,
    /// Radius of the ball, m.
    pub ball_radius: f64,
}

/// Sliding speed below which pocket friction falls off in proportion, m/s. The balls spin past their pockets at tens of
/// metres per second; this only keeps a bearing at rest from chattering.
const CREEP: f64 = 0.01;

/// What a ball does against its pocket.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PocketMotion {
    /// Lead of the ball over the middle of its pocket, rad.
    pub lead: f64,
    /// Its rate, rad/s.
    pub rate: f64,
    /// Axial and radial velocity of the ball centre, m/s.
    pub velocity: [f64; 2],
    /// Absolute spin, axial and radial, rad/s.
    pub spin: [f64; 2],
    /// Speed of the cage, rad/s.
    pub cage_speed: f64,
}

/// What the pocket does to the ball.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PocketLoad {
    /// Force along the orbit, N.
    pub force: f64,
    /// Friction (axial, radial), N.
    pub friction: [f64; 2],
    /// Moment of the friction on the ball (axial, radial), N m.
    pub moment: [f64; 2],
    /// Torque on the cage of force and friction, N m.
    pub cage_torque: f64,
    /// Energy of the spring, J.
    pub energy: f64,
    /// Power lost by damping, W.
    pub damping_power: f64,
    /// Power lost by friction, W.
    pub friction_power: f64,
    /// Sliding speed, m/s.
    pub sliding: f64,
}

impl Pocket {
    /// How far the ball is pressed into the pocket wall, m; negative where there is a gap.
    pub fn penetration(&self, lead: f64) -> f64 {
        self.radius * (lead.abs() - self.clearance)
    }

    /// Force and friction. The spring starts at the wall and the damping grows with the penetration, so that the force
    /// is continuous; together they never pull.
    pub fn load(&self, motion: &PocketMotion) -> PocketLoad {
        let depth = self.penetration(motion.lead);
        if depth <= 0.0 {
            return PocketLoad::default();
        }
        // The ball leads: it touches the front wall, at +r_b e_t, and is held back.
        let side = motion.lead.signum();
        let closing = side * self.radius * motion.rate;
        let spring = self.stiffness * depth;
        let normal = (spring * (1.0 + self.damping * closing)).max(0.0);
        let arm = side * self.ball_radius;
        let slip = [
            motion.velocity[0] + arm * motion.spin[1],
            motion.velocity[1] - arm * (motion.spin[0] - motion.cage_speed),
        ];
        let sliding = slip[0].hypot(slip[1]);
        let share = -self.friction * normal / sliding.hypot(CREEP);
        let friction = slip.map(|s| share * s);
        let force = -side * normal;
        PocketLoad {
            force,
            friction,
            // (arm e_t) × (f_a e_a + f_r e_r) = arm (f_a e_r − f_r e_a).
            moment: [-arm * friction[1], arm * friction[0]],
            cage_torque: -self.radius * force + arm * friction[1],
            energy: 0.5 * spring * depth,
            damping_power: (normal - spring) * closing,
            friction_power: -share * sliding * sliding,
            sliding,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POCKET: Pocket =
        Pocket { radius: 0.08, clearance: 1.5e-3, stiffness: 5e6, damping: 0.3, friction: 0.1, ball_radius: 0.015 };

    fn motion(lead: f64, rate: f64) -> PocketMotion {
        PocketMotion { lead, rate, velocity: [0.02, -0.01], spin: [-2700.0, 800.0], cage_speed: 608.0 }
    }

    #[test]
    fn limit_no_force_within_the_clearance_and_a_continuous_one_at_its_edge() {
        assert_eq!(POCKET.load(&motion(1.49e-3, 5.0)), PocketLoad::default());
        let edge = POCKET.load(&motion(1.5e-3 + 1e-12, 5.0));
        assert!(edge.force.abs() < 1e-5 && edge.damping_power.abs() < 1e-5);
    }

    #[test]
    fn identity_pushes_back_on_either_side_and_never_pulls() {
        for (lead, rate) in [(2e-3, 1.0), (2e-3, -1.0), (-2e-3, 1.0), (2e-3, -1e4), (-2e-3, 1e4)] {
            let load = POCKET.load(&motion(lead, rate));
            assert!(load.force * lead <= 0.0, "{lead} {rate}: {}", load.force);
            assert!(load.damping_power >= 0.0 && load.friction_power >= 0.0);
        }
    }

    /// What ball and cage receive together is what spring, damping and friction take.
    #[test]
    fn identity_power_of_ball_and_cage() {
        for (lead, rate) in [(2e-3, 1.3), (-2.5e-3, 0.7), (3e-3, -0.4)] {
            let m = motion(lead, rate);
            let orbit = m.cage_speed + rate;
            let load = POCKET.load(&m);
            let on_ball = load.force * POCKET.radius * orbit
                + load.friction[0] * m.velocity[0]
                + load.friction[1] * m.velocity[1]
                + load.moment[0] * m.spin[0]
                + load.moment[1] * m.spin[1];
            let given = on_ball + load.cage_torque * m.cage_speed;
            let stored = POCKET.stiffness * POCKET.penetration(lead) * POCKET.radius * rate * lead.signum();
            let lost = load.damping_power + load.friction_power;
            assert!((given + stored + lost).abs() < 1e-9 * lost.abs(), "{given} {stored} {lost}");
        }
    }
}
