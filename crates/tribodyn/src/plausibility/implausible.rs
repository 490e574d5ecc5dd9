//! Answers that no bearing gives: what a model comes to where it does not hold. One list, for `solve`, `run` and the
//! rows of sweeps.

use super::balls::{SHOULDER_MAX_DEG, at, largest};
use super::shown;
use crate::answers::Equations;
use serde::{Serialize, Serializer};
use std::fmt;
use tribodyn_bearing::{BallResult, Races, Side};
use tribodyn_quasistatic::{Model, Solution};

/// By how much a ball's load may be above the bearing's before it counts: residuals are far below.
const SLACK: f64 = 0.01;
/// Peak pressure beyond which no rolling contact is elastic, Pa: the hardness of bearing steel (handbook values of 7 to
/// 8 GPa for 60 to 64 HRC).
const PRESSURE_MAX: f64 = 7e9;

/// A thing about a solution that no bearing does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Implausible {
    /// Pressed harder than steel is hard: Hertz's contact is elastic.
    Pressure,
    /// A contact beyond the shoulder of its groove, or where no groove has one.
    ContactAngle,
    /// A ball that is pressed harder than the whole bearing.
    BallLoad,
    /// Balls that no race drives, in a model that leaves open how they move then.
    IdleBalls,
    /// A pocket that carries more than the whole bearing.
    PocketForce,
    /// A cage that turns faster or slower than both rings.
    CageSpeed,
}

impl fmt::Display for Implausible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Pressure => "pressure",
            Self::ContactAngle => "contact angle",
            Self::BallLoad => "ball load",
            Self::IdleBalls => "idle balls",
            Self::PocketForce => "pocket force",
            Self::CageSpeed => "cage speed",
        })
    }
}

/// Under the name that it has in tables.
impl Serialize for Implausible {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// Advice to who gets such an answer: an equilibrium leaves open what the steady orbit has.
pub fn advice(model: Equations) -> &'static str {
    match model {
        Equations::JonesHarris | Equations::Traction => {
            "do not use these numbers; `--model steady-orbit` gives what a run settles to"
        }
        Equations::SteadyOrbit => "the models' grooves have no ends: these loads are beyond this bearing",
    }
}

/// All that is implausible about a solution, in order and each once, with a sentence on each. The shoulders are the
/// angles at which the grooves end, rad, as far as they are known.
pub fn implausible(solution: &Solution, shoulders: &Races<Option<f64>>) -> Vec<(Implausible, String)> {
    let angles =
        [(Side::Inner, "inner"), (Side::Outer, "outer")].map(|(side, race)| angle(solution, shoulders, side, race));
    let pressed = pressed(solution).map(|sentence| (Implausible::Pressure, sentence));
    let found = angles.into_iter().flatten().map(|sentence| (Implausible::ContactAngle, sentence));
    let found = pressed.into_iter().chain(found);
    let others = [
        (Implausible::BallLoad, ball_load(solution)),
        (Implausible::IdleBalls, idle(solution)),
        (Implausible::PocketForce, pocket(solution)),
        (Implausible::CageSpeed, cage(solution)),
    ];
    found.chain(others.into_iter().filter_map(|(what, sentence)| Some((what, sentence?)))).collect()
}

/// Kinds of what is implausible, each once.
pub fn kinds(found: &[(Implausible, String)]) -> Vec<Implausible> {
    let mut kinds: Vec<Implausible> = found.iter().map(|(what, _)| *what).collect();
    kinds.dedup();
    kinds
}

