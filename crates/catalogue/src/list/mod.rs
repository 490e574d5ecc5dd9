//! Sizes that catalogues list, with their boundary dimensions and load ratings.

mod angular_contact;
mod balls;
mod deep_groove;
mod thin;
mod thin_angular;

pub use balls::PublishedBalls;

use crate::designation::Designation;
use crate::suffixes::Part;
use crate::{CatalogueError, ClearanceGroup, Envelope, Ratings};

/// Where dimensions and ratings of most of the list come from.
pub const SOURCE: &str = "NSK, Rolling Bearings, CAT. No. E1102; boundary dimensions as in ISO 15";
const SOURCE_64: &str = "Koyo, Ball and Roller Bearings; boundary dimensions as in ISO 15";
const SOURCE_718: &str = "NTN, Ball and Roller Bearings; boundary dimensions as in ISO 15";

/// One line of the list.
pub(crate) struct Row {
    /// Designation without blanks; angular-contact bearings with the letters of their contact angle.
    designation: &'static str,
    /// Nominal contact angle, degrees.
    angle_deg: f64,
    /// Bore, outside diameter, width, mm.
    dimensions_mm: [f64; 3],
    /// C_r and C_0r, N.
    ratings: [f64; 2],
}

/// A line from whole numbers, as a catalogue prints it.
const fn row(designation: &'static str, angle_deg: i32, mm: [i32; 3], ratings: [i32; 2]) -> Row {
    Row {
        designation,
        angle_deg: angle_deg as f64,
        dimensions_mm: [mm[0] as f64, mm[1] as f64, mm[2] as f64],
        ratings: [ratings[0] as f64, ratings[1] as f64],
    }
}

/// A bearing of the list, and what a designation says of it besides.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedBearing {
    /// Its designation as the list has it.
    pub designation: String,
    /// Boundary dimensions and nominal contact angle.
    pub envelope: Envelope,
    /// Load ratings; absent where the list has the size, but not with this contact angle.
    pub ratings: Option<Ratings>,
    /// The catalogue of dimensions and ratings.
    pub source: &'static str,
    /// Balls that are published for this size.
    pub balls: Option<PublishedBalls>,
    /// Prefixes and suffixes, with their meaning.
    pub parts: Vec<Part>,
    /// Group of radial internal clearance, where the designation says it.
    pub clearance: Option<ClearanceGroup>,
    /// True for balls of silicon nitride.
    pub ceramic_balls: bool,
}

/// All bearings of the list, deep-groove ones first.
pub fn listed() -> impl Iterator<Item = ListedBearing> {
    rows().map(|row| row.bearing())
}

fn rows() -> impl Iterator<Item = &'static Row> {
    let deep_groove = deep_groove::ROWS.iter().chain(thin::ROWS);
    deep_groove.chain(angular_contact::ROWS).chain(thin_angular::ROWS)
}

impl Row {
    fn bearing(&self) -> ListedBearing {
        let [bore, outside, width] = self.dimensions_mm.map(|mm| mm * 1e-3);
        let [dynamic, at_rest] = self.ratings;
        ListedBearing {
            designation: self.designation.to_owned(),
            envelope: Envelope { bore, outside, width, contact_angle: self.angle_deg.to_radians() },
            ratings: Some(Ratings { dynamic, at_rest }),
            source: self.source(),
            balls: balls::published(self.designation),
            parts: Vec::new(),
            clearance: None,
            ceramic_balls: false,
        }
    }

    fn source(&self) -> &'static str {
        match self.designation {
            d if d.starts_with("64") => SOURCE_64,
            d if d.starts_with("718") => SOURCE_718,
            _ => SOURCE,
        }
    }

    /// The designation without the letters of the contact angle.
    fn size(&self) -> &'static str {
        self.designation.trim_end_matches(char::is_alphabetic)
    }
}

