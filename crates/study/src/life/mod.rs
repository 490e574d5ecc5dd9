//! How long a coating lasts, or how fast clearance grows, by strides of wear between steady orbits or equilibria.
//!
//! Wear of a race counts as added radial clearance, by its mean depth round the race: the free contact angle grows and
//! the loads with it. The depth is in no other place, and the solution knows no bare steel.

mod acting;
mod rows;
mod strides;
mod table;

pub use acting::{
    ActingLife, ActingOptions, ActingStride, ActingTable, Effects, FirstThrough, Mission, Phase, acting_life,
};
pub use rows::{Life, LifeEnd, LifeStride};
pub use table::LifeTable;

use crate::error::StudyError;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;
use tribodyn::answers::{Equations, OrbitProblem};
use tribodyn::{AnswerError, CaseFile};
use tribodyn_bearing::quantities::{OfBall, Over};
use tribodyn_bearing::{BallResult, Bearing, SearchWatch, Side};
use tribodyn_case::{Case, Coatings, Fit, Purpose};
use tribodyn_orbit::{OrbitStart, SolvedOrbit, steady_orbit, steady_orbit_from};
use tribodyn_quasistatic::{Model, OperatingPoint, Solution, Solved, WarmStart, solve, solve_near};
use tribodyn_wear::{BallWear, CoatingLife, RaceWear, Raceway, WearRates};

const HOUR: f64 = 3600.0;
/// Longest stride where nothing else ends one, s: what lasts longer lasts for ever.
const FOR_EVER: f64 = 1e12;
/// Part of the new thickness that is left, averaged over the track, when the middle of the track is through (see
/// [`Raceway`]).
const STEEL_SHOWS: f64 = 1.0 / 3.0;

/// Choices of a life besides its case.
#[derive(Debug, Clone, PartialEq)]
pub struct LifeOptions {
    /// Strides in which a new coating is worn away at its fastest spot, or the clearance limit used up, 1 or more; the
    /// error falls in proportion to their number.
    pub strides: u32,
    /// Running time after which a life ends, should the coatings last longer, s.
    pub until_s: Option<f64>,
    /// Radial internal clearance, added by wear, at which a life ends, on the diameter, m: for races without coating.
    pub clearance_limit_m: Option<f64>,
    /// Equations of each stride: with traction, as nothing slides without.
    pub equations: Equations,
    /// By which the search of a stride is ended.
    pub watch: SearchWatch,
}

/// Wears the raceways of a bearing until a coating is through, or wear has added the clearance or taken the time that
/// the options allow. `progress` gets each stride as it is reached; a break ends the life there.
///
/// # Errors
/// The case makes no bearing, an equilibrium is not found, or nothing ends the life: no race has a coating, or nothing
/// wears it through, and neither clearance limit nor time is given.
pub fn wear_life(
    file: &CaseFile,
    options: LifeOptions,
    progress: impl FnMut(&LifeStride) -> ControlFlow<()>,
) -> Result<Life, StudyError> {
    worn_life(file, options, (Vec::new(), &mut |_, _| Ok(())), progress)
}

/// A finished stride with all that the next one goes on from.
#[derive(Debug, Serialize, Deserialize)]
struct Kept {
    row: LifeStride,
    warnings: Vec<String>,
    /// At the end of the stride.
    life: CoatingLife,
    start: Option<Start>,
}

/// Keeps a finished stride, by its number.
type Keep<'a> = &'a mut dyn FnMut(usize, &Kept) -> Result<(), StudyError>;

