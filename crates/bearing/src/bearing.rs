//! A bearing made ready for the solvers: geometry, masses, contact constants, traction laws and fluid forces.

use crate::BearingError;
use crate::deviations::Deviations;
use crate::elastic::ElasticPatches;
use crate::geometry::Geometry;
use crate::lean::RingOffset;
use crate::modelling::{Modelling, PatchSurfaces};
use crate::races::{Races, Side};
use crate::state::BallState;
use crate::tribology::Tribology;
use std::f64::consts::PI;
use tribodyn_contact::{ContactError, ElasticBody, HertzContact, Scalar, effective_modulus};
use tribodyn_fluid::{BallDrag, Churning};
use tribodyn_traction::{FastsimRule, TractionLaw};
use tribodyn_wear::LocalSurface;

/// All that a [`Bearing`] is made of, SI.
#[derive(Debug, Clone)]
pub struct BearingSpec {
    /// Unloaded geometry.
    pub geometry: Geometry,
    /// Elastic constants of the balls.
    pub ball: ElasticBody,
    /// Density of the balls, kg/m³.
    pub ball_density: f64,
    /// Elastic constants of the rings.
    pub rings: Races<ElasticBody>,
    /// Modelling choices.
    pub modelling: Modelling,
    /// Traction and wear of the contacts; models with traction need it.
    pub tribology: Option<Tribology>,
    /// Forces of the fluid; absent in a dry bearing.
    pub fluid: Option<FluidForces>,
    /// Surfaces of the raceways all round at the beginning; [`LocalSurface::NEW`] where nothing is worn.
    pub worn: Races<LocalSurface>,
}

impl BearingSpec {
    /// A new, dry bearing with balls and rings of one material (density in kg/m³), its surfaces not known: enough for
    /// Jones–Harris.
    pub fn new(geometry: Geometry, (material, density): (ElasticBody, f64), modelling: Modelling) -> Self {
        Self {
            geometry,
            ball: material,
            ball_density: density,
            rings: Races { inner: material, outer: material },
            modelling,
            tribology: None,
            fluid: None,
            worn: Races { inner: LocalSurface::NEW, outer: LocalSurface::NEW },
        }
    }
}

/// A bearing that the solvers can work with, SI.
///
/// Its fields may be changed before it is solved: another law in the `laws` of its `tribology` is a traction law of
/// one's own on that race.
#[derive(Debug, Clone)]
pub struct Bearing {
    /// Unloaded geometry.
    pub geometry: Geometry,
    /// Ball mass, kg.
    pub ball_mass: f64,
    /// Ball moment of inertia J, kg m².
    pub ball_inertia: f64,
    /// Inner and outer race.
    pub races: Races<Race>,
    /// Forces of the fluid; absent in a dry bearing.
    pub fluid: Option<FluidForces>,
    /// Modelling choices.
    pub modelling: Modelling,
    /// Traction and wear of the contacts; models with traction need it.
    pub tribology: Option<Tribology>,
    /// How the rings' offsets are taken: to first order unless a transient solver asks for more.
    pub ring_offset: RingOffset,
    /// Surfaces of the raceways all round when the case begins. Their depth is part of the pose of a ball, so both
    /// solvers have it.
    pub worn: Races<LocalSurface>,
    /// Damping of the contacts along their normals, a fraction ζ of the critical one; 0 unless a transient solver sets
    /// it, since an equilibrium is at rest only in the mean where a ring is off centre.
    pub contact_damping: f64,
    /// Tangential elasticity of the patches; absent where their surfaces are rigid.
    pub elastic: Option<ElasticPatches>,
    /// Waviness of races and unequal balls; none unless they are put in.
    pub deviations: Deviations,
}

/// One raceway.
#[derive(Debug, Clone)]
pub struct Race {
    /// Contact constants at the free contact angle.
    hertz: HertzContact,
    /// Radius of the deformed contact across the groove, m; infinite without differential slip.
    pub surface_radius: f64,
    /// The ball's part of the elastic approach, 0 to 1: a half between bodies of one material.
    pub ball_share: f64,
}

