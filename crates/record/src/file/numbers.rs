//! Numbers of encoded messages: which of them, if any, is none.

use crate::wire::TRIBODYN_DESCRIPTORS;
use prost::Message;
use prost_types::{DescriptorProto, FileDescriptorSet, field_descriptor_proto::Type};
use std::collections::BTreeMap;

/// The kinds of fields that hold numbers or messages, by message and number of the field.
#[derive(Debug, Default)]
pub(crate) struct Numbers {
    messages: BTreeMap<String, BTreeMap<u32, (String, Kind)>>,
}

#[derive(Debug)]
enum Kind {
    Double,
    Float,
    Message(String),
}

impl Numbers {
    /// Of our own messages.
    pub(crate) fn new() -> Self {
        let mut numbers = Self::default();
        // The build has made them from the same files as the messages.
        for file in FileDescriptorSet::decode(TRIBODYN_DESCRIPTORS).unwrap_or_default().file {
            let package = file.package().to_owned();
            file.message_type.iter().for_each(|message| numbers.learn(&package, message));
        }
        numbers
    }

    fn learn(&mut self, scope: &str, message: &DescriptorProto) {
        let name = format!("{scope}.{}", message.name());
        message.nested_type.iter().for_each(|nested| self.learn(&name, nested));
        let kind = |field: &prost_types::FieldDescriptorProto| match field.r#type() {
            Type::Double => Some(Kind::Double),
            Type::Float => Some(Kind::Float),
            Type::Message => Some(Kind::Message(field.type_name().trim_start_matches('.').to_owned())),
            _ => None,
        };
        let fields = message.field.iter().filter_map(|field| {
            let number = u32::try_from(field.number()).ok()?;
            Some((number, (field.name().to_owned(), kind(field)?)))
        });
        self.messages.insert(name, fields.collect());
    }

    /// The first field of a message that is infinite or not a number, with its path, and its value.
    pub(crate) fn not_finite(&self, message: &str, data: &[u8]) -> Option<(String, f64)> {
        let fields = self.messages.get(message)?;
        let mut rest = data;
        while !rest.is_empty() {
            let tag = varint(&mut rest)?;
            let field = u32::try_from(tag >> 3).ok().and_then(|number| fields.get(&number));
            let value: &[u8] = match tag & 7 {
                0 => varint(&mut rest).map(|_| &[][..])?,
                1 => taken(&mut rest, 8)?,
                2 => {
                    let length = usize::try_from(varint(&mut rest)?).ok()?;
                    taken(&mut rest, length)?
                }
                5 => taken(&mut rest, 4)?,
                // No message of ours has groups; the decoder says what is wrong.
                _ => return None,
            };
            let Some((name, kind)) = field else { continue };
            let found = match kind {
                Kind::Double => {
                    first(value.as_chunks().0, |bytes| f64::from_le_bytes(*bytes)).map(|v| (name.clone(), v))
                }
                Kind::Float => {
                    first(value.as_chunks().0, |bytes| f64::from(f32::from_le_bytes(*bytes))).map(|v| (name.clone(), v))
                }
                Kind::Message(of) => {
                    self.not_finite(of, value).map(|(inner, value)| (format!("{name}.{inner}"), value))
                }
            };
            if found.is_some() {
                return found;
            }
        }
        None
    }
}

fn first<const N: usize>(values: &[[u8; N]], number: impl Fn(&[u8; N]) -> f64) -> Option<f64> {
    values.iter().map(number).find(|value| !value.is_finite())
}

fn taken<'a>(rest: &mut &'a [u8], count: usize) -> Option<&'a [u8]> {
    let (value, after) = rest.split_at_checked(count)?;
    *rest = after;
    Some(value)
}

fn varint(rest: &mut &[u8]) -> Option<u64> {
    let mut value = 0;
    for place in 0..10 {
        let (&byte, after) = rest.split_first()?;
        *rest = after;
        value |= u64::from(byte & 0x7f) << (7 * place);
        if byte < 0x80 {
            return Some(value);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::Numbers;
    use crate::wire::tribodyn::{Ball, Balls, TransientState};
    use prost::Message;

    #[test]
    fn limit_a_number_that_is_none_is_found_wherever_it_stands() {
        let numbers = Numbers::new();
        let state = TransientState { time_s: 1.0, inner_displacement_x_um: f64::NAN, ..TransientState::default() };
        let (field, value) = numbers.not_finite("tribodyn.v1.TransientState", &state.encode_to_vec()).unwrap();
        assert!(field == "inner_displacement_x_um" && value.is_nan());
        let ball = Ball { load_inner_n: f32::INFINITY, ..Ball::default() };
        let mut balls = Balls { time_s: 1.0, balls: vec![Ball::default(), ball], ..Balls::default() };
        let found = numbers.not_finite("tribodyn.v1.Balls", &balls.encode_to_vec());
        assert_eq!(found, Some(("balls.load_inner_n".to_owned(), f64::INFINITY)));
        balls.balls.pop();
        assert_eq!(numbers.not_finite("tribodyn.v1.Balls", &balls.encode_to_vec()), None);
        assert_eq!(numbers.not_finite("foxglove.Log", &[0xff; 64]), None);
        assert_eq!(numbers.not_finite("tribodyn.v1.Balls", &[0xff; 64]), None);
    }
}
