//! The numbers of an answer by their paths in its JSON, in the order of its fields.

use crate::sweep::Cell;
use serde::Serialize;
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// All numbers of an answer, with dots between levels, as `power.shaft_w`. What is null is a number that is absent;
/// texts and lists are left out.
pub(crate) fn numbers_of(answer: &impl Serialize) -> Result<Vec<(String, Cell)>, serde_json::Error> {
    let text = serde_json::to_string(answer)?;
    let mut found = Vec::new();
    Numbers { path: String::new(), found: &mut found }.deserialize(&mut serde_json::Deserializer::from_str(&text))?;
    Ok(found)
}

/// A value at a path.
struct Numbers<'a> {
    path: String,
    found: &'a mut Vec<(String, Cell)>,
}

impl Numbers<'_> {
    fn add(self, cell: Cell) {
        self.found.push((self.path, cell));
    }
}

impl<'de> DeserializeSeed<'de> for Numbers<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Numbers<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a value of JSON")
    }

    fn visit_bool<E>(self, _: bool) -> Result<(), E> {
        Ok(())
    }

    fn visit_str<E>(self, _: &str) -> Result<(), E> {
        Ok(())
    }

    fn visit_i64<E>(self, value: i64) -> Result<(), E> {
        self.add(Cell::Integer(value));
        Ok(())
    }

    fn visit_u64<E>(self, value: u64) -> Result<(), E> {
        self.add(i64::try_from(value).map_or(Cell::Number(value as f64), Cell::Integer));
        Ok(())
    }

    fn visit_f64<E>(self, value: f64) -> Result<(), E> {
        self.add(Cell::Number(value));
        Ok(())
    }

    fn visit_unit<E>(self) -> Result<(), E> {
        self.add(Cell::Null);
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        while list.next_element::<IgnoredAny>()?.is_some() {}
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(key) = map.next_key::<String>()? {
            let path = if self.path.is_empty() { key } else { format!("{}.{key}", self.path) };
            map.next_value_seed(Numbers { path, found: &mut *self.found })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Serialize)]
    struct Answer {
        z: f64,
        a: Option<f64>,
        name: &'static str,
        inside: Inside,
        list: Vec<f64>,
    }

    #[derive(Serialize)]
    struct Inside {
        count: u32,
        sum: f64,
        good: bool,
    }

    #[test]
    fn identity_numbers_keep_their_order_kind_and_bits() {
        let inside = Inside { count: 3, sum: 0.1 + 0.2, good: true };
        let found = numbers_of(&Answer { z: 1.0, a: None, name: "x", inside, list: vec![1.0] }).unwrap();
        let expected = [
            ("z", Cell::Number(1.0)),
            ("a", Cell::Null),
            ("inside.count", Cell::Integer(3)),
            ("inside.sum", Cell::Number(0.1 + 0.2)),
        ];
        assert_eq!(found, expected.map(|(name, cell)| (name.to_owned(), cell)));
    }
}
