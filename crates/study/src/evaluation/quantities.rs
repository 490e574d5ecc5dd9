//! Operating quantities of a run or a solution: one list for tables, JSON and comparisons.

use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::collections::BTreeMap;
use tribodyn_bearing::Side;
use tribodyn_bearing::quantities::{OfBall, Unit, joined};
use tribodyn_record::wire::Numbers;
use tribodyn_record::{BallRow, Run, SolutionRow, StateRow};

/// Least, mean and greatest value, or one value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Values {
    /// A value of one time, or of all.
    One(f64),
    /// Values of a part of a run, or of all balls.
    Span {
        /// Least.
        min: f64,
        /// Mean.
        mean: f64,
        /// Greatest.
        max: f64,
    },
}

/// A quantity with its names for people and for JSON.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Its name in JSON, without unit.
    pub key: Cow<'static, str>,
    /// Its name for people.
    pub name: Cow<'static, str>,
    /// The unit for people, and as the end of the name in JSON; both empty for a ratio or a count.
    pub unit: &'static str,
    /// The unit as the end of the name in JSON.
    pub suffix: &'static str,
    /// Decimals for people.
    pub digits: usize,
    /// In this unit.
    pub values: Values,
}

impl Quantity {
    /// The numbers with their names in JSON, which end in the unit, and for people.
    pub fn fields(&self) -> Vec<(String, String, f64)> {
        let named = |part: &str| {
            let parts = [&self.key, part, self.suffix];
            joined(&parts)
        };
        match self.values {
            Values::One(value) => vec![(named(""), self.name.to_string(), value)],
            Values::Span { min, mean, max } => {
                [("min", "least", min), ("mean", "mean", mean), ("max", "greatest", max)]
                    .map(|(part, word, value)| (named(part), format!("{}, {word}", self.name), value))
                    .to_vec()
            }
        }
    }
}

/// Quantities in the order of their table.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Quantities(pub Vec<Quantity>);

impl Quantities {
    /// The one value or the mean of a quantity.
    pub fn mean(&self, key: &str) -> Option<f64> {
        self.0.iter().find(|q| q.key == key).map(|q| match q.values {
            Values::One(value) | Values::Span { mean: value, .. } => value,
        })
    }
}

impl Serialize for Quantities {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let fields = self.0.iter().flat_map(Quantity::fields).map(|(key, _, value)| (key, value));
        fields.collect::<BTreeMap<String, f64>>().serialize(serializer)
    }
}

/// Least, mean and greatest of some numbers.
fn span(values: impl Iterator<Item = f64>) -> Option<Values> {
    let (mut min, mut max, mut sum, mut count) = (f64::INFINITY, f64::NEG_INFINITY, 0.0, 0.0);
    for value in values {
        (min, max) = (min.min(value), max.max(value));
        sum += value;
        count += 1.0;
    }
    (count > 0.0).then(|| Values::Span { min, mean: sum / count, max })
}

/// Names of a quantity: in JSON, for people, unit, end in JSON, digits.
type Names = (&'static str, &'static str, &'static str, &'static str, usize);

fn quantity((key, name, unit, suffix, digits): Names, values: Values) -> Quantity {
    Quantity { key: key.into(), name: name.into(), unit, suffix, digits, values }
}

const TORQUE: Names = ("friction_torque", "Friction torque", "N m", "nm", 4);
const CAGE: Names = ("cage_speed", "Cage speed", "r/min", "rpm", 3);
const DEFLECTIONS: [Names; 3] = [
    ("ring_displacement_x", "Ring displacement along X", "µm", "um", 3),
    ("ring_displacement_y", "Ring displacement along Y", "µm", "um", 3),
    ("ring_displacement_z", "Ring displacement along Z", "µm", "um", 3),
];

/// A number of a ball where a contact carries load.
type OfContact = (Names, Side, fn(&BallRow) -> f32);

