//! The plan of a sweep, as a person or a program reads it.

use crate::failure::Failure;
use crate::table::{number, print_json, print_line, print_pairs, print_rows};
use tribodyn_study::sweep::{AxisSummary, Plan};

/// Prints the plan.
pub fn print(plan: &Plan, json: bool) -> Result<(), Failure> {
    if json {
        return print_json(plan);
    }
    let of = |a: &AxisSummary| vec![a.column.clone(), a.values.to_string(), a.first.clone(), a.last.clone()];
    print_rows(&["swept", "values", "first", "last"], plan.axes.iter().map(of))?;
    print_line("")?;
    print_pairs(&[
        ("rows of the grid", plan.grid_rows.to_string(), ""),
        ("rows of this shard", plan.rows.to_string(), ""),
        ("rows in a chunk", plan.chunk_rows.to_string(), ""),
        ("threads", plan.threads.to_string(), ""),
        ("estimated time", number(plan.estimated_time_s, 1), "s"),
    ])
}
