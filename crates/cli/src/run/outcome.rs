//! The answer of `tribodyn run`: the summary of the recording, and what only the solver knows.

use super::RunError;
use super::progress::significant;
use super::summary::{Summary, acceleration, carries_accelerations, imbalance};
use super::warnings::{self, Tested};
use crate::failure::Failure;
use crate::table::{self, number};
use serde::Serialize;
use std::path::{Path, PathBuf};
use tribodyn_bearing::case::Case;
use tribodyn_dynamics::{Run, Statistics, Stiffness};
use tribodyn_record::{RecordError, RunItem, RunReader};
use tribodyn_study::CaseFile;

pub struct Outcome {
    pub report: Report,
    /// Where the run was stopped before its end.
    pub stopped: Option<RunError>,
}

/// What `--json` prints.
#[derive(Debug, Serialize)]
pub struct Report {
    case: String,
    bearing: String,
    recording: PathBuf,
    duration_s: f64,
    /// Wall time of this part of the run.
    wall_s: f64,
    simulated_per_wall: f64,
    cage_speed_quasi_static_rpm: f64,
    patch_rule: String,
    /// Of the quasi-static solution, over the contact load.
    patch_error_estimate: Option<f64>,
    /// Whether that error is small enough for accelerations.
    accelerations_supported: bool,
    scheme: String,
    scheme_statistics: Statistics,
    stiffness: Stiffness,
    #[serde(flatten)]
    summary: Option<Summary>,
    /// Of the quasi-static solution from which the run starts.
    warnings_at_start: Vec<String>,
    /// Races whose pressures left the range in which the coating was tested.
    untested_pressures: Vec<String>,
}

impl Report {
    /// What the solver knows at the end of a run.
    pub fn begin(run: &Run, file: &CaseFile, wall_s: f64) -> Self {
        let solution = run.solution();
        Self {
            case: file.name.clone(),
            bearing: file.case.name.clone(),
            recording: PathBuf::new(),
            duration_s: run.duration(),
            wall_s,
            simulated_per_wall: 0.0,
            cage_speed_quasi_static_rpm: solution.cage_speed_rpm,
            patch_rule: format!("{:?}", run.patch_rule()),
            patch_error_estimate: solution.patch_error_estimate,
            accelerations_supported: carries_accelerations(solution.patch_error_estimate),
            scheme: file.case.transient.as_ref().map_or_else(String::new, |t| format!("{:?}", t.scheme)),
            scheme_statistics: run.statistics(),
            stiffness: run.stiffness(),
            summary: None,
            warnings_at_start: warnings::at_start(solution.warnings.clone()),
            untested_pressures: Vec::new(),
        }
    }

    /// Reads the rest from the recording, which shows that it can be read.
    pub fn complete(mut self, recording: &Path, case: &Case, from_s: f64) -> Result<Self, Failure> {
        let (mut states, mut wear, mut log) = (Vec::new(), None, Vec::new());
        let mut races = Tested::of(case);
        for item in RunReader::open(recording)? {
            match item? {
                RunItem::Balls(_, balls) => races.iter_mut().for_each(|race| race.add(&balls)),
                RunItem::State(row) => states.push(row),
                RunItem::Wear(row) => wear = Some(row),
                RunItem::Log(row) => log.push(row),
                _ => {}
            }
        }
        let nothing = || RecordError::NothingToRecover { path: recording.to_owned() };
        let summary = Summary::of(&states, wear.as_ref(), &log).ok_or_else(nothing)?.judged(case);
        self.simulated_per_wall = (summary.simulated_s - from_s) / self.wall_s;
        self.summary = Some(summary);
        self.untested_pressures = races.iter().filter_map(Tested::warning).collect();
        self.recording = recording.to_owned();
        Ok(self)
    }
}

