//! Sizes that a catalogue lists, with their boundary dimensions and load ratings.

mod angular_contact;
mod deep_groove;

use crate::{CatalogueError, Envelope, Ratings};

/// Where dimensions and ratings of the list come from.
pub const SOURCE: &str = "NSK, Rolling Bearings, CAT. No. E1102; boundary dimensions as in ISO 15";

/// One line of the list.
pub(crate) struct Row {
    /// Designation without blanks; angular-contact bearings with the letter of their contact angle.
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

/// A bearing of the list.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedBearing {
    /// Its designation as the list has it.
    pub designation: String,
    /// Boundary dimensions and nominal contact angle.
    pub envelope: Envelope,
    /// Load ratings; absent where the list has the size, but not with this contact angle.
    pub ratings: Option<Ratings>,
}

/// All bearings of the list, deep-groove ones first.
pub fn listed() -> impl Iterator<Item = ListedBearing> {
    rows().map(|row| row.bearing())
}

fn rows() -> impl Iterator<Item = &'static Row> {
    deep_groove::ROWS.iter().chain(angular_contact::ROWS)
}

impl Row {
    fn bearing(&self) -> ListedBearing {
        let [bore, outside, width] = self.dimensions_mm.map(|mm| mm * 1e-3);
        let [dynamic, at_rest] = self.ratings;
        ListedBearing {
            designation: self.designation.to_owned(),
            envelope: Envelope { bore, outside, width, contact_angle: self.angle_deg.to_radians() },
            ratings: Some(Ratings { dynamic, at_rest }),
        }
    }

    /// The designation without the letter of the contact angle.
    fn size(&self) -> &'static str {
        self.designation.trim_end_matches(char::is_alphabetic)
    }
}

/// Contact angles of the letters that makers use alike, degrees.
const LETTERS: [(&str, f64); 7] =
    [("A", 30.0), ("B", 40.0), ("BE", 40.0), ("BEP", 40.0), ("C", 15.0), ("AC", 25.0), ("A5", 25.0)];

/// The bearing of a designation such as `6206`, `7210B` or, with an angle in degrees, `7210`; blanks and hyphens are
/// ignored.
///
/// # Errors
/// [`CatalogueError::Unknown`] with what the list has, [`CatalogueError::Angle`] for an angular-contact bearing without
/// contact angle, with two of them, or for an angle where the bearing is a deep-groove one.
pub fn find(designation: &str, angle_deg: Option<f64>) -> Result<ListedBearing, CatalogueError> {
    let plain: String = designation.chars().filter(|c| !matches!(c, ' ' | '-' | '_')).collect();
    let plain = plain.to_uppercase();
    let digits = plain.len().min(plain.find(|c: char| !c.is_ascii_digit()).unwrap_or(plain.len()));
    let (size, suffix) = plain.split_at(digits);
    let of_size: Vec<&Row> = rows().filter(|row| row.size() == size).collect();
    let Some(first) = of_size.first() else {
        return Err(CatalogueError::Unknown { designation: designation.to_owned(), allowed: allowed(size) });
    };
    let mut angles: Vec<f64> = of_size.iter().map(|row| row.angle_deg).collect();
    angles.sort_by(f64::total_cmp);
    let refused = |why: &str| CatalogueError::Angle { designation: designation.to_owned(), why: why.to_owned() };
    if first.angle_deg == 0.0 {
        return match angle_deg {
            None | Some(0.0) => Ok(first.bearing()),
            Some(angle) => Err(refused(&format!("is a deep-groove bearing: it has no contact angle of {angle}°"))),
        };
    }
    let of_letter = LETTERS.iter().find(|(letter, _)| *letter == suffix).map(|(_, angle)| *angle);
    let angle = match (of_letter, angle_deg) {
        (Some(letter), Some(given)) if letter != given => {
            return Err(refused(&format!("has {letter}° by its letter {suffix}, not {given}°")));
        }
        (Some(angle), _) | (None, Some(angle)) => angle,
        (None, None) => {
            let known: Vec<String> = angles.iter().map(|angle| format!("{angle}°")).collect();
            return Err(refused(&format!("needs a contact angle; listed are {}", known.join(", "))));
        }
    };
    let mut bearing = of_size.iter().find(|row| row.angle_deg == angle).unwrap_or(first).bearing();
    if bearing.envelope.contact_angle != angle.to_radians() {
        // The size of the list with an angle that it has no ratings for.
        bearing.designation = size.to_owned();
        bearing.envelope.contact_angle = angle.to_radians();
        bearing.ratings = None;
    }
    Ok(bearing)
}

/// What the list has, for a designation that it does not have: the series of its first two digits, or all series.
fn allowed(size: &str) -> String {
    let mut sizes: Vec<&str> = rows().map(Row::size).filter(|s| size.len() >= 2 && s.starts_with(&size[..2])).collect();
    sizes.dedup();
    match (sizes.first(), sizes.last()) {
        (Some(first), Some(last)) => format!("{first} to {last}"),
        _ => "series 60, 62, 63 (bores 10 to 100 mm), 70, 72 and 73 (10 to 65 mm)".to_owned(),
    }
}
