//! The other equilibria of each ball: a search on request, with the ring held.
//!
//! Past its peak the traction curve falls, so under drag a ball may have a rolling equilibrium, a skidding one, or
//! both, with an unstable one between them. [`crate::solve`] finds the one connected to rolling. Here each ball is
//! followed from several skidding states to where it ends, and each end is judged by the eigenvalues of its rotation
//! and orbit. A lightly loaded ball may also drop out of contact: what presses it on a race is the centrifugal force of
//! its orbit. The search samples states, so it can show that another equilibrium exists but not that none does.

use crate::block::{AXIAL, BALL, BlockSystem, OMEGA, ORBIT, RADIAL, RING};
use crate::jones_harris::{Typical, kinematics};
use crate::problem::QuasiStaticError;
use crate::report::SKIDDING;
use crate::settle::{Evaluated, FROM_AFAR, settle_ball};
use crate::solve::traction_system;
use crate::start::WarmStart;
use crate::with_traction::WithTraction;
use nalgebra::{Matrix2, Matrix4, Matrix4x2};
use serde::{Serialize, Serializer};
use tribodyn_bearing::{BallPose, BallSize, Bearing, OperatingPoint, Races};

/// Orbital speeds at which the search starts, as shares of the rolling one.
const START_SPEEDS: [f64; 6] = [0.0, 0.2, 0.4, 0.6, 0.8, 0.95];
/// Relative residual below which the end of a search is an equilibrium.
const EQUILIBRIUM: f64 = 1e-9;
/// Two equilibria are one where orbit and rotation differ by less than this share of the fastest ring's speed.
const DISTINCT: f64 = 1e-5;

/// One equilibrium of a ball.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Root {
    /// Orbital speed ω_m, rad/s.
    pub orbital_speed_rad_s: f64,
    /// Spin ω relative to the orbiting frame: axial, radial, tangential, rad/s.
    #[serde(flatten, serialize_with = "components")]
    pub angular_velocity_rad_s: [f64; 3],
    /// Inner contact load, N.
    pub load_inner_n: f64,
    /// Outer contact load, N.
    pub load_outer_n: f64,
    /// True if the inner race presses on the ball and so drives it.
    pub driven: bool,
    /// Longitudinal slide-to-roll ratio ξ_x at the inner contact.
    pub slide_to_roll_inner: f64,
    /// Longitudinal slide-to-roll ratio ξ_x at the outer contact.
    pub slide_to_roll_outer: f64,
    /// Largest real part of the eigenvalues of rotation and orbit, 1/s: negative where the equilibrium is stable.
    /// Absent where they cannot be worked out.
    pub growth_rate_per_s: Option<f64>,
}

/// An angular velocity as the fields of a ball.
fn components<S: Serializer>(omega: &[f64; 3], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(
        ["angular_velocity_axial_rad_s", "angular_velocity_radial_rad_s", "angular_velocity_tangential_rad_s"]
            .into_iter()
            .zip(omega),
    )
}

impl Root {
    /// True if a small disturbance dies out.
    pub fn stable(&self) -> bool {
        self.growth_rate_per_s.is_some_and(|rate| rate < 0.0)
    }

    /// True if the ball is driven but skids: an inner slide-to-roll ratio beyond 5 %.
    pub fn skids(&self) -> bool {
        self.driven && self.slide_to_roll_inner.abs() > SKIDDING
    }

    /// True if the ball is driven and rolls.
    pub fn rolls(&self) -> bool {
        self.driven && !self.skids()
    }
}

/// The equilibria of one ball with the ring held.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BallRoots {
    /// Azimuth of the ball, degrees.
    pub azimuth_deg: f64,
    /// The equilibrium of the solution.
    pub solution: Root,
    /// The other equilibria that the search came to, by falling orbital speed.
    pub others: Vec<Root>,
}

