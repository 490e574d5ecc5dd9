//! A ball in its cage pocket: dead band, spring and damper, friction.

use crate::modelling::PocketForce;
use tribodyn_contact::Scalar;
use tribodyn_fluid::SqueezeFilm;

/// The cage's pockets, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pocket {
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
    /// Where the force starts.
    pub force: PocketForce,
    /// Oil between ball and walls; none in a dry pocket.
    pub film: Option<SqueezeFilm>,
}

/// Sliding speed below which pocket friction falls off in proportion, m/s. The balls spin past their pockets at tens of
/// metres per second; this only keeps a bearing at rest from chattering.
pub(crate) const CREEP: f64 = 0.01;

/// Motion of a ball in its pocket.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PocketMotion<D = f64> {
    /// Lead of the ball over the middle of its pocket, rad.
    pub lead: D,
    /// Its rate, rad/s.
    pub rate: D,
    /// Axial and radial velocity of the ball centre, m/s.
    pub velocity: [D; 2],
    /// Absolute angular velocity, axial and radial, rad/s.
    pub angular_velocity: [D; 2],
    /// Speed of the cage, rad/s.
    pub cage_speed: D,
}

/// Forces and moments of the pocket contact, its energy and its losses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PocketLoad<D = f64> {
    /// Force along the orbit, N, that of the film with it.
    pub force: D,
    /// Friction (axial, radial), N; in the pocket of a free cage the whole force along these axes.
    pub friction: [D; 2],
    /// Moment of the friction on the ball (axial, radial, tangential), N m.
    pub moment: [D; 3],
    /// Torque on the cage of force and friction, N m.
    pub cage_torque: D,
    /// Energy of the spring, J.
    pub energy: D,
    /// Power lost by damping and in the film, W.
    pub damping_power: D,
    /// Power lost by friction, W.
    pub friction_power: D,
    /// Sliding speed, m/s.
    pub sliding: D,
    /// Normal force on the wall without that of the film, N.
    pub normal: D,
}

impl<D: Scalar> PocketLoad<D> {
    /// Normal force times sliding speed, W: the cage wears in proportion to it.
    #[inline(always)]
    pub fn sliding_power(&self) -> D {
        self.sliding * self.normal
    }

    /// The ball touches no wall.
    pub fn none() -> Self {
        let zero = D::zero();
        Self {
            force: zero,
            friction: [zero; 2],
            moment: [zero; 3],
            cage_torque: zero,
            energy: zero,
            damping_power: zero,
            friction_power: zero,
            sliding: zero,
            normal: zero,
        }
    }
}

/// Steps from the wall to where a ball is, at its velocity, up to which it is in a blow: a deeper one presses on it.
const BLOW: f64 = 2.0;

impl Pocket {
    /// How far the ball is pressed into the pocket wall, m; negative where there is a gap.
    pub fn penetration<D: Scalar>(&self, lead: D) -> D {
        let size = if lead.re() < 0.0 { -lead } else { lead };
        (size - self.clearance) * self.radius
    }

    /// How far the spring is pressed, m, where the ball is pressed into the wall by `depth`: by as much, or from the
    /// middle of the pocket on; and the length that it has at the wall.
    fn pressed<D: Scalar>(&self, depth: D) -> [D; 2] {
        let before = match self.force {
            PocketForce::FromWall => 0.0,
            PocketForce::AsPrinted => self.clearance * self.radius,
        };
        [depth + before, D::from(before)]
    }

    /// Force of the oil on the ball along the orbit, N: of the film at the wall that it approaches, in front or behind.
    fn film_force<D: Scalar>(&self, lead: D, rate: D) -> D {
        let Some(film) = &self.film else { return D::zero() };
        let (ahead, speed, gap) = (lead * self.radius, rate * self.radius, self.clearance * self.radius);
        film.force(ahead + gap, -speed) - film.force(-ahead + gap, speed)
    }

    /// Angular velocity of a ball against the cage that dampers see in a step of `h`, rad/s. `hold` is what stops ball
    /// and cage within the step, N s/m. In a blow, where a few steps at most lead from the gap to where the ball is, it
    /// is the mean one of a ball that its wall stops or turns back: with that before the step dampers would turn it
    /// back faster than it came. A ball that presses on its wall for longer has that before the step.
    pub fn rate_in_step(&self, lead: f64, rate: f64, (hold, h): (f64, f64)) -> f64 {
        let side = lead.signum();
        let (depth, closing) = (self.penetration(lead), rate * (side * self.radius));
        if depth <= 0.0 || depth > BLOW * closing * h {
            return rate;
        }
        let spring = self.pressed(depth)[0] * self.stiffness;
        let dampers = spring * self.damping - side * self.film_force(lead, rate) / closing;
        let mean = (closing - 0.5 * spring / hold) / (1.0 + 0.5 * dampers / hold);
        side * mean.max(0.0) / self.radius
    }