const SPINS: [OfContact; 2] = [
    (("spin_to_roll_inner", "Spin-to-roll ratio, inner race", "", "", 4), Side::Inner, |b| b.spin_ratio_inner_per_m),
    (("spin_to_roll_outer", "Spin-to-roll ratio, outer race", "", "", 4), Side::Outer, |b| b.spin_ratio_outer_per_m),
];

/// Friction torque at a time: that of the drive of the ring that turns, N m, positive where it takes power.
pub fn friction_torque_nm(row: &StateRow) -> f64 {
    if row.inner_speed_rpm == 0.0 {
        row.outer_torque_nm * row.outer_speed_rpm.signum()
    } else {
        row.inner_torque_nm * row.inner_speed_rpm.signum()
    }
}

/// Displacement of the inner against the outer ring, µm.
pub fn ring_displacement_um(row: &StateRow) -> [f64; 3] {
    [
        row.inner_displacement_x_um - row.outer_displacement_x_um,
        row.inner_displacement_y_um - row.outer_displacement_y_um,
        row.inner_displacement_z_um - row.outer_displacement_z_um,
    ]
}

/// Of the part of a run from a time on.
pub fn of_run(run: &Run, from_s: f64, ball_radius_m: Option<f64>) -> Quantities {
    let states = || run.states.iter().filter(|row| row.time_s >= from_s);
    let mut all: Vec<Quantity> =
        [(CAGE, span(states().map(|row| row.cage_speed_rpm))), (TORQUE, span(states().map(friction_torque_nm)))]
            .into_iter()
            .chain(
                DEFLECTIONS
                    .into_iter()
                    .enumerate()
                    .map(|(k, n)| (n, span(states().map(|row| ring_displacement_um(row)[k])))),
            )
            .filter_map(|(names, values)| values.map(|values| quantity(names, values)))
            .collect();
    let rows: Vec<&[BallRow]> = run.balls.iter().filter(|(t, _)| *t >= from_s).map(|(_, b)| b.as_slice()).collect();
    all.extend(of_balls(&rows, &rows, ball_radius_m));
    Quantities(all)
}

/// Of a solution: the solved balls are those of the first sample, and the load zone is that of the recorded orbit.
pub fn of_solution(run: &Run, solution: &SolutionRow, ball_radius_m: Option<f64>) -> Quantities {
    let s = solution;
    let torque = s.shaft_torque_nm * if s.inner_speed_rpm < 0.0 { -1.0 } else { 1.0 };
    let mut all = vec![quantity(CAGE, Values::One(s.cage_speed_rpm)), quantity(TORQUE, Values::One(torque))];
    let moved = [s.ring_displacement_x_um, s.ring_displacement_y_um, s.ring_displacement_z_um];
    all.extend(DEFLECTIONS.into_iter().zip(moved).map(|(names, um)| quantity(names, Values::One(um))));
    let rows: Vec<&[BallRow]> = run.balls.iter().map(|(_, balls)| balls.as_slice()).collect();
    all.extend(of_balls(&rows[..rows.len().min(1)], &rows, ball_radius_m));
    Quantities(all)
}

/// Start transient: what came before the part of the means; empty without any.
pub fn of_start(run: &Run, until_s: f64) -> Quantities {
    let of = |get: fn(&StateRow) -> f64| span(run.states.iter().filter(|row| row.time_s < until_s).map(get));
    let all = [
        (("start_cage_speed", "Cage speed", "r/min", "rpm", 3), of(|r| r.cage_speed_rpm)),
        (("start_friction_torque", "Friction torque", "N m", "nm", 4), of(friction_torque_nm)),
        (("start_load_inner_max", "Load of the most loaded ball, inner race", "N", "n", 1), of(|r| r.load_inner_max_n)),
        (("start_load_outer_max", "Load of the most loaded ball, outer race", "N", "n", 1), of(|r| r.load_outer_max_n)),
        (("start_pocket_force_max", "Largest pocket force", "N", "n", 1), of(|r| r.pocket_force_max_n)),
    ];
    Quantities(all.into_iter().filter_map(|(names, values)| values.map(|v| quantity(names, v))).collect())
}

