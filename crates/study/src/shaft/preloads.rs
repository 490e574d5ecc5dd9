//! Preloads that are given as a force, on the shaft that bends and in the housings that give way.

use super::build::Running;
use super::file::ShaftFile;
use tribodyn_case::PreloadSpec;

/// Share of a preload by which another one is named.
const NAMED: f64 = 0.05;

/// A sentence on each bearing whose axial force at rest and without loads is not that of its preload.
pub(super) fn changed(file: &ShaftFile) -> Vec<Option<String>> {
    let bearings = &file.system.bearings;
    let is_force = |preload: Option<PreloadSpec>| matches!(preload, Some(PreloadSpec::Force(_)));
    let running = bearings.iter().any(|bearing| is_force(bearing.preload)).then(|| Running::new(file, 0.0, 0.0));
    let unloaded = running.and_then(Result::ok).and_then(|running| running.equilibrium(None).ok());
    let Some(unloaded) = unloaded else { return vec![None; bearings.len()] };
    let sentence = |(preload, reaction): (Option<PreloadSpec>, f64)| match preload {
        Some(PreloadSpec::Force(force)) if (reaction - force).abs() > NAMED * force => Some(format!(
            "of a preload of {force} N between rigid seats {reaction:.1} N are there at rest and without loads: shaft, \
             housings, fits and heat change it"
        )),
        _ => None,
    };
    bearings.iter().map(|b| b.preload).zip(unloaded.reactions.iter().map(|r| r[2].abs())).map(sentence).collect()
}
