//! A complete case from what a catalogue has: every value with its source, and every assumption marked as one.

mod fits;
mod lubricant;
mod numbers;
mod sections;

use crate::{BallSet, CatalogueError, ClearanceGroup, Envelope, KnownBalls, ListedBearing, Origin, Part, Ratings};
pub use fits::Fits;
pub use lubricant::NewLubricant;
use numbers::Numbers;
use std::f64::consts::PI;
use tribodyn_rating::RatingError;

/// Known data of a bearing that a case is made for, SI.
#[derive(Debug, Clone, PartialEq)]
pub struct NewCase {
    /// Designation, for the title.
    pub designation: Option<String>,
    /// Boundary dimensions and nominal contact angle.
    pub envelope: Envelope,
    /// Load ratings, where known.
    pub ratings: Option<Ratings>,
    /// Catalogue of dimensions and ratings; none where they were given.
    pub source: Option<&'static str>,
    /// Number and diameter of the balls, where known.
    pub balls: KnownBalls,
    /// Group of radial internal clearance of a deep-groove bearing; the normal one where it is not known.
    pub clearance: Option<ClearanceGroup>,
    /// True for balls of silicon nitride.
    pub ceramic_balls: bool,
    /// Parts of the designation besides the size.
    pub parts: Vec<Part>,
    /// Radial load along x, N, where known.
    pub radial_load: Option<f64>,
    /// Axial load along z, N, where known.
    pub axial_load: Option<f64>,
    /// Speed of the inner ring, rad/s, where known.
    pub speed: Option<f64>,
    /// Lubricant, where known; else the usual one of the bearing's class.
    pub lubricant: Option<NewLubricant>,
    /// Tolerance classes of the seats, where known; else the bearing runs as it is drawn.
    pub fits: Fits,
}

/// Numbers that the asker of a new case knows, in the units of catalogues; what is absent is assumed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Given {
    /// Number of balls.
    pub balls: Option<usize>,
    /// Diameter of a ball, mm.
    pub ball_mm: Option<f64>,
    /// Load ratings C_r and C_0r, N, where both are known.
    pub ratings: Option<Ratings>,
    /// Radial load, N.
    pub radial: Option<f64>,
    /// Axial load, N.
    pub axial: Option<f64>,
    /// Speed of the inner ring, r/min.
    pub speed_rpm: Option<f64>,
    /// Lubricant: `usual`, or a word of [`NewLubricant::parse`].
    pub lubricant: Option<String>,
    /// Tolerance classes of the seats.
    pub fits: Fits,
}

/// A value of the case that is not in the catalogue, or is.
struct Sources {
    lines: Vec<String>,
}

impl Sources {
    fn assumed(&mut self, path: &str, why: &str) {
        self.add(path, "Assumed", why);
    }

    fn catalogue(&mut self, path: &str, which: &str) {
        self.add(path, "Catalogue", which);
    }

    fn reference(&mut self, path: &str, which: &str) {
        self.add(path, "Reference", which);
    }

    fn add(&mut self, path: &str, kind: &str, text: &str) {
        self.lines.push(format!("        \"{path}\": {kind}(\"{text}\"),"));
    }
}

impl NewCase {
    /// A case of a bearing, nothing known but its envelope.
    pub fn new(envelope: Envelope) -> Self {
        Self {
            designation: None,
            envelope,
            ratings: None,
            source: None,
            balls: KnownBalls::default(),
            clearance: None,
            ceramic_balls: false,
            parts: Vec::new(),
            radial_load: None,
            axial_load: None,
            speed: None,
            lubricant: None,
            fits: Fits::default(),
        }
    }

    /// A case of a bearing of the list, by the designation as it was written where that says more than the list's.
    pub fn of_listed(bearing: ListedBearing, written: &str) -> Self {
        let ListedBearing { designation, envelope, ratings, source, balls, parts, clearance, ceramic_balls } = bearing;
        // The letters of a contact angle are in the designation of the list.
        let more = parts.iter().any(|part| !designation.ends_with(&part.text));
        Self {
            designation: Some(if more { written.trim().to_owned() } else { designation }),
            ratings,
            source: Some(source),
            balls: KnownBalls { published: balls, ..KnownBalls::default() },
            clearance,
            ceramic_balls,
            parts,
            ..Self::new(envelope)
        }
    }

