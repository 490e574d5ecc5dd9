//! `tribodyn report A.mcap B.mcap`: what two recordings differ in.

use super::content::Content;
use super::page_table::Table;
use super::values::CaseValue;
use super::{Answer, Evaluated, Kind, compare_figures, opening};
use crate::ReportError;
use crate::words::number;
use crate::words::shown;
use serde::Serialize;
use std::path::{Path, PathBuf};
use tribodyn_plot::Figure;
use tribodyn_signal::BearingFrequencies;
use tribodyn_study::evaluation::facts::said;
use tribodyn_study::evaluation::quantities::{Quantities, Quantity, Values};

/// Contents of `summary.json` and of `--json` for a comparison.
#[derive(Debug, Serialize)]
pub struct Comparison {
    a: PathBuf,
    b: PathBuf,
    differences: Vec<Difference>,
    /// Values of the cases that are not the same, or in one of them only.
    case_differences: Vec<CaseDifference>,
    warnings: Vec<String>,
    figures: Vec<String>,
    notes: Vec<String>,
}

/// A number of both recordings.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Difference {
    /// Its name in JSON, which ends in the unit of all but the last number.
    quantity: String,
    #[serde(skip)]
    name: String,
    #[serde(skip)]
    unit: &'static str,
    #[serde(skip)]
    digits: usize,
    a: f64,
    b: f64,
    difference: f64,
    /// Difference over the magnitude of A; none where A is 0 to the decimals that are shown, and of directions.
    relative_percent: Option<f64>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CaseDifference {
    path: String,
    a: Option<String>,
    b: Option<String>,
}

impl Difference {
    fn new((quantity, name): (String, String), unit: &'static str, digits: usize, [a, b]: [f64; 2]) -> Self {
        let difference = b - a;
        // A direction has no magnitude: azimuth 0 is as good as any.
        let direction = ["load_zone_middle_deg", "highest_load_azimuth_deg"].contains(&quantity.as_str());
        // Rounding, 1e-15 of something large, has no percentage.
        let shows = a.abs() >= 0.5 * 10f64.powi(-(digits as i32));
        let relative_percent = (shows && !direction).then(|| 100.0 * difference / a.abs());
        Self { quantity, name, unit, digits, a, b, difference, relative_percent }
    }
}

/// Both recordings beside each other, with curves over each other.
pub fn compared(a: &Evaluated, b: &Evaluated) -> Result<(Comparison, Content, Vec<Figure>), ReportError> {
    let mut notes = Vec::new();
    let figures = compare_figures::figures(a, b, &mut notes)?;
    let mut warnings = Vec::new();
    if [a, b].map(|e| said(&e.run, "ball_count")).windows(2).any(|pair| pair[0] != pair[1]) {
        warnings.push("The bearings have different numbers of balls.".to_owned());
    }
    for (letter, evaluated) in [("A", a), ("B", b)] {
        warnings.extend(evaluated.kind.warnings().into_iter().map(|warning| format!("{letter}: {warning}")));
    }
    let answer = Comparison {
        a: a.kind.recording().to_owned(),
        b: b.kind.recording().to_owned(),
        differences: differences(&a.kind.numbers(), &b.kind.numbers()),
        case_differences: case_differences(a.kind.case_values(), b.kind.case_values()),
        warnings,
        figures: figures.iter().map(|figure| figure.name.clone()).collect(),
        notes,
    };
    let mut opening = vec![of_both(a, b)];
    if a.case.is_some() && b.case.is_some() {
        opening.push(case_table(&answer.case_differences));
    }
    let content = Content {
        title: format!("{} against {}", name(&answer.b), name(&answer.a)),
        subtitle: "Comparison of two recordings",
        warnings: shown(&answer.warnings),
        tables: vec![table(&answer.differences)],
        opening,
        inputs: Vec::new(),
        notes: answer.notes.clone(),
        case_text: None,
    };
    Ok((answer, content, figures))
}

fn name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

impl Kind {
    fn recording(&self) -> &Path {
        match self {
            Self::Run(answer) => &answer.recording,
            Self::Solution(answer) => &answer.recording,
        }
    }

    fn case_values(&self) -> &[CaseValue] {
        match self {
            Self::Run(answer) => &answer.case_values,
            Self::Solution(answer) => &answer.case_values,
        }
    }

    fn warnings(&self) -> Vec<String> {
        match self {
            Self::Run(answer) => {
                let of_start = answer.warnings_at_start.iter().chain(&answer.untested_pressures);
                of_start.chain(&answer.summary.warnings).cloned().collect()
            }
            Self::Solution(answer) => answer.warnings.clone(),
        }
    }

