//! The 13-ball bearing of `fixtures/cases/paper-handset.ron` for tests, in plain numbers and without its fluid.

use crate::{BearingSpec, Dimensions, Fit, Geometry, Modelling, Races, RingCentre, Tribology};
use tribodyn_contact::ElasticBody;
use tribodyn_traction::{Coating, CoatingLaw, Law, PressureChoice, SlipUnit};
use tribodyn_wear::Archard;

pub fn spec() -> BearingSpec {
    let geometry = Geometry::new(Dimensions {
        ball_count: 13,
        ball_diameter: 0.03016,
        pitch_diameter: 0.165,
        inner_coefficient: 0.527,
        outer_coefficient: 0.527,
        fit: Fit::ContactAngle(18f64.to_radians()),
    });
    let steel = ElasticBody { young: 200e9, poisson: 0.28 };
    let law: Law = CoatingLaw::varying(&Coating::library("ag").unwrap(), 2).unwrap().into();
    let silver = Archard { coefficient: 1e-6, hardness: 250e6 };
    let tribology = Tribology {
        laws: Races { inner: law.clone(), outer: law },
        bare_law: None,
        transferred: None,
        differential_slip: true,
        slip_unit: SlipUnit::Scaled { per_m_s: 22.0 },
        pressure_choice: PressureChoice::Peak,
        wear: Races { inner: silver, outer: silver },
        wear_cage: Archard { coefficient: 1e-6, hardness: 60e6 },
    };
    let modelling = Modelling::with_traction(false, RingCentre::Displaced);
    let dry = BearingSpec::new(geometry.unwrap(), (steel, 7800.0), modelling);
    BearingSpec { tribology: Some(tribology), ..dry }
}
