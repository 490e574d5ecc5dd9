//! The orbit by the balance of the cage alone. In oil, balls without load lag behind and brake the cage, until it is so
//! slow that balls under load reach the fronts of their pockets and drive it: its torque over its speed bends there so
//! sharply that Newton's method on both at once goes to and fro. So it does in wide pockets of dry bearings, which
//! balls reach only once the fluid has braked the cage. With the cage held at a speed, ball and ring have no such bend,
//! and a root of one variable is found by brackets.

use crate::collocation::Orbit;
use crate::newton::Newton;
use crate::residual::cage_torque;
use crate::settings::OrbitSettings;
use crate::shooting::{CLOSE_BY, FAR, ROUNDS};
use tribodyn_traction::FastPatch;

/// First change of the cage's speed over it, with cheap patches and once these have shown where the balance is.
const FIRST: f64 = 2e-4;
const AGAIN: f64 = 2e-5;
/// By how much the change of them all grows until the torque has another sign, and one shrinks where no turn closes,
/// the largest and the least one.
const GROWS: f64 = 2.5;
const SHRINKS: f64 = 0.4;
const LARGEST: f64 = 0.1;
const LEAST: f64 = 1e-5;
/// Change of them all: a cage that is braked nearly stands.
const FARTHEST: f64 = 0.97;
/// Speeds that are tried within a bracket.
const TRIES: usize = 24;
/// Part of a bracket that is left at its ends.
const MARGIN: f64 = 0.05;
/// Torque on the cage over its scale, and width of the bracket over the speed, at which the cage is let go.
const BALANCED: f64 = 1e-4;
const NARROW: f64 = 1e-7;
/// Intervals of all turns that the search may take.
const WORK: usize = 25_000;

/// The turn of a ball whose cage is held, and the torque on the cage over its scale.
struct Held {
    orbit: Orbit,
    torque: f64,
}

/// The turn, next to one near by, at whose speed the torques on a held cage balance; none where the torque keeps its
/// sign.
pub(crate) fn balanced(
    newton: &mut Newton<'_>,
    near: &Orbit,
    (cheap, settings): (FastPatch, &OrbitSettings),
) -> Option<Orbit> {
    let accuracy = settings.mesh_error;
    let found = newton.within(WORK, |newton| {
        let near = newton.with_patches(cheap, |newton| weighed(newton, near, (accuracy, FIRST)))?;
        weighed(newton, &near, (accuracy, AGAIN))
    });
    newton.system.held = None;
    found
}

/// The turn at whose speed the torques on the cage balance, with errors allowed in an interval.
fn weighed(newton: &mut Newton<'_>, near: &Orbit, (allowed, first): (f64, f64)) -> Option<Orbit> {
    let begun = held(newton, near, (near.cage_speed, allowed))?;
    let mut ends = bracket(newton, begun, (allowed, first))?;
    // A torque that stays at one end of the bracket counts half: the Illinois rule. Beside a sharp bend halving the
    // bracket is faster, so both take turns.
    let mut weights = [1.0; 2];
    for attempt in 0..TRIES {
        let nearest = usize::from(ends[1].torque.abs() < ends[0].torque.abs());
        let [from, to] = ends.each_ref().map(|end| end.orbit.cage_speed);
        if ends[nearest].torque.abs() < BALANCED || (to - from).abs() < NARROW * to.abs() {
            return Some(ends[nearest].orbit.clone());
        }
        let [a, b] = [0, 1].map(|k| weights[k] * ends[k].torque);
        let share = if attempt % 2 == 0 { 0.5 } else { (a / (a - b)).clamp(MARGIN, 1.0 - MARGIN) };
        let next = held(newton, &ends[usize::from(share > 0.5)].orbit, (from + share * (to - from), allowed))?;
        let side = usize::from((next.torque > 0.0) == (ends[1].torque > 0.0));
        weights[1 - side] *= 0.5;
        weights[side] = 1.0;
        ends[side] = next;
    }
    None
}

/// Turns at two speeds of the cage at which its torque has different signs.
fn bracket(newton: &mut Newton<'_>, begun: Held, (allowed, first): (f64, f64)) -> Option<[Held; 2]> {
    let speed = begun.orbit.cage_speed;
    // A torque along its motion makes it faster.
    let direction = begun.torque.signum() * speed.abs();
    let (mut last, mut gone, mut change) = (begun, 0.0, first);
    while gone < FARTHEST && change >= LEAST {
        let Some(next) = held(newton, &last.orbit, (speed + direction * (gone + change), allowed)) else {
            change *= SHRINKS;
            continue;
        };
        if next.torque * last.torque <= 0.0 {
            return Some([last, next]);
        }
        gone += change;
        last = next;
        change = ((GROWS - 1.0) * gone).min(LARGEST);
    }
    None
}

/// A ball sent round until it closes its turn, with the cage held at a speed.
fn held(newton: &mut Newton<'_>, near: &Orbit, (speed, allowed): (f64, f64)) -> Option<Held> {
    newton.system.held = Some(speed);
    let turn = newton.shoot(near.last(), (speed, near.ring), (allowed, CLOSE_BY, ROUNDS)).ok()?;
    if turn.off > FAR {
        return None;
    }
    let torque = cage_torque(&newton.system, &turn.orbit, &turn.residual.means) / newton.scales.border_rows[0];
    Some(Held { orbit: turn.orbit, torque })
}
