//! Viewers of a live run that are slow, silent or hostile: none of them changes the recording, stops the run or keeps
//! a good viewer out, and pages of strangers read nothing.

use super::kills::is_whole;
use super::lab::{Lab, Reference, told};
use super::random::Random;
use super::row::{Row, ensure};
use super::viewer::{Viewer, frame, subscribe_all};
use crate::error::Failure;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::SocketAddr;
use std::process::Child;
use std::time::{Duration, Instant};

/// Connections that drip at the same time.
const DRIPPING: usize = 40;
/// Hostile connections of a run.
const HOSTILE: usize = 20;
/// Most waiting of a good viewer.
const GREETING: Duration = Duration::from_secs(2);
/// Longest delay of a run by viewers: their time at its end, and a share of the processor for their threads.
const LAST: Duration = Duration::from_secs(4);

pub fn rows(lab: &mut Lab, references: &[Reference]) -> Result<Vec<Row>, Failure> {
    let mut dripping = Row::new("dripping handshakes: a good viewer is served");
    let mut strangers = Row::new("pages of strangers, names of strangers: refused");
    let mut hostile = Row::new("hostile and slow viewers: the run is whole, and not held up");
    let mut longest = Duration::ZERO;
    for reference in references {
        let (run, address) = begin(lab, reference)?;
        let (outcome, waited) = drip(address);
        longest = longest.max(waited);
        dripping.count(outcome);
        for (host, headers) in [
            (address.to_string(), "Origin: https://evil.example\r\n"),
            (address.to_string(), "Origin: null\r\n"),
            ("evil.example:8765".to_owned(), ""),
        ] {
            let status = Viewer::connect(address).and_then(|mut viewer| viewer.shake_hands(&host, headers));
            strangers.count(ensure(matches!(status, Ok(403)), || format!("{host} {headers:?}: {status:?}")));
        }
        hostile.count(end(lab, run, reference)?);
    }
    for reference in references {
        let begun = Instant::now();
        let (run, address) = begin(lab, reference)?;
        let attacks: Vec<_> = (0..HOSTILE).map(|kind| (kind, Random::new(lab.random.next()))).collect();
        let threads =
            attacks.into_iter().map(|(kind, random)| std::thread::spawn(move || attack(kind, address, random)));
        for thread in threads.collect::<Vec<_>>() {
            // What came of an attack is seen in the run.
            let _ = thread.join();
        }
        let outcome = end(lab, run, reference)?;
        let took = begun.elapsed();
        let most = reference.wall * 2 + LAST + attack_time();
        hostile.count(outcome.and_then(|()| ensure(took < most, || format!("the run took {took:?}"))));
    }
    dripping.worst = format!("{:.2} s until it is greeted", longest.as_secs_f64());
    hostile.worst = format!("{} connections a run", HOSTILE.max(DRIPPING));
    Ok(vec![dripping, strangers, hostile])
}

struct Run {
    child: Child,
    /// The rest of what the run says.
    said: BufReader<std::process::ChildStderr>,
    recording: std::path::PathBuf,
}

/// Starts a run with viewers, and waits until it says where it listens.
fn begin(lab: &mut Lab, reference: &Reference) -> Result<(Run, SocketAddr), Failure> {
    let recording = lab.scratch()?.join("run.mcap");
    let mut child = lab.spawn(&lab.run_words(reference.plan, &recording, &["--live=127.0.0.1:0"]))?;
    let missing = || lab.no_start(std::io::Error::other("a live run does not say where it listens"));
    let mut said = BufReader::new(child.stderr.take().ok_or_else(missing)?);
    let mut line = String::new();
    said.read_line(&mut line).map_err(|source| lab.no_start(source))?;
    let address = line.trim().strip_prefix("live at ws://").and_then(|address| address.parse().ok());
    Ok((Run { child, said, recording }, address.ok_or_else(missing)?))
}

/// Waits for the end of a run, whose recording is that of one that nobody watched.
fn end(lab: &Lab, run: Run, reference: &Reference) -> Result<Result<(), String>, Failure> {
    let Run { child, mut said, recording } = run;
    let mut stderr = Vec::new();
    said.read_to_end(&mut stderr).map_err(|source| lab.no_start(source))?;
    let mut output = child.wait_with_output().map_err(|source| lab.no_start(source))?;
    output.stderr = stderr;
    Ok(ensure(output.status.success(), || told(&output)).and_then(|()| is_whole(&recording, reference)))
}

/// Many connections that send a byte now and then, and a good viewer among them; how long it waits.
fn drip(address: SocketAddr) -> (Result<(), String>, Duration) {
    let mut dripping: Vec<Viewer> = (0..DRIPPING).flat_map(|_| Viewer::connect(address)).collect();
    let connected = dripping.len();
    let mut greeted = |begun: Instant| {
        dripping.retain_mut(|one| one.0.write_all(b"G").is_ok());
        let mut viewer = Viewer::connect(address).map_err(|error| error.to_string())?;
        let status = viewer.shake_hands(&address.to_string(), "").map_err(|error| error.to_string())?;
        ensure(status == 101 && viewer.hears(), || format!("status {status}"))?;
        viewer.vanish();
        ensure(begun.elapsed() < GREETING, || format!("a good viewer waited {:?}", begun.elapsed()))
    };
    let (mut longest, mut outcome) = (Duration::ZERO, ensure(connected > 8, || "no connections".to_owned()));
    for _ in 0..4 {
        let begun = Instant::now();
        outcome = outcome.and_then(|()| greeted(begun));
        longest = longest.max(begun.elapsed());
        std::thread::sleep(Duration::from_millis(50));
    }
    (outcome, longest)
}

/// The longest that an attack lasts once it is connected.
fn attack_time() -> Duration {
    Duration::from_secs(6)
}

/// One hostile viewer. Whatever the server answers, it goes on as long as it can.
fn attack(kind: usize, address: SocketAddr, mut random: Random) {
    let Ok(mut viewer) = Viewer::connect(address) else { return };
    let noise = |random: &mut Random, count: usize| (0..count).map(|_| random.next() as u8).collect::<Vec<_>>();
    let good =
        !kind.is_multiple_of(5) && viewer.shake_hands(&address.to_string(), "").is_ok_and(|status| status == 101);
    let _ = match (good, kind % 10) {
        // Noise instead of a handshake.
        (false, _) => viewer.0.write_all(&noise(&mut random, 20_000)),
        (_, 1) => viewer.0.write_all(&noise(&mut random, 100_000)),
        // A frame that promises more than there is room for, and one that is not masked.
        (_, 2) => viewer.0.write_all(&[0x82, 0xff, 0x7f, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 1, 2, 3]),
        (_, 3) => viewer.0.write_all(b"\x81\x05hello"),
        // Everything, and reads nothing.
        (_, 4) => viewer.send(&subscribe_all()).map(|()| std::thread::sleep(attack_time() / 2)),
        // Requests without end whose answers are not read.
        (_, 6) => (0..5000).try_for_each(|_| viewer.send("{\"op\":\"getParameters\"}")),
        (_, 7) => (0..5000).try_for_each(|_| viewer.0.write_all(&frame(0x89, b"ping"))),
        // A message in pieces that never ends.
        (_, 8) => (0..500).try_for_each(|k| viewer.0.write_all(&frame(u8::from(k == 0), &[b' '; 300]))),
        // Numbers that are none of ours.
        (_, 9) => viewer.send("{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":4294967295,\"channelId\":1e18}]}"),
        _ => viewer.send(&subscribe_all()),
    };
    if random.below(2) == 0 {
        viewer.drain(Duration::from_secs(1));
    }
    viewer.vanish();
}
