//! The balls of a bearing whose catalogue does not tell them.
//!
//! Load ratings tell them: ISO 281 and ISO 76 compute C_r and C_0r from number and diameter of the balls, and balls
//! come in the sizes of ISO 3290. Of all sets that fit between the rings there is as a rule one that gives both
//! ratings of the catalogue to half a percent.

use crate::{CatalogueError, Envelope, PublishedBalls};
use std::f64::consts::PI;
use tribodyn_rating::RatedBearing;

/// Groove radii over ball diameter that ISO 281 rates, inner and outer.
pub const USUAL_GROOVES: [f64; 2] = [0.52, 0.53];

/// Load ratings, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ratings {
    /// C_r.
    pub dynamic: f64,
    /// C_0r.
    pub at_rest: f64,
}

/// The balls of a bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallSet {
    /// Number of balls.
    pub ball_count: usize,
    /// Ball diameter, m.
    pub ball_diameter: f64,
    /// Pitch diameter, m.
    pub pitch_diameter: f64,
    /// Where they come from.
    pub origin: Origin,
}

/// The set whose ratings come second nearest to the catalogue's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunnerUp {
    /// Number of balls.
    pub ball_count: usize,
    /// Ball diameter, m.
    pub ball_diameter: f64,
    /// The larger of its relative deviations in C_r and C_0r.
    pub deviation: f64,
}

/// Where the balls of a set come from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Origin {
    /// Both numbers were given.
    Given,
    /// They are published, with the pitch diameter.
    Published {
        /// Where.
        source: &'static str,
    },
    /// The set whose ratings come nearest to the catalogue's; their relative deviations.
    Ratings {
        /// Of C_r.
        dynamic: f64,
        /// Of C_0r.
        at_rest: f64,
        /// The set that comes second, for how sure this one is; none where only one fits.
        next: Option<RunnerUp>,
    },
    /// A rule of thumb: 0.3 of the space between the rings, and as many as can be put in.
    Thumb,
}

/// Known data of a bearing's balls.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct KnownBalls {
    /// Number of balls.
    pub ball_count: Option<usize>,
    /// Ball diameter, m.
    pub ball_diameter: Option<f64>,
    /// The set that is published; the numbers above go before it.
    pub published: Option<PublishedBalls>,
}

/// Ball diameter over the space between bore and outside diameter.
const USUAL_BALL: f64 = 0.30;
/// Least and largest of that.
const BALLS: [f64; 2] = [0.18, 0.38];
/// Arc that the balls of a deep-groove bearing fill when they are put in eccentrically, first to last, degrees: usual
/// and largest.
const FILLING_DEG: [f64; 2] = [195.0, 210.0];
/// Arc that the balls of an angular-contact bearing fill, degrees: usual and largest.
const FULL_DEG: [f64; 2] = [320.0, 350.0];

impl Envelope {
    /// Mean of bore and outside diameter, m: where nothing else is known of the pitch diameter.
    pub fn mean_diameter(&self) -> f64 {
        0.5 * (self.bore + self.outside)
    }

    /// The bearing with a set of balls and the grooves that the standards rate.
    pub fn rated(&self, balls: &BallSet) -> RatedBearing {
        let [inner_coefficient, outer_coefficient] = USUAL_GROOVES;
        let BallSet { ball_count, ball_diameter, pitch_diameter, .. } = *balls;
        let contact_angle = self.contact_angle;
        RatedBearing { ball_count, ball_diameter, pitch_diameter, contact_angle, inner_coefficient, outer_coefficient }
    }

    /// The balls: those given, or those that the ratings tell, or a rule of thumb.
    ///
    /// # Errors
    /// [`CatalogueError::NoBalls`] where none fits between the rings.
    pub fn ball_set(&self, known: KnownBalls, ratings: Option<Ratings>) -> Result<BallSet, CatalogueError> {
        let pitch_diameter = self.mean_diameter();
        match known {
            KnownBalls { ball_count: Some(ball_count), ball_diameter: Some(ball_diameter), .. } => {
                return Ok(BallSet { ball_count, ball_diameter, pitch_diameter, origin: Origin::Given });
            }
            KnownBalls { ball_count: None, ball_diameter: None, published: Some(set) } => {
                let PublishedBalls { ball_count, ball_diameter, pitch_diameter, source } = set;
                return Ok(BallSet { ball_count, ball_diameter, pitch_diameter, origin: Origin::Published { source } });
            }
            _ => {}
        }
        let found = match ratings {
            Some(ratings) => self.by_ratings(known, ratings),
            None => self.by_thumb(known),
        };
        found.ok_or(CatalogueError::NoBalls { space_mm: 0.5e3 * (self.outside - self.bore) })
    }

