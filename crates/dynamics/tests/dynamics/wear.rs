//! Wear and defects in the loop.

use crate::{Keep, case, run};
use tribodyn_case::Case;
use tribodyn_dynamics::{EventKind, PowerSample, Run, Sample};

fn with(text: &str, changes: &[(&str, &str)]) -> Case {
    let changed = changes.iter().fold(text.to_owned(), |text, (path, value)| {
        tribodyn_case::set_value(&text, path, value).unwrap_or_else(|e| panic!("{path}: {e}"))
    });
    Case::from_ron(&changed).unwrap_or_else(|e| panic!("{e}"))
}

const WORN: &str = include_str!("../../../../fixtures/cases/paper-ag-worn.ron");
const SHORT: [(&str, &str); 3] = [
    ("traction.patch", "SplitStrip(across: 5, along: 3)"),
    ("transient.scheme", "RungeKutta4(step: us(5))"),
    ("transient.duration", "s(0.002)"),
];

#[test]
fn identity_volumes_are_the_rates_summed() {
    let (_, keep) = run(&case(&[("transient.duration", "s(0.002)"), ("recording.ball_rate", "kHz(25.6)")]));
    let rate = |s: &tribodyn_dynamics::Sample| {
        s.balls.iter().map(|b| b.contacts.inner.friction_or_nan().wear_rate_m3_s).sum::<f64>()
    };
    let summed: f64 = keep.samples.windows(2).map(|w| 0.5 * (rate(&w[0]) + rate(&w[1])) / 25_600.0).sum();
    let last = keep.samples.last().unwrap();
    let volume = last.wear.volume_inner_m3;
    assert!((volume / summed - 1.0).abs() < 0.01, "{volume:e} {summed:e}");
}

/// Where a ball passes the pit its outer load drops, and bare steel changes its traction.
#[test]
fn identity_a_defect_is_felt_by_the_ball_that_passes() {
    let (_, keep) = run(&with(WORN, &SHORT));
    let hit = |s: &tribodyn_dynamics::Sample| {
        s.balls.iter().any(|b| b.contacts.outer.transient.unwrap_or_default().bare > 0.5)
    };
    assert!(keep.samples.iter().any(hit) && !keep.samples.iter().all(hit));
    let deepest = keep
        .samples
        .iter()
        .flat_map(|s| &s.balls)
        .map(|b| b.contacts.outer.transient.unwrap_or_default().depth_m)
        .fold(0.0, f64::max);
    assert!(deepest > 6e-6, "{deepest:e}");
    let quiet = run(&with(WORN, &[&SHORT[..], &[("defects", "[]")]].concat())).1;
    let strongest = |k: &Keep| k.samples.iter().map(|s| s.outer.acceleration_m_s2[0].abs()).fold(0.0, f64::max);
    assert!(strongest(&keep) > 3.0 * strongest(&quiet), "{} {}", strongest(&keep), strongest(&quiet));
}

/// The balance holds while balls pass a pit: the slope of the groove does work on the orbit. (At the edges of the pit
/// the scheme errs by some 1e-8; without a defect by 2e-13.)
#[test]
fn identity_power_balances_over_a_defect() {
    let share = |changes: &[(&str, &str)]| {
        let changes = [&SHORT[..], &[("transient.scheme", "RungeKutta4(step: us(2))")], changes].concat();
        let power = run(&with(WORN, &changes)).1.samples.pop().unwrap().power;
        (power.imbalance_j / power.throughput_j).abs()
    };
    let (with_pit, without) = (share(&[]), share(&[("defects", "[]")]));
    assert!(with_pit < 1e-7 && without < 1e-10, "{with_pit:e} {without:e}");
}

#[test]
fn limit_accelerated_wear_goes_through_the_coating_and_says_so() {
    let changes = [&SHORT[..], &[("transient.wear_acceleration", "5e4"), ("defects", "[]")]].concat();
    let case = with(WORN, &changes);
    let mut keep = Keep::default();
    let mut run = Run::new(case.run_inputs().unwrap()).unwrap();
    let _ = run.advance(f64::INFINITY, &mut keep).unwrap();
    let through = keep.events.iter().filter(|e| matches!(e.kind, EventKind::CoatingThrough { .. })).count();
    assert!(through >= 1, "{:?}", keep.samples.last().unwrap().wear);
    assert!(
        keep.samples.last().unwrap().balls.iter().any(|b| b.contacts.inner.transient.unwrap_or_default().bare > 0.0
            || b.contacts.outer.transient.unwrap_or_default().bare > 0.0)
    );
}

/// Wear lowers the races under loaded balls: the elastic energy that goes with it is counted. Without it 3e-5 of the
/// work and more would be missing.
#[test]
fn identity_power_balances_while_races_wear() {
    let changes =
        [("transient.scheme", "RungeKutta4(step: us(2))"), ("transient.wear_acceleration", "1e5"), ("defects", "[]")];
    let power = run(&with(WORN, &[&SHORT[..], &changes].concat())).1.samples.pop().unwrap().power;
    let (off, taken) = (power.imbalance_j / power.throughput_j, power.wear_work_j / power.throughput_j);
    assert!(taken > 1e-5 && off.abs() < 0.05 * taken, "{off:e} missing, {taken:e} taken by wear");
}

/// The groove of a tilted ring climbs along the orbit, and the normal force has a part along it.
#[test]
fn identity_power_balances_in_a_tilted_ring() {
    let changes = [
        ("transient.scheme", "RungeKutta4(step: us(2))"),
        ("defects", "[]"),
        ("ring.tilt_x", "Held(mrad(0.4))"),
        ("ring.tilt_y", "Held(mrad(-0.2))"),
    ];
    let power = run(&with(WORN, &[&SHORT[..], &changes].concat())).1.samples.pop().unwrap().power;
    let off = power.imbalance_j / power.throughput_j;
    assert!(off.abs() < 1e-8, "{off:e}");
}

/// Where balls slow down, what they lose was stored and not put in: the balance is measured against what is lost.
#[test]
fn identity_throughput_is_no_less_than_what_is_lost() {
    let changes = [
        ("transient.scheme", "RungeKutta4(step: us(2))"),
        ("speed.inner", "Table([(s(0), rpm(14000)), (s(0.002), rpm(13870))])"),
    ];
    let samples = run(&with(WORN, &[&SHORT[..], &changes].concat())).1.samples;
    let (first, last) = (&samples[0].power, &samples[samples.len() - 1].power);
    let integral = |power: fn(&PowerSample) -> f64| -> f64 {
        let mean = |w: &[Sample]| 0.5 * (power(&w[0].power) + power(&w[1].power));
        samples.windows(2).map(|w| mean(w) * (w[1].time_s - w[0].time_s)).sum()
    };
    let (lost, put_in) = (integral(PowerSample::lost), integral(|p| p.shaft_w.abs() + p.load_w.abs()));
    assert!(put_in < 0.8 * lost, "{put_in} J of {lost} J: the case no longer shows what it is for");
    assert!(last.energy_j < first.energy_j && last.throughput_j >= 0.99 * lost, "{last:?}, {lost} J lost");
}
