//! A row of a data set: what is known of a member, its passages and its signals.

use super::members::Choice;
use super::signal::Signals;
use crate::sweep::{Cell, Column, Kind};
use std::f64::consts::TAU;
use tribodyn_case::{DatasetPlan, FaultClass, SensorSpec};

/// A list in a cell of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum List {
    /// Whole numbers.
    Integers,
    /// Numbers of double precision.
    Numbers,
    /// Numbers of single precision.
    Singles,
}

/// Columns in order, labels first, then those of sensors; one with lists has them as text in the rows that are kept
/// while a set is made.
pub(super) fn columns(plan: &DatasetPlan) -> Vec<(Column, Option<List>)> {
    let of_sensor = |sensor: &SensorSpec| (Column::new(&sensor.name, Kind::Text, false), Some(List::Singles));
    labels().into_iter().chain(plan.sensors.iter().map(of_sensor)).collect()
}

/// Columns that every plan has.
pub(super) fn labels() -> Vec<(Column, Option<List>)> {
    let plain = |name: &str, kind, optional| (Column::new(name, kind, optional), None);
    let list = |name: &str, of| (Column::new(name, Kind::Text, false), Some(of));
    vec![
        plain("member", Kind::Integer, false),
        plain("bearing", Kind::Integer, false),
        plain("split", Kind::Text, false),
        plain("case", Kind::Text, false),
        plain("fault", Kind::Text, false),
        plain("spall_length_mm", Kind::Number, true),
        plain("spall_width_mm", Kind::Number, true),
        plain("spall_depth_um", Kind::Number, true),
        plain("spall_azimuth_deg", Kind::Number, true),
        plain("radial_load_n", Kind::Number, false),
        plain("axial_load_n", Kind::Number, true),
        plain("inner_speed_rpm", Kind::Number, false),
        plain("cage_speed_rpm", Kind::Number, true),
        plain("largest_slip", Kind::Number, true),
        plain("rate_hz", Kind::Number, false),
        plain("step_us", Kind::Number, true),
        plain("acceleration_error_m_s2", Kind::Number, true),
        plain("warnings", Kind::Text, false),
        plain("error", Kind::Text, true),
        list("passed_ball", List::Integers),
        list("passed_inner", List::Integers),
        list("entered_s", List::Numbers),
        list("struck_s", List::Numbers),
        list("left_s", List::Numbers),
    ]
}

/// The name of a class in labels.
pub(super) fn class(fault: FaultClass) -> &'static str {
    match fault {
        FaultClass::Sound => "sound",
        FaultClass::Outer => "outer",
        FaultClass::Inner => "inner",
        FaultClass::Ball => "ball",
    }
}

/// The fields of a member's row; the loads are those of its case.
pub(super) fn row(
    plan: &DatasetPlan,
    (member, choice): (usize, &Choice),
    [radial, axial]: [Option<f64>; 2],
    found: &Result<Signals, String>,
) -> Vec<Cell> {
    let individual = &choice.individual;
    let text = |text: &str| Cell::Text(text.to_owned());
    let number = |value: Option<f64>| value.map_or(Cell::Null, Cell::Number);
    let spalled = individual.length.map(|_| &plan.spall);
    let signals = found.as_ref().ok();
    const RPM: f64 = 60.0 / TAU;
    let mut cells = vec![
        Cell::Integer(member as i64),
        Cell::Integer(individual.number as i64),
        text(if individual.test { "test" } else { "train" }),
        text(&plan.cases[individual.case]),
        text(class(individual.fault)),
        number(individual.length.map(|length| 1e3 * length)),
        number(spalled.map(|spall| 1e3 * spall.width)),
        number(spalled.map(|spall| 1e6 * spall.depth)),
        number(individual.azimuth.map(f64::to_degrees)),
        number(radial),
        number(axial),
        Cell::Number(RPM * choice.speed),
        number(signals.map(|signals| RPM * signals.cage_speed)),
        number(signals.map(|signals| signals.slip)),
        Cell::Number(plan.rate),
        number(signals.and_then(|signals| signals.step).map(|step| 1e6 * step)),
        number(signals.and_then(|signals| signals.acceleration_error)),
        text(&signals.map_or_else(String::new, |signals| signals.warnings.join("; "))),
        found.as_ref().err().map_or(Cell::Null, |why| text(why)),
    ];
    let passages = signals.map(|signals| &signals.passages[..]).unwrap_or_default();
    let joined = |of: &dyn Fn(usize) -> String| Cell::Text((0..passages.len()).map(of).collect::<Vec<_>>().join(" "));
    cells.push(joined(&|k| passages[k].ball.to_string()));
    cells.push(joined(&|k| u8::from(passages[k].inner).to_string()));
    cells.push(joined(&|k| passages[k].entered.to_string()));
    cells.push(joined(&|k| passages[k].struck.to_string()));
    cells.push(joined(&|k| passages[k].left.to_string()));
    let samples = |samples: &Vec<f32>| samples.iter().map(|v| format!("{:08x}", v.to_bits())).collect::<String>();
    match signals {
        Some(signals) => cells.extend(signals.sensors.iter().map(|signal| Cell::Text(samples(signal)))),
        None => cells.extend(plan.sensors.iter().map(|_| text(""))),
    }
    cells
}

/// The single-precision numbers of a cell.
pub(super) fn singles(cell: &Cell) -> Vec<f32> {
    let Cell::Text(text) = cell else { return Vec::new() };
    let (words, _) = text.as_bytes().as_chunks::<8>();
    let bits = |word: &[u8; 8]| u32::from_str_radix(std::str::from_utf8(word).unwrap_or("0"), 16).unwrap_or_default();
    words.iter().map(|word| f32::from_bits(bits(word))).collect()
}

/// The numbers of a cell with blanks between.
pub(super) fn numbers(cell: &Cell) -> Vec<f64> {
    let Cell::Text(text) = cell else { return Vec::new() };
    text.split_ascii_whitespace().filter_map(|word| word.parse().ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_singles_come_back_to_the_bit() {
        let values = [0.0f32, -1.5, f32::MIN_POSITIVE, 3.402e38, -0.0];
        let text: String = values.iter().map(|v| format!("{:08x}", v.to_bits())).collect();
        let back = singles(&Cell::Text(text));
        assert!(back.iter().zip(values).all(|(a, b)| a.to_bits() == b.to_bits()) && back.len() == values.len());
        assert_eq!(numbers(&Cell::Text("0.1 2 -3e-7".to_owned())), [0.1, 2.0, -3e-7]);
        assert!(numbers(&Cell::Text(String::new())).is_empty());
    }
}
