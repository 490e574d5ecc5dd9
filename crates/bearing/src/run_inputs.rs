//! All that a transient run is made of. It stands below the solvers, so that case files can give it without them.

use crate::bearing::Bearing;
use crate::free_cage::FreeCage;
use crate::history::{RingLoads, SpeedHistory};
use crate::operation::{Cage, OperatingPoint, SolverSettings};
use crate::races::{Races, Side};
use crate::watch::SearchWatch;
use tribodyn_traction::PatchChoice;
use tribodyn_wear::{BallWaves, Defect, Spall};

/// A bearing with what loads, holds and drives it over time, SI.
#[derive(Debug, Clone)]
pub struct RunInputs {
    /// The bearing, with traction laws on its races.
    pub bearing: Bearing,
    /// Load on each degree of freedom of the inner ring over time, or the position at which it is held.
    pub ring: RingLoads,
    /// Rotational speeds of the rings.
    pub speeds: Races<SpeedHistory>,
    /// The cage.
    pub cage: MovingCage,
    /// Mass, pockets and lands of a cage that is free to move in all directions; without them it turns about the
    /// bearing's axis only.
    pub free_cage: Option<FreeCage>,
    /// Masses and supports of the rings.
    pub supports: Supports,
    /// Inertias and supports of rings that are free to tilt; without them tilts are held where they are at
    /// the start.
    pub tilting: Races<Option<TiltingRing>>,
    /// Coatings of the races when the run starts.
    pub coatings: Races<CoatingState>,
    /// Local defects of the races.
    pub defects: Races<Vec<Defect>>,
    /// Spalls of the races.
    pub spalls: Races<Vec<Spall>>,
    /// Spalls of the balls.
    pub ball_spalls: Vec<BallSpall>,
    /// Waviness of the balls.
    pub ball_waves: BallWaves,
    /// Quadrature over the contact patches.
    pub patch: PatchChoice,
    /// Settings of the quasi-static solution at the start.
    pub numerics: SolverSettings,
    /// Duration, scheme and samples.
    pub options: RunOptions,
}

impl RunInputs {
    /// A run of races without defects, of whose coatings no thickness is known: nothing wears through. The patch rule
    /// keeps its error below 1e-5 of the load, at which accelerations settle.
    pub fn new(
        bearing: Bearing,
        (ring, speeds): (RingLoads, Races<SpeedHistory>),
        cage: MovingCage,
        supports: Supports,
        options: RunOptions,
    ) -> Self {
        let bare = CoatingState { thickness: 0.0, worn: 0.0 };
        Self {
            bearing,
            ring,
            speeds,
            cage,
            free_cage: None,
            supports,
            tilting: Races::default(),
            coatings: Races { inner: bare, outer: bare },
            defects: Races::default(),
            spalls: Races::default(),
            ball_spalls: Vec::new(),
            ball_waves: BallWaves::default(),
            patch: PatchChoice::TargetError { relative: 1e-5 },
            numerics: SolverSettings::default(),
            options,
        }
    }

    /// The operating point with the loads and speeds of a time in s.
    pub fn operating_point_at(&self, time: f64) -> OperatingPoint {
        OperatingPoint {
            ring: self.ring.at(time),
            inner_speed: self.speeds.inner.at(time),
            outer_speed: self.speeds.outer.at(time),
            patch: Some(self.patch),
            cage: Some(self.cage.pockets),
            numerics: self.numerics,
            watch: SearchWatch::default(),
        }
    }
}

/// A spall of a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallSpall {
    /// Number of the ball.
    pub ball: usize,
    /// Angle along the rolling circle from the outer contact at time 0, in the direction of the orbit, rad.
    pub angle: f64,
    /// Angle from the rolling circle of the outer contact, rad.
    pub latitude: f64,
    /// Its form; azimuth and place across are those of its race and not used.
    pub spall: Spall,
}

/// A cage that turns about the bearing's axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingCage {
    /// Pockets and the drag on the cage.
    pub pockets: Cage,
    /// Friction coefficient between ball and pocket.
    pub pocket_friction: f64,
    /// Damping of the pocket contact χ in F = K δ (1 + χ δ̇) (Hunt and Crossley), s/m.
    pub pocket_damping: f64,
    /// Oil in the pockets; none in dry ones.
    pub pocket_film: Option<PocketFilm>,
    /// Moment of inertia about the bearing's axis, kg m².
    pub inertia: f64,
    /// The land that guides the cage; absent for a cage that the balls alone guide.
    pub guidance: Option<GuidingLand>,
}

