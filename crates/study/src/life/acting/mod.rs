//! Lives in which wear acts: depth over azimuth and across the groove, what it does to clearance, profile and traction,
//! and a film of lubricant that comes from the cage.
//!
//! The states of a contact, by the share of its load: *self-lubricated* where a film from the cage covers it, and of
//! the rest *pre-coated* where coating is left and *unlubricated* where it is gone. The ball in its pocket is the
//! *sacrificial* contact, which makes the film. Where the film is, it slides and wears in the place of what is below.

mod effects;
mod kept;
mod mission;
mod rows;
mod state;
mod table;

pub use effects::Effects;
pub use kept::ActingTable;
pub use mission::{Mission, Phase};
pub use rows::{ActingLife, ActingStride, FirstThrough};

use super::{LifeEnd, Start};
use crate::error::StudyError;
use kept::{Keep, Kept};
use state::{Acting, State, solved};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;
use tribodyn::CaseFile;
use tribodyn::answers::Equations;
use tribodyn_bearing::{Races, SearchWatch, Side};
use tribodyn_wear::{GrooveField, GroovePlace, TransferFilm, TransferLaw, TransferRates, UnderContact};

const HOUR: f64 = 3600.0;
/// Cubic millimetres in a cubic metre.
const MM3: f64 = 1e9;
/// Part by which the cover of the film may change in a stride, where strides are coarser than that.
const COVER_CHANGE: f64 = 0.05;

/// Choices of a life in which wear acts.
#[derive(Debug, Clone)]
pub struct ActingOptions {
    /// Effects of wear that are on.
    pub effects: Effects,
    /// Strides in which a new coating is worn away at its fastest spot, 1 or more.
    pub strides: u32,
    /// Running time after which the life ends, s.
    pub until_s: Option<f64>,
    /// Share of the load of a race on bare steel at which the life ends, above 0, at most 1.
    pub bare_limit: f64,
    /// Equations of each stride, with traction.
    pub equations: Equations,
    /// By which the search of a stride is ended.
    pub watch: SearchWatch,
}

/// The grooves of both races.
pub(super) struct Grooves {
    fields: Races<GrooveField>,
}

/// A life as it goes on.
struct Living<'a> {
    mission: &'a Mission,
    options: &'a ActingOptions,
    transfer: Option<TransferLaw>,
    grooves: Grooves,
    film: TransferFilm,
    acting: Acting,
    /// Where each phase was solved last.
    starts: Vec<Option<Start>>,
    time: f64,
    revolutions: f64,
    phase: usize,
    /// Of the phase, s.
    left: f64,
    life: ActingLife,
}

/// Wears the races of a bearing, wear acting on it as the options say, until the share of a race's load on bare steel
/// is at its limit or the time is over. `progress` gets each stride as it is reached; a break ends the life there.
///
/// # Errors
/// The case lacks coatings, the curve of bare steel or of the cage's film where effects need them; a state that cannot
/// be solved; and a bearing in which nothing wears through where no time is given.
pub fn acting_life(
    file: &CaseFile,
    mission: &Mission,
    options: &ActingOptions,
    progress: impl FnMut(&ActingStride) -> ControlFlow<()>,
) -> Result<ActingLife, StudyError> {
    acting_life_after(file, mission, options, (Vec::new(), &mut |_, _| Ok(())), progress)
}

