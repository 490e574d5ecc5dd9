//! The live server, seen by clients over a socket of this machine.

use super::sample::{feed, recording, sample};
use super::{BALLS, case};
use crate::output::Channel;
use crate::run::Preamble;
use crate::wire::{FOXGLOVE_DESCRIPTORS, TRIBODYN_DESCRIPTORS, foxglove, tribodyn};
use crate::{LIVE_ADDRESS, LiveServer, RecordError, RunRecorder, Sink, StreamSink};
use data_encoding::BASE64;
use prost::Message as _;
use serde_json::{Value, json};
use std::io::{Cursor, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::time::{Duration, Instant};
use tungstenite::{ClientRequestBuilder, Message, WebSocket};

/// A message of a channel as it came: subscription, log time, data.
type Data = (u32, u64, Vec<u8>);

struct Viewer {
    socket: WebSocket<TcpStream>,
    times: Vec<u64>,
}

impl Viewer {
    fn connect(address: SocketAddr, protocols: &[&str]) -> Result<(Self, String), String> {
        let stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        let uri = format!("ws://{address}/").parse().unwrap();
        let request = protocols.iter().fold(ClientRequestBuilder::new(uri), |r, p| r.with_sub_protocol(*p));
        let (socket, response) = tungstenite::client(request, stream).map_err(|error| error.to_string())?;
        let agreed = response.headers()["sec-websocket-protocol"].to_str().unwrap().to_owned();
        Ok((Self { socket, times: Vec::new() }, agreed))
    }

    /// With the server's first two messages.
    fn open(address: SocketAddr) -> (Self, Value, Value) {
        let (mut viewer, _) = Self::connect(address, &["foxglove.sdk.v1"]).unwrap();
        let (info, channels) = (viewer.json(), viewer.json());
        (viewer, info, channels)
    }

    fn json(&mut self) -> Value {
        match self.socket.read().unwrap() {
            Message::Text(text) => serde_json::from_str(&text).unwrap(),
            other => panic!("{other:?}"),
        }
    }

    /// Asks; the pong comes after all answers.
    fn ask(&mut self, request: &Value) {
        self.socket.send(Message::text(request.to_string())).unwrap();
        self.socket.send(Message::Ping("done".into())).unwrap();
    }

    fn subscribe(&mut self, id: u32, channel: usize) {
        self.ask(&json!({ "op": "subscribe", "subscriptions": [{ "id": id, "channelId": channel }] }));
        // The server asks in between whether its viewer is there.
        let answer = std::iter::repeat_with(|| self.socket.read().unwrap()).find(|message| !message.is_ping());
        assert_eq!(answer, Some(Message::Pong("done".into())));
    }

    /// The next message of a channel; none when the server has closed the connection in good order.
    fn data(&mut self) -> Option<Data> {
        loop {
            match self.socket.read().unwrap() {
                Message::Binary(bytes) if bytes[0] == 1 => {
                    let id = u32::from_le_bytes(bytes[1..5].try_into().unwrap());
                    let time = u64::from_le_bytes(bytes[5..13].try_into().unwrap());
                    return Some((id, time, bytes[13..].to_vec()));
                }
                Message::Binary(bytes) => {
                    assert_eq!((bytes[0], bytes.len()), (2, 9));
                    self.times.push(u64::from_le_bytes(bytes[1..].try_into().unwrap()));
                }
                Message::Close(frame) => {
                    assert_eq!(u16::from(frame.unwrap().code), 1000);
                    return None;
                }
                Message::Text(_) | Message::Ping(_) | Message::Pong(_) => {}
                Message::Frame(frame) => panic!("{frame:?}"),
            }
        }
    }
}

fn start() -> LiveServer {
    let (server, warning) = LiveServer::start("127.0.0.1:0").unwrap();
    assert_eq!(warning, None);
    server
}

/// Log times and data of a topic in a file.
fn of_topic(file: &[u8], topic: &str) -> Vec<(u64, Vec<u8>)> {
    let messages = mcap::MessageStream::new(file).unwrap().map(Result::unwrap);
    messages.filter(|m| m.channel.topic == topic).map(|m| (m.log_time, m.data.to_vec())).collect()
}

fn place(channels: &Value, topic: &str) -> usize {
    let list = channels["channels"].as_array().unwrap();
    usize::try_from(list.iter().find(|c| c["topic"] == topic).unwrap()["id"].as_u64().unwrap()).unwrap()
}

#[test]
fn identity_a_viewer_gets_what_the_file_gets() {
    let case = case::case(BALLS);
    let server = start();
    let address = server.address();
    let file = StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
    let mut recorder = RunRecorder::new((file, Some(server)), &recording(&case)).unwrap();

    let (mut viewer, info, channels) = Viewer::open(address);
    assert_eq!((&info["op"], &info["capabilities"]), (&json!("serverInfo"), &json!(["time"])));
    assert_eq!(info["metadata"]["kind"], "transient run");
    let list = channels["channels"].as_array().unwrap();
    assert_eq!((&channels["op"], list.len()), (&json!("advertise"), 13));
    for channel in list {
        assert_eq!((&channel["encoding"], &channel["schemaEncoding"]), (&json!("protobuf"), &json!("protobuf")));
        let own = channel["schemaName"].as_str().unwrap().starts_with("tribodyn.");
        let expected = if own { TRIBODYN_DESCRIPTORS } else { FOXGLOVE_DESCRIPTORS };
        assert_eq!(BASE64.decode(channel["schema"].as_str().unwrap().as_bytes()).unwrap(), expected);
    }

    viewer.subscribe(70, place(&channels, "/bearing/state"));
    feed(&mut recorder, 200, 10_000.0, 5).unwrap();
    let (id, _, first) = viewer.data().unwrap();
    let state = tribodyn::TransientState::decode(first.as_slice()).unwrap();
    assert_eq!((id, state.time_s), (70, 0.0));
    assert_eq!(state.inner_displacement_x_um, sample(0.0).inner.displacement_m[0] * 1e6);

    // After the only message of the topic.
    let (mut late, _, _) = Viewer::open(address);
    let channel = place(&channels, "/bearing/geometry");
    late.ask(&json!({ "op": "subscribe", "subscriptions": [{ "id": 4, "channelId": channel }] }));
    let (id, time, geometry) = late.data().unwrap();
    assert!(!foxglove::SceneUpdate::decode(geometry.as_slice()).unwrap().entities.is_empty());

    let end = std::thread::spawn(move || {
        assert_eq!(late.data(), None);
        let mut rest = vec![];
        while let Some((id, time, data)) = viewer.data() {
            assert_eq!(id, 70);
            rest.push((time, data));
        }
        (rest, viewer.times)
    });
    let (file, summary) = recorder.finish().unwrap();
    let (rest, times) = end.join().unwrap();
    let file = file.into_inner();
    assert_eq!((id, vec![(time, geometry)]), (4, of_topic(&file, "/bearing/geometry")));
    let states = of_topic(&file, "/bearing/state");
    assert_eq!((&states[0].1, &states[1..]), (&first, rest.as_slice()));
    assert!(times.windows(2).all(|pair| pair[0] <= pair[1]));
    assert_eq!(times.last(), states.last().map(|(time, _)| time));
    let summary = summary.unwrap();
    assert_eq!((summary.clients, summary.messages_sent, summary.messages_dropped), (2, 201, 0));
    assert!(TcpStream::connect(address).is_err(), "still listening");
}

const NUMBERED: [Channel; 1] = [Channel { topic: "/numbered", schema: "none", descriptors: &[] }];

fn preamble() -> Preamble<'static> {
    Preamble { channels: &NUMBERED, generator: "test", case_text: "", layout: "", entries: &[] }
}

