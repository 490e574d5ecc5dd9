//! A run as it goes, for viewers that connect: the channels of the recording over Foxglove's WebSocket protocol.
//!
//! A run is served as fast as it goes, which may be slower or faster than real time: nothing is slowed down to a clock.
//! Viewers follow the simulated time that is broadcast with the messages.
//!
//! Viewers do not slow a run: each has a queue of 8 MiB from which the oldest messages are left out, counted, and
//! reported to it. Without a viewer a message costs two accesses to memory. The bodies of `/bearing/geometry` come once
//! in a run; they are kept and sent to whoever subscribes later.
//!
//! The data are not encrypted, and nobody is asked who they are. Nobody can change a run by this. The address should be
//! one of this machine, and even there any program can read. Pages in a browser cannot, but for those of this machine
//! and of the viewers that are known or were allowed ([`LiveServer::allow`]).
//!
//! A viewer is asked every few seconds whether it is still there; one that does not answer for twelve seconds loses its
//! place.
//!
//! A handshake has five seconds in all. Connections that have not shaken hands yet take no viewer's place; the oldest
//! of them makes room for a new one.
//!
//! The server is written on the crate `tungstenite`, with two threads for each viewer: ten crates more than without it,
//! and at most 13 s of processor time to build. The one in the Foxglove SDK 0.30.3 needs 118 crates, an asynchronous
//! runtime among them.

mod access;
mod client;
mod handshake;
mod protocol;
mod serve;

pub use access::LiveName;

use crate::RecordError;
use crate::run::{Preamble, Sink};
use access::Access;
use client::{Client, Counts};
use protocol::Frame;
use std::fmt;
use std::io;
use std::net::{SocketAddr, TcpListener};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Where viewers look for a server if not told otherwise: this machine only.
pub const LIVE_ADDRESS: &str = "127.0.0.1:8765";

/// Most viewers at a time.
const MOST_CLIENTS: usize = 8;
/// Most connections at a time that have not shaken hands yet, each with a thread of its own.
const MOST_SHAKING: usize = 32;
/// Wall time between looks for new viewers.
const ACCEPT_STEP: Duration = Duration::from_millis(20);
/// Wall time between broadcasts of the simulated time.
const TIME_STEP: Duration = Duration::from_millis(20);
/// Wall time that viewers have at the end to take what waits for them.
const LAST_WAIT: Duration = Duration::from_secs(2);
/// Topics whose message comes once and is kept.
const KEPT: [&str; 1] = ["/bearing/geometry"];

/// The server can be reached from other machines: to be shown to whoever started it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LiveWarning {
    /// Where the server listens.
    pub address: SocketAddr,
}

impl fmt::Display for LiveWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the live server at {} can be reached from other machines: its data is neither encrypted nor protected by \
             a password, and anyone who can reach the address can read it; {LIVE_ADDRESS} is for this machine only",
            self.address
        )
    }
}

/// Totals of a server: its viewers and messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LiveSummary {
    /// Viewers that connected.
    pub clients: u64,
    /// Messages handed to viewers, one for each that had subscribed.
    pub messages_sent: u64,
    /// Messages left out because a viewer was slower than the run.
    pub messages_dropped: u64,
}

/// Serves the messages of a run to viewers: a [`Sink`] for [`crate::RunRecorder`], alone or beside a file.
///
/// Viewers can connect from the start of the recording to [`Sink::finish`]; dropped before, it cuts all connections.
#[derive(Debug)]
pub struct LiveServer {
    address: SocketAddr,
    /// None once the recording has begun.
    listener: Option<TcpListener>,
    access: Access,
    running: Option<Running>,
    /// When the time was broadcast last.
    broadcast: Option<Instant>,
}

#[derive(Debug)]
struct Running {
    shared: Arc<Shared>,
    acceptor: JoinHandle<()>,
}

/// State shared by the threads.
#[derive(Debug)]
struct Shared {
    /// Frames that every client gets first: server information and channels.
    hello: [Frame; 2],
    access: Access,
    clients: Mutex<Vec<Arc<Client>>>,
    /// A client has gone.
    ended: Condvar,
    /// Number of clients, to be read without a lock.
    connected: AtomicUsize,
    /// True for channels whose messages are kept.
    keeps: Vec<bool>,
    /// The kept messages, by channel.
    kept: Mutex<Vec<Option<Kept>>>,
    /// Log time of the last message, ns.
    now: AtomicU64,
    closing: AtomicBool,
    summary: Mutex<LiveSummary>,
}

