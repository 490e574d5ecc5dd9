//! `cargo xtask fuzz`: inputs by the million for everything that reads files and messages from elsewhere.
//!
//! Seeds are changed at random, with a seed of the numbers, on the stable toolchain. An input whose answer is of a new
//! kind joins the seeds: what coverage is to other tools, the messages are here. A panic, more than a second of
//! processor time, or more memory than is allowed is a failure; the input is written to a file.

pub mod document;
mod mutate;
mod seeds;
mod target;
mod targets;

use crate::error::Failure;
use crate::terminal;
use cpu_time::{ProcessTime, ThreadTime};
use mutate::{Random, mutate};
use std::collections::BTreeSet;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use target::Target;
use targets::Subject;
use tribodyn_paper::{files, table};

/// Try inputs by the million on everything that reads files and messages from elsewhere.
#[derive(clap::Args)]
pub struct Arguments {
    /// Time for each target, s
    #[arg(long, default_value_t = 60, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    seconds: u64,
    /// Most inputs for each target
    #[arg(long, default_value_t = 10_000_000)]
    executions: u64,
    /// Only this target; may be repeated
    #[arg(long = "target", value_enum)]
    targets: Vec<Target>,
    /// Seed of the random numbers
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Write every input to a file before it is read: for one that ends the process
    #[arg(long)]
    trace: bool,
    /// Rewrite the table of docs/reliability.md
    #[arg(long)]
    write: bool,
}

/// Longest processor time for an input.
const SLOW: Duration = Duration::from_secs(1);
/// Processor time of the program after which an input counts as one that never ends: the wall's clock would blame it for
/// the work of others.
const HANGING: Duration = Duration::from_secs(60);
/// Most memory of the process, bytes.
const MEMORY: u64 = 512 << 20;
/// Most inputs that are kept for further changes.
const POOL: usize = 2000;
/// Longest of them, bytes, and most failures that are written.
const LONGEST_KEPT: usize = 20_000;
const WRITTEN: usize = 10;
/// Stack of the thread that reads, bytes: that of the threads of the standard library.
const STACK: usize = 2 << 20;

/// The outcome of a target.
#[derive(Debug, Clone, serde::Serialize)]
pub struct Tried {
    pub target: &'static str,
    pub executions: u64,
    pub seconds: f64,
    pub kinds: usize,
    pub panics: u64,
    pub slow: u64,
    pub slowest_s: f64,
    /// None where the system does not tell.
    pub memory_bytes: Option<u64>,
}

impl Tried {
    fn nothing(target: Target) -> Self {
        Self {
            target: target.name(),
            executions: 0,
            seconds: 0.0,
            kinds: 0,
            panics: 0,
            slow: 0,
            slowest_s: 0.0,
            memory_bytes: None,
        }
    }
}

impl Tried {
    fn failed(&self) -> bool {
        self.panics > 0 || self.slow > 0 || self.memory_bytes.is_some_and(|bytes| bytes > MEMORY)
    }
}

const HEAD: [&str; 9] =
    ["target", "inputs", "time, s", "inputs/s", "kinds of answers", "panics", "over 1 s", "longest, ms", "memory, MB"];

fn cells(all: &[Tried]) -> Vec<Vec<String>> {
    let one = |t: &Tried| {
        let memory = t.memory_bytes.map_or("–".to_owned(), |bytes| (bytes >> 20).to_string());
        vec![
            t.target.to_owned(),
            t.executions.to_string(),
            format!("{:.0}", t.seconds),
            format!("{:.0}", t.executions as f64 / t.seconds.max(1e-9)),
            t.kinds.to_string(),
            t.panics.to_string(),
            t.slow.to_string(),
            format!("{:.1}", 1e3 * t.slowest_s),
            memory,
        ]
    };
    all.iter().map(one).collect()
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let targets = if arguments.targets.is_empty() { &Target::ALL[..] } else { &arguments.targets };
    let folder = files::root().join("target/fuzz");
    // A panic is an answer here; its place is in the name of the file.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|info| PLACE.with_borrow_mut(|place| *place = info.to_string())));
    let tried = targets.iter().map(|&target| watched(arguments, target, &folder)).collect::<Result<Vec<_>, _>>();
    panic::set_hook(hook);
    let tried = tried?;
    terminal::print(&format!("\n{}", table::aligned(&HEAD, &cells(&tried))))?;
    if arguments.write {
        document::rewrite(&tried)?;
    }
    let findings: Vec<String> = tried
        .iter()
        .filter(|tried| tried.failed())
        .map(|t| format!("{}: {} panics, {} slow, inputs in {}", t.target, t.panics, t.slow, folder.display()))
        .collect();
    if findings.is_empty() { Ok(()) } else { Err(Failure::Check { what: "fuzz", findings }) }
}

thread_local! {
    /// The last panic of this thread.
    static PLACE: std::cell::RefCell<String> = const { std::cell::RefCell::new(String::new()) };
}

/// The input that is being read, and since when; none between two.
type Current = Arc<Mutex<Option<(Input, ProcessTime)>>>;
type Input = Arc<Vec<u8>>;

