//! How long a coating lasts, by strides of wear between steady orbits or equilibria.
//!
//! Wear of a race counts as added radial clearance, by its mean depth round the race: the free contact angle grows and
//! the loads with it. The depth is in no other place, and the solution knows no bare steel.

use crate::answers::{Equations, OrbitProblem};
use crate::case_file::CaseFile;
use crate::error::StudyError;
use serde::Serialize;
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;
use tribodyn_bearing::quantities::{OfBall, Over};
use tribodyn_bearing::{BallResult, Bearing, Side};
use tribodyn_case::{Case, Coatings, Fit, Purpose};
use tribodyn_orbit::{OrbitStart, SolvedOrbit, steady_orbit, steady_orbit_from};
use tribodyn_quasistatic::{Model, OperatingPoint, Solution, Solved, WarmStart, solve, solve_near};
use tribodyn_wear::{BallWear, CoatingLife, GrooveGeometry, RaceWear, Raceway, WearDepths, WearRates};

const HOUR: f64 = 3600.0;
/// Longest stride where nothing else ends one, s: what lasts longer lasts for ever.
const FOR_EVER: f64 = 1e12;
/// Part of the new thickness that is left, averaged over the track, when the middle of the track is through (see
/// [`Raceway`]).
const STEEL_SHOWS: f64 = 1.0 / 3.0;

/// Choices of a life besides its case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LifeOptions {
    /// Strides in which a new coating is worn away at its fastest spot, 1 or more; the error falls in proportion to
    /// their number.
    pub strides: u32,
    /// Running time after which a life ends, should the coatings last longer, s.
    pub until_s: Option<f64>,
    /// Equations of each stride: with traction, as nothing slides without.
    pub equations: Equations,
}

/// The life of a bearing's coatings.
#[derive(Debug, Clone, Serialize)]
pub struct Life {
    /// Name of the case file.
    pub case: String,
    /// Name of the bearing.
    pub bearing: String,
    /// Races whose coating is through at the end: `inner`, `outer`.
    pub worn_through: Vec<&'static str>,
    /// Running time at the end, h.
    pub end_h: f64,
    /// Turns of the inner ring against the outer by then.
    pub end_revolutions: f64,
    /// When steel first showed in the middle of a track, h; absent where it did not.
    pub steel_shows_h: Option<f64>,
    /// Part of a new coating that a stride takes at its fastest spot.
    pub loss_per_stride: f64,
    /// The state at the start of each stride, and at the end.
    pub strides: Vec<LifeStride>,
    /// Of the solutions, and of what a life leaves out.
    pub warnings: Vec<String>,
}

/// A worn bearing at one time of its life.
#[derive(Debug, Clone, Serialize)]
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

/// Wears the coatings of a bearing until one is through. `progress` gets each stride as it is reached; a break ends the
/// life there.
///
/// # Errors
/// The case makes no bearing, an equilibrium is not found, or nothing wears a coating through and no time is given.
pub fn wear_life(
    file: &CaseFile,
    options: LifeOptions,
    mut progress: impl FnMut(&LifeStride) -> ControlFlow<()>,
) -> Result<Life, StudyError> {
    let mut worn = Worn::new(file, options.equations)?;
    let loss_per_stride = 1.0 / f64::from(options.strides);
    let [inner, outer] = worn.raceways()?;
    let mut life = CoatingLife::new(inner, outer, loss_per_stride)?;
    let until = options.until_s.unwrap_or(FOR_EVER);
    let (mut rows, mut warnings) = (Vec::new(), Vec::new());
    loop {
        let state = worn.state(&life)?;
        for warning in &state.round.warnings {
            if !warnings.contains(warning) {
                warnings.push(warning.clone());
            }
        }
        rows.push(worn.row(&life, &state));
        let stopped = progress(&rows[rows.len() - 1]).is_break();
        let left = until - life.elapsed();
        if stopped || life.worn_through().is_some() || left <= 1e-9 * until {
            if !stopped && options.until_s.is_none() && life.worn_through().is_none() {
                return Err(StudyError::NoWear { file: file.name.clone() });
            }
            break;
        }
        let rates = worn.rates(&state.round);
        life.advance(left, |_, _| Ok::<_, StudyError>(rates))?;
    }
    warnings.extend(worn.warnings());
    let end = rows[rows.len() - 1].clone();
    let through = [("inner", life.inner()), ("outer", life.outer())];
    Ok(Life {
        case: file.name.clone(),
        bearing: file.case.name.clone(),
        worn_through: through.iter().filter(|(_, r)| r.worn_through().is_some()).map(|(name, _)| *name).collect(),
        end_h: end.time_h,
        end_revolutions: end.revolutions,
        steel_shows_h: steel_shows(&rows, worn.coatings),
        loss_per_stride,
        strides: rows,
        warnings,
    })
}

