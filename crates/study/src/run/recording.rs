//! The recorder of a run on a thread of its own: encoding, compression, viewers and checkpoints wait for nothing that
//! the solver does, and the solver not for them, unless the queue between them is full.
//!
//! All goes through one queue, in order. The recorder makes the same bytes as on the thread of the solver, and a
//! checkpoint is written when the recorder has all that the checkpoint counts on.

use super::checkpoint::Saved;
use super::tape::Tape;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::{Builder, JoinHandle};
use tribodyn_bearing::BallResult;
use tribodyn_dynamics::{BallDetail, Checkpoint, Event, Observer, Sample};
use tribodyn_record::{Overview, RecordError, RunRecorder};

/// The recorder that the thread works on.
pub(super) type Recorder = RunRecorder<Tape>;

/// Balls of all samples that go over at once: waking the other thread costs as much as taking some samples.
const BALLS_AT_ONCE: usize = 2048;
/// Such loads that wait at the most; with those that are made and worked on some 3 MB.
const WAITING: usize = 4;

/// An item of the queue.
enum Item {
    /// With its balls where they are recorded.
    Sample(Box<Overview>, Option<Vec<BallResult>>),
    Event(Event),
    /// State of the run at a time, s.
    Save(Box<Checkpoint>, f64),
}

/// Room of samples that have been recorded, to be filled again: one thread would else free what the other allocates.
#[derive(Default)]
struct Spare {
    #[allow(clippy::vec_box)] // they go to and fro, and lie still
    overviews: Vec<Box<Overview>>,
    lists: Vec<Vec<BallResult>>,
}

/// Why nothing is recorded any more, and the simulated time of what could not be, s.
pub(super) struct Failed {
    pub simulated_s: f64,
    pub reason: Reason,
}

/// The error that stopped the recording.
pub(super) enum Reason {
    Recording(RecordError),
    Checkpoint(std::io::Error),
}

/// Where checkpoints go, and the case that they belong to.
pub(super) struct Keeper {
    pub checkpoint: PathBuf,
    pub case_text: String,
}

impl Keeper {
    /// Writes a checkpoint of a run at a time, s, at which the recorder stands.
    pub fn save(&self, recorder: &Recorder, run: Checkpoint, simulated_s: f64) -> Result<(), Failed> {
        let saved = Saved::new(&self.case_text, (simulated_s, run), recorder);
        saved.write(&self.checkpoint).map_err(|error| Failed { simulated_s, reason: Reason::Checkpoint(error) })
    }
}

/// The near end of the queue.
pub(super) struct Recording {
    /// None once the recorder is back.
    queue: Option<SyncSender<Vec<Item>>>,
    load: Vec<Item>,
    /// Balls in that load.
    balls: usize,
    /// Room that came back.
    spare: Spare,
    back: Receiver<Spare>,
    failed: Arc<AtomicBool>,
    worker: Option<JoinHandle<Result<Recorder, Failed>>>,
}

impl Recording {
    /// Moves a recorder to a thread of its own.
    pub fn start(recorder: Recorder, keeper: Keeper) -> std::io::Result<Self> {
        let (queue, items) = sync_channel(WAITING);
        let (done, back) = channel();
        let failed = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&failed);
        let worker = Builder::new().name("recording".to_owned()).spawn(move || {
            let recorded = record(recorder, (&items, &done), &keeper);
            flag.store(recorded.is_err(), Ordering::Release);
            recorded
        })?;
        Ok(Self {
            queue: Some(queue),
            load: Vec::new(),
            balls: 0,
            spare: Spare::default(),
            back,
            failed,
            worker: Some(worker),
        })
    }

    /// True once something could not be recorded: [`Self::end`] says what.
    pub fn has_failed(&self) -> bool {
        self.failed.load(Ordering::Acquire)
    }

    /// Has a checkpoint written of a run at a time, s, and all that was recorded before.
    pub fn save(&mut self, run: Checkpoint, simulated_s: f64) {
        self.load.push(Item::Save(Box::new(run), simulated_s));
        self.hand_over();
    }

    /// Lets the recorder have all up to here; waits where it is behind.
    pub fn hand_over(&mut self) {
        self.balls = 0;
        if self.load.is_empty() {
            return;
        }
        let next = Vec::with_capacity(self.load.len());
        let load = std::mem::replace(&mut self.load, next);
        for Spare { overviews, lists } in self.back.try_iter() {
            self.spare.overviews.extend(overviews);
            self.spare.lists.extend(lists);
        }
        if let Some(queue) = &self.queue {
            // A recorder that does not listen any more has failed and says so at the end.
            let _ = queue.send(load);
        }
    }

    /// The recorder, once it has recorded everything.
    pub fn end(mut self) -> Result<Recorder, Failed> {
        self.hand_over();
        self.queue = None;
        let worker = self.worker.take().unwrap_or_else(|| unreachable!("the recorder is fetched once"));
        worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    }
}

impl Drop for Recording {
    /// The recorder has closed its files when the lock on them is let go.
    fn drop(&mut self) {
        self.queue = None;
        if let Some(worker) = self.worker.take() {
            // What it found is of no use to anybody any more.
            let _ = worker.join();
        }
    }
}

impl Observer for Recording {
    type Error = std::convert::Infallible;

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, Self::Error> {
        let overview = match self.spare.overviews.pop() {
            Some(mut spare) => {
                spare.take(sample);
                spare
            }
            None => Box::new(Overview::of(sample)),
        };
        let balls = with_balls.then(|| {
            let mut balls = self.spare.lists.pop().unwrap_or_default();
            balls.clone_from(&sample.balls);
            balls
        });
        self.load.push(Item::Sample(overview, balls));
        self.balls += sample.balls.len();
        if self.balls >= BALLS_AT_ONCE {
            self.hand_over();
        }
        Ok(ControlFlow::Continue(()))
    }

