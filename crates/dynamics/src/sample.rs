//! Results of a run at one time: SI, units in the names. Vectors of a ball are (axial, radial, tangential) in its
//! azimuth frame, those of a ring (x, y, z) in the inertial frame.

use crate::power::PowerSample;
use serde::{Deserialize, Serialize};
use tribodyn_bearing::{BallResult, Races};

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
    /// Wear so far.
    pub wear: WearSample,
    /// One entry per ball, in the order of their numbers, without the films of their contacts: nothing in a run needs
    /// them, and [`tribodyn_bearing::Bearing::put_films`] puts them in where they are wanted.
    pub balls: Vec<BallResult>,
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
    /// Tilt about X and Y, rad.
    #[serde(default)]
    pub tilt_rad: [f64; 2],
    /// Velocity, m/s.
    pub velocity_m_s: [f64; 3],
    /// Acceleration as a measuring chain gives it, m/s²: low-pass filtered, that of [`crate::FilterBands::delay_s`]
    /// before.
    pub acceleration_m_s2: [f64; 3],
    /// Acceleration at this very time, m/s²: its spectrum folds.
    pub acceleration_point_m_s2: [f64; 3],
    /// Sum of the forces of the balls on the ring, N.
    pub ball_force_n: [f64; 3],
    /// Torque about its axis that keeps the prescribed speed, N m.
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
    /// Where a free cage is; absent where it turns only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub free: Option<FreeCageSample>,
}

/// A cage that is free to move.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct FreeCageSample {
    /// Displacement of its centre (x, y) from the bearing's axis and along it (z), m.
    pub centre_m: [f64; 3],
    /// Velocity of its centre, m/s.
    pub velocity_m_s: [f64; 3],
    /// Tilt of its axis about X and Y, rad.
    pub tilt_rad: [f64; 2],
    /// Force of the lands of each ring on it, N.
    pub land_force_n: Races<[f64; 3]>,
    /// Smallest gap at the lands of each ring, m, negative where an edge is pressed; absent without a land.
    pub land_gap_m: Races<Option<f64>>,
    /// Power that friction at the lands takes, W.
    pub land_friction_w: f64,
    /// Power that the films of the lands take, W.
    pub land_film_w: f64,
}

/// Wear since the start, before any acceleration of wear.
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
