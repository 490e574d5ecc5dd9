//! A connected viewer: what it has subscribed to and what waits for it.

use super::protocol::{Frame, Level};
use std::collections::VecDeque;
use std::net::{Shutdown, TcpStream};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Most bytes of messages that wait for a client: about half a second of simulated time with all topics.
pub(super) const MOST_WAITING: usize = 8 << 20;
/// Most answers that wait for a client: one that asks without reading the answers is cut off.
const MOST_ANSWERS: usize = 1024;
/// Bytes that the writer takes from the queue at a time.
const BATCH: usize = 256 << 10;
/// Longest pause of a client that takes nothing.
pub(super) const STALLED: Duration = Duration::from_secs(10);
/// Between two questions whether a client is still there, and the longest time without a word of it: one that reads
/// nothing answers nothing, and its place is another's.
const PING_STEP: Duration = Duration::from_secs(3);
pub(super) const SILENT: Duration = Duration::from_secs(12);
/// Between two lines that tell a client what it has missed.
const REPORT_STEP: Duration = Duration::from_secs(1);

#[derive(Debug)]
pub(super) struct Client {
    pub(super) stream: TcpStream,
    queue: Mutex<Queue>,
    wake: Condvar,
}

#[derive(Debug, Default)]
pub(super) struct Queue {
    /// The client's name for its subscription, by channel.
    pub(super) subscriptions: Vec<Option<u32>>,
    /// Answers and what must not get lost; goes first.
    pub(super) control: VecDeque<Frame>,
    pub(super) data: VecDeque<Frame>,
    /// Bytes in `data`.
    pub(super) waiting: usize,
    pub(super) counts: Counts,
    /// Messages left out that the client knows of, and when it was told.
    pub(super) reported: (u64, Option<Instant>),
    pub(super) stage: Stage,
    /// When the client was asked last whether it is there.
    pub(super) asked: Option<Instant>,
}

/// Messages of one client.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Counts {
    pub(super) sent: u64,
    pub(super) dropped: u64,
}

#[derive(Debug, Default, PartialEq, Eq, Clone, Copy, PartialOrd)]
pub(super) enum Stage {
    /// The handshake is not over: nothing may be sent.
    #[default]
    Shaking,
    /// It has a viewer's place; the answer to the handshake is under way.
    Admitted,
    Open,
    /// To be closed when the queues are empty.
    Closing,
    /// Nothing more is sent.
    Over,
}

impl Client {
    pub(super) fn new(stream: TcpStream, channels: usize) -> Self {
        let queue = Queue { subscriptions: vec![None; channels], ..Queue::default() };
        Self { stream, queue: Mutex::new(queue), wake: Condvar::new() }
    }