/// A bearing as it wears.
struct Worn<'a> {
    file: &'a CaseFile,
    coatings: &'a Coatings,
    point: OperatingPoint,
    new: Bearing,
    equations: Equations,
    start: Option<Start>,
}

/// The stride before.
enum Start {
    Equilibrium(WarmStart),
    Orbit(Box<OrbitStart>),
}

/// The bearing at one time of its life.
struct State {
    /// The balls where they stand.
    balls: Vec<BallResult>,
    /// One ball round its orbit: all balls of an equilibrium, being one ball at other times.
    round: Solution,
}

impl<'a> Worn<'a> {
    fn new(file: &'a CaseFile, equations: Equations) -> Result<Self, StudyError> {
        if equations == Equations::JonesHarris {
            return Err(StudyError::argument("model", equations.name(), "without traction nothing slides and wears"));
        }
        let new = file.bearing_for(Purpose::Traction)?;
        let coatings = file.case.coatings.as_ref().ok_or_else(|| StudyError::NoWear { file: file.name.clone() })?;
        Ok(Self { file, coatings, point: file.case.operating_point(), new, equations, start: None })
    }

    /// As the case has them; defects are too small to wear a race round.
    fn raceways(&self) -> Result<[Raceway; 2], StudyError> {
        let (g, coatings) = (&self.new.geometry, self.coatings);
        // Where the balls touch at the free contact angle.
        let outwards = g.ball_radius() * g.cos_contact_angle();
        let race = |spec: &tribodyn_case::CoatingSpec, outwards: f64| {
            Raceway::new(spec.thickness, spec.worn, 0.5 * g.pitch_diameter + outwards, &[])
        };
        Ok([race(&coatings.inner, -outwards)?, race(&coatings.outer, outwards)?])
    }

    /// The case with the free contact angle that the wear leaves.
    fn case(&self, life: &CoatingLife) -> Result<Case, StudyError> {
        let g = &self.new.geometry;
        let groove = |side| g.coefficient(side) * g.ball_diameter;
        let grooves = GrooveGeometry {
            ball_diameter: g.ball_diameter,
            inner_groove: groove(Side::Inner),
            outer_groove: groove(Side::Outer),
            inner_bottom: g.groove_centre_radius(Side::Inner) - groove(Side::Inner),
            outer_bottom: g.groove_centre_radius(Side::Outer) + groove(Side::Outer),
        };
        let depths = WearDepths { inner: life.inner().mean_depth(), outer: life.outer().mean_depth() };
        let mut case = self.file.case.clone();
        // Bottoms and back again would cost the last digits of the angle where nothing is worn.
        let angle = if depths == WearDepths::NONE { g.contact_angle() } else { grooves.free_contact_angle(depths)? };
        case.geometry.fit = Fit::ContactAngle(angle);
        // The clearance has all that is worn, what was so at the start too.
        if let Some(coatings) = &mut case.coatings {
            (coatings.inner.worn, coatings.outer.worn) = (0.0, 0.0);
        }
        Ok(case)
    }

    /// From the stride before where there is one: the coating wears slowly, and the balls stay in the motion that they
    /// are in.
    fn state(&mut self, life: &CoatingLife) -> Result<State, StudyError> {
        let case = self.case(life)?;
        if self.equations == Equations::SteadyOrbit { self.orbit(&case) } else { self.equilibrium(&case) }
    }

    fn equilibrium(&mut self, case: &Case) -> Result<State, StudyError> {
        let failed = |source| StudyError::Solver { file: self.file.name.clone(), source };
        let bearing = case.bearing().map_err(|source| self.file.not_usable(source.into()))?;
        let estimate = |solved: &Solved| solved.solution.patch_error_estimate;
        let fine = |solved: &Solved| self.point.patch.is_none_or(|patch| patch.allows(estimate(solved)));
        let near = match &self.start {
            Some(Start::Equilibrium(start)) => solve_near(&bearing, &self.point, start).ok().filter(fine),
            _ => None,
        };
        let solved = match near {
            Some(solved) => solved,
            None => solve(&bearing, &self.point, Model::Traction).map_err(failed)?,
        };
        self.start = solved.warm_start.map(Start::Equilibrium);
        Ok(State { balls: solved.solution.balls.clone(), round: solved.solution })
    }

    fn orbit(&mut self, case: &Case) -> Result<State, StudyError> {
        let failed = |source| StudyError::Orbit { file: self.file.name.clone(), source };
        let problem = OrbitProblem::of(case).map_err(|source| self.file.not_usable(source))?;
        let OrbitProblem { bearing, point, cage, settings } = &problem;
        let solved = match &self.start {
            Some(Start::Orbit(near)) => steady_orbit_from(bearing, point, cage, settings, near),
            _ => steady_orbit(bearing, point, cage, settings),
        };
        let SolvedOrbit { solution: orbit, start, .. } = solved.map_err(failed)?;
        self.start = start.map(|start| Start::Orbit(Box::new(start)));
        let round = orbit.as_solution(&orbit.points, [point.inner_speed, point.outer_speed]);
        Ok(State { balls: orbit.balls, round })
    }

