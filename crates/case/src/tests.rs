//! The case file as a whole: fixtures, refusals with their place, paths, units.

use super::outline::Segment;
use super::*;

const AG: &str = include_str!("../../../fixtures/cases/paper-handset.ron");
const IDENTIFIED: &str = include_str!("../../../fixtures/cases/paper-ag.ron");
const PTFE: &str = include_str!("../../../fixtures/cases/paper-ptfe.ron");
const WORN: &str = include_str!("../../../fixtures/cases/paper-ag-worn.ron");
const BEARING_218: &str = include_str!("../../../fixtures/cases/bearing-218.ron");

/// A refusal: a text in the Ag case, what replaces it with «» around the place that the error must point at (only its
/// start where nothing is between), the path, and a part of the message.
pub(super) type Refused = (&'static str, &'static str, &'static str, &'static str);

#[rustfmt::skip]
const READING: &[Refused] = &[
    ("ball_diameter: mm", "«ball_diametre»: mm", "geometry.ball_diametre", "unknown field `ball_diametre`; allowed: ball_count, ball_diameter"),
    ("numerics: (", "numerics: ( «steps»: 3,", "numerics.steps", "unknown field"),
    ("mm(30.16)", "«N(30.16)»", "geometry.ball_diameter", "allowed units: m, mm, um, inch"),
    ("mm(30.16)", "«30.16»", "geometry.ball_diameter", "expected a length with its unit, such as mm(30.16)"),
    ("mm(30.16)", "«mm(NaN)»", "geometry.ball_diameter", "NaN is not allowed: the number must be finite"),
    ("mm(30.16)", "«mm(inf)»", "geometry.ball_diameter", "the number must be finite"),
    ("mm(30.16)", "«mm(1e999)»", "geometry.ball_diameter", "the number must be finite"),
    ("mm(30.16)", "«mm(30,16)»", "geometry.ball_diameter", "more values"),
    ("GPa(200)", "«GPa(1e300)»", "materials.ball.young", "too large for a number in SI"),
    ("deg(18)", "«mm(18)»", "geometry.fit.ContactAngle", "allowed units: rad, deg, mrad"),
    ("geometry: (\n        ball_count: 13,", "geometry: «»(", "geometry.ball_count", "field `ball_count` is missing"),
    ("    cage: (", "    «kage»: (", "kage", "unknown field `kage`; allowed: name, geometry"),
    ("ball_count: 13,", "ball_count: 13, «ball_count»: 12,", "geometry.ball_count", "twice"),
    ("ball_count: 13,", "ball_count: «13.5»,", "geometry.ball_count", "expected a whole number"),
    ("ball_count: 13,", "ball_count: «-13»,", "geometry.ball_count", "not negative"),
    ("ball_count: 13,", "ball_count: «\"13\"»,", "geometry.ball_count", "expected a whole number"),
    ("ball_count: 13,\n        ", "ball_count: 13\n        «»", "geometry", "not well-formed RON: expected comma"),
    ("poisson: 0.28", "poisson: «GPa(0.28)»", "materials.ball.poisson", "expected a plain number"),
    ("varying: true", "varying: «1»", "traction.varying", "expected true or false"),
    ("pressure: Peak", "pressure: «Mean»", "traction.pressure", "`Mean` is not known here; allowed: Peak, Local"),
    ("relative: 1e-5", "«absolute»: 1e-5", "traction.patch.TargetError.absolute", "allowed: relative"),
    ("Force(kN(20))", "«kN(20)»", "ring.x", "allowed: Force, ForceTable, Held"),
    ("Force(kN(20))", "ForceTable([(s(0), kN(0)), (s(1), «s(2)»)])", "ring.x.ForceTable[1][1]", "allowed units: N, kN"),
    ("Force(kN(20))", "ForceTable([(s(0), kN(0)), «(s(1))»])", "ring.x.ForceTable[1]", "a row of time and value"),
    ("Force(kN(20))", "ForceTable([(s(0), «kN(NaN)»)])", "ring.x.ForceTable[0][1]", "must be finite"),
    ("\"geometry.fit\": Published", "«geometry.fit»: Published", "sources[\"geometry.fit\"]", "a string in quotes"),
];

