//! `tribodyn run`: a transient run, recorded.

#[cfg(feature = "live")]
mod live;
mod outcome;
mod progress;

pub use progress::significant;

use crate::failure::Failure;
use crate::input::{CaseArguments, ReplaceArguments};
use crate::table;
use crate::units::in_unit;
use crate::waiting::Waiting;
use progress::Progress;
use signal_hook::consts::{SIGINT, SIGTERM};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tribodyn::CaseFile;
use tribodyn_study::StudyError;
use tribodyn_study::run::{Beginning, PreparedRun};

/// Run a bearing in time and record it.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn run 7210B.ron -o run.mcap --duration 0.05
  tribodyn run 7210B.ron -o run.mcap --resume
  tribodyn run 6206.ron -o skid.mcap --set 'ring.x.Force=N(50)'")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Recording to write (MCAP, opens in Foxglove); named RUN.mcap.active until it is complete
    #[arg(short, long, value_name = "RUN.mcap")]
    output: PathBuf,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Simulated time in s; short for --set transient.duration=s(…)
    #[arg(long, value_name = "SECONDS", value_parser = in_unit("s"))]
    duration: Option<f64>,
    /// Continue a stopped or killed run of the same case
    #[arg(long, conflicts_with = "restart")]
    resume: bool,
    /// Discard a stopped or killed run and start again
    #[arg(long)]
    restart: bool,
    /// Let viewers such as Foxglove watch over a WebSocket, on this machine only unless an address says otherwise
    #[cfg(feature = "live")]
    #[arg(long, value_name = "HOST:PORT", num_args = 0..=1, require_equals = true, default_missing_value = live::ADDRESS)]
    live: Option<String>,
    /// Accept viewers that use this host name, or pages of this host or origin; may be repeated
    #[cfg(feature = "live")]
    #[arg(long, value_name = "NAME", requires = "live")]
    live_allow: Vec<tribodyn_record::LiveName>,
    /// Show no progress
    #[arg(short, long)]
    quiet: bool,
    /// Print the summary as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.read()?;
    arguments.replace.check_recording(&arguments.output, &arguments.case.path, &file)?;
    let starting = Waiting::new(arguments.quiet, "solving for the start");
    let prepared = PreparedRun::new(&file, &arguments.output, arguments.beginning())?;
    drop(starting);
    #[cfg(feature = "live")]
    let viewers = arguments.live.as_deref().map(|address| live::start(address, &arguments.live_allow)).transpose()?;
    #[cfg(not(feature = "live"))]
    let viewers = None;
    let session = prepared.begin(viewers)?;
    // Until here nothing is lost by the end of the program, and a signal may do what it does.
    let stop = stop_flag()?;
    let progress = Progress::new(arguments.quiet, session.duration_s(), session.time_s());
    let outcome = session.complete(|time_s| {
        progress.show(time_s);
        if stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    drop(progress);
    let outcome = outcome?;
    if arguments.json {
        table::print_json(&outcome.report)?;
    } else {
        outcome::print(&outcome.report)?;
    }
    outcome.stopped.map_or(Ok(()), |stopped| {
        Err(Failure::Stopped { simulated_s: stopped.simulated_s, duration_s: stopped.duration_s })
    })
}

impl Arguments {
    /// The case with the changes of `--set` and `--duration`.
    fn read(&self) -> Result<CaseFile, StudyError> {
        self.case.read_with(&self.case.run_changes(self.duration)?)
    }

    fn beginning(&self) -> Beginning {
        match (self.resume, self.restart) {
            (true, _) => Beginning::Resume,
            (false, true) => Beginning::Restart,
            (false, false) => Beginning::New,
        }
    }
}

/// Set by the first interrupt or request to terminate; the second one ends the program at once.
pub fn stop_flag() -> Result<Arc<AtomicBool>, Failure> {
    let flag = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        signal_hook::flag::register_conditional_shutdown(signal, 1, Arc::clone(&flag)).map_err(Failure::Output)?;
        signal_hook::flag::register(signal, Arc::clone(&flag)).map_err(Failure::Output)?;
    }
    Ok(flag)
}
