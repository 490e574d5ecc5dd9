//! Data of the interactive figures of `report.html`.
//!
//! Each is beside a static figure of the same name, which the page's script replaces. Columns of numbers are `f32`,
//! least significant byte first, in base64; columns that are equal are there once.

use serde::Serialize;
use tribodyn_plot::{Axis, History};

/// Most points of a line. A longer line has the least and greatest value of each of half as many parts.
const MOST_POINTS: usize = 1 << 14;

/// The interactive figures of a page.
#[derive(Debug, Default, Serialize)]
pub struct Live {
    columns: Vec<String>,
    charts: Vec<Chart>,
}

/// An interactive figure before its data are packed.
pub struct Plan<'a> {
    /// Name of the static figure.
    pub name: &'a str,
    pub title: &'a str,
    pub kind: Kind,
    pub abscissa: Axis,
    /// Panels over one abscissa: that of the first line.
    pub panels: &'a [History<'a>],
    /// Ranges of the abscissa with a button each; the first is what the figure opens with.
    pub views: Vec<View>,
    pub marks: Vec<LiveMark>,
    /// Frequency of order 1, Hz; spectra only.
    pub shaft_hz: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Over time; all of them are zoomed together.
    History,
    /// Logarithmic ordinates.
    Spectrum,
    /// Over the azimuth; opens with the static, polar figure.
    Orbit,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct View {
    pub name: String,
    pub from: f64,
    pub to: f64,
}

/// A marked abscissa.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveMark {
    /// Marks of one family are shown or hidden together.
    pub family: &'static str,
    pub label: String,
    pub at: f64,
}

#[derive(Debug, Serialize)]
struct Chart {
    name: String,
    title: String,
    kind: Kind,
    x: usize,
    label: String,
    unit: String,
    views: Vec<View>,
    /// Samples of a line in the recording.
    samples: usize,
    /// Samples of which the least and greatest are shown; 1 where all are.
    each: usize,
    panels: Vec<Panel>,
    marks: Vec<LiveMark>,
    shaft_hz: Option<f64>,
}

#[derive(Debug, Serialize)]
struct Panel {
    title: String,
    label: String,
    unit: String,
    /// Range that the ordinate covers at least.
    #[serde(skip_serializing_if = "Option::is_none")]
    cover: Option<(f64, f64)>,
    lines: Vec<Line>,
}

#[derive(Debug, Serialize)]
struct Line {
    label: String,
    y: usize,
}

impl Live {
    /// Adds a figure; one without lines is left out.
    pub fn add(&mut self, plan: Plan) {
        let Some(x) = plan.panels.iter().flat_map(|panel| &panel.samples).map(|s| s.x).next() else { return };
        let each = samples_each(x.len());
        let at = self.column(&abscissas(x, each));
        let mut panels = Vec::with_capacity(plan.panels.len());
        for panel in plan.panels {
            let mut lines = Vec::with_capacity(panel.samples.len());
            for line in &panel.samples {
                lines.push(Line { label: line.label.to_owned(), y: self.column(&extremes(line.y, each)) });
            }
            let (label, unit) = (panel.quantity.label.clone(), panel.quantity.unit.clone());
            let cover = panel.quantity.at_least;
            panels.push(Panel { title: panel.title.to_owned(), label, unit, cover, lines });
        }
        self.charts.push(Chart {
            name: plan.name.to_owned(),
            title: plan.title.to_owned(),
            kind: plan.kind,
            x: at,
            label: plan.abscissa.label,
            unit: plan.abscissa.unit,
            views: plan.views,
            samples: x.len(),
            each,
            panels,
            marks: plan.marks,
            shaft_hz: plan.shaft_hz,
        });
    }

    pub fn is_empty(&self) -> bool {
        self.charts.is_empty()
    }

    /// JSON that may stand in a `script` element.
    pub fn json(&self) -> Result<String, serde_json::Error> {
        Ok(serde_json::to_string(self)?.replace('<', "\\u003c"))
    }