#[rustfmt::skip]
const IMPOSSIBLE: &[Refused] = &[
    ("mm(30.16)", "«mm(-30.16)»", "geometry.ball_diameter", "greater than 0"),
    ("mm(30.16)", "/* ø 30 µm */ «mm(0)»", "geometry.ball_diameter", "greater than 0"),
    ("mm(165)", "«mm(30.16)»", "geometry.pitch_diameter", "greater than the ball diameter, 30.16 mm"),
    ("ball_count: 13", "ball_count: «1»", "geometry.ball_count", "at least 2"),
    ("ball_count: 13", "ball_count: «18»", "geometry.ball_count", "too many balls: sin(π/18) × pitch diameter = 28.6519 mm must exceed the ball diameter, 30.16 mm; at most 17 fit"),
    ("Coefficient(0.527)", "Coefficient(«0.5»)", "geometry.inner_groove.Coefficient", "above 0.5"),
    ("Coefficient(0.527)", "Coefficient(«0.71»)", "geometry.inner_groove.Coefficient", "at most 0.7"),
    ("Coefficient(0.527)", "Radius(«mm(15)»)", "geometry.inner_groove.Radius", "greater than the ball radius, 15.08 mm"),
    ("outer_groove: Coefficient(0.527)", "outer_groove: Coefficient(«NaN»)", "geometry.outer_groove.Coefficient", "above 0.5"),
    ("ContactAngle(deg(18))", "ContactAngle(«deg(-1)»)", "geometry.fit.ContactAngle", "between 0° and 60°"),
    ("ContactAngle(deg(18))", "ContactAngle(«rad(1.05)»)", "geometry.fit.ContactAngle", "between 0° and 60°"),
    ("ContactAngle(deg(18))", "RadialClearance(«mm(2)»)", "geometry.fit.RadialClearance", "groove centres, and 1.6286 mm"),
    (
        "ContactAngle(deg(18))",
        "RadialClearance(«um(-500)»)",
        "geometry.fit.RadialClearance",
        "must lie between -0.1629 mm",
    ),
    ("GPa(200)", "«GPa(0)»", "materials.ball.young", "greater than 0"),
    ("poisson: 0.28", "poisson: «0.5»", "materials.ball.poisson", "below 0.5"),
    ("density: kg_per_m3(7800)", "density: «kg_per_m3(-7800)»", "materials.ball.density", "greater than 0"),
    ("Library(\"ag\")", "Library(«\"gold\"»)", "coatings.inner.curve.Library", "allowed: ag, ptfe"),
    ("thickness: um(10)", "thickness: «um(-10)»", "coatings.inner.thickness", "at least 0"),
    ("per_m_s: 22.0", "per_m_s: «0»", "traction.slip_unit.Scaled.per_m_s", "greater than 0"),
    ("order: 2", "order: «3»", "traction.order", "coatings.inner has 3"),
    ("order: 2", "order: «18446744073709551615»", "traction.order", "lower the order or add tests"),
    ("reference_pressure: GPa(2.5)", "reference_pressure: «GPa(-2.5)»", "traction.reference_pressure", "greater than 0"),
    ("relative: 1e-5", "relative: «0.1»", "traction.patch.TargetError.relative", "limits excluded"),
    ("TargetError(relative: 1e-5)", "PolarMidpoint(radial: 10, circumferential: «0»)", "traction.patch.PolarMidpoint.circumferential", "between 1 and 1000"),
    ("TargetError(relative: 1e-5)", "GaussJacobi(radial: «1001», angles: 8)", "traction.patch.GaussJacobi.radial", "between 1 and 1000"),
    ("TargetError(relative: 1e-5)", "SplitStrip(across: 8, along: «0»)", "traction.patch.SplitStrip.along", "between 1 and 1000"),
    ("Nitrogen(temperature: K(87.5), pressure: MPa(4))", "«Nitrogen(temperature: K(300), pressure: MPa(4))»", "fluid.medium", "outside"),
    ("Nitrogen(temperature: K(87.5), pressure: MPa(4))", "Custom(density: «kg_per_m3(0)», viscosity: uPa_s(120))", "fluid.medium.Custom.density", "greater than 0"),
    ("Nitrogen(temperature: K(87.5), pressure: MPa(4))", "Custom(density: kg_per_m3(770), viscosity: «uPa_s(0)»)", "fluid.medium.Custom.viscosity", "greater than 0"),
    ("liquid_fraction: 0.9", "liquid_fraction: «1.1»", "fluid.liquid_fraction", "between 0 and 1"),
    ("gas_density: kg_per_m3(12)", "gas_density: «kg_per_m3(-12)»", "fluid.gas_density", "greater than 0"),
    ("drag_coefficient: 0.32", "drag_coefficient: «-0.32»", "fluid.drag_coefficient", "at least 0"),
    ("swirl: 0", "swirl: «1.5»", "fluid.swirl", "between 0 and 1"),
    ("shaded_fraction: 0", "shaded_fraction: «NaN»", "fluid.shaded_fraction", "between 0 and 1"),
    ("mm(0.12)", "«mm(-0.12)»", "cage.pocket_gap", "at least 0"),
    ("N_per_um(5)", "«N_per_um(-5)»", "cage.pocket_stiffness", "at least 0"),
    ("pocket_friction: 0.1", "pocket_friction: «inf»", "cage.pocket_friction", "finite"),
    ("(coefficient: 1e-6,", "(coefficient: «-1e-6»,", "wear.inner.coefficient", "at least 0"),
    ("hardness: MPa(60)", "hardness: «MPa(0)»", "wear.cage.hardness", "greater than 0"),
    ("Force(kN(20))", "ForceTable(«[]»)", "ring.x.ForceTable", "at least one row"),
    ("Force(kN(20))", "ForceTable([(s(0), kN(0)), (s(2), kN(1)), («s(2)», kN(20))])", "ring.x.ForceTable[2][0]", "times must rise from row to row; the row before is at 2 s"),
    ("tilt_y: Held(deg(0))", "tilt_y: MomentTable([(ms(2), Nm(0)), («ms(1)», Nmm(1))])", "ring.tilt_y.MomentTable[1][0]", "times must rise"),
    ("Constant(rpm(14000))", "Constant(«rpm(-1e6)»)", "speed.inner.Constant", "1e5 rad/s"),
    ("Constant(rpm(0))", "Table([(s(0), rpm(0)), (s(1), «rpm(1e6)»)])", "speed.outer.Table[1][1]", "1e5 rad/s"),
    ("Constant(rpm(0))", "Table([(s(0), rpm(0)), («s(-1)», rpm(1))])", "speed.outer.Table[1][0]", "times must rise"),
    ("tolerance: 1e-10", "tolerance: «0.01»", "numerics.tolerance", "at most 0.001"),
    ("max_iterations: 200", "max_iterations: «0»", "numerics.max_iterations", "at least 1"),
    ("\"geometry.fit\": ", "«\"geometry.fitt\"»: ", "sources[\"geometry.fitt\"]", "`geometry` has ball_count, ball_diameter"),
    ("\"geometry.fit\": ", "«\"geometry fit.\"»: ", "sources[\"geometry fit.\"]", "not a path"),
    ("\"ring.y\": ", "«\"ring.x\"»: ", "sources[\"ring.x\"]", "two sources"),
    ("Assumed(\"aligned\")", "Identified(spread: «-1», from: \"Table 5\")", "sources[\"ring.tilt_x\"].Identified.spread", "at least 0"),
];

