//! Wear of a groove by one contact, strip by strip across it.

use crate::WearError;

/// Wear of a race under one ball, across the groove.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactWear {
    /// Azimuth of the ball, rad, in the frame of the load, which stands still.
    pub azimuth: f64,
    /// Contact angle: where the middle of the contact stands in the groove, rad.
    pub angle: f64,
    /// Half of the contact's width across the groove, seen from the groove's centre, rad.
    pub half_width: f64,
    /// Contact load, N.
    pub load: f64,
    /// Volume worn off the race per time by this ball, m³/s.
    pub volume_rate: f64,
    /// Parts of that volume in strips of equal width from one edge of the contact (at smaller angles) to the other;
    /// only their proportions count.
    pub across: Vec<f64>,
}

impl ContactWear {
    pub(super) fn check(&self) -> Result<(), WearError> {
        if !(self.volume_rate >= 0.0 && self.volume_rate.is_finite()) {
            return Err(WearError::Rate { value: self.volume_rate });
        }
        if !(self.azimuth.is_finite() && self.angle.is_finite()) {
            return Err(WearError::Orbit { azimuth: self.azimuth });
        }
        let sum: f64 = self.across.iter().sum();
        let shaped = self.half_width > 0.0 && self.half_width.is_finite() && sum > 0.0 && sum.is_finite();
        if self.volume_rate > 0.0 && !shaped {
            return Err(WearError::Length { name: "width of a contact", value: self.half_width });
        }
        Ok(())
    }

    /// Calls `put(column, volume per time)` for the columns that the contact covers; together they get all of its
    /// volume, what reaches beyond the groove its last column.
    pub(super) fn share_out(&self, columns: &Columns, mut put: impl FnMut(usize, f64)) {
        let sum: f64 = self.across.iter().sum();
        if self.volume_rate <= 0.0 || sum <= 0.0 {
            return;
        }
        let strip = 2.0 * self.half_width / self.across.len() as f64;
        for (k, part) in self.across.iter().enumerate().filter(|(_, part)| **part > 0.0) {
            let volume = self.volume_rate * part / sum;
            let from = self.angle - self.half_width + strip * k as f64;
            columns.covered(from, from + strip, |column, share| put(column, volume * share));
        }
    }
}

/// Columns of equal angle across a groove.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Columns {
    /// Smallest angle, rad.
    pub begin: f64,
    /// Width of a column, rad.
    pub width: f64,
    pub count: usize,
}

impl Columns {
    /// Middle of a column, rad.
    pub fn middle(&self, column: usize) -> f64 {
        self.begin + (column as f64 + 0.5) * self.width
    }

    /// Calls `part(column, share)` for the columns between two angles, with their shares of the distance, which add up
    /// to 1.
    fn covered(&self, from: f64, to: f64, mut part: impl FnMut(usize, f64)) {
        let last = self.count - 1;
        let place = |angle: f64| (((angle - self.begin) / self.width).max(0.0) as usize).min(last);
        let (first, end) = (place(from), place(to));
        let mut start = from;
        for column in first..=end {
            let edge = if column == end { to } else { self.begin + (column + 1) as f64 * self.width };
            part(column, (edge - start) / (to - from));
            start = edge;
        }
    }

    /// Calls `part(column, weight)` with each column's share of the load under a contact, by Hertz's pressure summed
    /// along the rolling direction, ∝ 1 − (y/a)²; the shares add up to 1.
    pub fn pressed(&self, angle: f64, half_width: f64, mut part: impl FnMut(usize, f64)) {
        // Load from the edge to Y = y/a: ¾ (Y − Y³/3) + ½.
        let carried = |edge: f64| {
            let y = ((edge - angle) / half_width).clamp(-1.0, 1.0);
            0.5 + 0.75 * y - 0.25 * y * y * y
        };
        let (from, to) = (angle - half_width, angle + half_width);
        self.covered(from, to, |column, _| {
            let low = if column == 0 { from } else { self.begin + column as f64 * self.width };
            let high = if column + 1 == self.count { to } else { self.begin + (column + 1) as f64 * self.width };
            part(column, carried(high) - carried(low));
        });
    }
}