/// Log time (ns) and data of a message that later viewers get too.
type Kept = (u64, Arc<[u8]>);

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Shared {
    fn new(preamble: &Preamble, access: Access) -> Self {
        let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        // Tells a viewer that connects again whether it is the same run.
        let session = format!("{}-{}", std::process::id(), since.as_nanos());
        Self {
            hello: [Frame::server_info(preamble, &session), Frame::advertise(preamble.channels)],
            access,
            clients: Mutex::default(),
            ended: Condvar::new(),
            connected: AtomicUsize::new(0),
            keeps: preamble.channels.iter().map(|channel| KEPT.contains(&channel.topic)).collect(),
            kept: Mutex::new(vec![None; preamble.channels.len()]),
            now: AtomicU64::new(0),
            closing: AtomicBool::new(false),
            summary: Mutex::default(),
        }
    }

    fn now(&self) -> u64 {
        self.now.load(Ordering::Relaxed)
    }

    fn kept(&self, channel: usize) -> Option<Kept> {
        lock(&self.kept).get(channel).cloned().flatten()
    }

    /// Takes a new connection, for which the oldest one that has not shaken hands may have to go.
    fn add(&self, client: &Arc<Client>) -> bool {
        let mut clients = lock(&self.clients);
        if self.closing.load(Ordering::Relaxed) {
            return false;
        }
        let shaking: Vec<_> = clients.iter().filter(|client| client.shakes()).collect();
        if let Some(oldest) = shaking.first().filter(|_| shaking.len() >= MOST_SHAKING) {
            oldest.close();
        }
        clients.push(Arc::clone(client));
        self.connected.store(clients.len(), Ordering::Release);
        true
    }

    /// Gives a client that has shaken hands one of the places, if there is one.
    fn admit(&self, client: &Client) -> bool {
        let clients = lock(&self.clients);
        clients.iter().filter(|client| client.has_place()).count() < MOST_CLIENTS && client.take_place()
    }

    fn remove(&self, client: &Arc<Client>, counts: Counts) {
        let mut clients = lock(&self.clients);
        clients.retain(|one| !Arc::ptr_eq(one, client));
        self.connected.store(clients.len(), Ordering::Release);
        let mut summary = lock(&self.summary);
        summary.clients += 1;
        summary.messages_sent += counts.sent;
        summary.messages_dropped += counts.dropped;
        self.ended.notify_all();
    }

    /// Lets no more clients in and asks those there are to leave, within `patience`.
    fn close(&self, patience: Duration) {
        let mut clients = lock(&self.clients);
        self.closing.store(true, Ordering::Relaxed);
        clients.iter().for_each(|client| client.close());
        let waited = self.ended.wait_timeout_while(clients, patience, |clients| !clients.is_empty());
        clients = waited.unwrap_or_else(PoisonError::into_inner).0;
        clients.iter().for_each(|client| client.cut());
    }
}

impl LiveServer {
    /// Listens on `address`, such as [`LIVE_ADDRESS`]: host and port, port 0 for any that is free. The warning, if
    /// there is one, is to be shown.
    ///
    /// # Errors
    /// [`RecordError::Listen`] if the address is none or is taken.
    pub fn start(address: &str) -> Result<(Self, Option<LiveWarning>), RecordError> {
        let error = |source| RecordError::Listen { address: address.to_owned(), source };
        let listener = TcpListener::bind(address).map_err(error)?;
        listener.set_nonblocking(true).map_err(error)?;
        let local = listener.local_addr().map_err(error)?;
        let warning = (!local.ip().is_loopback()).then_some(LiveWarning { address: local });
        let host = address.rsplit_once(':').map_or(address, |(host, _)| host);
        let access = Access { listens: host.to_ascii_lowercase(), names: Vec::new() };
        let server = Self { address: local, listener: Some(listener), access, running: None, broadcast: None };
        Ok((server, warning))
    }

