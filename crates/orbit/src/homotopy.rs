//! The homotopy to an orbit that Newton's method does not find at once: from balls that soft springs hold in their
//! pockets, and that are heavy enough to keep to the outer race, to those of the bearing.

use crate::OrbitError;
use crate::start::{centrifugal_force, mean_load};
use crate::system::OrbitSystem;
use tribodyn_bearing::Bearing;
use tribodyn_quasistatic::RollingStart;
use tribodyn_traction::{FastPatch, PatchRule};

/// The cheap rule on which the neighbourhood of an orbit is found.
pub(crate) const SCOUT: PatchRule = PatchRule::SplitStrip { across: 5, along: 3 };
/// Centrifugal force of a ball over the mean load of a ball, at its beginning, and the least that balls of
/// slow bearings are given: what weighs so little has no part in what others carry, and balls that nothing holds come
/// to rest in a turn.
const HEAVIEST: f64 = 0.03;
pub(crate) const LIGHTEST: f64 = 1e-4;
/// Bearings with balls from heavy to real.
const RUNGS: usize = 13;
/// Friction over load by which the softest pockets are chosen.
const FRICTION: f64 = 0.01;

/// By how much an orbit's bearing is not that of the case.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub(crate) struct Regularization {
    /// Mass of a ball over the real one.
    pub ball_mass: f64,
    /// Stiffness of the pockets over the real one.
    pub pocket_stiffness: f64,
    /// Damping ratio that the contacts have at least, where that is more than every orbit's; else 0.
    pub contact_damping: f64,
}

impl Regularization {
    /// The case's own bearing.
    pub const NONE: Self = Self { ball_mass: 1.0, pocket_stiffness: 1.0, contact_damping: 0.0 };

    /// The bearing with its balls and the damping of its contacts.
    pub fn of(&self, bearing: &Bearing) -> Bearing {
        let mut regularized = bearing.clone();
        regularized.ball_mass *= self.ball_mass;
        regularized.ball_inertia *= self.ball_mass;
        regularized.contact_damping = regularized.contact_damping.max(self.contact_damping);
        regularized
    }

    /// Sentences on what an orbit was found with that is not the bearing's.
    pub fn sentences(&self) -> Vec<String> {
        let heavy = (self.ball_mass != 1.0).then(|| {
            format!(
                "the balls are {} times heavier than given, so that those without load stay on the outer race; their \
                 centrifugal force is still negligible beside the bearing's load",
                said(self.ball_mass, 3)
            )
        });
        let soft = (self.pocket_stiffness != 1.0).then(|| {
            format!(
                "no orbit was found with the given stiffness of the pockets: this one has pockets {} times softer",
                said(1.0 / self.pocket_stiffness, 3)
            )
        });
        let damped = (self.contact_damping > 0.0).then(|| {
            format!(
                "balls without load bounce on their races without end: this orbit has contacts with a damping ratio of \
                 {}, which stops them",
                said(self.contact_damping, 1)
            )
        });
        heavy.into_iter().chain(soft).chain(damped).collect()
    }
}

/// A number as one would say it: to so many digits, without an exponent between 1e-6 and a million.
pub(crate) fn said(value: f64, digits: usize) -> String {
    let size = value.abs().max(f64::MIN_POSITIVE);
    let places = (digits as i32 - 1 - size.log10().floor() as i32).max(0);
    if (1e-6..1e6).contains(&size) {
        format!("{value:.*}", places as usize)
    } else {
        format!("{value:.*e}", digits - 1)
    }
}

/// Mass of a ball over the real one with which its centrifugal force is at least a share of the mean load of a ball.
pub(crate) fn mass_factor(share: f64, bearing: &Bearing, (start, cage_speed): (&RollingStart, f64)) -> f64 {
    (share * mean_load(start) / centrifugal_force(bearing, cage_speed)).max(1.0)
}

/// The bearing with balls from heavy ones to those that it is solved with, each with the factor of their mass.
pub(crate) fn ladder(bearing: &Bearing, rolling: (&RollingStart, f64)) -> Vec<(f64, Bearing)> {
    let [first, last] = [HEAVIEST, LIGHTEST].map(|share| mass_factor(share, bearing, rolling));
    let rung = |k: usize| {
        // The end of the homotopy is exact.
        let part = k as f64 / (RUNGS - 1) as f64;
        let ball_mass = if k == RUNGS - 1 { last } else { first * (last / first).powf(part) };
        (ball_mass, Regularization { ball_mass, ..Regularization::NONE }.of(bearing))
    };
    (0..RUNGS).map(rung).collect()
}

/// The homotopy, as a parameter goes from 0 to 1.
pub(crate) struct Homotopy<'a> {
    ladder: &'a [(f64, Bearing)],
    /// Stiffness of the pockets, soft and real, N/m.
    stiffness: [f64; 2],
    /// Stiffness that draws balls to the middle of their pockets, at first and at the end, N/m.
    centring: [f64; 2],
    /// Patches before its end and at it.
    kernels: [FastPatch; 2],
}

impl<'a> Homotopy<'a> {
    /// Of a bearing with `force` N on a ball.
    pub fn new(
        system: &OrbitSystem<'a>,
        ladder: &'a [(f64, Bearing)],
        (start, force): (&RollingStart, f64),
    ) -> Result<Self, OrbitError> {
        let mean = mean_load(start);
        let pocket = &system.cage.pocket;
        let gap = (pocket.clearance * pocket.radius).max(1e-3 * system.bearing.geometry.ball_diameter);
        let soft = (FRICTION * mean.max(1e-3 * force) / gap).min(0.1 * pocket.stiffness);
        Ok(Self {
            ladder,
            stiffness: [soft, pocket.stiffness],
            centring: [soft, system.centring],
            kernels: [FastPatch::new(SCOUT)?, system.kernel.clone()],
        })
    }

    /// Puts the system at a place of the homotopy.
    pub fn set(&self, system: &mut OrbitSystem<'a>, share: f64) {
        let between = |[first, last]: [f64; 2]| if share == 1.0 { last } else { first * (last / first).powf(share) };
        system.bearing = &self.ladder[self.rung(share)].1;
        system.cage.pocket.stiffness = between(self.stiffness);
        system.centring = between(self.centring);
        system.kernel = self.kernels[usize::from(share == 1.0)].clone();
    }

    /// The same with the patches of its end.
    pub fn set_fine(&self, system: &mut OrbitSystem<'a>, share: f64) {
        self.set(system, share);
        system.kernel = self.kernels[1].clone();
    }

    /// The cheap patches.
    pub fn scout(&self) -> FastPatch {
        self.kernels[0].clone()
    }

    /// By how much the bearing at a place is not that of the case.
    pub fn regularization(&self, share: f64) -> Regularization {
        let pocket_stiffness =
            if share == 1.0 { 1.0 } else { (self.stiffness[0] / self.stiffness[1]).powf(1.0 - share) };
        Regularization { ball_mass: self.ladder[self.rung(share)].0, pocket_stiffness, ..Regularization::NONE }
    }

    fn rung(&self, share: f64) -> usize {
        (share * (self.ladder.len() - 1) as f64) as usize
    }
}

/// Sentence on balls that are damped at so many times the cage speed.
pub(crate) fn swinging(rate: f64) -> String {
    format!(
        "lightly loaded balls keep swinging in their grooves: on this orbit the swinging is damped at {rate:.0} times \
         the cage speed"
    )
}