/// 60 MB for a viewer that reads nothing until all is said, which is more than the system keeps for it.
#[test]
fn limit_a_slow_viewer_misses_the_oldest_messages_and_holds_nothing_up() {
    const COUNT: u64 = 600;
    let mut server = start();
    server.begin(&preamble()).unwrap();
    let (mut viewer, _, _) = Viewer::open(server.address());
    viewer.subscribe(0, 0);
    let mut data = vec![1; 100_000];
    let start = Instant::now();
    for number in 1..=COUNT {
        data[..8].copy_from_slice(&number.to_le_bytes());
        server.message(0, number, &data).unwrap();
    }
    // Far less than the ten seconds after which a viewer that takes nothing is cut off.
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
    let reading = std::thread::spawn(move || {
        let mut numbers = vec![];
        while let Some((_, time, data)) = viewer.data() {
            assert_eq!(data[..8], time.to_le_bytes());
            numbers.push(time);
        }
        numbers
    });
    let summary = server.finish().unwrap();
    let numbers = reading.join().unwrap();
    assert_eq!(numbers.len() as u64, summary.messages_sent);
    assert_eq!(summary.messages_sent + summary.messages_dropped, COUNT);
    assert!(summary.messages_dropped > 0);
    // 8 MiB are 83 messages.
    assert!(numbers.ends_with(&(COUNT - 80..=COUNT).collect::<Vec<_>>()), "not the newest ones");
    assert!(numbers.windows(2).all(|pair| pair[0] < pair[1]));
}

