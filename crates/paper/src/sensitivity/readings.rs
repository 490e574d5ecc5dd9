//! Other readings of the missed claims, on the unchanged runs: another average, zone, ring, direction or window.

use crate::error::PaperError;
use crate::files;
use crate::mean::{mean, rms};
use crate::table::{Table, markdown};
use crate::transient::{RPM, Set, StateSample, Transient};
use crate::validate::first_impacts_of;
use std::f64::consts::TAU;
use tribodyn_bearing::BallResult;

const RESULT: &str = "fixtures/expected/sensitivity-readings.csv";

type OfBall = fn(&BallResult) -> f64;
type OfState = fn(&StateSample) -> f64;

/// Statement of a claim about loads, zones or coatings.
#[derive(Clone, Copy)]
enum Says {
    Rises,
    Falls,
    /// All values above, or below, this.
    Above(f64),
    Below(f64),
    /// Each value within 10 of these.
    Near([f64; 4]),
}

impl Says {
    fn holds(self, values: &[f64]) -> bool {
        match self {
            Self::Rises => values.windows(2).all(|w| w[1] > w[0]),
            Self::Falls => values.windows(2).all(|w| w[1] < w[0]),
            Self::Above(limit) => values.iter().all(|v| *v > limit),
            Self::Below(limit) => values.iter().all(|v| *v < limit),
            Self::Near(wanted) => values.iter().zip(wanted).all(|(v, w)| (v - w).abs() <= THERE),
        }
    }
}

struct Reading {
    row: &'static str,
    text: String,
    values: Vec<f64>,
    says: Says,
}

const INNER: [OfState; 3] = [|s| s.inner_acceleration[0], |s| s.inner_acceleration[1], |s| s.inner_acceleration[2]];
const OUTER: [OfState; 2] = [|s| s.outer_acceleration[0], |s| s.outer_acceleration[1]];
const SLIP: [OfBall; 2] =
    [|b| b.contacts.inner.friction_or_nan().slide_to_roll[0], |b| b.contacts.outer.friction_or_nan().slide_to_roll[0]];
const SIDES: [&str; 2] = ["inner", "outer"];

/// Ways to average a number of the balls; a ball without inner contact has no angle and no slip that would mean
/// anything.
#[derive(Clone, Copy)]
struct Average {
    name: &'static str,
    of: fn(&mut Vec<(f64, f64)>) -> f64,
}

const AVERAGES: [Average; 6] = [
    Average { name: "mean", of: |v| mean(v.iter().map(|p| p.1)) },
    Average { name: "median", of: |v| middle(v) },
    Average { name: "rms", of: |v| rms(v.iter().map(|p| [p.1])) },
    Average { name: "greatest", of: |v| v.iter().fold(f64::NEG_INFINITY, |m, p| m.max(p.1)) },
    Average { name: "mean of the heavy zone", of: |v| mean(v.iter().filter(|p| p.0.cos() > 0.0).map(|p| p.1)) },
    Average { name: "mean of the light zone", of: |v| mean(v.iter().filter(|p| p.0.cos() <= 0.0).map(|p| p.1)) },
];

fn middle(values: &mut [(f64, f64)]) -> f64 {
    values.sort_by(|a, b| a.1.total_cmp(&b.1));
    values.get(values.len() / 2).map_or(f64::NAN, |p| p.1)
}

/// Azimuth and number of all balls at all times.
fn samples(run: &Transient, get: impl Fn(&BallResult) -> f64) -> Vec<(f64, f64)> {
    run.settled().all_balls().map(|b| (b.azimuth_rad, get(b))).collect()
}

fn loads(set: &Set) -> [&Transient; 4] {
    set.by_load().map(|(_, run)| run)
}

fn all(set: &Set) -> Vec<Reading> {
    let mut out = vibration(set);
    out.extend(directions(set));
    out.extend(speeds(set));
    out.extend(impacts(set));
    out.extend(contacts(set));
    out.extend(coatings(set));
    out.extend(cage(set));
    out
}

fn whole(run: &Transient, get: OfState) -> f64 {
    rms(run.trace.states.iter().map(|s| [get(s)]))
}

