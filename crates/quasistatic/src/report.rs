//! From unknowns to a [`Solution`].

use crate::block::{AXIAL, Iterate, RING};
use crate::cage::{Pocket, pocket_forces};
use crate::jones_harris::{JonesHarris, Kinematics, kinematics};
use crate::with_traction::WithTraction;
use crate::{Model, Solution};
use tribodyn_bearing::{
    BallPlace, BallResult, BallSize, Bearing, Cage, ContactPose, ContactResult, OperatingPoint, PocketForce,
    PocketResult, RaceControl,
};
use tribodyn_bearing::{Races, Sheet, Side};

/// Inner slide-to-roll ratio beyond which the ball skids: past the peak of the library's coatings, which lies at 0.1 to
/// 4 % for the slip units in use.
pub(crate) const SKIDDING: f64 = 0.05;

pub(crate) fn jones_harris(system: &JonesHarris<'_>, solved: &Iterate, point: &OperatingPoint) -> Solution {
    let bearing = system.bearing;
    let (mut ring_load, mut ring_moment) = ([0.0; 3], [0.0; 2]);
    let sheet = bearing.sheet();
    let mut balls = Vec::with_capacity(solved.state.balls.len());
    for (index, &ball) in solved.state.balls.iter().enumerate() {
        let pose = system.pose(index, ball, solved.state.ring);
        let (size, control) = (bearing.ball_size(index), system.inner_control[index]);
        let k = kinematics(bearing, (&pose, &size), system.speeds, control, system.centrifugal_at_free_pitch);
        let contacts = Races::from_fn(|side| {
            let contact = &pose.contacts[side];
            let (load, ellipse) = bearing.contact_load(side, contact);
            Sheet::contact(contact, (load, &ellipse), rolling(system, (&k, &size), side, contact))
        });
        let place = BallPlace {
            azimuth: bearing.azimuth(index),
            axial: ball[AXIAL],
            orbit_radius: pose.orbit_radius,
            orbital_speed: k.orbital_speed,
            angular_velocity: [k.angular_velocity[0], k.angular_velocity[1], 0.0],
            size,
        };
        balls.push(BallResult {
            // As the model has it, which may take the free pitch radius.
            centrifugal_force_n: k.centrifugal_force,
            ..sheet.place(&place, contacts)
        });
        let balance = crate::block::BlockSystem::ball(system, index, ball, solved.state.ring);
        (0..3).for_each(|c| ring_load[c] += balance.ring[c]);
        (0..2).for_each(|c| ring_moment[c] += balance.ring[3 + c]);
    }
    let mut solution = solution(Model::JonesHarris, bearing, solved.state.ring, balls, point);
    (solution.ring_load_n, solution.ring_moment_nm) = (ring_load, ring_moment);
    (solution.residual, solution.iterations) = (solved.worst().residual, solved.statistics.accepted);
    judged(&mut solution, solved);
    lost_contacts(&mut solution);
    let released = system.inner_control.iter().filter(|inner| !**inner).count();
    if bearing.modelling.race_control == Some(RaceControl::Inner) && released > 0 {
        solution.warnings.push(format!(
            "raceway control by the inner race for all balls has no equilibrium that was found: {released} of {} balls, \
             which it does not touch without gyroscopic moments, run with the outer race",
            system.inner_control.len()
        ));
    }
    solution
}

/// Rolling speed (m/s) and spin ratio (1/m) of the Jones–Harris kinematics, which slide nowhere else.
fn rolling(
    system: &JonesHarris<'_>,
    (k, ball): (&Kinematics<f64>, &BallSize),
    side: Side,
    contact: &ContactPose,
) -> [f64; 2] {
    let [axial, radial] = k.angular_velocity;
    let [n_a, n_r] = contact.normal(side);
    let rolling = (axial * n_r - radial * n_a) * (system.bearing.geometry.ball_radius() + ball.excess);
    let spin = (axial + k.orbital_speed - system.speeds[side]) * n_a + radial * n_r;
    [rolling, if rolling == 0.0 { 0.0 } else { spin / rolling }]
}