const POINTS: &str = "Tested([
    (pressure: GPa(2.5), peak_slip: 3.0, peak_coefficient: 0.138, residual_coefficient: 0.124),
    (pressure: GPa(3), peak_slip: 3.3, peak_coefficient: 0.128, residual_coefficient: 0.116),
    (pressure: GPa(3.5), peak_slip: 3.6, peak_coefficient: 0.121, residual_coefficient: 0.102),
])";

#[rustfmt::skip]
const TESTED: &[Refused] = &[
    ("residual_coefficient: 0.102", "residual_coefficient: «0»", "coatings.inner.curve.Tested[2].residual_coefficient", "greater than 0"),
    ("peak_coefficient: 0.128", "peak_coefficient: «0.116»", "coatings.inner.curve.Tested[1].peak_coefficient", "greater than the residual coefficient, 0.116"),
    ("peak_slip: 3.3", "peak_slip: «0»", "coatings.inner.curve.Tested[1].peak_slip", "greater than 0"),
    ("GPa(3.5)", "«GPa(3)»", "coatings.inner.curve.Tested[2].pressure", "must rise"),
    ("GPa(2.5)", "«GPa(0)»", "coatings.inner.curve.Tested[0].pressure", "greater than 0"),
    ("(pressure: GPa(2.5),", "«»(", "coatings.inner.curve.Tested[0].pressure", "field `pressure` is missing"),
    ("order: 2", "order: «3»", "traction.order", "coatings.inner has 3"),
];

