//! Finding and replacing a value by its path, comments and layout left alone.

use super::CaseError;
use super::outline::{Missing, Outline, Path};
use std::ops::Range;

/// Byte range of the value at a path of a RON text, `None` where there is none.
///
/// A path is `geometry.ball_diameter`, `coatings.inner.curve.Tested[0].pressure` (the name of an enum variant steps
/// inside it, `[i]` picks an element) or `sources["ring.z"]`; after a unit's name stands the bare number, as in
/// `ring.z.Force.kN`.
pub fn locate(text: &str, path: &str) -> Option<Range<usize>> {
    Outline::new(text)?.find(&Path::parse(path)?).ok()
}

/// The text with the value at `path` replaced by `value`, everything else as it was.
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
    let range = outline.find(&parsed).map_err(|missing| unknown_path(text, &parsed, missing))?;
    if Outline::new(value).is_none() {
        let message = format!("`{value}` is not one value in RON, such as mm(30.16)");
        return Err(CaseError::new(text, range, &parsed, message));
    }
    // A line comment at the end of the value would swallow what follows it.
    let gap = if value.rfind("//") > value.rfind('\n') { "\n" } else { "" };
    Ok([&text[..range.start], value, gap, &text[range.end..]].concat())
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
