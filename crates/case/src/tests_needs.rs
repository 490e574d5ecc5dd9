//! Sections that a model does not use may be left out; those that it uses are asked for, all at once.

use super::*;

const AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");
const BEARING_218: &str = include_str!("../../../fixtures/cases/bearing-218.ron");

/// The text without an entry of the file or of one of its sections, and without sources.
fn without(text: &str, path: &str) -> Case {
    let sources = locate(text, "sources").unwrap();
    let text = [&text[..sources.start], "{}", &text[sources.end..]].concat();
    let value = locate(&text, path).unwrap_or_else(|| panic!("{path}"));
    let key = path.rsplit('.').next().unwrap();
    let start = text[..value.start].rfind(&format!("{key}:")).unwrap();
    let end = value.end + text[value.end..].find(',').unwrap() + 1;
    let text = [&text[..start], &text[end..]].concat();
    Case::from_ron(&text).unwrap_or_else(|e| panic!("{path}: {e}"))
}

fn missing(case: &Case, purpose: Purpose) -> Vec<&'static str> {
    case.require(purpose).err().map_or_else(Vec::new, |lacking| lacking.missing.iter().map(|(path, _)| *path).collect())
}

#[test]
fn limit_a_case_for_jones_harris_needs_nothing_of_friction() {
    let case = Case::from_ron(BEARING_218).unwrap();
    assert!(case.coatings.is_none() && case.traction.is_none() && case.cage.is_none() && case.wear.is_none());
    assert_eq!(case.require(Purpose::JonesHarris), Ok(()));
    let bearing = case.bearing().unwrap();
    assert!(bearing.tribology.is_none() && bearing.races.inner.surface_radius.is_infinite());
    assert_eq!((case.operating_point().patch, case.operating_point().cage), (None, None));
}

/// All that is missing is named at once, with the model and what it must hold.
#[test]
fn limit_a_model_asks_for_all_that_is_missing() {
    let case = Case::from_ron(BEARING_218).unwrap();
    let of_traction = ["coatings", "traction", "cage", "wear", "modelling.ring_centre"];
    assert_eq!(missing(&case, Purpose::Traction), of_traction);
    let of_run = ["coatings", "traction", "cage", "wear", "supports", "transient", "modelling.ring_centre"];
    assert_eq!(missing(&case, Purpose::Transient), of_run);
    let message = case.run_inputs().map(drop).unwrap_err().to_string();
    assert!(
        message.starts_with("a transient run needs what the case does not have: `coatings` (inner and outer, each")
    );
    assert!(message.contains("`supports` (inner and outer, each with mass, stiffness and damping)"), "{message}");
}

/// Each part of a whole case, left out, is asked for by the models that use it and by no other.
#[test]
fn limit_each_part_is_asked_for_by_the_models_that_use_it() {
    let [jones_harris, traction, transient] = [Purpose::JonesHarris, Purpose::Traction, Purpose::Transient];
    for (path, users) in [
        ("coatings", &[traction, transient][..]),
        ("traction", &[traction, transient]),
        ("cage", &[traction, transient]),
        ("wear", &[traction, transient]),
        ("modelling.ring_centre", &[traction, transient]),
        ("modelling.race_control", &[jones_harris]),
        ("modelling.centrifugal_at_free_pitch", &[jones_harris]),
        ("cage.inertia", &[transient]),
        ("supports", &[transient]),
        ("transient", &[transient]),
        ("fluid", &[]),
        ("recording", &[]),
        ("numerics", &[]),
    ] {
        let case = without(AG, path);
        for purpose in [jones_harris, traction, transient] {
            let expected: &[&str] = if users.contains(&purpose) { &[path] } else { &[] };
            assert_eq!(missing(&case, purpose), expected, "{path}, {purpose}");
        }
    }
    assert_eq!(without(AG, "recording").rates(), RecordingSpec { state_rate: 25_600.0, ball_rate: 5_120.0 });
}

/// A choice for all models stands in every case.
#[test]
fn limit_modelling_choices_have_no_default() {
    let without = |from: &str| Case::from_ron(&BEARING_218.replacen(from, "", 1)).unwrap_err();
    let error = without("        contact_at_actual_angle: true,\n");
    assert_eq!(
        (error.path.as_str(), error.message.as_str()),
        ("modelling.contact_at_actual_angle", "field `contact_at_actual_angle` is missing")
    );
    let start = BEARING_218.find("    modelling: (").unwrap();
    let end = start + BEARING_218[start..].find("    ),\n").unwrap() + "    ),\n".len();
    let error = without(&BEARING_218[start..end]);
    assert_eq!((error.path.as_str(), error.message.as_str()), ("modelling", "field `modelling` is missing"));
    let error = Case::from_ron(&set_value(AG, "modelling.race_control", "Middle").unwrap()).unwrap_err();
    assert!(error.message.contains("allowed: Outer, Inner, Criterion"), "{error}");
    let numerics = AG.replacen("numerics: (", "numerics: (ring_centre: Inertial,", 1);
    assert!(Case::from_ron(&numerics).unwrap_err().message.contains("unknown field `ring_centre`"));
}

/// The inputs of a run hold the values of the case, each at its own place.
#[test]
fn identity_run_inputs_hold_the_values_of_the_case() {
    let case = Case::from_ron(include_str!("../../../fixtures/cases/paper-ag-worn.ron")).unwrap();
    let inputs = case.run_inputs().unwrap();
    assert_eq!((inputs.supports.inner.mass, inputs.supports.outer.mass), (12.0, 6.0));
    assert_eq!((inputs.coatings.inner.worn, inputs.coatings.outer.thickness), (0.5, 1e-5));
    assert_eq!((inputs.defects.inner.len(), inputs.defects.outer.len()), (0, 1));
    assert_eq!((inputs.cage.inertia, inputs.cage.pocket_damping), (0.0021, 0.5));
    assert_eq!(inputs.cage.guidance.map(|land| (land.radius, land.gap)), Some((0.09025, 0.00025)));
    assert_eq!((inputs.options.duration, inputs.options.ball_rate), (0.05, 6400.0));
    assert_eq!(inputs.operating_point_at(0.0), case.operating_point_at(0.0));
}
