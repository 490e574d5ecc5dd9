//! Results of a steady orbit.

use crate::collocation::Orbit;
use crate::newton::Newton;
use crate::system::{BALL, Evaluation, LEAD, ORBIT};
use serde::Serialize;
use std::f64::consts::TAU;
use tribodyn_bearing::Side;

/// Places round the orbit at which a solution is given: every two degrees.
pub const POINTS: usize = 180;

/// r/min per rad/s.
const RPM_PER_RAD_S: f64 = 60.0 / TAU;

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
    /// Largest pocket force of either direction, N.
    pub pocket_force_max_n: f64,
    /// Azimuths at which a ball meets a wall of its pocket, degrees.
    pub pocket_contact_azimuths_deg: Vec<f64>,
    /// Largest relative residual of all balances.
    pub residual: f64,
    /// Estimated quadrature error of the traction force over the load, against a finer rule.
    pub patch_error_estimate: f64,
    /// Intervals of the mesh.
    pub intervals: usize,
    /// Estimated relative error of the cage speed by the mesh, where the orbit is of first order only: balls that lose their contacts
    /// and meet their pockets abruptly leave no other; absent where three points an interval make it negligible.
    pub cage_speed_error: Option<f64>,
    /// A ball round its orbit, by azimuth.
    pub points: Vec<OrbitPoint>,
}

/// One ball at one azimuth. Vectors are (axial, radial, tangential) in its azimuth frame.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct OrbitPoint {
    /// Azimuth, degrees.
    pub azimuth_deg: f64,
    /// Inner contact angle, degrees.
    pub contact_angle_inner_deg: f64,
    /// Outer contact angle, degrees.
    pub contact_angle_outer_deg: f64,
    /// Inner contact load, N.
    pub load_inner_n: f64,
    /// Outer contact load, N.
    pub load_outer_n: f64,
    /// Inner peak pressure, Pa.
    pub peak_pressure_inner_pa: f64,
    /// Outer peak pressure, Pa.
    pub peak_pressure_outer_pa: f64,
    /// Orbital speed, rad/s.
    pub orbital_speed_rad_s: f64,
    /// Absolute spin, rad/s.
    pub spin_rad_s: [f64; 3],
    /// Lead of the ball over the middle of its pocket, rad.
    pub pocket_lead_rad: f64,
    /// Pocket force on the ball along the orbit, N.
    pub pocket_force_n: f64,
    /// Traction on the ball along the orbit at the inner contact, N.
    pub traction_inner_n: f64,
    /// Traction on the ball along the orbit at the outer contact, N.
    pub traction_outer_n: f64,
    /// Frictional power of the inner contact, W.
    pub power_inner_w: f64,
    /// Frictional power of the outer contact, W.
    pub power_outer_w: f64,
}

/// Means over the turn of what all balls do.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Means {
    pub ring: [f64; 5],
    pub torque: f64,
    pub friction: [f64; 2],
    pub fluid: f64,
    pub pocket: f64,
}

impl Means {
    /// Adds a ball with a weight.
    pub fn add(&mut self, e: &Evaluation, weight: f64) {
        self.ring.iter_mut().zip(e.ring).for_each(|(sum, f)| *sum += weight * f);
        self.torque += weight * e.torque;
        for side in Side::BOTH {
            self.friction[side as usize] += weight * e.loads.contacts[side].traction.power;
        }
        let churning: f64 = e.friction.churning.iter().zip(e.state.spin).map(|(m, w)| m * w).sum();
        self.fluid += weight * (e.friction.drag * e.loads.orbit_radius * e.state.orbital_speed - churning);
        self.pocket += weight * (e.friction.pocket.friction_power + e.friction.pocket.damping_power);
    }
}

