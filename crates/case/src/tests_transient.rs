//! The sections of a transient run: what they hold, and refusals with their place.

use super::tests::{Refused, check_refusal};
use super::*;
use tribodyn_bearing::{Scheme, Start};

const WORN: &str = include_str!("../../../fixtures/cases/paper-ag-worn.ron");
const AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");

#[rustfmt::skip]
const READING: &[Refused] = &[
    ("mass: kg(12)", "mass: «12»", "supports.inner.mass", "expected a mass with its unit, such as kg(2.5); allowed units: kg, g"),
    ("mass: kg(12)", "mass: «kg(inf)»", "supports.inner.mass", "the number must be finite"),
    ("inner: (\n            mass: kg(12),", "inner: «»(", "supports.inner.mass", "field `mass` is missing"),
    ("mass: kg(6),", "mass: kg(6), «preload»: N(3),", "supports.outer.preload", "allowed: mass, stiffness, damping"),
    ("(N_per_um(100), N_per_um(100), N_per_um(50))", "«(N_per_um(100), N_per_um(100))»", "supports.inner.stiffness", "expected 3 values in parentheses, each such as N_per_um(10) but found 2"),
    ("(N_per_um(200), N_per_um(200))", "«(N_per_um(200), N_per_um(200), N_per_um(200))»", "supports.outer.stiffness", "more values than belong"),
    ("(N_per_um(200), N_per_um(200))", "«[N_per_um(200), N_per_um(200)]»", "supports.outer.stiffness", "values in parentheses"),
    ("N_per_um(50))", "«N_s_per_m(50)»)", "supports.inner.stiffness[2]", "allowed units: N_per_m, N_per_um"),
    ("N_s_per_m(1500))", "«N_per_um(1500)»)", "supports.inner.damping[2]", "allowed units: N_s_per_m"),
    ("race: Outer, azimuth", "race: «Middle», azimuth", "defects[0].race", "`Middle` is not known here; allowed: Inner, Outer"),
    ("width: deg(3)", "width: «mm(3)»", "defects[0].width", "allowed units: rad, deg, mrad"),
    ("depth: um(2), bare: 1)", "depth: um(2), bare: 1, «length»: 3)", "defects[0].length", "allowed: race, azimuth, width, depth, bare"),
    ("(race: Outer, azimuth: deg(0), width: deg(3), depth: um(2), bare: 1)", "«»(race: Outer, azimuth: deg(0), width: deg(3), depth: um(2))", "defects[0].bare", "field `bare` is missing"),
    ("worn: 0.5", "worn: «um(5)»", "coatings.inner.worn", "expected a plain number"),
    ("bare: (curve: Library(\"bare-440c\")),", "bare: «»(),", "coatings.bare.curve", "field `curve` is missing"),
    ("inertia: kg_m2(0.0021)", "inertia: «kg(0.0021)»", "cage.inertia", "expected a moment of inertia with its unit, such as kg_m2(0.004)"),
    ("pocket_damping: s_per_m(0.5)", "pocket_damping: «0.5»", "cage.pocket_damping", "allowed units: s_per_m"),
    ("land: Outer, radius", "land: «Both», radius", "cage.guidance.land", "allowed: Inner, Outer"),
    ("width: mm(12), gap: mm(0.25)),", "width: mm(12), gap: mm(0.25), «gap»: mm(0.25)),", "cage.guidance.gap", "twice"),
    ("start: QuasiStatic", "start: «Running»", "transient.start", "allowed: QuasiStatic, SteadyOrbit, Rest"),
    ("DormandPrince(tolerance", "«Euler(tolerance: 1e-6, longest: us(10))», tolerance: (tolerance", "transient.scheme", "`Euler` is not known here; allowed: RungeKutta4, DormandPrince, Fast"),
    ("longest: us(10)", "«shortest»: us(10)", "transient.scheme.DormandPrince.shortest", "allowed: tolerance, longest"),
    ("longest: us(10)", "longest: «Hz(10)»", "transient.scheme.DormandPrince.longest", "allowed units: s, ms, us"),
    ("duration: s(0.05)", "duration: «0.05»", "transient.duration", "expected a time with its unit"),
    ("kHz(6.4)", "«ms(6.4)»", "recording.ball_rate", "expected a rate with its unit, such as kHz(25.6); allowed units: Hz, kHz"),
];

