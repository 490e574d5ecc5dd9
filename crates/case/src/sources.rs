//! Sources: each names a value of the file, once.

use super::locate::unknown_path;
use super::outline::{Outline, Path, Segment, unquoted};
use super::{Case, CaseError, Source};

/// Checks the paths and spreads of all sources.
pub(super) fn check(text: &str, case: &Case, outline: &Outline<'_>) -> Result<(), CaseError> {
    let section = Path(vec![Segment::Name("sources".into())]);
    let mut seen = Vec::new();
    for range in outline.keys(&section) {
        let key = unquoted(&text[range.clone()]);
        let mut path = section.clone();
        path.0.push(Segment::Key(key.to_owned()));
        if seen.contains(&key) {
            return Err(CaseError::new(text, range, &path, format!("`{key}` has two sources; allowed is one")));
        }
        seen.push(key);
        let named = Path::parse(key)
            .ok_or_else(|| "not a path; write it as in \"geometry.ball_diameter\"".to_owned())
            .and_then(|named| {
                outline.find(&named).map(drop).map_err(|missing| unknown_path(text, &named, missing).message)
            });
        named.map_err(|message| CaseError::new(text, range, &path, message))?;
    }
    for (key, source) in &case.sources {
        if let Source::Identified { spread, .. } = source
            && !(spread.is_finite() && *spread >= 0.0)
        {
            let steps = ["Identified", "spread"].map(|name| Segment::Name(name.into()));
            let path = Path([section.0[0].clone(), Segment::Key(key.clone())].into_iter().chain(steps).collect());
            let range = outline.find(&path).unwrap_or_else(|missing| missing.deepest);
            let message = "a standard deviation must be at least 0 and finite".to_owned();
            return Err(CaseError::new(text, range, &path, message));
        }
    }
    Ok(())
}
