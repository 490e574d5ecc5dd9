//! Places of the turn where contacts of a ball begin and end. From orbit to orbit they move, and with them the kinks of
//! all unknowns: what one orbit says of another holds between the same two of them, not at the same azimuth.

use crate::collocation::{Orbit, STAGES};
use crate::system::OrbitSystem;
use serde::{Deserialize, Serialize};
use tribodyn_numerics::Radau;

/// Halvings by which a place is found between two points of the mesh.
const HALVINGS: usize = 30;

/// A contact that begins or ends.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Event {
    /// Of [`OrbitSystem::gaps`].
    contact: usize,
    begins: bool,
    turn: f64,
}

/// The contacts that begin and end in a turn, one after the other.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Events(Vec<Event>);

impl Events {
    /// Those of an orbit.
    pub fn of(system: &OrbitSystem<'_>, radau: &Radau, orbit: &Orbit) -> Self {
        let closed = |turn: f64| {
            let y = orbit.at(radau, turn);
            system.gaps(system.azimuth(turn), &y, (orbit.cage_speed, orbit.ring)).map(|gap| gap < 0.0)
        };
        let mut events = Vec::new();
        let (mut last, mut before) = (0.0, closed(0.0));
        for j in 0..orbit.intervals() {
            let [begin, width] = orbit.interval(j);
            for i in 0..STAGES {
                let turn = begin + radau.points[i] * width;
                let now = closed(turn);
                for contact in (0..now.len()).filter(|contact| now[*contact] != before[*contact]) {
                    let begins = now[contact];
                    let turn = between((last, turn), |turn| closed(turn)[contact] == begins);
                    events.push(Event { contact, begins, turn });
                }
                (last, before) = (turn, now);
            }
        }
        events.sort_by(|a, b| a.turn.total_cmp(&b.turn));
        Self(events)
    }

    /// Moved by as much as two others differ; none where they are not the same contacts in the same order, also once
    /// they are moved.
    pub fn moved(&self, from: &Self, to: &Self) -> Option<Self> {
        if !self.is_in_order() || !self.is_like(from) || !self.is_like(to) {
            return None;
        }
        let pairs = self.0.iter().zip(from.0.iter().zip(&to.0));
        let moved = Self(pairs.map(|(own, (from, to))| own.at(own.turn + (to.turn - from.turn))).collect());
        moved.is_in_order().then_some(moved)
    }

    /// Places of a mesh where they would be between the events of another orbit, which are like these.
    pub fn carried(&self, ends: &[f64], to: &Self) -> Vec<f64> {
        let knots = |events: &Self| -> Vec<f64> {
            [0.0].into_iter().chain(events.0.iter().map(|event| event.turn)).chain([1.0]).collect()
        };
        if self == to {
            return ends.to_vec();
        }
        let (here, there) = (knots(self), knots(to));
        let carry = |&turn: &f64| {
            let k = here.partition_point(|knot| *knot <= turn).clamp(1, here.len() - 1);
            if turn == here[k] {
                return there[k];
            }
            there[k - 1] + (turn - here[k - 1]) * ((there[k] - there[k - 1]) / (here[k] - here[k - 1]))
        };
        ends.iter().map(carry).collect()
    }

    fn is_like(&self, other: &Self) -> bool {
        let alike = |(a, b): (&Event, &Event)| (a.contact, a.begins) == (b.contact, b.begins);
        self.0.len() == other.0.len() && self.0.iter().zip(&other.0).all(alike) && other.is_in_order()
    }

    fn is_in_order(&self) -> bool {
        let turns = || self.0.iter().map(|event| event.turn);
        [0.0].into_iter().chain(turns()).zip(turns().chain([1.0])).all(|(before, after)| before < after)
    }
}

impl Event {
    fn at(self, turn: f64) -> Self {
        Self { turn, ..self }
    }
}

/// Where something becomes true between two places.
fn between((mut before, mut after): (f64, f64), is_true: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (before + after);
        *(if is_true(middle) { &mut after } else { &mut before }) = middle;
    }
    after
}

#[cfg(test)]
mod tests {
    use super::*;

    fn events(turns: &[f64]) -> Events {
        Events(turns.iter().enumerate().map(|(k, &turn)| Event { contact: 0, begins: k % 2 == 0, turn }).collect())
    }

    #[test]
    fn identity_a_mesh_goes_along_with_the_contacts() {
        let (here, there) = (events(&[0.25, 0.5]), events(&[0.375, 0.5]));
        let ends = [0.0, 0.125, 0.25, 0.375, 0.5, 0.75, 1.0];
        assert_eq!(here.carried(&ends, &there), [0.0, 0.1875, 0.375, 0.4375, 0.5, 0.75, 1.0]);
        assert_eq!(here.carried(&ends, &here), ends);
        let back: Vec<f64> = there.carried(&here.carried(&ends, &there), &here);
        assert!(back.iter().zip(ends).all(|(a, b)| (a - b).abs() < 1e-15), "{back:?}");
    }

    #[test]
    fn limit_contacts_that_are_not_the_same_or_would_pass_each_other_move_nothing() {
        let near = events(&[0.25, 0.5]);
        assert_eq!(near.moved(&events(&[0.125, 0.5]), &near), Some(events(&[0.375, 0.5])));
        assert_eq!(near.moved(&events(&[0.25]), &near), None);
        assert_eq!(near.moved(&events(&[0.0625, 0.5625]), &events(&[0.4375, 0.5625])), None);
        assert_eq!(events(&[]).moved(&events(&[]), &events(&[])), Some(events(&[])));
    }
}