#[rustfmt::skip]
const IMPOSSIBLE: &[Refused] = &[
    ("mass: kg(12)", "mass: «g(0)»", "supports.inner.mass", "greater than 0"),
    ("mass: kg(6)", "mass: «kg(-6)»", "supports.outer.mass", "greater than 0"),
    ("N_per_um(50))", "«N_per_um(-50)»)", "supports.inner.stiffness[2]", "at least 0"),
    ("(N_per_um(200), N_per_um(200))", "(N_per_um(200), «N_per_um(0)»)", "supports.outer.stiffness[1]", "nothing else holds the outer ring"),
    ("N_s_per_m(1500))", "«N_s_per_m(-1)»)", "supports.inner.damping[2]", "at least 0"),
    ("width: deg(3)", "width: «deg(0)»", "defects[0].width", "greater than 0° and less than 360°"),
    ("width: deg(3)", "width: «deg(360)»", "defects[0].width", "greater than 0° and less than 360°"),
    ("depth: um(2)", "depth: «um(-2)»", "defects[0].depth", "between 0 and a hundredth of the ball diameter, 301.6 um"),
    ("depth: um(2)", "depth: «mm(2)»", "defects[0].depth", "between 0 and a hundredth of the ball diameter, 301.6 um"),
    ("bare: 1)", "bare: «1.5»)", "defects[0].bare", "between 0 and 1"),
    ("worn: 0.5", "worn: «-0.5»", "coatings.inner.worn", "between 0 and 1"),
    ("worn: 0.5),\n        bare", "worn: «NaN»),\n        bare", "coatings.outer.worn", "between 0 and 1"),
    ("Library(\"bare-440c\")", "Library(«\"rust\"»)", "coatings.bare.curve.Library", "allowed: ag, ptfe, bare-440c"),
    ("Library(\"bare-440c\")", "Tested(«[]»)", "coatings.bare.curve.Tested", "at least one tested point"),
    ("Library(\"bare-440c\")", "Tested([(pressure: GPa(3), peak_slip: 3.3, peak_coefficient: «0.4», residual_coefficient: 0.42)])", "coatings.bare.curve.Tested[0].peak_coefficient", "greater than the residual coefficient, 0.42"),
    ("inertia: kg_m2(0.0021)", "inertia: «kg_mm2(0)»", "cage.inertia", "greater than 0"),
    ("pocket_damping: s_per_m(0.5)", "pocket_damping: «s_per_m(-0.5)»", "cage.pocket_damping", "at least 0"),
    ("radius: mm(90.25)", "radius: «mm(0)»", "cage.guidance.radius", "greater than 0"),
    ("radius: mm(90.25)", "radius: «mm(30)»", "cage.guidance.radius", "a land of the outer ring is outside"),
    ("width: mm(12)", "width: «mm(-12)»", "cage.guidance.width", "greater than 0"),
    ("gap: mm(0.25)", "gap: «mm(0)»", "cage.guidance.gap", "greater than 0 and at most a tenth of the land's radius, 9.025 mm"),
    ("gap: mm(0.25)", "gap: «mm(10)»", "cage.guidance.gap", "at most a tenth of the land's radius, 9.025 mm"),
    ("duration: s(0.05)", "duration: «s(0)»", "transient.duration", "greater than 0 s and at most 10000 s"),
    ("duration: s(0.05)", "duration: «s(1e5)»", "transient.duration", "at most 10000 s"),
    ("tolerance: 1e-6,", "tolerance: «0.1»,", "transient.scheme.DormandPrince.tolerance", "between 1e-13 and 0.01"),
    ("longest: us(10)", "longest: «ms(1)»", "transient.scheme.DormandPrince.longest", "between 1e-12 s and 1e-4 s"),
    ("DormandPrince(tolerance: 1e-6, longest: us(10))", "Fast(step: «us(0)»)", "transient.scheme.Fast.step", "between 1e-12 s and 1e-4 s"),
    ("DormandPrince(tolerance: 1e-6, longest: us(10))", "RungeKutta4(step: «us(200)»)", "transient.scheme.RungeKutta4.step", "between 1e-12 s and 1e-4 s"),
    ("DormandPrince(tolerance: 1e-6, longest: us(10))", "RungeKutta4(step: «s(1e-300)»)", "transient.scheme.RungeKutta4.step", "between 1e-12 s and 1e-4 s"),
    ("longest: us(10)", "longest: «s(1e-13)»", "transient.scheme.DormandPrince.longest", "between 1e-12 s and 1e-4 s"),
    ("contact_damping: 0.02", "contact_damping: «2»", "transient.contact_damping", "between 0 and 1"),
    ("wear_acceleration: 0", "wear_acceleration: «-1»", "transient.wear_acceleration", "at least 0"),
    ("kHz(25.6)", "«Hz(0)»", "recording.state_rate", "greater than 0 Hz and at most 1 MHz"),
    ("kHz(25.6)", "«kHz(1001)»", "recording.state_rate", "at most 1 MHz"),
    ("kHz(6.4)", "«kHz(25.7)»", "recording.ball_rate", "must not exceed recording.state_rate"),
];

