//! F22 to F24: 25, 50, 75 and 100 % of the axial load with the whole radial load.

use super::coating::race_wear;
use super::{AZIMUTH, by_load, claim, number};
use crate::transient::{Set, Transient};
use crate::validate::row::{Evidence, Row};
use tribodyn_bearing::BallResult;

/// The paper's first impacts, percent of the axial load and degrees.
const FIRST_IMPACTS: [f64; 4] = [310.0, 290.0, 260.0, 240.0];
/// Range in which the first impact is looked for: on the way from light to heavy zone, as the paper sees all of them.
const RISING_HALF: [f64; 2] = [180.0, 360.0];

/// Least ratio of a value to the one before it, from 25 to 100 %: above 1 it rises all the way.
fn least_step(set: &Set, value: impl Fn(&Transient) -> f64) -> f64 {
    let values = set.by_load().map(|(_, run)| value(run));
    values.windows(2).map(|pair| pair[1] / pair[0]).fold(f64::INFINITY, f64::min)
}

/// Largest such ratio: below 1 it falls all the way.
fn largest_step(set: &Set, value: impl Fn(&Transient) -> f64) -> f64 {
    1.0 / least_step(set, |run| 1.0 / value(run))
}

fn rising(
    set: &Set,
    id: &'static str,
    text: &'static str,
    value: impl Fn(&Transient) -> f64 + Copy,
    note: String,
) -> Row {
    let step = least_step(set, value);
    claim(id, text, "least ratio of neighbouring loads, 25 to 100 %").row(
        step,
        step > 1.0,
        format!("met above 1; {note}"),
    )
}

fn falling(
    set: &Set,
    id: &'static str,
    text: &'static str,
    value: impl Fn(&Transient) -> f64 + Copy,
    note: String,
) -> Row {
    let step = largest_step(set, value);
    let measured = "largest ratio of neighbouring loads, 25 to 100 %";
    claim(id, text, measured).row(step, step < 1.0, format!("met below 1; {note}"))
}

/// Root of the sum of squares of the inner ring's accelerations.
fn vibration(run: &Transient) -> f64 {
    let window = run.settled();
    [0, 1, 2].map(|k| window.rms(|s| s.inner_acceleration[k]).powi(2)).iter().sum::<f64>().sqrt()
}

fn mean(run: &Transient, get: fn(&BallResult) -> f64) -> f64 {
    run.settled().ball_mean(get)
}

pub(super) fn rows(set: &Set) -> Vec<Row> {
    let mut rows = shaking(set);
    rows.extend(first_impacts(set));
    rows.push(direction(set));
    rows.extend(contacts(set));
    rows.extend(cage(set));
    rows
}

fn shaking(set: &Set) -> Vec<Row> {
    let note = || format!("rms of the inner ring in m/s²: {}", by_load(set, vibration, 2));
    let speed = |run: &Transient| run.settled().mean_orbit_rpm();
    vec![
        rising(set, "F22.1.text", "ring acceleration rises with axial load (section 5.2.2)", vibration, note()),
        falling(set, "F22.1.conclusion", "ring vibration falls with axial load (conclusion 3)", vibration, note()),
        rising(
            set,
            "F22.2",
            "orbital speed falls as axial load falls",
            speed,
            format!("mean of the balls in r/min: {}", by_load(set, speed, 1)),
        ),
    ]
}

/// Azimuths of the first impacts of all passages through [`RISING_HALF`], degrees, in order of size.
pub fn first_impacts_of(run: &Transient) -> Vec<f64> {
    let window = run.settled();
    let period = 1.0 / window.cage_hz();
    let mut firsts = Vec::new();
    for ball in 0..run.case.geometry.ball_count {
        let mut last = f64::NEG_INFINITY;
        for impact in window.impacts().filter(|i| i.ball == ball) {
            let inside = (RISING_HALF[0]..RISING_HALF[1]).contains(&impact.azimuth_deg);
            // Impacts of one passage of the half orbit lie within half a period.
            if inside && impact.time_s - last > 0.5 * period {
                firsts.push(impact.azimuth_deg);
                last = impact.time_s;
            }
        }
    }
    firsts.sort_by(f64::total_cmp);
    firsts
}

/// Their median.
fn first_impact(run: &Transient) -> f64 {
    let firsts = first_impacts_of(run);
    firsts.get(firsts.len() / 2).copied().unwrap_or(f64::NAN)
}

