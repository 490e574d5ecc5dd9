//! A groove as it wears, by cells over azimuth and across: volume, depth, coating left, and what a contact finds there.
//!
//! A cell takes the volume that the strips of the contacts wear off it, over its own area R dφ r dα. So the field holds
//! Archard's volume to rounding, whatever the cells are.

mod contact;

pub use contact::ContactWear;

use crate::WearError;
use contact::Columns;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Cells across a groove, from −90° to 90° of contact angle: half a degree each, some 30 under a contact.
const ACROSS: usize = 360;
/// Cells round a ring that stands under the load. Loads vary slowly over the orbit; 3° resolve what 13 balls make.
const AROUND: usize = 120;
/// Part of the new thickness within which a coating goes from whole to gone in a cell: films are rough, and an edge
/// without width would let traction jump from stride to stride.
const THINNING: f64 = 0.1;

/// Place of a groove in its ring.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GroovePlace {
    /// Groove radius r, m.
    pub groove_radius: f64,
    /// Radius of the circle of groove centres about the bearing's axis, m.
    pub centre_radius: f64,
    /// True for the outer race, whose bottom is farther from the axis than its groove's centre.
    pub outer: bool,
}

impl GroovePlace {
    /// Radius of the surface about the axis at a contact angle, m.
    pub fn radius_at(&self, angle: f64) -> f64 {
        let away = self.groove_radius * angle.cos();
        if self.outer { self.centre_radius + away } else { self.centre_radius - away }
    }
}

/// Depth of a groove by cells. In its own frame for a ring that turns under the load, which wears alike all round.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GrooveField {
    place: GroovePlace,
    /// Of the new coating, m.
    thickness: f64,
    /// Cells round: 1 where the ring turns under the load.
    rows: usize,
    /// By row, then by column, m.
    depth: Vec<f64>,
    /// Removed since the beginning, m³.
    volume: f64,
}

/// Wear of one race over the orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct GrooveWear {
    /// One ball at azimuths that rise over one turn; between them its rates are linear.
    pub along_orbit: Vec<ContactWear>,
    /// Number of balls.
    pub ball_count: usize,
    /// True if the ring turns under the load.
    pub turning: bool,
}

/// State of the groove under a contact, weighted by its pressure.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct UnderContact {
    /// Mean depth, m: to first order the balls come so much nearer at a given load.
    pub depth: f64,
    /// Curvature of the worn profile across the groove, 1/m; positive where the middle is deeper.
    pub curvature: f64,
    /// Share of the load on spots where the coating is gone.
    pub bare: f64,
}

/// A cell of a groove.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrooveSpot {
    /// Azimuth of its middle, rad; absent where the groove is alike all round.
    pub azimuth: Option<f64>,
    /// Contact angle of its middle, rad.
    pub angle: f64,
    /// Depth, m.
    pub depth: f64,
}

impl GrooveWear {
    /// Volume worn per time by all balls, m³/s.
    pub fn volume_rate(&self) -> f64 {
        let weights = self.along_orbit.iter().enumerate().map(|(k, ball)| self.part_of_orbit(k) * ball.volume_rate);
        self.ball_count as f64 * weights.sum::<f64>()
    }

    /// Gap, rad, to the next azimuth.
    fn gap(&self, k: usize) -> f64 {
        let n = self.along_orbit.len();
        let gap = (self.along_orbit[(k + 1) % n].azimuth - self.along_orbit[k].azimuth).rem_euclid(TAU);
        if gap > 0.0 { gap } else { TAU }
    }

    /// Part of the orbit that a ball's azimuth stands for.
    pub fn part_of_orbit(&self, k: usize) -> f64 {
        let n = self.along_orbit.len();
        0.5 * (self.gap(k) + self.gap((k + n - 1) % n)) / TAU
    }

    /// Parts of the orbit within each of some equal sectors that belong to a ball's azimuth, its rate falling linearly
    /// towards its neighbours.
    fn sectors(&self, k: usize, count: usize) -> Vec<f64> {
        let mut parts = vec![0.0; count];
        let n = self.along_orbit.len();
        let middle = self.along_orbit[k].azimuth;
        for (gap, sign) in [(self.gap(k), 1.0), (self.gap((k + n - 1) % n), -1.0)] {
            // Halves of the hat in small pieces, each with its exact integral.
            let pieces = 2 * ((gap / TAU * count as f64).ceil() as usize).max(1);
            for piece in 0..pieces {
                let share = (piece as f64 + 0.5) / pieces as f64;
                let at = (middle + sign * share * gap).rem_euclid(TAU) / TAU * count as f64;
                parts[(at as usize).min(count - 1)] += (1.0 - share) * gap / pieces as f64 / TAU;
            }
        }
        parts
    }