    /// Lets viewers in that come by these host names or from pages of these hosts or origins, besides those of this
    /// machine and the known ones; to be called before the recording begins.
    pub fn allow(&mut self, names: &[LiveName]) {
        self.access.names.extend_from_slice(names);
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Viewers that are connected now.
    pub fn clients(&self) -> usize {
        self.running.as_ref().map_or(0, |running| running.shared.connected.load(Ordering::Acquire))
    }

    fn stop(&mut self, patience: Duration) -> Option<LiveSummary> {
        let Running { shared, acceptor } = self.running.take()?;
        shared.close(patience);
        // A thread that panicked has let go of its connections too.
        let _ = acceptor.join();
        let summary = *lock(&shared.summary);
        Some(summary)
    }
}

impl Drop for LiveServer {
    fn drop(&mut self) {
        self.stop(Duration::ZERO);
    }
}

impl Sink for LiveServer {
    type Output = LiveSummary;

    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        let listener = self.listener.take().ok_or(RecordError::NotBegun)?;
        let shared = Arc::new(Shared::new(preamble, self.access.clone()));
        let serving = Arc::clone(&shared);
        let acceptor = thread::Builder::new().name("live".to_owned()).spawn(move || accept(&listener, &serving));
        let error = |source| RecordError::Listen { address: self.address.to_string(), source };
        self.running = Some(Running { shared, acceptor: acceptor.map_err(error)? });
        Ok(())
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        let shared = &self.running.as_ref().ok_or(RecordError::NotBegun)?.shared;
        shared.now.store(log_time, Ordering::Relaxed);
        let keep = shared.keeps.get(channel).is_some_and(|&keep| keep);
        let nobody = shared.connected.load(Ordering::Acquire) == 0;
        if nobody && !keep {
            return Ok(());
        }
        // One copy for all who want it.
        let mut copy: Option<Arc<[u8]>> = None;
        if keep {
            let data = copy.insert(data.into());
            if let Some(kept) = lock(&shared.kept).get_mut(channel) {
                *kept = Some((log_time, Arc::clone(data)));
            }
        }
        let clients = lock(&shared.clients);
        if self.broadcast.is_none_or(|at| at.elapsed() >= TIME_STEP) {
            self.broadcast = Some(Instant::now());
            clients.iter().for_each(|client| client.time(log_time));
        }
        for client in clients.iter() {
            client.message(channel, log_time, keep, || Arc::clone(copy.get_or_insert_with(|| data.into())));
        }
        Ok(())
    }

    /// Nothing to do: viewers get messages as they come.
    fn flush(&mut self) -> Result<(), RecordError> {
        self.running.as_ref().map(|_| ()).ok_or(RecordError::NotBegun)
    }

    /// Broadcasts the last time, gives viewers two seconds to take what waits for them, and closes the connections.
    fn finish(mut self) -> Result<LiveSummary, RecordError> {
        let shared = &self.running.as_ref().ok_or(RecordError::NotBegun)?.shared;
        lock(&shared.clients).iter().for_each(|client| client.time(shared.now()));
        self.stop(LAST_WAIT).ok_or(RecordError::NotBegun)
    }
}

/// Lets clients in until the server closes.
fn accept(listener: &TcpListener, shared: &Arc<Shared>) {
    let mut threads: Vec<JoinHandle<()>> = Vec::new();
    while !shared.closing.load(Ordering::Relaxed) {
        match listener.accept() {
            Ok((stream, _)) => threads.extend(welcome(Arc::new(Client::new(stream, shared.keeps.len())), shared)),
            // Nobody there, or one who has gone again.
            Err(_) => thread::sleep(ACCEPT_STEP),
        }
        threads.retain(|thread| !thread.is_finished());
    }
    for thread in threads {
        // One that panicked has nothing more to say.
        let _ = thread.join();
    }
}

/// Starts to serve a client, if there is room for it.
fn welcome(client: Arc<Client>, shared: &Arc<Shared>) -> Option<JoinHandle<()>> {
    if !shared.add(&client) {
        return None;
    }
    let (serving, theirs) = (Arc::clone(shared), Arc::clone(&client));
    let serve = move || {
        let counts = serve::serve(&theirs, &serving);
        serving.remove(&theirs, counts);
    };
    let started: io::Result<JoinHandle<()>> = thread::Builder::new().name("live reader".to_owned()).spawn(serve);
    if started.is_err() {
        shared.remove(&client, Counts::default());
    }
    started.ok()
}

/// True for a text that is a request of a viewer, for trials with damaged ones: none of them may do worse than be
/// refused.
#[doc(hidden)]
pub fn is_live_request(text: &str) -> bool {
    protocol::request(text).is_some()
}