/// F22.1: by direction, ring and window.
fn vibration(set: &Set) -> Vec<Reading> {
    let mut out = Vec::new();
    let mut both = |text: String, of: &dyn Fn(&Transient) -> f64| {
        for (row, says) in [("F22.1.text", Says::Rises), ("F22.1.conclusion", Says::Falls)] {
            out.push(Reading { row, text: text.clone(), values: loads(set).map(of).to_vec(), says });
        }
    };
    for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
        both(format!("inner ring {axis}: rms"), &|run| run.settled().rms(INNER[k]));
        both(format!("inner ring {axis}: peak"), &|run| run.settled().peak(INNER[k]));
        both(format!("inner ring {axis}: rms of the whole run"), &|run| whole(run, INNER[k]));
    }
    for (k, axis) in ["x", "y"].into_iter().enumerate() {
        both(format!("outer ring {axis}: rms"), &|run| run.settled().rms(OUTER[k]));
        both(format!("outer ring {axis}: peak"), &|run| run.settled().peak(OUTER[k]));
    }
    out
}

/// F22.4: range over the loads along x, over that along the others.
fn directions(set: &Set) -> Vec<Reading> {
    let row = "F22.4";
    let range = |runs: &[&Transient], of: &dyn Fn(&Transient) -> f64| {
        let values: Vec<f64> = runs.iter().map(|run| of(run)).collect();
        let (low, high) = values.iter().fold((f64::INFINITY, 0.0f64), |(l, h), v| (l.min(*v), h.max(*v)));
        (high - low, mean(values.into_iter()))
    };
    let runs = loads(set);
    let inner = |text: &str, runs: &[&Transient], of: &dyn Fn(&Transient, OfState) -> f64, relative: bool| {
        let [x, y, z] = INNER.map(|get| {
            let (range, mean) = range(runs, &|run| of(run, get));
            if relative { range / mean } else { range }
        });
        Reading { row, text: text.to_owned(), values: vec![x / y, x / z], says: Says::Above(1.0) }
    };
    let rms = |run: &Transient, get: OfState| run.settled().rms(get);
    let outer = OUTER.map(|get| range(&runs, &|run| rms(run, get)).0);
    vec![
        inner("inner ring: rms; x over y, x over z", &runs, &rms, false),
        inner("inner ring: rms over its mean of the loads", &runs, &rms, true),
        inner("inner ring: rms from 50 % on", &runs[1..], &rms, false),
        inner("inner ring: peak", &runs, &|run, get| run.settled().peak(get), false),
        inner("inner ring: rms of the whole run", &runs, &whole, false),
        Reading {
            row,
            text: "outer ring: rms; x over y".to_owned(),
            values: vec![outer[0] / outer[1]],
            says: Says::Above(1.0),
        },
    ]
}

/// F22.2: of the cage, one ball, a zone.
fn speeds(set: &Set) -> Vec<Reading> {
    let reading = |text: &str, of: &dyn Fn(&Transient) -> f64| Reading {
        row: "F22.2",
        text: text.to_owned(),
        values: loads(set).map(of).to_vec(),
        says: Says::Rises,
    };
    let orbit = |run: &Transient| samples(run, |b| b.orbital_speed_rad_s / RPM);
    let mut out = vec![
        reading("cage", &|run| run.settled().cage_rpm()),
        reading("least of a ball", &|run| orbit(run).iter().fold(f64::INFINITY, |m, p| m.min(p.1))),
        reading("quasi-static start", &|run| run.start_rpm),
    ];
    for average in &AVERAGES[3..] {
        out.push(reading(average.name, &|run| (average.of)(&mut orbit(run))));
    }
    out
}

/// Azimuth of the sector in which a number is greatest, degrees from 0 to 360.
fn place(run: &Transient, get: OfBall) -> f64 {
    let sectors = run.settled().sectors(get);
    let most = (0..sectors.len()).max_by(|&a, &b| sectors[a].total_cmp(&sectors[b])).unwrap_or(0);
    360.0 * most as f64 / sectors.len() as f64
}

/// The paper's azimuths of first impacts at 25, 50, 75 and 100 % of the axial load, and how far off counts as there,
/// degrees.
const FIRST: [f64; 4] = [310.0, 290.0, 260.0, 240.0];
const THERE: f64 = 10.0;

