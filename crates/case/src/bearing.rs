//! From a case to the bearing that the solvers work with.

use crate::{
    ArchardSpec, Case, CoatingSpec, CurveSpec, Fit, FluidSpec, GeometrySpec, MaterialSpec, Medium, ShouldersSpec,
    TractionSpec, TransferSpec,
};
use std::cell::RefCell;
use tribodyn_bearing::{Bearing, BearingError, BearingSpec, Dimensions, FluidForces, Geometry, Races, Tribology};
use tribodyn_contact::ElasticBody;
use tribodyn_fluid::{BallDrag, Churning, Fluid, effective_density, frontal_area};
use tribodyn_traction::{Coating, CoatingLaw, Law, Peak, PressureChoice, SlipUnit, TestedCurve};
use tribodyn_wear::{Archard, LocalSurface, Raceway, TransferLaw};

impl Case {
    /// The bearing of the case; without traction and wear unless the case has all of coatings, traction and wear.
    ///
    /// # Errors
    /// [`BearingError`] where coating, fluid or contact data do not make sense together.
    pub fn bearing(&self) -> Result<Bearing, BearingError> {
        let geometry = self.running_geometry()?;
        let radius = geometry.ball_radius();
        let worn = match &self.coatings {
            Some(coatings) => Races { inner: worn(&coatings.inner)?, outer: worn(&coatings.outer)? },
            None => Races { inner: LocalSurface::NEW, outer: LocalSurface::NEW },
        };
        let mut bearing = Bearing::new(BearingSpec {
            geometry,
            ball: elastic(&self.materials.ball),
            ball_density: self.materials.ball.density,
            rings: Races { inner: elastic(&self.materials.inner), outer: elastic(&self.materials.outer) },
            modelling: self.modelling,
            tribology: self.tribology(&geometry)?,
            fluid: self.fluid.as_ref().map(|f| fluid_forces(f, radius)).transpose()?,
            worn,
        })?;
        if let Some(deviations) = &self.deviations {
            bearing.deviations = deviations.of(geometry.ball_count)?;
        }
        Ok(bearing)
    }

    fn tribology(&self, geometry: &Geometry) -> Result<Option<Tribology>, BearingError> {
        if let (Some(lubricant), Some(wear)) = (&self.lubricant, &self.wear) {
            let rings = Races { inner: elastic(&self.materials.inner), outer: elastic(&self.materials.outer) };
            return Ok(Some(Tribology {
                laws: lubricant.laws(geometry, elastic(&self.materials.ball), rings)?,
                bare_law: None,
                transferred: None,
                differential_slip: true,
                // The film has its own: it knows speeds and local pressures.
                slip_unit: SlipUnit::MeterPerSecond,
                pressure_choice: PressureChoice::Local,
                wear: Races { inner: archard(&wear.inner), outer: archard(&wear.outer) },
                wear_cage: archard(&wear.cage),
            }));
        }
        let (Some(coatings), Some(traction), Some(wear)) = (&self.coatings, &self.traction, &self.wear) else {
            return Ok(None);
        };
        Ok(Some(Tribology {
            laws: Races {
                inner: coating_law(traction, &coatings.inner.curve)?,
                outer: coating_law(traction, &coatings.outer.curve)?,
            },
            bare_law: coatings.bare.as_ref().map(|bare| coating_law(traction, &bare.curve)).transpose()?,
            transferred: None,
            differential_slip: traction.differential_slip,
            slip_unit: traction.slip_unit,
            pressure_choice: traction.pressure,
            wear: Races { inner: archard(&wear.inner), outer: archard(&wear.outer) },
            wear_cage: archard(&wear.cage),
        }))
    }
}

impl TransferSpec {
    /// The balance of the film.
    pub fn law(&self) -> TransferLaw {
        TransferLaw { loss: self.loss, cover: self.cover, wear: archard(&self.wear) }
    }
}

impl Case {
    /// Traction law of the film that comes from the cage; absent where the case has none.
    ///
    /// # Errors
    /// [`BearingError`] for a curve that cannot be fitted.
    pub fn transferred_law(&self) -> Result<Option<Law>, BearingError> {
        let transfer = self.coatings.as_ref().and_then(|coatings| coatings.transfer.as_ref());
        let (Some(transfer), Some(traction)) = (transfer, &self.traction) else { return Ok(None) };
        coating_law(traction, &transfer.curve).map(Some)
    }
}