    /// Force and friction. The spring starts at the wall, unless it is taken as printed, and the damping grows with it,
    /// so that the force is continuous; together they never pull.
    pub fn load<D: Scalar>(&self, motion: &PocketMotion<D>) -> PocketLoad<D> {
        let depth = self.penetration(motion.lead);
        let film = self.film_force(motion.lead, motion.rate);
        let of_film = PocketLoad {
            force: film,
            cage_torque: film * -self.radius,
            damping_power: film * motion.rate * -self.radius,
            ..PocketLoad::none()
        };
        if depth.re() <= 0.0 {
            return of_film;
        }
        // The ball leads: it touches the front wall, at +r_b e_t, and is held back.
        let side = motion.lead.re().signum();
        let closing = motion.rate * (side * self.radius);
        let [length, at_wall] = self.pressed(depth);
        let spring = length * self.stiffness;
        let pressed = spring * (closing * self.damping + 1.0);
        let normal = if pressed.re() > 0.0 { pressed } else { D::zero() };
        let arm = side * self.ball_radius;
        let slip = [
            motion.velocity[0] + motion.angular_velocity[1] * arm,
            motion.velocity[1] - (motion.angular_velocity[0] - motion.cage_speed) * arm,
        ];
        let sliding = hypot(slip[0], slip[1]);
        let share = normal * -self.friction / hypot(sliding, D::from(CREEP));
        let friction = slip.map(|s| share * s);
        let force = normal * -side + film;
        PocketLoad {
            force,
            friction,
            // (arm e_t) × (f_a e_a + f_r e_r) = arm (f_a e_r − f_r e_a).
            moment: [friction[1] * -arm, friction[0] * arm, D::zero()],
            cage_torque: force * -self.radius + friction[1] * arm,
            energy: (spring + at_wall * self.stiffness) * 0.5 * depth,
            damping_power: (normal - spring) * closing + of_film.damping_power,
            friction_power: -share * sliding * sliding,
            sliding,
            normal,
        }
    }
}

