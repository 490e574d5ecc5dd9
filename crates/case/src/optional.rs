//! Fields that a case or a shaft's file may leave out, and how a value is put in where one of them is missing.

use super::outline::{Missing, Outline, Path, Segment};

/// Paths of fields that may be left out; `*` is any one step.
const OPTIONAL: &[&str] = &[
    "geometry.shoulders",
    "geometry.inner_shoulder",
    "geometry.outer_shoulder",
    "coatings",
    "coatings.bare",
    "coatings.transfer",
    "coatings.*.worn",
    "traction",
    "lubricant",
    "lubricant.starvation",
    "lubricant.hysteresis",
    "fluid",
    "fluid.drag_over_reynolds",
    "cage",
    "cage.churning",
    "cage.inertia",
    "cage.pocket_damping",
    "cage.pocket_film",
    "cage.guidance",
    "cage.free",
    "cage.free.unbalance",
    "cage.free.gravity",
    "cage.free.displacement",
    "cage.free.lands",
    "wear",
    "supports",
    "supports.tilt",
    "supports.tilt.askew",
    "supports.outer_tilt",
    "supports.outer_tilt.askew",
    "deviations",
    "deviations.*",
    "deviations.*.*",
    "defects",
    "spalls",
    "ball_spalls",
    "transient",
    "recording",
    "mounting",
    "mounting.*.seat",
    "mounting.*.seat.interference",
    "mounting.*.seat.fit",
    "rating",
    "rating.*",
    "modelling.*",
    "numerics",
    "numerics.*",
];

/// The same of a shaft's file; `*` is a number in brackets too.
const OPTIONAL_OF_SHAFTS: &[&str] = &[
    "loads",
    "discs",
    "weight",
    "heat",
    "housing",
    "spectrum",
    "shaft.longest_element",
    "shaft.sections.*.outer_end",
    "shaft.sections.*.inner",
    "shaft.sections.*.inner_end",
    "shaft.sections.*.material",
    "bearings.*.preload",
    "bearings.*.clearance",
    "bearings.*.mounting",
    "bearings.*.fits",
    "bearings.*.fits.housing_material",
    "bearings.*.housing",
    "bearings.*.housing.mass",
    "bearings.*.damping",
    "spectrum.*.speed",
];

/// The section that a shaft's file has and a case does not.
const OF_SHAFTS: &str = "bearings";

/// The text with a field added that it leaves out: at the beginning of the section that can be reached, and with the
/// sections between. `None` where the path does not lead to a field that may be left out.
pub(super) fn added(text: &str, path: &Path, missing: &Missing, value: &str) -> Option<String> {
    // What is added has a name; entries of lists are only gone through.
    let added: Vec<&str> = path.0.get(missing.steps..)?.iter().map(name).collect::<Option<_>>()?;
    let (first, inner) = added.split_first()?;
    let names: Vec<&str> = path.0.iter().map(|segment| name(segment).unwrap_or("[]")).collect();
    let bearings = Path::parse(OF_SHAFTS)?;
    let of_shaft = Outline::new(text).is_some_and(|outline| outline.find(&bearings).is_ok());
    let known = if of_shaft { OPTIONAL_OF_SHAFTS } else { OPTIONAL };
    // A section around the field is added only where it may hold this field alone.
    let optional = |length: usize| known.iter().any(|pattern| matches(pattern, &names[..length]));
    if !(missing.steps + 1..=names.len()).all(optional) {
        return None;
    }
    let open = missing.deepest.start + text.get(missing.deepest.clone())?.find('(')? + 1;
    // A line comment at the end of the value would swallow what follows it.
    let gap = if value.rfind("//") > value.rfind('\n') { "\n" } else { "" };
    let nested = inner.iter().rev().fold(format!("{value}{gap}"), |value, name| format!("({name}: {value})"));
    Some([&text[..open], &format!("{first}: {nested}, "), &text[open..]].concat())
}

fn name(segment: &Segment) -> Option<&str> {
    if let Segment::Name(name) = segment { Some(name) } else { None }
}

fn matches(pattern: &str, names: &[&str]) -> bool {
    let steps: Vec<&str> = pattern.split('.').collect();
    steps.len() == names.len() && steps.iter().zip(names).all(|(step, name)| *step == "*" || step == name)
}

#[cfg(test)]
mod tests {
    use crate::{Case, ShaftSystem, set_value};

    const HARRIS: &str = include_str!("../../../fixtures/cases/bearing-218.ron");
    const AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");

    #[test]
    fn identity_a_field_that_is_left_out_can_be_set() {
        let with = |text: &str, changes: &[(&str, &str)]| {
            let set = |text: String, (path, value): &(&str, &str)| set_value(&text, path, value).unwrap();
            Case::from_ron(&changes.iter().fold(text.to_owned(), set)).unwrap()
        };
        let rated = with(HARRIS, &[("rating.dynamic", "kN(23.4)"), ("rating.static_load", "N(9000)")]).rating.unwrap();
        assert_eq!((rated.dynamic, rated.static_load), (Some(23_400.0), Some(9000.0)));
        assert_eq!(with(HARRIS, &[("numerics.tolerance", "1e-9")]).numerics.tolerance, 1e-9);
        let bare = "(curve: Library(\"bare-440c\"))";
        let worn = with(AG, &[("coatings.inner.worn", "0.25 // a quarter"), ("coatings.bare", bare)]);
        assert_eq!(worn.coatings.unwrap().inner.worn, 0.25);
        let guided = "(land: Inner, radius: mm(60), width: mm(5), gap: mm(0.2))";
        assert!(with(AG, &[("cage.guidance", guided)]).cage.unwrap().guidance.is_some());
    }

    #[test]
    fn identity_a_field_that_a_shaft_leaves_out_can_be_set() {
        let text = include_str!("../../../fixtures/shafts/motor.ron");
        let changes = [
            (
                "heat",
                "(shaft_expansion: per_K(12e-6), shaft_temperature_rise: K(20), housing_expansion: per_K(12e-6), \
              housing_temperature_rise: K(5))",
            ),
            ("shaft.longest_element", "mm(10)"),
            ("shaft.sections[1].inner", "mm(10)"),
            ("bearings[1].damping", "N_s_per_m(500)"),
        ];
        let set = |text: String, (path, value): &(&str, &str)| set_value(&text, path, value).unwrap();
        let system = ShaftSystem::from_ron(&changes.iter().fold(text.to_owned(), set)).unwrap();
        assert_eq!((system.shaft.sections[1].inner, system.bearings[1].damping), (Some(0.01), Some(500.0)));
        assert!(system.heat.is_some() && system.shaft.longest_element == Some(0.01));
        assert!(set_value(text, "discs[0].damping", "N_s_per_m(1)").unwrap_err().message.contains("no such path"));
    }

    #[test]
    fn limit_a_field_that_no_case_has_is_refused_as_before() {
        let refused = |path: &str| set_value(HARRIS, path, "1").unwrap_err().message;
        assert!(refused("geometry.bal_count").contains("no such path: `geometry` has ball_count"));
        assert!(set_value(AG, "coatings.worn", "1").is_err());
        assert!(refused("ratings.dynamic").contains("no such path"));
        // A run needs more of this section than a duration.
        assert!(refused("transient.duration").contains("no such path"));
        // A field that the section does not know is refused by the reader.
        let text = set_value(HARRIS, "rating.dinamic", "N(1)").unwrap();
        assert!(Case::from_ron(&text).unwrap_err().message.contains("dinamic"));
    }
}