    fn check(&self) -> Result<(), WearError> {
        self.along_orbit.iter().try_for_each(ContactWear::check)?;
        let turn: f64 = (0..self.along_orbit.len()).map(|k| self.gap(k)).sum();
        match self.along_orbit.first() {
            Some(first) if (turn - TAU).abs() > 1e-9 => Err(WearError::Orbit { azimuth: first.azimuth }),
            _ => Ok(()),
        }
    }
}

impl GrooveField {
    /// A groove with a coating of `thickness` (m) of which the part `worn` is gone everywhere; `turning` where its ring
    /// turns under the load all the time.
    ///
    /// # Errors
    /// [`WearError`] for a thickness, a part or a radius out of range.
    pub fn new(place: GroovePlace, thickness: f64, worn: f64, turning: bool) -> Result<Self, WearError> {
        if !(thickness >= 0.0 && thickness.is_finite()) {
            return Err(WearError::Thickness { value: thickness });
        }
        if !(0.0..=1.0).contains(&worn) {
            return Err(WearError::Fraction { name: "worn part of the coating", value: worn });
        }
        let lengths = [("groove radius", place.groove_radius), ("radius of the track", place.radius_at(0.0))];
        for (name, value) in lengths {
            if !(value > 0.0 && value.is_finite()) {
                return Err(WearError::Length { name, value });
            }
        }
        let rows = if turning { 1 } else { AROUND };
        Ok(Self { place, thickness, rows, depth: vec![worn * thickness; rows * ACROSS], volume: 0.0 })
    }

    fn columns(&self) -> Columns {
        Columns { begin: -FRAC_PI_2, width: 2.0 * FRAC_PI_2 / ACROSS as f64, count: ACROSS }
    }

    /// Area of a cell, m².
    fn area(&self, column: usize) -> f64 {
        let columns = self.columns();
        let round = TAU / self.rows as f64 * self.place.radius_at(columns.middle(column));
        round * columns.width * self.place.groove_radius
    }

    /// Depth per time of each cell, m/s.
    ///
    /// # Errors
    /// [`WearError`] for rates that are negative or not finite, contacts without width, and azimuths that do not rise
    /// over one turn.
    pub fn depth_rates(&self, wear: &GrooveWear) -> Result<Vec<f64>, WearError> {
        wear.check()?;
        let columns = self.columns();
        let mut volumes = vec![0.0; self.depth.len()];
        for (k, contact) in wear.along_orbit.iter().enumerate() {
            let parts = match wear.turning || self.rows == 1 {
                true => vec![wear.part_of_orbit(k) / self.rows as f64; self.rows],
                false => wear.sectors(k, self.rows),
            };
            contact.share_out(&columns, |column, volume| {
                for (row, part) in parts.iter().enumerate().filter(|(_, part)| **part > 0.0) {
                    volumes[row * ACROSS + column] += wear.ball_count as f64 * part * volume;
                }
            });
        }
        for (cell, volume) in volumes.iter_mut().enumerate() {
            *volume /= self.area(cell % ACROSS);
        }
        Ok(volumes)
    }

    /// Lets rates of [`Self::depth_rates`] act for a time, s.
    pub fn wear(&mut self, rates: &[f64], time: f64) {
        for (cell, rate) in rates.iter().enumerate() {
            let depth = rate * time;
            self.depth[cell] += depth;
            self.volume += depth * self.area(cell % ACROSS);
        }
    }