    /// The same with what its asker knows.
    ///
    /// # Errors
    /// [`CatalogueError::Lubricant`].
    pub fn given(self, given: Given) -> Result<Self, CatalogueError> {
        let Given { balls, ball_mm, ratings, radial, axial, speed_rpm, lubricant, fits } = given;
        let lubricant = match lubricant.as_deref() {
            Some("usual") => Some(self.usual_lubricant()),
            word => word.map(NewLubricant::parse).transpose()?,
        };
        let source = if ratings.is_some() { None } else { self.source };
        let ball_diameter = ball_mm.map(|mm| mm * 1e-3);
        Ok(Self {
            balls: KnownBalls { ball_count: balls, ball_diameter, ..self.balls },
            ratings: ratings.or(self.ratings),
            source,
            radial_load: radial,
            axial_load: axial,
            speed: speed_rpm.map(|rpm| rpm * PI / 30.0),
            lubricant,
            fits,
            ..self
        })
    }

    /// The text of the case file (RON), complete and commented.
    ///
    /// # Errors
    /// [`CatalogueError`] for dimensions that no radial ball bearing has.
    pub fn text(&self) -> Result<String, CatalogueError> {
        self.check()?;
        let balls = self.envelope.ball_set(self.balls, self.ratings)?;
        let numbers = Numbers::new(self, &balls)?;
        let mut sources = Sources { lines: Vec::new() };
        let mut text = self.opening();
        text += &self.geometry(&balls, &numbers, &mut sources);
        text += &sections::materials(self, &mut sources);
        let lubricant = self.lubricant();
        text += &lubricant.section(&mut sources);
        text += &sections::cage(&numbers, lubricant.is_wet(), &mut sources);
        text += &sections::operation(self, &numbers, &mut sources);
        text += &self.mounting(&mut sources);
        text += &sections::transient(&numbers, !lubricant.is_wet(), &mut sources);
        text += &sections::rating(self, &numbers, &mut sources);
        text += sections::modelling(&mut sources);
        text += "    // Where each value comes from. What is assumed may be wrong for your bearing: replace it by what you know.\n";
        text += &format!("    sources: {{\n{}\n    }},\n)\n", sources.lines.join("\n"));
        Ok(text)
    }

    fn check(&self) -> Result<(), CatalogueError> {
        self.fits.check()?;
        let Envelope { bore, outside, width, contact_angle } = self.envelope;
        let require = |allowed: bool, quantity, value: f64, rule: String| {
            if allowed {
                Ok(())
            } else {
                Err(CatalogueError::Dimension { quantity, value_mm: value * 1e3, allowed: rule })
            }
        };
        let positive = |value: f64| value.is_finite() && value > 0.0;
        require(positive(bore), "bore", bore, "greater than 0 and finite".to_owned())?;
        let rule = format!("greater than the bore, {} mm, and at most ten times it", millimetres(bore));
        require(outside > bore && outside <= 10.0 * bore, "outside diameter", outside, rule)?;
        let rule = format!("greater than 0 and at most the outside diameter, {} mm", millimetres(outside));
        require(positive(width) && width <= outside, "width", width, rule)?;
        let angle_deg = contact_angle.to_degrees();
        if !(0.0..=45.000_001).contains(&angle_deg) {
            return Err(CatalogueError::ContactAngle { angle_deg });
        }
        if let Some(diameter) = self.balls.ball_diameter {
            let space = 0.5 * (outside - bore);
            let rule = format!("greater than 0 and below the space between the rings, {} mm", millimetres(space));
            require(diameter > 0.0 && diameter < space, "ball diameter", diameter, rule)?;
        }
        if let KnownBalls { ball_count: Some(count), ball_diameter: Some(diameter), .. } = self.balls {
            let chord = (std::f64::consts::PI / count as f64).sin() * self.envelope.mean_diameter();
            if count < 3 || chord <= diameter {
                return Err(CatalogueError::Count { count, diameter_mm: diameter * 1e3 });
            }
        }
        Ok(())
    }

    /// Grease where seals or shields close the bearing, else oil.
    pub fn usual_lubricant(&self) -> NewLubricant {
        NewLubricant::usual(self.parts.iter().any(Part::closes))
    }

    /// The lubricant, the usual one where none is given.
    fn lubricant(&self) -> NewLubricant {
        self.lubricant.clone().unwrap_or_else(|| self.usual_lubricant())
    }

    fn is_deep_groove(&self) -> bool {
        self.envelope.contact_angle == 0.0
    }