    pub(super) fn queue(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// True if it has not shaken hands yet.
    pub(super) fn shakes(&self) -> bool {
        self.queue().stage == Stage::Shaking
    }

    /// True if it has a viewer's place.
    pub(super) fn has_place(&self) -> bool {
        (Stage::Admitted..=Stage::Closing).contains(&self.queue().stage)
    }

    /// Takes a viewer's place, unless its time is over.
    pub(super) fn take_place(&self) -> bool {
        let mut queue = self.queue();
        let shaking = queue.stage == Stage::Shaking;
        if shaking {
            queue.stage = Stage::Admitted;
        }
        shaking
    }

    /// Hands out a message, whose bytes are asked for only if the client wants it. Kept ones are never left out.
    pub(super) fn message(&self, channel: usize, log_time: u64, kept: bool, data: impl FnOnce() -> Arc<[u8]>) {
        let mut queue = self.queue();
        let Some(&Some(subscription)) = queue.subscriptions.get(channel) else { return };
        if queue.stage != Stage::Open {
            return;
        }
        let frame = Frame::message(subscription, log_time, data());
        if kept {
            queue.counts.sent += 1;
            queue.control.push_back(frame);
        } else {
            queue.push(frame);
        }
        self.wake.notify_one();
    }

    pub(super) fn time(&self, log_time: u64) {
        let mut queue = self.queue();
        if queue.stage == Stage::Open {
            let frame = Frame::time(log_time);
            queue.waiting += frame.len();
            queue.data.push_back(frame);
            queue.make_room();
            self.wake.notify_one();
        }
    }

    pub(super) fn answer(&self, frame: Frame) {
        let mut queue = self.queue();
        if queue.control.len() < MOST_ANSWERS {
            queue.control.push_back(frame);
        } else {
            queue.stage = Stage::Over;
            self.cut();
        }
        self.wake.notify_one();
    }

    /// Lets what waits be sent and then says goodbye.
    pub(super) fn close(&self) {
        let mut queue = self.queue();
        match queue.stage {
            Stage::Shaking | Stage::Admitted => {
                queue.stage = Stage::Over;
                self.cut();
            }
            Stage::Open => queue.stage = Stage::Closing,
            Stage::Closing | Stage::Over => {}
        }
        self.wake.notify_one();
    }

    /// Ends the connection at once.
    pub(super) fn cut(&self) {
        // Fails where the other side was faster, with the same result.
        let _ = self.stream.shutdown(Shutdown::Both);
    }

    pub(super) fn over(&self) {
        self.queue().stage = Stage::Over;
        self.wake.notify_one();
    }

    /// Waits for something to write; false when nothing more is to be written.
    pub(super) fn next(&self, batch: &mut Vec<Frame>) -> bool {
        let mut queue = self.queue();
        loop {
            queue.ask();
            if !queue.is_empty() || queue.stage != Stage::Open {
                break;
            }
            queue = self.wake.wait_timeout(queue, PING_STEP).unwrap_or_else(PoisonError::into_inner).0;
        }
        if queue.stage == Stage::Over {
            // Answers to a goodbye are still due, messages are not.
            batch.extend(queue.control.drain(..));
            return !batch.is_empty();
        }
        queue.report();
        if queue.is_empty() {
            batch.push(Frame::close());
            queue.stage = Stage::Over;
        }
        queue.take(batch);
        true
    }
}

impl Queue {
    pub(super) fn is_empty(&self) -> bool {
        self.control.is_empty() && self.data.is_empty()
    }

    /// Asks the client now and then whether it is still there.
    fn ask(&mut self) {
        if self.stage != Stage::Open {
            return;
        }
        // Who has just come is there.
        let asked = *self.asked.get_or_insert_with(Instant::now);
        if asked.elapsed() >= PING_STEP {
            self.control.push_back(Frame::ping());
            self.asked = Some(Instant::now());
        }
    }

    /// Appends a message, the oldest ones making room for it.
    pub(super) fn push(&mut self, frame: Frame) {
        self.counts.sent += 1;
        self.waiting += frame.len();
        self.data.push_back(frame);
        self.make_room();
    }

    pub(super) fn make_room(&mut self) {
        while self.waiting > MOST_WAITING && self.data.len() > 1 {
            let Some(oldest) = self.data.pop_front() else { return };
            self.waiting -= oldest.len();
            self.forget(&oldest);
        }
    }

    pub(super) fn forget(&mut self, frame: &Frame) {
        if !frame.is_time() {
            self.counts.sent -= 1;
            self.counts.dropped += 1;
        }
    }

    /// The counts at the end, when what still waits will not be sent.
    pub(super) fn counts(&mut self) -> Counts {
        while let Some(frame) = self.data.pop_front() {
            self.forget(&frame);
        }
        self.counts
    }

    pub(super) fn take(&mut self, batch: &mut Vec<Frame>) {
        batch.extend(self.control.drain(..));
        let mut bytes = 0;
        while bytes < BATCH {
            let Some(frame) = self.data.pop_front() else { return };
            bytes += frame.len();
            self.waiting -= frame.len();
            batch.push(frame);
        }
    }

    /// Tells the client what it has missed, now and then.
    pub(super) fn report(&mut self) {
        let (known, at) = self.reported;
        if self.counts.dropped > known && at.is_none_or(|at| at.elapsed() >= REPORT_STEP) {
            let missed = self.counts.dropped - known;
            let text = format!("{missed} messages were left out: the run is faster than this connection");
            self.control.push_back(Frame::status(Level::Warning, &text));
            self.reported = (self.counts.dropped, Some(Instant::now()));
        }
    }
}