    fn column(&mut self, values: &[f64]) -> usize {
        let packed = base64(&values.iter().flat_map(|v| (*v as f32).to_le_bytes()).collect::<Vec<u8>>());
        self.columns.iter().position(|known| *known == packed).unwrap_or_else(|| {
            self.columns.push(packed);
            self.columns.len() - 1
        })
    }
}

/// Samples of a part of a line of `count` samples.
fn samples_each(count: usize) -> usize {
    if count <= MOST_POINTS { 1 } else { count.div_ceil(MOST_POINTS / 2) }
}

/// Where the two values of each part are drawn: at its first sample and at its middle.
fn abscissas(x: &[f64], each: usize) -> Vec<f64> {
    if each == 1 {
        return x.to_vec();
    }
    x.chunks(each).flat_map(|part| [part[0], part[part.len() / 2]]).collect()
}

/// The least and the greatest value of each part, in the order in which they occur.
fn extremes(y: &[f64], each: usize) -> Vec<f64> {
    if each == 1 {
        return y.to_vec();
    }
    let pair = |part: &[f64]| {
        let place = |better: fn(f64, f64) -> bool| {
            (1..part.len()).fold(0, |best, k| if better(part[k], part[best]) { k } else { best })
        };
        let (least, greatest) = (place(|a, b| a < b), place(|a, b| a > b));
        [part[least.min(greatest)], part[least.max(greatest)]]
    };
    y.chunks(each).flat_map(pair).collect()
}

/// RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let byte = |k: usize| group.get(k).copied().map_or(0, usize::from);
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for k in 0..4 {
            let digit = char::from(DIGITS[bits >> (18 - 6 * k) & 63]);
            text.push(if k <= group.len() { digit } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_plot::Samples;

    #[test]
    fn paper_base64_of_rfc_4648_section_10() {
        let vectors = [("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("foobar", "Zm9vYmFy")];
        for (plain, packed) in vectors {
            assert_eq!(base64(plain.as_bytes()), packed);
        }
    }

    #[test]
    fn identity_every_peak_of_a_long_line_is_shown() {
        let count = 5 * MOST_POINTS + 3;
        let y: Vec<f64> = (0..count).map(|k| if k == 70_001 { 9.0 } else { (0.01 * k as f64).sin() }).collect();
        let x: Vec<f64> = (0..count).map(|k| 1e-4 * k as f64).collect();
        let each = samples_each(count);
        let (shown_x, shown_y) = (abscissas(&x, each), extremes(&y, each));
        assert!(shown_y.len() <= MOST_POINTS && shown_x.len() == shown_y.len(), "{}", shown_y.len());
        assert!(shown_x.windows(2).all(|pair| pair[0] <= pair[1]));
        let most = |values: &[f64]| values.iter().copied().fold(f64::MIN, f64::max);
        assert_eq!((most(&shown_y), most(&y)), (9.0, 9.0));
        let place = shown_y.iter().position(|v| *v == 9.0).unwrap();
        assert!((shown_x[place] - x[70_001]).abs() <= 1e-4 * each as f64);
    }

    #[test]
    fn limit_short_lines_are_whole_and_equal_columns_are_there_once() {
        assert_eq!(samples_each(MOST_POINTS), 1);
        let (x, y) = ([0.0, 1.0], [2.0, 3.0]);
        let line = |label| Samples { label, x: &x, y: &y };
        let panels = [History { title: "<t>", quantity: Axis::new("q", "N"), samples: vec![line("a"), line("b")] }];
        let mut live = Live::default();
        live.add(Plan {
            name: "n",
            title: "T",
            kind: Kind::History,
            abscissa: Axis::new("Time", "s"),
            panels: &panels,
            views: Vec::new(),
            marks: Vec::new(),
            shaft_hz: None,
        });
        assert_eq!(live.columns.len(), 2);
        let json = live.json().unwrap();
        assert!(!json.contains('<') && json.contains("\\u003ct>"), "{json}");
    }
}
