//! Finding and replacing a value by its path, comments and layout left alone.

use super::CaseError;
use super::optional::added;
use super::outline::{Missing, Outline, Path, Segment};
use std::ops::Range;

/// Byte range of the value at a path of a RON text, `None` where there is none.
///
/// A path is `geometry.ball_diameter`, `coatings.inner.curve.Tested[0].pressure` (the name of an enum variant steps
/// inside it, `[i]` picks an element) or `sources["ring.z"]`; after a unit's name stands the bare number, as in
/// `ring.z.Force.kN`.
pub fn locate(text: &str, path: &str) -> Option<Range<usize>> {
    Outline::new(text)?.find(&Path::parse(path)?).ok()
}

/// Paths and byte ranges of all single values of a RON text in its order, the sources left out; empty where the text is
/// not well-formed. A single value has no named fields inside: `mm(30.16)`, `Library("ag")`, a list of numbers.
pub fn values(text: &str) -> Vec<(String, Range<usize>)> {
    let leaves = Outline::new(text).map_or_else(Vec::new, |outline| outline.leaves());
    let of_case = |path: &Path| path.0.first() != Some(&Segment::Name("sources".to_owned()));
    leaves.into_iter().filter(|(path, _)| of_case(path)).map(|(path, range)| (path.to_string(), range)).collect()
}

/// The text with the value at `path` replaced by `value`, everything else as it was. A field that a case may leave
/// out is added, with the sections around it.
///
/// # Errors
/// [`CaseError`] where the text or the value is not well-formed RON, or where the path leads nowhere: it then says what
/// stands at the last place that could be reached.
pub fn set_value(text: &str, path: &str, value: &str) -> Result<String, CaseError> {
    let fail = |path: &Path, message: &str| CaseError::new(text, 0..0, path, message.to_owned());
    let Some(parsed) = Path::parse(path) else {
        let message = format!("`{path}` is not a path; write it as in `ring.z.Force` or `curve.Tested[0].pressure`");
        return Err(fail(&Path::default(), &message));
    };
    let Some(outline) = Outline::new(text) else {
        return Err(fail(&Path::default(), "the text is not well-formed RON: brackets or strings do not match"));
    };
    let found = outline.find(&parsed);
    if Outline::new(value).is_none() {
        let message = format!("`{value}` is not one value in RON, such as mm(30.16)");
        let range = found.unwrap_or_else(|missing| missing.deepest);
        return Err(CaseError::new(text, range, &parsed, message));
    }
    let range = match found {
        Ok(range) => range,
        Err(missing) => {
            let with_field = added(text, &parsed, &missing, value);
            return with_field.ok_or_else(|| unknown_path(text, &parsed, missing));
        }
    };
    Ok([&text[..range.start], value, gap_after(value), &text[range.end..]].concat())
}

/// A text with some values to be replaced, again and again.
#[derive(Debug, Clone)]
pub struct Template {
    text: String,
    /// Which of the values, by the places of their paths, and where it stands, in the order of the text.
    places: Vec<(usize, Range<usize>)>,
}

impl Template {
    /// The text with the values at these paths to be replaced; `None` where one is not there, or stands in another.
    pub fn new(text: &str, paths: &[&str]) -> Option<Self> {
        let outline = Outline::new(text)?;
        let place = |(k, path): (usize, &&str)| Some((k, outline.find(&Path::parse(path)?).ok()?));
        let mut places: Vec<_> = paths.iter().enumerate().map(place).collect::<Option<_>>()?;
        places.sort_by_key(|(_, range)| range.start);
        let apart = places.windows(2).all(|pair| pair[0].1.end <= pair[1].1.start);
        apart.then(|| Self { text: text.to_owned(), places })
    }

    /// The text with these values, as [`set_value`] one after the other would make it; `None` where one of them is not
    /// well-formed.
    pub fn with(&self, values: &[&str]) -> Option<String> {
        let (mut filled, mut at) = (String::with_capacity(self.text.len() + 64), 0);
        for (k, range) in &self.places {
            let value = values.get(*k).filter(|value| Outline::new(value).is_some())?;
            filled.push_str(&self.text[at..range.start]);
            filled.push_str(value);
            filled.push_str(gap_after(value));
            at = range.end;
        }
        filled.push_str(&self.text[at..]);
        Some(filled)
    }
}

/// A line comment at the end of a value would swallow what follows it.
fn gap_after(value: &str) -> &'static str {
    if value.rfind("//") > value.rfind('\n') { "\n" } else { "" }
}

/// The error for a path that leads nowhere.
pub(super) fn unknown_path(text: &str, path: &Path, missing: Missing) -> CaseError {
    let reached = Path(path.0[..missing.steps].to_vec()).to_string();
    let place = if reached.is_empty() { "the file".to_owned() } else { format!("`{reached}`") };
    let message = if missing.allowed.is_empty() {
        format!("{place} has nothing inside")
    } else {
        format!("no such path: {place} has {}", missing.allowed.join(", "))
    };
    let error = CaseError::new(text, missing.deepest, path, message);
    CaseError { value: String::new(), ..error }
}

#[cfg(test)]
mod tests {
    use super::{Template, locate, set_value, values};

    #[test]
    fn identity_every_value_is_listed_and_found_at_its_path() {
        let text = include_str!("../../../fixtures/cases/paper-ag-defect.ron");
        let all = values(text);
        for (path, range) in &all {
            assert_eq!(locate(text, path).as_ref(), Some(range), "{path}");
        }
        let value = |path: &str| all.iter().find(|(p, _)| p == path).map(|(_, range)| &text[range.clone()]);
        assert_eq!(value("geometry.fit"), Some("ContactAngle(deg(18))"));
        assert_eq!(value("transient.scheme.RungeKutta4.step"), Some("us(2.5)"));
        assert_eq!(value("defects[0].depth"), Some("um(2)"));
        assert_eq!(value("supports.outer.damping"), Some("(N_s_per_m(5000), N_s_per_m(5000))"));
        assert_eq!(value("fluid.medium.Nitrogen.pressure"), Some("MPa(4)"));
        assert!(all.iter().all(|(path, _)| !path.starts_with("sources")));
        assert_eq!(values("(a: 1"), []);
    }

    #[test]
    fn identity_a_template_is_filled_as_values_are_set_one_by_one() {
        let text = include_str!("../../../fixtures/cases/paper-ag.ron");
        let changes =
            [("speed.inner", "Constant(rpm(9e3)) // slow"), ("ring.z.Force", "N(3)"), ("ring.x", "Held(m(0))")];
        let one_by_one =
            changes.iter().fold(text.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap());
        let template = Template::new(text, &changes.map(|(path, _)| path)).unwrap();
        assert_eq!(template.with(&changes.map(|(_, value)| value)), Some(one_by_one));
        assert_eq!(template.with(&["Constant(rpm(1))", "N(3", "Held(m(0))"]), None);
        assert!(Template::new(text, &["ring.z", "ring.z.Force"]).is_none(), "one stands in the other");
        assert!(Template::new(text, &["ring.w"]).is_none());
    }

    #[test]
    fn limit_lists_and_optional_values_are_single_values_unless_fields_stand_in_them() {
        let text = "(a: Some(mm(1)), b: [], c: Tested([(p: 1, q: 2)]), d: Table([(s(0), rpm(0)), (s(1), rpm(5))]))";
        let paths: Vec<String> = values(text).into_iter().map(|(path, _)| path).collect();
        assert_eq!(paths, ["a", "b", "c.Tested[0].p", "c.Tested[0].q", "d"]);
    }
}
