//! Results of a steady orbit.

use crate::coarse::coarse_sentence;
use crate::collocation::Orbit;
use crate::damping::{LessDamping, RPM_PER_RAD_S, not_followed, pocket_force_max};
use crate::homotopy::{Regularization, swinging};
use crate::newton::Newton;
use crate::residual::{Found, shaft_torque};
use crate::system::{BALL, Evaluation, LEAD, ORBIT, OrbitSystem, VELOCITY};
use serde::Serialize;
use std::f64::consts::TAU;
use tribodyn_bearing::{BallMotionResult, BallResult, PocketResult};
use tribodyn_quasistatic::{Model, Solution};

/// Places round the orbit at which a solution is given: every two degrees.
pub const POINTS: usize = 180;

/// The periodic motion of balls and cage under steady loads.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SteadyOrbit {
    /// Cage speed, r/min.
    pub cage_speed_rpm: f64,
    /// Displacement of the inner ring against the outer: x, y (radial), z (axial), m.
    pub ring_displacement_m: [f64; 3],
    /// Tilt of the inner ring about X and Y, rad.
    pub ring_tilt_rad: [f64; 2],
    /// Mean force that the inner ring puts on the balls: x, y, z, N.
    pub ring_load_n: [f64; 3],
    /// Mean moment that the inner ring puts on the balls about X and Y, N m.
    pub ring_moment_nm: [f64; 2],
    /// Mean torque that the shaft needs against rotation at the inner ring's speed, N m.
    pub shaft_torque_nm: f64,
    /// Mean frictional power of the inner and outer contacts, W.
    pub friction_w: [f64; 2],
    /// Mean power of drag and churning, W.
    pub fluid_w: f64,
    /// Mean power of friction and damping in the pockets, W.
    pub pocket_w: f64,
    /// Largest pocket force of either direction, N; where the pockets' damping is raised, at the places of `points`.
    pub pocket_force_max_n: f64,
    /// Azimuths at which a ball meets a wall of its pocket, degrees.
    pub pocket_contact_azimuths_deg: Vec<f64>,
    /// Largest relative residual of all balances.
    pub residual: f64,
    /// Estimated quadrature error of the traction force over the load, against a finer rule.
    pub patch_error_estimate: f64,
    /// Jacobians of the whole orbit.
    pub iterations: usize,
    /// Intervals of the mesh.
    pub intervals: usize,
    /// Error of its worst interval over what is allowed, where no orbit was found on a finer mesh; absent elsewhere.
    pub mesh_error: Option<f64>,
    /// True if no orbit was found on a mesh fine enough for the pocket forces.
    pub pocket_force_unresolved: bool,
    /// Rate over the cage speed at which the orbit lets axial and radial motion of balls die out besides, where they
    /// swing in their grooves without end; absent where they come to an orbit by themselves.
    pub swing_damping: Option<f64>,
    /// Mass of a ball over that of the case, where balls are too light for their loads to have a definite motion once
    /// nothing presses them; absent where it is the case's.
    pub ball_mass_factor: Option<f64>,
    /// Stiffness of the pockets over that of the case, where no orbit was found with that; absent where it is.
    pub pocket_stiffness_share: Option<f64>,
    /// Damping ratio of the contacts, where no orbit was found with that of the case and [`crate::OrbitSettings`];
    /// absent where it is.
    pub raised_contact_damping: Option<f64>,
    /// Damping of the pockets and that of the case, χ of Hunt and Crossley, s/m, where balls touch their pockets and
    /// the orbit was found with more than the case gives; absent where that has no part.
    pub raised_pocket_damping_s_per_m: Option<[f64; 2]>,
    /// The orbit with the case's own damping of the pockets, where it was asked for and differs.
    pub less_damped: Option<LessDamping>,
    /// True if the inner ring turns without touching a ball, and balls and cage stand still.
    pub undriven: bool,
    /// The balls when they stand where those of an equilibrium do, the first at azimuth 0.
    pub balls: Vec<BallResult>,
    /// A ball round its orbit, every two degrees of azimuth.
    pub points: Vec<BallResult>,
}

/// Sentence on an inner ring that floats.
const FLOATING: &str = "no ball touches the inner race: fluid, cage and outer ring alone move the balls, and where the \
                        inner ring is not held it may be anywhere between them";

