//! From unknowns to a [`Solution`].

use crate::block::{AXIAL, Iterate, RING, SPIN};
use crate::cage::{Pocket, pocket_forces};
use crate::jones_harris::{JonesHarris, kinematics};
use crate::with_traction::WithTraction;
use crate::{BallSolution, Model, Solution};
use tribodyn_bearing::{Bearing, OperatingPoint, RaceContact, Side};
use tribodyn_traction::TractionLaw;

/// Inner slide-to-roll ratio beyond which the ball skids: past the peak of the library's coatings, which lies at 0.1 to
/// 4 % for the slip units in use.
pub(crate) const SKIDDING: f64 = 0.05;

pub(crate) fn jones_harris(system: &JonesHarris<'_>, solved: &Iterate, point: &OperatingPoint) -> Solution {
    let bearing = system.bearing;
    let (mut ring_load, mut ring_moment) = ([0.0; 3], [0.0; 2]);
    let mut balls = Vec::with_capacity(solved.state.balls.len());
    for (index, &ball) in solved.state.balls.iter().enumerate() {
        let pose = system.pose(index, ball, solved.state.ring);
        let k =
            kinematics(bearing, &pose, system.speeds, system.inner_control[index], system.centrifugal_at_free_pitch);
        let (q_i, ellipse_i) = bearing.contact_load(Side::Inner, &pose.contacts.inner);
        let (q_o, ellipse_o) = bearing.contact_load(Side::Outer, &pose.contacts.outer);
        let mut entry = empty_ball(bearing, index);
        fill_contact(&mut entry, Side::Inner, &pose.contacts.inner, q_i, &ellipse_i);
        fill_contact(&mut entry, Side::Outer, &pose.contacts.outer, q_o, &ellipse_o);
        entry.orbital_speed_rad_s = k.orbital_speed;
        entry.orbit_radius_m = pose.orbit_radius;
        entry.axial_displacement_m = axial_displacement(bearing, ball[AXIAL]);
        entry.spin_rad_s = [k.spin[0], k.spin[1], 0.0];
        entry.centrifugal_force_n = k.centrifugal_force;
        entry.gyroscopic_moment_nm = k.gyroscopic_moment.abs();
        fill_rolling(&mut entry, system, &pose);
        balls.push(entry);
        let balance = crate::block::BlockSystem::ball(system, index, ball, solved.state.ring);
        (0..3).for_each(|c| ring_load[c] += balance.ring[c]);
        (0..2).for_each(|c| ring_moment[c] += balance.ring[3 + c]);
    }
    let mut solution = solution(Model::JonesHarris, bearing, solved.state.ring, balls, point);
    (solution.ring_load_n, solution.ring_moment_nm) = (ring_load, ring_moment);
    (solution.residual, solution.iterations) = (solved.worst().residual, solved.statistics.accepted);
    lost_contacts(&mut solution);
    solution
}

/// Spin ratios and rolling speeds of the Jones–Harris kinematics; its slide-to-roll ratios are zero by assumption.
fn fill_rolling(entry: &mut BallSolution, system: &JonesHarris<'_>, pose: &tribodyn_bearing::BallPose) {
    let [axial, radial, _] = entry.spin_rad_s;
    let r_b = system.bearing.geometry.ball_radius();
    let orbit = entry.orbital_speed_rad_s;
    for (side, contact) in pose.contacts.iter() {
        let speed = system.speeds[side];
        let [n_a, n_r] = contact.normal(side);
        let rolling = (axial * n_r - radial * n_a) * r_b;
        let spin = (axial + orbit - speed) * n_a + radial * n_r;
        let ratio = if rolling == 0.0 { 0.0 } else { spin / rolling };
        match side {
            Side::Inner => (entry.rolling_speed_inner_m_s, entry.spin_ratio_inner) = (rolling.abs(), ratio),
            Side::Outer => (entry.rolling_speed_outer_m_s, entry.spin_ratio_outer) = (rolling.abs(), ratio),
        }
    }
}

