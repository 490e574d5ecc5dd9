//! A case made ready for the solvers: geometry, masses, contact constants, traction laws and fluid forces.

use crate::BearingError;
use crate::case::{Case, CoatingSpec, CurveSpec, FluidSpec, MaterialSpec, Medium, RingCentre};
use crate::geometry::Geometry;
use crate::normal::RingOffset;
use crate::races::{Races, Side};
use std::f64::consts::PI;
use tribodyn_contact::{ContactError, ElasticBody, HertzContact, Scalar, effective_modulus};
use tribodyn_fluid::{BallDrag, Churning, Fluid, effective_density, frontal_area};
use tribodyn_traction::{Coating, CoatingLaw, Law, MomentArm, Peak, PressureChoice, SlipUnit, TestedCurve};
use tribodyn_wear::{Archard, LocalSurface, Raceway};

/// A bearing that the solvers can work with, SI.
///
/// Its fields may be changed before it is solved: `bearing.races.inner.law = Law::Custom(…)` puts a traction law of one's
/// own on the inner race.
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
    /// What the fluid does; absent in a dry bearing.
    pub fluid: Option<FluidForces>,
    /// Unit of the slip axis.
    pub slip_unit: SlipUnit,
    /// Pressure at which the curve is taken.
    pub pressure_choice: PressureChoice,
    /// Arm of the traction moment.
    pub moment_arm: MomentArm,
    /// Whether contact constants follow the actual contact angle.
    pub contact_at_actual_angle: bool,
    /// Whether each ring turns about its own displaced centre, or about the inertial axis.
    pub ring_turns_about_own_centre: bool,
    /// How the rings' offsets are taken: to first order unless a transient solver asks for more.
    pub ring_offset: RingOffset,
    /// Surfaces of the raceways all round when the case begins. Their depth is part of the pose of a ball, so both solvers
    /// have it.
    pub worn: Races<LocalSurface>,
    /// Damping of the contacts along their normals, a fraction ζ of the critical one; 0 unless a transient solver sets
    /// it, since an equilibrium is at rest only in the mean where a ring is off centre.
    pub contact_damping: f64,
    /// Wear of the races.
    pub wear: Races<Archard>,
    /// Wear of the cage.
    pub wear_cage: Archard,
}

/// One raceway.
#[derive(Debug, Clone)]
pub struct Race {
    /// Contact constants at the free contact angle.
    hertz: HertzContact,
    /// Radius of the deformed contact across the groove, m; infinite without differential slip.
    pub surface_radius: f64,
    /// Traction law of the coating.
    pub law: Law,
    /// Traction law of the bare steel under it, where the case has one.
    pub bare_law: Option<Law>,
}

impl Race {
    /// The frozen contact constants as dual numbers without derivatives.
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

impl Bearing {
    /// Works out a bearing from a case.
    ///
    /// # Errors
    /// [`BearingError`] where coating, fluid or contact data do not make sense together.
    pub fn new(case: &Case) -> Result<Self, BearingError> {
        let geometry = Geometry::new(&case.geometry)?;
        let radius = geometry.ball_radius();
        let ball_mass = case.materials.ball.density * 4.0 / 3.0 * PI * radius.powi(3);
        let bare_law = case.coatings.bare.as_ref().map(|bare| coating_law(case, &bare.curve)).transpose()?;
        let race = |side, material: &MaterialSpec, coating: &CoatingSpec| {
            let modulus = effective_modulus(&elastic(&case.materials.ball), &elastic(material));
            let [rolling, lateral] = geometry.curvatures(side, geometry.cos_contact_angle());
            let hertz = HertzContact::new(rolling, lateral, modulus)?;
            let surface_radius =
                if case.traction.differential_slip { geometry.surface_radius(side) } else { f64::INFINITY };
            let law = coating_law(case, &coating.curve)?;
            Ok::<_, BearingError>(Race { hertz, surface_radius, law, bare_law: bare_law.clone() })
        };
        let wear = |spec: &crate::case::ArchardSpec| Archard { coefficient: spec.coefficient, hardness: spec.hardness };
        Ok(Self {
            geometry,
            ball_mass,
            ball_inertia: 0.4 * ball_mass * radius * radius,
            races: Races {
                inner: race(Side::Inner, &case.materials.inner, &case.coatings.inner)?,
                outer: race(Side::Outer, &case.materials.outer, &case.coatings.outer)?,
            },
            fluid: case.fluid.as_ref().map(|f| fluid_forces(f, radius)).transpose()?,
            slip_unit: case.traction.slip_unit,
            pressure_choice: case.traction.pressure,
            moment_arm: case.traction.moment_arm,
            contact_at_actual_angle: case.numerics.contact_at_actual_angle,
            ring_turns_about_own_centre: case.numerics.ring_centre == RingCentre::Displaced,
            ring_offset: RingOffset::FirstOrder,
            worn: Races { inner: worn(&case.coatings.inner)?, outer: worn(&case.coatings.outer)? },
            contact_damping: 0.0,
            wear: Races { inner: wear(&case.wear.inner), outer: wear(&case.wear.outer) },
            wear_cage: wear(&case.wear.cage),
        })
    }