impl SteadyOrbit {
    /// The balls of the orbit, or the points round it, in the form of an equilibrium with traction: for figures and
    /// recordings.
    pub fn as_solution(&self, balls: &[BallResult], [inner_speed, outer_speed]: [f64; 2]) -> Solution {
        Solution {
            model: Model::Traction,
            converged: true,
            stable: None,
            cage_speed_rpm: self.cage_speed_rpm,
            ring_displacement_m: self.ring_displacement_m,
            ring_tilt_rad: self.ring_tilt_rad,
            ring_load_n: self.ring_load_n,
            ring_moment_nm: self.ring_moment_nm,
            shaft_torque_nm: Some(self.shaft_torque_nm),
            inner_speed_rad_s: inner_speed,
            outer_speed_rad_s: outer_speed,
            residual: self.residual,
            iterations: self.iterations,
            patch_error_estimate: Some(self.patch_error_estimate),
            warnings: self.warnings(),
            balls: balls.to_vec(),
        }
    }

    /// True if balls are damped, pockets softer or contacts damped more than the case's, for want of another orbit.
    pub fn is_regularized(&self) -> bool {
        [self.swing_damping, self.pocket_stiffness_share, self.raised_contact_damping].iter().any(Option::is_some)
    }

    /// True if balls, pockets and contacts are those of the case, none damped more, heavier or softer.
    pub fn is_of_the_case(&self) -> bool {
        !self.is_regularized() && self.ball_mass_factor.is_none()
    }

    /// Sentences on what is unusual about it.
    pub fn warnings(&self) -> Vec<String> {
        if self.undriven {
            let alone =
                "no load presses a ball on the inner race: the inner ring turns alone, balls and cage stand still";
            return vec![alone.to_owned()];
        }
        let lost = self.points.iter().filter(|p| p.contacts.inner.load_n == 0.0).count();
        let lost = match lost {
            0 => None,
            all if all == self.points.len() => Some(FLOATING.to_owned()),
            lost => {
                let part = 100.0 * lost as f64 / self.points.len() as f64;
                Some(format!("balls have no inner contact over {part:.0} % of their orbit"))
            }
        };
        let swinging = self.swing_damping.map(swinging);
        let regularization = Regularization {
            ball_mass: self.ball_mass_factor.unwrap_or(1.0),
            pocket_stiffness: self.pocket_stiffness_share.unwrap_or(1.0),
            contact_damping: self.raised_contact_damping.unwrap_or(0.0),
        };
        let coarse = self.mesh_error.is_some() || self.pocket_force_unresolved;
        let coarse = coarse.then(|| coarse_sentence(self.mesh_error));
        lost.into_iter().chain(swinging).chain(regularization.sentences()).chain(coarse).collect()
    }

    /// Sentence on the raised damping of the pockets, where it changes something or no orbit with less of it was found.
    pub fn damping_sentence(&self) -> Option<String> {
        let [raised, given] = self.raised_pocket_damping_s_per_m?;
        match self.less_damped {
            Some(less) => less.sentence([self.cage_speed_rpm, self.shaft_torque_nm, self.pocket_force_max_n]),
            None => Some(not_followed(raised, given)),
        }
    }
}

/// A ball as a result, with what a motion has besides an equilibrium.
pub(crate) fn ball_result(system: &OrbitSystem<'_>, azimuth: f64, y: &[f64; BALL], e: &Evaluation) -> BallResult {
    let pocket = &e.friction.pocket;
    let mut ball = BallResult {
        pocket: Some(PocketResult {
            lead_rad: y[LEAD],
            force_n: pocket.force,
            friction_n: Some(pocket.friction),
            wear_rate_m3_s: system.bearing.pocket_wear_rate(pocket.sliding_power()),
        }),
        motion: Some(BallMotionResult {
            orbital_acceleration_rad_s2: e.rate[ORBIT],
            velocity_m_s: [y[VELOCITY], y[VELOCITY + 1]],
        }),
        ..system.bearing.sheet().ball(azimuth, &e.state, &e.loads, system.speeds.inner)
    };
    system.bearing.put_films(std::slice::from_mut(&mut ball));
    ball
}

/// Azimuth, unknowns and forces of a ball at a place round the bearing.
pub(crate) type Placed = (f64, [f64; BALL], Evaluation);

/// A ball at so many even places, the first at azimuth 0.
pub(crate) fn placed(newton: &Newton<'_>, orbit: &Orbit, count: usize) -> impl Iterator<Item = Placed> {
    (0..count).map(move |place| {
        let azimuth = TAU * place as f64 / count as f64;
        let (turn, y) = at_azimuth(newton, orbit, azimuth);
        let system = &newton.system;
        (azimuth, y, system.value(system.azimuth(turn), &y, orbit.cage_speed, orbit.ring))
    })
}

