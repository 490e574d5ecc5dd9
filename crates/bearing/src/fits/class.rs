//! Tolerance classes of shafts and housings (ISO 286).

use super::grades::{F, FINE_SIZES, G, GRADES, J_5_6, J_7, J_HOLE, K, M, N, P, R, SIZES, range, standard};
use super::{Deviations, FitError};
use crate::Side;
use std::fmt;

/// Where the tolerance lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Position {
    F,
    G,
    H,
    J,
    Js,
    K,
    M,
    N,
    P,
    R,
}

const POSITIONS: [(&str, Position, std::ops::RangeInclusive<u8>); 10] = [
    ("f", Position::F, 4..=10),
    ("g", Position::G, 4..=10),
    ("h", Position::H, 4..=10),
    ("j", Position::J, 5..=8),
    ("js", Position::Js, 4..=10),
    ("k", Position::K, 4..=8),
    ("m", Position::M, 4..=8),
    ("n", Position::N, 4..=8),
    ("p", Position::P, 4..=8),
    ("r", Position::R, 4..=8),
];

/// Tolerance class of a bearing's seat: small letters are shafts, capitals are housings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SeatClass {
    position: Position,
    side: Side,
    grade: u8,
}

impl SeatClass {
    /// Reads a class such as `k5` or `H7`.
    ///
    /// # Errors
    /// [`FitError::Class`] with what is allowed.
    pub fn parse(text: &str) -> Result<Self, FitError> {
        let refused = || FitError::Class { text: text.to_owned() };
        let plain = text.trim();
        let digits = plain.find(|c: char| c.is_ascii_digit()).ok_or_else(refused)?;
        let (letters, grade) = plain.split_at(digits);
        let side = match letters {
            _ if letters.chars().all(|c| c.is_ascii_lowercase()) => Side::Inner,
            _ if letters.chars().all(|c| c.is_ascii_uppercase()) => Side::Outer,
            _ => return Err(refused()),
        };
        let found = POSITIONS.iter().find(|(name, ..)| name.eq_ignore_ascii_case(letters)).ok_or_else(refused)?;
        let (_, position, grades) = found.clone();
        let grade: u8 = grade.parse().map_err(|_| refused())?;
        // Shafts have j5 to j7, holes J6 to J8.
        let outside = position == Position::J && grade == if side == Side::Inner { 8 } else { 5 };
        if outside || !grades.contains(&grade) {
            return Err(refused());
        }
        Ok(Self { position, side, grade })
    }

    /// The ring that sits there: the inner one on a shaft, the outer one in a housing.
    pub fn side(self) -> Side {
        self.side
    }

    /// The same for the seat of a ring.
    ///
    /// # Errors
    /// [`FitError::Seat`] for a class of the other seat.
    pub fn of_ring(self, side: Side) -> Result<Self, FitError> {
        if self.side == side { Ok(self) } else { Err(FitError::Seat { side }) }
    }

    /// Limit deviations at a nominal diameter, m.
    ///
    /// # Errors
    /// [`FitError::Diameter`] beyond 500 mm.
    pub fn deviations(self, diameter: f64) -> Result<Deviations, FitError> {
        let millimetres = diameter * 1e3;
        let (Some(at), Some(fine)) = (range(&SIZES, millimetres), range(&FINE_SIZES, millimetres)) else {
            let class = self.to_string();
            return Err(FitError::Diameter { class, diameter_mm: millimetres, largest_mm: SIZES[SIZES.len() - 1] });
        };
        let width = standard(self.grade, at);
        let from = |low: f64| (low, low + width);
        let (low, high) = match (self.side, self.position) {
            (_, Position::Js) => from(-0.5 * width),
            (Side::Inner, Position::F) => from(-F[at] - width),
            (Side::Inner, Position::G) => from(-G[at] - width),
            (Side::Inner, Position::H) => from(-width),
            (Side::Inner, Position::J) => from(if self.grade == 7 { -J_7[at] } else { -J_5_6[at] }),
            (Side::Inner, position) => from(self.lower_deviation(position, at, fine)),
            (Side::Outer, Position::F) => from(F[at]),
            (Side::Outer, Position::G) => from(G[at]),
            (Side::Outer, Position::H) => from(0.0),
            (Side::Outer, Position::J) => from(J_HOLE[usize::from(self.grade) - 6][at] - width),
            (Side::Outer, position) => from(self.upper_deviation(position, at, fine) - width),
        };
        Ok(Deviations { low: low * 1e-6, high: high * 1e-6 })
    }

    /// Lower deviation of a shaft k to r, µm.
    fn lower_deviation(self, position: Position, at: usize, fine: usize) -> f64 {
        match position {
            Position::K if self.grade > 7 => 0.0,
            Position::K => K[at],
            Position::M => M[at],
            Position::N => N[at],
            Position::P => P[at],
            _ => R[fine],
        }
    }

    /// Upper deviation of a hole K to R, µm: that of the shaft mirrored, less strict by the step Δ between its grade
    /// and the next finer one, so that H and K of one grade fit like the shaft of the finer one (ISO 286-1, 4.3.2.5).
    fn upper_deviation(self, position: Position, at: usize, fine: usize) -> f64 {
        let (mirrored, coarsest) = match position {
            Position::K => (K[at], 8),
            Position::M => (M[at], 8),
            Position::N => (N[at], 8),
            Position::P => (P[at], 7),
            _ => (R[fine], 7),
        };
        // Table 3 has one departure from the rule.
        if position == Position::M && self.grade == 6 && SIZES[at] == 315.0 {
            return -9.0;
        }
        let has_step = at > 0 && self.grade <= coarsest && self.grade > *GRADES.start();
        let step = if has_step { standard(self.grade, at) - standard(self.grade - 1, at) } else { 0.0 };
        step - mirrored
    }
}

impl fmt::Display for SeatClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = POSITIONS.iter().find(|(_, position, _)| *position == self.position).map_or("", |(name, ..)| name);
        match self.side {
            Side::Inner => write!(f, "{name}{}", self.grade),
            Side::Outer => write!(f, "{}{}", name.to_uppercase(), self.grade),
        }
    }
}
