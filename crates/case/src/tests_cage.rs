//! A cage that is free to move: what its section holds, and refusals with their place.

use super::tests::{Refused, check_refusal};
use super::*;
use tribodyn_bearing::{CageBody, FilmExtent, PocketShape, Races, Side};

const CASE: &str = include_str!("../../../fixtures/cases/cage-6206.ron");

const REFUSED: &[Refused] = &[
    ("mass: g(7.6)", "mass: «g(0)»", "cage.free.mass", "greater than 0"),
    ("mass: g(7.6)", "mass: «7.6»", "cage.free.mass", "expected a mass with its unit"),
    ("free: (\n            mass: g(7.6),", "free: «»(", "cage.free.mass", "field `mass` is missing"),
    ("kg_mm2(2.35)", "«kg_mm2(2.2)»", "cage.free.transverse_inertia", "at least half of cage.inertia"),
    ("m_per_s2(9.81)", "«9.81»", "cage.free.gravity[0]", "expected an acceleration with its unit"),
    ("pockets: Cylinder", "pockets: «Cone»", "cage.free.pockets", "allowed: Cylinder, Sphere, RaceTrack"),
    (
        "pockets: Cylinder",
        "pockets: RaceTrack(axial_gap: «mm(-1)»)",
        "cage.free.pockets.RaceTrack.axial_gap",
        "at least 0",
    ),
    ("unbalance: um(20)", "displacement: («um(151)», um(0))", "cage.free.displacement[0]", "within ± 0.15 mm"),
    (
        "land: Outer,\n                    axial: mm(5.5)",
        "land: «Both»,\n                    axial: mm(5.5)",
        "cage.free.lands[1].land",
        "allowed: Inner, Outer",
    ),
    ("gap: mm(0.15)", "gap: «mm(3)»", "cage.free.lands[0].gap", "at most a tenth of the land's radius, 2.65 mm"),
    (
        "stiffness: N_per_um(5),\n                    damping",
        "stiffness: «N_per_um(0)»,\n                    damping",
        "cage.free.lands[0].stiffness",
        "greater than 0",
    ),
    ("radius: mm(26.5)", "radius: «mm(15)»", "cage.free.lands[0].radius", "between 23 and 32.5"),
    (
        "land: Outer,\n                    axial: mm(-5.5),\n                    radius: mm(26.5)",
        "land: Inner, axial: mm(-5.5), radius: «mm(35)»",
        "cage.free.lands[0].radius",
        "inside the pitch circle",
    ),
    ("axial: mm(5.5)", "axial: «mm(200)»", "cage.free.lands[1].axial", "within 3 ball diameters"),
    ("fill: 0.2", "fill: «0»", "cage.free.lands[0].film.fill", "leave film out of a dry land"),
    ("extent: Half", "extent: «Quarter»", "cage.free.lands[0].film.extent", "allowed: Half, Full"),
    (
        "roughness: um(2)",
        "roughness: «um(40)»",
        "cage.free.lands[0].film.roughness",
        "at most a quarter of the gap, 37.5 um",
    ),
    (
        "pocket_damping: s_per_m(0.5),",
        "pocket_damping: s_per_m(0.5), \
         guidance: «(land: Inner, radius: mm(20), width: mm(5), gap: mm(0.2))»,",
        "cage.guidance",
        "the lands of a free one are in cage.free.lands",
    ),
    (
        "ring_centre: Displaced",
        "ring_centre: Displaced, pocket_force: «AsPrinted»",
        "modelling.pocket_force",
        "leave it out with cage.free",
    ),
];

#[test]
fn limit_a_free_cage_that_cannot_be_is_refused_where_it_stands() {
    REFUSED.iter().for_each(|refused| check_refusal(CASE, *refused));
}

#[test]
fn identity_a_free_cage_is_read_to_si() {
    let inputs = Case::from_ron(CASE).unwrap().run_inputs().unwrap();
    let cage = inputs.free_cage.unwrap();
    assert_eq!((cage.mass, cage.transverse_inertia, cage.unbalance), (0.0076, 2.35e-6, 2e-5));
    assert_eq!((cage.gravity, cage.displacement, cage.pockets), ([9.81, 0.0, 0.0], [0.0; 2], PocketShape::Cylinder));
    let land = &cage.lands[1];
    assert_eq!((land.side, land.axial, land.radius, land.gap), (Side::Outer, 0.0055, 0.0265, 0.00015));
    let film = land.film.unwrap();
    assert_eq!((film.viscosity, film.extent, film.roughness), (0.017, FilmExtent::Half, 2e-6));
    let track = set_value(CASE, "cage.free.pockets", "RaceTrack(axial_gap: um(50))").unwrap();
    let cage = Case::from_ron(&track).unwrap().run_inputs().unwrap().free_cage.unwrap();
    assert_eq!(cage.pockets, PocketShape::RaceTrack { axial_gap: 5e-5 });
}

const AG: &str = include_str!("../../../fixtures/cases/paper-authors-ag.ron");

/// The cage of a 7224 in liquid nitrogen: the fluid takes what its drag torque does not, and nothing without a form.
#[test]
fn identity_the_fluid_brakes_a_cage_by_its_form() {
    let form = "(bore: mm(149.85), outside: mm(180), width: mm(37.7))";
    let with = set_value(AG, "cage.churning", form).unwrap();
    let body = |text: &str| {
        let inputs = Case::from_ron(text).unwrap().run_inputs().unwrap();
        let churning = inputs.cage.pockets.churning(&inputs.bearing);
        (CageBody::new(&inputs.cage, &inputs.bearing), churning)
    };
    let ((plain, none), (braked, churning)) = (body(AG), body(&with));
    assert!(none.is_none());
    let rings = Races { inner: 1466.0, outer: 0.0 };
    for speed in [607.0f64, -607.0] {
        let [[_, drag], [_, all]] = [plain, braked].map(|cage| cage.fluid_torques(speed, rings));
        let moments = churning.unwrap().moments(speed);
        assert!((all - drag + moments.sum()).abs() < 1e-12);
        // Faces alone 2.0 N m, of 4.7.
        assert!((moments.faces.abs() - 2.03).abs() < 0.02 && (moments.sum().abs() - 4.68).abs() < 0.03, "{moments:?}");
    }
    let refused: &[Refused] = &[
        (
            "outside: mm(180)",
            "outside: «mm(140)»",
            "cage.churning.outside",
            "greater than cage.churning.bore, 149.85 mm",
        ),
        ("width: mm(37.7)", "width: «mm(0)»", "cage.churning.width", "greater than 0"),
        ("bore: mm(149.85)", "bore: «149.85»", "cage.churning.bore", "expected a length with its unit"),
    ];
    refused.iter().for_each(|refused| check_refusal(&with, *refused));
}
