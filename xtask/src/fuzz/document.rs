//! The generated block of docs/reliability.md.

use super::{HEAD, Tried, cells};
use crate::error::Failure;
use crate::rows::Rows;

pub const ROWS: Rows<'static> =
    Rows { document: "docs/reliability.md", marks: ["<!-- fuzz:begin -->", "<!-- fuzz:end -->"], head: &HEAD };

/// Puts the rows of these targets into the table; those of other targets stay.
pub fn rewrite(tried: &[Tried]) -> Result<(), Failure> {
    ROWS.rewrite(&cells(tried))
}
