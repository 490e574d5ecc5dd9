//! Figures 16 to 18: traction, slide-to-roll ratios and wear over azimuth.

use super::over_azimuth::{Quantity, by_case, heavy, largest, least, median, range, total, values, zone_mean};
use super::row::{Claim, Evidence, Row};
use super::runs::{Run, Runs};

/// "Clearly larger", "well above": by half at least.
const CLEARLY: f64 = 1.5;
/// "Mostly": more than half.
const MOSTLY: f64 = 0.5;

/// All rows of Figures 16 to 18.
pub fn figures_16_to_18(runs: &Runs) -> Vec<Row> {
    let mut rows = vec![
        traction_zone(runs, "F16.1.i", |b| b.contacts.inner.friction_or_nan().traction_n[0].abs(), true),
        traction_zone(runs, "F16.1.o", |b| b.contacts.outer.friction_or_nan().traction_n[0].abs(), false),
        traction_range(runs),
        slip_size(runs),
        slip_sign(runs),
    ];
    rows.extend(wear_order(runs));
    rows.push(wear_sides(runs));
    rows.push(race_wear_zone(runs, "F18.3.inner", |b| b.contacts.inner.friction_or_nan().wear_rate_m3_s));
    rows.push(race_wear_zone(runs, "F18.3.outer", |b| b.contacts.outer.friction_or_nan().wear_rate_m3_s));
    rows.push(cage_wear_zone(runs));
    rows
}

fn claim(id: &'static str, text: &'static str, measured: &'static str) -> Claim {
    Claim { id, evidence: Evidence::Validation, text, measured, unit: "" }
}

/// F16.1: |T| falls from heavy to light zone (`falls`), or rises.
fn traction_zone(runs: &Runs, id: &'static str, get: Quantity, falls: bool) -> Row {
    let (text, measured) = match falls {
        true => ("|T_i| falls from heavy to light zone", "largest |T_i| light over heavy zone, means, cases 1–4"),
        false => ("|T_o| rises from heavy to light zone", "least |T_o| light over heavy zone, means, cases 1–4"),
    };
    let ratio = |run: &Run| zone_mean(run, false, get) / zone_mean(run, true, get);
    let ratios = runs.cases.iter().map(ratio);
    let (worst, side) = if falls { (largest(ratios), "below") } else { (least(ratios), "above") };
    let met = if falls { worst < 1.0 } else { worst > 1.0 };
    Row::claim(&claim(id, text, measured), worst, met, format!("met {side} 1; {}", by_case(runs, 3, ratio)))
}

/// F16.2: varying parameters flatten T over azimuth.
fn traction_range(runs: &Runs) -> Row {
    let [one, two, three, four] = &runs.cases;
    let ratio = |varying: &Run, fixed: &Run, get: Quantity| range(varying, get) / range(fixed, get);
    let inner: Quantity = |b| b.contacts.inner.friction_or_nan().traction_n[0];
    let outer: Quantity = |b| b.contacts.outer.friction_or_nan().traction_n[0];
    let ratios = [ratio(one, two, inner), ratio(one, two, outer), ratio(three, four, inner), ratio(three, four, outer)];
    let worst = largest(ratios.into_iter());
    let [a, b, c, d] = ratios;
    let note =
        format!("met if all are below 1; case 1 over 2: T_i {a:.3}, T_o {b:.3}; case 3 over 4: T_i {c:.3}, T_o {d:.3}");
    let text = "T varies less over azimuth with varying parameters (1, 3) than without (2, 4)";
    Row::claim(
        &claim("F16.2", text, "largest ratio of ranges of T over azimuth, varying over fixed"),
        worst,
        worst < 1.0,
        note,
    )
}

/// F17.1: differential slip enlarges |ξ_i|.
fn slip_size(runs: &Runs) -> Row {
    let size = |run: &Run| median(run, |b| b.contacts.inner.friction_or_nan().slide_to_roll[0].abs());
    let [one, two, three, four] = &runs.cases;
    let ratio = size(one).min(size(two)) / size(three).max(size(four));
    let permille = |run: &Run| 1e3 * size(run);
    let note = format!("medians over the balls; met above {CLEARLY}; |ξ_i| in ‰: {}", by_case(runs, 3, permille));
    let text = "|ξ_i| in cases 1, 2 clearly larger than in 3, 4";
    let measured = "|ξ_i|, smaller of cases 1, 2 over larger of 3, 4";
    Row::claim(&claim("F17.1", text, measured), ratio, ratio > CLEARLY, note)
}

