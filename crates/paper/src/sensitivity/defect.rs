//! Effect of the defect's size, which the paper does not print, and of the scheme on its rows.

use crate::error::PaperError;
use crate::files;
use crate::table::{Table, markdown};
use crate::transient::{CLASSICAL, FAST, Set, run_all};
use crate::validate::defect_rows;

const RESULT: &str = "fixtures/expected/sensitivity-defect.csv";

/// The scheme and step of the case.
const CASE: &str = "RungeKutta4(step: us(2.5))";
/// Name, width in degrees, depth in µm, bare part, scheme.
const DEFECTS: [(&str, f64, f64, f64, &str); 9] = [
    ("as it is: 4° wide and 2 µm deep and bare", 4.0, 2.0, 1.0, CASE),
    ("half the width", 2.0, 2.0, 1.0, CASE),
    ("double width", 8.0, 2.0, 1.0, CASE),
    ("half the depth", 4.0, 1.0, 1.0, CASE),
    ("double depth", 4.0, 4.0, 1.0, CASE),
    ("coated", 4.0, 2.0, 0.0, CASE),
    ("half bare", 4.0, 2.0, 0.5, CASE),
    ("fast scheme 10 µs", 4.0, 2.0, 1.0, "Fast(step: us(10))"),
    ("fast scheme 20 µs", 4.0, 2.0, 1.0, FAST),
];
/// Half of the case's: two orbits beyond the start.
const DURATION: &str = "s(0.05)";

/// Makes the runs and writes the result.
pub fn run(base: &Set) -> Result<(), PaperError> {
    let plans = DEFECTS.map(|(_, width, depth, bare, scheme)| {
        let list = format!("[(race: Outer, azimuth: deg(0), width: deg({width}), depth: um({depth}), bare: {bare})]");
        CLASSICAL.defect().with("defects", &list).with("transient.scheme", scheme).with("transient.duration", DURATION)
    });
    let mut lines = Vec::new();
    for ((name, ..), run) in DEFECTS.iter().zip(run_all(&plans, None)?) {
        let cells: Vec<String> = defect_rows(&run, &base.ag)?
            .iter()
            .map(|row| format!("{},{}", row.computed_text(), row.verdict.name()))
            .collect();
        let window = run.settled();
        let x = |s: &crate::transient::StateSample| s.outer_acceleration[0];
        lines.push(format!("{name},{},{:.1},{:.1}", cells.join(","), window.peak(x), window.rms(x)));
    }
    let text = format!(
        "# our own output; rewritten by `cargo xtask sensitivity`\n# rows of the defect and the outer ring's \
        acceleration along x, m/s2, last orbits of runs of 0.05 s; the run without defect with the fast scheme at 20 \
        us\nchange,place,place_verdict,height,height_verdict,peak,rms\n{}\n",
        lines.join("\n")
    );
    files::write(&files::root().join(RESULT), text.as_bytes())
}

/// The document's table.
pub fn block() -> Result<String, PaperError> {
    let text = files::read(&files::root().join(RESULT))?;
    let table = Table::read(RESULT, &text)?;
    let mut rows = Vec::new();
    for row in table.rows() {
        rows.push(table.columns().iter().map(|c| row.text(c).map(str::to_owned)).collect::<Result<Vec<_>, _>>()?);
    }
    let head = ["defect", "defect.place", "verdict", "defect.height", "verdict", "peak m/s²", "rms m/s²"];
    Ok(format!("The rows of the defect, whose size the paper does not print:\n\n{}", markdown(&head, &rows)))
}
