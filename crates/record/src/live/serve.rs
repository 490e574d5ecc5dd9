//! The two threads of a viewer: one reads its requests, one writes what waits for it.

use super::Shared;
use super::client::{Client, Counts, Stage};
use super::handshake::{Half, shake_hands};
use super::protocol::{Frame, Level, Request, request};
use std::io::{BufWriter, Write};
use std::sync::Arc;
use std::thread;
use tungstenite::{Message, WebSocket};

/// Serves a client until either side ends it.
pub(super) fn serve(client: &Arc<Client>, shared: &Arc<Shared>) -> Counts {
    if let Ok(mut socket) = shake_hands(client, shared) {
        {
            let mut queue = client.queue();
            queue.control.extend(shared.hello.iter().cloned());
            if queue.stage == Stage::Admitted {
                queue.stage = Stage::Open;
            }
        }
        let writing = Arc::clone(client);
        let writer = thread::Builder::new().name("live writer".to_owned()).spawn(move || write(&writing));
        if let Ok(writer) = writer {
            read(&mut socket, client, shared);
            client.over();
            // A thread that panicked has written what it has written.
            let _ = writer.join();
        }
    }
    client.cut();
    client.queue().counts()
}

/// Takes requests until the connection ends.
fn read(socket: &mut WebSocket<Half>, client: &Client, shared: &Shared) {
    while let Ok(message) = socket.read() {
        let Message::Text(text) = message else { continue };
        match request(&text) {
            Some(Request::Subscribe(list)) => list.iter().for_each(|&(id, channel)| {
                subscribe(client, shared, id, channel);
            }),
            Some(Request::Unsubscribe(ids)) => {
                let mut queue = client.queue();
                let ended = queue.subscriptions.iter_mut().filter(|s| s.is_some_and(|id| ids.contains(&id)));
                ended.for_each(|subscription| *subscription = None);
            }
            Some(Request::Other(op)) => client.answer(Frame::status(Level::Error, &format!("cannot do: {op}"))),
            None => client.answer(Frame::status(Level::Error, "a request that is not of the protocol")),
        }
    }
}

fn subscribe(client: &Client, shared: &Shared, id: u32, channel: usize) {
    let refused = {
        let mut queue = client.queue();
        let taken = queue.subscriptions.contains(&Some(id));
        match queue.subscriptions.get_mut(channel) {
            None => Some(format!("there is no channel {channel}")),
            Some(_) if taken => Some(format!("subscription {id} exists")),
            Some(Some(other)) => Some(format!("channel {channel} has subscription {other}")),
            Some(free) => {
                *free = Some(id);
                None
            }
        }
    };
    if let Some(reason) = refused {
        return client.answer(Frame::status(Level::Error, &reason));
    }
    if let Some((log_time, data)) = shared.kept(channel) {
        client.answer(Frame::time(shared.now().max(log_time)));
        client.message(channel, log_time, true, || data);
    }
}

/// Writes what waits, until nothing more will come.
fn write(client: &Client) {
    let mut out = BufWriter::with_capacity(64 << 10, &client.stream);
    let mut batch = Vec::new();
    while client.next(&mut batch) {
        if batch.drain(..).try_for_each(|frame| frame.write(&mut out)).and_then(|()| out.flush()).is_err() {
            client.over();
            client.cut();
            return;
        }
    }
}