pub(super) fn check_refusal(good: &str, (from, to, path, message): Refused) {
    assert!(good.contains(from), "{from} is not in the good file");
    let marked = good.replacen(from, to, 1);
    let (before, rest) = marked.split_once('«').unwrap();
    let (inside, _) = rest.split_once('»').unwrap();
    let text = marked.replace(['«', '»'], "");
    let error = Case::from_ron(&text).expect_err(to);
    assert_eq!(error.path, path, "{to}: {error}");
    assert!(error.message.contains(message), "{to}: {error}");
    let line = before.lines().count();
    let column = before.lines().next_back().unwrap().chars().count() + 1;
    assert_eq!((error.line, error.column), (line, column), "{to}: {error}");
    if !inside.is_empty() {
        assert_eq!(&text[error.offset..error.offset + error.length], inside, "{to}: {error}");
    }
    assert_eq!(error.to_string().lines().count(), 1, "{error}");
}

#[test]
fn limit_unreadable_values_are_refused_where_they_stand() {
    READING.iter().for_each(|row| check_refusal(AG, *row));
}

#[test]
fn limit_impossible_values_are_refused_where_they_stand() {
    IMPOSSIBLE.iter().for_each(|row| check_refusal(AG, *row));
}

#[test]
fn limit_impossible_tested_points_are_refused_where_they_stand() {
    let tested = set_value(AG, "coatings.inner.curve", POINTS).unwrap();
    assert!(matches!(
        Case::from_ron(&tested).unwrap().coatings.unwrap().inner.curve,
        CurveSpec::Tested(points) if points.len() == 3
    ));
    TESTED.iter().for_each(|row| check_refusal(&tested, *row));
}

#[test]
fn limit_error_text_shows_path_value_and_what_is_allowed() {
    let text = set_value(AG, "traction.order", "7").unwrap();
    let error = Case::from_ron(&text).unwrap_err().to_string();
    assert!(error.starts_with("traction.order = 7: ") && error.ends_with("lower the order or add tests"), "{error}");
    let long = set_value(AG, "traction.pressure", "\"first line\nsecond line\"").unwrap();
    assert_eq!(Case::from_ron(&long).unwrap_err().value, "\"first line…");
    let section = AG.replacen("medium: Nitrogen(temperature: K(87.5),", "medium: Nitrogen(temperature: K(300),\n", 1);
    assert_eq!(Case::from_ron(&section).unwrap_err().value, "Nitrogen(…)");
    let error = Case::from_ron("").unwrap_err();
    assert_eq!((error.line, error.column, error.path.as_str()), (1, 1, ""));
}