/// [`wear_life`] after some strides that are finished; `keep` gets each further one.
fn worn_life(
    file: &CaseFile,
    options: LifeOptions,
    (finished, keep): (Vec<Kept>, Keep<'_>),
    mut progress: impl FnMut(&LifeStride) -> ControlFlow<()>,
) -> Result<Life, StudyError> {
    let mut worn = Worn::new(file, options.equations)?;
    worn.point.watch = options.watch.clone();
    let loss_per_stride = 1.0 / f64::from(options.strides);
    let [inner, outer] = worn.raceways()?;
    let coated = [&inner, &outer].into_iter().any(|race| race.new_thickness() > 0.0);
    if !coated && options.until_s.is_none() && options.clearance_limit_m.is_none() {
        return Err(StudyError::NoCoating(file.name.clone()));
    }
    let mut life = CoatingLife::new(inner, outer, loss_per_stride)?;
    let until = options.until_s.unwrap_or(FOR_EVER);
    let bound = Bound::new(options.clearance_limit_m, &worn.new);
    let (mut rows, mut warnings) = (Vec::new(), Vec::new());
    for kept in finished {
        (life, worn.start) = (kept.life, kept.start);
        rows.push(kept.row);
        add_new(&mut warnings, &kept.warnings);
    }
    let ended_by = loop {
        let state = worn.state(&life)?;
        add_new(&mut warnings, &state.round.warnings);
        rows.push(worn.row(&life, &state));
        let stopped = progress(&rows[rows.len() - 1]).is_break();
        let left = until - life.elapsed();
        match () {
            () if life.worn_through().is_some() => break LifeEnd::WornThrough,
            () if bound.reached(&life) => break bound.end,
            () if stopped => break LifeEnd::Stopped,
            () if left > 1e-9 * until => {}
            () if options.until_s.is_some() => break LifeEnd::Time,
            () => return Err(StudyError::NoWear(file.name.clone())),
        }
        let rates = worn.rates(&state.round);
        let longest = left.min(bound.longest(&life, &rates, loss_per_stride)?);
        life.advance(longest, |_, _| Ok::<_, StudyError>(rates))?;
        let (row, start) = (rows[rows.len() - 1].clone(), worn.start.clone());
        keep(rows.len() - 1, &Kept { row, warnings: state.round.warnings, life: life.clone(), start })?;
    };
    warnings.extend(worn.warnings(ended_by));
    let end = rows[rows.len() - 1].clone();
    let through = [("inner", life.inner()), ("outer", life.outer())];
    Ok(Life {
        case: file.name.clone(),
        bearing: file.case.name.clone(),
        ended_by,
        worn_through: through.iter().filter(|(_, r)| r.worn_through().is_some()).map(|(name, _)| *name).collect(),
        end_h: end.time_h,
        end_revolutions: end.revolutions,
        steel_shows_h: steel_shows(&rows, worn.coatings),
        clearance_limit_um: options.clearance_limit_m.map(|limit| limit * 1e6),
        loss_per_stride,
        strides: rows,
        warnings,
    })
}

fn add_new(all: &mut Vec<String>, more: &[String]) {
    for warning in more {
        if !all.contains(warning) {
            all.push(warning.clone());
        }
    }
}

/// Radial internal clearance that wear has added, on the diameter, m.
fn growth(life: &CoatingLife) -> f64 {
    2.0 * (life.inner().mean_depth() + life.outer().mean_depth())
}

/// The clearance, added by wear, at which a life ends.
struct Bound {
    /// On the diameter, m.
    clearance: f64,
    end: LifeEnd,
}

impl Bound {
    /// The clearance asked for, but at most half of what is left until the balls no longer lie in both grooves: beyond
    /// that no bearing runs, and just before it no contact angle is left.
    fn new(asked: Option<f64>, bearing: &Bearing) -> Self {
        let g = &bearing.geometry;
        let grooves = 0.5 * (2.0 * g.centre_distance() - g.radial_clearance());
        match asked.filter(|limit| *limit <= grooves) {
            Some(clearance) => Self { clearance, end: LifeEnd::ClearanceLimit },
            None => Self { clearance: grooves, end: LifeEnd::Grooves },
        }
    }

    fn reached(&self, life: &CoatingLife) -> bool {
        growth(life) >= self.clearance * (1.0 - 1e-9)
    }

    /// Longest stride, s, that adds a part of the bound at most and does not go beyond it; endless where nothing wears.
    fn longest(&self, life: &CoatingLife, rates: &WearRates, part: f64) -> Result<f64, StudyError> {
        let [inner, outer] = life.mean_depth_rates(rates)?;
        let added = (part * self.clearance).min(self.clearance - growth(life));
        Ok(added / (2.0 * (inner + outer)))
    }
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
#[derive(Debug, Clone, Serialize, Deserialize)]
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
    /// Free contact angle, rad.
    free_angle: f64,
}

impl<'a> Worn<'a> {
    fn new(file: &'a CaseFile, equations: Equations) -> Result<Self, StudyError> {
        if equations == Equations::JonesHarris {
            return Err(StudyError::argument("model", equations.name(), "without traction nothing slides and wears"));
        }
        let new = file.bearing_for(Purpose::Traction)?;
        let coatings = file.case.coatings.as_ref().ok_or_else(|| StudyError::NoCoating(file.name.clone()))?;
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

    /// The case with the clearance that wear has added to the drawn one; mounting and running are its own.
    fn case(&self, life: &CoatingLife) -> Result<Case, StudyError> {
        let mut case = self.file.case.clone();
        let growth = growth(life);
        // There and back would cost the last digits of the angle where nothing is worn.
        if growth > 0.0 {
            let drawn = case.geometry.resolve().map_err(|source| self.file.not_usable(source.into()))?;
            case.geometry.fit = Fit::RadialClearance(drawn.radial_clearance() + growth);
        }
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
        let failed = |source| AnswerError::Solver { file: self.file.name.clone(), source };
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
        let free_angle = bearing.geometry.contact_angle();
        Ok(State { balls: solved.solution.balls.clone(), round: solved.solution, free_angle })
    }

    fn orbit(&mut self, case: &Case) -> Result<State, StudyError> {
        let failed = |source| AnswerError::Orbit { file: self.file.name.clone(), source };
        let problem = OrbitProblem::of(case).map_err(|source| self.file.not_usable(source))?;
        let OrbitProblem { bearing, cage, settings, .. } = &problem;
        let point = &OperatingPoint { watch: self.point.watch.clone(), ..problem.point.clone() };
        let solved = match &self.start {
            Some(Start::Orbit(near)) => steady_orbit_from(bearing, point, cage, settings, near),
            _ => steady_orbit(bearing, point, cage, settings),
        };
        let SolvedOrbit { solution: orbit, start, .. } = solved.map_err(failed)?;
        // Without the Jacobian: one that is taken up again does not have it.
        self.start = start.map(|start| Start::Orbit(Box::new(start.without_jacobian())));
        let round = orbit.as_solution(&orbit.points, [point.inner_speed, point.outer_speed]);
        Ok(State { balls: orbit.balls, round, free_angle: bearing.geometry.contact_angle() })
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
        LifeStride {
            time_h: time / HOUR,
            revolutions: time * turns,
            coating_inner_min_um: life.inner().thinnest() * 1e6,
            coating_outer_min_um: life.outer().thinnest() * 1e6,
            wear_depth_inner_mean_um: depths[0] * 1e6,
            wear_depth_outer_mean_um: depths[1] * 1e6,
            clearance_growth_um: growth(life) * 1e6,
            contact_angle_free_deg: state.free_angle * 180.0 / PI,
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

    /// Warnings for the reader of a life.
    fn warnings(&self, end: LifeEnd) -> Vec<String> {
        let mut all = vec![
            "the life is in inverse proportion to the wear coefficients, which are orders of magnitude as a rule, and no film comes back from the cage"
                .to_owned(),
        ];
        if !self.file.case.defects.is_empty() {
            all.push("the defects of the case have no part in this".to_owned());
        }
        if end == LifeEnd::Grooves {
            all.push(
                "wear has added half of the clearance that the grooves can hold: bearings are taken out long before; a clearance limit ends the life where yours is"
                    .to_owned(),
            );
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
