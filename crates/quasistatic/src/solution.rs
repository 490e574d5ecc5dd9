//! Results of a quasi-static solution: names and units as in the `--json` output of `tribodyn solve`.

use serde::Serialize;

/// Which equations were solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Model {
    /// Jones–Harris with raceway control.
    JonesHarris,
    /// Six balances per ball with the traction integrals of both contacts.
    Traction,
}

/// The equilibrium of ring and balls.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Solution {
    /// Which equations were solved.
    pub model: Model,
    /// True if every balance is within the tolerance.
    pub converged: bool,
    /// Mean orbital speed of the balls, r/min.
    pub cage_speed_rpm: f64,
    /// Displacement of the inner ring against the outer: x, y (radial), z (axial), m.
    pub ring_displacement_m: [f64; 3],
    /// Tilt of the inner ring about X and Y, rad.
    pub ring_tilt_rad: [f64; 2],
    /// Force that the inner ring puts on the balls: x, y, z, N. Equal to the load where the ring is loaded.
    pub ring_load_n: [f64; 3],
    /// Moment that the inner ring puts on the balls about X and Y, N m.
    pub ring_moment_nm: [f64; 2],
    /// Torque that the shaft needs, N m, against rotation at the inner ring's speed.
    pub shaft_torque_nm: f64,
    /// Speed of the inner ring, rad/s.
    pub inner_speed_rad_s: f64,
    /// Speed of the outer ring, rad/s.
    pub outer_speed_rad_s: f64,
    /// Largest relative residual of all balances.
    pub residual: f64,
    /// Newton steps taken.
    pub iterations: usize,
    /// Estimated quadrature error of the traction force over the load, against a finer rule; absent for Jones–Harris.
    pub patch_error_estimate: Option<f64>,
    /// Warnings: clamped pressure range, lost contacts, several or no roots, by ball.
    pub warnings: Vec<String>,
    /// One entry per ball, by azimuth.
    pub balls: Vec<BallSolution>,
}

/// One ball in equilibrium. Vectors are (axial, radial, tangential) in the ball's azimuth frame.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct BallSolution {
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
    /// Inner elastic approach, m.
    pub approach_inner_m: f64,
    /// Outer elastic approach, m.
    pub approach_outer_m: f64,
    /// Inner peak pressure, Pa.
    pub peak_pressure_inner_pa: f64,
    /// Outer peak pressure, Pa.
    pub peak_pressure_outer_pa: f64,
    /// Semi-axes of the inner contact: across the groove, along rolling, m.
    pub semi_axes_inner_m: [f64; 2],
    /// Semi-axes of the outer contact: across the groove, along rolling, m.
    pub semi_axes_outer_m: [f64; 2],
    /// Orbital speed ω_m, rad/s.
    pub orbital_speed_rad_s: f64,
    /// Radius of the orbit of the ball centre about the bearing axis, m.
    pub orbit_radius_m: f64,
    /// Axial position of the ball centre against the unloaded one, m.
    pub axial_displacement_m: f64,
    /// Spin ω relative to the orbiting frame: axial, radial, tangential, rad/s.
    pub spin_rad_s: [f64; 3],
    /// Centrifugal force, N.
    pub centrifugal_force_n: f64,
    /// Gyroscopic moment (magnitude), N m.
    pub gyroscopic_moment_nm: f64,
    /// Fluid drag, N, positive against the orbit.
    pub drag_n: f64,
    /// Longitudinal (rolling direction e_t) traction on the ball at the inner contact, N.
    pub traction_inner_n: f64,
    /// Longitudinal traction on the ball at the outer contact, N.
    pub traction_outer_n: f64,
    /// Lateral traction on the ball at the inner contact, N.
    pub lateral_traction_inner_n: f64,
    /// Lateral traction on the ball at the outer contact, N.
    pub lateral_traction_outer_n: f64,
    /// Longitudinal slide-to-roll ratio ξ_x at the inner contact (paper's Eq. 3).
    pub slide_to_roll_inner: f64,
    /// Longitudinal slide-to-roll ratio ξ_x at the outer contact.
    pub slide_to_roll_outer: f64,
    /// Lateral slide-to-roll ratio ξ_y at the inner contact.
    pub lateral_slide_to_roll_inner: f64,
    /// Lateral slide-to-roll ratio ξ_y at the outer contact.
    pub lateral_slide_to_roll_outer: f64,
    /// Spin ratio φ at the inner contact, 1/m.
    pub spin_ratio_inner: f64,
    /// Spin ratio φ at the outer contact, 1/m.
    pub spin_ratio_outer: f64,
    /// Rolling speed V at the inner contact, m/s.
    pub rolling_speed_inner_m_s: f64,
    /// Rolling speed V at the outer contact, m/s.
    pub rolling_speed_outer_m_s: f64,
    /// Frictional power at the inner contact, W.
    pub power_loss_inner_w: f64,
    /// Frictional power at the outer contact, W.
    pub power_loss_outer_w: f64,
    /// Power taken by drag and churning, W.
    pub power_loss_fluid_w: f64,
    /// Archard wear rate at the inner race, m³/s.
    pub wear_rate_inner_m3_s: f64,
    /// Archard wear rate at the outer race, m³/s.
    pub wear_rate_outer_m3_s: f64,
    /// Lead of the ball over its cage pocket, rad (negative: it lags).
    pub pocket_lead_rad: f64,
    /// Cage pocket force on the ball along the orbit, N (negative: it retards the ball).
    pub cage_force_n: f64,
    /// Archard wear rate at the cage pocket, m³/s.
    pub wear_rate_cage_m3_s: f64,
}
