//! How the bearings of a set stand, and what presses them together, as users say it.

use super::SetPreload;
use crate::error::StudyError;

/// How the bearings of a set stand, by the names of catalogues: the side that each carries, from −z to +z.
pub const ARRANGEMENTS: [(&str, &[bool]); 10] = [
    ("DB", &[true, false]),
    ("DF", &[false, true]),
    ("DT", &[true, true]),
    ("TBT", &[true, true, false]),
    ("TFT", &[false, true, true]),
    ("TT", &[true, true, true]),
    ("QBC", &[true, true, false, false]),
    ("QFC", &[false, false, true, true]),
    ("QBT", &[true, true, true, false]),
    ("QT", &[true, true, true, true]),
];

/// The side that each bearing of a set carries, from −z to +z, true for +z: by the name of its arrangement, or by signs
/// such as `++-`.
///
/// # Errors
/// A name or signs that are none.
pub fn sides(arrangement: Option<&str>, signs: Option<&str>) -> Result<Vec<bool>, StudyError> {
    if let Some(signs) = signs {
        let side = |sign| match sign {
            '+' => Some(true),
            '-' => Some(false),
            _ => None,
        };
        let all: Option<Vec<bool>> = signs.chars().map(side).collect();
        let refused = || StudyError::argument("sides", signs, "allowed are 1 to 8 signs + or -, such as ++-");
        return all.filter(|all| (1..=8).contains(&all.len())).ok_or_else(refused);
    }
    let name = arrangement.unwrap_or_default();
    let found = ARRANGEMENTS.iter().find(|(known, _)| known.eq_ignore_ascii_case(name));
    let refused = || {
        let known = ARRANGEMENTS.map(|(known, _)| known).join(", ");
        StudyError::argument("arrangement", name, format!("allowed are {known}; any other by its sides"))
    };
    found.map(|(_, sides)| sides.to_vec()).ok_or_else(refused)
}

/// True if all bearings carry the same way.
pub(super) fn is_tandem(sides: &[bool]) -> bool {
    sides.iter().all(|side| *side == sides[0])
}

/// A force, N, with the condition of the bearings in which it presses.
pub type PreloadForce = (f64, fn(f64) -> SetPreload);

/// The preload of a set, of the three ways to say it: a force, N, in a condition, an offset, µm, or the force of a
/// spring, N. Bearings that all carry the same way have none.
///
/// # Errors
/// Several of these or none, and numbers that are not possible.
pub fn pressed(
    sides: &[bool],
    force: Option<PreloadForce>,
    offset_um: Option<f64>,
    spring: Option<f64>,
) -> Result<SetPreload, StudyError> {
    let of_force = |name, force: f64, made: fn(f64) -> SetPreload| match force.is_finite() && force >= 0.0 {
        true => Ok(made(force)),
        false => Err(StudyError::argument(name, force, "allowed is 0 N or more")),
    };
    let ways = "one of preload, offset and spring";
    match (force, offset_um, spring) {
        (Some((force, condition)), None, None) => of_force("preload", force, condition),
        (None, Some(um), None) if um.is_finite() => Ok(SetPreload::OffsetM(1e-6 * um)),
        (None, Some(um), None) => Err(StudyError::argument("offset", um, "allowed is a finite number of µm")),
        (None, None, Some(spring)) => of_force("spring", spring, SetPreload::SpringN),
        (None, None, None) if is_tandem(sides) => Ok(SetPreload::OffsetM(0.0)),
        (None, None, None) => Err(StudyError::argument("preload", "is missing", format!("allowed is {ways}"))),
        _ => Err(StudyError::argument("preload", "is not alone", format!("allowed is {ways}"))),
    }
}

/// Refuses a preload of bearings that all carry the same way.
pub(super) fn check(sides: &[bool], preload: SetPreload) -> Result<(), StudyError> {
    let (name, value) = match preload {
        SetPreload::UnmountedN(force) | SetPreload::MountedN(force) | SetPreload::RunningN(force) => ("preload", force),
        SetPreload::OffsetM(offset) => ("offset", 1e6 * offset),
        SetPreload::SpringN(force) => ("spring", force),
    };
    if value == 0.0 || !is_tandem(sides) {
        return Ok(());
    }
    let why = "all bearings carry the same way: nothing presses them against each other; without it their \
               displacement counts from where they touch";
    Err(StudyError::argument(name, value, why))
}
