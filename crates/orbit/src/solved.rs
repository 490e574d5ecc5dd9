//! A solved orbit, and what is needed to go on from it.

use crate::chain::Jacobian;
use crate::coarse::Coarse;
use crate::collocation::Orbit;
use crate::events::Events;
use crate::homotopy::{Regularization, swinging};
use crate::newton::OrbitStatistics;
use crate::residual::Scales;
use crate::solution::SteadyOrbit;
use crate::system::{BALL, OMEGA, ORBIT};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tribodyn_bearing::{AzimuthFrame, BallSize, BallState, Motion, OperatingPoint, Races, Side};
use tribodyn_numerics::Radau;
use tribodyn_traction::PatchRule;

/// An orbit to start a neighbouring problem from.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct OrbitStart {
    pub(crate) orbit: Orbit,
    /// Where its contacts begin and end.
    #[serde(default)]
    pub(crate) events: Events,
    /// The last Jacobian on the orbit's mesh, where there was one.
    #[serde(skip)]
    pub(crate) jacobian: Option<Jacobian>,
    pub(crate) rule: PatchRule,
    /// The same orbit by another rule: by that which a cold start begins with, where this one is by a finer one that
    /// was needed; or the other way round.
    #[serde(skip)]
    pub(crate) twin: Option<Box<OrbitStart>>,
    /// Azimuth at which the turn begins, rad.
    pub(crate) origin: f64,
    /// Rate at which the swinging of balls dies out besides, 1/s.
    pub(crate) settling: f64,
    /// Damping χ of the pockets, s/m, and stiffness that centres balls in them, N/m.
    pub(crate) pocket_damping: f64,
    pub(crate) centring: f64,
    pub(crate) regularization: Regularization,
    /// Where its mesh could not be made as fine as is asked for.
    #[serde(default)]
    pub(crate) coarse: Option<Coarse>,
    pub(crate) scales: Scales,
    /// Mean load of a ball on the inner race, N.
    pub(crate) carried: f64,
    pub(crate) speeds: Races<f64>,
}

impl OrbitStart {
    /// The start as it is read back from what was written of it.
    #[must_use]
    pub fn without_jacobian(self) -> Self {
        Self { jacobian: None, twin: None, ..self }
    }

    /// Balls, cage and ring at the instant when pocket 0 stands at azimuth 0.
    pub fn motion(&self, ball_count: usize) -> Motion {
        let (radau, orbit) = (Radau::new(), &self.orbit);
        let ball = |index: usize| {
            let pocket = TAU * index as f64 / ball_count as f64;
            let turn = orbit.cage_speed.signum() * (pocket - self.origin) / TAU;
            let [x1, x2, lead, v_a, v_r, orbital_speed, angular_velocity @ ..] = orbit.at(&radau, turn);
            let azimuth = pocket + lead;
            let frame = AzimuthFrame::at(azimuth);
            let (position, velocity, size) = ([x1, x2], [v_a, v_r], BallSize::NOMINAL);
            (azimuth, BallState { frame, position, velocity, orbital_speed, angular_velocity, size })
        };
        Motion { balls: (0..ball_count).map(ball).collect(), cage_speed: orbit.cage_speed, ring: orbit.ring }
    }

    /// The fourth corner of a parallelogram of problems: what this orbit says of one that is as far from it as `to` is
    /// from `from`. With `from` and `to` = `self` it goes on in a straight line. None where the orbits do not begin at
    /// one place or are not of equally regularized bearings.
    pub fn moved(&self, from: &Self, to: &Self) -> Option<Self> {
        let first = self.first().moved_alone(from.first(), to.first())?;
        if [self, from, to].iter().any(|start| start.twin.is_none()) {
            return Some(first);
        }
        let sharp = self.moved_alone(from, to)?;
        Some(Self { twin: Some(Box::new(first)), ..sharp })
    }

    /// By the rule that a cold start begins with.
    fn first(&self) -> &Self {
        self.twin.as_deref().unwrap_or(self)
    }