impl Race {
    /// The frozen contact constants as dual numbers without derivatives.
    #[inline(always)]
    pub fn frozen<D: Scalar>(&self) -> HertzContact<D> {
        self.hertz.lift()
    }

    /// Contact constants for other curvatures, 1/m.
    ///
    /// # Errors
    /// [`ContactError`] for curvatures that do not make a point contact.
    pub fn hertz_at<D: Scalar>(&self, rolling: D, lateral: D) -> Result<HertzContact<D>, ContactError> {
        HertzContact::new(rolling, lateral, self.hertz.effective_modulus)
    }
}

/// Drag and churning of the fluid on a ball.
#[derive(Debug, Clone, Copy)]
pub struct FluidForces {
    /// Drag.
    pub drag: BallDrag,
    /// Churning, where wanted.
    pub churning: Option<Churning>,
    /// Speed of the fluid over that of the inner ring.
    pub swirl: f64,
    /// Effective density of the mixture, kg/m³.
    pub density: f64,
    /// Dynamic viscosity of the liquid, Pa s.
    pub viscosity: f64,
}

impl FluidForces {
    /// Drag on a ball against its orbit, N, in a fluid that turns with the inner ring.
    #[inline(always)]
    pub fn drag_on<D: Scalar>(&self, ball: &BallState<D>, orbit_radius: D, inner_speed: D) -> D {
        self.drag.force(orbit_radius * (ball.orbital_speed - inner_speed * self.swirl))
    }
}

impl Bearing {
    /// Works out masses and contact constants.
    ///
    /// ```
    /// use tribodyn_bearing::*;
    /// use tribodyn_contact::ElasticBody;
    /// use tribodyn_traction::{Coating, CoatingLaw, Law, PressureChoice, SlipUnit};
    /// use tribodyn_wear::Archard;
    ///
    /// let geometry = Geometry::new(Dimensions {
    ///     ball_count: 13,
    ///     ball_diameter: 0.03016,
    ///     pitch_diameter: 0.165,
    ///     inner_coefficient: 0.527,
    ///     outer_coefficient: 0.527,
    ///     fit: Fit::ContactAngle(18f64.to_radians()),
    /// })?;
    /// let steel = ElasticBody { young: 200e9, poisson: 0.28 };
    /// let silver: Law = CoatingLaw::varying(&Coating::library("ag")?, 2)?.into();
    /// let wear = Archard { coefficient: 1e-6, hardness: 250e6 };
    /// let tribology = Tribology {
    ///     laws: Races { inner: silver.clone(), outer: silver },
    ///     bare_law: None,
    ///     transferred: None,
    ///     differential_slip: true,
    ///     slip_unit: SlipUnit::Scaled { per_m_s: 22.0 },
    ///     pressure_choice: PressureChoice::Peak,
    ///     wear: Races { inner: wear, outer: wear },
    ///     wear_cage: Archard { coefficient: 1e-6, hardness: 60e6 },
    /// };
    /// let modelling = Modelling::with_traction(false, RingCentre::Displaced);
    /// let dry = BearingSpec::new(geometry, (steel, 7800.0), modelling);
    /// let bearing = Bearing::new(BearingSpec { tribology: Some(tribology), ..dry })?;
    /// assert!((bearing.ball_mass - 0.112).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BearingError::Contact`] for elastic constants and curvatures that do not make a point contact.
    pub fn new(spec: BearingSpec) -> Result<Self, BearingError> {
        let geometry = spec.geometry;
        let differential_slip = spec.tribology.as_ref().is_some_and(|t| t.differential_slip);
        let radius = geometry.ball_radius();
        let ball_mass = spec.ball_density * 4.0 / 3.0 * PI * radius.powi(3);
        let race = |side, ring: &ElasticBody| {
            let modulus = effective_modulus(&spec.ball, ring);
            let [rolling, lateral] = geometry.curvatures(side, geometry.cos_contact_angle());
            let hertz = HertzContact::new(rolling, lateral, modulus)?;
            let surface_radius = if differential_slip { geometry.surface_radius(side) } else { f64::INFINITY };
            let ball_share = spec.ball.compliance() / (spec.ball.compliance() + ring.compliance());
            Ok::<_, BearingError>(Race { hertz, surface_radius, ball_share })
        };
        // A film has the flexibility of its bodies in series.
        let film = spec.tribology.as_ref().is_some_and(|t| t.laws.inner.film().or(t.laws.outer.film()).is_some());
        let elastic = match spec.modelling.patch {
            Some(PatchSurfaces::Elastic { strips, cells }) if !film => {
                Some(ElasticPatches::new(FastsimRule { across: strips, cells }, &spec.ball, &spec.rings)?)
            }
            Some(PatchSurfaces::Rigid | PatchSurfaces::Elastic { .. }) | None => None,
        };
        Ok(Self {
            geometry,
            ball_mass,
            ball_inertia: 0.4 * ball_mass * radius * radius,
            races: Races { inner: race(Side::Inner, &spec.rings.inner)?, outer: race(Side::Outer, &spec.rings.outer)? },
            fluid: spec.fluid,
            modelling: spec.modelling,
            tribology: spec.tribology,
            ring_offset: RingOffset::FirstOrder,
            worn: spec.worn,
            contact_damping: 0.0,
            elastic,
            deviations: Deviations::default(),
        })
    }

