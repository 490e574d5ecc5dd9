//! Figures as files.

pub use tribodyn_report::stage;

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
