//! Runs of catalogue bearings whose races are rough or damaged, or that a load strikes, as `new` writes the rest.

use super::{Scratch, run};
use serde_json::Value;
use std::ffi::OsStr;

/// Waves of a race, 1 µm n^−1.5.
fn waves(race: &str, seed: u32) -> String {
    format!("deviations.{race}=(spectrum: (first: 2, last: 60, amplitude: um(1), exponent: 1.5, seed: {seed}))")
}

/// Answer of a run of so many seconds of a bearing as `new` writes it, with changes to the case.
fn answer(bearing: &[&str], duration: &str, changes: &[String]) -> Value {
    let scratch = Scratch::new();
    let [case, recording] = ["case.ron", "run.mcap"].map(|name| scratch.0.join(name));
    let mut new: Vec<&dyn AsRef<OsStr>> = vec![&"new", &"-o", &case];
    bearing.iter().for_each(|word| new.push(word));
    run(&new).table();
    let mut words: Vec<&dyn AsRef<OsStr>> = vec![&"run", &case, &"-o", &recording, &"--json", &"--duration", &duration];
    changes.iter().for_each(|change| words.extend([&"--set" as &dyn AsRef<OsStr>, change]));
    run(&words).json()
}

/// Powers of such a run: at the shaft, lost, and the imbalance in per cent.
fn powers(designation: &str, duration: &str, changes: &[String]) -> [f64; 3] {
    let power = &answer(&[designation], duration, changes)["power"];
    let of = |name: &str| power[name].as_f64().unwrap();
    let lost = ["friction_inner_w", "friction_outer_w", "contact_damping_w"].map(of);
    [of("shaft_w"), lost.iter().sum(), of("imbalance_percent")]
}

/// The same with rough races, and other changes.
fn powers_if_rough(designation: &str, duration: &str, more: &[String]) -> [f64; 3] {
    powers(designation, duration, &[&[waves("inner", 1), waves("outer", 2)], more].concat())
}

/// Balls that a strike makes slide come to rolling and not beyond, and the others stay there. Where loads vibrated,
/// linear tractions reached as far in slip as in load and threw balls to and fro: the power at the shaft was 6 to 17 %
/// too large. By Runge–Kutta of 0.5 µs the spall changes it by 0.2 %.
#[test]
fn regress_strikes_leave_the_power_at_the_shaft() {
    let [round, lost, _] = powers_if_rough("6206", "0.03", &[]);
    let spall = "spalls=[(race: Outer, azimuth: deg(-90), length: mm(1), width: mm(3), depth: um(50))]";
    let [struck, lost_then, _] = powers_if_rough("6206", "0.03", &[spall.to_owned()]);
    assert!((struck / round - 1.0).abs() < 0.01, "{struck} and {round} W");
    assert!((lost_then / lost - 1.0).abs() < 0.01, "{lost_then} and {lost} W");
}

/// The shock in which rough races meet a round start dies out: carried on by the fast scheme's common acceleration it
/// left 42 % of the work unaccounted for. By Runge–Kutta the shaft has 3.230 W.
#[test]
fn regress_rough_races_begin_without_swinging() {
    let [shaft, _, imbalance] = powers_if_rough("608", "0.02", &[]);
    assert!(imbalance.abs() < 1.0, "{imbalance} %");
    assert!((shaft / 3.230 - 1.0).abs() < 0.005, "{shaft} W");
}

/// A load that grows three times within half a millisecond. Balls that roll with slip in the middle of their contacts
/// were pushed from one side of rolling to the other in each step, for lack of a slope between: 8 % too much power at
/// the shaft and a fifth too little lost. By Runge–Kutta of 0.2 µs the shaft has 61.5 W and 61.7 are lost.
#[test]
fn regress_a_load_that_strikes_leaves_balls_rolling() {
    let struck = "ring.x=ForceTable([(s(0), N(2000)), (s(0.005), N(2000)), (s(0.0055), N(6000)), (s(0.02), N(6000))])";
    let changes = [struck, "transient.start=QuasiStatic"].map(str::to_owned);
    let [shaft, lost, _] = powers("6206", "0.02", &changes);
    assert!((shaft / 61.5 - 1.0).abs() < 0.02, "{shaft} W at the shaft");
    assert!((lost / 61.7 - 1.0).abs() < 0.02, "{lost} W lost");
}

/// The step chosen, with its errors, for 0.02 s of a bearing with a spall.
fn choice(bearing: &[&str], spall: &str, accuracy: f64) -> Value {
    let changes = [format!("spalls=[{spall}]"), format!("transient.scheme=FastTo(accuracy: {accuracy})")];
    answer(bearing, "0.02", &changes)["step_choice"].clone()
}

/// One piece of a step that was just stable let balls swing as they struck. Asked for 1e-4, a run took 19.5 µs, which
/// errs fifteen times as much, since shorter steps seemed no better.
#[test]
fn regress_a_stricter_accuracy_takes_a_shorter_step_over_a_spall() {
    let bearing = ["7210", "--angle", "15", "--radial", "1500", "--axial", "1500", "--speed", "6000"];
    let spall = "(race: Inner, azimuth: deg(10), length: mm(0.6), width: mm(1.5), depth: um(60), edge_radius: um(10))";
    let step = |accuracy: f64| {
        let choice = choice(&bearing, spall, accuracy);
        let error = ["loads", "torque"].map(|name| choice["errors"][name].as_f64().unwrap());
        assert!(choice["scatters"] == false && error.iter().all(|error| *error <= accuracy), "{choice}");
        choice["step_s"].as_f64().unwrap()
    };
    let steps = [1e-3, 5e-4, 1e-4].map(step);
    assert!(steps[0] > steps[2] && steps.is_sorted_by(|long, short| long >= short), "{steps:?}");
}

