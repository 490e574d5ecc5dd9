//! Figure 14: contact angles, loads and pressures.

use super::over_azimuth::{Quantity, largest, least, limits, values};
use super::row::{Claim, Evidence, Row};
use super::runs::{Run, Runs};

/// Distance at which curves of a polar plot look identical: 1 % of the largest value, about a line's width.
const IDENTICAL: f64 = 0.01;
/// "Nearly twice": a quarter to either side.
const TWICE: [f64; 2] = [1.75, 2.25];
/// "Slightly above": by no more than Table 5's largest difference, 0.16 GPa at 0°, and its rounding, 0.01 GPa.
const SLIGHTLY: f64 = 0.17;

/// All rows of Figure 14.
pub fn figure_14(runs: &Runs) -> Vec<Row> {
    vec![
        same(runs, "F14.1.load", "largest difference of a load between cases, of the largest load", LOADS),
        same(runs, "F14.1.angle", "largest difference of an angle between cases, of the largest angle", ANGLES),
        above(runs, "F14.2.load", "Q_o > Q_i at every azimuth", "least Q_o/Q_i", |b| {
            b.contacts.outer.load_n / b.contacts.inner.load_n
        }),
        above(runs, "F14.2.angle", "α_i > α_o", "least α_i/α_o", |b| {
            b.contacts.inner.angle_rad.to_degrees() / b.contacts.outer.angle_rad.to_degrees()
        }),
        twice(runs),
        pressures(&runs.cases[0]),
    ]
}

const LOADS: [Quantity; 2] = [|b| b.contacts.inner.load_n, |b| b.contacts.outer.load_n];
const ANGLES: [Quantity; 2] =
    [|b| b.contacts.inner.angle_rad.to_degrees(), |b| b.contacts.outer.angle_rad.to_degrees()];

/// F14.1: how far apart the four cases are.
fn same(runs: &Runs, id: &'static str, measured: &'static str, quantities: [Quantity; 2]) -> Row {
    let claim = Claim {
        id,
        evidence: Evidence::Validation,
        text: "four cases give the same contact angles and loads",
        measured,
        unit: "%",
    };
    let [reference, others @ ..] = &runs.cases;
    let apart = |get: Quantity| {
        let size = largest(values(reference, get));
        let between = |other: &Run| largest(values(reference, get).zip(values(other, get)).map(|(a, b)| (a - b).abs()));
        largest(others.iter().map(between)) / size
    };
    let [inner, outer] = quantities.map(apart);
    let worst = inner.max(outer);
    let note = format!(
        "against case 1; met below {:.0} %, a line's width in a plot; inner {:.3} %, outer {:.3} %",
        100.0 * IDENTICAL,
        100.0 * inner,
        100.0 * outer
    );
    Row::claim(&claim, 100.0 * worst, worst < IDENTICAL, note)
}

/// F14.2: a ratio above 1 at every ball of every case.
fn above(runs: &Runs, id: &'static str, text: &'static str, measured: &'static str, ratio: Quantity) -> Row {
    let claim = Claim { id, evidence: Evidence::Validation, text, measured, unit: "" };
    let by_case: Vec<f64> = runs.cases.iter().map(|run| least(values(run, ratio))).collect();
    let worst = least(by_case.into_iter());
    Row::claim(&claim, worst, worst > 1.0, "over all balls of cases 1 to 4; met above 1".to_owned())
}

/// F14.3: heaviest over lightest load.
fn twice(runs: &Runs) -> Row {
    let claim = Claim {
        id: "F14.3",
        evidence: Evidence::Calibration,
        text: "heaviest load nearly twice the lightest",
        measured: "largest over least Q_o, case 1",
        unit: "",
    };
    let spread = |get: Quantity| {
        let [low, high] = limits(values(&runs.cases[0], get));
        high / low
    };
    let [inner, outer] = LOADS.map(spread);
    let met = (TWICE[0]..=TWICE[1]).contains(&outer);
    let note = format!(
        "met from {} to {}; inner loads {inner:.3}; Table 5's pressures cubed give 1.92 outside and 2.60 inside, so \
        the outer load is meant",
        TWICE[0], TWICE[1]
    );
    Row::claim(&claim, outer, met, note)
}

/// F14.4: inner above outer pressure.
fn pressures(run: &Run) -> Row {
    let claim = Claim {
        id: "F14.4",
        evidence: Evidence::Calibration,
        text: "p_i slightly above p_o at most azimuths",
        measured: "balls with p_i > p_o, case 1",
        unit: "balls",
    };
    let excess: Vec<f64> =
        values(run, |b| (b.contacts.inner.peak_pressure_pa - b.contacts.outer.peak_pressure_pa) * 1e-9).collect();
    let (count, most) = (excess.iter().filter(|&&e| e > 0.0).count(), largest(excess.iter().copied()));
    let met = 2 * count > excess.len() && most <= SLIGHTLY;
    let note = format!(
        "of {}; met by more than half of them with no excess above {SLIGHTLY} GPa (Table 5: up to 0.16); largest \
        {most:.3} GPa; Table 5 itself: above at 3 of 6 azimuths, equal at 2",
        excess.len()
    );
    Row { decimals: 0, ..Row::claim(&claim, count as f64, met, note) }
}
