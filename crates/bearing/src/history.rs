//! Loads and speeds over time: constant, or a table that is linear between its rows and constant beyond them.

use crate::operation::RingFreedom;

/// The five degrees of freedom of the inner ring against the outer: axes X and Y radial, Z axial.
#[derive(Debug, Clone, PartialEq)]
pub struct RingLoads {
    /// Radial, the direction of azimuth 0: a force, or a held displacement.
    pub x: Translation,
    /// Radial, at azimuth 90°.
    pub y: Translation,
    /// Axial.
    pub z: Translation,
    /// Tilt about X: a moment, or a held angle.
    pub tilt_x: Tilt,
    /// Tilt about Y.
    pub tilt_y: Tilt,
}

impl RingLoads {
    /// A ring under constant forces along x, y and z, N, its tilts held at 0.
    pub fn forces([x, y, z]: [f64; 3]) -> Self {
        let [x, y, z] = [x, y, z].map(Translation::Force);
        Self { x, y, z, tilt_x: Tilt::Held(0.0), tilt_y: Tilt::Held(0.0) }
    }

    /// Load on each degree of freedom at `time` in s, or the position at which it is held.
    pub fn at(&self, time: f64) -> [RingFreedom; 5] {
        let translation = |t: &Translation| match t {
            Translation::Held(x) => RingFreedom::Held(*x),
            loaded => RingFreedom::Loaded(loaded.at(time)),
        };
        let tilt = |t: &Tilt| match t {
            Tilt::Held(angle) => RingFreedom::Held(*angle),
            loaded => RingFreedom::Loaded(loaded.at(time)),
        };
        [translation(&self.x), translation(&self.y), translation(&self.z), tilt(&self.tilt_x), tilt(&self.tilt_y)]
    }
}

/// A translation of the ring: loaded or held.
#[derive(Debug, Clone, PartialEq)]
pub enum Translation {
    /// External force on the inner ring, N.
    Force(f64),
    /// External force in time: rows (s, N), linear between them and constant beyond.
    ForceTable(Vec<(f64, f64)>),
    /// Held displacement, m.
    Held(f64),
}

/// A tilt of the ring: loaded or held.
#[derive(Debug, Clone, PartialEq)]
pub enum Tilt {
    /// External moment on the inner ring, N m.
    Moment(f64),
    /// External moment in time: rows (s, N m), linear between them and constant beyond.
    MomentTable(Vec<(f64, f64)>),
    /// Held angle, rad.
    Held(f64),
}

/// A rotational speed, constant or in time.
#[derive(Debug, Clone, PartialEq)]
pub enum SpeedHistory {
    /// The same at all times, rad/s.
    Constant(f64),
    /// Rows (s, rad/s), linear between them and constant beyond.
    Table(Vec<(f64, f64)>),
}

impl Translation {
    /// External force in N at `time` in s, or the held displacement in m.
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Self::Force(value) | Self::Held(value) => *value,
            Self::ForceTable(rows) => interpolate(rows, time),
        }
    }

    /// Final value of [`Self::at`]: the steady state after a table has run through.
    pub fn last(&self) -> f64 {
        self.at(f64::INFINITY)
    }
}

impl Tilt {
    /// External moment in N m at `time` in s, or the held angle in rad.
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Self::Moment(value) | Self::Held(value) => *value,
            Self::MomentTable(rows) => interpolate(rows, time),
        }
    }

    /// Final value of [`Self::at`].
    pub fn last(&self) -> f64 {
        self.at(f64::INFINITY)
    }
}

impl SpeedHistory {
    /// Rotational speed in rad/s at `time` in s.
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Table(rows) => interpolate(rows, time),
        }
    }

    /// Final value of [`Self::at`].
    pub fn last(&self) -> f64 {
        self.at(f64::INFINITY)
    }
}

/// Linear between rows of rising time, constant beyond. An empty table is NaN.
fn interpolate(rows: &[(f64, f64)], time: f64) -> f64 {
    let next = rows.partition_point(|row| row.0 <= time);
    match (next.checked_sub(1).map(|previous| rows[previous]), rows.get(next)) {
        (None, None) => f64::NAN,
        (None, Some(first)) => first.1,
        (Some(last), None) => last.1,
        (Some((t0, v0)), Some(&(t1, v1))) => v0 + (v1 - v0) * ((time - t0) / (t1 - t0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_table_is_linear_between_rows_and_constant_beyond() {
        let load = Translation::ForceTable(vec![(1.0, 10.0), (3.0, 30.0), (4.0, -30.0)]);
        for (time, expected) in
            [(-5.0, 10.0), (1.0, 10.0), (2.5, 25.0), (3.0, 30.0), (3.5, 0.0), (4.0, -30.0), (9.0, -30.0)]
        {
            assert_eq!(load.at(time), expected, "at {time} s");
        }
        assert_eq!(load.last(), -30.0);
    }

    #[test]
    fn limit_constants_do_not_depend_on_time() {
        assert_eq!(SpeedHistory::Constant(5.0).at(1e3), SpeedHistory::Constant(5.0).last());
        assert_eq!(Tilt::MomentTable(vec![(0.0, 2.0)]).at(-1.0), 2.0);
        assert_eq!((Tilt::Held(0.1).last(), Translation::Held(1e-5).at(0.0)), (0.1, 1e-5));
    }
}