/// √(a² + b²) with derivatives; none at zero. Speeds are far from the ends of the range of their squares.
#[inline(always)]
pub(crate) fn hypot<D: Scalar>(a: D, b: D) -> D {
    let square = a * a + b * b;
    if square.re() == 0.0 { D::zero() } else { square.sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::first_derivative;

    const POCKET: Pocket = Pocket {
        radius: 0.08,
        clearance: 1.5e-3,
        stiffness: 5e6,
        damping: 0.3,
        friction: 0.1,
        ball_radius: 0.015,
        force: PocketForce::FromWall,
        film: None,
    };

    fn motion(lead: f64, rate: f64) -> PocketMotion {
        PocketMotion { lead, rate, velocity: [0.02, -0.01], angular_velocity: [-2700.0, 800.0], cage_speed: 608.0 }
    }

    #[test]
    fn limit_no_force_within_the_clearance_and_a_continuous_one_at_its_edge() {
        assert_eq!(POCKET.load(&motion(1.49e-3, 5.0)), PocketLoad::none());
        let edge = POCKET.load(&motion(1.5e-3 + 1e-12, 5.0));
        assert!(edge.force.abs() < 1e-5 && edge.damping_power.abs() < 1e-5);
    }

    /// As printed the force is K r_p Δθ wherever there is one, and jumps at the wall.
    #[test]
    fn paper_pocket_force_as_printed() {
        let printed = Pocket { force: PocketForce::AsPrinted, ..POCKET };
        assert_eq!(printed.load(&motion(1.49e-3, 0.0)), PocketLoad::none());
        for lead in [1.5e-3 + 1e-12, 2e-3, -3e-3] {
            let force = printed.load(&motion(lead, 0.0)).force;
            assert!((force + 5e6 * 0.08 * lead).abs() < 1e-9 * force.abs(), "{force}");
        }
    }

    #[test]
    fn identity_pushes_back_on_either_side_and_never_pulls() {
        for (lead, rate) in [(2e-3, 1.0), (2e-3, -1.0), (-2e-3, 1.0), (2e-3, -1e4), (-2e-3, 1e4)] {
            let load = POCKET.load(&motion(lead, rate));
            assert!(load.force * lead <= 0.0, "{lead} {rate}: {}", load.force);
            assert!(load.damping_power >= 0.0 && load.friction_power >= 0.0);
        }
    }

    /// A ball flies into its wall in steps in which the spring just turns it back, at any phase of a step. With dampers
    /// that see the velocity before each kick it comes out up to 1.3 times as fast and more.
    #[test]
    fn limit_a_blow_gives_no_more_speed_than_it_had() {
        let (h, oiled) = (26e-6, Pocket { film: Some(SqueezeFilm::new(0.02, [0.2, 0.015], 1e-5)), ..POCKET });
        let hold = 0.5 * POCKET.stiffness * h;
        let fastest_out = |pocket: Pocket, dampers: f64| {
            let blow = |speed: f64, phase: f64| {
                let (mut depth, mut velocity) = (phase * speed * h, speed);
                while depth > 0.0 {
                    let (lead, rate) = (pocket.clearance + depth / pocket.radius, velocity / pocket.radius);
                    let rate = rate + dampers * (pocket.rate_in_step(lead, rate, (hold, h)) - rate);
                    velocity += pocket.load(&motion(lead, rate)).force / hold;
                    depth += velocity * h;
                }
                -velocity / speed
            };
            let speeds = [0.05, 0.5, 1.0, 2.0];
            let all = speeds.into_iter().flat_map(|speed| (1..=50).map(move |k| blow(speed, f64::from(k) / 50.0)));
            all.fold(0.0, f64::max)
        };
        for pocket in [POCKET, oiled] {
            assert!(fastest_out(pocket, 1.0) < 1.0 + 1e-9, "{}", fastest_out(pocket, 1.0));
            assert!(fastest_out(pocket, 0.0) > 1.3, "{}", fastest_out(pocket, 0.0));
        }
    }

    /// Ball and cage together lose the power that spring, damping, film and friction take.
    #[test]
    fn identity_power_of_ball_and_cage() {
        let printed = Pocket { force: PocketForce::AsPrinted, ..POCKET };
        let oiled = Pocket { film: Some(SqueezeFilm::new(0.02, [0.2, 0.015], 1e-6)), ..POCKET };
        for (lead, rate, pocket) in [
            (2e-3, 1.3, POCKET),
            (-2.5e-3, 0.7, POCKET),
            (3e-3, -0.4, POCKET),
            (2e-3, 1.3, printed),
            (2e-3, 1.3, oiled),
            (-2e-3, 1.3, oiled),
            (1e-3, -0.8, oiled),
        ] {
            let m = motion(lead, rate);
            let orbit = m.cage_speed + rate;
            let load = pocket.load(&m);
            let on_ball = load.force * POCKET.radius * orbit
                + load.friction[0] * m.velocity[0]
                + load.friction[1] * m.velocity[1]
                + load.moment[0] * m.angular_velocity[0]
                + load.moment[1] * m.angular_velocity[1];
            let given = on_ball + load.cage_torque * m.cage_speed;
            let ahead = PocketMotion { lead: lead + 1e-9, ..m };
            let stored = (pocket.load(&ahead).energy - load.energy) / 1e-9 * rate;
            let lost = load.damping_power + load.friction_power;
            assert!((given + stored + lost).abs() < 1e-5 * lost.abs(), "{given} {stored} {lost}");
        }
    }

    /// Force and torque on the cage by the lead, with the friction's part.
    #[test]
    fn identity_slope_over_the_lead_is_that_of_differences() {
        for lead in [2e-3, -3e-3] {
            let at = |lead| POCKET.load(&motion(lead, 1.0)).cage_torque;
            let (_, slope) = first_derivative(
                |lead| {
                    let constant = |v: f64| num_dual::Dual64::from(v);
                    let m = motion(0.0, 1.0);
                    let angular_velocity = m.angular_velocity.map(constant);
                    let velocity = m.velocity.map(constant);
                    let rate = constant(m.rate);
                    POCKET
                        .load(&PocketMotion {
                            lead,
                            rate,
                            velocity,
                            angular_velocity,
                            cage_speed: constant(m.cage_speed),
                        })
                        .cage_torque
                },
                lead,
            );
            let difference = (at(lead + 1e-8) - at(lead - 1e-8)) / 2e-8;
            assert!((slope / difference - 1.0).abs() < 1e-7, "{slope} {difference}");
        }
    }
}
