//! Results of a quasi-static solution, and their table. What `tribodyn solve --json` prints is made of the table.

use serde::ser::{Serialize, SerializeMap, Serializer};
use tribodyn_bearing::quantities::{Fields, NEWTON, NEWTON_METRE, ONE, Quantity, RADIAN_PER_SECOND, RPM, joined};
use tribodyn_bearing::quantities::{METRE, MICROMETRE, MILLIRADIAN, RADIAN, Scope, Unit};
use tribodyn_bearing::{BallResult, place};

/// Which equations were solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Model {
    /// Jones–Harris with raceway control.
    JonesHarris,
    /// Six balances per ball with the traction integrals of both contacts.
    Traction,
}

impl Model {
    /// Its name in answers.
    pub const fn name(self) -> &'static str {
        match self {
            Self::JonesHarris => "jones-harris",
            Self::Traction => "traction",
        }
    }
}

/// Its name in a sentence.
impl std::fmt::Display for Model {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::JonesHarris => "Jones–Harris",
            Self::Traction => "traction",
        })
    }
}

/// The equilibrium of ring and balls.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Which equations were solved.
    pub model: Model,
    /// True if every balance is within the tolerance.
    pub converged: bool,
    /// Mean orbital speed of the balls, r/min.
    pub cage_speed_rpm: f64,
    /// True if the ring comes back from a small push, by its stiffness with the balls in balance; absent where that was
    /// not judged.
    pub stable: Option<bool>,
    /// Displacement of the inner ring against the outer: x, y (radial), z (axial), m.
    pub ring_displacement_m: [f64; 3],
    /// Tilt of the inner ring about X and Y, rad.
    pub ring_tilt_rad: [f64; 2],
    /// Force that the inner ring puts on the balls: x, y, z, N. Equal to the load where the ring is loaded.
    pub ring_load_n: [f64; 3],
    /// Moment that the inner ring puts on the balls about X and Y, N m.
    pub ring_moment_nm: [f64; 2],
    /// Torque that the shaft needs, N m, against rotation at the inner ring's speed; absent for Jones–Harris.
    pub shaft_torque_nm: Option<f64>,
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
    /// Warnings: lost contacts, several or no roots, by ball.
    pub warnings: Vec<String>,
    /// One entry per ball, by azimuth.
    pub balls: Vec<BallResult>,
}

impl Solution {
    /// A solution of which only the model and the balls are known, with zeros or nothing for the rest: what else is
    /// read back is set in it.
    pub fn of_balls(model: Model, balls: Vec<BallResult>) -> Self {
        Self {
            model,
            converged: false,
            cage_speed_rpm: 0.0,
            stable: None,
            ring_displacement_m: [0.0; 3],
            ring_tilt_rad: [0.0; 2],
            ring_load_n: [0.0; 3],
            ring_moment_nm: [0.0; 2],
            shaft_torque_nm: None,
            inner_speed_rad_s: 0.0,
            outer_speed_rad_s: 0.0,
            residual: f64::NAN,
            iterations: 0,
            patch_error_estimate: None,
            warnings: Vec::new(),
            balls,
        }
    }

    /// Name of the equations in answers and recordings: those of the model, or `steady-orbit` where the balls move as
    /// they do on one.
    pub fn equations(&self) -> &'static str {
        let moving = self.model == Model::Traction && self.balls.iter().any(|ball| ball.motion.is_some());
        if moving { "steady-orbit" } else { self.model.name() }
    }

    /// True if the rings turn against each other: only then do balls roll, slide and meet their pockets.
    pub fn turns(&self) -> bool {
        self.inner_speed_rad_s != self.outer_speed_rad_s
    }
}

type S = Quantity<Solution>;

/// The cage speed is held in r/min.
const TURNS: Unit = Unit { per_si: 1.0, ..RPM };

