//! The Foxglove layout that travels with a recording: a picture and a log at the left, tabs with plots at the right.
//!
//! It is the form that "Import from file" takes. What depends on the bearing is the distance of the camera, the number
//! of balls and the band of the spectra. At most eight panels are seen at a time; legends stand beside their plots,
//! since floating ones hide half of a small plot.

mod balls;
mod panels;
mod tabs;

use crate::mesh;
use panels::Panel;
pub(crate) use panels::round_up;
use serde_json::{Map, Value, json};
use tribodyn_bearing::{Geometry, Races, Side, SpeedHistory};
use tribodyn_signal::BearingFrequencies;

/// Kind of recording that a layout is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayoutKind {
    /// A transient run.
    Run,
    /// One orbit of a quasi-static solution.
    Solution,
}

/// The layout of the recordings of a bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    kind: LayoutKind,
    title: String,
    ball_count: usize,
    outside_diameter_m: f64,
    /// Upper end of the spectra that are shown near zero, Hz.
    band_hz: f64,
}

/// Camera distance over the outside diameter: bearing, scales and axes fill the panel.
const CAMERA_OVER_DIAMETER: f64 = 2.3;
/// The band of the spectra over the frequency of balls passing the inner race: three harmonics and what is around them.
const BAND_OVER_BALL_PASS: f64 = 4.0;

impl Layout {
    /// For any bearing: the camera at one of 215 mm outside diameter, 13 balls, spectra up to 5 kHz.
    pub fn general(kind: LayoutKind) -> Self {
        Self { kind, title: "Bearing".to_owned(), ball_count: 13, outside_diameter_m: 0.215, band_hz: 5000.0 }
    }

    /// For a bearing with a name and the speeds of its rings.
    pub fn new(kind: LayoutKind, name: &str, geometry: &Geometry, speeds: &Races<SpeedHistory>) -> Self {
        let general = Self::general(kind);
        let Races { inner, outer } = speeds.each_ref().map(highest);
        let frequencies = BearingFrequencies::from_geometry(
            geometry.ball_count,
            geometry.ball_diameter,
            geometry.pitch_diameter,
            geometry.contact_angle(),
            inner,
            outer,
        );
        let ball_pass = frequencies.map_or(0.0, |f| f.ball_pass_inner_hz.max(f.ball_pass_outer_hz));
        let band_hz = if ball_pass > 0.0 { panels::round_up(BAND_OVER_BALL_PASS * ball_pass) } else { general.band_hz };
        Self {
            kind,
            title: name.to_owned(),
            ball_count: geometry.ball_count,
            outside_diameter_m: 2.0 * mesh::back_radius(geometry, Side::Outer),
            band_hz,
        }
    }

    /// The layout as a file.
    pub fn json(&self) -> String {
        let tabs = match self.kind {
            LayoutKind::Run => tabs::of_run(self),
            LayoutKind::Solution => tabs::of_solution(self),
        };
        let picture = panels::picture(&self.title, CAMERA_OVER_DIAMETER * self.outside_diameter_m);
        let log = panels::log();
        let mut panels = Map::new();
        let mut pages = Vec::new();
        let left = split("column", picture.id(), log.id(), 78);
        let layout = split("row", &left, &json!("Tab!main"), 46);
        for tab in tabs {
            pages.push(json!({ "title": tab.title, "layout": rows(&tab.rows) }));
            panels.extend(tab.rows.into_iter().flatten().map(Panel::into_entry));
        }
        panels.extend([picture, log].map(Panel::into_entry));
        panels.insert("Tab!main".to_owned(), json!({ "activeTabIdx": 0, "tabs": pages }));
        let whole = json!({
            "configById": panels,
            "globalVariables": {},
            "userNodes": {},
            // A shaft at 14 000 r/min turns twice in a second of the viewer.
            "playbackConfig": { "speed": 0.01 },
            "layout": layout,
        });
        format!("{whole:#}\n")
    }
}

/// The speed of the highest magnitude, rad/s.
fn highest(speed: &SpeedHistory) -> f64 {
    match speed {
        SpeedHistory::Constant(value) => *value,
        SpeedHistory::Table(rows) => {
            rows.iter().map(|row| row.1).max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0)
        }
    }
}

/// A page of panels, row by row.
struct Tab {
    title: &'static str,
    rows: Vec<Vec<Panel>>,
}

fn split(direction: &str, first: &Value, second: &Value, percentage: usize) -> Value {
    json!({ "direction": direction, "first": first, "second": second, "splitPercentage": percentage })
}

/// Parts of equal size, one after the other.
fn evenly(direction: &str, parts: &[Value]) -> Value {
    match parts {
        [] => Value::Null,
        [one] => one.clone(),
        [first, rest @ ..] => split(direction, first, &evenly(direction, rest), 100 / parts.len()),
    }
}

fn rows(rows: &[Vec<Panel>]) -> Value {
    let row = |row: &Vec<Panel>| evenly("row", &row.iter().map(|panel| panel.id().clone()).collect::<Vec<_>>());
    evenly("column", &rows.iter().map(row).collect::<Vec<_>>())
}
