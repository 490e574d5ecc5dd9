//! A bearing at rest: the elastic equilibrium, balls where they stand.

use crate::OrbitError;
use crate::means::Means;
use crate::newton::OrbitStatistics;
use crate::solution::{SteadyOrbit, ball_result};
use crate::solved::SolvedOrbit;
use crate::system::{BALL, OrbitSystem};
use tribodyn_bearing::{BallResult, Bearing, CageBody, OperatingPoint, Races, RingFreedom, RingOffset};
use tribodyn_quasistatic::{RollingStart, rolling_start};
use tribodyn_traction::FastPatch;

/// Load on the inner race that counts as none, over the diameter of a ball squared, Pa.
const UNLOADED: f64 = 1e-4;

/// The bearing where nothing drives a ball: an outer ring that stands still, and an inner one that turns without load
/// and touches none. Balls and cage then stand still too.
pub(crate) fn standing(bearing: &Bearing, point: &OperatingPoint, cage: &CageBody) -> Option<SolvedOrbit> {
    let loaded = |freedom: &RingFreedom| matches!(freedom, RingFreedom::Loaded(load) if *load != 0.0);
    let swirls = bearing.fluid.as_ref().is_some_and(|fluid| fluid.swirl != 0.0);
    let [guidance, _] = cage.fluid_torques(0.0, Races { inner: point.inner_speed, outer: point.outer_speed });
    let driven = point.outer_speed != 0.0 || swirls || guidance != 0.0;
    if driven || point.inner_speed == 0.0 || point.ring.iter().any(loaded) {
        return None;
    }
    let bearing = &to_first_order(bearing);
    let rolling = rolling_start(bearing, &OperatingPoint { inner_speed: 0.0, ..point.clone() }).ok()?;
    let pressed: f64 = rolling.inner_loads.iter().sum();
    let kernel = FastPatch::new(rolling.rule).ok()?;
    let free = pressed < UNLOADED * bearing.geometry.ball_diameter.powi(2);
    free.then(|| {
        let mut solved = at_rest(bearing, point, cage, (&rolling, kernel));
        solved.solution.undriven = true;
        solved
    })
}

/// The bearing at rest with the offsets of its rings to first order, of which the elastic equilibrium knows.
pub(crate) fn still(bearing: &Bearing, point: &OperatingPoint, cage: &CageBody) -> Result<SolvedOrbit, OrbitError> {
    let bearing = &to_first_order(bearing);
    let rolling = rolling_start(bearing, point)?;
    let kernel = FastPatch::new(rolling.rule)?;
    Ok(at_rest(bearing, point, cage, (&rolling, kernel)))
}

fn to_first_order(bearing: &Bearing) -> Bearing {
    Bearing { ring_offset: RingOffset::FirstOrder, ..bearing.clone() }
}

/// The start's equilibrium as a solution; nothing moves, so nothing rubs.
fn at_rest(
    bearing: &Bearing,
    point_of: &OperatingPoint,
    cage: &CageBody,
    (start, kernel): (&RollingStart, FastPatch),
) -> SolvedOrbit {
    let system = OrbitSystem {
        bearing,
        surfaces: bearing.surfaces(),
        cage: *cage,
        speeds: Races { inner: point_of.inner_speed, outer: point_of.outer_speed },
        ring: point_of.ring,
        kernel,
        origin: 0.0,
        direction: 1.0,
        centring: 0.0,
        settling: 0.0,
        held: None,
    };
    let mut means = Means::default();
    let at = |(index, ball): (usize, &tribodyn_quasistatic::BallMotion)| {
        let (azimuth, mut y) = (bearing.azimuth(index), [0.0; BALL]);
        y[..2].copy_from_slice(&ball.position);
        let e = system.value(azimuth, &y, 0.0, start.ring);
        means.add(&e, 1.0);
        ball_result(&system, azimuth, &y, &e)
    };
    let balls: Vec<BallResult> = start.balls.iter().enumerate().map(at).collect();
    let [x, y, z, tilt @ ..] = start.ring;
    let [fx, fy, fz, moment @ ..] = means.ring;
    let solution = SteadyOrbit {
        cage_speed_rpm: 0.0,
        ring_displacement_m: [x, y, z],
        ring_tilt_rad: tilt,
        ring_load_n: [fx, fy, fz],
        ring_moment_nm: moment,
        shaft_torque_nm: 0.0,
        friction_w: [0.0; 2],
        fluid_w: 0.0,
        pocket_w: 0.0,
        pocket_force_max_n: 0.0,
        pocket_contact_azimuths_deg: Vec::new(),
        residual: start.residual,
        patch_error_estimate: start.rule_error,
        iterations: 0,
        intervals: 0,
        mesh_error: None,
        pocket_force_unresolved: false,
        swing_damping: None,
        ball_mass_factor: None,
        pocket_stiffness_share: None,
        raised_contact_damping: None,
        raised_pocket_damping_s_per_m: None,
        less_damped: None,
        undriven: false,
        points: balls.clone(),
        balls,
    };
    SolvedOrbit { solution, statistics: OrbitStatistics::default(), start: None }
}
