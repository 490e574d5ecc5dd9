//! Every value of a case, readable and with its source.

use serde::Serialize;
use tribodyn_case::{Case, Source, locate, values};

/// A value of the case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CaseValue {
    /// As for `--set`.
    pub path: String,
    /// With its unit.
    pub value: String,
    /// `published`, `catalogue`, `reference`, `assumed`, `searched`, `identified`, `default`, or empty where
    /// no source is given.
    pub class: &'static str,
    pub source: String,
}

impl CaseValue {
    /// Its section: the first name of the path.
    pub fn section(&self) -> &str {
        self.path.split(['.', '[']).next().unwrap_or_default()
    }
}

/// All values in the order of the text, and the defaults of what the text leaves out.
pub fn all(text: &str, case: &Case) -> Vec<CaseValue> {
    let sources: Vec<(std::ops::Range<usize>, &Source)> =
        case.sources.iter().filter_map(|(path, source)| Some((locate(text, path)?, source))).collect();
    let listed = values(text);
    let mut found: Vec<CaseValue> = listed
        .iter()
        .map(|(path, range)| {
            // The source of the smallest part of the case that holds the value, else those of what stands inside it.
            let around = sources.iter().filter(|(r, _)| r.start <= range.start && range.end <= r.end);
            let inside = sources.iter().filter(|(r, _)| range.start <= r.start && r.end <= range.end);
            let nearest = around.min_by_key(|(r, _)| r.len()).map(|(_, source)| vec![*source]);
            let of = nearest.unwrap_or_else(|| inside.map(|(_, source)| *source).collect());
            let (class, from): (Vec<_>, Vec<_>) = of.into_iter().map(described).unzip();
            let class = class.first().copied().unwrap_or_default();
            CaseValue { path: path.clone(), value: readable(&text[range.clone()]), class, source: from.join("; ") }
        })
        .collect();
    let given = |path: &str| listed.iter().any(|(p, _)| p == path || p.starts_with(&format!("{path}.")));
    for (path, value) in defaults(case) {
        if given(&path) {
            continue;
        }
        let section = path.split('.').next().unwrap_or_default();
        let place = found.iter().rposition(|v| v.section() == section).map_or(found.len(), |last| last + 1);
        let source = "not in the case file".to_owned();
        found.insert(place, CaseValue { path, value, class: "default", source });
    }
    found
}

/// Class and text of a source.
fn described(source: &Source) -> (&'static str, String) {
    match source {
        Source::Published(from) => ("published", from.clone()),
        Source::Catalogue(from) => ("catalogue", from.clone()),
        Source::Reference(from) => ("reference", from.clone()),
        Source::Assumed(why) => ("assumed", why.clone()),
        Source::Searched(of) => ("searched", of.clone()),
        Source::Identified { spread, from } => ("identified", format!("spread {spread}; {from}")),
    }
}

/// Entries that a case may leave out, with the values that then hold.
fn defaults(case: &Case) -> Vec<(String, String)> {
    let n = &case.numerics;
    let mut all = vec![
        ("numerics.tolerance".to_owned(), format!("{:e}", n.tolerance)),
        ("numerics.max_iterations".to_owned(), n.max_iterations.to_string()),
    ];
    if let Some(coatings) = &case.coatings {
        all.push(("coatings.inner.worn".to_owned(), coatings.inner.worn.to_string()));
        all.push(("coatings.outer.worn".to_owned(), coatings.outer.worn.to_string()));
    }
    if let Some(cage) = &case.cage {
        all.push(("cage.pocket_damping".to_owned(), format!("{} s/m", cage.pocket_damping)));
    }
    let absent = [
        ("fluid", case.fluid.is_none(), "none: no drag, no churning"),
        ("defects", case.defects.is_empty(), "none"),
        ("spalls", case.spalls.is_empty(), "none"),
        ("deviations", case.deviations.is_none(), "none: round races, equal balls"),
        ("cage.guidance", case.cage.as_ref().is_some_and(|cage| cage.guidance.is_none()), "none: guided by the balls"),
    ];
    all.extend(absent.into_iter().filter(|(_, is, _)| *is).map(|(path, _, value)| (path.to_owned(), value.to_owned())));
    all
}

/// Symbols of the units of case files.
const UNITS: &[(&str, &str)] = &[
    ("m", "m"),
    ("mm", "mm"),
    ("um", "µm"),
    ("inch", "in"),
    ("rad", "rad"),
    ("deg", "°"),
    ("mrad", "mrad"),
    ("Pa", "Pa"),
    ("kPa", "kPa"),
    ("MPa", "MPa"),
    ("GPa", "GPa"),
    ("kg_per_m3", "kg/m³"),
    ("g_per_cm3", "g/cm³"),
    ("N", "N"),
    ("kN", "kN"),
    ("Nm", "N m"),
    ("Nmm", "N mm"),
    ("rad_per_s", "rad/s"),
    ("rpm", "r/min"),
    ("K", "K"),
    ("degC", "°C"),
    ("Pa_s", "Pa s"),
    ("mPa_s", "mPa s"),
    ("uPa_s", "µPa s"),
    ("mm2_per_s", "mm²/s"),
    ("m2_per_s", "m²/s"),
    ("cSt", "mm²/s"),
    ("per_Pa", "1/Pa"),
    ("per_GPa", "1/GPa"),
    ("N_per_m", "N/m"),
    ("N_per_um", "N/µm"),
    ("s", "s"),
    ("ms", "ms"),
    ("us", "µs"),
    ("kg", "kg"),
    ("g", "g"),
    ("kg_m2", "kg m²"),
    ("kg_mm2", "kg mm²"),
    ("N_s_per_m", "N s/m"),
    ("Nm_per_rad", "N m/rad"),
    ("Nm_per_mrad", "N m/mrad"),
    ("Nm_s_per_rad", "N m s/rad"),
    ("Hz", "Hz"),
    ("kHz", "kHz"),
    ("s_per_m", "s/m"),
];