    /// Longest time, s, in which no cell with coating loses more than a part of the new one: no longer than until the
    /// first spot is through. Once one is, cells go into their steel within a stride. Endless where nothing wears or
    /// there is no coating.
    pub fn longest(&self, rates: &[f64], part: f64) -> f64 {
        let through = self.thinnest() <= 1e-9 * self.thickness;
        let time = |(depth, rate): (&f64, &f64)| {
            let left = (self.thickness - depth) * (1.0 + 1e-12) + 1e-12 * self.thickness;
            let most = part * self.thickness;
            (if through { most } else { most.min(left) }) / rate
        };
        let coated = |(depth, rate): &(&f64, &f64)| **rate > 0.0 && (!through || **depth < self.thickness);
        let cells = || self.depth.iter().zip(rates);
        match self.thickness {
            0.0 => f64::INFINITY,
            _ if cells().any(|cell| coated(&cell)) => cells().filter(coated).map(time).fold(f64::INFINITY, f64::min),
            // All that is rolled over is through: strides of as much steel.
            _ => cells().filter(|(_, rate)| **rate > 0.0).map(time).fold(f64::INFINITY, f64::min),
        }
    }

    /// State of the groove under the contacts, on the mean of the orbit, each contact by its load.
    pub fn under(&self, wear: &GrooveWear) -> UnderContact {
        let (mut sum, mut loads) = (UnderContact::default(), 0.0);
        for (k, contact) in wear.along_orbit.iter().enumerate().filter(|(_, c)| c.load > 0.0 && c.half_width > 0.0) {
            let load = contact.load * wear.part_of_orbit(k);
            let found = self.under_contact(contact);
            sum.depth += load * found.depth;
            sum.curvature += load * found.curvature;
            sum.bare += load * found.bare;
            loads += load;
        }
        let mean = |value: f64| if loads > 0.0 { value / loads } else { 0.0 };
        UnderContact { depth: mean(sum.depth), curvature: mean(sum.curvature), bare: mean(sum.bare) }
    }

    /// State of the groove under one contact where it stands, by its pressure.
    pub fn under_contact(&self, contact: &ContactWear) -> UnderContact {
        let row = ((contact.azimuth.rem_euclid(TAU) / TAU * self.rows as f64) as usize).min(self.rows - 1);
        let columns = self.columns();
        let (mut depth, mut bare, mut square, mut fourth, mut by_square) = (0.0, 0.0, 0.0, 0.0, 0.0);
        columns.pressed(contact.angle, contact.half_width, |column, weight| {
            let d = self.depth[row * ACROSS + column];
            let y = (columns.middle(column) - contact.angle) * self.place.groove_radius;
            depth += weight * d;
            bare += weight * self.gone(d);
            square += weight * y * y;
            fourth += weight * y.powi(4);
            by_square += weight * y * y * d;
        });
        // Least squares of d = c_0 − κ y²/2, weighted by the pressure.
        let slope = (by_square - depth * square) / (fourth - square * square);
        UnderContact { depth, curvature: -2.0 * slope, bare }
    }

    /// Part of the coating that is gone at a depth.
    fn gone(&self, depth: f64) -> f64 {
        if self.thickness == 0.0 {
            return 0.0;
        }
        ((depth / self.thickness - (1.0 - THINNING)) / THINNING).clamp(0.0, 1.0)
    }

    /// Volume removed since the beginning, m³.
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// The integral of the depth over the groove, m³, with what was worn at the beginning.
    pub fn integral(&self) -> f64 {
        self.depth.iter().enumerate().map(|(cell, depth)| depth * self.area(cell % ACROSS)).sum()
    }

    /// Thickness of the new coating, m.
    pub fn new_thickness(&self) -> f64 {
        self.thickness
    }

    /// Thinnest coating left of any cell, m.
    pub fn thinnest(&self) -> f64 {
        (self.thickness - self.deepest().depth).max(0.0)
    }

    /// The deepest cell, the first of several.
    pub fn deepest(&self) -> GrooveSpot {
        let deeper = |best: usize, cell: usize| if self.depth[cell] > self.depth[best] { cell } else { best };
        self.spot((0..self.depth.len()).fold(0, deeper))
    }

    fn spot(&self, cell: usize) -> GrooveSpot {
        let azimuth = (self.rows > 1).then(|| ((cell / ACROSS) as f64 + 0.5) * TAU / self.rows as f64);
        GrooveSpot { azimuth, angle: self.columns().middle(cell % ACROSS), depth: self.depth[cell] }
    }

    /// The cells that are worn, row by row.
    pub fn worn_cells(&self) -> impl Iterator<Item = GrooveSpot> + '_ {
        (0..self.depth.len()).filter(|&cell| self.depth[cell] > 0.0).map(|cell| self.spot(cell))
    }
}

#[cfg(test)]
mod tests;
