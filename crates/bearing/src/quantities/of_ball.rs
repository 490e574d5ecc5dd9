//! Quantities read from a ball: its own and those of its two contacts.

use super::{BALL, CONTACT, Facts, Over, Quantity, Scope, Unit, joined};
use crate::races::Side;
use crate::result::{BallResult, ContactResult};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// A quantity of a ball, or of one of its contacts, read from the ball.
#[derive(Debug, Clone, Copy)]
pub enum OfBall {
    /// Of the ball.
    Ball(&'static Quantity<BallResult>),
    /// Of a contact.
    Contact(Side, &'static Quantity<ContactResult>),
}

impl OfBall {
    /// All of them, those of the contacts by quantity, inner before outer.
    pub fn all() -> impl Iterator<Item = Self> {
        let contacts = CONTACT.iter().flat_map(|q| Side::BOTH.map(|side| Self::Contact(side, q)));
        BALL.iter().map(Self::Ball).chain(contacts)
    }

    /// The quantity of a ball by its name without unit.
    pub fn ball(name: &str) -> Option<Self> {
        BALL.iter().find(|q| q.facts.name == name).map(Self::Ball)
    }

    /// The quantity of a contact by its name without race and unit.
    pub fn contact(side: Side, name: &str) -> Option<Self> {
        CONTACT.iter().find(|q| q.facts.name == name).map(|q| Self::Contact(side, q))
    }

    /// Names, units and uses.
    pub fn facts(&self) -> &'static Facts {
        match self {
            Self::Ball(q) => &q.facts,
            Self::Contact(_, q) => &q.facts,
        }
    }

    /// The race; none for a quantity of the ball.
    pub fn side(&self) -> Option<Side> {
        if let Self::Contact(side, _) = self { Some(*side) } else { None }
    }

    /// Name without unit.
    pub fn name(&self) -> String {
        joined(&[self.facts().name, self.side().map_or("", Side::name)])
    }

    /// Name with its unit.
    pub fn name_in(&self, unit: Unit) -> String {
        joined(&[&self.name(), unit.suffix])
    }

    /// The value, SI; absent where the model does not have it.
    pub fn get(&self, ball: &BallResult) -> Option<f64> {
        match self {
            Self::Ball(q) => (q.get)(ball),
            Self::Contact(side, q) => (q.get)(&ball.contacts[*side]),
        }
    }

    /// Writes the value, SI.
    pub fn set(&self, ball: &mut BallResult, value: f64) {
        match self {
            Self::Ball(q) => (q.set)(ball, value),
            Self::Contact(side, q) => (q.set)(&mut ball.contacts[*side], value),
        }
    }

    /// One number for all balls, SI.
    pub fn over(&self, over: Over, balls: &[BallResult]) -> Option<f64> {
        match self {
            Self::Ball(q) => over.of(balls.iter().map(q.get)),
            Self::Contact(side, q) => {
                let values = balls.iter().map(|ball| (q.get)(&ball.contacts[*side]));
                // A ball that has left a race has no film there; the others have.
                if q.facts.scope == Scope::Lubricated {
                    over.of(values.filter(Option::is_some))
                } else {
                    over.of(values)
                }
            }
        }
    }

    /// All numbers that the table has for all balls: the quantity and how it is counted.
    pub fn over_balls() -> impl Iterator<Item = (Self, Over)> {
        Self::all().flat_map(|q| q.facts().over_balls.iter().map(move |over| (q, *over)))
    }

    /// Name of a number for all balls.
    pub fn over_name(&self, over: Over, unit: Unit) -> String {
        joined(&[&self.name(), over.name(), unit.suffix])
    }
}

/// A ball as flat fields: every number that its model has, by name and in the unit of results.
#[derive(Debug, Clone, Copy)]
pub struct Fields<'a>(pub &'a BallResult);

impl Serialize for Fields<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for q in OfBall::all() {
            if let Some(value) = q.get(self.0) {
                let unit = q.facts().unit;
                map.serialize_entry(&q.name_in(unit), &(value * unit.per_si))?;
            }
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// A row that reads another field than it writes, or two rows of one field, would be found here.
    #[test]
    fn identity_every_row_reads_what_it_writes_and_nothing_else() {
        let mut ball = BallResult::default();
        for (k, q) in OfBall::all().enumerate() {
            q.set(&mut ball, k as f64 + 1.0);
        }
        for (k, q) in OfBall::all().enumerate() {
            assert_eq!(q.get(&ball), Some(k as f64 + 1.0), "{}", q.name());
        }
    }

    #[test]
    fn identity_names_are_unique_in_either_unit() {
        for of in [|f: &Facts| f.unit, |f: &Facts| f.shown] {
            let names: Vec<String> = OfBall::all().map(|q| q.name_in(of(q.facts()))).collect();
            assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len(), "{names:?}");
        }
    }

    #[test]
    fn limit_a_model_without_traction_has_no_such_numbers() {
        let ball = BallResult::default();
        for q in OfBall::all() {
            // A bearing may have no cage.
            let held =
                q.facts().scope == Scope::All && !["pocket", "wear_rate_cage"].iter().any(|n| q.name().starts_with(n));
            assert_eq!(q.get(&ball).is_some(), held, "{}", q.name());
        }
    }
}