#[test]
fn limit_unreadable_values_are_refused_where_they_stand() {
    READING.iter().for_each(|row| check_refusal(WORN, *row));
}

#[test]
fn limit_impossible_values_are_refused_where_they_stand() {
    IMPOSSIBLE.iter().for_each(|row| check_refusal(WORN, *row));
}

#[test]
fn limit_worn_coatings_and_bare_defects_need_the_curve_of_bare_steel() {
    let bare = "        bare: (curve: Library(\"bare-440c\")),\n";
    let source = WORN.lines().find(|line| line.contains("\"coatings.bare\"")).unwrap();
    let text = WORN.replacen(bare, "", 1).replacen(source, "", 1);
    check_refusal(&text, ("worn: 0.5", "worn: «0.5»", "coatings.inner.worn", "add coatings.bare"));
    let text = text.replacen("worn: 0.5", "worn: 0", 2);
    check_refusal(&text, ("bare: 1)", "bare: «1»)", "defects[0].bare", "add coatings.bare"));
    let case = Case::from_ron(&text.replacen("bare: 1)", "bare: 0)", 1)).unwrap();
    assert_eq!((case.coatings.unwrap().bare, case.defects[0].bare), (None, 0.0));
}

/// A curve for bare steel obeys the order of the polynomials as the coatings' do.
#[test]
fn limit_bare_curve_needs_as_many_tests_as_the_order_asks_for() {
    let point = "(pressure: GPa(3), peak_slip: 3.3, peak_coefficient: 0.46, residual_coefficient: 0.42)";
    let one = set_value(WORN, "coatings.bare.curve", &format!("Tested([{point}])")).unwrap();
    check_refusal(&one, ("order: 2", "order: «2»", "traction.order", "coatings.bare has 1"));
    assert!(Case::from_ron(&set_value(&one, "traction.order", "0").unwrap()).is_ok());
}

#[test]
fn limit_too_many_samples_are_refused_with_their_number() {
    let text = set_value(WORN, "transient.duration", "s(10000)").unwrap();
    let text = set_value(&text, "recording.ball_rate", "kHz(100)").unwrap();
    let row = ("kHz(25.6)", "«kHz(200)»", "recording.state_rate", "2000000000 samples in 10000 s; allowed are 1e9");
    check_refusal(&text, row);
}

#[test]
fn identity_sections_are_read_to_si() {
    let case = Case::from_ron(WORN).unwrap();
    let supports = case.supports.unwrap();
    assert_eq!((supports.inner.mass, supports.inner.stiffness), (12.0, [1e8, 1e8, 5e7]));
    assert_eq!((supports.outer.stiffness, supports.outer.damping), ([2e8; 2], [2000.0; 2]));
    let (coatings, cage) = (case.coatings.unwrap(), case.cage.unwrap());
    assert_eq!((coatings.inner.worn, coatings.outer.worn), (0.5, 0.5));
    assert_eq!((cage.inertia, cage.pocket_damping), (Some(0.0021), 0.5));
    let land = cage.guidance.unwrap();
    assert_eq!(
        (land.land, land.radius, land.width, land.gap),
        (tribodyn_bearing::Side::Outer, 0.09025, 0.012, 0.00025)
    );
    let [defect] = &case.defects[..] else { panic!("{:?}", case.defects) };
    assert_eq!(
        (defect.race, defect.azimuth, defect.depth, defect.bare),
        (tribodyn_bearing::Side::Outer, 0.0, 2e-6, 1.0)
    );
    assert_eq!(defect.width, 3f64.to_radians());
    let transient = case.transient.unwrap();
    assert_eq!((transient.duration, transient.start), (0.05, Start::QuasiStatic));
    assert_eq!(transient.scheme, Scheme::DormandPrince { tolerance: 1e-6, longest: 1e-5 });
    assert_eq!(case.recording, Some(RecordingSpec { state_rate: 25600.0, ball_rate: 6400.0 }));
}