/// F17.2: sign of ξ_i by zone.
fn slip_sign(runs: &Runs) -> Row {
    let mut wrong = Vec::new();
    let (mut right, mut count) = (0, 0);
    for run in &runs.cases[..2] {
        for ball in &run.solution.balls {
            count += 1;
            if (ball.contacts.inner.friction_or_nan().slide_to_roll[0] < 0.0) == heavy(ball) {
                right += 1;
            } else {
                wrong.push(format!("{} {:.0}°", run.label, ball.azimuth_rad.to_degrees()));
            }
        }
    }
    let others = if wrong.is_empty() { "none".to_owned() } else { wrong.join(", ") };
    let note = format!("of {count}; met if all; with another sign: {others}");
    let text = "ξ_i in cases 1, 2 negative in the heavy zone, positive in the light zone";
    let claim = Claim { unit: "balls", ..claim("F17.2", text, "balls of cases 1, 2 with the stated sign") };
    Row { decimals: 0, ..Row::claim(&claim, f64::from(right), right == count, note) }
}

/// F18.1: what differential slip does to each wear rate.
fn wear_order(runs: &Runs) -> [Row; 3] {
    let [one, two, three, four] = &runs.cases;
    let row = |id, text, measured, get: Quantity, less: bool| {
        let sum = |run: &Run| total(run, get);
        let (ratio, side) = match less {
            true => (sum(one).max(sum(two)) / sum(three).min(sum(four)), "below"),
            false => (sum(one).min(sum(two)) / sum(three).max(sum(four)), "above"),
        };
        let met = if less { ratio < 1.0 } else { ratio > 1.0 };
        let scaled = |run: &Run| 1e12 * sum(run);
        let note = format!("met {side} 1; sums over the balls in 1e-12 m³/s: {}", by_case(runs, 3, scaled));
        Row::claim(&claim(id, text, measured), ratio, met, note)
    };
    let least_favourable = "larger of cases 1, 2 over smaller of 3, 4";
    [
        row(
            "F18.1.inner",
            "less wear of the inner race in cases 1, 2",
            least_favourable,
            |b| b.contacts.inner.friction_or_nan().wear_rate_m3_s,
            true,
        ),
        row(
            "F18.1.cage",
            "less wear of the cage in cases 1, 2",
            least_favourable,
            |b| b.pocket.unwrap_or_default().wear_rate_m3_s,
            true,
        ),
        row(
            "F18.1.outer",
            "more wear of the outer race in cases 1, 2",
            "smaller of cases 1, 2 over larger of 3, 4",
            |b| b.contacts.outer.friction_or_nan().wear_rate_m3_s,
            false,
        ),
    ]
}

/// F18.2: inner against outer race.
fn wear_sides(runs: &Runs) -> Row {
    let ratio = |run: &Run| {
        total(run, |b| b.contacts.inner.friction_or_nan().wear_rate_m3_s)
            / total(run, |b| b.contacts.outer.friction_or_nan().wear_rate_m3_s)
    };
    let worst = least(runs.cases.iter().map(ratio));
    let note = format!("sums over the balls; met above {CLEARLY}; {}", by_case(runs, 3, ratio));
    let text = "inner-race wear rate well above outer";
    Row::claim(&claim("F18.2", text, "least inner over outer wear, cases 1–4"), worst, worst > CLEARLY, note)
}

/// F18.3, races: highest wear in the heavy zone.
fn race_wear_zone(runs: &Runs, id: &'static str, get: Quantity) -> Row {
    let ratio = |run: &Run| {
        let most = |in_heavy: bool| largest(run.solution.balls.iter().filter(|b| heavy(b) == in_heavy).map(get));
        most(true) / most(false)
    };
    let worst = least(runs.cases.iter().map(ratio));
    let note = format!("met above 1; {}", by_case(runs, 3, ratio));
    let measured = "least ratio of the highest rates, heavy over light zone, cases 1–4";
    Row::claim(&claim(id, "race wear highest in the heavy zone", measured), worst, worst > 1.0, note)
}

/// F18.3, cage: most wear in the light zone.
fn cage_wear_zone(runs: &Runs) -> Row {
    let share = |run: &Run| {
        let light: f64 =
            run.solution.balls.iter().filter(|b| !heavy(b)).map(|b| b.pocket.unwrap_or_default().wear_rate_m3_s).sum();
        light / total(run, |b| b.pocket.unwrap_or_default().wear_rate_m3_s)
    };
    let worst = least(runs.cases.iter().map(share));
    let touching =
        |run: &Run| values(run, |b| b.pocket.unwrap_or_default().force_n).filter(|f| *f != 0.0).count() as f64;
    let note = format!(
        "met above {MOSTLY} in every case (NaN: no ball touches its pocket); {}; balls that touch: {}",
        by_case(runs, 3, share),
        by_case(runs, 0, touching)
    );
    let text = "cage wear mostly in the light zone";
    let measured = "least share of the light zone in cage wear, cases 1–4";
    // `least` passes over a case without pocket contact; such a case does not show the claim.
    let all_known = runs.cases.iter().all(|run| share(run).is_finite());
    Row::claim(&claim("F18.3.cage", text, measured), worst, all_known && worst > MOSTLY, note)
}