fn symbol(unit: &str) -> Option<&'static str> {
    UNITS.iter().find(|(name, _)| *name == unit).map(|(_, symbol)| *symbol)
}

/// A value as a person writes it: `kN(22.98)` is `22.98 kN`, `Constant(rpm(9000))` is `constant 9000 r/min`.
pub fn readable(value: &str) -> String {
    let value = uncommented(value);
    let value = value.trim();
    if let Some(inner) = value.strip_prefix('"').and_then(|v| v.strip_suffix('"')) {
        return inner.replace("\\\"", "\"");
    }
    let list = [('(', ')'), ('[', ']')];
    if let Some(inner) = list.iter().find_map(|(open, close)| value.strip_prefix(*open)?.strip_suffix(*close)) {
        let nested = inner.contains(['(', '[']) && inner.trim_start().starts_with(['(', '[']);
        let parts: Vec<String> = pieces(inner).into_iter().map(readable).collect();
        return if parts.is_empty() { "none".to_owned() } else { parts.join(if nested { "; " } else { ", " }) };
    }
    let Some((name, inner)) =
        value.split_once('(').and_then(|(name, rest)| Some((name.trim(), rest.strip_suffix(')')?)))
    else {
        return value.split_whitespace().collect::<Vec<_>>().join(" ");
    };
    match (name, symbol(name)) {
        ("Some", _) => readable(inner),
        (_, Some("°")) => format!("{}°", readable(inner)),
        (_, Some(symbol)) => format!("{} {symbol}", readable(inner)),
        _ => {
            let parts: Vec<String> = pieces(inner).into_iter().map(readable).collect();
            format!("{} {}", words(name), parts.join(", "))
        }
    }
}

/// `ContactAngle` as `contact angle`.
fn words(name: &str) -> String {
    let mut text = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !text.is_empty() {
            text.push(' ');
        }
        text.extend(letter.to_lowercase());
    }
    text
}

/// The parts between commas that stand in no bracket and no string.
fn pieces(text: &str) -> Vec<&str> {
    let (mut depth, mut quoted, mut start) = (0, false, 0);
    let mut found = Vec::new();
    for (at, letter) in text.char_indices() {
        match letter {
            '"' => quoted = !quoted,
            '(' | '[' if !quoted => depth += 1,
            ')' | ']' if !quoted => depth -= 1,
            ',' if !quoted && depth == 0 => {
                found.push(&text[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    found.push(&text[start..]);
    found.retain(|piece| !piece.trim().is_empty());
    found
}

/// The text without its line comments.
fn uncommented(text: &str) -> String {
    let line = |line: &str| {
        let quoted = |at: usize| line[..at].matches('"').count() % 2 == 1;
        let comment = line.match_indices("//").map(|(at, _)| at).find(|at| !quoted(*at));
        line[..comment.unwrap_or(line.len())].to_owned()
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_values_read_as_people_write_them() {
        for (value, expected) in [
            ("mm(30.16)", "30.16 mm"),
            ("ContactAngle(deg(18))", "contact angle 18°"),
            ("Constant(rpm(14000))", "constant 14000 r/min"),
            ("Some(kg_m2(6e-5))", "6e-5 kg m²"),
            ("(N_per_um(500), N_per_um(0))", "500 N/µm, 0 N/µm"),
            ("Table([(s(0), rpm(0)), // from rest\n (s(1), rpm(50))])", "table 0 s, 0 r/min; 1 s, 50 r/min"),
            ("\"a, (name) // of <it>\"", "a, (name) // of <it>"),
            ("[]", "none"),
            ("Library(\"ag\")", "library ag"),
            ("QuasiStatic", "QuasiStatic"),
            ("furlong(3)", "furlong 3"),
        ] {
            assert_eq!(readable(value), expected, "{value}");
        }
    }

    #[test]
    fn regress_every_value_of_a_case_has_its_unit_and_nearest_source() {
        let text = include_str!("../../../fixtures/cases/paper-ag-defect.ron");
        let case = Case::from_ron(text).unwrap();
        let found = all(text, &case);
        let of = |path: &str| {
            let value = found.iter().find(|v| v.path == path).unwrap_or_else(|| panic!("{path} is not listed"));
            (value.value.as_str(), value.class, value.source.as_str())
        };
        assert_eq!(found.len(), values(text).len() + 5, "and the defaults of what is left out");
        assert_eq!(of("geometry.ball_diameter").0, "30.16 mm");
        assert_eq!(of("geometry.pitch_diameter").1, "identified");
        assert!(of("geometry.pitch_diameter").2.starts_with("spread 0.46; "));
        assert_eq!(of("materials.ball.young"), ("208.06 GPa", "reference", of("materials.ball.density").2));
        assert_eq!(of("defects[0].width"), ("4°", "assumed", "the paper prints a picture only"));
        assert_eq!(of("transient.scheme.RungeKutta4.step").0, "2.5 µs");
        assert_eq!((of("modelling.race_control").0, of("modelling.race_control").1), ("Outer", "assumed"));
        assert_eq!(of("coatings.inner.worn"), ("0", "default", "not in the case file"));
        assert_eq!((of("transient.duration").0, of("transient.duration").1), ("0.1 s", ""));
        assert!(found.iter().all(|v| !v.value.is_empty()));
    }
}