/// Runs a target in a thread of its own; an input that never ends is written and ends the program.
fn watched(arguments: &Arguments, target: Target, folder: &Path) -> Result<Tried, Failure> {
    let current: Current = Arc::default();
    let (shared, folder) = (Arc::clone(&current), folder.join(target.name()));
    let (limits, own) = ((arguments.seconds, arguments.executions, arguments.seed, arguments.trace), folder.clone());
    let worker = std::thread::Builder::new().stack_size(STACK).spawn(move || tried(target, limits, &own, &shared));
    let worker = worker.map_err(Failure::Print)?;
    while !worker.is_finished() {
        std::thread::sleep(Duration::from_millis(100));
        let now = current.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((input, since)) = now.as_ref()
            && since.elapsed() > HANGING
        {
            let path = save(&folder, "hanging", input)?;
            let finding = format!("{}: an input never ends: {}", target.name(), path.display());
            return Err(Failure::Check { what: "fuzz", findings: vec![finding] });
        }
    }
    worker.join().unwrap_or_else(|_| Err(Failure::Seed(format!("the target {} cannot be tried", target.name()))))
}

fn tried(
    target: Target,
    (seconds, executions, seed, trace): (u64, u64, u64, bool),
    folder: &Path,
    current: &Current,
) -> Result<Tried, Failure> {
    let mut pool: Vec<Input> = seeds::of(target)?.into_iter().map(Arc::new).collect();
    let mut subject = Subject::new(target)?;
    let mut random = Random::new(seed);
    let mut kinds = BTreeSet::new();
    let began = Instant::now();
    let mut done = Tried::nothing(target);
    forget_peak();
    let mut told = 0;
    while done.executions < executions && began.elapsed() < Duration::from_secs(seconds) {
        let input = next(&mut random, target, &pool, (done.executions, kinds.len()));
        if trace {
            save(folder, "current", &input)?;
        }
        *current.lock().unwrap_or_else(PoisonError::into_inner) = Some((Arc::clone(&input), ProcessTime::now()));
        let clock = ThreadTime::now();
        let answer = panic::catch_unwind(AssertUnwindSafe(|| subject.read(&input)));
        let time = clock.elapsed();
        *current.lock().unwrap_or_else(PoisonError::into_inner) = None;
        done.executions += 1;
        done.slowest_s = done.slowest_s.max(time.as_secs_f64());
        if time > SLOW {
            done.slow += 1;
            if done.slow as usize <= WRITTEN {
                save(folder, &format!("slow-{:.0}-ms", 1e3 * time.as_secs_f64()), &input)?;
            }
        }
        match answer {
            Ok(kind) => {
                if kinds.insert(kind) && pool.len() < POOL && input.len() <= LONGEST_KEPT {
                    pool.push(input);
                }
            }
            Err(_) => {
                done.panics += 1;
                if done.panics as usize <= WRITTEN {
                    let place = PLACE.take();
                    let path = save(folder, &format!("panic-{}", done.panics), &input)?;
                    terminal::progress(&format!("{}: {place}: {}", target.name(), path.display()));
                }
                // What was in the middle of a change is of no more use.
                subject = Subject::new(target)?;
            }
        }
        if began.elapsed().as_secs() / 60 > told {
            told += 1;
            terminal::progress(&format!("{}: {} inputs in {told} min", target.name(), done.executions));
        }
    }
    (done.seconds, done.kinds, done.memory_bytes) = (began.elapsed().as_secs_f64(), kinds.len(), peak());
    Ok(done)
}

/// The seeds as they are first, then changed ones.
fn next(random: &mut Random, target: Target, pool: &[Input], (executions, kinds): (u64, usize)) -> Input {
    let seed = usize::try_from(executions).ok().and_then(|at| pool.get(at)).filter(|_| kinds < pool.len());
    seed.cloned().unwrap_or_else(|| {
        let mut input = random.one_of(pool).to_vec();
        let other = random.one_of(pool);
        mutate(random, target.form(), &mut input, other);
        input.truncate(target.longest());
        Arc::new(input)
    })
}

fn save(folder: &Path, name: &str, input: &[u8]) -> Result<PathBuf, Failure> {
    let path = folder.join(name);
    files::write(&path, input)?;
    Ok(path)
}

/// Forgets the most memory that the process ever had, where the system can.
fn forget_peak() {
    // Elsewhere than on Linux there is no such file, and then no figure either.
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}

/// The most memory that the process had since, bytes.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok().map(|kilobytes| kilobytes << 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An input that once did harm, or could, is read by its target without a panic and in no time; so are some
    /// thousand changes.
    #[test]
    fn limit_the_kept_inputs_and_some_of_their_changes_do_no_harm() {
        for target in Target::ALL {
            let mut subject = Subject::new(target).unwrap();
            let kept = seeds::kept(target).unwrap();
            assert!(!kept.is_empty(), "{}", target.name());
            for input in &kept {
                let clock = ThreadTime::now();
                subject.read(input);
                assert!(clock.elapsed() < 5 * SLOW, "{}: {:?}", target.name(), String::from_utf8_lossy(input));
            }
            let mut random = Random::new(1);
            for _ in 0..300 {
                let mut input = random.one_of(&kept).clone();
                mutate(&mut random, target.form(), &mut input, &kept[0]);
                subject.read(&input);
            }
        }
    }

    #[test]
    fn identity_a_target_is_tried_and_counted() {
        let folder = std::env::temp_dir().join(format!("tribodyn-fuzz-test-{}", std::process::id()));
        let tried = tried(Target::Live, (60, 500, 1, false), &folder, &Current::default()).unwrap();
        assert!(tried.executions == 500 && tried.kinds >= 2 && !tried.failed(), "{tried:?}");
        assert!(!folder.exists());
    }
}
