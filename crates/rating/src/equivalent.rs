//! The dynamic equivalent load P = X F_r + Y F_a of ISO 281 and the basic rating life.

use crate::dynamic_rating::MM_PER_M;
use crate::{RatedBearing, RatingError, load};

/// Factors of ISO 281, table 3, for one bearing under one axial load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadFactors {
    /// Ratio F_a/F_r up to which the axial load does no harm.
    pub limit: f64,
    /// X beyond it.
    pub radial: f64,
    /// Y beyond it.
    pub axial: f64,
}

/// Basic rating life L_10 = (C_r/P)³ in 10⁶ revolutions; absent for a bearing without load.
pub fn basic_life_mrev(dynamic_rating: f64, equivalent_load: f64) -> Option<f64> {
    let life = (dynamic_rating / equivalent_load).powi(3);
    (equivalent_load > 0.0 && life.is_finite()).then_some(life)
}

impl RatedBearing {
    /// e, X and Y at an axial load (N), linear between the entries of the table; its ends hold beyond them.
    ///
    /// # Errors
    /// [`RatingError`] for a load below 0 and for dimensions that are not those of a radial ball bearing.
    pub fn load_factors(&self, axial: f64) -> Result<LoadFactors, RatingError> {
        let relative = self.relative_axial_load(axial)?;
        let angle = self.contact_angle.to_degrees();
        let at = |value: fn(&Factors, f64) -> f64| between(&FACTORS, angle, |row| row.0, |row| value(&row.1, relative));
        Ok(LoadFactors {
            limit: at(|factors, relative| factors.column(relative, 0)),
            radial: at(|factors, _| factors.radial),
            axial: at(|factors, relative| factors.column(relative, 1)),
        })
    }

    /// The relative axial load F_a/(Z D²), N/mm², where it is beyond the last row of the table, and that row's: e and Y
    /// of [`Self::load_factors`] are the row's then. Absent from 20° on, where they do not depend on it.
    ///
    /// # Errors
    /// As [`Self::load_factors`].
    pub fn beyond_table(&self, axial: f64) -> Result<Option<[f64; 2]>, RatingError> {
        let relative = self.relative_axial_load(axial)?;
        let last = RELATIVE_LOADS[RELATIVE_LOADS.len() - 1];
        let depends = self.contact_angle.to_degrees() < SINGLE_ROW_DEG;
        Ok((depends && relative > last).then_some([relative, last]))
    }

    /// F_a/(Z D²) of a bearing that the standard rates, N/mm².
    fn relative_axial_load(&self, axial: f64) -> Result<f64, RatingError> {
        self.check()?;
        let diameter = self.ball_diameter * MM_PER_M;
        Ok(load("axial load", axial)? / (self.ball_count as f64 * diameter * diameter))
    }

    /// Dynamic equivalent load P of a radial and an axial load, N.
    ///
    /// # Errors
    /// As [`Self::load_factors`].
    pub fn equivalent_load(&self, radial: f64, axial: f64) -> Result<f64, RatingError> {
        let radial = load("radial load", radial)?;
        let factors = self.load_factors(axial)?;
        if axial <= factors.limit * radial { Ok(radial) } else { Ok(factors.radial * radial + factors.axial * axial) }
    }
}

/// Factors at one contact angle.
struct Factors {
    /// X.
    radial: f64,
    /// e and Y over the relative axial load, one entry where they do not depend on it.
    rows: &'static [[f64; 2]],
}

impl Factors {
    /// e (0) or Y (1) at a relative axial load F_a/(Z D²), N/mm².
    fn column(&self, relative: f64, column: usize) -> f64 {
        match self.rows {
            [single] => single[column],
            rows => {
                let entries: Vec<(f64, f64)> =
                    RELATIVE_LOADS.iter().zip(rows).map(|(load, row)| (*load, row[column])).collect();
                between(&entries, relative, |entry| entry.0, |entry| entry.1)
            }
        }
    }
}

/// Relative axial loads F_a/(Z D²) of the table's rows, N/mm².
const RELATIVE_LOADS: [f64; 9] = [0.172, 0.345, 0.689, 1.03, 1.38, 2.07, 3.45, 5.17, 6.89];
/// Nominal contact angle from which the table has a single row, degrees; less what is lost on the way through radians.
const SINGLE_ROW_DEG: f64 = 20.0 - 1e-9;

const DEEP_GROOVE: Factors = Factors {
    radial: 0.56,
    rows: &[
        [0.19, 2.30],
        [0.22, 1.99],
        [0.26, 1.71],
        [0.28, 1.55],
        [0.30, 1.45],
        [0.34, 1.31],
        [0.38, 1.15],
        [0.42, 1.04],
        [0.44, 1.00],
    ],
};

/// ISO 281:2007, table 3, single row, over the nominal contact angle in degrees. Of a single row with 5° it says to
/// take the values of radial contact.
const FACTORS: [(f64, Factors); 10] = [
    (0.0, DEEP_GROOVE),
    (5.0, DEEP_GROOVE),
    (
        10.0,
        Factors {
            radial: 0.46,
            rows: &[
                [0.29, 1.88],
                [0.32, 1.71],
                [0.36, 1.52],
                [0.38, 1.41],
                [0.40, 1.34],
                [0.44, 1.23],
                [0.49, 1.10],
                [0.54, 1.01],
                [0.54, 1.00],
            ],
        },
    ),
    (
        15.0,
        Factors {
            radial: 0.44,
            rows: &[
                [0.38, 1.47],
                [0.40, 1.40],
                [0.43, 1.30],
                [0.46, 1.23],
                [0.47, 1.19],
                [0.50, 1.12],
                [0.55, 1.02],
                [0.56, 1.00],
                [0.56, 1.00],
            ],
        },
    ),
    (20.0, Factors { radial: 0.43, rows: &[[0.57, 1.00]] }),
    (25.0, Factors { radial: 0.41, rows: &[[0.68, 0.87]] }),
    (30.0, Factors { radial: 0.39, rows: &[[0.80, 0.76]] }),
    (35.0, Factors { radial: 0.37, rows: &[[0.95, 0.66]] }),
    (40.0, Factors { radial: 0.35, rows: &[[1.14, 0.57]] }),
    (45.0, Factors { radial: 0.33, rows: &[[1.34, 0.50]] }),
];

/// A table's value at `x`, linear between its rows, the end rows beyond them.
pub(crate) fn between<T>(rows: &[T], x: f64, key: impl Fn(&T) -> f64, value: impl Fn(&T) -> f64) -> f64 {
    let above = rows.partition_point(|row| key(row) < x);
    if above == 0 || above == rows.len() {
        return value(&rows[above.min(rows.len() - 1)]);
    }
    let (low, high) = (&rows[above - 1], &rows[above]);
    let share = (x - key(low)) / (key(high) - key(low));
    value(low) + share * (value(high) - value(low))
}