/// A quantity of the table, where reports have it.
fn reported(q: &OfBall, values: Values) -> Option<Quantity> {
    let facts = q.facts();
    let name = q.side().map_or(facts.label.into(), |side| format!("{}, {} race", facts.label, side.name()).into());
    let Unit { suffix, symbol, .. } = facts.shown;
    Some(Quantity { key: q.name().into(), name, unit: symbol, suffix, digits: facts.digits?, values })
}

fn of_balls(rows: &[&[BallRow]], orbit: &[&[BallRow]], ball_radius_m: Option<f64>) -> Vec<Quantity> {
    let balls = || rows.iter().flat_map(|balls| balls.iter());
    let loaded = |side: Side| {
        balls().filter(move |b| if side == Side::Inner { b.load_inner_n > 0.0 } else { b.load_outer_n > 0.0 })
    };
    let mut all: Vec<Quantity> = OfBall::all()
        .filter_map(|q| {
            let place = BallRow::place(&q.name_in(q.facts().shown))?;
            let there = |number: &f64| !q.facts().is_absence(*number);
            let values = match q.side() {
                None => span(balls().map(|b| b.number(place)).filter(there)),
                Some(side) => span(loaded(side).map(|b| b.number(place)).filter(there)),
            };
            reported(&q, values?)
        })
        .collect();
    if let Some(radius) = ball_radius_m {
        all.extend(SPINS.iter().filter_map(|(names, side, get)| {
            span(loaded(*side).map(|b| radius * f64::from(get(b)))).map(|values| quantity(*names, values))
        }));
    }
    all.extend(load_zone(rows, orbit));
    all
}

/// Part of the sum of all loads below which their resultant points nowhere, as under thrust.
const NO_DIRECTION: f64 = 0.01;

/// Part of the highest load at the inner race below which a ball is outside the load zone: balls rattle in the
/// clearance.
const CARRIED: f64 = 0.01;