    fn by_ratings(&self, known: KnownBalls, ratings: Ratings) -> Option<BallSet> {
        let mut all: Vec<(f64, BallSet)> = Vec::new();
        let pitch_diameter = self.mean_diameter();
        for ball_diameter in self.diameters(known) {
            for ball_count in self.counts(known, ball_diameter) {
                let bearing = self.rated(&BallSet { ball_count, ball_diameter, pitch_diameter, origin: Origin::Given });
                let (Ok(dynamic), Ok(at_rest)) = (bearing.dynamic_rating(), bearing.static_rating()) else { continue };
                let (dynamic, at_rest) = (dynamic / ratings.dynamic - 1.0, at_rest / ratings.at_rest - 1.0);
                let worst = dynamic.abs().max(at_rest.abs());
                let origin = Origin::Ratings { dynamic, at_rest, next: None };
                all.push((worst, BallSet { ball_count, ball_diameter, pitch_diameter, origin }));
            }
        }
        all.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let next = all.get(1).map(|&(deviation, BallSet { ball_count, ball_diameter, .. })| RunnerUp {
            ball_count,
            ball_diameter,
            deviation,
        });
        let mut best = all.first()?.1;
        if let Origin::Ratings { next: second, .. } = &mut best.origin {
            *second = next;
        }
        Some(best)
    }

    fn by_thumb(&self, known: KnownBalls) -> Option<BallSet> {
        let wanted = USUAL_BALL * (self.outside - self.bore);
        let off = |d: &f64| (d - wanted).abs();
        let ball_diameter = self.diameters(known).into_iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        let ball_count = known.ball_count.or_else(|| self.most(ball_diameter, 0))?;
        Some(BallSet { ball_count, ball_diameter, pitch_diameter: self.mean_diameter(), origin: Origin::Thumb })
    }

    /// The diameter given, or all standard ones between the rings, m.
    fn diameters(&self, known: KnownBalls) -> Vec<f64> {
        let space = self.outside - self.bore;
        let fits = |d: &f64| (BALLS[0] * space..BALLS[1] * space).contains(d);
        known.ball_diameter.map_or_else(|| standard_diameters().filter(fits).collect(), |d| vec![d])
    }

    fn counts(&self, known: KnownBalls, ball_diameter: f64) -> std::ops::RangeInclusive<usize> {
        match known.ball_count {
            Some(count) => count..=count,
            None => 3..=self.most(ball_diameter, 1).unwrap_or(0),
        }
    }

    /// Most balls by the usual (0) or the largest (1) arc that they fill.
    fn most(&self, ball_diameter: f64, limit: usize) -> Option<usize> {
        let half = (ball_diameter / self.mean_diameter()).asin();
        let pitch_deg = 2.0 * half.to_degrees();
        // Balls of a deep-groove bearing go in through the gap of rings that touch: the first and the last count half.
        let count = if self.contact_angle < 5f64.to_radians() {
            (FILLING_DEG[limit] / pitch_deg).floor() + 1.0
        } else {
            (FULL_DEG[limit] / pitch_deg).floor()
        };
        let fits = (PI / half).floor();
        let count = count.min(fits);
        (count >= 3.0).then_some(count as usize)
    }
}

/// Ball diameters that ISO 3290 prefers, m: 64ths of an inch up to a half, 32nds up to one, 16ths up to three; halves
/// of a millimetre up to 15 mm, whole ones up to 75 mm.
fn standard_diameters() -> impl Iterator<Item = f64> {
    let inch = |step: f64, from: u32, to: u32| (from..=to).map(move |k| f64::from(k) * step * 25.4e-3);
    let metric = |step: f64, from: u32, to: u32| (from..=to).map(move |k| f64::from(k) * step * 1e-3);
    inch(1.0 / 64.0, 4, 32)
        .chain(inch(1.0 / 32.0, 17, 32))
        .chain(inch(1.0 / 16.0, 17, 48))
        .chain(metric(0.5, 4, 30))
        .chain(metric(1.0, 16, 75))
}
