//! The handshake: who is let in, and in which time.

use super::Shared;
use super::client::{Client, SILENT, STALLED};
use super::protocol::{Frame, SUBPROTOCOLS};
use std::io::{self, Read, Write};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tungstenite::WebSocket;
use tungstenite::handshake::server::{ErrorResponse, Request as Handshake, Response};
use tungstenite::http::{HeaderValue, StatusCode, header::SEC_WEBSOCKET_PROTOCOL};
use tungstenite::protocol::WebSocketConfig;

/// Longest request.
const MOST_REQUEST: usize = 64 << 10;
/// Longest handshake, however its bytes come.
const LONGEST: Duration = Duration::from_secs(5);

/// The reading half of a connection. What the WebSocket layer wants to answer takes its turn in the queue, so that it
/// does not get between the bytes of a message.
pub(super) struct Half {
    client: Arc<Client>,
    queued: bool,
    /// When the handshake has to be over.
    deadline: Option<Instant>,
}

impl Read for Half {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if let Some(deadline) = self.deadline {
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Err(io::ErrorKind::TimedOut.into());
            }
            self.client.stream.set_read_timeout(Some(left))?;
        }
        (&self.client.stream).read(buffer)
    }
}

impl Write for Half {
    fn write(&mut self, data: &[u8]) -> io::Result<usize> {
        if !self.queued {
            return (&self.client.stream).write(data);
        }
        self.client.answer(Frame::raw(data));
        Ok(data.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Agrees on a subprotocol with a client that may watch, within [`LONGEST`].
// The callback's type is the WebSocket layer's.
#[allow(clippy::result_large_err)]
pub(super) fn shake_hands(client: &Arc<Client>, shared: &Shared) -> Result<WebSocket<Half>, io::Error> {
    client.stream.set_nonblocking(false)?;
    client.stream.set_nodelay(true)?;
    client.stream.set_write_timeout(Some(STALLED))?;
    let limits = WebSocketConfig::default()
        .read_buffer_size(4 << 10)
        .write_buffer_size(0)
        .max_message_size(Some(MOST_REQUEST))
        .max_frame_size(Some(MOST_REQUEST));
    let half = Half { client: Arc::clone(client), queued: false, deadline: Some(Instant::now() + LONGEST) };
    let agree = |request: &Handshake, mut response: Response| {
        if let Some(reason) = shared.access.refusal(request) {
            return Err(refuse(StatusCode::FORBIDDEN, reason));
        }
        let Some(name) = subprotocol(request) else {
            return Err(refuse(StatusCode::BAD_REQUEST, format!("subprotocols: {}", SUBPROTOCOLS.join(", "))));
        };
        if !shared.admit(client) {
            return Err(refuse(StatusCode::SERVICE_UNAVAILABLE, "all places of viewers are taken".to_owned()));
        }
        response.headers_mut().insert(SEC_WEBSOCKET_PROTOCOL, HeaderValue::from_static(name));
        Ok(response)
    };
    let mut socket = tungstenite::accept_hdr_with_config(half, agree, Some(limits))
        .map_err(|error| io::Error::other(error.to_string()))?;
    client.stream.set_read_timeout(Some(SILENT))?;
    let half = socket.get_mut();
    (half.queued, half.deadline) = (true, None);
    Ok(socket)
}

fn refuse(status: StatusCode, reason: String) -> ErrorResponse {
    let mut refusal = ErrorResponse::new(Some(reason));
    *refusal.status_mut() = status;
    refusal
}

/// The first of ours that the client offers.
fn subprotocol(request: &Handshake) -> Option<&'static str> {
    let lines = || request.headers().get_all(SEC_WEBSOCKET_PROTOCOL).iter().filter_map(|line| line.to_str().ok());
    let offered = |name: &str| lines().flat_map(|line| line.split(',')).any(|offer| offer.trim() == name);
    SUBPROTOCOLS.into_iter().find(|name| offered(name))
}