/// F22.3: how likely a first impact is where the paper has it.
fn first_impacts(set: &Set) -> Reading {
    let share = |(run, wanted): (&Transient, f64)| {
        let all = first_impacts_of(run);
        all.iter().filter(|azimuth| (*azimuth - wanted).abs() <= THERE).count() as f64 / all.len() as f64
    };
    Reading {
        row: "F22.3",
        text: "share of the passages with a first impact within 10°; even over 180° to 360° it is 0.11".to_owned(),
        values: loads(set).into_iter().zip(FIRST).map(share).collect(),
        says: Says::Above(0.5),
    }
}

/// F22.3 and F19.3: where balls meet their pockets.
fn impacts(set: &Set) -> Vec<Reading> {
    let near = |text: &str, of: &dyn Fn(&Transient) -> f64| Reading {
        row: "F22.3",
        text: text.to_owned(),
        values: loads(set).map(of).to_vec(),
        says: Says::Near(FIRST),
    };
    let weighed = |wall: f64| {
        move |run: &Transient| {
            let force = |b: &BallResult| (wall * b.pocket.unwrap_or_default().force_n).max(0.0);
            let all = samples(run, force);
            let inside = |azimuth: f64| (245.0..=330.0).contains(&azimuth.rem_euclid(TAU).to_degrees());
            let total: f64 = all.iter().map(|p| p.1).sum();
            all.iter().filter(|p| inside(p.0)).map(|p| p.1).sum::<f64>() / total
        }
    };
    let share = |text: &str, of: &dyn Fn(&Transient) -> f64| Reading {
        row: "F19.3",
        text: text.to_owned(),
        values: [&set.ag, &set.ptfe].map(of).to_vec(),
        says: Says::Above(0.5),
    };
    vec![
        first_impacts(set),
        near("greatest pocket force", &|run| place(run, |b| b.pocket.unwrap_or_default().force_n.abs())),
        near("greatest force of the front wall", &|run| place(run, |b| -b.pocket.unwrap_or_default().force_n)),
        near("greatest force of the rear wall", &|run| place(run, |b| b.pocket.unwrap_or_default().force_n)),
        near("greatest orbital speed", &|run| place(run, |b| b.orbital_speed_rad_s)),
        near("least orbital speed", &|run| place(run, |b| -b.orbital_speed_rad_s)),
        near("greatest lead", &|run| place(run, |b| b.pocket.unwrap_or_default().lead_rad)),
        share("share of the impulse of the front wall", &weighed(-1.0)),
        share("share of the impulse of the rear wall", &weighed(1.0)),
    ]
}

/// F23.1: angles and slip.
fn contacts(set: &Set) -> Vec<Reading> {
    let mut out = Vec::new();
    let angles: [OfBall; 2] =
        [|b| b.contacts.inner.angle_rad.to_degrees(), |b| b.contacts.outer.angle_rad.to_degrees()];
    for (side, get) in SIDES.into_iter().zip(angles) {
        for average in [AVERAGES[1], AVERAGES[3], AVERAGES[4], AVERAGES[5]] {
            let values = loads(set).map(|run| (average.of)(&mut samples(run, get))).to_vec();
            out.push(Reading {
                row: "F23.1.angle",
                text: format!("{side}: {}", average.name),
                values,
                says: Says::Rises,
            });
        }
    }
    for (side, get) in SIDES.into_iter().zip(SLIP) {
        for average in AVERAGES {
            let values = loads(set).map(|run| (average.of)(&mut samples(run, |b| 1e3 * get(b).abs()))).to_vec();
            out.push(Reading {
                row: "F23.1.slip",
                text: format!("{side}: {}", average.name),
                values,
                says: Says::Falls,
            });
        }
    }
    out
}

