//! The rows of a run as its summary needs them, gathered while it is recorded.
//!
//! Rows are kept in blocks of 1, 2, 4, … rows each: as many to a block as keep the blocks below [`MOST`]. Up to that
//! number of rows nothing is lost; of a longer run averages begin with a whole block.

use super::cage::{CageBlock, CageMotion};
use super::settled::Settled;
use super::summary::{Powers, Summary, Worn};
use super::warnings;
use std::sync::LazyLock;
use tribodyn_bearing::quantities::{Quantity, joined};
use tribodyn_dynamics::{POWER_IN, POWER_LOST, PowerSample};
use tribodyn_record::wire::Numbers;
use tribodyn_record::{LogRow, StateRow, WearRow};

/// Most blocks that are kept: 2.5 s at 25.6 kHz row by row, in 18 MB.
const MOST: usize = 1 << 16;
/// Parts per billion, the unit of recordings, in one percent.
const PPB_PER_PERCENT: f64 = 1e7;
/// Deviations below this part of the greatest magnitude are rounding: the signal is a constant.
const ROUNDING: f64 = 1e-14;
/// Terms of the power balance.
const POWERS: usize = POWER_IN.len() + POWER_LOST.len();

/// The terms of the power balance with their places in a row.
static PLACES: LazyLock<Vec<(&Quantity<PowerSample>, usize)>> = LazyLock::new(|| {
    let place = |term: &'static Quantity<PowerSample>| {
        Some((term, StateRow::place(&joined(&[term.facts.name, term.facts.shown.suffix]))?))
    };
    POWER_IN.iter().chain(&POWER_LOST).filter_map(place).collect()
});

/// Mean, spread and extremes of one signal over some rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Moments {
    pub count: f64,
    pub mean: f64,
    /// Sum of the squares about the mean.
    squares: f64,
    least: f64,
    most: f64,
}

impl Moments {
    const NONE: Self = Self { count: 0.0, mean: 0.0, squares: 0.0, least: f64::INFINITY, most: f64::NEG_INFINITY };

    fn one(value: f64) -> Self {
        Self { count: 1.0, mean: value, squares: 0.0, least: value, most: value }
    }

    fn and(self, other: Self) -> Self {
        let count = self.count + other.count;
        let apart = other.mean - self.mean;
        Self {
            count,
            mean: (self.count * self.mean + other.count * other.mean) / count,
            squares: self.squares + other.squares + apart * apart * (self.count * other.count / count),
            least: self.least.min(other.least),
            most: self.most.max(other.most),
        }
    }

    /// Over many blocks: the mean first, then the deviations from it.
    fn over(parts: impl Iterator<Item = Self> + Clone) -> Self {
        let (count, sum) = parts.clone().fold((0.0, 0.0), |(n, sum), m| (n + m.count, sum + m.count * m.mean));
        let mean = sum / count;
        parts.fold(Self { count, mean, ..Self::NONE }, |all, m| Self {
            squares: all.squares + m.squares + m.count * (m.mean - mean) * (m.mean - mean),
            least: all.least.min(m.least),
            most: all.most.max(m.most),
            ..all
        })
    }

    /// Greatest distance from the mean.
    fn peak(&self) -> f64 {
        (self.most - self.mean).max(self.mean - self.least)
    }

    /// Root of the mean square about the mean.
    fn rms(&self) -> f64 {
        let constant = self.peak() <= ROUNDING * self.least.abs().max(self.most.abs());
        if constant { 0.0 } else { (self.squares / self.count).sqrt() }
    }
}

/// Some rows after each other.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Block {
    rows: usize,
    /// Of the first row.
    time_s: f64,
    energy_j: f64,
    cage_speed: Moments,
    acceleration: [Moments; 2],
    powers: [f64; POWERS],
    orbital_speed: [f64; 2],
    /// Loads and pressures at the inner and outer race, and the pocket force.
    largest: [f64; 5],
    /// A cage that is free to move.
    free_cage: Option<CageBlock>,
}

impl Block {
    fn of(r: &StateRow) -> Self {
        let mut powers = [0.0; POWERS];
        for (power, (_, place)) in powers.iter_mut().zip(PLACES.iter()) {
            *power = r.number(*place);
        }
        Self {
            rows: 1,
            time_s: r.time_s,
            energy_j: r.energy_j,
            cage_speed: Moments::one(r.cage_speed_rpm),
            acceleration: [r.outer_acceleration_x_m_s2, r.outer_acceleration_y_m_s2].map(Moments::one),
            powers,
            orbital_speed: [r.orbital_speed_min_rpm, r.orbital_speed_max_rpm],
            largest: [
                r.load_inner_max_n,
                r.load_outer_max_n,
                r.peak_pressure_inner_max_gpa,
                r.peak_pressure_outer_max_gpa,
                r.pocket_force_max_n,
            ],
            free_cage: CageBlock::of(r),
        }
    }

