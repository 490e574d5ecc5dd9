//! Figures as files.

use crate::failure::Failure;
use tribodyn_plot::Figure;
use tribodyn_study::StagedFiles;

/// Wide enough for a page at 200 dots per inch.
const PNG_WIDTH: u32 = 1600;

/// A figure over the columns of a table: its name and title, its axis with unit and the unit's count in that of the
/// columns, and its lines by name and column.
pub struct Plan {
    pub name: &'static str,
    pub title: &'static str,
    pub axis: (&'static str, &'static str, f64),
    pub lines: &'static [(&'static str, &'static str)],
}

/// A plan in one line.
pub const fn plan(
    name: &'static str,
    title: &'static str,
    axis: (&'static str, &'static str, f64),
    lines: &'static [(&'static str, &'static str)],
) -> Plan {
    Plan { name, title, axis, lines }
}

/// Writes a figure as SVG and PNG, which get their names with the other files.
pub fn stage(staged: &mut StagedFiles, figure: &Figure) -> Result<(), Failure> {
    staged.write(format!("{}.svg", figure.name), figure.svg().as_bytes())?;
    Ok(staged.write(format!("{}.png", figure.name), &figure.png(PNG_WIDTH)?)?)
}
