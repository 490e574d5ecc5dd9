//! The table of quantities: the names, units and getters of all numbers of a result stand here once. JSON, sweeps,
//! recordings, interpolation over azimuth, figures, checks, reports and `docs/quantities.md` read it.

mod ball;
mod of_ball;
mod unit;

pub use ball::{BALL, CONTACT};
pub use of_ball::{Fields, OfBall};
pub use unit::*;

/// The models that have a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// All of them.
    All,
    /// Equilibria with traction, and runs.
    Traction,
    /// The same of a bearing with oil or grease.
    Lubricated,
    /// Runs alone.
    Run,
}

/// How a quantity follows the azimuth between solved balls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Course {
    /// Smoothly, with either sign.
    Smooth,
    /// Smoothly and never below 0.
    Positive,
    /// With a dead band: linear between neighbours.
    Threshold,
}

/// One number for all balls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Over {
    /// Sum.
    Sum,
    /// Least value.
    Min,
    /// Greatest value.
    Max,
    /// Greatest magnitude.
    Largest,
}

impl Over {
    /// Part of the name that says so, before the unit.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sum => "",
            Self::Min => "min",
            Self::Max | Self::Largest => "max",
        }
    }

    /// Of some values; absent where one is absent, or where there are none.
    pub fn of(self, values: impl Iterator<Item = Option<f64>>) -> Option<f64> {
        // The choice outside of the loop: a recording counts over the balls of every sample.
        match self {
            Self::Sum => reduce(values, |a, b| a + b),
            Self::Min => reduce(values, f64::min),
            Self::Max => reduce(values, f64::max),
            Self::Largest => reduce(values.map(|value| value.map(f64::abs)), f64::max),
        }
    }
}

/// Of values that are all there.
fn reduce(mut values: impl Iterator<Item = Option<f64>>, of: impl Fn(f64, f64) -> f64) -> Option<f64> {
    let first = values.next()??;
    values.try_fold(first, |so_far, value| Some(of(so_far, value?)))
}

/// All about a quantity but its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facts {
    /// Name without race and unit.
    pub name: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// One line that says what it is.
    pub about: &'static str,
    /// Unit in JSON and sweeps.
    pub unit: Unit,
    /// Unit in recordings and reports.
    pub shown: Unit,
    /// Models that have it.
    pub scope: Scope,
    /// How it follows the azimuth.
    pub course: Course,
    /// The sign says more than which body is faster, or a figure around a circle would not do.
    pub signed: bool,
    /// Numbers for all balls that sweeps and states give.
    pub over_balls: &'static [Over],
    /// Decimals in reports; absent where a report does not have it.
    pub digits: Option<usize>,
}

impl Facts {
    /// True for a number by which a recording, that has one for each quantity, says that a ball has no such quantity:
    /// a film of no thickness is none.
    pub fn is_absence(&self, number: f64) -> bool {
        self.scope == Scope::Lubricated && number == 0.0
    }
}

/// Reads a number from a result; absent where the model does not have it.
pub type Get<T> = fn(&T) -> Option<f64>;
/// Writes a number to a result.
pub type Set<T> = fn(&mut T, f64);

/// A quantity of a result, in SI.
#[derive(Debug)]
pub struct Quantity<T: 'static> {
    /// Names, units and uses.
    pub facts: Facts,
    /// Reads it.
    pub get: Get<T>,
    /// Writes it.
    pub set: Set<T>,
}

impl<T> Quantity<T> {
    /// A smooth quantity that all models have: its name, its name for people, one line about it, the units of results
    /// and of what is shown, and its place.
    pub const fn new(
        [name, label, about]: [&'static str; 3],
        [unit, shown]: [Unit; 2],
        (get, set): (Get<T>, Set<T>),
    ) -> Self {
        let facts = Facts {
            name,
            label,
            about,
            unit,
            shown,
            scope: Scope::All,
            course: Course::Smooth,
            signed: false,
            over_balls: &[],
            digits: None,
        };
        Self { facts, get, set }
    }

    /// In these models only.
    #[must_use]
    pub const fn in_scope(mut self, scope: Scope) -> Self {
        self.facts.scope = scope;
        self
    }

    /// With this course over the azimuth.
    #[must_use]
    pub const fn along(mut self, course: Course) -> Self {
        self.facts.course = course;
        self
    }

    /// Signed.
    #[must_use]
    pub const fn signed(mut self) -> Self {
        self.facts.signed = true;
        self
    }

    /// With these numbers for all balls.
    #[must_use]
    pub const fn over(mut self, over_balls: &'static [Over]) -> Self {
        self.facts.over_balls = over_balls;
        self
    }

    /// In reports with so many decimals.
    #[must_use]
    pub const fn reported(mut self, digits: usize) -> Self {
        self.facts.digits = Some(digits);
        self
    }
}

/// A name from its parts; empty ones are left out.
pub fn joined(parts: &[&str]) -> String {
    parts.iter().filter(|part| !part.is_empty()).copied().collect::<Vec<_>>().join("_")
}

/// Where a number stands in a result: for [`Quantity::new`].
#[macro_export]
macro_rules! place {
    ($group:ident ? $($field:tt)+) => {
        (
            |r| r.$group.as_ref().map(|group| group.$($field)+),
            |r, value| r.$group.get_or_insert_default().$($field)+ = value,
        )
    };
    (. $($field:tt)+) => {
        (|r| Some(r.$($field)+), |r, value| r.$($field)+ = value)
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_one_number_for_all_balls_is_absent_where_one_is() {
        let of = |over: Over, values: [f64; 3]| over.of(values.into_iter().map(Some)).unwrap();
        assert_eq!(
            [Over::Sum, Over::Min, Over::Max, Over::Largest].map(|o| of(o, [1.0, -3.0, 0.5])),
            [-1.5, -3.0, 1.0, 3.0]
        );
        assert_eq!(Over::Largest.of([Some(-2.0)].into_iter()), Some(2.0));
        assert_eq!(Over::Sum.of([Some(1.0), None].into_iter()), None);
        assert_eq!(Over::Sum.of(std::iter::empty()), None);
    }
}
