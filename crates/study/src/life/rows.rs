//! Results of a life.

use serde::{Deserialize, Serialize};

/// The event that ends a life.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LifeEnd {
    /// A coating is worn through.
    WornThrough,
    /// Wear has added the clearance of [`LifeOptions::clearance_limit_m`](super::LifeOptions::clearance_limit_m).
    ClearanceLimit,
    /// The running time of [`LifeOptions::until_s`](super::LifeOptions::until_s) is over.
    Time,
    /// Wear has added half of the clearance that the grooves can hold at all.
    Grooves,
    /// The caller has ended it.
    Stopped,
}

/// The life of a bearing's raceways.
#[derive(Debug, Clone, Serialize)]
pub struct Life {
    /// Name of the case file.
    pub case: String,
    /// Name of the bearing.
    pub bearing: String,
    /// The event that ended the life.
    pub ended_by: LifeEnd,
    /// Races whose coating is through at the end: `inner`, `outer`.
    pub worn_through: Vec<&'static str>,
    /// Running time at the end, h.
    pub end_h: f64,
    /// Turns of the inner ring against the outer by then.
    pub end_revolutions: f64,
    /// When steel first showed in the middle of a track, h; absent where it did not.
    pub steel_shows_h: Option<f64>,
    /// Radial internal clearance, added by wear, at which the life was to end, µm; absent where none was asked for.
    pub clearance_limit_um: Option<f64>,
    /// Part of a new coating that a stride takes at its fastest spot, and of the clearance limit that it adds at most.
    pub loss_per_stride: f64,
    /// The state at the start of each stride, and at the end.
    pub strides: Vec<LifeStride>,
    /// Of the solutions, and of what a life leaves out.
    pub warnings: Vec<String>,
}

/// A worn bearing at one time of its life.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct LifeStride {
    /// Running time, h.
    pub time_h: f64,
    /// Turns of the inner ring against the outer.
    pub revolutions: f64,
    /// Thinnest coating of the inner race, µm.
    pub coating_inner_min_um: f64,
    /// Thinnest coating of the outer race, µm.
    pub coating_outer_min_um: f64,
    /// Mean depth worn off round the inner race, µm.
    pub wear_depth_inner_mean_um: f64,
    /// Mean depth worn off round the outer race, µm.
    pub wear_depth_outer_mean_um: f64,
    /// Radial internal clearance that wear has added, on the diameter as in ISO 5753, µm: twice the mean depths of both
    /// races.
    pub clearance_growth_um: f64,
    /// Free contact angle with the clearance that wear has added, degrees.
    pub contact_angle_free_deg: f64,
    /// Least contact angle of the balls at the inner race, degrees.
    pub contact_angle_inner_min_deg: f64,
    /// Largest contact angle of the balls at the inner race, degrees.
    pub contact_angle_inner_max_deg: f64,
    /// Least contact angle of the balls at the outer race, degrees.
    pub contact_angle_outer_min_deg: f64,
    /// Largest contact angle of the balls at the outer race, degrees.
    pub contact_angle_outer_max_deg: f64,
    /// Highest peak pressure at the inner race, GPa.
    pub peak_pressure_inner_max_gpa: f64,
    /// Highest peak pressure at the outer race, GPa.
    pub peak_pressure_outer_max_gpa: f64,
    /// Cage speed, r/min.
    pub cage_speed_rpm: f64,
    /// Wear rate of the inner race, µm³/s.
    pub wear_rate_inner_um3_s: f64,
    /// Wear rate of the outer race, µm³/s.
    pub wear_rate_outer_um3_s: f64,
    /// Wear rate of the cage, µm³/s.
    pub wear_rate_cage_um3_s: f64,
}
