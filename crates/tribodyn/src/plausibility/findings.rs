//! Findings on values that are unusual against each other, and on an unusual solution.

use super::balls::{SHOULDER_MAX_DEG, at, largest};
use super::implausible::{Implausible, advice, implausible, kinds, names};
use super::{shown, side};
use crate::answers::Equations;
use tribodyn_bearing::{BallResult, Bearing, BearingError, Races, RingFreedom, Side};
use tribodyn_case::{Case, Fit, Medium};
use tribodyn_lubricant::Supply;
use tribodyn_quasistatic::Solution;
use tribodyn_rating::PERMISSIBLE_PRESSURE;

/// Contact angle at which a bearing counts as an angular-contact one, degrees.
const ANGULAR_DEG: f64 = 12.0;
/// Density below which balls count as ceramic, kg/m³.
const CERAMIC_DENSITY: f64 = 6000.0;
/// Speed of the rings against each other times pitch diameter by type, mm r/min, with the type in words: limiting
/// speeds of manufacturers' catalogues for deep-groove bearings in oil, spindle bearings of steel with oil and air, and
/// those with ceramic balls or cooled by a cryogen (main shafts, turbopumps).
const SPEED_MAX: [(f64, &str); 3] = [
    (1.1e6, "deep-groove bearings in oil"),
    (1.8e6, "angular-contact bearings with steel balls"),
    (3e6, "angular-contact bearings with ceramic balls or in a cryogen"),
];
/// The same of all types in grease: a rule of thumb of manufacturers' catalogues.
const GREASE_SPEED_MAX: (f64, &str) = (5e5, "bearings in grease");
/// Tilt of the rings against each other by the same catalogues, mrad: ten minutes of arc for deep-groove bearings of
/// usual clearance, three for angular-contact ones.
const TILT_MAX: [f64; 2] = [3.0, 0.9];
/// Radial clearance over ball diameter: group C5 of small bearings.
const CLEARANCE_MAX: f64 = 0.02;
/// Pocket gap over ball diameter.
const POCKET_GAP: [f64; 2] = [5e-4, 0.1];
/// Inertia of the cage over that of all balls about the bearing's axis.
const CAGE_INERTIA: [f64; 2] = [0.01, 10.0];
/// Angular velocity of spin over that of rolling.
const SPIN_TO_ROLL_MAX: f64 = 1.0;
/// Slide-to-roll ratio beyond which a contact skids, as a fraction.
const SLIDE_MAX: f64 = 0.1;

/// Sentences on values of a case that are unusual against each other.
pub fn case_findings(case: &Case, bearing: &Bearing) -> Vec<String> {
    let point = case.operating_point();
    let mut found: Vec<String> = side::of_point(bearing, &point).into_iter().collect();
    found.extend(speed_finding(case, bearing));
    let mut note = |unusual: bool, sentence: String| found.extend(unusual.then_some(sentence));
    let geometry = &bearing.geometry;
    let angular = is_angular(bearing);
    let tilt = point.ring[3..].iter().filter_map(|f| if let RingFreedom::Held(tilt) = f { Some(*tilt) } else { None });
    let tilt = 1e3 * tilt.fold(0.0, f64::hypot);
    let most = TILT_MAX[usize::from(angular)];
    note(
        tilt > most,
        format!(
            "the rings are tilted by {} mrad: usual is up to {most} ({} bearings)",
            shown(tilt),
            if angular { "angular-contact" } else { "deep-groove" }
        ),
    );
    if let Fit::RadialClearance(clearance) = case.geometry.fit {
        let share = clearance / geometry.ball_diameter;
        note(
            share > CLEARANCE_MAX,
            format!(
                "`geometry.fit` is a radial clearance of {} of the ball diameter: usual is up to {CLEARANCE_MAX} (ISO 5753-1, group C5)",
                shown(share)
            ),
        );
    }
    if let Some(cage) = &case.cage {
        let gap = cage.pocket_gap / geometry.ball_diameter;
        note(
            gap > 0.0 && !within(gap, POCKET_GAP),
            format!(
                "`cage.pocket_gap` is {} of the ball diameter: usual is {} to {} (the project's cases)",
                shown(gap),
                POCKET_GAP[0],
                POCKET_GAP[1]
            ),
        );
        let balls = geometry.ball_count as f64 * bearing.ball_mass * (0.5 * geometry.pitch_diameter).powi(2);
        let share = cage.inertia.map(|inertia| inertia / balls);
        note(
            share.is_some_and(|share| !within(share, CAGE_INERTIA)),
            format!(
                "`cage.inertia` is {} of that of the balls about the bearing's axis: usual is {} to {} (the project's cases)",
                shown(share.unwrap_or_default()),
                CAGE_INERTIA[0],
                CAGE_INERTIA[1]
            ),
        );
    }
    found
}

fn is_angular(bearing: &Bearing) -> bool {
    bearing.geometry.contact_angle().to_degrees() >= ANGULAR_DEG
}

/// A sentence on rings that turn faster against each other than is usual for the bearing's type and lubricant.
pub fn speed_finding(case: &Case, bearing: &Bearing) -> Option<String> {
    let point = case.operating_point();
    let rpm = (point.inner_speed - point.outer_speed).abs() * 30.0 / std::f64::consts::PI;
    let speed = rpm * bearing.geometry.pitch_diameter * 1e3;
    let (most, of) = speed_limit(case, is_angular(bearing));
    (speed > most).then(|| {
        format!("pitch diameter times speed is {} mm r/min: usual is up to {} ({of})", shown(speed), shown(most))
    })
}

