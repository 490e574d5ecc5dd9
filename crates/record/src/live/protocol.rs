//! The words of the protocol: what a server says, what a client asks for, and the WebSocket frames around both.
//!
//! | message | form |
//! |---|---|
//! | `serverInfo`, `advertise`, `status` | text, JSON |
//! | message of a channel | binary: 0x01, subscription (u32), log time in ns (u64), data; little-endian |
//! | time | binary: 0x02, time in ns (u64) |
//!
//! Sources: Foxglove WebSocket protocol v1 (github.com/foxglove/ws-protocol, docs/spec.md); subprotocol names and the
//! base64 of binary schemas as in the Foxglove SDK 0.30.3; frames: RFC 6455, section 5.2.

use crate::output::Channel;
use crate::run::Preamble;
use data_encoding::BASE64;
use serde_json::{Value, json};
use std::io::{self, Write};
use std::sync::Arc;

/// Subprotocols that are spoken, the preferred one first. They differ in nothing that is used here;
/// `foxglove.sdk.v1.1` has its schemas elsewhere and is left to clients that offer one of these too.
pub(super) const SUBPROTOCOLS: [&str; 2] = ["foxglove.sdk.v1", "foxglove.websocket.v1"];

const TEXT: u8 = 0x1;
const BINARY: u8 = 0x2;
const CLOSE: u8 = 0x8;
const PING: u8 = 0x9;
/// "Normal closure", RFC 6455, section 7.4.1.
const NORMAL: u16 = 1000;
const MESSAGE_DATA: u8 = 0x01;
const TIME: u8 = 0x02;
/// Longest head: frame header (10), opcode (1), subscription (4), time (8).
const HEAD: usize = 23;

/// A WebSocket frame: a head of its own, and bytes that the frames of several clients may share.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    head: [u8; HEAD],
    head_length: usize,
    body: Option<Arc<[u8]>>,
}

impl Frame {
    /// A whole message, unmasked as a server has to send it, that begins with `prefix` (13 bytes at most).
    fn new(kind: u8, prefix: &[&[u8]], body: Option<Arc<[u8]>>) -> Self {
        let mut frame = Self { head: [0; HEAD], head_length: 0, body };
        let length = prefix.iter().map(|part| part.len()).sum::<usize>() + frame.body.as_ref().map_or(0, |b| b.len());
        // The last fragment of its message, which is the first one too.
        frame.put(&[0x80 | kind]);
        match (u8::try_from(length), u16::try_from(length)) {
            (Ok(short @ ..126), _) => frame.put(&[short]),
            (_, Ok(medium)) => {
                frame.put(&[126]);
                frame.put(&medium.to_be_bytes());
            }
            _ => {
                frame.put(&[127]);
                frame.put(&(length as u64).to_be_bytes());
            }
        }
        prefix.iter().for_each(|part| frame.put(part));
        frame
    }

    fn put(&mut self, bytes: &[u8]) {
        let end = self.head_length + bytes.len();
        self.head[self.head_length..end].copy_from_slice(bytes);
        self.head_length = end;
    }

    /// Bytes that are frames already.
    pub(super) fn raw(bytes: &[u8]) -> Self {
        Self { head: [0; HEAD], head_length: 0, body: Some(bytes.into()) }
    }

    /// A message of a channel under a client's name for its subscription.
    pub(super) fn message(subscription: u32, log_time: u64, data: Arc<[u8]>) -> Self {
        let (id, time) = (subscription.to_le_bytes(), log_time.to_le_bytes());
        Self::new(BINARY, &[&[MESSAGE_DATA], &id, &time], Some(data))
    }

    pub(super) fn time(log_time: u64) -> Self {
        Self::new(BINARY, &[&[TIME], &log_time.to_le_bytes()], None)
    }

    pub(super) fn ping() -> Self {
        Self::new(PING, &[], None)
    }

    pub(super) fn close() -> Self {
        Self::new(CLOSE, &[&NORMAL.to_be_bytes()], None)
    }

    fn text(value: &Value) -> Self {
        Self::new(TEXT, &[], Some(value.to_string().into_bytes().into()))
    }

    /// Who serves what run.
    pub(super) fn server_info(preamble: &Preamble, session: &str) -> Self {
        let metadata: serde_json::Map<String, Value> =
            preamble.entries.iter().map(|(key, value)| ((*key).to_owned(), json!(value))).collect();
        Self::text(&json!({
            "op": "serverInfo",
            "name": preamble.generator,
            "capabilities": ["time"],
            "supportedEncodings": [],
            "metadata": metadata,
            "sessionId": session,
        }))
    }

    /// The channels; their numbers are their places.
    pub(super) fn advertise(channels: &[Channel]) -> Self {
        let channel = |(id, channel): (usize, &Channel)| {
            json!({
                "id": id,
                "topic": channel.topic,
                "encoding": "protobuf",
                "schemaName": channel.schema,
                "schema": BASE64.encode(channel.descriptors),
                "schemaEncoding": "protobuf",
            })
        };
        let channels: Vec<Value> = channels.iter().enumerate().map(channel).collect();
        Self::text(&json!({ "op": "advertise", "channels": channels }))
    }