pub(crate) fn with_traction(
    system: &WithTraction<'_>,
    solved: &Iterate,
    point: &OperatingPoint,
    estimate: f64,
) -> Solution {
    let bearing = system.bearing;
    let mut action = [0.0; 6];
    let mut balls = Vec::with_capacity(solved.state.balls.len());
    let mut clamped = Vec::new();
    for (index, &ball) in solved.state.balls.iter().enumerate() {
        let (state, loads, inner) = system.evaluate(index, ball, solved.state.ring);
        let mut entry = empty_ball(bearing, index);
        fill_race(&mut entry, Side::Inner, &loads.contacts.inner, bearing);
        fill_race(&mut entry, Side::Outer, &loads.contacts.outer, bearing);
        entry.orbital_speed_rad_s = state.orbital_speed;
        entry.orbit_radius_m = loads.orbit_radius;
        entry.axial_displacement_m = axial_displacement(bearing, ball[AXIAL]);
        entry.spin_rad_s = [ball[SPIN], ball[SPIN + 1], ball[SPIN + 2]];
        entry.centrifugal_force_n = bearing.ball_mass * loads.orbit_radius * state.orbital_speed.powi(2);
        entry.gyroscopic_moment_nm =
            (bearing.ball_inertia * state.orbital_speed * ball[SPIN + 1].hypot(ball[SPIN + 2])).abs();
        entry.drag_n = loads.drag;
        let swirl = bearing.fluid.as_ref().map_or(0.0, |f| f.swirl);
        let against_fluid = loads.orbit_radius * (state.orbital_speed - swirl * system.speeds.inner);
        let churning: f64 = loads.churning.iter().zip(state.spin).map(|(m, w)| -m * w).sum();
        entry.power_loss_fluid_w = loads.drag * against_fluid + churning;
        let out_of_range = |contact: &RaceContact, side| {
            let law = bearing.tribology.as_ref().map(|t| &t.laws[side]);
            contact.normal.load > 0.0 && law.is_some_and(|law| law.clamps(contact.ellipse.peak_pressure))
        };
        if out_of_range(&loads.contacts.inner, Side::Inner) || out_of_range(&loads.contacts.outer, Side::Outer) {
            clamped.push(index);
        }
        let on_ring = bearing.ring_action(&state, &loads, &inner);
        (0..6).for_each(|c| action[c] += on_ring[c]);
        balls.push(entry);
    }
    let mut solution = solution(Model::Traction, bearing, solved.state.ring, balls, point);
    let [x, y, z, mx, my, torque] = action;
    (solution.ring_load_n, solution.ring_moment_nm, solution.shaft_torque_nm) = ([x, y, z], [mx, my], torque);
    (solution.residual, solution.iterations) = (solved.worst().residual, solved.statistics.accepted);
    solution.patch_error_estimate = Some(estimate);
    if !clamped.is_empty() {
        let text = "pressure outside the range of the coating's data, clamped";
        solution.warnings.push(format!("{text}: {}", name_balls(&solution, &clamped)));
    }
    lost_contacts(&mut solution);
    skidding(&mut solution);
    solution
}

fn axial_displacement(bearing: &Bearing, axial: f64) -> f64 {
    let g = &bearing.geometry;
    axial - g.groove_offset(Side::Outer) * g.sin_contact_angle()
}

fn solution(
    model: Model,
    bearing: &Bearing,
    ring: [f64; RING],
    mut balls: Vec<BallSolution>,
    point: &OperatingPoint,
) -> Solution {
    let speeds: Vec<f64> = balls.iter().map(|b| b.orbital_speed_rad_s).collect();
    let radius = 0.5 * bearing.geometry.pitch_diameter;
    if let Some(cage) = &point.cage {
        let pocket = Pocket {
            stiffness: cage.pocket_stiffness,
            clearance: cage.pocket_gap / radius,
            radius,
            drag_torque: cage.drag_torque,
        };
        let pockets = pocket_forces(&speeds, &pocket);
        for ((ball, lead), force) in balls.iter_mut().zip(pockets.lead).zip(pockets.force) {
            let [axial, radial, _] = ball.spin_rad_s;
            let sliding = axial.hypot(radial) * bearing.geometry.ball_radius();
            ball.pocket_lead_rad = lead;
            ball.cage_force_n = force;
            ball.wear_rate_cage_m3_s = bearing.pocket_wear_rate(force.abs() * sliding);
        }
    }
    let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
    Solution {
        model,
        converged: true,
        cage_speed_rpm: mean * 30.0 / std::f64::consts::PI,
        ring_displacement_m: [ring[0], ring[1], ring[2]],
        ring_tilt_rad: [ring[3], ring[4]],
        ring_load_n: [0.0; 3],
        ring_moment_nm: [0.0; 2],
        shaft_torque_nm: 0.0,
        inner_speed_rad_s: point.inner_speed,
        outer_speed_rad_s: point.outer_speed,
        residual: 0.0,
        iterations: 0,
        patch_error_estimate: None,
        warnings: Vec::new(),
        balls,
    }
}