/// The solution of a converged orbit, with the balls where those of an equilibrium stand and the error of their
/// patches.
///
/// # Errors
/// A patch rule that cannot be laid out for the estimate of its error.
pub(crate) fn solution(
    newton: &Newton<'_>,
    at: &Found,
    (balls, patch_error_estimate): (&[Placed], f64),
    (regularization, given): (&Regularization, f64),
) -> SteadyOrbit {
    let (orbit, found) = at;
    let system = &newton.system;
    let means = &found.means;
    let result = |(azimuth, y, e): &Placed| ball_result(system, *azimuth, y, e);
    let points: Vec<BallResult> = placed(newton, orbit, POINTS).map(|at| result(&at)).collect();
    let count = system.bearing.geometry.ball_count as f64;
    let given = [system.cage.pocket.damping, given];
    let touches = pocket_force_max(newton, at);
    let raised = (touches > 0.0 && given[0] > given[1]).then_some(given);
    // A ball may meet its pocket between two points of the result; raised damping makes much of the first touch, which
    // is no force of the case.
    let at_points = points.iter().filter_map(|p| p.pocket).map(|p| p.force_n.abs()).fold(0.0, f64::max);
    let pocket_force_max_n = if raised.is_some() { at_points } else { touches.max(at_points) };
    let [x, y, z, tilt @ ..] = orbit.ring;
    let [fx, fy, fz, moment @ ..] = means.ring;
    SteadyOrbit {
        cage_speed_rpm: orbit.cage_speed * RPM_PER_RAD_S,
        ring_displacement_m: [x, y, z],
        ring_tilt_rad: tilt,
        ring_load_n: [fx, fy, fz].map(|f| count * f),
        ring_moment_nm: moment.map(|m| count * m),
        shaft_torque_nm: shaft_torque(system, orbit, means),
        friction_w: means.friction.map(|w| count * w),
        fluid_w: count * means.fluid,
        pocket_w: count * means.pocket,
        pocket_force_max_n,
        pocket_contact_azimuths_deg: contacts(newton, orbit),
        residual: found.worst.relative,
        patch_error_estimate,
        iterations: newton.statistics.jacobians,
        intervals: orbit.intervals(),
        mesh_error: newton.coarse.and_then(|coarse| coarse.of_motion()),
        pocket_force_unresolved: newton.coarse.is_some_and(|coarse| coarse.hides_pocket_forces()),
        swing_damping: (system.settling > 0.0).then(|| system.settling / orbit.cage_speed.abs()),
        ball_mass_factor: (regularization.ball_mass != 1.0).then_some(regularization.ball_mass),
        pocket_stiffness_share: (regularization.pocket_stiffness != 1.0).then_some(regularization.pocket_stiffness),
        raised_contact_damping: (regularization.contact_damping > 0.0).then_some(regularization.contact_damping),
        raised_pocket_damping_s_per_m: raised,
        less_damped: None,
        undriven: false,
        balls: balls.iter().map(result).collect(),
        points,
    }
}

/// The turn at which a ball is at an azimuth, and its unknowns there.
fn at_azimuth(newton: &Newton<'_>, orbit: &Orbit, azimuth: f64) -> (f64, [f64; BALL]) {
    let mut turn = newton.system.turn(azimuth);
    let mut y = orbit.at(&newton.radau, turn);
    // The lead is small and changes slowly: the iteration contracts.
    for _ in 0..50 {
        let next = newton.system.turn(azimuth - y[LEAD]);
        let moved = (next - turn).abs();
        turn = next;
        y = orbit.at(&newton.radau, turn);
        if moved < 1e-13 {
            break;
        }
    }
    (turn, y)
}

/// Azimuths at which the pocket closes, degrees.
fn contacts(newton: &Newton<'_>, orbit: &Orbit) -> Vec<f64> {
    /// Looks at an interval; closings are then found to the width of an interval over two to the power of halvings.
    const LOOKS: usize = 6;
    const HALVINGS: usize = 12;
    let lead = |turn: f64| orbit.at(&newton.radau, turn)[LEAD];
    let pressed = |turn: f64| newton.system.cage.pocket.penetration(lead(turn)) > 0.0;
    let mut azimuths = Vec::new();
    let mut before = pressed(0.0);
    for j in 0..orbit.intervals() {
        let [begin, width] = orbit.interval(j);
        for look in 1..=LOOKS {
            let after = begin + width * look as f64 / LOOKS as f64;
            let now = pressed(after);
            if now && !before {
                let (mut open, mut closed) = (after - width / LOOKS as f64, after);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (open + closed);
                    *(if pressed(middle) { &mut closed } else { &mut open }) = middle;
                }
                let azimuth = newton.system.azimuth(closed) + lead(closed);
                azimuths.push(azimuth.to_degrees().rem_euclid(360.0));
            }
            before = now;
        }
    }
    azimuths.sort_by(f64::total_cmp);
    azimuths
}