#[test]
fn limit_everything_of_a_transient_run_can_be_left_out_or_written_as_an_option() {
    let case = Case::from_ron(include_str!("../../../fixtures/cases/paper-handset.ron")).unwrap();
    assert!(case.supports.is_none() && case.defects.is_empty() && case.transient.is_none());
    let (coatings, cage) = (case.coatings.unwrap(), case.cage.unwrap());
    assert!(case.recording.is_none() && coatings.bare.is_none() && coatings.inner.worn == 0.0);
    assert!(cage.inertia.is_none() && cage.guidance.is_none() && cage.pocket_damping == 0.0);
    let expected = Case::from_ron(WORN).unwrap();
    for path in ["supports", "transient", "recording", "cage.guidance", "cage.inertia", "coatings.bare"] {
        let value = &WORN[locate(WORN, path).unwrap()];
        let text = set_value(WORN, path, &format!("Some({value})")).unwrap();
        assert_eq!(Case::from_ron(&text), Ok(expected.clone()), "{path}");
        // Without bare steel the worn coatings are refused, without supports the sources of what is in them.
        let none = Case::from_ron(&set_value(WORN, path, "None").unwrap()).map_err(|error| error.path);
        match path {
            "coatings.bare" => assert_eq!(none, Err("coatings.inner.worn".into())),
            "supports" => assert_eq!(none, Err("sources[\"supports.inner\"]".into())),
            _ => assert!(none.is_ok(), "{path}"),
        }
    }
}

/// The worn case is the Ag case but for what a worn, transient run adds.
#[test]
fn identity_the_worn_case_shares_the_steady_values_of_the_ag_case() {
    let (ag, mut worn) = (Case::from_ron(AG).unwrap(), Case::from_ron(WORN).unwrap());
    worn.name.clone_from(&ag.name);
    worn.coatings.clone_from(&ag.coatings);
    worn.cage.clone_from(&ag.cage);
    worn.supports.clone_from(&ag.supports);
    worn.transient.clone_from(&ag.transient);
    worn.recording = ag.recording;
    worn.defects.clear();
    worn.sources.clone_from(&ag.sources);
    assert_eq!(worn, ag);
}

#[test]
fn identity_units_of_the_transient_sections_give_the_closest_number_in_si() {
    type Reader = fn(&mut ron::Deserializer<'_>) -> ron::Result<f64>;
    #[rustfmt::skip]
    let rows: &[(Reader, &[(&str, f64)])] = &[
        (|d| units::time(d), &[("s(2)", 2.0), ("ms(0.3)", 0.0003), ("us(10)", 1e-5)]),
        (|d| units::mass(d), &[("kg(2.5)", 2.5), ("g(303)", 0.303)]),
        (|d| units::inertia(d), &[("kg_m2(0.004)", 0.004), ("kg_mm2(2100)", 0.0021)]),
        (|d| units::frequency(d), &[("Hz(50)", 50.0), ("kHz(25.6)", 25600.0)]),
        (|d| units::slowness(d), &[("s_per_m(0.5)", 0.5)]),
    ];
    for (reader, values) in rows {
        for (text, expected) in *values {
            assert_eq!(reader(&mut ron::Deserializer::from_str(text).unwrap()), Ok(*expected), "{text}");
        }
    }
    let mut three = ron::Deserializer::from_str("(N_s_per_m(1), N_s_per_m(2.5), N_s_per_m(0))").unwrap();
    assert_eq!(units::dampings(&mut three), Ok([1.0, 2.5, 0.0]));
}
