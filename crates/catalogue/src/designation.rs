//! Designations as people write them: prefix, basic number, and what follows it.

use crate::suffixes::{ANGULAR_ALLOWED, DEEP_GROOVE_ALLOWED, Effect, Of, PREFIXES, Part, SUFFIXES};
use crate::{CatalogueError, ClearanceGroup};

/// A designation taken apart.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Designation {
    /// Basic number, series 618, 619, 718 and 719 by these names.
    pub size: String,
    /// Prefixes and suffixes, in order.
    pub parts: Vec<Part>,
    /// Nominal contact angle by its letter, degrees.
    pub angle_deg: Option<f64>,
    /// Group of radial internal clearance, where it is said.
    pub clearance: Option<ClearanceGroup>,
    /// True for balls of silicon nitride.
    pub ceramic_balls: bool,
    /// True for a spindle bearing by a prefix of FAG, in whose suffixes E stands for 25°.
    spindle: bool,
}

/// Series that makers call by two digits here and by three there.
const ALIASES: [(&str, &str); 4] = [("68", "618"), ("69", "619"), ("78", "718"), ("79", "719")];

fn is_separator(c: char) -> bool {
    matches!(c, ' ' | '-' | '/' | '.' | '_' | ',')
}

impl Designation {
    /// Takes a designation apart; `listed` tells whether a basic number is in the list and whether it has a contact
    /// angle.
    pub fn parse(text: &str, listed: &dyn Fn(&str) -> Option<bool>) -> Result<Self, CatalogueError> {
        let plain = text.trim().to_uppercase();
        let start = plain.find(|c: char| c.is_ascii_digit()).unwrap_or(plain.len());
        let (before, rest) = plain.split_at(start);
        let mut found = Self {
            size: String::new(),
            parts: Vec::new(),
            angle_deg: None,
            clearance: None,
            ceramic_balls: false,
            spindle: false,
        };
        for word in before.split(is_separator).filter(|word| !word.is_empty()) {
            found.prefix(text, word)?;
        }
        let rest = joined(rest, listed);
        let rest = rest.as_str();
        let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        let (size, after) = basic_number(rest, digits, listed).ok_or_else(|| not_listed(text, &rest[..digits]))?;
        let angular = listed(&size) == Some(true);
        found.size = size;
        found.suffixes(text, after, angular)?;
        Ok(found)
    }

    fn prefix(&mut self, designation: &str, word: &str) -> Result<(), CatalogueError> {
        if let Some(why) = type_of_letters(word) {
            return Err(CatalogueError::Type { designation: designation.to_owned(), why });
        }
        let Some((_, effect, meaning)) = PREFIXES.iter().find(|(prefix, ..)| *prefix == word) else {
            let allowed = PREFIXES.iter().map(|(prefix, ..)| *prefix).collect::<Vec<_>>().join(", ");
            let (designation, part) = (designation.to_owned(), word.to_owned());
            return Err(CatalogueError::Part { designation, part, place: "before", allowed });
        };
        self.ceramic_balls |= *effect == Effect::Ceramic;
        self.spindle |= matches!(word, "B" | "HCB" | "HCS" | "BSS");
        self.parts.push(Part { text: word.to_owned(), meaning });
        Ok(())
    }

    fn suffixes(&mut self, designation: &str, text: &str, angular: bool) -> Result<(), CatalogueError> {
        let mut rest = text.trim_start_matches(is_separator);
        while !rest.is_empty() {
            let fits = |of: Of| of == Of::Any || (of == Of::Angular) == angular;
            let all = SUFFIXES.iter().filter(|suffix| fits(suffix.of) && rest.starts_with(suffix.text));
            let found = all.max_by_key(|suffix| suffix.text.len());
            let e_of_spindle = angular && self.spindle && self.angle_deg.is_none() && rest.starts_with('E');
            let (length, effect, meaning) = match found {
                _ if e_of_spindle => (1, Effect::Angle(25.0), "contact angle 25°"),
                Some(suffix) => (suffix.text.len(), suffix.effect, suffix.meaning),
                None => return Err(self.not_understood(designation, rest, angular)),
            };
            match effect {
                Effect::None => {}
                Effect::Ceramic => self.ceramic_balls = true,
                Effect::Clearance(group) if self.clearance.is_none() => self.clearance = Some(group),
                Effect::Angle(angle) if self.angle_deg.is_none() => self.angle_deg = Some(angle),
                Effect::Several => {
                    let why = format!("stands for {meaning}");
                    return Err(CatalogueError::Type { designation: designation.to_owned(), why });
                }
                // A second clearance or angle.
                Effect::Clearance(_) | Effect::Angle(_) => {
                    return Err(self.not_understood(designation, rest, angular));
                }
            }
            self.parts.push(Part { text: rest[..length].to_owned(), meaning });
            rest = rest[length..].trim_start_matches(is_separator);
        }
        Ok(())
    }

