//! An axis of a sweep: a path with its values, and the column that they make.

use super::columns::{Cell, Column, Kind};
use super::setting::Setting;
use serde::Serialize;

/// A path with the values that it takes.
#[derive(Debug)]
pub(crate) struct Axis {
    pub setting: Setting,
    pub column: Column,
    pub cells: Vec<Cell>,
}

/// One axis in a few words.
#[derive(Debug, Clone, Serialize)]
pub struct AxisSummary {
    /// Name of its column, with the unit.
    pub column: String,
    /// Place in the case.
    pub path: String,
    /// Number of values.
    pub values: usize,
    /// First value, as in a case file.
    pub first: String,
    /// Last value, as in a case file.
    pub last: String,
}

impl Axis {
    /// Numbers of one unit, plain numbers and truth values keep their kind; anything else is text.
    pub fn new(setting: &Setting) -> Self {
        let values = &setting.values;
        let texts = || values.iter().map(|v| Cell::Text(v.clone())).collect();
        let quantities: Option<Vec<_>> = values.iter().map(|v| quantity(v)).collect();
        let truths: Option<Vec<bool>> = values.iter().map(|v| v.parse().ok()).collect();
        let (name, kind, cells) = match (quantities, truths) {
            (Some(q), _) if q.iter().all(|(names, _)| *names == q[0].0) => {
                let name = match q[0].0.split_last() {
                    None => setting.path.clone(),
                    // The names around a unit are steps of the path to it.
                    Some((unit, steps)) => format!("{} [{unit}]", [&[setting.path.as_str()], steps].concat().join(".")),
                };
                (name, Kind::Number, q.iter().map(|(_, v)| Cell::Number(*v)).collect())
            }
            (_, Some(truths)) => (setting.path.clone(), Kind::Truth, truths.into_iter().map(Cell::Truth).collect()),
            _ => (setting.path.clone(), Kind::Text, texts()),
        };
        Self { setting: setting.clone(), column: Column { name, kind, optional: false }, cells }
    }
}

/// `Force(kN(10))` as the names before the number, and the number.
fn quantity(value: &str) -> Option<(Vec<&str>, f64)> {
    let (mut names, mut rest) = (Vec::new(), value.trim());
    while let Some((name, inside)) = rest.split_once('(') {
        names.push(name.trim());
        rest = inside.strip_suffix(')')?.trim();
    }
    let plain = names.iter().all(|n| !n.is_empty() && n.chars().all(|c| c.is_alphanumeric() || c == '_'));
    let number = rest.parse::<f64>().ok().filter(|v| v.is_finite() && plain)?;
    Some((names, number))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(text: &str) -> (String, Kind, Vec<Cell>) {
        let axis = Axis::new(&Setting::parse(text).unwrap());
        (axis.column.name, axis.column.kind, axis.cells)
    }

    #[test]
    fn limit_columns_are_named_after_path_and_unit() {
        let numbers = |values: &[f64]| values.iter().map(|v| Cell::Number(*v)).collect::<Vec<_>>();
        assert_eq!(axis("a.b=kN(1),kN( 2 )"), ("a.b [kN]".to_owned(), Kind::Number, numbers(&[1.0, 2.0])));
        assert_eq!(
            axis("a=Force(kN(1)),Force(kN(2))"),
            ("a.Force [kN]".to_owned(), Kind::Number, numbers(&[1.0, 2.0]))
        );
        assert_eq!(axis("a=1,2.5"), ("a".to_owned(), Kind::Number, numbers(&[1.0, 2.5])));
        assert_eq!(axis("a=true,false"), ("a".to_owned(), Kind::Truth, vec![Cell::Truth(true), Cell::Truth(false)]));
        for mixed in
            ["a=N(1),kN(2)", "a=Peak,Local", "a=kN(1),2", "a=(x: 1),(x: 2)", "a=f(1,2),f(3,4)", "a=kN(nan),kN(1)"]
        {
            assert_eq!(axis(mixed).1, Kind::Text, "{mixed}");
        }
    }
}