/// [`acting_life`] after some strides that are finished; `keep` gets each further one.
fn acting_life_after(
    file: &CaseFile,
    mission: &Mission,
    options: &ActingOptions,
    (finished, keep): (Vec<Kept>, Keep<'_>),
    mut progress: impl FnMut(&ActingStride) -> ControlFlow<()>,
) -> Result<ActingLife, StudyError> {
    let mut living = Living::new(file, mission, options)?;
    finished.into_iter().for_each(|kept| living.go_on_from(kept));
    loop {
        let state = living.solve()?;
        living.note();
        let row = living.row(&state);
        let stopped = progress(&row).is_break();
        living.life.strides.push(row);
        if let Some(end) = living.end(stopped) {
            living.life.ended_by = end;
            return Ok(living.finish());
        }
        if !living.whole_cycles(&state)? {
            living.stride(&state)?;
        }
        keep(living.life.strides.len() - 1, &living.kept())?;
    }
}

impl<'a> Living<'a> {
    fn new(file: &CaseFile, mission: &'a Mission, options: &'a ActingOptions) -> Result<Self, StudyError> {
        if options.equations == Equations::JonesHarris {
            let reason = "without traction nothing slides and wears";
            return Err(StudyError::argument("model", options.equations.name(), reason));
        }
        let Some(coatings) = &file.case.coatings else { return Err(StudyError::NoCoating(file.name.clone())) };
        let lacks = |what: &str| StudyError::argument("acting", what, format!("the case needs coatings.{what} for it"));
        if options.effects.traction && coatings.bare.is_none() {
            return Err(lacks("bare"));
        }
        if options.effects.transfer && coatings.transfer.is_none() {
            return Err(lacks("transfer"));
        }
        let transfer = coatings.transfer.as_ref().filter(|_| options.effects.transfer).map(|transfer| transfer.law());
        let bearing = file.bearing()?;
        let g = &bearing.geometry;
        let fields = Races::try_from_fn(|side| {
            let outer = side == Side::Outer;
            let spec = if outer { &coatings.outer } else { &coatings.inner };
            let groove_radius = g.coefficient(side) * g.ball_diameter;
            let place = GroovePlace { groove_radius, centre_radius: g.groove_centre_radius(side), outer };
            let turning = mission.phases.iter().all(|phase| {
                let point = phase.file.case.operating_point();
                let speed = if outer { point.outer_speed } else { point.inner_speed };
                speed != 0.0 || point.inner_speed == point.outer_speed
            });
            GrooveField::new(place, spec.thickness, spec.worn, turning)
        })?;
        let worn = |field: &GrooveField| UnderContact { depth: field.deepest().depth, ..UnderContact::default() };
        let acting = Acting { under: fields.each_ref().map(worn), cover: 0.0 };
        let life = ActingLife {
            case: file.name.clone(),
            bearing: file.case.name.clone(),
            effects: options.effects.names(),
            ended_by: LifeEnd::Time,
            end_h: 0.0,
            end_revolutions: 0.0,
            first_through: None,
            bare_limit: options.bare_limit,
            loss_per_stride: 1.0 / f64::from(options.strides),
            strides: Vec::new(),
            warnings: kept::doubtful(options),
            fields: [fields.inner.clone(), fields.outer.clone()],
        };
        let starts = mission.phases.iter().map(|_| None).collect();
        Ok(Self {
            mission,
            options,
            transfer,
            grooves: Grooves { fields },
            film: TransferFilm::default(),
            acting,
            starts,
            time: 0.0,
            revolutions: 0.0,
            phase: 0,
            left: mission.phases[0].duration_s,
            life,
        })
    }

    /// The phase that runs now; what is worn acts as its contacts find it.
    fn solve(&mut self) -> Result<State, StudyError> {
        self.solve_phase(self.phase)
    }

    fn solve_phase(&mut self, phase: usize) -> Result<State, StudyError> {
        let options = (self.options.equations, &self.options.effects, &self.options.watch);
        let state = solved(&self.mission.phases[phase].file, options, &self.acting, &mut self.starts[phase])?;
        self.look(&state);
        for warning in &state.warnings {
            if !self.life.warnings.contains(warning) {
                self.life.warnings.push(warning.clone());
            }
        }
        Ok(state)
    }

    /// Takes the effect of the wear so far on the contacts from a state.
    fn look(&mut self, state: &State) {
        let cover = self.transfer.as_ref().map_or(0.0, |law| self.film.cover(law, state.film.area));
        self.acting = self.grooves.acting(state, cover);
    }

    /// Part of every contact that no film covers.
    fn uncovered(&self) -> f64 {
        1.0 - self.acting.cover
    }

    fn end(&self, stopped: bool) -> Option<LifeEnd> {
        let bare = self.acting.under.inner.bare.max(self.acting.under.outer.bare) * self.uncovered();
        match self.options.until_s {
            _ if bare >= self.options.bare_limit * (1.0 - 1e-9) => Some(LifeEnd::WornThrough),
            _ if stopped => Some(LifeEnd::Stopped),
            Some(until) if until - self.time <= 1e-9 * until => Some(LifeEnd::Time),
            _ => None,
        }
    }

    /// Until the end of the life, s.
    fn until(&self) -> f64 {
        self.options.until_s.map_or(f64::INFINITY, |until| until - self.time)
    }

    /// Longest stride that the coatings and the film allow at some rates, s.
    fn allowed(&self, rates: &Races<Vec<f64>>, film: &TransferRates) -> f64 {
        let part = self.life.loss_per_stride;
        let fields = Side::BOTH.into_iter().map(|side| {
            let uncovered = self.uncovered().max(1e-300);
            self.grooves.fields[side].longest(&rates[side], part) / uncovered
        });
        let by_film = self.transfer.map_or(f64::INFINITY, |law| self.film.longest(&law, film, part.max(COVER_CHANGE)));
        fields.fold(by_film, f64::min)
    }

    /// Lets rates act for a time; the film wears in the place of what it covers.
    fn act(&mut self, rates: &Races<Vec<f64>>, film: &TransferRates, (time, turns): (f64, f64)) {
        let mut uncovered = 1.0;
        if let Some(law) = &self.transfer {
            let (after, cover) = self.film.after(law, film, time);
            (self.film, uncovered) = (after, 1.0 - cover);
        }
        for side in Side::BOTH {
            self.grooves.fields[side].wear(&rates[side], time * uncovered);
        }
        self.time += time;
        self.revolutions += turns;
    }

    fn rates(&self, state: &State) -> Result<Races<Vec<f64>>, StudyError> {
        Ok(Races::try_from_fn(|side| self.grooves.fields[side].depth_rates(&state.wear[side]))?)
    }

    /// One stride in the phase that runs.
    fn stride(&mut self, state: &State) -> Result<(), StudyError> {
        let rates = self.rates(state)?;
        let time = self.allowed(&rates, &state.film).min(self.until()).min(self.left);
        if !time.is_finite() {
            return Err(StudyError::NoWear(self.life.case.clone()));
        }
        self.act(&rates, &state.film, (time, time * state.speed.abs() / TAU));
        self.look(state);
        self.left -= time;
        if self.left <= 1e-9 * self.mission.phases[self.phase].duration_s {
            self.phase = (self.phase + 1) % self.mission.phases.len();
            self.left = self.mission.phases[self.phase].duration_s;
        }
        Ok(())
    }

    /// A stride of whole cycles by the mean of all phases, where a cycle wears less than a stride may; `false` where it
    /// does not, or where a cycle is under way.
    fn whole_cycles(&mut self, first: &State) -> Result<bool, StudyError> {
        let cycle = self.mission.cycle_s();
        let phases = self.mission.phases.len();
        if phases < 2 || self.phase != 0 || self.left < self.mission.phases[0].duration_s || self.until() < cycle {
            return Ok(false);
        }
        let mut rates = self.rates(first)?;
        let mut film = first.film;
        let mut turns = 0.0;
        for phase in 0..phases {
            let share = self.mission.phases[phase].duration_s / cycle;
            let other;
            let state = if phase == 0 {
                first
            } else {
                other = self.solve_phase(phase)?;
                &other
            };
            let of_phase = self.rates(state)?;
            let (own, keep) = if phase == 0 { (share, 0.0) } else { (share, 1.0) };
            for side in Side::BOTH {
                let mix = |(sum, rate): (&mut f64, &f64)| *sum = keep * *sum + own * rate;
                rates[side].iter_mut().zip(&of_phase[side]).for_each(mix);
            }
            let mix = |sum: f64, value: f64| keep * sum + own * value;
            film = TransferRates {
                scraped: mix(film.scraped, state.film.scraped),
                sliding: mix(film.sliding, state.film.sliding),
                area: mix(film.area, state.film.area),
            };
            turns += self.mission.phases[phase].duration_s * state.speed.abs() / TAU;
        }
        let allowed = self.allowed(&rates, &film).min(self.until());
        if !allowed.is_finite() {
            return Err(StudyError::NoWear(self.life.case.clone()));
        }
        let cycles = (allowed / cycle).floor();
        if cycles < 1.0 {
            return Ok(false);
        }
        self.act(&rates, &film, (cycles * cycle, cycles * turns));
        self.look(first);
        Ok(true)
    }

    /// Notes where a coating is through first.
    fn note(&mut self) {
        if self.life.first_through.is_some() {
            return;
        }
        let through = Side::BOTH.into_iter().find(|side| {
            let field = &self.grooves.fields[*side];
            field.new_thickness() > 0.0 && field.thinnest() <= 1e-9 * field.new_thickness()
        });
        self.life.first_through = through.map(|side| {
            let spot = self.grooves.fields[side].deepest();
            FirstThrough {
                race: side.name().to_owned(),
                azimuth_deg: spot.azimuth.map(f64::to_degrees),
                angle_deg: spot.angle.to_degrees(),
                time_h: self.time / HOUR,
            }
        });
    }

    fn row(&self, state: &State) -> ActingStride {
        let (under, uncovered, film) = (&self.acting.under, self.uncovered(), &self.film);
        let fields = &self.grooves.fields;
        let peak =
            |side: Side| state.round.iter().map(|ball| ball.contacts[side].peak_pressure_pa).fold(0.0, f64::max) * 1e-9;
        let balls = state.wear.inner.ball_count as f64;
        let power = |side: Side| -> f64 {
            let of_ball = |k: usize| state.round[k].contacts[side].friction.map_or(0.0, |f| f.power_loss_w);
            balls * (0..state.round.len()).map(|k| state.wear.inner.part_of_orbit(k) * of_ball(k)).sum::<f64>()
        };
        let rate = |side: Side| state.wear[side].volume_rate() * uncovered * 1e18;
        ActingStride {
            time_h: self.time / HOUR,
            revolutions: self.revolutions,
            phase: (self.phase + 1) as f64,
            coating_inner_min_um: fields.inner.thinnest() * 1e6,
            coating_outer_min_um: fields.outer.thinnest() * 1e6,
            depth_under_contact_inner_um: under.inner.depth * 1e6,
            depth_under_contact_outer_um: under.outer.depth * 1e6,
            profile_curvature_inner_per_m: under.inner.curvature,
            profile_curvature_outer_per_m: under.outer.curvature,
            precoated_inner: uncovered * (1.0 - under.inner.bare),
            precoated_outer: uncovered * (1.0 - under.outer.bare),
            self_lubricated: self.acting.cover,
            unlubricated_inner: uncovered * under.inner.bare,
            unlubricated_outer: uncovered * under.outer.bare,
            worn_inner_mm3: fields.inner.volume() * MM3,
            worn_outer_mm3: fields.outer.volume() * MM3,
            scraped_mm3: film.scraped * MM3,
            film_mm3: film.volume * MM3,
            lost_mm3: film.lost * MM3,
            contact_angle_free_deg: state.free_angle * 180.0 / PI,
            peak_pressure_inner_max_gpa: peak(Side::Inner),
            peak_pressure_outer_max_gpa: peak(Side::Outer),
            cage_speed_rpm: state.cage_speed_rpm,
            friction_races_w: power(Side::Inner) + power(Side::Outer),
            wear_rate_inner_um3_s: rate(Side::Inner),
            wear_rate_outer_um3_s: rate(Side::Outer),
            wear_rate_cage_um3_s: state.film.scraped * 1e18,
        }
    }

    fn finish(self) -> ActingLife {
        let Self { mut life, grooves, time, revolutions, mission, .. } = self;
        let coefficients =
            "the life is in inverse proportion to the wear coefficients, which are orders of magnitude as a rule";
        life.warnings.push(coefficients.to_owned());
        if mission.phases.iter().any(|phase| !phase.file.case.defects.is_empty()) {
            life.warnings.push("the defects of the case have no part in this".to_owned());
        }
        (life.end_h, life.end_revolutions) = (time / HOUR, revolutions);
        life.fields = [grooves.fields.inner, grooves.fields.outer];
        life
    }
}

#[cfg(test)]
mod tests;