    /// This one and the one after it.
    fn and(&self, next: &Self) -> Self {
        let (a, b) = (self.rows as f64, next.rows as f64);
        Self {
            rows: self.rows + next.rows,
            time_s: self.time_s,
            energy_j: self.energy_j,
            cage_speed: self.cage_speed.and(next.cage_speed),
            acceleration: [0, 1].map(|k| self.acceleration[k].and(next.acceleration[k])),
            powers: std::array::from_fn(|k| (a * self.powers[k] + b * next.powers[k]) / (a + b)),
            orbital_speed: [
                self.orbital_speed[0].min(next.orbital_speed[0]),
                self.orbital_speed[1].max(next.orbital_speed[1]),
            ],
            largest: std::array::from_fn(|k| self.largest[k].max(next.largest[k])),
            free_cage: self.free_cage.zip(next.free_cage).map(|(one, two)| one.and(&two, [a, b])),
        }
    }

    /// Power of the drives of both rings, W; the first term of all.
    fn shaft_w(&self) -> f64 {
        self.powers[0]
    }
}

/// The rows of a run so far.
#[derive(Debug, Clone, PartialEq)]
pub struct Gathered {
    /// Rows of a full block, a power of two.
    rows_of_block: usize,
    most: usize,
    blocks: Vec<Block>,
    rows: usize,
    last: Option<StateRow>,
    /// Cage speed of the first row, r/min.
    cage_speed_start_rpm: f64,
    balls_in_contact_min: u32,
}

impl Default for Gathered {
    fn default() -> Self {
        Self::with_most(MOST)
    }
}

impl Gathered {
    fn with_most(most: usize) -> Self {
        Self {
            rows_of_block: 1,
            most,
            blocks: Vec::new(),
            rows: 0,
            last: None,
            cage_speed_start_rpm: 0.0,
            balls_in_contact_min: u32::MAX,
        }
    }

    /// Takes in the next row.
    pub fn add(&mut self, row: StateRow) {
        let one = Block::of(&row);
        if self.rows == 0 {
            self.cage_speed_start_rpm = row.cage_speed_rpm;
        }
        self.rows += 1;
        self.balls_in_contact_min = self.balls_in_contact_min.min(row.balls_in_contact);
        self.last = Some(row);
        match self.blocks.last_mut().filter(|block| block.rows < self.rows_of_block) {
            Some(open) => *open = open.and(&one),
            None => {
                if self.blocks.len() == self.most {
                    self.halve();
                }
                self.blocks.push(one);
            }
        }
    }

    fn halve(&mut self) {
        self.rows_of_block *= 2;
        let pairs = self.blocks.chunks(2).map(|pair| pair[1..].iter().fold(pair[0], |one, next| one.and(next)));
        self.blocks = pairs.collect();
    }

    /// When the run became steady, by the running means of the blocks.
    pub fn settled(&self) -> Settled {
        let (Some(first), Some(last)) = (self.blocks.first(), &self.last) else { return Settled::TooShort };
        let series = |get: fn(&Block) -> f64| self.blocks.iter().map(get).collect::<Vec<_>>();
        let rate_hz = (self.rows - 1) as f64 / (last.time_s - first.time_s) / self.rows_of_block as f64;
        Settled::of(
            [first.time_s, last.time_s],
            rate_hz,
            &series(|block| block.cage_speed.mean),
            &series(Block::shaft_w),
        )
    }