    fn class(&self) -> &'static str {
        if self.is_deep_groove() { "deep-groove bearing" } else { "angular-contact bearing" }
    }

    fn title(&self) -> String {
        let Envelope { bore, outside, width, .. } = self.envelope;
        let [bore, outside, width] = [bore, outside, width].map(millimetres);
        let name = self.designation.as_ref().map(|name| format!("{name}, ")).unwrap_or_default();
        format!("{name}{} {bore} x {outside} x {width} mm", self.class())
    }

    fn opening(&self) -> String {
        let title = self.title();
        let parts: String = self.parts.iter().map(|part| format!("// {}: {}.\n", part.text, part.meaning)).collect();
        format!(
            "// {title}: a first case, complete.\n{parts}\
             // All that no catalogue tells is assumed and marked so in the sources at the end, with the usual range:\n\
             // replace what you know. docs/case-file.md has every field.\n\
             (\n    name: \"{title}\",\n\n"
        )
    }

    fn geometry(&self, balls: &BallSet, numbers: &Numbers, sources: &mut Sources) -> String {
        let BallSet { ball_count, ball_diameter, pitch_diameter, origin } = *balls;
        let Envelope { bore, contact_angle, .. } = self.envelope;
        sections::ball_sources(&origin, sources);
        match origin {
            Origin::Published { source } => sources.reference("geometry.pitch_diameter", source),
            _ => sources.assumed(
                "geometry.pitch_diameter",
                "mean of bore and outside diameter; makers' values differ by up to 2 %",
            ),
        }
        let groove = "the class that ISO 281 rates; makers do not print it, usual 0.505 to 0.54";
        sources.assumed("geometry.inner_groove", groove);
        sources.assumed("geometry.outer_groove", groove);
        let fit = if self.is_deep_groove() {
            let group = self.clearance.unwrap_or(ClearanceGroup::Normal);
            let [least, most] = group.of_bore(bore);
            let [least_um, most_um] = [least, most].map(|c| (c * 1e6).round());
            let why = format!(
                "middle of clearance group {}, {least_um} to {most_um} um (ISO 5753-1), before mounting",
                group.symbol()
            );
            sources.assumed("geometry.fit", &why);
            format!("RadialClearance(um({}))", trim(0.5e6 * (least + most), 1))
        } else {
            let nominal = if self.source.is_some() { "nominal, from the designation" } else { "nominal, as given" };
            sources.catalogue("geometry.fit", nominal);
            format!("ContactAngle(deg({}))", trim(contact_angle.to_degrees(), 3))
        };
        let sides = self.sides(sources);
        let shoulder = "height over the bottom of the groove on the loaded side; deep groove 0.15 to 0.25 D, angular contact 0.25 to 0.45 D";
        sources.assumed("geometry.inner_shoulder", shoulder);
        sources.assumed("geometry.outer_shoulder", shoulder);
        format!(
            "    geometry: (
        ball_count: {ball_count},
        ball_diameter: mm({}),
        pitch_diameter: mm({}),
        inner_groove: Coefficient(0.52),
        outer_groove: Coefficient(0.53),
        fit: {fit},
        // Sides on which the grooves go up: One is the side on which a positive axial load presses the balls.
        shoulders: {sides},
        // How far the groove goes up the side: the contact ellipse must not reach its edge.
        inner_shoulder: Height(mm({shoulder_mm})),
        outer_shoulder: Height(mm({shoulder_mm})),
    ),

",
            trim(ball_diameter * 1e3, 4),
            millimetres(pitch_diameter),
            shoulder_mm = trim(numbers.shoulder * 1e3, 2),
        )
    }

    /// Sides on which the grooves have shoulders.
    fn sides(&self, sources: &mut Sources) -> &'static str {
        if self.is_deep_groove() {
            sources.reference("geometry.shoulders", "deep-groove bearings have two shoulders on either ring");
            return "(inner: Both, outer: Both)";
        }
        let why = "outer ring relieved on one side, so that thrust is carried along +z only; Both on either ring for a split ring";
        sources.assumed("geometry.shoulders", why);
        "(inner: Both, outer: One)"
    }

    /// Name of the source of dimensions and ratings.
    fn source(&self) -> &'static str {
        self.source.unwrap_or("as given")
    }
}

impl From<RatingError> for CatalogueError {
    fn from(error: RatingError) -> Self {
        Self::Rating(error)
    }
}

/// A length in m as millimetres with the digits that a drawing has.
fn millimetres(metres: f64) -> String {
    trim(metres * 1e3, 4)
}

/// A number with at most so many digits behind the point, none of them a zero at the end.
fn trim(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