impl Outcome {
    pub fn print(&self) -> Result<(), Failure> {
        let r = &self.report;
        table::print_line(&table::visible(&format!("{}: {}", r.case, r.bearing)))?;
        table::print_line("")?;
        let mut rows = Vec::new();
        if let Some(summary) = &r.summary {
            rows.extend(motion_rows(summary, r));
            rows.extend(power_rows(summary));
            rows.extend(wear_rows(summary));
        }
        rows.extend(solver_rows(r));
        table::print_pairs(&rows)?;
        table::print_line(&format!("\nscheme      {}\npatch rule  {}", r.scheme, r.patch_rule))?;
        let of_run = r.summary.iter().flat_map(|summary| &summary.warnings);
        let all = r.warnings_at_start.iter().chain(&r.untested_pressures).chain(of_run);
        for warning in warnings::shown(&all.cloned().collect::<Vec<_>>()) {
            table::print_line(&format!("warning: {warning}"))?;
        }
        table::print_line(&format!("recording: {}", r.recording.display()))
    }
}

type Row = (&'static str, String, &'static str);

fn pair(a: f64, b: f64, digits: usize) -> String {
    format!("{}  {}", number(a, digits), number(b, digits))
}

fn motion_rows(s: &Summary, r: &Report) -> Vec<Row> {
    let of = |x: f64, y: f64| acceleration(pair(x, y, 3), r.accelerations_supported);
    let (rms, rms_unit) = of(s.outer_acceleration_x_rms_m_s2, s.outer_acceleration_y_rms_m_s2);
    let (peak, peak_unit) = of(s.outer_acceleration_x_peak_m_s2, s.outer_acceleration_y_peak_m_s2);
    vec![
        ("simulated time", number(s.simulated_s, 6), "s"),
        ("times real time", significant(r.simulated_per_wall), ""),
        ("cage speed, quasi-static start", number(r.cage_speed_quasi_static_rpm, 3), "r/min"),
        ("cage speed, mean of last half", number(s.cage_speed_mean_rpm, 3), "r/min"),
        ("orbital speeds, least and most", pair(s.orbital_speed_min_rpm, s.orbital_speed_max_rpm, 2), "r/min"),
        ("outer ring acceleration, rms x y", rms, rms_unit),
        ("outer ring acceleration, peak x y", peak, peak_unit),
        ("peak pressure, inner outer", pair(s.pressure_inner_max_gpa, s.pressure_outer_max_gpa, 3), "GPa"),
        ("pocket force, largest", number(s.pocket_force_max_n, 1), "N"),
        ("pocket impacts, whole run", s.impacts.to_string(), ""),
    ]
}

fn power_rows(s: &Summary) -> Vec<Row> {
    let p = &s.power;
    let mut rows = vec![("power in: shaft", number(p.shaft_w, 1), "W"), ("power in: loads", number(p.load_w, 1), "W")];
    rows.extend(p.out().map(|(name, value)| (name, number(value, 1), "W")));
    rows.push(("imbalance of all work done", imbalance(p.imbalance_percent), "%"));
    rows
}

fn wear_rows(s: &Summary) -> Vec<Row> {
    let w = &s.wear;
    vec![
        ("coating left, inner outer", pair(w.coating_inner_min_um, w.coating_outer_min_um, 4), "µm"),
        ("worn off, inner outer", pair(w.volume_inner_um3, w.volume_outer_um3, 0), "µm³"),
        ("worn off, cage", number(w.volume_cage_um3, 0), "µm³"),
    ]
}

fn solver_rows(r: &Report) -> Vec<Row> {
    let c = &r.scheme_statistics;
    let mut rows = vec![
        ("steps kept", c.steps.to_string(), ""),
        ("steps rejected", c.rejected.to_string(), ""),
        ("steps cut at pockets", c.cut_at_pocket.to_string(), ""),
        ("evaluations of all forces", c.evaluations.to_string(), ""),
        ("longest stable fixed step", number(r.stiffness.runge_kutta_step_s * 1e6, 2), "µs"),
    ];
    if let Some(error) = r.patch_error_estimate {
        rows.push(("patch error estimate (of load)", format!("{error:.1e}"), ""));
    }
    rows
}