/// Whatever is deleted, reading ends without a panic, and an error points into the text.
#[test]
fn limit_damaged_files_are_read_or_refused_with_a_place_inside() {
    let mut refused = 0;
    for (at, c) in AG.char_indices().filter(|(_, c)| c.is_ascii_punctuation()).step_by(3) {
        for text in [[&AG[..at], &AG[at + c.len_utf8()..]].concat(), AG[..at].to_owned()] {
            let Err(error) = Case::from_ron(&text) else { continue };
            refused += 1;
            assert!(text.get(error.offset..error.offset + error.length).is_some(), "{error}");
            assert!(error.line <= text.lines().count() + 1 && error.column >= 1 && !error.message.is_empty());
        }
    }
    assert!(refused > 500, "only {refused} damaged files were refused");
}

#[test]
fn identity_every_place_of_a_file_has_a_path_that_leads_back_to_it() {
    for text in [AG, IDENTIFIED, PTFE, BEARING_218, &set_value(AG, "coatings.inner.curve", POINTS).unwrap()] {
        let outline = Outline::new(text).unwrap();
        let mut places = 0;
        for (path, _, value) in (0..text.len()).filter_map(|offset| outline.entry_at(offset)) {
            places += 1;
            let written = path.to_string();
            assert_eq!(Path::parse(&written), Some(path));
            assert_eq!(locate(text, &written), Some(value.clone()), "{written}");
            assert_eq!(set_value(text, &written, &text[value]).unwrap(), text);
        }
        assert!(places > 1200, "only {places} places");
    }
}

#[test]
fn identity_paths_lead_to_the_values_they_name() {
    let text = set_value(AG, "coatings.inner.curve", POINTS).unwrap();
    let text = set_value(&text, "ring.x", "ForceTable([(s(0), kN(0)), /* ( */ (s(1), kN(20))])").unwrap();
    let text = set_value(&text, "fluid.medium", "Some(Oxygen(temperature: K(90), pressure: MPa(4)))").unwrap();
    let within_some = Outline::new(&text).unwrap().entry_at(text.find("K(90)").unwrap());
    assert_eq!(within_some.unwrap().0.to_string(), "fluid.medium.Oxygen.temperature");
    for (path, value) in [
        ("geometry.ball_diameter", "mm(30.16)"),
        ("geometry.ball_diameter.mm", "30.16"),
        ("geometry.fit.ContactAngle", "deg(18)"),
        ("traction.patch", "TargetError(relative: 1e-5)"),
        ("traction.patch.TargetError", "(relative: 1e-5)"),
        ("traction.patch.TargetError.relative", "1e-5"),
        ("traction.pressure", "Peak"),
        ("coatings.inner.curve.Tested[1].pressure", "GPa(3)"),
        ("ring.x.ForceTable[1][1]", "kN(20)"),
        ("ring.x.ForceTable[1][0].s", "1"),
        ("fluid.medium.Oxygen.temperature", "K(90)"),
        ("sources[\"ring.tilt_x\"].Assumed", "\"aligned\""),
    ] {
        assert_eq!(locate(&text, path).map(|range| &text[range]), Some(value), "{path}");
    }
    for path in [
        "geometry.ball",
        "geometry.ball_count.mm",
        "ring.x[0]",
        "ring.x.ForceTable[2]",
        "traction..order",
        "[",
        "ring.x.Held",
    ] {
        assert_eq!(locate(&text, path), None, "{path}");
    }
}

#[test]
fn identity_a_replaced_value_is_read_back_and_the_rest_stays() {
    let text = set_value(AG, "geometry.pitch_diameter", "mm(167.5) // catalogue").unwrap();
    assert_eq!(Case::from_ron(&text).unwrap(), {
        let mut case = Case::from_ron(AG).unwrap();
        case.geometry.pitch_diameter = 0.1675;
        case
    });
    assert_eq!(text.replace("mm(167.5) // catalogue\n", "mm(165)"), AG);
}