fn first_impacts(set: &Set) -> Vec<Row> {
    let ids = ["F22.3.25", "F22.3.50", "F22.3.75", "F22.3.100"];
    let one = |((id, (percent, run)), published): ((&str, (u32, &Transient)), f64)| {
        let quantity = format!("first impact at {percent} % axial load");
        let note =
            "median over balls and orbits, first impact from 180° on; half a step of the published azimuths is allowed";
        let values = [published, first_impact(run), AZIMUTH];
        number(id, &quantity, "°", values, 0, Evidence::Validation, note)
    };
    ids.into_iter().zip(set.by_load()).zip(FIRST_IMPACTS).map(one).collect()
}

/// F22.4: how far the rms of each direction varies over the loads.
fn direction(set: &Set) -> Row {
    let [x, y, z] = [0, 1, 2].map(|k: usize| {
        let values = set.by_load().map(|(_, run)| run.settled().rms(|s| s.inner_acceleration[k]));
        let [low, high] = values.iter().fold([f64::INFINITY, 0.0], |[l, h]: [f64; 2], v| [l.min(*v), h.max(*v)]);
        high - low
    });
    let ratio = x / y.max(z);
    claim(
        "F22.4",
        "x direction most sensitive to axial load",
        "range of the rms over the loads, x over the larger of y, z",
    )
    .row(ratio, ratio > 1.0, format!("met above 1; m/s²: x {x:.2}, y {y:.2}, z {z:.2}"))
}

fn contacts(set: &Set) -> Vec<Row> {
    let load: [fn(&BallResult) -> f64; 2] = [|b| b.contacts.inner.load_n, |b| b.contacts.outer.load_n];
    let angle: [fn(&BallResult) -> f64; 2] =
        [|b| b.contacts.inner.angle_rad.to_degrees(), |b| b.contacts.outer.angle_rad.to_degrees()];
    let slip: [fn(&BallResult) -> f64; 2] = [
        |b| 1e3 * b.contacts.inner.friction_or_nan().slide_to_roll[0].abs(),
        |b| 1e3 * b.contacts.outer.friction_or_nan().slide_to_roll[0].abs(),
    ];
    let both = |get: [fn(&BallResult) -> f64; 2], decimals| {
        let [i, o] = get.map(|get| by_load(set, |run| mean(run, get), decimals));
        format!("means over balls and time: inner {i}; outer {o}")
    };
    let text = "angles and loads rise with axial load";
    let least = |get: [fn(&BallResult) -> f64; 2]| {
        get.map(|get| least_step(set, |run| mean(run, get))).iter().fold(f64::INFINITY, |l: f64, v| l.min(*v))
    };
    let most = slip.map(|get| largest_step(set, |run| mean(run, get))).iter().fold(0.0, |h: f64, v| h.max(*v));
    let measured = "least ratio of neighbouring loads, 25 to 100 %, inner and outer";
    vec![
        claim("F23.1.load", text, measured).row(
            least(load),
            least(load) > 1.0,
            format!("met above 1; N, {}", both(load, 0)),
        ),
        claim("F23.1.angle", text, measured).row(
            least(angle),
            least(angle) > 1.0,
            format!("met above 1; °, {}", both(angle, 2)),
        ),
        claim(
            "F23.1.slip",
            "|ξ| falls as axial load rises",
            "largest ratio of neighbouring loads, 25 to 100 %, inner and outer",
        )
        .row(most, most < 1.0, format!("met below 1; ‰, {}", both(slip, 3))),
    ]
}

fn cage(set: &Set) -> Vec<Row> {
    let force = |run: &Transient| run.settled().pocket_peak();
    let forces = || format!("largest pocket force in N: {}", by_load(set, force, 0));
    let race = |run: &Transient| run.settled().ball_mean(race_wear) * 1e12;
    let pocket = |run: &Transient| run.settled().ball_mean(|b| b.pocket.unwrap_or_default().wear_rate_m3_s) * 1e12;
    let per_ball = |text: String| format!("mean of a ball in 1e-12 m³/s: {text}");
    vec![
        rising(set, "F23.2.text", "peak ball–cage force grows with axial load (text on Fig. 23d)", force, forces()),
        falling(set, "F23.2.fig24", "peak ball–cage force falls with axial load (text on Fig. 24)", force, forces()),
        rising(set, "F24.1.race", "ball–race wear rises with axial load", race, per_ball(by_load(set, race, 1))),
        falling(
            set,
            "F24.1.cage",
            "ball–cage wear falls as axial load rises",
            pocket,
            per_ball(by_load(set, pocket, 1)),
        ),
    ]
}