/// Searches each ball for other equilibria than the solution's, the ring held at its solved position.
///
/// Costs about as much as a dozen cold solutions. A ball without inner contact has no drive and is not searched.
///
/// # Errors
/// Those of the patch quadrature.
pub fn other_roots(
    bearing: &Bearing,
    point: &OperatingPoint,
    solved: &WarmStart,
) -> Result<Vec<BallRoots>, QuasiStaticError> {
    let typical = Typical::new(bearing, &point.ring, Races { inner: point.inner_speed, outer: point.outer_speed });
    let system = traction_system(bearing, point, typical, solved.rule)?;
    let balls = solved.state.balls.iter().enumerate();
    Ok(balls.map(|(index, &ball)| ball_roots(&system, index, ball, solved.state.ring)).collect())
}

fn ball_roots(system: &WithTraction<'_>, index: usize, ball: [f64; BALL], ring: [f64; RING]) -> BallRoots {
    let solution = root(system, index, ball, ring);
    let mut others: Vec<Root> = Vec::new();
    if solution.driven {
        let (state, loads, _) = system.evaluate(index, ball, ring);
        let pose = loads.pose();
        for start in starts(system, ball, (&pose, &state.size)) {
            let end = settle_ball(system, index, start, ring, EQUILIBRIUM, FROM_AFAR);
            if end.residual > EQUILIBRIUM {
                continue;
            }
            let new = root(system, index, end.ball, ring);
            if !same(&solution, &new, system.speeds) && others.iter().all(|known| !same(known, &new, system.speeds)) {
                others.push(new);
            }
        }
    }
    others.sort_by(|a, b| b.orbital_speed_rad_s.abs().total_cmp(&a.orbital_speed_rad_s.abs()));
    BallRoots { azimuth_deg: system.bearing.azimuth(index).to_degrees(), solution, others }
}

/// Skidding states at the solved position: the orbit slower than rolling, the ball rolling on one race only.
fn starts(
    system: &WithTraction<'_>,
    ball: [f64; BALL],
    (pose, size): (&BallPose, &BallSize),
) -> impl Iterator<Item = [f64; BALL]> {
    let Races { inner: inner_speed, outer: outer_speed } = system.speeds;
    let rolling = kinematics(system.bearing, (pose, size), system.speeds, false, true);
    // Rolling on a race alone, the rotation grows with the speed of the orbit against that race, along the same axis.
    let share = move |orbit: f64, race: f64| {
        let full = rolling.orbital_speed - race;
        if full == 0.0 { 0.0 } else { (orbit - race) / full }
    };
    START_SPEEDS.into_iter().flat_map(move |speed| {
        let orbit = outer_speed + speed * (rolling.orbital_speed - outer_speed);
        [inner_speed, outer_speed].map(|race| {
            let turning = share(orbit, race);
            [
                ball[AXIAL],
                ball[RADIAL],
                turning * rolling.angular_velocity[0],
                turning * rolling.angular_velocity[1],
                0.0,
                orbit,
            ]
        })
    })
}

/// A ball that nothing drives drifts with the fluid; where it does so is one equilibrium.
fn same(a: &Root, b: &Root, speeds: Races<f64>) -> bool {
    if !a.driven || !b.driven {
        return a.driven == b.driven;
    }
    let near = |a: f64, b: f64| (a - b).abs() <= DISTINCT * speeds.inner.abs().max(speeds.outer.abs());
    near(a.orbital_speed_rad_s, b.orbital_speed_rad_s)
        && (0..3).all(|k| near(a.angular_velocity_rad_s[k], b.angular_velocity_rad_s[k]))
}