    /// Summary of the rows; none without any.
    pub fn summary(&self, wear: Option<&WearRow>, warnings: Vec<String>) -> Option<Summary> {
        let last = self.last.as_ref()?;
        let settled = self.settled();
        let from_s = settled.averages_from_s(last.time_s);
        let from = self.blocks.partition_point(|block| block.time_s < from_s).min(self.blocks.len() - 1);
        let half = &self.blocks[from..];
        let moments = |get: fn(&Block) -> Moments| {
            let all = Moments::over(half.iter().map(get));
            (all.mean.is_finite() && all.squares.is_finite()).then_some(all)
        };
        let (x, y) = (moments(|b| b.acceleration[0])?, moments(|b| b.acceleration[1])?);
        let largest = |k: usize| half.iter().fold(f64::NEG_INFINITY, |most: f64, block| most.max(block.largest[k]));
        let orbital = half.iter().map(|block| block.orbital_speed);
        let orbital = orbital.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], [c, d]| [a.min(c), b.max(d)]);
        let cage_speed_mean_rpm = moments(|b| b.cage_speed)?.mean;
        let cages: Vec<CageBlock> = half.iter().filter_map(|block| block.free_cage).collect();
        let step = (last.time_s - half[0].time_s) / (half.len() - 1).max(1) as f64;
        Some(Summary {
            simulated_s: last.time_s,
            averaged_from_s: half[0].time_s,
            settled_at_s: if let Settled::At(time_s) = settled { Some(time_s) } else { None },
            settled,
            samples: self.rows,
            cage_speed_mean_rpm,
            cage_speed_start_rpm: self.cage_speed_start_rpm,
            cage_speed_end_rpm: last.cage_speed_rpm,
            orbital_speed_min_rpm: orbital[0],
            orbital_speed_max_rpm: orbital[1],
            outer_acceleration_x_rms_m_s2: x.rms(),
            outer_acceleration_y_rms_m_s2: y.rms(),
            outer_acceleration_x_peak_m_s2: x.peak(),
            outer_acceleration_y_peak_m_s2: y.peak(),
            load_inner_max_n: largest(0),
            load_outer_max_n: largest(1),
            peak_pressure_inner_max_gpa: largest(2),
            peak_pressure_outer_max_gpa: largest(3),
            pocket_force_max_n: largest(4),
            cage: CageMotion::of(&cages, step, cage_speed_mean_rpm),
            impacts: last.impacts,
            balls_in_contact_min: self.balls_in_contact_min,
            power: powers(half, last),
            wear: wear.map_or_else(Worn::default, Worn::of),
            warnings,
        })
    }
}

impl Summary {
    /// Of the rows of a recording; none without any.
    pub fn of(states: &[StateRow], wear: Option<&WearRow>, log: &[LogRow]) -> Option<Self> {
        let mut gathered = Gathered::default();
        states.iter().for_each(|row| gathered.add(*row));
        gathered.summary(wear, warnings::of_log(log))
    }
}

/// Means over blocks that are not empty, and what stands at their ends.
fn powers(blocks: &[Block], last: &StateRow) -> Powers {
    let rows = blocks.iter().map(|block| block.rows as f64).sum::<f64>();
    let mut mean = PowerSample::default();
    for (k, (term, _)) in PLACES.iter().enumerate() {
        let sum = blocks.iter().map(|block| block.rows as f64 * block.powers[k]).sum::<f64>();
        (term.set)(&mut mean, sum / rows);
    }
    let span = last.time_s - blocks[0].time_s;
    Powers {
        mean,
        stored_w: if span > 0.0 { (last.energy_j - blocks[0].energy_j) / span } else { 0.0 },
        imbalance_percent: last.imbalance_ppb / PPB_PER_PERCENT,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(k: usize) -> StateRow {
        let time_s = 1e-3 * k as f64;
        let ripple = (k as f64 * std::f64::consts::TAU / 10.0).sin();
        StateRow {
            time_s,
            cage_speed_rpm: 3000.0 + ripple,
            shaft_w: 100.0 + ripple,
            outer_acceleration_x_m_s2: ripple * (1.0 + time_s),
            load_inner_max_n: 7.0 * time_s,
            orbital_speed_min_rpm: -time_s,
            energy_j: 3.0 * time_s,
            ..StateRow::default()
        }
    }

    #[test]
    fn identity_blocks_of_rows_come_to_what_the_rows_come_to() {
        let (mut all, mut few) = (Gathered::default(), Gathered::with_most(100));
        for k in 0..1600 {
            all.add(row(k));
            few.add(row(k));
        }
        assert_eq!((all.blocks.len(), few.blocks.len(), few.rows_of_block), (1600, 100, 16));
        let [all, few] = [all, few].map(|gathered| gathered.summary(None, Vec::new()).unwrap());
        assert_eq!((all.averaged_from_s, few.averaged_from_s), (0.8, 0.8));
        assert_eq!((all.samples, all.load_inner_max_n), (few.samples, few.load_inner_max_n));
        assert_eq!(all.settled, Settled::At(0.0));
        assert_eq!(few.settled, Settled::At(0.0));
        let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-12 * a.abs(), "{a} {b}");
        close(all.outer_acceleration_x_rms_m_s2, few.outer_acceleration_x_rms_m_s2);
        close(all.cage_speed_mean_rpm, few.cage_speed_mean_rpm);
        close(all.power.mean.shaft_w, few.power.mean.shaft_w);
        assert_eq!(all.outer_acceleration_x_peak_m_s2, few.outer_acceleration_x_peak_m_s2);
        assert_eq!(all.power.stored_w, few.power.stored_w);
    }
}