/// Over a spall the torque swings by many times its mean. That of samples was off by 2e-2 in steps that were as good as
/// those of a quarter of their length, which a run of this bearing took.
#[test]
fn regress_a_step_over_a_spall_is_not_judged_by_chance() {
    let spall = "(race: Outer, azimuth: deg(0), length: mm(1), width: mm(2), depth: um(100), edge_radius: um(10))";
    let choice = choice(&["6308"], spall, 0.05);
    assert!(choice["errors"]["torque"].as_f64().unwrap() < 3e-3, "{choice}");
}

/// Balls of a 608 that stand over a spall at the start strike so hard that the motion goes beyond all numbers in 13 µs:
/// trials of that step panicked with the spall on the outer race, and with it on the inner race the run broke off. By
/// Runge–Kutta of 0.1 µs the ring has 552 and 781 m/s² over the inner one.
#[test]
fn regress_small_balls_may_start_over_a_spall() {
    let accelerations = |race: &str, duration: &str| {
        let place = "azimuth: deg(0), length: mm(1), width: mm(2), depth: um(100), edge_radius: um(10)";
        let answer = answer(&["608"], duration, &[format!("spalls=[(race: {race}, {place})]")]);
        ["x", "y"].map(|axis| answer[format!("outer_acceleration_{axis}_rms_m_s2")].as_f64().unwrap())
    };
    assert!(accelerations("Outer", "0.005").iter().all(|rms| (50.0..1500.0).contains(rms)));
    let [x, y] = accelerations("Inner", "0.01");
    assert!((x / 552.4 - 1.0).abs() < 0.05 && (y / 780.8 - 1.0).abs() < 0.05, "{x} and {y} m/s²");
}

/// Runs that lost their motion after 41 and 66 ms in the step that was chosen: what the edges of a spall do to a ball
/// was carried on along its orbit, and balls without load still gripped the rings. With steps of 1 µs the ring has 448
/// and 230 m/s² and friction takes 11.13 W; 662 and 570 m/s² and 12.74 W.
#[test]
fn regress_runs_over_spalls_keep_their_motion() {
    let all =
        [("6202", 9000, 0.53, "0.05", [448.3, 230.4, 11.13]), ("6201", 12000, 1.24, "0.08", [661.5, 570.1, 12.74])];
    for (bearing, speed, length, duration, expected) in all {
        let place = "azimuth: deg(0), width: mm(3), depth: um(100), edge_radius: um(20)";
        let spall = format!("spalls=[(race: Inner, length: mm({length}), {place})]");
        let answer = answer(&[bearing], duration, &[spall, format!("speed.inner=Constant(rpm({speed}))")]);
        let friction = ["inner", "outer"].map(|race| answer["power"][format!("friction_{race}_w")].as_f64().unwrap());
        let [x, y] = ["x", "y"].map(|axis| answer[format!("outer_acceleration_{axis}_rms_m_s2")].as_f64().unwrap());
        for (found, expected) in [x, y, friction.iter().sum()].into_iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 0.06, "{bearing}: {found}, not {expected}");
        }
    }
}

/// Balls that an edge pushes along the orbit roll on. With the push in the drift and friction in the kick they went
/// round at 2221 to 2595 r/min, and one struck its pocket with 28 N; by Runge–Kutta of 0.3 µs it is 2354 to 2461, and
/// 2.5 N.
#[test]
fn regress_balls_roll_over_the_edges_of_a_spall() {
    let spall = "(race: Outer, azimuth: deg(0), length: mm(1.23), width: mm(3), depth: um(100), edge_radius: um(20))";
    let changes =
        [&format!("spalls=[{spall}]"), "speed.inner=Constant(rpm(6000))", "transient.scheme=Fast(step: us(20))"];
    let answer = answer(&["6205"], "0.06", &changes.map(str::to_owned));
    let of = |name: &str| answer[name].as_f64().unwrap();
    let [least, most] = ["orbital_speed_min_rpm", "orbital_speed_max_rpm"].map(of);
    assert!((least / 2354.0 - 1.0).abs() < 0.01 && (most / 2461.0 - 1.0).abs() < 0.01, "{least} to {most} r/min");
    assert!(of("pocket_force_max_n") < 5.0, "{} N", of("pocket_force_max_n"));
}

/// Several balls that press on a light cage at once vibrate on its pockets faster than a long step resolves: the motion
/// was lost after 18 ms.
#[test]
fn regress_a_light_cage_among_many_balls_stays_calm() {
    let changes = [
        "cage.pocket_film=(fill: 0.001, roughness: um(1))",
        "transient.start=QuasiStatic",
        "transient.scheme=Fast(step: us(39.1))",
    ];
    let [shaft, lost, imbalance] = powers("6206", "0.05", &changes.map(str::to_owned));
    assert!((shaft / lost - 1.0).abs() < 0.02 && imbalance.abs() < 0.5, "{shaft} W, {lost} W lost, {imbalance} %");
}
