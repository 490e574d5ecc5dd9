//! The generated block of docs/reliability.md.

use super::row::{HEAD, Row};
use crate::error::Failure;
use crate::rows::Rows;

pub const ROWS: Rows<'static> =
    Rows { document: "docs/reliability.md", marks: ["<!-- faults:begin -->", "<!-- faults:end -->"], head: &HEAD };

/// Puts the rows of these trials into the table; rows of faults that were not tried this time stay.
pub fn rewrite(rows: &[Row]) -> Result<(), Failure> {
    ROWS.rewrite(&rows.iter().map(Row::cells).collect::<Vec<_>>())
}