#[test]
fn limit_a_viewer_that_reads_nothing_does_not_hold_up_the_end() {
    let mut server = start();
    server.begin(&preamble()).unwrap();
    let (mut viewer, _, _) = Viewer::open(server.address());
    viewer.subscribe(0, 0);
    // A connection without a handshake, too.
    let silent = TcpStream::connect(server.address()).unwrap();
    for number in 1..=300 {
        server.message(0, number, &[7; 100_000]).unwrap();
    }
    let start = Instant::now();
    let summary = server.finish().unwrap();
    assert!(start.elapsed() < Duration::from_secs(8), "{:?}", start.elapsed());
    assert!(summary.messages_dropped > 0);
    drop(silent);
}

#[test]
fn limit_what_is_not_of_the_protocol_is_refused_in_words() {
    let mut server = start();
    assert!(matches!(server.message(0, 1, &[]), Err(RecordError::NotBegun)));
    server.begin(&preamble()).unwrap();
    assert!(matches!(server.begin(&preamble()), Err(RecordError::NotBegun)));
    let address = server.address();
    let connect = |protocols: &[&str]| Viewer::connect(address, protocols).map(|(_, agreed)| agreed);
    assert_eq!(connect(&["foxglove.websocket.v1"]).unwrap(), "foxglove.websocket.v1");
    assert_eq!(connect(&["foxglove.websocket.v1", "foxglove.sdk.v1"]).unwrap(), "foxglove.sdk.v1");
    for refused in [&["foxglove.sdk.v1.1"][..], &[]] {
        assert!(connect(refused).unwrap_err().contains("400"));
    }
    let (mut viewer, _, _) = Viewer::open(address);
    viewer.subscribe(1, 0);
    let subscribe =
        |id: u32, channel: u32| json!({ "op": "subscribe", "subscriptions": [{ "id": id, "channelId": channel }] });
    for (request, reason) in [
        (subscribe(1, 0), "subscription 1 exists"),
        (subscribe(2, 0), "channel 0 has subscription 1"),
        (subscribe(2, 9), "no channel 9"),
        (json!({ "op": "getParameters" }), "getParameters"),
        (json!([]), "not of the protocol"),
    ] {
        viewer.ask(&request);
        let answer = viewer.json();
        assert_eq!((&answer["op"], &answer["level"]), (&json!("status"), &json!(2)));
        assert!(answer["message"].as_str().unwrap().contains(reason), "{answer}");
        assert_eq!(viewer.socket.read().unwrap(), Message::Pong("done".into()));
    }
    // Still served; and no longer once it has unsubscribed.
    server.message(0, 5, b"five").unwrap();
    assert_eq!(viewer.data(), Some((1, 5, b"five".to_vec())));
    viewer.ask(&json!({ "op": "unsubscribe", "subscriptionIds": [1] }));
    assert_eq!(viewer.socket.read().unwrap(), Message::Pong("done".into()));
    server.message(0, 6, b"six").unwrap();
    drop(server);
    assert!(std::iter::repeat_with(|| viewer.socket.read()).any(|message| match message {
        Ok(Message::Binary(data)) => {
            assert_eq!(data[0], 2, "a message after the subscription had ended");
            false
        }
        // The server says goodbye, where the connection lives long enough to hear it.
        Ok(Message::Close(_)) | Err(_) => true,
        Ok(other) => panic!("{other:?}"),
    }));
}

/// Asks for a WebSocket as a page of a browser would; the answer's status.
fn as_page(address: SocketAddr, host: &str, origin: &str) -> Result<(), String> {
    let stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
    let request = ClientRequestBuilder::new(format!("ws://{host}/").parse().unwrap())
        .with_header("Origin", origin)
        .with_sub_protocol("foxglove.sdk.v1");
    tungstenite::client(request, stream).map(drop).map_err(|error| error.to_string())
}

