//! `tribodyn traction`: one traction curve.

use crate::failure::Failure;
use crate::table;
use std::io::Write;
use tribodyn::answers::traction_curve;

/// Traction coefficient of a coating at a contact pressure, over slip in the unit of the coating's own data.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn traction --coating ptfe --pressure 2.5 --slip 0,1,3,10")]
pub struct Arguments {
    /// Coating of the library: ag or ptfe
    #[arg(long)]
    coating: String,
    /// Contact pressure, GPa
    #[arg(long, allow_hyphen_values = true)]
    pressure: f64,
    /// Slips, separated by commas
    #[arg(long, value_delimiter = ',', required = true, allow_hyphen_values = true)]
    slip: Vec<f64>,
    /// Order of the polynomials in pressure (2: through the three tested pressures)
    #[arg(long, default_value_t = 2)]
    order: usize,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let a = arguments;
    let answer = traction_curve(&a.coating, a.pressure, &a.slip, a.order)?;
    if a.json {
        return table::print_json(&answer);
    }
    if let Some(note) = &answer.note {
        // If nobody listens, nothing can be done.
        let _ = writeln!(std::io::stderr(), "note: {note}");
    }
    let digits = |v: f64| format!("{v:.6}");
    table::print_pairs(&[
        ("A", digits(answer.a), ""),
        ("B", digits(answer.b), "per slip"),
        ("C", digits(answer.c), "per slip"),
        ("D", digits(answer.d), ""),
        ("peak slip", digits(answer.peak_slip), "slip"),
        ("peak coefficient", digits(answer.peak_coefficient), ""),
    ])?;
    let rows = answer.slip.iter().zip(&answer.coefficient).map(|(s, k)| vec![s.to_string(), digits(*k)]);
    table::print_rows(&["slip", "coefficient"], rows)
}