fn fill_contact(
    entry: &mut BallSolution,
    side: Side,
    pose: &tribodyn_bearing::ContactPose,
    load: f64,
    ellipse: &tribodyn_bearing::Ellipse,
) {
    let angle = pose.sin.atan2(pose.cos).to_degrees();
    let axes = [ellipse.semi_lateral(), ellipse.semi_rolling()];
    let pressure = ellipse.peak_pressure;
    match side {
        Side::Inner => {
            (entry.contact_angle_inner_deg, entry.load_inner_n) = (angle, load);
            (entry.approach_inner_m, entry.peak_pressure_inner_pa) = (pose.approach, pressure);
            entry.semi_axes_inner_m = axes;
        }
        Side::Outer => {
            (entry.contact_angle_outer_deg, entry.load_outer_n) = (angle, load);
            (entry.approach_outer_m, entry.peak_pressure_outer_pa) = (pose.approach, pressure);
            entry.semi_axes_outer_m = axes;
        }
    }
}

fn fill_race(entry: &mut BallSolution, side: Side, contact: &RaceContact, bearing: &Bearing) {
    fill_contact(entry, side, &contact.normal.pose, contact.normal.load, &contact.ellipse);
    let [along, across, spin] = contact.slide_to_roll(bearing.geometry.ball_radius());
    let t = &contact.traction;
    let speed = contact.rolling_speed.abs();
    match side {
        Side::Inner => {
            (entry.traction_inner_n, entry.lateral_traction_inner_n) = (t.force_rolling, t.force_lateral);
            (entry.slide_to_roll_inner, entry.lateral_slide_to_roll_inner) = (along, across);
            (entry.spin_ratio_inner, entry.rolling_speed_inner_m_s) = (spin, speed);
            entry.power_loss_inner_w = t.power;
            entry.wear_rate_inner_m3_s = bearing.wear_rate(Side::Inner, t.wear_integral);
        }
        Side::Outer => {
            (entry.traction_outer_n, entry.lateral_traction_outer_n) = (t.force_rolling, t.force_lateral);
            (entry.slide_to_roll_outer, entry.lateral_slide_to_roll_outer) = (along, across);
            (entry.spin_ratio_outer, entry.rolling_speed_outer_m_s) = (spin, speed);
            entry.power_loss_outer_w = t.power;
            entry.wear_rate_outer_m3_s = bearing.wear_rate(Side::Outer, t.wear_integral);
        }
    }
}

fn name_balls(solution: &Solution, indices: &[usize]) -> String {
    let name = |&i: &usize| format!("ball {i} ({:.0}°)", solution.balls[i].azimuth_deg);
    indices.iter().map(name).collect::<Vec<_>>().join(", ")
}

fn warn(solution: &mut Solution, text: &str, is: impl Fn(&BallSolution) -> bool) {
    let indices: Vec<usize> = (0..solution.balls.len()).filter(|&i| is(&solution.balls[i])).collect();
    if !indices.is_empty() {
        let warning = format!("{text}: {}", name_balls(solution, &indices));
        solution.warnings.push(warning);
    }
}

fn lost_contacts(solution: &mut Solution) {
    warn(solution, "no contact with the inner race, nothing drives the ball", |b| b.load_inner_n <= 0.0);
    warn(solution, "no contact with the outer race", |b| b.load_outer_n <= 0.0);
}

fn skidding(solution: &mut Solution) {
    warn(solution, "no rolling equilibrium, the ball skids (inner slide-to-roll ratio beyond 5 %)", |b| {
        b.load_inner_n > 0.0 && b.slide_to_roll_inner.abs() > SKIDDING
    });
}

fn empty_ball(bearing: &Bearing, index: usize) -> BallSolution {
    BallSolution { azimuth_deg: bearing.azimuth(index).to_degrees(), ..BallSolution::default() }
}
