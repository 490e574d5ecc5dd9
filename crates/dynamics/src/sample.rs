//! What a run says at one time: SI, units in the names. Vectors of a ball are (axial, radial, tangential) in its azimuth
//! frame, those of a ring (x, y, z) in the inertial frame.

use serde::{Deserialize, Serialize};

/// Everything at one time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sample {
    /// Simulated time, s.
    pub time_s: f64,
    /// Inner ring.
    pub inner: RingSample,
    /// Outer ring.
    pub outer: RingSample,
    /// Cage.
    pub cage: CageSample,
    /// Powers and energy.
    pub power: PowerSample,
    /// What has worn off so far.
    pub wear: WearSample,
    /// One entry per ball, in the order of their numbers.
    pub balls: Vec<BallSample>,
}

/// A ring.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct RingSample {
    /// Angle turned since time 0, rad.
    pub angle_rad: f64,
    /// Rotational speed, rad/s.
    pub speed_rad_s: f64,
    /// Displacement, m.
    pub displacement_m: [f64; 3],
    /// Velocity, m/s.
    pub velocity_m_s: [f64; 3],
    /// Acceleration as a measuring chain gives it, m/s²: low-pass filtered, that of [`crate::FilterBands::delay_s`] before.
    pub acceleration_m_s2: [f64; 3],
    /// Acceleration at this very time, m/s²: its spectrum folds.
    pub acceleration_point_m_s2: [f64; 3],
    /// Sum of the forces of the balls on the ring, N.
    pub ball_force_n: [f64; 3],
    /// Torque about Z that keeps the prescribed speed, N m.
    pub torque_nm: f64,
}

/// The cage.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct CageSample {
    /// Angle turned since time 0, rad.
    pub angle_rad: f64,
    /// Rotational speed, rad/s.
    pub speed_rad_s: f64,
    /// The same low-pass filtered, that of [`crate::FilterBands::delay_s`] before, rad/s: what spectra are made of.
    pub speed_filtered_rad_s: f64,
    /// Rotational acceleration, rad/s².
    pub acceleration_rad_s2: f64,
    /// Torque of all balls on the cage, N m.
    pub ball_torque_nm: f64,
    /// Torque of drag and guidance on the cage, N m.
    pub fluid_torque_nm: f64,
}

/// Where power comes from and where it goes, W, and the energy stored, J. In is what drives, every loss is positive:
/// shaft + loads = friction + drag + churning + damping + pocket + cage + supports + d(energy)/dt.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct PowerSample {
    /// Of both rings' drives.
    pub shaft_w: f64,
    /// Of the external loads on the rings.
    pub load_w: f64,
    /// Friction of all inner contacts.
    pub friction_inner_w: f64,
    /// Friction of all outer contacts.
    pub friction_outer_w: f64,
    /// Drag on the balls.
    pub drag_w: f64,
    /// Churning of the balls.
    pub churning_w: f64,
    /// Damping of the ball–race contacts.
    pub contact_damping_w: f64,
    /// Friction in the cage pockets.
    pub pocket_friction_w: f64,
    /// Damping in the cage pockets.
    pub pocket_damping_w: f64,
    /// Drag and guidance of the cage.
    pub cage_w: f64,
    /// Dampers of the supports.
    pub support_w: f64,
    /// Kinetic and elastic energy, J, those of the prescribed rotation of the rings left out.
    pub energy_j: f64,
    /// Elastic energy that wear has taken out of the contacts since the start by what it does to the raceways, J; less
    /// than 0 where it lets a load down.
    pub wear_work_j: f64,
    /// What is missing in the balance integrated from the start: work in − losses − wear − change of energy, J.
    pub imbalance_j: f64,
    /// Work put in from the start, all sources, magnitudes summed, or work lost where that is more, as where balls slow down,
    /// J: what the imbalance is compared with.
    pub throughput_j: f64,
}

impl PowerSample {
    /// Power of all that drives, W.
    pub fn put_in(&self) -> f64 {
        self.shaft_w + self.load_w
    }

    /// Power lost, W.
    pub fn lost(&self) -> f64 {
        self.friction_inner_w
            + self.friction_outer_w
            + self.drag_w
            + self.churning_w
            + self.contact_damping_w
            + self.pocket_friction_w
            + self.pocket_damping_w
            + self.cage_w
            + self.support_w
    }
}

/// What has worn off since the start, before any acceleration of wear.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct WearSample {
    /// Volume off the inner race, m³.
    pub volume_inner_m3: f64,
    /// Volume off the outer race, m³.
    pub volume_outer_m3: f64,
    /// Volume off the cage pockets, m³.
    pub volume_cage_m3: f64,
    /// Thinnest coating left on the inner race, m.
    pub coating_inner_min_m: f64,
    /// Thinnest coating left on the outer race, m.
    pub coating_outer_min_m: f64,
}

/// A ball.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct BallSample {
    /// Azimuth from X towards Y, counted on from the start without wrapping, rad.
    pub azimuth_rad: f64,
    /// Orbital speed ω_m, rad/s.
    pub orbital_speed_rad_s: f64,
    /// Orbital acceleration, rad/s².
    pub orbital_acceleration_rad_s2: f64,
    /// Radius of the orbit of the ball centre about the inertial axis, m.
    pub orbit_radius_m: f64,
    /// Axial position of the ball centre against the unloaded one, m.
    pub axial_displacement_m: f64,
    /// Axial and radial velocity of the ball centre, m/s.
    pub velocity_m_s: [f64; 2],
    /// Spin ω relative to the orbiting frame, rad/s.
    pub spin_rad_s: [f64; 3],
    /// Inner contact.
    pub inner: ContactSample,
    /// Outer contact.
    pub outer: ContactSample,
    /// Fluid drag against the orbit, N.
    pub drag_n: f64,
    /// Moment of the fluid against the spin, N m.
    pub churning_nm: [f64; 3],
    /// Power that churning takes from the absolute spin, W.
    pub churning_w: f64,
    /// Lead of the ball over the middle of its pocket, rad.
    pub pocket_lead_rad: f64,
    /// Force of the pocket on the ball along the orbit, N.
    pub pocket_force_n: f64,
    /// Friction of the pocket on the ball (axial, radial), N.
    pub pocket_friction_n: [f64; 2],
    /// Archard wear rate at the pocket, m³/s.
    pub wear_rate_cage_m3_s: f64,
}

/// One ball–race contact.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactSample {
    /// Contact angle, rad.
    pub angle_rad: f64,
    /// Elastic approach, m; 0 or less where there is no contact.
    pub approach_m: f64,
    /// Normal load Q, N, without damping.
    pub load_n: f64,
    /// Normal force with damping, N.
    pub normal_force_n: f64,
    /// Semi-axes across the groove and along rolling, m.
    pub semi_axes_m: [f64; 2],
    /// Peak pressure, Pa.
    pub peak_pressure_pa: f64,
    /// Traction on the ball along the orbit and across the groove, N.
    pub traction_n: [f64; 2],
    /// Slide-to-roll ratios ξ_x, ξ_y.
    pub slide_to_roll: [f64; 2],
    /// Spin ratio φ, 1/m.
    pub spin_ratio_per_m: f64,
    /// Rolling speed V, m/s.
    pub rolling_speed_m_s: f64,
    /// Frictional power, W.
    pub power_loss_w: f64,
    /// Archard wear rate, m³/s.
    pub wear_rate_m3_s: f64,
    /// Part of the coating that is gone where the ball stands, 0 to 1.
    pub bare: f64,
    /// Depth of the groove where the ball stands, by defects and wear, m.
    pub depth_m: f64,
}