pub(crate) fn with_traction(
    system: &WithTraction<'_>,
    solved: &Iterate,
    point: &OperatingPoint,
    estimate: f64,
) -> Solution {
    let bearing = system.bearing;
    let mut action = [0.0; 6];
    let sheet = bearing.sheet();
    let mut balls = Vec::with_capacity(solved.state.balls.len());
    for (index, &ball) in solved.state.balls.iter().enumerate() {
        let (state, loads, inner) = system.evaluate(index, ball, solved.state.ring);
        balls.push(sheet.ball(bearing.azimuth(index), &state, &loads, system.speeds.inner));
        let on_ring = bearing.ring_action(&state, &loads, &inner);
        (0..6).for_each(|c| action[c] += on_ring[c]);
    }
    bearing.put_films(&mut balls);
    let mut solution = solution(Model::Traction, bearing, solved.state.ring, balls, point);
    let [x, y, z, mx, my, torque] = action;
    (solution.ring_load_n, solution.ring_moment_nm, solution.shaft_torque_nm) = ([x, y, z], [mx, my], Some(torque));
    (solution.residual, solution.iterations) = (solved.worst().residual, solved.statistics.accepted);
    solution.patch_error_estimate = Some(estimate);
    judged(&mut solution, solved);
    lost_contacts(&mut solution);
    if solution.turns() {
        skidding(&mut solution);
    }
    solution
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Orbital speeds of the balls, rad/s. With traction a ball without load at one of the races stands still, as nothing
/// drives it; the cage carries it along at the mean of the others.
fn carried(model: Model, balls: &[BallResult]) -> Vec<f64> {
    let loaded: Vec<f64> = balls.iter().filter(|b| b.is_loaded()).map(|b| b.orbital_speed_rad_s).collect();
    let own = |b: &BallResult| model != Model::Traction || loaded.is_empty() || b.is_loaded();
    balls.iter().map(|b| if own(b) { b.orbital_speed_rad_s } else { mean(&loaded) }).collect()
}

/// Torque of the fluid against a cage at a speed, rad/s, N m.
fn churned(bearing: &Bearing, cage: &Cage, speed: f64, inner_speed: f64) -> f64 {
    let swirl = bearing.fluid.as_ref().map_or(0.0, |fluid| fluid.swirl);
    cage.churning(bearing).map_or(0.0, |churning| churning.moments(speed - swirl * inner_speed).sum())
}

fn solution(
    model: Model,
    bearing: &Bearing,
    ring: [f64; RING],
    mut balls: Vec<BallResult>,
    point: &OperatingPoint,
) -> Solution {
    let speeds = carried(model, &balls);
    let radius = 0.5 * bearing.geometry.pitch_diameter;
    // Where the rings do not turn against each other, speeds of the balls are what rounding leaves.
    let turns = point.inner_speed != point.outer_speed;
    if let Some(cage) = point.cage.as_ref().filter(|_| turns) {
        let pocket = Pocket {
            stiffness: cage.pocket_stiffness,
            clearance: cage.pocket_gap / radius,
            radius,
            drag_torque: cage.drag_torque + churned(bearing, cage, mean(&speeds), point.inner_speed),
            force: bearing.modelling.pocket_force.unwrap_or(PocketForce::FromWall),
        };
        let pockets = pocket_forces(&speeds, &pocket);
        for ((ball, lead), force) in balls.iter_mut().zip(pockets.lead).zip(pockets.force) {
            let [axial, radial, _] = ball.angular_velocity_rad_s;
            let sliding = axial.hypot(radial) * bearing.geometry.ball_radius();
            let wear_rate_m3_s = bearing.pocket_wear_rate(force.abs() * sliding);
            ball.pocket = Some(PocketResult { lead_rad: lead, force_n: force, friction_n: None, wear_rate_m3_s });
        }
    }
    let mean = if turns { mean(&speeds) } else { point.outer_speed };
    Solution {
        model,
        converged: true,
        stable: None,
        cage_speed_rpm: mean * 30.0 / std::f64::consts::PI,
        ring_displacement_m: [ring[0], ring[1], ring[2]],
        ring_tilt_rad: [ring[3], ring[4]],
        ring_load_n: [0.0; 3],
        ring_moment_nm: [0.0; 2],
        shaft_torque_nm: None,
        inner_speed_rad_s: point.inner_speed,
        outer_speed_rad_s: point.outer_speed,
        residual: 0.0,
        iterations: 0,
        patch_error_estimate: None,
        warnings: Vec::new(),
        balls,
    }
}

fn name_balls(solution: &Solution, indices: &[usize]) -> String {
    let name = |&i: &usize| format!("ball {i} ({:.0}°)", solution.balls[i].azimuth_rad.to_degrees());
    indices.iter().map(name).collect::<Vec<_>>().join(", ")
}

fn warn(solution: &mut Solution, text: &str, is: impl Fn(&BallResult) -> bool) {
    let indices: Vec<usize> = (0..solution.balls.len()).filter(|&i| is(&solution.balls[i])).collect();
    if !indices.is_empty() {
        let warning = format!("{text}: {}", name_balls(solution, &indices));
        solution.warnings.push(warning);
    }
}

fn judged(solution: &mut Solution, solved: &Iterate) {
    solution.stable = solved.stable;
    if solved.stable == Some(false) {
        let text =
            "the equilibrium is not stable: a small push takes the ring away from it, and no stable one was found";
        solution.warnings.push(text.to_owned());
    }
}

/// At rest there is nothing to drive: a ball out of the load zone is as it should be.
fn lost_contacts(solution: &mut Solution) {
    if solution.inner_speed_rad_s == 0.0 && solution.outer_speed_rad_s == 0.0 {
        return;
    }
    warn(solution, "no contact with the inner race, nothing drives the ball", |b| b.contacts.inner.load_n <= 0.0);
    warn(solution, "no contact with the outer race", |b| b.contacts.outer.load_n <= 0.0);
}

/// A driven ball beyond the limit.
fn skids(contact: &ContactResult) -> bool {
    contact.load_n > 0.0 && contact.friction_or_nan().slide_to_roll[0].abs() > SKIDDING
}

fn skidding(solution: &mut Solution) {
    warn(solution, "no rolling equilibrium, the ball skids (inner slide-to-roll ratio beyond 5 %)", |b| {
        skids(&b.contacts.inner)
    });
}
