//! Results of a life with acting wear.

use crate::life::LifeEnd;
use serde::{Deserialize, Serialize};
use tribodyn_wear::GrooveField;

/// A life in which wear acts on the bearing.
#[derive(Debug, Clone, Serialize)]
pub struct ActingLife {
    /// Name of the case file.
    pub case: String,
    /// Name of the bearing.
    pub bearing: String,
    /// The effects that were on: `clearance`, `curvature`, `traction`, `transfer`.
    pub effects: Vec<&'static str>,
    /// The event that ended the life.
    pub ended_by: LifeEnd,
    /// Running time at the end, h.
    pub end_h: f64,
    /// Turns of the inner ring against the outer by then.
    pub end_revolutions: f64,
    /// The first spot without coating; absent where there was none.
    pub first_through: Option<FirstThrough>,
    /// Share of a race's load on bare steel at which the life was to end.
    pub bare_limit: f64,
    /// Part of a new coating that a stride takes at its fastest spot at most.
    pub loss_per_stride: f64,
    /// The state at the start of each stride, and at the end.
    pub strides: Vec<ActingStride>,
    /// Of the solutions, and of what a life leaves out.
    pub warnings: Vec<String>,
    /// Depth over azimuth and across, inner and outer.
    #[serde(skip)]
    pub fields: [GrooveField; 2],
}

/// The spot at which a coating was through first.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FirstThrough {
    /// `inner` or `outer`.
    pub race: String,
    /// Azimuth in a ring that stands, degrees; absent where the ring turns, as it wears alike all round.
    pub azimuth_deg: Option<f64>,
    /// Contact angle at which it lies in the groove, degrees.
    pub angle_deg: f64,
    /// Running time, h.
    pub time_h: f64,
}

/// A worn bearing at one time of its life.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ActingStride {
    /// Running time, h.
    pub time_h: f64,
    /// Turns of the inner ring against the outer.
    pub revolutions: f64,
    /// Number of the phase of the mission that is solved; 0 where the stride takes whole cycles.
    pub phase: f64,
    /// Thinnest coating of any spot of the inner race, µm.
    pub coating_inner_min_um: f64,
    /// The same of the outer race.
    pub coating_outer_min_um: f64,
    /// Depth under the contacts of the inner race, weighted by their pressure, µm.
    pub depth_under_contact_inner_um: f64,
    /// The same of the outer race.
    pub depth_under_contact_outer_um: f64,
    /// Curvature of the worn profile under the contacts of the inner race, 1/m.
    pub profile_curvature_inner_per_m: f64,
    /// The same of the outer race.
    pub profile_curvature_outer_per_m: f64,
    /// Share of the load of the inner race that is carried pre-coated: by what is left of its coating.
    pub precoated_inner: f64,
    /// The same of the outer race.
    pub precoated_outer: f64,
    /// Share that is self-lubricated: by the film that comes from the cage. Alike at both races.
    pub self_lubricated: f64,
    /// Share of the load of the inner race that is unlubricated: on bare steel.
    pub unlubricated_inner: f64,
    /// The same of the outer race.
    pub unlubricated_outer: f64,
    /// Volume worn off the inner race, mm³.
    pub worn_inner_mm3: f64,
    /// The same of the outer race.
    pub worn_outer_mm3: f64,
    /// Volume scraped off the cage, mm³.
    pub scraped_mm3: f64,
    /// Of that, the volume on balls and tracks, mm³.
    pub film_mm3: f64,
    /// Of that, the volume lost, mm³.
    pub lost_mm3: f64,
    /// Free contact angle, degrees.
    pub contact_angle_free_deg: f64,
    /// Highest peak pressure at the inner race, GPa.
    pub peak_pressure_inner_max_gpa: f64,
    /// The same of the outer race.
    pub peak_pressure_outer_max_gpa: f64,
    /// Cage speed, r/min.
    pub cage_speed_rpm: f64,
    /// Frictional power of all contacts of balls and races, W.
    pub friction_races_w: f64,
    /// Volume worn off the inner race per time, below the film, µm³/s.
    pub wear_rate_inner_um3_s: f64,
    /// The same of the outer race.
    pub wear_rate_outer_um3_s: f64,
    /// Volume scraped off the cage per time, µm³/s.
    pub wear_rate_cage_um3_s: f64,
}
