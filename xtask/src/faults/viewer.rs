//! A viewer of a live run by hand: what it sends are the bytes of the WebSocket protocol (RFC 6455), right or wrong.

use std::io::{self, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::time::{Duration, Instant};

/// Most waiting for an answer.
const PATIENCE: Duration = Duration::from_secs(10);

/// A connection to a live server.
pub struct Viewer(pub TcpStream);

impl Viewer {
    pub fn connect(address: SocketAddr) -> io::Result<Self> {
        let stream = TcpStream::connect_timeout(&address, PATIENCE)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_write_timeout(Some(PATIENCE))?;
        Ok(Self(stream))
    }

    /// The handshake of a viewer, with headers of its own; the status that is answered.
    pub fn shake_hands(&mut self, host: &str, headers: &str) -> io::Result<u16> {
        let request = format!(
            "GET / HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n\
             Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: foxglove.sdk.v1\r\n{headers}\r\n"
        );
        self.0.write_all(request.as_bytes())?;
        let (mut head, mut byte) = (Vec::new(), [0]);
        while !head.ends_with(b"\r\n\r\n") {
            self.0.read_exact(&mut byte)?;
            head.push(byte[0]);
        }
        let status = String::from_utf8_lossy(&head).split(' ').nth(1).and_then(|status| status.parse().ok());
        status.ok_or_else(|| io::ErrorKind::InvalidData.into())
    }

    /// Sends a text as one masked frame; the mask is zero, which the protocol allows.
    pub fn send(&mut self, text: &str) -> io::Result<()> {
        self.0.write_all(&frame(0x81, text.as_bytes()))
    }

    /// True if something comes within a time: a server that serves sends its greeting at once.
    pub fn hears(&mut self) -> bool {
        let mut bytes = [0; 64];
        self.0.read(&mut bytes).is_ok_and(|count| count > 0)
    }

    /// Reads and forgets until the server ends the connection or the time is over; the bytes that came.
    pub fn drain(&mut self, patience: Duration) -> usize {
        let (end, mut bytes, mut sum) = (Instant::now() + patience, vec![0; 1 << 16], 0);
        // A time that is 0 would mean none.
        let _ = self.0.set_read_timeout(Some(Duration::from_millis(200)));
        while Instant::now() < end {
            match self.0.read(&mut bytes) {
                Ok(0) => break,
                Ok(count) => sum += count,
                Err(error) if matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut) => {}
                Err(_) => break,
            }
        }
        sum
    }

    /// Ends the connection without a word.
    pub fn vanish(self) {
        // The other side may have been faster.
        let _ = self.0.shutdown(Shutdown::Both);
    }
}

/// A frame as a client has to send it, up to 65 535 bytes, masked with zeros.
pub fn frame(first: u8, payload: &[u8]) -> Vec<u8> {
    let mut bytes = vec![first];
    match u8::try_from(payload.len()) {
        Ok(short @ ..126) => bytes.push(0x80 | short),
        _ => {
            bytes.push(0x80 | 126);
            bytes.extend((payload.len().min(65_535) as u16).to_be_bytes());
        }
    }
    bytes.extend([0; 4]);
    bytes.extend(&payload[..payload.len().min(65_535)]);
    bytes
}

/// Asks for all channels of a run.
pub fn subscribe_all() -> String {
    let one = |id: usize| format!("{{\"id\":{id},\"channelId\":{id}}}");
    let list: Vec<String> = (0..20).map(one).collect();
    // One request for each: a channel that is not there is refused by itself.
    format!("{{\"op\":\"subscribe\",\"subscriptions\":[{}]}}", list.join(","))
}

#[cfg(test)]
mod tests {
    use super::frame;

    #[test]
    fn limit_frames_have_the_lengths_of_their_forms() {
        assert_eq!(frame(0x81, b"ab"), [0x81, 0x82, 0, 0, 0, 0, b'a', b'b']);
        let long = frame(0x82, &[7; 300]);
        assert_eq!((&long[..4], long.len()), (&[0x82, 0xfe, 1, 44][..], 308));
    }
}