/// The bearing of a designation as people write it, such as `6206`, `6205-2RS C3`, `7210B`, `7014CDGA/P4A`,
/// `B7014-C-T-P4S` or, with an angle in degrees, `7210`.
///
/// # Errors
/// [`CatalogueError::Unknown`] with what the list has, [`CatalogueError::Type`] for bearings that the models do not
/// hold for, [`CatalogueError::Part`] for what is not understood, [`CatalogueError::Angle`] for an angular-contact
/// bearing without contact angle, with two of them, or for an angle where the bearing is a deep-groove one.
pub fn find(designation: &str, angle_deg: Option<f64>) -> Result<ListedBearing, CatalogueError> {
    let is_angular = |size: &str| rows().find(|row| row.size() == size).map(|row| row.angle_deg > 0.0);
    let read = Designation::parse(designation, &is_angular)?;
    let bearing = of_size(designation, &read, angle_deg)?;
    let Designation { parts, clearance, ceramic_balls, .. } = read;
    Ok(ListedBearing { parts, clearance, ceramic_balls, ..bearing })
}

/// The bearing of a size with the contact angle of its letter or the one given.
fn of_size(designation: &str, read: &Designation, angle_deg: Option<f64>) -> Result<ListedBearing, CatalogueError> {
    let of_size: Vec<&Row> = rows().filter(|row| row.size() == read.size).collect();
    let Some(first) = of_size.first() else {
        return Err(CatalogueError::Unknown { designation: designation.to_owned(), allowed: allowed(&read.size) });
    };
    let refused = |why: &str| CatalogueError::Angle { designation: designation.to_owned(), why: why.to_owned() };
    if first.angle_deg == 0.0 {
        return match angle_deg {
            None | Some(0.0) => Ok(first.bearing()),
            Some(angle) => Err(refused(&format!("is a deep-groove bearing: it has no contact angle of {angle}°"))),
        };
    }
    let angle = match (read.angle_deg, angle_deg) {
        (Some(letter), Some(given)) if letter != given => {
            return Err(refused(&format!("has {letter}° by its letter, not {given}°")));
        }
        (Some(angle), _) | (None, Some(angle)) => angle,
        (None, None) => {
            let mut angles: Vec<f64> = of_size.iter().map(|row| row.angle_deg).collect();
            angles.sort_by(f64::total_cmp);
            let known: Vec<String> = angles.iter().map(|angle| format!("{angle}°")).collect();
            let why = format!("needs a contact angle; listed are {}: add --angle or its letter", known.join(", "));
            return Err(refused(&why));
        }
    };
    let mut bearing = of_size.iter().find(|row| row.angle_deg == angle).unwrap_or(first).bearing();
    if bearing.envelope.contact_angle != angle.to_radians() {
        // The size of the list with an angle that it has no ratings for.
        bearing.designation.clone_from(&read.size);
        bearing.envelope.contact_angle = angle.to_radians();
        bearing.ratings = None;
    }
    Ok(bearing)
}

/// Bearings of the list whose designation, as the list or as other makers have it, contains a text, or fits one with
/// `*` for any letters; all for an empty one.
pub fn search(pattern: &str) -> Vec<ListedBearing> {
    let plain: String = pattern.to_uppercase().chars().filter(|c| !matches!(c, ' ' | '-')).collect();
    let parts: Vec<&str> = plain.split('*').collect();
    let fits = |name: &str| match parts[..] {
        [part] => name.contains(part),
        _ => globbed(name, &parts),
    };
    listed().filter(|bearing| fits(&bearing.designation)).collect()
}

/// True if a name begins with the first part, ends with the last one, and has the others in order between.
fn globbed(name: &str, parts: &[&str]) -> bool {
    let [first, middle @ .., last] = parts else { return false };
    let Some(mut rest) = name.strip_prefix(first).and_then(|rest| rest.strip_suffix(last)) else { return false };
    middle.iter().all(|part| {
        let found = rest.find(part);
        rest = found.map_or(rest, |at| &rest[at + part.len()..]);
        found.is_some()
    })
}

/// Allowed designations, for one that is not in the list: those of the series of its first digits, or all series.
pub(crate) fn allowed(size: &str) -> String {
    let series = if ["16", "61", "71"].iter().any(|s| size.starts_with(s)) { 3 } else { 2 };
    let of_series = |s: &&str| size.len() > series && s.len() == size.len() && s.starts_with(&size[..series]);
    let mut sizes: Vec<&str> = rows().map(Row::size).filter(of_series).collect();
    sizes.dedup();
    match (sizes.first(), sizes.last()) {
        (Some(first), Some(last)) => format!("{first} to {last}"),
        _ => "series 60, 62, 63, 64, 618, 619, 160 (deep groove), 70, 72, 73, 718, 719 (angular contact), bores up to 200 mm: `tribodyn catalogue` lists them".to_owned(),
    }
}