    /// The numbers that can be compared, those of a run and of a solution under the same names.
    fn numbers(&self) -> Quantities {
        match self {
            Self::Run(answer) => {
                let mut all = answer.operation.0.clone();
                all.extend(of_run(answer));
                all.extend(of_frequencies(&answer.frequencies));
                Quantities(all)
            }
            Self::Solution(answer) => {
                let mut all = answer.operation.0.clone();
                all.extend(
                    answer
                        .power
                        .iter()
                        .flat_map(|p| of_powers([p.shaft_w, p.friction_inner_w, p.friction_outer_w, p.fluid_w])),
                );
                all.extend(of_frequencies(&answer.frequencies));
                Quantities(all)
            }
        }
    }
}

type Named = (&'static str, &'static str, &'static str, &'static str, usize, f64);

fn one((key, name, unit, suffix, digits, value): Named) -> Quantity {
    Quantity { key: key.into(), name: name.into(), unit, suffix, digits, values: Values::One(value) }
}

fn of_powers([shaft, inner, outer, fluid]: [f64; 4]) -> Vec<Quantity> {
    [
        ("power_shaft", "Power of the shaft", "W", "w", 2, shaft),
        ("power_friction_inner", "Friction, inner race", "W", "w", 2, inner),
        ("power_friction_outer", "Friction, outer race", "W", "w", 2, outer),
        ("power_fluid", "Drag and churning", "W", "w", 2, fluid),
    ]
    .map(one)
    .to_vec()
}

fn of_frequencies(f: &BearingFrequencies) -> Vec<Quantity> {
    [
        ("frequency_cage", "FTF, computed", "Hz", "hz", 3, f.cage_hz),
        ("frequency_ball_pass_outer", "BPFO, computed", "Hz", "hz", 3, f.ball_pass_outer_hz),
        ("frequency_ball_pass_inner", "BPFI, computed", "Hz", "hz", 3, f.ball_pass_inner_hz),
        ("frequency_ball_spin", "BSF, computed", "Hz", "hz", 3, f.ball_spin_hz),
    ]
    .map(one)
    .to_vec()
}

/// Quantities that only a run has, and its powers.
fn of_run(answer: &Answer) -> Vec<Quantity> {
    let (s, p) = (&answer.summary, &answer.summary.power.mean);
    let mut all = of_powers([p.shaft_w, p.friction_inner_w, p.friction_outer_w, p.drag_w + p.churning_w]);
    all.extend(
        [
            ("pocket_force_max", "Largest pocket force", "N", "n", 2, s.pocket_force_max_n),
            ("impacts", "Impacts on pockets, whole run", "", "", 0, f64::from(s.impacts)),
            ("coating_inner_min", "Thinnest coating left, inner race", "µm", "um", 4, s.wear.coating_inner_min_um),
            ("coating_outer_min", "Thinnest coating left, outer race", "µm", "um", 4, s.wear.coating_outer_min_um),
        ]
        .map(one),
    );
    if answer.accelerations_supported {
        let rms = [s.outer_acceleration_x_rms_m_s2, s.outer_acceleration_y_rms_m_s2];
        let [x, y] = rms;
        all.extend(
            [
                ("outer_acceleration_x_rms", "Acceleration of the outer ring, rms X", "m/s²", "m_s2", 3, x),
                ("outer_acceleration_y_rms", "Acceleration of the outer ring, rms Y", "m/s²", "m_s2", 3, y),
            ]
            .map(one),
        );
    }
    all
}

/// The numbers that both have; where one has a mean with extremes and the other one value, the mean.
fn differences(a: &Quantities, b: &Quantities) -> Vec<Difference> {
    let both = |qa: &Quantity| {
        let qb = b.0.iter().find(|qb| qb.key == qa.key)?;
        let spans = [qa, qb].map(|q| matches!(q.values, Values::Span { .. }));
        let (unit, digits) = (qa.unit, qa.digits);
        if spans[0] == spans[1] {
            let of_b = qb.fields().into_iter().map(|(.., value)| value);
            let pairs = qa.fields().into_iter().zip(of_b);
            return Some(
                pairs.map(|((key, name, a), b)| Difference::new((key, name), unit, digits, [a, b])).collect::<Vec<_>>(),
            );
        }
        let (key, name, _) = if spans[0] { qa.fields().swap_remove(1) } else { qb.fields().swap_remove(1) };
        Some(vec![Difference::new((key, name), unit, digits, [a.mean(&qa.key)?, b.mean(&qb.key)?])])
    };
    a.0.iter().filter_map(both).flatten().collect()
}