/// Names of what is implausible, for a field of a table; none where nothing is.
pub fn names(found: &[(Implausible, String)]) -> Option<String> {
    let names = kinds(found);
    (!names.is_empty()).then(|| names.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "))
}

/// A contact pressed harder than the hardness of the races.
fn pressed(solution: &Solution) -> Option<String> {
    let of =
        |ball: &BallResult| Side::BOTH.map(|side| ball.contacts[side].peak_pressure_pa).into_iter().reduce(f64::max);
    let (ball, pressure) = largest(solution, of)?;
    (pressure > PRESSURE_MAX).then(|| {
        format!(
            "{} GPa, {}, is above the hardness of bearing steel, {} GPa: the contact would be plastic, these loads and \
             deflections mean nothing",
            shown(pressure * 1e-9),
            at(ball),
            shown(PRESSURE_MAX * 1e-9)
        )
    })
}

/// A contact beyond the end of the groove.
fn angle(solution: &Solution, shoulders: &Races<Option<f64>>, side: Side, race: &str) -> Option<String> {
    let loaded = |ball: &BallResult| ball.contacts[side].load_n > 0.0;
    let (ball, contact) = largest(solution, |ball| loaded(ball).then(|| ball.contacts[side].angle_rad.abs()))?;
    let degrees = |rad: f64| shown(rad.to_degrees());
    match shoulders[side] {
        Some(shoulder) => (contact > shoulder).then(|| {
            format!(
                "contact angle of {}° on the {race} race, {}, is beyond the shoulder at {}°: the ball would climb out of the groove",
                degrees(contact),
                at(ball),
                degrees(shoulder)
            )
        }),
        None => (contact.to_degrees() > SHOULDER_MAX_DEG).then(|| {
            format!(
                "contact angle of {}° on the {race} race, {}: no shoulder reaches beyond {SHOULDER_MAX_DEG}°, the ball would climb out of the groove",
                degrees(contact),
                at(ball)
            )
        }),
    }
}

/// Loads of balls that press the same way add up to the bearing's, and tilting moments press two ways. A ball may carry
/// more than that across the load, at a small contact angle, but not both along and across the axis.
fn ball_load(solution: &Solution) -> Option<String> {
    let [x, y, z] = solution.ring_load_n;
    let [mx, my] = solution.ring_moment_nm;
    let excess = |ball: &BallResult| {
        let contact = &ball.contacts.inner;
        let tilting = mx.hypot(my) / ball.orbit_radius_m;
        let (sin, cos) = contact.angle_rad.sin_cos();
        let (axial, radial) = ((contact.load_n * sin).abs(), (contact.load_n * cos).abs());
        let of = |force: f64, load: f64| force - SLACK * contact.load_n - (1.0 + SLACK) * (load + tilting);
        Some(of(axial, z.abs()).min(of(radial, x.hypot(y)))).filter(|excess| *excess > 0.0)
    };
    let (ball, _) = largest(solution, excess)?;
    Some(format!(
        "load of {} N on the inner race, {}, is above the bearing's {} N both along and across the axis",
        shown(ball.contacts.inner.load_n),
        at(ball),
        shown(x.hypot(y).hypot(z))
    ))
}

/// Balls that the inner race does not drive turn with the cage, which an equilibrium does not have.
fn idle(solution: &Solution) -> Option<String> {
    let idle = solution.balls.iter().filter(|ball| ball.contacts.inner.load_n <= 0.0).count();
    // The steady orbit says what such balls do.
    let quasi_static = solution.model == Model::Traction && solution.balls.iter().all(|ball| ball.motion.is_none());
    (quasi_static && idle > 0 && solution.inner_speed_rad_s != solution.outer_speed_rad_s).then(|| {
        format!(
            "{idle} of {} balls have no inner contact, and this model does not determine how they move: do not use cage speed, torque, pocket forces or contact angles of these balls",
            solution.balls.len()
        )
    })
}

/// A pocket holds a ball back by friction, which is a small share of what loads the bearing.
fn pocket(solution: &Solution) -> Option<String> {
    let [x, y, z] = solution.ring_load_n;
    let load = x.hypot(y).hypot(z);
    let (ball, force) = largest(solution, |ball| ball.pocket.map(|pocket| pocket.force_n.abs()))?;
    let free = ball.motion.is_none();
    (force > load && load > 0.0).then(|| {
        let why = if free {
            ": the quasi-static model takes pockets to follow from free orbits, which idle balls do not have"
        } else {
            ""
        };
        format!("pocket force of {} N, {}, above the bearing's load of {} N{why}", shown(force), at(ball), shown(load))
    })
}

fn cage(solution: &Solution) -> Option<String> {
    let rpm = |rad_s: f64| rad_s * 30.0 / std::f64::consts::PI;
    let [a, b] = [rpm(solution.inner_speed_rad_s), rpm(solution.outer_speed_rad_s)];
    let (least, most) = (a.min(b), a.max(b));
    let speed = solution.cage_speed_rpm;
    // A thousandth of the difference for rounding.
    let slack = 1e-3 * (most - least);
    (speed < least - slack || speed > most + slack).then(|| {
        format!(
            "cage speed of {} r/min is outside the rings' speeds, {} and {} r/min: nothing in the bearing drives it there",
            shown(speed),
            shown(a),
            shown(b)
        )
    })
}
