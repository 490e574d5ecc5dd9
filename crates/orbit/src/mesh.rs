//! Where the intervals stand: short where a ball meets its pocket or loses a contact.

use crate::collocation::{Orbit, Radau};
use crate::system::{LEAD, ORBIT, OrbitSystem};
use tribodyn_bearing::Side;

/// Places at which the orbit is looked at.
const LOOKS: usize = 144;
/// What must change from one look to the next to count as much as the way itself.
const QUANTITIES: usize = 4;
/// Looks on either side over which the density is smoothed, so that neighbouring intervals are of like width.
const SMOOTH: usize = 3;

/// A mesh of `intervals` that divides evenly the arc over the turn of orbital speed, lead, pocket force and inner load.
pub(crate) fn graded(system: &OrbitSystem<'_>, radau: &Radau, orbit: &Orbit, intervals: usize) -> Vec<f64> {
    let values: Vec<[f64; QUANTITIES]> = (0..LOOKS)
        .map(|look| {
            let turn = look as f64 / LOOKS as f64;
            let y = orbit.at(radau, turn);
            let e = system.value(system.azimuth(turn), &y, orbit.cage_speed, orbit.ring);
            [y[ORBIT], y[LEAD], e.friction.pocket.force, e.loads.contacts[Side::Inner].normal.load]
        })
        .collect();
    let range = |k: usize| {
        let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v[k]), h.max(v[k])));
        high - low
    };
    // Changes below these are no events: a thousandth of the speed, of the force scale.
    let least = [1e-3 * orbit.cage_speed.abs(), 1e-3, 1e-3 * values.iter().map(|v| v[3]).fold(1.0, f64::max), 1.0];
    let ranges: [f64; QUANTITIES] = std::array::from_fn(|k| range(k).max(least[k]));
    let density: Vec<f64> = (0..LOOKS)
        .map(|look| {
            let (a, b) = (&values[look], &values[(look + 1) % LOOKS]);
            let way = 1.0 / LOOKS as f64;
            (0..QUANTITIES).map(|k| ((b[k] - a[k]) / ranges[k]).powi(2)).fold(way * way, |s, v| s + v).sqrt()
        })
        .collect();
    let smooth = |look: usize| {
        let near = (0..=2 * SMOOTH).map(|d| density[(look + LOOKS + d - SMOOTH) % LOOKS]);
        near.sum::<f64>() / (2 * SMOOTH + 1) as f64
    };
    let mut sums = vec![0.0];
    (0..LOOKS).for_each(|look| sums.push(sums[look] + smooth(look)));
    let total = sums[LOOKS];
    (0..=intervals)
        .map(|j| {
            let goal = total * j as f64 / intervals as f64;
            let at = sums.partition_point(|&s| s <= goal).clamp(1, LOOKS);
            let share = (goal - sums[at - 1]) / (sums[at] - sums[at - 1]);
            if j == intervals { 1.0 } else { (at as f64 - 1.0 + share) / LOOKS as f64 }
        })
        .collect()
}