/// The speed limit of a bearing by its lubricant and type, mm r/min, with what it is of in words.
fn speed_limit(case: &Case, angular: bool) -> (f64, &'static str) {
    if case.lubricant.as_ref().is_some_and(|lubricant| lubricant.supply == Supply::Grease) {
        return GREASE_SPEED_MAX;
    }
    let cooled = case.fluid.as_ref().is_some_and(|fluid| !matches!(fluid.medium, Medium::Custom { .. }));
    let light = case.materials.ball.density < CERAMIC_DENSITY;
    SPEED_MAX[usize::from(angular) + usize::from(angular && (light || cooled))]
}

fn within(value: f64, [least, most]: [f64; 2]) -> bool {
    (least..=most).contains(&value)
}

/// Sentences on a solution that is unusual, and what is implausible about it.
pub struct SolutionFindings {
    /// All sentences.
    pub sentences: Vec<String>,
    /// Things that no bearing does, with the sentence on each, which is among the others.
    pub implausible: Vec<(Implausible, String)>,
}

impl SolutionFindings {
    /// Kinds of what is implausible, each once.
    pub fn kinds(&self) -> Vec<Implausible> {
        kinds(&self.implausible)
    }

    /// All sentences, and at the end the names of what is implausible in an answer of a model, with advice.
    pub fn warnings(self, model: Equations) -> Vec<String> {
        let last = names(&self.implausible).map(|names| format!("implausible: {names}; {}", advice(model)));
        self.sentences.into_iter().chain(last).collect()
    }
}

/// Sentences on a solution that is unusual, or more than its model can mean.
///
/// # Errors
/// [`BearingError`] where the case has no geometry.
pub fn solution_findings(
    case: &Case,
    bearing: &Bearing,
    solution: &Solution,
) -> Result<SolutionFindings, BearingError> {
    let mut sentences = Vec::new();
    let shoulders = case.geometry.shoulder_angles()?;
    for (side, race) in [(Side::Inner, "inner"), (Side::Outer, "outer")] {
        sentences.extend(pressure(solution, side, race));
        sentences.extend(edge(bearing, solution, &shoulders, side, race));
        if solution.turns() {
            sentences.extend(sliding(solution, side, race));
            sentences.extend(spinning(bearing, solution, side, race));
        }
    }
    let sides = side::of_solution(bearing, solution);
    sentences.extend(sides.open);
    let implausible: Vec<_> = sides.implausible.into_iter().chain(implausible(solution, &shoulders)).collect();
    sentences.extend(implausible.iter().map(|(_, sentence)| sentence.clone()));
    Ok(SolutionFindings { sentences, implausible })
}

fn pressure(solution: &Solution, side: Side, race: &str) -> Option<String> {
    let (ball, pressure) = largest(solution, |ball| Some(ball.contacts[side].peak_pressure_pa))?;
    (pressure > PERMISSIBLE_PRESSURE).then(|| {
        format!(
            "{} GPa on the {race} race, {}: steel takes 4.2 GPa at rest (ISO 76), and elastic theory ends near it",
            shown(pressure * 1e-9),
            at(ball)
        )
    })
}

/// The contact ellipse against the edge of the groove: its far end is a/r_e of an angle beyond the contact angle.
fn edge(
    bearing: &Bearing,
    solution: &Solution,
    shoulders: &Races<Option<f64>>,
    side: Side,
    race: &str,
) -> Option<String> {
    let radius = bearing.geometry.coefficient(side) * bearing.geometry.ball_diameter;
    // A groove without a shoulder in the case ends somewhere too.
    let shoulder = shoulders[side].unwrap_or(SHOULDER_MAX_DEG.to_radians());
    let loaded = |ball: &BallResult| ball.contacts[side].load_n > 0.0;
    let angle = |ball: &BallResult| loaded(ball).then(|| ball.contacts[side].angle_rad.abs());
    let (_, contact) = largest(solution, angle)?;
    let end = |ball: &BallResult| angle(ball).map(|angle| angle + ball.contacts[side].semi_axes_m[0] / radius);
    let (ball, end) = largest(solution, end)?;
    let degrees = |rad: f64| shown(rad.to_degrees());
    // A ball whose middle is beyond it is another matter.
    (end > shoulder && contact <= shoulder).then(|| {
        format!(
            "contact ellipse cut by the shoulder of the {race} race, {}: it ends at {}°, the groove at {}°{}; pressures at the edge are higher than Hertz's",
            at(ball),
            degrees(end),
            degrees(shoulder),
            if shoulders[side].is_some() { "" } else { " at the latest" }
        )
    })
}

fn sliding(solution: &Solution, side: Side, race: &str) -> Option<String> {
    let slide = |ball: &BallResult| {
        let contact = &ball.contacts[side];
        contact.friction.as_ref().filter(|_| contact.load_n > 0.0).map(|f| f.slide_to_roll[0].abs())
    };
    let (ball, slide) = largest(solution, slide)?;
    (slide > SLIDE_MAX).then(|| {
        format!(
            "slide-to-roll ratio of {} on the {race} race, {}: usual is below {SLIDE_MAX}; the ball skids",
            shown(slide),
            at(ball)
        )
    })
}

fn spinning(bearing: &Bearing, solution: &Solution, side: Side, race: &str) -> Option<String> {
    let radius = bearing.geometry.ball_radius();
    let spin = |ball: &BallResult| {
        let contact = &ball.contacts[side];
        (contact.load_n > 0.0).then(|| contact.spin_ratio_per_m.abs() * radius)
    };
    let (ball, ratio) = largest(solution, spin)?;
    (ratio > SPIN_TO_ROLL_MAX).then(|| {
        format!(
            "spin-to-roll ratio of {} on the {race} race, {}: usual is below {SPIN_TO_ROLL_MAX} up to 45° of contact angle (Harris and Kotzalas)",
            shown(ratio),
            at(ball)
        )
    })
}