#[test]
fn limit_replacing_needs_a_path_of_the_file_and_one_value() {
    let error = set_value(AG, "geometry.pitch", "mm(1)").unwrap_err();
    let line = AG.lines().position(|line| line.contains("geometry: (")).unwrap() + 1;
    assert_eq!((error.path.as_str(), error.line), ("geometry.pitch", line));
    assert!(error.message.contains("`geometry` has ball_count, ball_diameter, pitch_diameter"), "{error}");
    let error = set_value(AG, "ring.x.Held", "mm(1)").unwrap_err();
    assert!(error.message.contains("`ring.x` has Force"), "{error}");
    let error = set_value(AG, "ring.x.Force.kN.N", "1").unwrap_err();
    assert!(error.message.contains("nothing inside"), "{error}");
    for value in ["", "1, ring: 2", "(", "mm(1) mm(2)"] {
        let error = set_value(AG, "ring.x", value).unwrap_err();
        assert!(error.message.contains("not one value"), "{error}");
    }
    assert!(set_value("(a: 1", "a", "2").unwrap_err().message.contains("not well-formed"));
    assert!(set_value(AG, "ring..x", "2").unwrap_err().message.contains("not a path"));
}

#[test]
fn paper_fixture_holds_the_published_values() {
    let case = Case::from_ron(AG).unwrap();
    let g = &case.geometry;
    assert_eq!((g.ball_count, g.ball_diameter, g.fit), (13, 0.03016, Fit::ContactAngle(18f64.to_radians())));
    assert_eq!(case.speed.inner.at(0.0), 14000.0 * std::f64::consts::PI / 30.0);
    let coatings = case.coatings.unwrap();
    assert_eq!((coatings.inner.thickness, coatings.outer.thickness), (1e-5, 1e-5));
    let medium = case.fluid.as_ref().map(|fluid| fluid.medium);
    assert_eq!(medium, Some(Medium::Nitrogen { temperature: 87.5, pressure: 4e6 }));
    let bearing_218 = Case::from_ron(BEARING_218).unwrap();
    assert_eq!((bearing_218.fluid, bearing_218.ring.z), (None, tribodyn_bearing::Translation::Force(22250.0)));
}

/// The PTFE case is the Ag case but for name, coatings and race wear.
#[test]
fn identity_the_two_coatings_of_the_paper_share_everything_else() {
    let (ag, mut ptfe) = (Case::from_ron(IDENTIFIED).unwrap(), Case::from_ron(PTFE).unwrap());
    let coatings = ptfe.coatings.clone().unwrap();
    assert_eq!(coatings.inner.curve, CurveSpec::Library("ptfe".into()));
    assert_eq!(coatings.inner, coatings.outer);
    ptfe.name.clone_from(&ag.name);
    ptfe.coatings.clone_from(&ag.coatings);
    ptfe.wear.clone_from(&ag.wear);
    ptfe.sources.clone_from(&ag.sources);
    assert_eq!(ptfe, ag);
}

#[test]
fn identity_every_value_of_the_fixtures_has_a_source() {
    for text in [AG, IDENTIFIED, PTFE, WORN, BEARING_218] {
        let case = Case::from_ron(text).unwrap();
        let outline = Outline::new(text).unwrap();
        let sourced: Vec<Path> = case.sources.keys().filter_map(|key| Path::parse(key)).collect();
        // What is simulated and recorded is a choice, not a value of the bearing.
        let unsourced =
            ["name", "transient", "recording", "numerics", "sources"].map(|name| Segment::Name(name.into()));
        for (path, _, value) in (0..text.len()).filter_map(|offset| outline.entry_at(offset)) {
            let section = outline.find(&path).is_ok_and(|range| text[range].contains('\n'));
            let has_source =
                sourced.iter().any(|source| path.0.starts_with(&source.0) || source.0.starts_with(&path.0));
            assert!(section || has_source || unsourced.contains(&path.0[0]), "{path} = {}", &text[value]);
        }
    }
}

