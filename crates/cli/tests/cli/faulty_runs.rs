//! Runs of catalogue bearings whose races are rough or damaged, as `new` writes the rest.

use super::{Scratch, run};

/// Waves of a race, 1 µm n^−1.5.
fn waves(race: &str, seed: u32) -> String {
    format!("deviations.{race}=(spectrum: (first: 2, last: 60, amplitude: um(1), exponent: 1.5, seed: {seed}))")
}

/// Powers of a run of so many seconds with such waves: at the shaft, lost, and the imbalance in per cent.
fn powers(designation: &str, duration: &str, spalls: &str) -> [f64; 3] {
    let scratch = Scratch::new();
    let [case, recording] = ["case.ron", "run.mcap"].map(|name| scratch.0.join(name));
    run(&[&"new", &designation, &"-o", &case]).table();
    let [inner, outer, spalls] = [waves("inner", 1), waves("outer", 2), format!("spalls={spalls}")];
    let answer = run(&[
        &"run",
        &case,
        &"-o",
        &recording,
        &"--json",
        &"--duration",
        &duration,
        &"--set",
        &inner,
        &"--set",
        &outer,
        &"--set",
        &spalls,
    ]);
    let power = &answer.json()["power"];
    let of = |name: &str| power[name].as_f64().unwrap();
    let lost = ["friction_inner_w", "friction_outer_w", "contact_damping_w"].map(of);
    [of("shaft_w"), lost.iter().sum(), of("imbalance_percent")]
}

/// Balls that a strike makes slide come to rolling and not beyond, and the others stay there. Where loads vibrated,
/// linear tractions reached as far in slip as in load and threw balls to and fro: the power at the shaft was 6 to 17 %
/// too large. By Runge–Kutta of 0.5 µs the spall changes it by 0.2 %.
#[test]
fn regress_strikes_leave_the_power_at_the_shaft() {
    let [round, lost, _] = powers("6206", "0.03", "[]");
    let spall = "[(race: Outer, azimuth: deg(-90), length: mm(1), width: mm(3), depth: um(50))]";
    let [struck, lost_then, _] = powers("6206", "0.03", spall);
    assert!((struck / round - 1.0).abs() < 0.01, "{struck} and {round} W");
    assert!((lost_then / lost - 1.0).abs() < 0.01, "{lost_then} and {lost} W");
}

/// The shock in which rough races meet a round start dies out: carried on by the fast scheme's common acceleration it
/// left 42 % of the work unaccounted for. By Runge–Kutta the shaft has 3.230 W.
#[test]
fn regress_rough_races_begin_without_swinging() {
    let [shaft, _, imbalance] = powers("608", "0.02", "[]");
    assert!(imbalance.abs() < 1.0, "{imbalance} %");
    assert!((shaft / 3.230 - 1.0).abs() < 0.005, "{shaft} W");
}