    /// [`Self::moved`], by the rules that these three are by.
    fn moved_alone(&self, from: &Self, to: &Self) -> Option<Self> {
        let alike = |other: &Self| {
            (other.origin, other.regularization, other.settling) == (self.origin, self.regularization, self.settling)
        };
        if !alike(from) || !alike(to) {
            return None;
        }
        let mut moved = Self { twin: None, ..self.clone() };
        let ends = &self.orbit.ends;
        let same = || (self.events.clone(), ends.clone(), ends.clone());
        // Without contacts that begin and end in all of them alike, unknowns are compared at the same azimuths.
        let (events, ends_from, ends_to) = self.events.moved(&from.events, &to.events).map_or_else(same, |events| {
            let [ends_from, ends_to] = [from, to].map(|other| self.events.carried(ends, &other.events));
            (events, ends_from, ends_to)
        });
        moved.orbit.shift(&Radau::new(), (&from.orbit, &ends_from), (&to.orbit, &ends_to));
        moved.orbit.ends = self.events.carried(ends, &events);
        moved.events = events;
        for side in Side::BOTH {
            moved.speeds[side] += to.speeds[side] - from.speeds[side];
        }
        Some(moved)
    }

    /// The orbit at other speeds of the rings: rolling is in proportion to them, seen from the outer ring.
    pub(crate) fn at_speeds(&self, point: &OperatingPoint) -> Orbit {
        let mut orbit = self.orbit.clone();
        let share = (point.inner_speed - point.outer_speed) / (self.speeds.inner - self.speeds.outer);
        if share.is_finite() && share > 0.0 && share != 1.0 {
            let faster = |w: f64| point.outer_speed + (w - self.speeds.outer) * share;
            orbit.cage_speed = faster(orbit.cage_speed);
            for y in orbit.values.iter_mut().flatten() {
                y[ORBIT] = faster(y[ORBIT]);
                (OMEGA..BALL).for_each(|k| y[k] *= share);
            }
        }
        orbit
    }

    /// Says what more the bearing of this orbit, and of its twin, is regularized by.
    pub(crate) fn regularize(&mut self, more: impl Fn(&mut Regularization)) {
        more(&mut self.regularization);
        if let Some(twin) = &mut self.twin {
            more(&mut twin.regularization);
        }
    }

    /// Sentences on what the orbit was found with that is not the bearing's.
    pub(crate) fn sentences(&self) -> Vec<String> {
        let swinging = swinging(self.settling / self.orbit.cage_speed.abs());
        self.regularization.sentences().into_iter().chain((self.settling > 0.0).then_some(swinging)).collect()
    }

    /// Patch rule of the orbit.
    pub fn rule(&self) -> PatchRule {
        self.rule
    }

    /// The same start for an orbit that is sought by the rule with which a cold start begins.
    #[must_use]
    pub fn by_rule(mut self, rule: PatchRule) -> Self {
        match self.twin.take() {
            Some(first) if self.rule != rule => Self { rule, twin: Some(Box::new(self)), ..*first },
            _ => Self { rule, ..self },
        }
    }

    /// A guess of an orbit by the finer rule of this start's twin, from that which was found from this start, with
    /// slopes there; none where the twin is by another rule, or on a mesh that is not alike.
    pub(crate) fn sharpened(
        &self,
        found: &Orbit,
        (point, rule): (&OperatingPoint, PatchRule),
    ) -> Option<(Orbit, Option<Jacobian>)> {
        let twin = self.twin.as_deref().filter(|twin| twin.rule == rule)?;
        let [own, sharp] = [self, twin].map(|start| start.at_speeds(point));
        if [&own, &sharp].iter().any(|orbit| orbit.intervals() != found.intervals()) {
            return None;
        }
        let mut orbit = found.clone();
        orbit.shift(&Radau::new(), (&own, &own.ends), (&sharp, &sharp.ends));
        Some((orbit, twin.jacobian.clone()))
    }
}

/// A steady orbit with what is needed to go on from it.
#[derive(Debug, Clone)]
pub struct SolvedOrbit {
    /// The orbit.
    pub solution: SteadyOrbit,
    /// Statistics of the solver.
    pub statistics: OrbitStatistics,
    /// Start for a neighbouring problem; none for a bearing at rest.
    pub start: Option<OrbitStart>,
}