fn root(system: &WithTraction<'_>, index: usize, ball: [f64; BALL], ring: [f64; RING]) -> Root {
    let (_, loads, _) = system.evaluate(index, ball, ring);
    let radius = system.bearing.geometry.ball_radius();
    Root {
        orbital_speed_rad_s: ball[ORBIT],
        angular_velocity_rad_s: [ball[OMEGA], ball[OMEGA + 1], ball[OMEGA + 2]],
        load_inner_n: loads.contacts.inner.normal.load,
        load_outer_n: loads.contacts.outer.normal.load,
        driven: !system.typical.is_idle(loads.contacts.inner.normal.load),
        slide_to_roll_inner: loads.contacts.inner.slide_to_roll(radius)[0],
        slide_to_roll_outer: loads.contacts.outer.slide_to_roll(radius)[0],
        growth_rate_per_s: growth_rate(system, index, ball, ring, loads.orbit_radius),
    }
}

/// Largest real part of the eigenvalues of the spin–orbit block, the position following at once.
fn growth_rate(
    system: &WithTraction<'_>,
    index: usize,
    ball: [f64; BALL],
    ring: [f64; RING],
    orbit_radius: f64,
) -> Option<f64> {
    let slope = Evaluated::new(system, index, ball, ring).slope;
    let mut position: Matrix2<f64> = slope.fixed_view::<2, 2>(0, 0).into();
    let floating = system.inertia();
    (0..2).for_each(|k| position[(k, k)] -= floating[k]);
    let by_position: Matrix4x2<f64> = slope.fixed_view::<4, 2>(2, 0).into();
    let follows = position.lu().solve(&slope.fixed_view::<2, 4>(0, 2).into_owned())?;
    let reduced: Matrix4<f64> = slope.fixed_view::<4, 4>(2, 2) - by_position * follows;
    // The axial balance accelerates the absolute angular velocity ω_a + ω_m.
    let size = system.bearing.ball_size(index);
    let (j, m) = (system.bearing.inertia_of(&size), system.bearing.mass_of(&size));
    let mut mass = Matrix4::from_diagonal(&[j, j, j, m * orbit_radius].into());
    mass[(0, 3)] = j;
    let rates = mass.lu().solve(&reduced)?;
    // The iteration for eigenvalues would not end on NaN.
    if !rates.iter().all(|v| v.is_finite()) {
        return None;
    }
    let schur = nalgebra::linalg::Schur::try_new(rates, f64::EPSILON, 1000)?;
    Some(schur.complex_eigenvalues().iter().fold(f64::NEG_INFINITY, |most, value| most.max(value.re)))
}

/// Warnings about the roots, by ball, in the manner of [`crate::Solution::warnings`].
pub fn root_warnings(roots: &[BallRoots]) -> Vec<String> {
    roots.iter().enumerate().filter_map(|(index, ball)| warning(index, ball)).collect()
}

fn warning(index: usize, ball: &BallRoots) -> Option<String> {
    let BallRoots { azimuth_deg, solution, others } = ball;
    let name = format!("ball {index} ({azimuth_deg:.0}°)");
    if !solution.driven {
        return Some(format!("{name}: no contact with the inner race, nothing drives the ball"));
    }
    let own = describe(solution);
    let also = match others.as_slice() {
        [] => String::new(),
        others => format!("; also {}", others.iter().map(describe).collect::<Vec<_>>().join(", ")),
    };
    if solution.skids() && !others.iter().any(|root| root.rolls() && root.stable()) {
        return Some(format!("{name}: no rolling equilibrium found, only skidding at {own}{also}"));
    }
    match (others.is_empty(), solution.stable()) {
        (true, true) => None,
        (true, false) => Some(format!("{name}: the equilibrium found is not stable: {own}")),
        (false, _) => Some(format!("{name}: several equilibria: found {own}{also}")),
    }
}

fn describe(root: &Root) -> String {
    let speed = root.orbital_speed_rad_s;
    if !root.driven {
        return format!("{speed:.1} rad/s, out of contact with the inner race");
    }
    let stable = if root.stable() { "stable" } else { "unstable" };
    format!("{speed:.1} rad/s (inner slide-to-roll ratio {:.1} %, {stable})", 100.0 * root.slide_to_roll_inner)
}