/// Extent, direction and balls of the load zone: where the inner race carries a ball.
fn load_zone(rows: &[&[BallRow]], orbit: &[&[BallRow]]) -> Vec<Quantity> {
    let balls = || rows.iter().flat_map(|balls| balls.iter());
    let least = CARRIED * balls().map(|b| f64::from(b.load_inner_n)).fold(0.0, f64::max);
    let carried = |balls: &&&[BallRow]| balls.iter().filter(|b| f64::from(b.load_inner_n) > least).count() as f64;
    let all: f64 = orbit.iter().map(|balls| balls.len() as f64).sum();
    let Some(counts) = span(rows.iter().map(|balls| carried(&balls))).filter(|_| all > 0.0) else { return Vec::new() };
    let part = orbit.iter().map(|balls| carried(&balls)).sum::<f64>() / all;
    let mut found = vec![
        quantity(("load_zone", "Load zone, extent", "°", "deg", 1), Values::One(360.0 * part)),
        quantity(("loaded_balls", "Loaded balls", "", "", 2), counts),
    ];
    let (mut x, mut y, mut sum) = (0.0, 0.0, 0.0);
    let mut highest: Option<&BallRow> = None;
    for ball in balls().filter(|b| b.load_inner_n > 0.0) {
        let (load, azimuth) = (f64::from(ball.load_inner_n), f64::from(ball.azimuth_deg).to_radians());
        (x, y, sum) = (x + load * azimuth.cos(), y + load * azimuth.sin(), sum + load);
        highest = highest.filter(|h| h.load_inner_n >= ball.load_inner_n).or(Some(ball));
    }
    if x.hypot(y) > NO_DIRECTION * sum {
        let direction = y.atan2(x).to_degrees();
        found.push(quantity(("load_zone_middle", "Load zone, middle", "°", "deg", 1), Values::One(direction)));
    }
    if let Some(ball) = highest {
        let load = ("highest_load", "Highest ball load, inner race", "N", "n", 1);
        let azimuth = ("highest_load_azimuth", "Azimuth of the highest load", "°", "deg", 1);
        found.push(quantity(load, Values::One(ball.load_inner_n.into())));
        found.push(quantity(azimuth, Values::One(ball.azimuth_deg.into())));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two samples of four balls, of which those at 0° and, in the second, at 90° are loaded.
    fn run() -> Run {
        let ball = |index: u32, azimuth_deg: f32, load: f32| BallRow {
            index,
            azimuth_deg,
            load_inner_n: load,
            load_outer_n: load + 1.0,
            contact_angle_inner_deg: if load > 0.0 { 10.0 + load / 100.0 } else { -77.0 },
            spin_ratio_inner_per_m: 50.0,
            ..BallRow::default()
        };
        let at =
            |second: f32| vec![ball(0, 0.0, 300.0), ball(1, 90.0, second), ball(2, 180.0, 0.0), ball(3, 270.0, 0.0)];
        let state = |time_s: f64, inner_torque_nm: f64| StateRow {
            time_s,
            inner_torque_nm,
            inner_speed_rpm: -100.0,
            inner_displacement_x_um: 12.0,
            outer_displacement_x_um: 2.0,
            ..StateRow::default()
        };
        Run {
            states: vec![state(0.0, -9.0), state(1.0, -2.0), state(2.0, -4.0)],
            balls: vec![(0.0, at(900.0)), (1.0, at(2.0)), (2.0, at(100.0))],
            ..Run::default()
        }
    }

    fn field(all: &Quantities, key: &str) -> Option<f64> {
        all.0.iter().flat_map(Quantity::fields).find(|(name, ..)| name == key).map(|(.., value)| value)
    }

    #[test]
    fn limit_only_loaded_contacts_of_the_steady_part_count() {
        let all = of_run(&run(), 1.0, Some(0.005));
        for (key, expected) in [
            ("friction_torque_min_nm", 2.0),
            ("friction_torque_mean_nm", 3.0),
            ("friction_torque_max_nm", 4.0),
            ("ring_displacement_x_mean_um", 10.0),
            ("contact_angle_inner_min_deg", 10.02),
            ("contact_angle_inner_max_deg", 13.0),
            ("load_zone_deg", 135.0),
            ("loaded_balls_min", 1.0),
            ("loaded_balls_max", 2.0),
            ("highest_load_n", 300.0),
            ("highest_load_azimuth_deg", 0.0),
            ("spin_to_roll_inner_mean", 0.25),
        ] {
            let found = field(&all, key).unwrap();
            assert!((found - expected).abs() < 1e-5, "{key}: {found} instead of {expected}");
        }
        let middle = field(&all, "load_zone_middle_deg").unwrap();
        assert!((middle - (102.0f64 / 600.0).atan().to_degrees()).abs() < 1e-5, "{middle}");
        assert_eq!(field(&of_start(&run(), 1.0), "start_friction_torque_max_nm"), Some(9.0));
        assert!(of_start(&run(), 0.0).0.is_empty());
    }

    #[test]
    fn limit_without_a_sample_there_is_no_number() {
        assert_eq!(of_run(&Run::default(), 0.0, None), Quantities::default());
        // Equal loads all round point nowhere.
        let round = |k: u32| BallRow { azimuth_deg: 90.0 * k as f32, load_inner_n: 5.0, ..BallRow::default() };
        let even = Run { balls: vec![(0.0, (0..4).map(round).collect())], ..Run::default() };
        let all = of_run(&even, 0.0, None);
        assert_eq!((field(&all, "load_zone_middle_deg"), field(&all, "load_zone_deg")), (None, Some(360.0)));
    }
}