    /// Gives the contacts of a race another groove radius, m, and leaves the grooves' centres where they are: what wear
    /// makes of the profile under the balls.
    ///
    /// # Errors
    /// [`BearingError::Contact`] for a groove that is not wider than the ball.
    pub fn reshape(&mut self, side: Side, groove_radius: f64) -> Result<(), BearingError> {
        let g = &self.geometry;
        let [rolling, _] = g.curvatures(side, g.cos_contact_angle());
        let ball = g.ball_radius();
        let race = &mut self.races[side];
        race.hertz = race.hertz_at(rolling, 1.0 / ball - 1.0 / groove_radius)?;
        if race.surface_radius.is_finite() {
            race.surface_radius = 2.0 * ball * groove_radius / (ball + groove_radius);
        }
        Ok(())
    }

    /// Wear rate of a race, m³/s, from the wear integral of its patch; 0 where nothing is known of the surfaces.
    pub fn wear_rate(&self, side: Side, wear_integral: f64) -> f64 {
        self.tribology.as_ref().map_or(0.0, |t| t.wear[side].rate(wear_integral))
    }

    /// Wear rate of a pocket, m³/s, from pocket force times sliding speed, W.
    pub fn pocket_wear_rate(&self, sliding_power: f64) -> f64 {
        self.tribology.as_ref().map_or(0.0, |t| t.wear_cage.rate(sliding_power))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_bearing::spec;

    /// A 30.16 mm steel ball of 7800 kg/m³: ρ π D³/6 and m D²/10.
    #[test]
    fn identity_mass_and_inertia_of_a_sphere() {
        let b = Bearing::new(BearingSpec { ball_density: 7800.0, ..spec() }).unwrap();
        let mass = 7800.0 * PI * 0.03016f64.powi(3) / 6.0;
        assert!((b.ball_mass - mass).abs() < 1e-14 * mass);
        assert!((b.ball_inertia - 0.1 * mass * 0.03016f64.powi(2)).abs() < 1e-14 * b.ball_inertia);
    }

    #[test]
    fn limit_without_differential_slip_the_contact_is_flat() {
        let with = |differential_slip| {
            let tribology = spec().tribology.map(|t| crate::Tribology { differential_slip, ..t });
            Bearing::new(BearingSpec { tribology, ..spec() }).unwrap()
        };
        let flat = with(false);
        assert!(flat.races.inner.surface_radius.is_infinite() && flat.races.outer.surface_radius.is_infinite());
        let curved = with(true);
        assert!(curved.races.inner.surface_radius < 2.0 * curved.geometry.ball_radius());
    }
}
