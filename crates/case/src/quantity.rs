//! Single numbers of a case's text, as they are written, in SI, and in the units that may have been meant.

use super::locate::values;
use super::units::{in_si, others};

/// A number of a case file.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Where it stands, choices included: `geometry.fit.ContactAngle`.
    pub path: String,
    /// As it is written: `GPa(208)`.
    pub written: String,
    /// In SI.
    pub value: f64,
}

impl Quantity {
    /// The same number with the other units of its kind, and what it would be in SI; empty for a number without unit.
    pub fn otherwise(&self) -> Vec<(String, f64)> {
        let Some((unit, rest)) = self.written.split_once('(') else { return Vec::new() };
        let inside = rest.trim_end_matches(')');
        let others = number(inside).map_or_else(Vec::new, |number| others(unit, number));
        others.into_iter().map(|(unit, si)| (format!("{unit}({inside})"), si)).collect()
    }
}

/// All numbers of a case's text in its order, the sources left out; empty where the text is not well-formed.
pub fn quantities(text: &str) -> Vec<Quantity> {
    let mut found = Vec::new();
    for (path, range) in values(text) {
        collect(&path, &text[range], &mut found);
    }
    found
}

fn collect(path: &str, value: &str, found: &mut Vec<Quantity>) {
    let value = value.trim();
    if let Some(inside) = enclosed(value, '(', ')').or_else(|| enclosed(value, '[', ']')) {
        for part in parts(inside) {
            collect(path, part, found);
        }
        return;
    }
    let Some((name, rest)) = value.split_once('(') else {
        if let Some(number) = number(value) {
            let written = value.to_owned();
            found.push(Quantity { path: path.to_owned(), written, value: number });
        }
        return;
    };
    let Some(inside) = rest.strip_suffix(')') else { return };
    let name = name.trim();
    match number(inside).and_then(|number| in_si(name, number)) {
        Some(value) => {
            let written = format!("{name}({})", inside.trim());
            found.push(Quantity { path: path.to_owned(), written, value });
        }
        // A choice: `Some` is none that a path names.
        None if name == "Some" => collect(path, inside, found),
        None => parts(inside).into_iter().for_each(|part| collect(&format!("{path}.{name}"), part, found)),
    }
}

fn enclosed(value: &str, open: char, close: char) -> Option<&str> {
    value.strip_prefix(open)?.strip_suffix(close)
}

/// Parts between the commas of the outermost level.
fn parts(inside: &str) -> Vec<&str> {
    let (mut depth, mut start, mut parts) = (0i32, 0, Vec::new());
    for (at, c) in inside.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&inside[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&inside[start..]);
    parts
}

fn number(text: &str) -> Option<f64> {
    let plain: String = text.trim().chars().filter(|c| *c != '_').collect();
    // Words such as `inf` are numbers to the parser, but not to a case file.
    plain.chars().all(|c| c.is_ascii_digit() || "+-.eE".contains(c)).then(|| plain.parse().ok())?
}

#[cfg(test)]
mod tests {
    use super::quantities;

    #[test]
    fn identity_numbers_are_found_with_their_choices_and_other_units() {
        let text = "(geometry: (ball_count: 13, ball_diameter: mm(30.16), fit: ContactAngle(deg(18))),
            supports: (stiffness: (N_per_um(500), N_per_um(400))), traction: (slip_unit: Scaled(per_m_s: 22)),
            ring: (z: ForceTable([(s(0), kN(2)), (s(1), kN(3))])), varying: true, name: \"a\", sources: {\"a\": Assumed(\"5\")})";
        let all = quantities(text);
        let shown: Vec<_> = all.iter().map(|q| (q.path.as_str(), q.written.as_str(), q.value)).collect();
        assert_eq!(
            shown,
            [
                ("geometry.ball_count", "13", 13.0),
                ("geometry.ball_diameter", "mm(30.16)", 0.03016),
                ("geometry.fit.ContactAngle", "deg(18)", 18f64.to_radians()),
                ("supports.stiffness", "N_per_um(500)", 5e8),
                ("supports.stiffness", "N_per_um(400)", 4e8),
                ("traction.slip_unit.Scaled.per_m_s", "22", 22.0),
                ("ring.z.ForceTable", "s(0)", 0.0),
                ("ring.z.ForceTable", "kN(2)", 2000.0),
                ("ring.z.ForceTable", "s(1)", 1.0),
                ("ring.z.ForceTable", "kN(3)", 3000.0),
            ]
        );
        assert!(all[1].otherwise().contains(&("um(30.16)".to_owned(), 3.016e-5)), "{:?}", all[1].otherwise());
        assert_eq!(all[0].otherwise(), []);
    }
}