fn case_differences(a: &[CaseValue], b: &[CaseValue]) -> Vec<CaseDifference> {
    let find = |all: &[CaseValue], path: &str| all.iter().find(|v| v.path == path).map(|v| v.value.clone());
    let of_a = a.iter().map(|v| (v.path.clone(), Some(v.value.clone()), find(b, &v.path)));
    let only_b = b.iter().filter(|v| find(a, &v.path).is_none());
    let of_b = only_b.map(|v| (v.path.clone(), None, Some(v.value.clone())));
    let all = of_a.chain(of_b).filter(|(_, a, b)| a != b);
    all.map(|(path, a, b)| CaseDifference { path, a, b }).collect()
}

/// Opening table of both recordings, A beside B.
fn of_both(a: &Evaluated, b: &Evaluated) -> Table {
    let rows = |e: &Evaluated| match &e.kind {
        Kind::Run(answer) => opening::of_run(answer, e.case.as_ref(), &e.run).rows,
        Kind::Solution(answer) => super::solution::opening(answer, e.case.as_ref(), &e.run).rows,
    };
    let (rows_a, rows_b) = (rows(a), rows(b));
    let find = |rows: &[Vec<String>], name: &str| {
        rows.iter().find(|row| row[0] == name).map_or_else(|| "–".to_owned(), |row| row[1].clone())
    };
    let only_b = rows_b.iter().filter(|row| rows_a.iter().all(|other| other[0] != row[0]));
    let names = rows_a.iter().chain(only_b).map(|row| row[0].clone());
    Table {
        title: "What is compared".to_owned(),
        text: String::new(),
        header: vec!["", "A", "B"],
        rows: names.map(|name| vec![name.clone(), find(&rows_a, &name), find(&rows_b, &name)]).collect(),
        numbers: 0..0,
        wide: true,
    }
}

fn case_table(all: &[CaseDifference]) -> Table {
    let or_none = |value: &Option<String>| value.clone().unwrap_or_else(|| "–".to_owned());
    let text = if all.is_empty() { "All values of the two cases are the same." } else { "All others are the same." };
    Table {
        title: "Values of the case that differ".to_owned(),
        text: text.to_owned(),
        header: vec!["Path", "A", "B"],
        rows: all.iter().map(|d| vec![d.path.clone(), or_none(&d.a), or_none(&d.b)]).collect(),
        numbers: 0..0,
        wide: true,
    }
}

fn table(all: &[Difference]) -> Table {
    let rows = all.iter().map(|d| {
        let shown = |value: f64| number(value, d.digits);
        let relative = d.relative_percent.map_or_else(|| "–".to_owned(), |percent| number(percent, 3));
        vec![d.name.clone(), shown(d.a), shown(d.b), shown(d.difference), relative, d.unit.to_owned()]
    });
    Table {
        title: "Differences".to_owned(),
        text: "Runs: the part that their means are of. Relative to the magnitude of A.".to_owned(),
        header: vec!["Quantity", "A", "B", "B − A", "Relative, %", "Unit"],
        rows: rows.collect(),
        numbers: 1..5,
        wide: true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_mean_is_compared_with_a_single_value() {
        let span = |min, mean, max| Values::Span { min, mean, max };
        let of = |values| {
            let torque = one(("friction_torque", "Friction torque", "N m", "nm", 3, 0.0));
            Quantities(vec![Quantity { values, ..torque }, one(("only", "", "", "", 0, 1.0))])
        };
        let [run, solution] = [span(1.0, 2.0, 4.0), Values::One(2.5)].map(of);
        let found = differences(&run, &Quantities(solution.0[..1].to_vec()));
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].quantity.as_str(), found[0].difference), ("friction_torque_mean_nm", 0.5));
        assert_eq!(found[0].relative_percent, Some(25.0));
        assert_eq!(differences(&solution, &run)[0].difference, -0.5);
        let both = differences(&run, &of(span(1.0, -2.0, 5.0)));
        assert_eq!(both.iter().map(|d| d.difference).collect::<Vec<_>>(), [0.0, -4.0, 1.0, 0.0]);
        assert_eq!(Difference::new(Default::default(), "", 0, [0.0, 1.0]).relative_percent, None);
        // Both print as 0.000.
        assert_eq!(Difference::new(Default::default(), "", 3, [2e-7, 7e-9]).relative_percent, None);
        assert_eq!(Difference::new(Default::default(), "", 3, [5e-4, 1e-3]).relative_percent, Some(100.0));
    }

    #[test]
    fn limit_values_of_one_case_only_differ() {
        let value = |path: &str, value: &str| CaseValue {
            path: path.to_owned(),
            value: value.to_owned(),
            class: "",
            source: String::new(),
        };
        let a = [value("x", "1 mm"), value("y", "2"), value("z", "3")];
        let b = [value("x", "1 mm"), value("y", "4"), value("w", "5")];
        let found: Vec<String> = case_differences(&a, &b).into_iter().map(|d| d.path).collect();
        assert_eq!(found, ["y", "z", "w"]);
    }
}
