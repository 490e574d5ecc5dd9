//! The steady orbit of `solve --model steady-orbit` as a person reads it, and tables as files.

use crate::failure::Failure;
use crate::input::ReplaceArguments;
use crate::table::{self, number};
use std::path::Path;
use tribodyn::answers::OrbitAnswer;
use tribodyn_bearing::BallResult;
use tribodyn_study::{Ours, StagedFiles};

/// Summary and balls; `rows` prints the table of balls.
pub fn print(
    name: &str,
    answer: &OrbitAnswer,
    rows: impl FnOnce(&[BallResult]) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let s = &answer.orbit;
    let triple = |v: [f64; 3], factor: f64, digits: usize| v.map(|c| number(c * factor, digits)).join("  ");
    let contacts = s.pocket_contact_azimuths_deg.iter().map(|a| number(*a, 1)).collect::<Vec<_>>();
    let mut pairs = vec![
        ("cage speed", number(s.cage_speed_rpm, 3), "r/min"),
        ("ring displacement x y z", triple(s.ring_displacement_m, 1e6, 3), "µm"),
        ("ring tilt about x y", s.ring_tilt_rad.map(|t| number(t * 1e3, 4)).join("  "), "mrad"),
        ("ring load x y z", triple(s.ring_load_n, 1.0, 2), "N"),
        ("shaft torque", number(s.shaft_torque_nm, 3), "N m"),
        ("friction of inner, outer contacts", s.friction_w.map(|w| number(w, 2)).join("  "), "W"),
        ("drag and churning", number(s.fluid_w, 2), "W"),
        ("friction in the pockets", number(s.pocket_w, 3), "W"),
        ("largest pocket force", number(s.pocket_force_max_n, 2), "N"),
    ];
    if !contacts.is_empty() {
        pairs.push(("balls meet their pockets at", contacts.join("  "), "°"));
    }
    pairs.push(("largest relative residual", format!("{:.1e}", s.residual), ""));
    pairs.push(("patch error estimate (of load)", format!("{:.1e}", s.patch_error_estimate), ""));
    table::print_head(name, &answer.findings)?;
    table::print_pairs(&pairs)?;
    table::print_line("")?;
    rows(&s.balls)?;
    table::print_warnings(answer.findings.warnings())
}

/// Writes a table under a temporary name first; it may not replace the case, nor a file of others unasked.
pub fn write_table(path: &Path, case: &Path, text: &str, replace: &ReplaceArguments) -> Result<(), Failure> {
    replace.check(path, case, Ours::Table)?;
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
        let message = "allowed is the path of a file".to_owned();
        return Err(Failure::Option { option: "csv", value: path.display().to_string(), message });
    };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut staged = StagedFiles::new(folder, replace.force)?;
    staged.write(name.to_owned(), text.as_bytes())?;
    Ok(staged.publish()?)
}