    /// A line for the people at the client.
    pub(super) fn status(level: Level, message: &str) -> Self {
        Self::text(&json!({ "op": "status", "level": level as u8, "message": message }))
    }

    /// True if it is a time, among times and messages: messages have data.
    pub(super) fn is_time(&self) -> bool {
        self.body.is_none()
    }

    /// Bytes of the frame.
    pub(super) fn len(&self) -> usize {
        self.head_length + self.body.as_ref().map_or(0, |body| body.len())
    }

    pub(super) fn write(&self, to: &mut impl Write) -> io::Result<()> {
        to.write_all(&self.head[..self.head_length])?;
        self.body.as_ref().map_or(Ok(()), |body| to.write_all(body))
    }
}

/// How bad a status is, as the protocol counts.
#[derive(Debug, Clone, Copy)]
pub(super) enum Level {
    Warning = 1,
    Error = 2,
}

/// A request of a client.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Request {
    /// Its names for its subscriptions, and their channels.
    Subscribe(Vec<(u32, usize)>),
    /// The names of subscriptions to end.
    Unsubscribe(Vec<u32>),
    /// Something that only servers with other capabilities understand.
    Other(String),
}

/// Reads a text message; none where it is not of the protocol.
pub(super) fn request(text: &str) -> Option<Request> {
    let value: Value = serde_json::from_str(text).ok()?;
    let id = |value: &Value| u32::try_from(value.as_u64()?).ok();
    match value["op"].as_str()? {
        "subscribe" => {
            let one = |s: &Value| Some((id(&s["id"])?, usize::try_from(s["channelId"].as_u64()?).ok()?));
            value["subscriptions"].as_array()?.iter().map(one).collect::<Option<_>>().map(Request::Subscribe)
        }
        "unsubscribe" => {
            value["subscriptionIds"].as_array()?.iter().map(id).collect::<Option<_>>().map(Request::Unsubscribe)
        }
        other => Some(Request::Other(other.to_owned())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bytes(frame: &Frame) -> Vec<u8> {
        let mut bytes = Vec::new();
        frame.write(&mut bytes).unwrap();
        assert_eq!(bytes.len(), frame.len());
        bytes
    }

    /// The payloads of the snapshots `v1/server/message_data` and `v1/server/time` in the SDK 0.30.3.
    #[test]
    fn code_foxglove_sdk_binary_messages() {
        let data = br#"{"key": "value"}"#;
        let message = bytes(&Frame::message(30, 1234, data.as_slice().into()));
        assert_eq!(message[..2], [0x82, 29]);
        assert_eq!(message[2..15], [0x01, 0x1e, 0, 0, 0, 0xd2, 0x04, 0, 0, 0, 0, 0, 0]);
        assert_eq!(&message[15..], data);
        let time = bytes(&Frame::time(1_234_567_890));
        assert_eq!(time, [0x82, 9, 0x02, 0xd2, 0x02, 0x96, 0x49, 0, 0, 0, 0]);
    }

    #[test]
    fn limit_lengths_of_frames_at_the_borders_of_their_forms() {
        for (length, head) in [
            (125, vec![0x82, 125]),
            (126, vec![0x82, 126, 0, 126]),
            (65_535, vec![0x82, 126, 255, 255]),
            (65_536, vec![0x82, 127, 0, 0, 0, 0, 0, 1, 0, 0]),
        ] {
            let frame = bytes(&Frame::message(1, 2, vec![7; length - 13].into()));
            assert_eq!(frame[..head.len()], head);
            assert_eq!(frame.len(), head.len() + length);
        }
        assert_eq!(bytes(&Frame::close()), [0x88, 2, 0x03, 0xe8]);
    }

    #[test]
    fn limit_requests_that_are_none() {
        let subscribe = r#"{"op":"subscribe","subscriptions":[{"id":0,"channelId":3},{"id":7,"channelId":5}]}"#;
        assert_eq!(request(subscribe), Some(Request::Subscribe(vec![(0, 3), (7, 5)])));
        let unsubscribe = r#"{"op":"unsubscribe","subscriptionIds":[7]}"#;
        assert_eq!(request(unsubscribe), Some(Request::Unsubscribe(vec![7])));
        assert_eq!(request(r#"{"op":"getParameters"}"#), Some(Request::Other("getParameters".to_owned())));
        for not in [
            "",
            "[]",
            r#"{"op":1}"#,
            r#"{"op":"subscribe"}"#,
            r#"{"op":"subscribe","subscriptions":[{"id":-1,"channelId":3}]}"#,
            r#"{"op":"unsubscribe","subscriptionIds":[4294967296]}"#,
        ] {
            assert_eq!(request(not), None, "{not}");
        }
    }
}