impl GeometrySpec {
    /// Groove coefficients and free contact angle worked out.
    ///
    /// # Errors
    /// [`BearingError::Clearance`] for a radial clearance that no contact angle has.
    pub fn resolve(&self) -> Result<Geometry, BearingError> {
        let [inner_coefficient, outer_coefficient] = self.coefficients();
        let fit = match self.fit {
            Fit::ContactAngle(angle) => tribodyn_bearing::Fit::ContactAngle(angle),
            Fit::RadialClearance(clearance) => tribodyn_bearing::Fit::RadialClearance(clearance),
        };
        let drawn = Geometry::new(Dimensions {
            ball_count: self.ball_count,
            ball_diameter: self.ball_diameter,
            pitch_diameter: self.pitch_diameter,
            inner_coefficient,
            outer_coefficient,
            fit,
        })?;
        Ok(drawn.with_shoulders(self.shoulders.map(|ShouldersSpec { inner, outer }| Races { inner, outer })))
    }
}

fn archard(spec: &ArchardSpec) -> Archard {
    Archard { coefficient: spec.coefficient, hardness: spec.hardness }
}

/// The surface of an evenly worn raceway.
fn worn(spec: &CoatingSpec) -> Result<LocalSurface, BearingError> {
    // The radius of the track matters to volumes only.
    Ok(Raceway::new(spec.thickness, spec.worn, 1.0, &[])?.at(0.0))
}

fn elastic(material: &MaterialSpec) -> ElasticBody {
    ElasticBody { young: material.young, poisson: material.poisson }
}

/// Laws that a thread keeps: of two races, what is bare between them and a film of the cage, and one to come.
const LAWS_KEPT: usize = 5;

thread_local! {
    /// The laws made last, with what they are made of. A fit takes as long as many solutions of a sweep, in whose rows
    /// the curves are mostly the same.
    static LAWS: RefCell<Vec<(TractionSpec, CurveSpec, Law)>> = const { RefCell::new(Vec::new()) };
}

fn coating_law(t: &TractionSpec, curve: &CurveSpec) -> Result<Law, BearingError> {
    let alike = |(of, c, _): &&(TractionSpec, CurveSpec, Law)| of == t && c == curve;
    if let Some(law) = LAWS.with_borrow(|laws| laws.iter().find(alike).map(|(.., law)| law.clone())) {
        return Ok(law);
    }
    let law = fitted_law(t, curve)?;
    LAWS.with_borrow_mut(|laws| {
        laws.truncate(LAWS_KEPT - 1);
        laws.insert(0, (t.clone(), curve.clone(), law.clone()));
    });
    Ok(law)
}

fn fitted_law(t: &TractionSpec, curve: &CurveSpec) -> Result<Law, BearingError> {
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
        drag: BallDrag {
            density_effective: density,
            frontal_area,
            drag_coefficient: spec.drag_coefficient,
            reynolds_per_speed: spec.drag_over_reynolds.then_some(density * 2.0 * radius / viscosity),
        },
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
    use crate::set_value;
    use tribodyn_bearing::RingCentre;

    const AG: &str = include_str!("../../../fixtures/cases/paper-handset.ron");

    fn bearing(path: &str, value: &str) -> Bearing {
        Case::from_ron(&set_value(AG, path, value).unwrap()).unwrap().bearing().unwrap()
    }

    #[test]
    fn identity_a_groove_radius_is_its_coefficient_times_the_ball_diameter() {
        let geometry = bearing("geometry.outer_groove", "Radius(mm(15.9848))").geometry;
        assert!((geometry.outer_coefficient - 0.53).abs() < 1e-15, "{}", geometry.outer_coefficient);
        assert_eq!(geometry.inner_coefficient, 0.527);
    }

    #[test]
    fn identity_a_fit_by_the_clearance_of_a_contact_angle_gives_that_angle() {
        let angle = bearing("geometry.fit", "ContactAngle(deg(20))").geometry;
        let clearance = format!("RadialClearance(m({:e}))", angle.radial_clearance());
        let same = bearing("geometry.fit", &clearance).geometry;
        assert!((same.contact_angle() - angle.contact_angle()).abs() < 1e-13);
    }

    /// Each choice of the case arrives at its own place of the bearing.
    #[test]
    fn identity_choices_and_wear_reach_the_bearing() {
        let plain = bearing("modelling.ring_centre", "Displaced");
        assert!(plain.modelling.ring_centre == Some(RingCentre::Displaced) && plain.fluid.is_some());
        assert!(!plain.modelling.contact_at_actual_angle);
        assert_eq!(bearing("modelling.ring_centre", "Inertial").modelling.ring_centre, Some(RingCentre::Inertial));
        assert!(bearing("traction.differential_slip", "false").races.inner.surface_radius.is_infinite());
        assert_eq!(bearing("wear.outer.coefficient", "3e-6").tribology.unwrap().wear.outer.coefficient, 3e-6);
        assert_eq!(plain.tribology.as_ref().unwrap().wear_cage.hardness, 60e6);
        let stiff = bearing("materials.outer.young", "GPa(400)");
        let moduli = |b: &Bearing| b.races.each_ref().map(|race| race.frozen::<f64>().effective_modulus);
        assert_eq!(moduli(&stiff).inner, moduli(&plain).inner);
        assert!(moduli(&stiff).outer > moduli(&plain).outer);
    }
}