    fn rates(&self, solution: &Solution) -> WearRates {
        let race = |speed: f64, side: Side| RaceWear {
            along_orbit: solution
                .balls
                .iter()
                .map(|b| {
                    let contact = &b.contacts[side];
                    let volume_rate = contact.friction_or_nan().wear_rate_m3_s;
                    BallWear { azimuth: b.azimuth_rad, volume_rate, semi_lateral: contact.semi_axes_m[0] }
                })
                .collect(),
            ball_count: self.new.geometry.ball_count,
            turning: speed != 0.0,
        };
        WearRates { inner: race(self.point.inner_speed, Side::Inner), outer: race(self.point.outer_speed, Side::Outer) }
    }

    fn row(&self, life: &CoatingLife, state: &State) -> LifeStride {
        let time = life.elapsed();
        let turns = (self.point.inner_speed - self.point.outer_speed).abs() / TAU;
        // A life is solved with traction, which has all of these.
        let of = |quantity: Option<OfBall>, over| {
            let balls = if over == Over::Sum { &state.balls } else { &state.round.balls };
            let value = quantity.and_then(|q| Some(q.over(over, balls)? * q.facts().shown.per_si));
            value.unwrap_or(f64::NAN)
        };
        let race = |side, name, over| of(OfBall::contact(side, name), over);
        let depths = [life.inner().mean_depth(), life.outer().mean_depth()];
        let angle = self.case(life).map_or(f64::NAN, |case| match case.geometry.fit {
            Fit::ContactAngle(angle) => angle,
            Fit::RadialClearance(_) => f64::NAN,
        });
        LifeStride {
            time_h: time / HOUR,
            revolutions: time * turns,
            coating_inner_min_um: life.inner().thinnest() * 1e6,
            coating_outer_min_um: life.outer().thinnest() * 1e6,
            wear_depth_inner_mean_um: depths[0] * 1e6,
            wear_depth_outer_mean_um: depths[1] * 1e6,
            contact_angle_free_deg: angle * 180.0 / PI,
            contact_angle_inner_min_deg: race(Side::Inner, "contact_angle", Over::Min),
            contact_angle_inner_max_deg: race(Side::Inner, "contact_angle", Over::Max),
            contact_angle_outer_min_deg: race(Side::Outer, "contact_angle", Over::Min),
            contact_angle_outer_max_deg: race(Side::Outer, "contact_angle", Over::Max),
            peak_pressure_inner_max_gpa: race(Side::Inner, "peak_pressure", Over::Max),
            peak_pressure_outer_max_gpa: race(Side::Outer, "peak_pressure", Over::Max),
            cage_speed_rpm: state.round.cage_speed_rpm,
            wear_rate_inner_um3_s: race(Side::Inner, "wear_rate", Over::Sum),
            wear_rate_outer_um3_s: race(Side::Outer, "wear_rate", Over::Sum),
            wear_rate_cage_um3_s: of(OfBall::ball("wear_rate_cage"), Over::Sum),
        }
    }

    /// What the reader of a life must know.
    fn warnings(&self) -> Vec<String> {
        let mut all = vec![
            "the life is in inverse proportion to the wear coefficients, which are orders of magnitude as a rule, and no film comes back from the cage"
                .to_owned(),
        ];
        if !self.file.case.defects.is_empty() {
            all.push("the defects of the case have no part in this".to_owned());
        }
        all
    }
}

/// The coating left on a race in a row, µm.
type Left = fn(&LifeStride) -> f64;

/// When the first of the coatings came down to a third, h: depths are linear in time within a stride.
fn steel_shows(rows: &[LifeStride], coatings: &Coatings) -> Option<f64> {
    let races: [(f64, Left); 2] = [
        (coatings.inner.thickness * 1e6, |row| row.coating_inner_min_um),
        (coatings.outer.thickness * 1e6, |row| row.coating_outer_min_um),
    ];
    let times = races.into_iter().filter(|(new, _)| *new > 0.0).filter_map(|(new, left)| {
        let limit = STEEL_SHOWS * new;
        if left(&rows[0]) <= limit {
            return Some(rows[0].time_h);
        }
        let pair = rows.windows(2).find(|pair| left(&pair[1]) <= limit)?;
        let share = (left(&pair[0]) - limit) / (left(&pair[0]) - left(&pair[1]));
        Some(pair[0].time_h + share * (pair[1].time_h - pair[0].time_h))
    });
    times.reduce(f64::min)
}