/// F20.2 and F21.2: slip with PTFE over Ag, and of the heavy over the light zone.
fn coatings(set: &Set) -> Vec<Reading> {
    let mut out = Vec::new();
    let runs = [&set.ag, &set.ptfe];
    let total: [OfBall; 2] = [
        |b| {
            b.contacts.inner.friction_or_nan().slide_to_roll[0]
                .hypot(b.contacts.inner.friction_or_nan().slide_to_roll[1])
        },
        |b| {
            b.contacts.outer.friction_or_nan().slide_to_roll[0]
                .hypot(b.contacts.outer.friction_or_nan().slide_to_roll[1])
        },
    ];
    for (side, (along, both)) in SIDES.into_iter().zip(SLIP.into_iter().zip(total)) {
        for (what, get) in [("", along), (", with the lateral part", both)] {
            let of = |average: Average, run| (average.of)(&mut samples(run, |b| get(b).abs()));
            for average in AVERAGES {
                let [ag, ptfe] = runs.map(|run| of(average, run));
                let text = format!("{side}{what}: {}", average.name);
                out.push(Reading { row: "F20.2.coating", text, values: vec![ptfe / ag], says: Says::Above(1.0) });
            }
            let values = runs.map(|run| of(AVERAGES[4], run) / of(AVERAGES[5], run)).to_vec();
            let text = format!("{side}{what}: mean");
            out.push(Reading { row: "F21.2.slip", text, values, says: Says::Below(1.0) });
        }
    }
    out
}

/// F23.2 and F24.1: pocket force and wear of the pockets.
fn cage(set: &Set) -> Vec<Reading> {
    let mut out = Vec::new();
    for average in AVERAGES {
        let force = loads(set)
            .map(|run| (average.of)(&mut samples(run, |b| b.pocket.unwrap_or_default().force_n.abs())))
            .to_vec();
        let wear = loads(set)
            .map(|run| (average.of)(&mut samples(run, |b| 1e12 * b.pocket.unwrap_or_default().wear_rate_m3_s)))
            .to_vec();
        out.push(Reading { row: "F23.2.text", text: average.name.to_owned(), values: force, says: Says::Rises });
        out.push(Reading { row: "F24.1.cage", text: average.name.to_owned(), values: wear, says: Says::Falls });
    }
    out
}

fn number(value: f64) -> String {
    match value.abs() {
        v if v >= 100.0 => format!("{value:.0}"),
        v if v >= 1.0 => format!("{value:.2}"),
        _ => format!("{value:.3}"),
    }
}

/// Works all readings out and writes them.
pub fn write(set: &Set) -> Result<(), PaperError> {
    let mut readings = all(set);
    readings.sort_by_key(|r| r.row);
    let line = |r: &Reading| {
        let values: Vec<String> = r.values.iter().map(|v| number(*v)).collect();
        let verdict = if r.says.holds(&r.values) { "met" } else { "missed" };
        format!("{},{},{},{verdict}", r.row, r.text.replace(',', " and"), values.join(" "))
    };
    let lines: Vec<String> = readings.iter().map(line).collect();
    let text = format!(
        "# our own output; rewritten by `cargo xtask sensitivity`\n# other readings of the missed rows on the runs as \
        identified, fast scheme at 20 us; values at 25, 50, 75 and 100 % of the axial load, or with Ag and \
        PTFE\nrow,reading,values,verdict\n{}\n",
        lines.join("\n")
    );
    files::write(&files::root().join(RESULT), text.as_bytes())
}

/// The document's table: what turns, and how many do not.
pub fn block() -> Result<String, PaperError> {
    let text = files::read(&files::root().join(RESULT))?;
    let table = Table::read(RESULT, &text)?;
    let mut counts: Vec<(&str, usize, Vec<String>)> = Vec::new();
    for row in table.rows() {
        if counts.last().is_none_or(|last| last.0 != row.first()) {
            counts.push((row.first(), 0, Vec::new()));
        }
        let Some((_, readings, met)) = counts.last_mut() else { continue };
        *readings += 1;
        if row.text("verdict")? == "met" {
            met.push(format!("{} ({})", row.text("reading")?, row.text("values")?.replace(' ', ", ")));
        }
    }
    let first = |met: &[String]| met.first().map_or_else(|| "none".to_owned(), Clone::clone);
    let rows: Vec<Vec<String>> = counts
        .iter()
        .map(|(row, readings, met)| vec![(*row).to_owned(), readings.to_string(), met.len().to_string(), first(met)])
        .collect();
    let head = ["row", "readings", "met", "such as"];
    Ok(format!("Other readings of the claims on the unchanged runs (`{RESULT}`):\n\n{}", markdown(&head, &rows)))
}
