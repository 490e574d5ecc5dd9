//! `/log` of a run: events as lines for people.
//!
//! Impacts and lost contacts come by the thousand. Of each kind one line is written for each millisecond in which
//! there were any: the hardest impact, the first contact lost or made, and how many more there were.

use crate::timeline::timestamp;
use crate::wire::foxglove::{Log, log::Level};
use serde::{Deserialize, Serialize};
use tribodyn_dynamics::{Event, EventKind};

/// Simulated time that shares one line of a kind, s.
pub(crate) const WINDOW_S: f64 = 1e-3;

/// The kind of the warnings of the state that a run starts from.
pub(crate) const START: &str = "start";

/// The kinds that are thinned out.
const KINDS: usize = 3;

/// Lines that wait for the end of their window.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Pending {
    windows: [Option<Window>; KINDS],
    impacts: u64,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Window {
    start_s: f64,
    event: Event,
    more: usize,
}

/// Which kind, and how strong one is among its kind; none for what is always written.
fn rank(kind: &EventKind) -> Option<(usize, f64)> {
    match kind {
        EventKind::Impact { closing_speed_m_s, .. } => Some((0, closing_speed_m_s.abs())),
        EventKind::ContactLost { .. } => Some((1, 0.0)),
        EventKind::ContactMade { .. } => Some((2, 0.0)),
        EventKind::CoatingThrough { .. } | EventKind::SpallPassed { .. } | EventKind::Warning { .. } => None,
    }
}

impl Pending {
    /// Impacts so far.
    pub(crate) fn impacts(&self) -> u64 {
        self.impacts
    }

    /// Events whose lines wait.
    pub(super) fn waiting(&self) -> usize {
        self.windows.iter().flatten().map(|window| window.more).max().unwrap_or(0)
    }

    /// Takes an event and returns its line if it is one that is always written.
    pub(crate) fn add(&mut self, event: &Event) -> Option<Log> {
        self.impacts += u64::from(matches!(event.kind, EventKind::Impact { .. }));
        let Some((kind, strength)) = rank(&event.kind) else {
            return Some(line(event, 0));
        };
        match &mut self.windows[kind] {
            Some(window) => {
                window.more += 1;
                if rank(&window.event.kind).is_some_and(|(_, strongest)| strength > strongest) {
                    window.event = event.clone();
                }
            }
            empty => *empty = Some(Window { start_s: event.time_s, event: event.clone(), more: 0 }),
        }
        None
    }

    /// The lines whose windows are over at a time; at the end of a run, all.
    pub(crate) fn due(&mut self, time_s: f64) -> impl Iterator<Item = Log> {
        let over = move |window: &mut Window| time_s >= window.start_s + WINDOW_S;
        self.windows
            .iter_mut()
            .filter_map(move |slot| slot.take_if(over))
            .map(|window| line(&window.event, window.more))
    }
}

/// A warning of the state that a run starts from.
pub(super) fn at_start(warning: &str, log_time: u64) -> Log {
    Log {
        timestamp: Some(timestamp(log_time)),
        level: Level::Warning.into(),
        message: warning.to_owned(),
        name: START.into(),
        ..Log::default()
    }
}

fn race(inner: bool) -> &'static str {
    if inner { "inner" } else { "outer" }
}

/// One line; `more` events of the kind had no line of their own.
fn line(event: &Event, more: usize) -> Log {
    let (name, level, text) = match &event.kind {
        EventKind::Impact { ball, azimuth_deg, closing_speed_m_s, ball_leads } => {
            let who = if *ball_leads { "ball pushes cage" } else { "cage pushes ball" };
            let azimuth = azimuth_deg.rem_euclid(360.0);
            let speed = closing_speed_m_s.abs();
            ("impact", Level::Info, format!("ball {ball} meets its pocket at {azimuth:.1}°, {speed:.3} m/s, {who}"))
        }
        EventKind::ContactLost { ball, inner, azimuth_deg } => {
            let azimuth = azimuth_deg.rem_euclid(360.0);
            ("contact-lost", Level::Info, format!("ball {ball} leaves the {} race at {azimuth:.1}°", race(*inner)))
        }
        EventKind::ContactMade { ball, inner, azimuth_deg } => {
            let azimuth = azimuth_deg.rem_euclid(360.0);
            ("contact-made", Level::Info, format!("ball {ball} meets the {} race at {azimuth:.1}°", race(*inner)))
        }
        EventKind::CoatingThrough { inner, azimuth_deg } => {
            let azimuth = azimuth_deg.rem_euclid(360.0);
            let text = format!("the coating of the {} race is worn through at {azimuth:.1}° of the ring", race(*inner));
            ("coating-through", Level::Warning, text)
        }
        EventKind::SpallPassed { ball, inner, of_ball, spall, entered_s, struck_s, left_s } => {
            let race = race(*inner);
            let passed = if *of_ball {
                format!("the {race} race has passed spall {spall} of balls, on ball {ball}")
            } else {
                format!("ball {ball} has passed spall {spall} of the {race} race")
            };
            let text = format!(
                "{passed}: over its first edge at {entered_s:.7} s, against the second at {struck_s:.7} s, over it at \
                 {left_s:.7} s"
            );
            ("spall-passed", Level::Info, text)
        }
        EventKind::Warning { message } => ("warning", Level::Warning, message.clone()),
    };
    let rest = match (more, name) {
        (0, _) => String::new(),
        (_, "impact") => format!(" (and {more} weaker within {} ms)", WINDOW_S * 1e3),
        _ => format!(" (and {more} more within {} ms)", WINDOW_S * 1e3),
    };
    Log {
        timestamp: Some(timestamp(crate::run::log_time(event.time_s))),
        level: level.into(),
        message: format!("t = {:.6} s: {text}{rest}", event.time_s),
        name: name.into(),
        ..Log::default()
    }
}
