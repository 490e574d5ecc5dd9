//! Loads and speeds at a time: constant, or a table that is linear between its rows and constant beyond them.

use super::{SpeedHistory, Tilt, Translation};

impl Translation {
    /// External force in N at `time` in s, or the held displacement in m.
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Self::Force(value) | Self::Held(value) => *value,
            Self::ForceTable(rows) => interpolate(rows, time),
        }
    }

    /// What [`Self::at`] comes to in the end: the steady state after a table has run through.
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

    /// What [`Self::at`] comes to in the end.
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

    /// What [`Self::at`] comes to in the end.
    pub fn last(&self) -> f64 {
        self.at(f64::INFINITY)
    }
}

/// Linear between rows of rising time, constant beyond. An empty table, which no validated case has, is NaN.
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
