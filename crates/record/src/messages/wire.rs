//! The messages as they lie in the file, generated from the `.proto` files of this crate.

use prost::Message;

/// Foxglove's public messages, as far as a recording uses them.
pub mod foxglove {
    #![allow(missing_docs, clippy::all)] // generated: helper functions of enums carry no text
    include!(concat!(env!("OUT_DIR"), "/foxglove.rs"));
}

/// Our own messages.
pub mod tribodyn {
    #![allow(missing_docs, clippy::all)] // generated, as above
    include!(concat!(env!("OUT_DIR"), "/tribodyn.v1.rs"));
}

/// A message whose single numbers can be reached by name.
pub trait Numbers {
    /// Names of the numbers, in the order of their places.
    const NAMES: &'static [&'static str];

    /// The number at a place; NaN beyond the last one.
    fn number(&self, place: usize) -> f64;

    /// Writes the number at a place, in the precision of its field; nothing beyond the last one.
    fn set_number(&mut self, place: usize, value: f64);

    /// Writes the numbers that `value` has for their places, in the precision of their fields.
    fn set_numbers(&mut self, value: impl Fn(usize) -> Option<f64>);

    /// True if no number is infinite or not a number at all.
    fn are_finite(&self) -> bool;

    /// The place of a name.
    fn place(name: &str) -> Option<usize> {
        Self::NAMES.iter().position(|known| *known == name)
    }
}

/// A message that is encoded field by field with keys that are known, the bytes of [`prost::Message::encode_raw`]:
/// of balls there are so many that it shows.
pub(crate) trait Flat {
    /// Appends the message.
    fn put(&self, out: &mut Vec<u8>);
}

impl Flat for tribodyn::Balls {
    fn put(&self, out: &mut Vec<u8>) {
        let Self { timestamp, time_s, balls } = self;
        tribodyn::Balls { timestamp: *timestamp, time_s: *time_s, balls: Vec::new() }.encode_raw(out);
        let mut message = Vec::with_capacity(LONGEST_BALL);
        for ball in balls {
            message.clear();
            ball.put(&mut message);
            put_varint(out, &[BALLS_KEY], message.len() as u64);
            out.extend_from_slice(&message);
        }
    }
}

/// Key of the balls among the fields of [`tribodyn::Balls`]: field 3, with a length.
const BALLS_KEY: u8 = 3 << 3 | 2;
/// Room for a ball, which has some 350 bytes.
const LONGEST_BALL: usize = 512;

/// A number with its key.
#[inline(always)]
fn put<const K: usize, const N: usize>(out: &mut Vec<u8>, key: &[u8; K], value: &[u8; N]) {
    let mut both = [0; 16];
    both[..K].copy_from_slice(key);
    both[K..K + N].copy_from_slice(value);
    out.extend_from_slice(&both[..K + N]);
}

/// A whole number with its key.
fn put_varint(out: &mut Vec<u8>, key: &[u8], value: u64) {
    out.extend_from_slice(key);
    prost::encoding::encode_varint(value, out);
}

mod numbers {
    #![allow(clippy::all)] // generated from the `.proto` file
    include!(concat!(env!("OUT_DIR"), "/tribodyn_numbers.rs"));
}

/// Descriptor set of [`foxglove`] with its imports, as the schema record holds it.
pub(crate) const FOXGLOVE_DESCRIPTORS: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/foxglove.binpb"));

/// Descriptor set of [`tribodyn`] with its imports, as the schema record holds it.
pub(crate) const TRIBODYN_DESCRIPTORS: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/tribodyn.binpb"));

#[cfg(test)]
mod tests {
    use super::Flat;
    use super::tribodyn::{Ball, Balls};
    use crate::wire::Numbers;
    use prost::Message;

    #[test]
    fn identity_balls_have_the_bytes_of_their_generated_encoding() {
        let ball = |k: usize| {
            let mut ball =
                Ball { index: k as u32, contact_outer: k.is_multiple_of(2), motion: k as i32 % 6, ..Ball::default() };
            ball.set_numbers(|place| (place % 5 != k % 5).then_some((place as f64 - 20.0) * 1.7 + k as f64));
            ball
        };
        let timestamp = Some(prost_types::Timestamp { seconds: 1_700_000_000, nanos: 12_345 });
        for (timestamp, time_s, count) in [(None, 0.0, 0), (timestamp, 0.125, 1), (timestamp, -3.0, 300)] {
            let balls = Balls { timestamp, time_s, balls: (0..count).map(ball).collect() };
            let mut bytes = Vec::new();
            balls.put(&mut bytes);
            assert!(bytes == balls.encode_to_vec(), "{count}");
        }
    }
}