    /// Azimuth of ball `index` when ball 0 is at 0, rad.
    pub fn azimuth(&self, index: usize) -> f64 {
        2.0 * PI * index as f64 / self.geometry.ball_count as f64
    }
}

/// The surface of an evenly worn raceway.
fn worn(spec: &CoatingSpec) -> Result<LocalSurface, BearingError> {
    // The radius of the track matters to volumes only.
    Ok(Raceway::new(spec.thickness, spec.worn, 1.0, &[])?.at(0.0))
}

fn elastic(material: &MaterialSpec) -> ElasticBody {
    ElasticBody { young: material.young, poisson: material.poisson }
}

fn coating_law(case: &Case, curve: &CurveSpec) -> Result<Law, BearingError> {
    let coating = match curve {
        CurveSpec::Library(name) => Coating::library(name)?,
        CurveSpec::Tested(points) => {
            let tested = points.iter().map(|p| TestedCurve {
                pressure: p.pressure,
                peak: Peak { slip: p.peak_slip, coefficient: p.peak_coefficient, residual: p.residual_coefficient },
            });
            Coating::from_tests("tested", tested.collect())?
        }
    };
    let t = &case.traction;
    let law = if t.varying {
        CoatingLaw::varying(&coating, t.order)?
    } else {
        CoatingLaw::fixed(&coating, t.order, t.reference_pressure)?
    };
    Ok(law.into())
}

fn fluid_forces(spec: &FluidSpec, radius: f64) -> Result<FluidForces, BearingError> {
    let (liquid, viscosity) = match spec.medium {
        Medium::Nitrogen { temperature, pressure } => properties(Fluid::Nitrogen, temperature, pressure)?,
        Medium::Oxygen { temperature, pressure } => properties(Fluid::Oxygen, temperature, pressure)?,
        Medium::Methane { temperature, pressure } => properties(Fluid::Methane, temperature, pressure)?,
        Medium::Custom { density, viscosity } => (density, viscosity),
    };
    let density = effective_density(spec.liquid_fraction, liquid, spec.gas_density);
    let frontal_area = frontal_area(2.0 * radius, spec.shaded_fraction);
    Ok(FluidForces {
        drag: BallDrag { density_effective: density, frontal_area, drag_coefficient: spec.drag_coefficient },
        churning: spec.churning.then_some(Churning { density, viscosity, radius }),
        swirl: spec.swirl,
        density,
        viscosity,
    })
}

fn properties(fluid: Fluid, temperature: f64, pressure: f64) -> Result<(f64, f64), BearingError> {
    let state = fluid.state(temperature, pressure)?;
    Ok((state.density, state.viscosity))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::set_value;

    fn bearing(changes: &[(&str, &str)]) -> Bearing {
        let text = include_str!("../../../fixtures/cases/paper-handset.ron").to_owned();
        let text = changes.iter().fold(text, |text, (path, value)| set_value(&text, path, value).unwrap());
        Bearing::new(&Case::from_ron(&text).unwrap()).unwrap()
    }

    /// A 30.16 mm steel ball of 7800 kg/m³: ρ π D³/6 and m D²/10.
    #[test]
    fn identity_mass_and_inertia_of_a_sphere() {
        let b = bearing(&[("materials.ball.density", "kg_per_m3(7800)")]);
        let mass = 7800.0 * PI * 0.03016f64.powi(3) / 6.0;
        assert!((b.ball_mass - mass).abs() < 1e-14 * mass);
        assert!((b.ball_inertia - 0.1 * mass * 0.03016f64.powi(2)).abs() < 1e-14 * b.ball_inertia);
    }

    #[test]
    fn limit_without_differential_slip_the_contact_is_flat() {
        let flat = bearing(&[("traction.differential_slip", "false")]);
        assert!(flat.races.inner.surface_radius.is_infinite() && flat.races.outer.surface_radius.is_infinite());
        let curved = bearing(&[("traction.differential_slip", "true")]);
        assert!(curved.races.inner.surface_radius < 2.0 * curved.geometry.ball_radius());
    }
}