    fn not_understood(&self, designation: &str, rest: &str, angular: bool) -> CatalogueError {
        let end = rest.find(is_separator).unwrap_or(rest.len());
        CatalogueError::Part {
            designation: designation.to_owned(),
            part: rest[..end].to_owned(),
            place: "after",
            allowed: if angular { ANGULAR_ALLOWED } else { DEEP_GROOVE_ALLOWED }.to_owned(),
        }
    }
}

/// A text whose basic number is written in two groups, as 72 10, with the number in one.
fn joined(text: &str, listed: &dyn Fn(&str) -> Option<bool>) -> String {
    match text.split_once(' ') {
        Some((first, rest)) if first.len() <= 3 && rest.starts_with(|c: char| c.is_ascii_digit()) => {
            if listed(first).is_some() { text.to_owned() } else { format!("{first}{rest}") }
        }
        _ => text.to_owned(),
    }
}

/// The basic number at the beginning of a text with so many digits, and what follows it.
fn basic_number<'a>(text: &'a str, digits: usize, listed: &dyn Fn(&str) -> Option<bool>) -> Option<(String, &'a str)> {
    let named = |number: &str| {
        let alias = ALIASES.iter().find(|(short, _)| number.len() == 4 && number.starts_with(short));
        let name = alias.map_or_else(|| number.to_owned(), |(_, long)| format!("{long}{}", &number[2..]));
        listed(&name).map(|_| name)
    };
    if let Some(name) = named(&text[..digits]) {
        return Some((name, &text[digits..]));
    }
    // Two seals or shields that stand at once behind the number: 62062RS.
    let split = digits.checked_sub(1)?;
    let twice = ["2R", "2Z", "2H"].iter().any(|seal| text[split..].starts_with(seal));
    named(&text[..split]).filter(|_| twice).map(|name| (name, &text[split..]))
}

/// Why letters stand for bearings that the models do not hold for.
fn type_of_letters(letters: &str) -> Option<String> {
    let why = match letters {
        "QJ" | "QJF" => {
            "is a four-point bearing: each of its rings has two arcs, and a ball touches at up to four points, where the models have one arc on each ring"
        }
        "N" | "NU" | "NJ" | "NUP" | "NF" | "NN" | "NNU" | "RNU" | "NCF" | "NJG" | "NA" | "HK" | "K" => {
            "is a roller bearing: the models are of balls"
        }
        _ => return None,
    };
    Some(why.to_owned())
}

/// Why a basic number is not in the list.
fn not_listed(designation: &str, number: &str) -> CatalogueError {
    let designation = designation.to_owned();
    let begins = |series: &[&str], length: usize| {
        number.len() == length && series.iter().any(|series| number.starts_with(series))
    };
    let why = if begins(&["10", "11", "12", "13", "14", "22", "23"], 4) {
        "is a self-aligning ball bearing: its outer race is a sphere, not a groove, which the models do not have"
    } else if begins(&["51", "52", "53", "54"], 5) {
        "is a thrust ball bearing: its contact angle is 90°, and the models are of radial bearings, up to 45°"
    } else if begins(&["30", "32", "33", "38", "39", "42", "43", "52", "53", "54"], 4) {
        "has two rows of balls: make a case of one row by its dimensions, and use `tribodyn pair`"
    } else if begins(&["2", "3", "8"], 5) {
        "is a roller bearing: the models are of balls"
    } else {
        return CatalogueError::Unknown { designation, allowed: crate::list::allowed(number) };
    };
    CatalogueError::Type { designation, why: why.to_owned() }
}
