//! The contacts of a ball: what is known of each, and what acts through it.
//!
//! Vectors are [a, r, t]: axial, radial, along the orbit. Forces and moments are those on the ball.

use crate::bearing::Race;
use crate::elastic::ElasticPatches;
use crate::geometry::ContactPose;
use crate::lean::{Lean, RingOffset};
use crate::races::{Races, Side};
use crate::tribology::Tribology;
use crate::vectors::add;
use tribodyn_contact::{Ellipse, Scalar};
use tribodyn_traction::{Law, Patch, PatchLaw, PatchTraction, RelativeMotion};

/// One contact without its traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalContact<D = f64> {
    /// Contact angle and approach.
    pub pose: ContactPose<D>,
    /// Where the ring's axis stands.
    pub lean: Lean<D>,
    /// Normal load Q, N, of the elastic approach.
    pub load: D,
    /// Normal force N on ball and race, N: the load and the contact's damping, never pulling.
    pub force: D,
    /// Rate of the elastic approach, m/s; 0 where the bearing has no contact damping.
    pub closing_speed: D,
    /// Moment about the ring's axis by which the ball slides down the slope of a groove that is not round, N m.
    pub slope_moment: D,
}

/// Both contacts of a ball without their traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalLoads<D = f64> {
    /// Both contacts.
    pub contacts: Races<NormalContact<D>>,
    /// Radius of the orbit, m.
    pub orbit_radius: D,
}

impl<D: Scalar> NormalContact<D> {
    /// The normal force on the ball [a, r, t], N. It has a part along the orbit where the ring is off centre or tilted
    /// and where the groove is not round.
    #[inline(always)]
    pub fn on_ball(&self, side: Side) -> [D; 3] {
        let [n_a, n_r] = self.pose.normal(side);
        let (outward, round) = (-(self.force * n_r), self.slope_moment * self.lean.curvature);
        let (sin, cos, axial) = (self.lean.sin, self.lean.cos, -(self.force * n_a));
        [axial, outward * cos + round * sin, round * cos - outward * sin - axial * self.lean.climb]
    }

    /// The normal force on the ring [a, r, t], N: the opposite of that on the ball, or its axial and radial part where
    /// the ring's offset is taken to first order, which is the derivative of the same potential.
    #[inline(always)]
    pub fn on_ring(&self, side: Side, offset: RingOffset) -> [D; 3] {
        match offset {
            RingOffset::Exact => {
                let [a, r, t] = self.on_ball(side);
                [-a, -r, -t]
            }
            RingOffset::FirstOrder => {
                let [n_a, n_r] = self.pose.normal(side);
                [self.force * n_a, self.force * n_r, D::zero()]
            }
        }
    }
}

/// One ball–race contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaceContact<D = f64> {
    /// Contact angle, approach, load and normal force.
    pub normal: NormalContact<D>,
    /// Contact ellipse and peak pressure.
    pub ellipse: Ellipse<D>,
    /// The ball's motion against the race.
    pub motion: RelativeMotion<D>,
    /// Mean of the two surface speeds along e_t in the orbiting frame, m/s: positive at the inner, negative at the
    /// outer race for a positive inner speed. Its magnitude is V of the paper's Eq. 3.
    pub rolling_speed: D,
    /// Traction integrals.
    pub traction: PatchTraction<D>,
    /// Traction, N.
    pub traction_force: [D; 3],
    /// Normal force and traction together, N.
    pub force: [D; 3],
    /// Moment of the traction about the ball centre, N m.
    pub moment: [D; 3],
}

impl<D: Scalar> RaceContact<D> {
    /// Slide-to-roll ratios ξ_x (positive where the ball's surface is the faster) and ξ_y and spin ratio φ in 1/m, as
    /// in the paper's Eq. 3; zeros where nothing rolls.
    #[inline(always)]
    pub fn slide_to_roll(&self, ball_radius: f64) -> [D; 3] {
        let [along, across] = self.motion.centre_slip(ball_radius);
        let v = self.rolling_speed;
        // A factor and not a branch, for loops over many contacts.
        let (rolls, v) = if v.re() == 0.0 { (0.0, D::one()) } else { (1.0, v) };
        let over = v.recip() * rolls;
        [along * over, across * over.abs(), self.motion.spin * over]
    }
}

/// Everything that acts on one ball, without inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallLoads<D = f64> {
    /// Both contacts.
    pub contacts: Races<RaceContact<D>>,
    /// Radius of the orbit, m.
    pub orbit_radius: D,
    /// Fluid drag against the orbit, N.
    pub drag: D,
    /// Churning moment, N m.
    pub churning: [D; 3],
}

impl<D: Scalar> BallLoads<D> {
    /// Sum of the forces, N.
    pub fn force(&self) -> [D; 3] {
        let [a, r, t] = add(self.contacts.inner.force, self.contacts.outer.force);
        [a, r, t - self.drag]
    }

    /// Contact angles and orbit radius.
    pub fn pose(&self) -> BallPose<D> {
        BallPose {
            contacts: self.contacts.map(|c| c.normal.pose),
            lean: self.contacts.map(|c| c.normal.lean),
            orbit_radius: self.orbit_radius,
        }
    }

    /// Sum of the moments about the ball centre, N m.
    pub fn moment(&self) -> [D; 3] {
        add(add(self.contacts.inner.moment, self.contacts.outer.moment), self.churning)
    }
}

/// A patch under load, for whoever integrates its traction.
#[derive(Debug, Clone, Copy)]
pub struct LoadedPatch<'a, D> {
    /// Which race.
    pub side: Side,
    /// The race.
    pub race: &'a Race,
    /// Traction laws; absent in a bearing whose surfaces are not known.
    pub tribology: Option<&'a Tribology>,
    /// Normal load under it, N.
    pub load: D,
    /// Contact ellipse and surface.
    pub patch: Patch<D>,
    /// The ball's motion against the race.
    pub motion: RelativeMotion<D>,
    /// Mean of the two surface speeds, m/s.
    pub rolling_speed: D,
    /// Part of the coating that is gone, 0 to 1.
    pub bare: f64,
    /// Tangential elasticity; absent where the surfaces are rigid.
    pub elastic: Option<&'a ElasticPatches>,
}

impl<D: Scalar> LoadedPatch<'_, D> {
    /// The traction on coating, bare steel and transferred film by their shares, the film on top of both. Where no
    /// curve of bare steel is known the coating stands for it; where nothing is known of the surfaces they are without
    /// friction.
    pub fn blend(&self, by: impl Fn(&PatchLaw<'_, Law>) -> PatchTraction<D>) -> PatchTraction<D> {
        let Some(tribology) = self.tribology else { return PatchTraction::zero() };
        let coating = &tribology.laws[self.side];
        let by = |law| by(&tribology.patch_law(law));
        let under = || match &tribology.bare_law {
            Some(bare) if self.bare >= 1.0 => by(bare),
            Some(bare) if self.bare > 0.0 => by(coating).mixed_with(&by(bare), self.bare),
            _ => by(coating),
        };
        match &tribology.transferred {
            Some(film) if film.share >= 1.0 => by(&film.law),
            Some(film) if film.share > 0.0 => under().mixed_with(&by(&film.law), film.share),
            _ => under(),
        }
    }
}

/// The kinematics of one ball between two rings that need no traction: enough for Jones–Harris.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallPose<D = f64> {
    /// Both contacts.
    pub contacts: Races<ContactPose<D>>,
    /// Where the axes of the rings stand.
    pub lean: Races<Lean<D>>,
    /// Radius of the orbit, m.
    pub orbit_radius: D,
}