#[test]
fn limit_pages_of_strangers_read_nothing() {
    let mut server = start();
    server.allow(&["https://lab.example".parse().unwrap(), "lab.example".parse().unwrap()]);
    server.begin(&preamble()).unwrap();
    let address = server.address();
    let here = address.to_string();
    for (host, origin) in [
        (here.as_str(), "http://localhost:8080"),
        (&here, "file://"),
        (&here, "https://lab.example"),
        ("lab.example:8765", "http://127.0.0.1"),
    ] {
        assert_eq!(as_page(address, host, origin), Ok(()), "{host} {origin}");
    }
    for (host, origin) in [(here.as_str(), "https://evil.example"), (&here, "null"), ("evil.example:8765", "file://")] {
        let refused = as_page(address, host, origin).unwrap_err();
        assert!(refused.contains("403"), "{host} {origin}: {refused}");
    }
}

/// Connections that send a byte now and then, as many as they like, keep no viewer out, and each is ended in its time.
#[test]
fn limit_clients_that_drip_through_the_handshake_lock_nobody_out() {
    let mut server = start();
    server.begin(&preamble()).unwrap();
    let address = server.address();
    let mut dripping: Vec<TcpStream> = (0..40).map(|_| TcpStream::connect(address).unwrap()).collect();
    let begun = Instant::now();
    let drip = |dripping: &mut Vec<TcpStream>| dripping.retain_mut(|stream| stream.write_all(b"G").is_ok());
    drip(&mut dripping);
    let (mut viewer, _, _) = Viewer::open(address);
    assert!(begun.elapsed() < Duration::from_secs(4), "a viewer waited {:?}", begun.elapsed());
    while !dripping.is_empty() {
        assert!(begun.elapsed() < Duration::from_secs(9), "{} still drip", dripping.len());
        std::thread::sleep(Duration::from_millis(250));
        drip(&mut dripping);
    }
    viewer.subscribe(0, 0);
    server.message(0, 1, b"one").unwrap();
    assert_eq!(viewer.data(), Some((0, 1, b"one".to_vec())));
}

#[test]
fn limit_a_viewer_beyond_the_places_is_told_so() {
    let mut server = start();
    server.begin(&preamble()).unwrap();
    let mut viewers: Vec<Viewer> = (0..8).map(|_| Viewer::open(server.address()).0).collect();
    let connect = || Viewer::connect(server.address(), &["foxglove.sdk.v1"]).map(drop);
    assert!(connect().unwrap_err().contains("503"));
    viewers.pop().unwrap().socket.close(None).unwrap();
    let begun = Instant::now();
    while connect().is_err() {
        assert!(begun.elapsed() < Duration::from_secs(20), "the place of a viewer that left is not free");
        std::thread::sleep(Duration::from_millis(50));
    }
}

/// Viewers that shake hands and then never read hold no place for ever; one that reads keeps its own.
#[test]
fn regress_viewers_that_never_read_lose_their_places() {
    let mut server = start();
    server.begin(&preamble()).unwrap();
    let (mut reading, _, _) = Viewer::open(server.address());
    reading.subscribe(0, 0);
    let silent: Vec<Viewer> = (0..7).map(|_| Viewer::open(server.address()).0).collect();
    reading.socket.get_mut().set_read_timeout(Some(Duration::from_millis(50))).unwrap();
    let begun = Instant::now();
    while Viewer::connect(server.address(), &["foxglove.sdk.v1"]).is_err() {
        assert!(begun.elapsed() < Duration::from_secs(40), "eight places are held by viewers that never read");
        // Reading answers the server's questions too.
        let _ = reading.socket.read();
    }
    reading.socket.get_mut().set_read_timeout(Some(Duration::from_secs(30))).unwrap();
    server.message(0, 1, b"one").unwrap();
    assert_eq!(reading.data(), Some((0, 1, b"one".to_vec())));
    drop(silent);
}

#[test]
fn limit_an_address_that_others_can_reach_gives_a_warning() {
    assert!(LIVE_ADDRESS.parse::<SocketAddr>().unwrap().ip().is_loopback());
    let (server, warning) = LiveServer::start("0.0.0.0:0").unwrap();
    let text = warning.unwrap().to_string();
    for word in ["0.0.0.0:", "encrypted", "anyone", LIVE_ADDRESS] {
        assert!(text.contains(word), "{text}");
    }
    let taken = server.address().to_string();
    for address in [taken.as_str(), "127.0.0.1", "127.0.0.1:99999"] {
        let error = LiveServer::start(address).unwrap_err();
        assert!(matches!(error, RecordError::Listen { .. }) && error.to_string().contains(address), "{error}");
    }
}