/// Oil between balls and pockets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PocketFilm {
    /// Share of the gap that is full, above 0.
    pub fill: f64,
    /// Height of the roughness of ball and pocket, m.
    pub roughness: f64,
}

/// A land that guides the cage: the fluid in its gap turns the cage with the ring or holds it back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GuidingLand {
    /// The ring whose land it is.
    pub side: Side,
    /// Radius of the land, m.
    pub radius: f64,
    /// Width of the land, m.
    pub width: f64,
    /// Radial gap between land and cage, m.
    pub gap: f64,
}

/// Masses and supports of the rings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Supports {
    /// Inner ring with what turns with it: three translations.
    pub inner: Support<3>,
    /// Outer ring with its housing: the two radial translations.
    pub outer: Support<2>,
}

/// Mass of a ring and the springs and dampers between it and the frame, along x, y (and z). The springs are without
/// stretch at the quasi-static solution of the starting loads, except that those of the outer ring carry its load
/// there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support<const N: usize> {
    /// Mass, kg.
    pub mass: f64,
    /// Stiffness, N/m.
    pub stiffness: [f64; N],
    /// Damping constant, N s/m.
    pub damping: [f64; N],
}

/// A ring, with what turns with it, that is free to tilt about its centre, which lies in the plane of its groove
/// centres. Springs are without stretch at the start, except where [`crate::RingLoads`] holds the tilt, and those of an
/// outer ring: these carry the moment there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TiltingRing {
    /// Moment of inertia about its axis, kg m².
    pub polar_inertia: f64,
    /// Moment of inertia across its axis, kg m².
    pub transverse_inertia: f64,
    /// Stiffness against tilts about X and Y, N m/rad.
    pub stiffness: [f64; 2],
    /// Damping of tilts about X and Y, N m s/rad.
    pub damping: [f64; 2],
    /// Tilts about X and Y, at time 0, by which the seat of the ring stands askew; they turn with the ring, rad.
    pub askew: [f64; 2],
}

/// The coating of a race at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoatingState {
    /// Thickness when new, m.
    pub thickness: f64,
    /// Part of the thickness that is worn off, 0 to 1.
    pub worn: f64,
}

/// Duration, start, scheme and samples of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunOptions {
    /// Simulated time, s.
    pub duration: f64,
    /// The state from which it starts.
    pub start: Start,
    /// Time stepping.
    pub scheme: Scheme,
    /// Damping of the ball–race contacts along their normals as a fraction of the critical one, ζ in c = 2ζ sqrt(m
    /// dQ/dδ).
    pub contact_damping: f64,
    /// Factor on all wear rates in what they do to coating and grooves, 0 for races that do not change during the run.
    pub wear_acceleration: f64,
    /// Samples of rings, cage and powers, Hz.
    pub state_rate: f64,
    /// Samples of every ball, Hz.
    pub ball_rate: f64,
}

impl RunOptions {
    /// From the quasi-static solution, races as they are, states at the 25.6 kHz of test rigs and balls at a fifth of
    /// it.
    pub fn new(duration: f64, scheme: Scheme, contact_damping: f64) -> Self {
        Self {
            duration,
            start: Start::QuasiStatic,
            scheme,
            contact_damping,
            wear_acceleration: 0.0,
            state_rate: 25_600.0,
            ball_rate: 5_120.0,
        }
    }
}

/// The state from which a transient run starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// The quasi-static solution at the loads and speeds of time 0.
    QuasiStatic,
    /// The steady orbit at the loads and speeds of time 0.
    SteadyOrbit,
    /// A standstill: rings, cage and balls at rest under the loads of time 0.
    Rest,
}

/// Time stepping.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scheme {
    /// The classical Runge–Kutta method of fourth order.
    RungeKutta4 {
        /// Step, s.
        step: f64,
    },
    /// The embedded pair 5(4) of Dormand and Prince.
    DormandPrince {
        /// Largest error of a step relative to the typical size of each unknown.
        tolerance: f64,
        /// Longest step, s.
        longest: f64,
    },
    /// The fast fixed-step scheme: contact springs explicit, the friction of rotation and orbit linearly implicit.
    Fast {
        /// Step, s.
        step: f64,
    },
    /// The same with the longest step that errs by no more than is asked for.
    FastTo {
        /// Error of loads and torque over themselves; of the cage's speed a tenth of it, of the outer ring's unsteady
        /// acceleration ten times as much.
        accuracy: f64,
    },
}
