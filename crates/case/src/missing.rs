//! All fields that a refused text lacks: each is filled with something of its kind until the reader goes on, so that
//! it meets the next one.

use super::error::CaseError;
use super::outline::{Outline, Path};

/// Something of every kind of value that a case has a required field for. A section is tried first: what it lacks in
/// turn is filled, but not named.
const KINDS: [&str; 45] = [
    "()",
    "1",
    "1.0",
    "true",
    "\"\"",
    "mm(1)",
    "deg(1)",
    "rpm(1)",
    "N(1)",
    "Nm(1)",
    "GPa(1)",
    "kg(1)",
    "s(1)",
    "Hz(1)",
    "K(1)",
    "kg_m2(1)",
    "kg_per_m3(1)",
    "N_per_m(1)",
    "N_s_per_m(1)",
    "s_per_m(1)",
    "Force(N(1))",
    "Held(deg(0))",
    "Constant(rpm(1))",
    "ContactAngle(deg(1))",
    "Coefficient(0.52)",
    "Library(\"ag\")",
    "Scaled(per_m_s: 1)",
    "Peak",
    "TargetError(relative: 1e-5)",
    "QuasiStatic",
    "Fast(step: us(1))",
    "Displaced",
    "Cylinder",
    "Half",
    "Pa_s(1)",
    "Inner",
    "\"k5\"",
    "Normal",
    "Mean",
    "(N_per_m(1), N_per_m(1), N_per_m(1))",
    "(N_per_m(1), N_per_m(1))",
    "(N_s_per_m(1), N_s_per_m(1), N_s_per_m(1))",
    "Given(polar: kg_m2(1), transverse: kg_m2(1))",
    "(Nm_per_rad(1), Nm_per_rad(1))",
    "(Nm_s_per_rad(1), Nm_s_per_rad(1))",
];
const PAIR: &str = "(N_s_per_m(1), N_s_per_m(1))";

/// Most fields that are filled: more than a case has.
const MOST: usize = 200;

/// The reader's error for a text, and true if it is a missing field.
pub(super) type Refused = (CaseError, bool);

/// The first refusal, a missing field, with the names of all others that are missing.
pub(super) fn with_all_missing(text: &str, first: CaseError, read: impl Fn(&str) -> Option<Refused>) -> CaseError {
    let mut names: Vec<String> = Vec::new();
    let (mut filled, mut next) = (text.to_owned(), Some(first.clone()));
    for _ in 0..MOST {
        let Some(missing) = next.take() else { break };
        let within = |name: &String| missing.path.starts_with(&format!("{name}."));
        if !names.iter().any(within) {
            names.push(missing.path.clone());
        }
        let Some((text, after)) = fill(&filled, &missing.path, &read) else { break };
        filled = text;
        next = after.and_then(|(error, lacks)| lacks.then_some(error));
    }
    let others: Vec<String> = names.iter().skip(1).map(|name| format!("`{name}`")).collect();
    if others.is_empty() {
        return first;
    }
    CaseError { message: format!("{}; also missing: {}", first.message, others.join(", ")), ..first }
}

/// The text with a value of the kind that the reader takes at a path, and what it says next.
fn fill(text: &str, path: &str, read: impl Fn(&str) -> Option<Refused>) -> Option<(String, Option<Refused>)> {
    let section = match path.rsplit_once('.') {
        Some((section, _)) => Path::parse(section)?,
        None => Path::default(),
    };
    let field = path.rsplit('.').next()?;
    let outline = Outline::new(text)?;
    let range = outline.find(&section).ok()?;
    let open = range.start + text.get(range)?.find('(')? + 1;
    KINDS.into_iter().chain([PAIR]).find_map(|kind| {
        let comma = if text[open..].trim_start().starts_with(')') { "" } else { ", " };
        let filled = format!("{}{field}: {kind}{comma}{}", &text[..open], &text[open..]);
        let after = read(&filled);
        // A section that lacks fields of its own is of the right kind; any other trouble at the field is not.
        let fits = after.as_ref().is_none_or(|(error, lacks)| {
            let here = error.path == path || error.path.starts_with(&format!("{path}."));
            !here && !error.path.is_empty() || here && *lacks && error.path != path
        });
        fits.then_some((filled, after))
    })
}

#[cfg(test)]
mod tests {
    use crate::Case;

    const AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");

    /// The text without the lines that hold one of the words.
    fn without(words: &[&str]) -> String {
        AG.lines()
            .filter(|line| !words.iter().any(|word| line.trim_start().starts_with(word)))
            .collect::<Vec<_>>()
            .join("\n")
    }

    #[test]
    fn limit_all_missing_fields_are_named_at_once() {
        let text = without(&["ball_count:", "fit:", "pitch_diameter:", "pocket_stiffness:", "slip_unit:", "tilt_x:"]);
        let error = Case::from_ron(&text).unwrap_err();
        for name in ["ball_count", "fit", "pitch_diameter", "pocket_stiffness", "slip_unit", "tilt_x"] {
            assert_eq!(error.to_string().matches(name).count().min(1), 1, "{name}: {error}");
        }
        assert!(error.message.contains("also missing: "), "{error}");
        assert!(error.path.starts_with("geometry."), "{error}");
    }

    #[test]
    fn limit_a_missing_section_is_named_without_its_fields() {
        let error = Case::from_ron("(name: \"nothing\")").unwrap_err().to_string();
        for section in ["geometry", "materials", "ring", "speed"] {
            assert!(error.contains(&format!("`{section}`")), "{error}");
        }
        assert!(!error.contains("ball_count"), "{error}");
    }

    #[test]
    fn limit_one_missing_field_is_said_as_such() {
        let error = Case::from_ron(&without(&["ball_count:"])).unwrap_err();
        assert_eq!(error.message, "field `ball_count` is missing");
    }
}