pub(crate) fn point(azimuth: f64, y: &[f64; BALL], e: &Evaluation) -> OrbitPoint {
    let [i, o] = Side::BOTH.map(|side| &e.loads.contacts[side]);
    let angle = |c: &tribodyn_bearing::RaceContact| c.normal.pose.sin.atan2(c.normal.pose.cos).to_degrees();
    OrbitPoint {
        azimuth_deg: azimuth.to_degrees(),
        contact_angle_inner_deg: angle(i),
        contact_angle_outer_deg: angle(o),
        load_inner_n: i.normal.load,
        load_outer_n: o.normal.load,
        peak_pressure_inner_pa: i.ellipse.peak_pressure,
        peak_pressure_outer_pa: o.ellipse.peak_pressure,
        orbital_speed_rad_s: y[ORBIT],
        spin_rad_s: e.state.spin,
        pocket_lead_rad: y[LEAD],
        pocket_force_n: e.friction.pocket.force,
        traction_inner_n: i.traction_force[2],
        traction_outer_n: o.traction_force[2],
        power_inner_w: i.traction.power,
        power_outer_w: o.traction.power,
    }
}

/// The solution of a converged orbit.
pub(crate) fn solution(
    newton: &Newton<'_>,
    orbit: &Orbit,
    (residual, rule_error, cage_speed_error): (f64, f64, Option<f64>),
) -> SteadyOrbit {
    let (system, radau) = (&newton.system, &newton.radau);
    let balls = system.bearing.geometry.ball_count as f64;
    let mut means = Means::default();
    for j in 0..orbit.intervals() {
        let [begin, width] = orbit.interval(j);
        for i in 0..radau.stages {
            let azimuth = system.azimuth(begin + radau.points[i] * width);
            let e = system.value(azimuth, &orbit.values[j][i], orbit.cage_speed, orbit.ring);
            means.add(&e, balls * width * radau.weights[i]);
        }
    }
    let points: Vec<OrbitPoint> = (0..POINTS)
        .map(|n| {
            let azimuth = TAU * n as f64 / POINTS as f64;
            let (turn, y) = at_azimuth(newton, orbit, azimuth);
            let e = system.value(system.azimuth(turn), &y, orbit.cage_speed, orbit.ring);
            point(azimuth, &y, &e)
        })
        .collect();
    let [x, y, z, tilt @ ..] = orbit.ring;
    let [fx, fy, fz, moment @ ..] = means.ring;
    SteadyOrbit {
        cage_speed_rpm: orbit.cage_speed * RPM_PER_RAD_S,
        ring_displacement_m: [x, y, z],
        ring_tilt_rad: tilt,
        ring_load_n: [fx, fy, fz],
        ring_moment_nm: moment,
        shaft_torque_nm: means.torque,
        friction_w: means.friction,
        fluid_w: means.fluid,
        pocket_w: means.pocket,
        pocket_force_max_n: points.iter().map(|p| p.pocket_force_n.abs()).fold(0.0, f64::max),
        pocket_contact_azimuths_deg: contacts(newton, orbit),
        residual,
        patch_error_estimate: rule_error,
        intervals: orbit.intervals(),
        cage_speed_error,
        points,
    }
}

/// The turn at which a ball is at an azimuth, and its unknowns there.
fn at_azimuth(newton: &Newton<'_>, orbit: &Orbit, azimuth: f64) -> (f64, [f64; BALL]) {
    let mut turn = newton.system.direction * azimuth / TAU;
    let mut y = orbit.at(&newton.radau, turn);
    // The lead is small and changes slowly: the iteration contracts.
    for _ in 0..50 {
        let next = newton.system.direction * (azimuth - y[LEAD]) / TAU;
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
    const LOOKS: usize = 7200;
    let look = |n: usize| {
        let turn = n as f64 / LOOKS as f64;
        let lead = orbit.at(&newton.radau, turn)[LEAD];
        let azimuth = (newton.system.azimuth(turn) + lead).to_degrees().rem_euclid(360.0);
        (azimuth, newton.system.cage.pocket.penetration(lead) > 0.0)
    };
    let looks: Vec<_> = (0..LOOKS).map(look).collect();
    let closes = |n: &usize| !looks[*n].1 && looks[(*n + 1) % LOOKS].1;
    (0..LOOKS).filter(closes).map(|n| looks[(n + 1) % LOOKS].0).collect()
}