fn read(text: &str, unit: fn(&mut ron::Deserializer<'_>) -> ron::Result<f64>) -> ron::Result<f64> {
    unit(&mut ron::Deserializer::from_str(text).unwrap())
}

#[test]
fn identity_units_give_the_closest_number_in_si() {
    type Reader = fn(&mut ron::Deserializer<'_>) -> ron::Result<f64>;
    let pi = std::f64::consts::PI;
    #[rustfmt::skip]
    let rows: &[(Reader, &[(&str, f64)])] = &[
        (|d| units::length(d), &[("m(1)", 1.0), ("mm(30.16)", 0.03016), ("mm(0.12)", 0.00012), ("um(10)", 1e-5), ("inch(1)", 0.0254), ("mm(-2e3)", -2.0)]),
        (|d| units::angle(d), &[("rad(0.1)", 0.1), ("deg(180)", pi), ("mrad(3)", 0.003)]),
        (|d| units::pressure(d), &[("Pa(3)", 3.0), ("kPa(3)", 3e3), ("MPa(0.4)", 4e5), ("GPa(206.9)", 206.9e9)]),
        (|d| units::density(d), &[("kg_per_m3(770.5)", 770.5), ("g_per_cm3(7.85)", 7850.0)]),
        (|d| units::force(d), &[("N(5)", 5.0), ("kN(22.25)", 22250.0)]),
        (|d| units::torque(d), &[("Nm(5)", 5.0), ("Nmm(5)", 0.005)]),
        (|d| units::speed(d), &[("rad_per_s(5)", 5.0), ("rpm(0)", 0.0)]),
        (|d| units::temperature(d), &[("K(87.5)", 87.5), ("degC(20)", 293.15)]),
        (|d| units::viscosity(d), &[("Pa_s(2)", 2.0), ("mPa_s(2)", 0.002), ("uPa_s(119.7)", 119.7e-6)]),
        (|d| units::stiffness(d), &[("N_per_m(2)", 2.0), ("N_per_um(2.3)", 2.3e6)]),
    ];
    for (reader, values) in rows {
        for (text, expected) in *values {
            assert_eq!(read(text, *reader), Ok(*expected), "{text}");
        }
    }
    // Not a decimal fraction: π rounds as well.
    assert!((read("rpm(-60)", |d| units::speed(d)).unwrap() + 2.0 * pi).abs() < 1e-14);
    let mut table = ron::Deserializer::from_str("[(s(0), rpm(0)), (ms(500), rad_per_s(7)),]").unwrap();
    assert_eq!(units::speed_table(&mut table), Ok(vec![(0.0, 0.0), (0.5, 7.0)]));
}

/// NIST Special Publication 811 (2008), appendix B.8: factors to SI, all of them exact or to the digits printed there.
#[test]
fn paper_inch_and_pound_units() {
    type Reader = fn(&mut ron::Deserializer<'_>) -> ron::Result<f64>;
    #[rustfmt::skip]
    let rows: &[(Reader, &str, f64, f64)] = &[
        (|d| units::length(d), "in(1)", 0.0254, 1e-15),
        (|d| units::length(d), "in(0.3125)", 7.9375e-3, 1e-15),
        (|d| units::force(d), "lbf(1)", 4.448_221_615_260_5, 1e-15),
        (|d| units::pressure(d), "psi(1)", 6.894_757e3, 1e-7),
        (|d| units::pressure(d), "ksi(30000)", 206.842_7e9, 1e-6),
        (|d| units::torque(d), "lbf_in(1)", 0.112_984_8, 1e-6),
        (|d| units::stiffness(d), "lbf_per_in(1)", 175.126_8, 1e-6),
        (|d| units::mass(d), "lb(1)", 0.453_592_37, 1e-15),
        (|d| units::density(d), "lb_per_in3(1)", 2.767_990e4, 1e-6),
        (|d| units::temperature(d), "degF(32)", 273.15, 1e-15),
        (|d| units::temperature(d), "degF(212)", 373.15, 1e-15),
        (|d| units::temperature(d), "degF(-459.67)", 0.0, 1e-15),
    ];
    for &(reader, text, expected, relative) in rows {
        let found = read(text, reader).unwrap();
        assert!(
            (found - expected).abs() <= relative * expected.abs().max(1e-300),
            "{text}: {found} instead of {expected}"
        );
    }
}