    fn between(&self) -> BallDetail {
        Overview::DETAIL
    }

    fn event(&mut self, event: &Event) -> Result<(), Self::Error> {
        self.load.push(Item::Event(event.clone()));
        Ok(())
    }
}

/// Takes what comes over the queue until it ends, and gives back what it came in.
fn record(
    mut recorder: Recorder,
    (loads, back): (&Receiver<Vec<Item>>, &Sender<Spare>),
    keeper: &Keeper,
) -> Result<Recorder, Failed> {
    for load in loads {
        let mut done = Spare { overviews: Vec::with_capacity(load.len()), lists: Vec::new() };
        for item in load {
            let (simulated_s, taken) = match item {
                Item::Sample(overview, mut balls) => {
                    let taken = recorder.record(&overview, balls.as_deref_mut());
                    let time_s = overview.time_s();
                    done.overviews.push(overview);
                    done.lists.extend(balls);
                    (time_s, taken)
                }
                Item::Event(event) => (event.time_s, recorder.event(&event)),
                Item::Save(run, simulated_s) => {
                    keeper.save(&recorder, *run, simulated_s)?;
                    continue;
                }
            };
            taken.map_err(|error| Failed { simulated_s, reason: Reason::Recording(error) })?;
        }
        // A run that is over does not listen any more.
        let _ = back.send(done);
    }
    Ok(recorder)
}

#[cfg(test)]
mod tests {
    use super::super::checkpoint::Files;
    use super::*;
    use crate::read_case;
    use tribodyn::{CaseFile, Change, Limits};
    use tribodyn_dynamics::Run;
    use tribodyn_record::{RunRecording, read_summary};

    const CASE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/cases/paper-ag.ron");

    fn case() -> CaseFile {
        let changes = [
            ("transient.duration", "ms(12)"),
            ("transient.scheme", "Fast(step: us(20))"),
            ("traction.patch", "SplitStrip(across: 5, along: 3)"),
        ];
        let changes = changes.map(|(path, value)| Change::new(format!("--set {path}"), path, value));
        read_case(CASE.as_ref(), &changes, &Limits::NORMAL).unwrap()
    }

    fn recorder(file: &CaseFile, files: &Files) -> Recorder {
        let tape = Tape::create(&files.recording, &file.case, None).unwrap();
        let inputs = &file.run_inputs().unwrap();
        RunRecorder::new(tape, &RunRecording::new(&file.text, &file.case.name, inputs, "test")).unwrap()
    }

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("tribodyn-recording-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn identity_one_thread_and_two_write_the_same_bytes() {
        let (file, folder) = (case(), folder("bytes"));
        let run = || Run::new(file.run_inputs().unwrap()).unwrap();
        let one = Files::new(&folder.join("one.mcap"));
        let mut alone = recorder(&file, &one);
        let mut first = run();
        for k in 1..=12 {
            let _ = first.advance(1e-3 * f64::from(k), &mut alone).unwrap();
        }
        alone.finish().unwrap();
        let two = Files::new(&folder.join("two.mcap"));
        let keeper = Keeper { checkpoint: two.checkpoint.clone(), case_text: file.text.clone() };
        let mut aside = Recording::start(recorder(&file, &two), keeper).unwrap();
        // Handed over in pieces of any length, with a checkpoint in between.
        let mut second = run();
        for k in 1..=12 {
            let _ = second.advance(1e-3 * f64::from(k), &mut aside).unwrap();
            aside.hand_over();
            if k == 5 {
                aside.save(second.checkpoint(), second.time());
            }
        }
        let recorder = aside.end().unwrap_or_else(|_| panic!("the disk is there"));
        // The checkpoint counts on what had been recorded by then, no more.
        let saved = Saved::read(&two.checkpoint, &file.text).unwrap();
        let (safe, loose) = recorder.sink().state();
        let counted = saved.safe_messages + saved.loose_messages.len() as u64;
        assert!(saved.simulated_s < 0.0051 && 0 < counted && counted < safe + loose.len() as u64, "{counted}");
        let tally = recorder.finish().unwrap();
        assert!(tally.states.summary(None, Vec::new()).is_some());
        let bytes = [&one, &two].map(|files| std::fs::read(&files.recording).unwrap());
        let messages = read_summary(&two.recording).unwrap().messages;
        assert!(messages > 300, "{messages}");
        assert!(bytes[0] == bytes[1], "{:?}", bytes.map(|b| b.len()));
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn limit_what_cannot_be_saved_is_known_at_the_next_step() {
        let (file, folder) = (case(), folder("failed"));
        let files = Files::new(&folder.join("run.mcap"));
        let keeper = Keeper { checkpoint: folder.join("missing/checkpoint"), case_text: file.text.clone() };
        let mut aside = Recording::start(recorder(&file, &files), keeper).unwrap();
        let mut run = Run::new(file.run_inputs().unwrap()).unwrap();
        let _ = run.advance(2e-4, &mut aside).unwrap();
        let saved_at = run.time();
        aside.save(run.checkpoint(), saved_at);
        let began = std::time::Instant::now();
        while !aside.has_failed() && began.elapsed().as_secs() < 60 {
            std::thread::yield_now();
        }
        assert!(aside.has_failed());
        // Whatever comes after it is taken and dropped.
        let _ = run.advance(1e-2, &mut aside).unwrap();
        let Err(Failed { simulated_s, reason: Reason::Checkpoint(error) }) = aside.end() else { panic!("it failed") };
        assert_eq!((simulated_s, error.kind()), (saved_at, std::io::ErrorKind::NotFound));
        std::fs::remove_dir_all(folder).unwrap();
    }
}