/// Quantities of a solution.
pub static SOLUTION: [Quantity<Solution>; 15] = [
    S::new(["cage_speed", "Cage speed", "Mean orbital speed of the balls"], [TURNS, TURNS], place!(.cage_speed_rpm)),
    S::new(
        [
            "ring_displacement_x",
            "Ring displacement along X",
            "Displacement of the inner against the outer ring along X",
        ],
        [METRE, MICROMETRE],
        place!(.ring_displacement_m[0]),
    ),
    S::new(
        [
            "ring_displacement_y",
            "Ring displacement along Y",
            "Displacement of the inner against the outer ring along Y",
        ],
        [METRE, MICROMETRE],
        place!(.ring_displacement_m[1]),
    ),
    S::new(
        ["ring_displacement_z", "Ring displacement along Z", "Axial displacement of the inner against the outer ring"],
        [METRE, MICROMETRE],
        place!(.ring_displacement_m[2]),
    ),
    S::new(
        ["ring_tilt_x", "Ring tilt about X", "Tilt of the inner ring about X"],
        [RADIAN, MILLIRADIAN],
        place!(.ring_tilt_rad[0]),
    ),
    S::new(
        ["ring_tilt_y", "Ring tilt about Y", "Tilt of the inner ring about Y"],
        [RADIAN, MILLIRADIAN],
        place!(.ring_tilt_rad[1]),
    ),
    S::new(
        ["ring_load_x", "Ring load along X", "Force of the inner ring on the balls along X"],
        [NEWTON, NEWTON],
        place!(.ring_load_n[0]),
    ),
    S::new(
        ["ring_load_y", "Ring load along Y", "Force of the inner ring on the balls along Y"],
        [NEWTON, NEWTON],
        place!(.ring_load_n[1]),
    ),
    S::new(
        ["ring_load_z", "Ring load along Z", "Force of the inner ring on the balls along Z"],
        [NEWTON, NEWTON],
        place!(.ring_load_n[2]),
    ),
    S::new(
        ["ring_moment_x", "Ring moment about X", "Moment of the inner ring on the balls about X"],
        [NEWTON_METRE, NEWTON_METRE],
        place!(.ring_moment_nm[0]),
    ),
    S::new(
        ["ring_moment_y", "Ring moment about Y", "Moment of the inner ring on the balls about Y"],
        [NEWTON_METRE, NEWTON_METRE],
        place!(.ring_moment_nm[1]),
    ),
    S::new(
        ["shaft_torque", "Shaft torque", "Torque that the shaft needs, against rotation at the inner ring's speed"],
        [NEWTON_METRE, NEWTON_METRE],
        (|s| s.shaft_torque_nm, |s, value| s.shaft_torque_nm = Some(value)),
    )
    .in_scope(Scope::Traction),
    S::new(
        ["inner_speed", "Speed of the inner ring", "Speed of the inner ring"],
        [RADIAN_PER_SECOND, RPM],
        place!(.inner_speed_rad_s),
    ),
    S::new(
        ["outer_speed", "Speed of the outer ring", "Speed of the outer ring"],
        [RADIAN_PER_SECOND, RPM],
        place!(.outer_speed_rad_s),
    ),
    S::new(
        ["patch_error_estimate", "Patch error estimate", "Quadrature error of the traction force over the load"],
        [ONE, ONE],
        (|s| s.patch_error_estimate, |s, value| s.patch_error_estimate = Some(value)),
    )
    .in_scope(Scope::Traction),
];

impl Serialize for Model {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// As `solve --json` prints it, under the name of its equations.
impl Serialize for Solution {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("model", self.equations())?;
        map.serialize_entry("converged", &self.converged)?;
        if let Some(stable) = self.stable {
            map.serialize_entry("stable", &stable)?;
        }
        for Quantity { facts, get, .. } in &SOLUTION {
            if let Some(value) = get(self) {
                map.serialize_entry(&joined(&[facts.name, facts.unit.suffix]), &(value * facts.unit.per_si))?;
            }
        }
        map.serialize_entry("residual", &self.residual)?;
        map.serialize_entry("iterations", &self.iterations)?;
        map.serialize_entry("warnings", &self.warnings)?;
        map.serialize_entry("balls", &self.balls.iter().map(Fields).collect::<Vec<_>>())?;
        map.end()
    }
}
