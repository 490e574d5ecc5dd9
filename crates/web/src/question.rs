//! Questions of the page, as it writes them.

use serde::Deserialize;
use tribodyn::sheet::SheetQuestion;
use tribodyn::{AnswerError, CaseFile, Envelope, Given, Limits, NewCase, Ratings, Translation, find_bearing};

/// A question; numbers in the units of the form.
#[derive(Deserialize)]
#[serde(tag = "ask", rename_all = "kebab-case")]
pub(crate) enum Question {
    /// Bearings of the list whose designation begins so.
    Catalogue {
        /// Beginning of a designation.
        pattern: String,
    },
    /// The text of the case file.
    Case(Form),
    /// Answers that take milliseconds.
    Quick(Form),
    /// The usual model of the case.
    Full(Form),
    /// The steady orbit, whatever is usual.
    Orbit(Form),
    /// Faults in a measured signal.
    Vibration {
        /// The bearing, at the speed of its shaft.
        form: Form,
        /// The signal.
        signal: Signal,
    },
    /// Numbers over a load or a speed.
    Curve {
        /// The bearing.
        form: Form,
        /// The values along the curve.
        range: Range,
    },
}

/// A measured signal.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Signal {
    /// Samples, in any unit.
    pub samples: Vec<f64>,
    /// Samples a second, Hz.
    pub rate: f64,
}

/// Values along a curve.
#[derive(Deserialize, Clone, Copy)]
#[serde(deny_unknown_fields)]
pub(crate) struct Range {
    /// The load or speed that varies.
    pub over: Over,
    /// First value, N or r/min.
    pub from: f64,
    /// Last value.
    pub to: f64,
    /// Number of values.
    pub count: usize,
}

/// The load or speed that varies along a curve.
#[derive(Deserialize, Clone, Copy)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Over {
    Radial,
    Axial,
    Speed,
}

/// A bearing by its designation or by its numbers, loads and speed; what is absent is assumed.
#[derive(Deserialize, Clone, Default)]
#[serde(default)]
pub(crate) struct Form {
    pub designation: Option<String>,
    /// Nominal contact angle, degrees.
    pub angle: Option<f64>,
    /// Boundary dimensions, mm, of a bearing without designation.
    pub bore: Option<f64>,
    pub outside: Option<f64>,
    pub width: Option<f64>,
    /// Number and diameter (mm) of the balls.
    pub balls: Option<usize>,
    pub ball: Option<f64>,
    /// Load ratings, N.
    pub dynamic_rating: Option<f64>,
    pub static_rating: Option<f64>,
    /// Loads, N.
    pub radial: Option<f64>,
    pub axial: Option<f64>,
    /// Speed of the inner ring, r/min.
    pub speed: Option<f64>,
    /// By the words of `tribodyn new --lubricant`.
    pub lubricant: Option<String>,
}

impl Form {
    /// Name of the case in messages.
    pub fn name(&self) -> &str {
        self.designation.as_deref().unwrap_or("bearing")
    }

    /// The text of its case file.
    pub fn text(&self) -> Result<String, AnswerError> {
        let ratings = self.dynamic_rating.zip(self.static_rating);
        let case = self.bearing()?.given(Given {
            balls: self.balls,
            ball_mm: self.ball,
            ratings: ratings.map(|(dynamic, at_rest)| Ratings { dynamic, at_rest }),
            radial: self.radial,
            axial: self.axial,
            speed_rpm: self.speed,
            lubricant: Some(self.lubricant.clone().unwrap_or_else(|| "usual".to_owned())),
            ..Given::default()
        })?;
        Ok(case.text()?)
    }

    fn bearing(&self) -> Result<NewCase, AnswerError> {
        if let Some(designation) = &self.designation {
            return Ok(NewCase::of_listed(find_bearing(designation, self.angle)?, designation));
        }
        let size = |name: &'static str, value: Option<f64>| {
            value.ok_or_else(|| AnswerError::argument(name, "nothing", "allowed is a length in mm, or a designation"))
        };
        let [bore, outside, width] =
            [size("bore", self.bore)?, size("outside", self.outside)?, size("width", self.width)?].map(|mm| mm * 1e-3);
        Ok(NewCase::new(Envelope { bore, outside, width, contact_angle: self.angle.unwrap_or(0.0).to_radians() }))
    }

    /// The case that it makes.
    pub fn case(&self) -> Result<CaseFile, AnswerError> {
        CaseFile::from_text(self.name(), self.text()?, &[], &Limits::NORMAL)
    }
}

/// Loads and speed of a case whose ring is loaded by forces.
pub(crate) fn operation(file: &CaseFile) -> SheetQuestion {
    let force = |along: &Translation| if let Translation::Force(force) = along { *force } else { 0.0 };
    SheetQuestion {
        radial: force(&file.case.ring.x),
        axial: force(&file.case.ring.z),
        speed: file.case.operating_point().inner_speed,
    }
}
