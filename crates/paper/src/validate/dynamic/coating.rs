//! F20 and F21: silver against PTFE.

use super::{CLEARLY, IDENTICAL, claim};
use crate::transient::{SECTORS, Set, Window};
use crate::validate::row::Row;
use tribodyn_bearing::BallResult;

type Quantity = fn(&BallResult) -> f64;

const SLIP: [Quantity; 2] = [
    |b| b.contacts.inner.friction_or_nan().slide_to_roll[0].abs(),
    |b| b.contacts.outer.friction_or_nan().slide_to_roll[0].abs(),
];
const SPIN: [Quantity; 2] = [|b| b.contacts.inner.spin_ratio_per_m.abs(), |b| b.contacts.outer.spin_ratio_per_m.abs()];

/// Wear of both races of a ball.
pub(super) fn race_wear(ball: &BallResult) -> f64 {
    ball.contacts.inner.friction_or_nan().wear_rate_m3_s + ball.contacts.outer.friction_or_nan().wear_rate_m3_s
}

pub(super) fn rows(set: &Set) -> Vec<Row> {
    let [ag, ptfe] = [&set.ag, &set.ptfe].map(|run| run.settled());
    let mut rows = same(&ag, &ptfe);
    rows.extend(slips(&ag, &ptfe));
    rows.extend(wear(set, &ag, &ptfe));
    rows
}

/// F20.1: loads and angles.
fn same(ag: &Window, ptfe: &Window) -> Vec<Row> {
    let difference = |get: Quantity| {
        let (a, b) = (ag.sectors(get), ptfe.sectors(get));
        let largest = a.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        (0..SECTORS).fold(0.0, |most: f64, k| most.max((a[k] - b[k]).abs())) / largest
    };
    let row = |id, measured, inner: Quantity, outer: Quantity| {
        let [i, o] = [difference(inner), difference(outer)];
        let note = format!("means in 10° sectors; met below 1 %; inner {:.3} %, outer {:.3} %", 100.0 * i, 100.0 * o);
        claim(id, "loads and angles do not depend on the coating", measured).in_unit("%").row(
            100.0 * i.max(o),
            i.max(o) < IDENTICAL,
            note,
        )
    };
    let load = "largest difference of a load, of the largest load";
    let angle = "largest difference of an angle, of the largest angle";
    vec![
        row("F20.1.load", load, |b| b.contacts.inner.load_n, |b| b.contacts.outer.load_n),
        row("F20.1.angle", angle, |b| b.contacts.inner.angle_rad, |b| b.contacts.outer.angle_rad),
    ]
}

/// F20.2: slip and spin.
fn slips(ag: &Window, ptfe: &Window) -> Vec<Row> {
    let mean = |w: &Window, get: Quantity| w.ball_mean(get);
    let [inner, outer] = SLIP.map(|get| mean(ptfe, get) / mean(ag, get));
    let sides = [ag, ptfe].map(|w| mean(w, SLIP[1]) / mean(w, SLIP[0]));
    let spins = [ag, ptfe].map(|w| mean(w, SPIN[1]) / mean(w, SPIN[0]));
    let least = |pair: [f64; 2]| pair[0].min(pair[1]);
    vec![
        claim("F20.2.coating", "|ξ| larger with PTFE than with Ag", "least mean |ξ| with PTFE over Ag").row(
            least([inner, outer]),
            least([inner, outer]) > 1.0,
            format!("met above 1; inner {inner:.3}, outer {outer:.3}"),
        ),
        claim("F20.2.sides", "|ξ_o| well above |ξ_i|", "least mean |ξ_o| over |ξ_i|").row(
            least(sides),
            least(sides) > CLEARLY,
            format!("met above 1.5; Ag {:.3}, PTFE {:.3}", sides[0], sides[1]),
        ),
        claim("F20.2.spin", "outer spin ratio below inner", "largest mean |φ_o| over |φ_i|").row(
            spins[0].max(spins[1]),
            spins[0].max(spins[1]) < 1.0,
            format!("met below 1; Ag {:.3}, PTFE {:.3}", spins[0], spins[1]),
        ),
    ]
}

/// F21: wear of both races.
fn wear(set: &Set, ag: &Window, ptfe: &Window) -> Vec<Row> {
    let ratio = ptfe.ball_mean(race_wear) / ag.ball_mean(race_wear);
    let constant = |case: &tribodyn_case::Case| {
        case.wear.as_ref().map_or(f64::NAN, |wear| wear.inner.coefficient / wear.inner.hardness)
    };
    let same_hardness = ratio * constant(&set.ag.case) / constant(&set.ptfe.case);
    let zones = [ag, ptfe].map(|w| w.zone_mean(true, race_wear) / w.zone_mean(false, race_wear));
    let slip = |b: &BallResult| SLIP[0](b) + SLIP[1](b);
    let slips = [ag, ptfe].map(|w| w.zone_mean(true, slip) / w.zone_mean(false, slip));
    let text = "ball–race wear with PTFE well above Ag";
    vec![
        claim("F21.1", text, "mean race wear with PTFE over Ag").row(
            ratio,
            ratio > CLEARLY,
            "met above 1.5; the case's hardnesses, 30 and 250 MPa, are assumed and make 8.3 of it",
        ),
        claim("F21.1.slip", "more wear with PTFE because it slips more", "the same at one hardness").row(
            same_hardness,
            same_hardness > 1.0,
            "met above 1: what load and slip alone make of it",
        ),
        claim("F21.2.wear", "ball–race wear higher in the heavy zone", "least race wear, heavy over light zone").row(
            zones[0].min(zones[1]),
            zones[0].min(zones[1]) > 1.0,
            format!("met above 1; Ag {:.3}, PTFE {:.3}", zones[0], zones[1]),
        ),
        claim("F21.2.slip", "|ξ| lower in the heavy zone", "largest mean |ξ|, heavy over light zone").row(
            slips[0].max(slips[1]),
            slips[0].max(slips[1]) < 1.0,
            format!("met below 1; Ag {:.3}, PTFE {:.3}", slips[0], slips[1]),
        ),
    ]
}
