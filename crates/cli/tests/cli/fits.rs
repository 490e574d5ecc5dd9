//! Fits by tolerance class, in cases, sheets, sets and shafts.

use super::{Scratch, run, run_words};
use std::path::{Path, PathBuf};

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn shafts() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/shafts")
}

/// A 6206 on k5 in J6 by the tables of ISO 286 and ISO 492: 2 to 21 µm on the shaft, 6 µm to −26 µm in the housing.
/// On a solid shaft of its material a ring's race grows by I d/d_race.
#[test]
fn paper_fits_of_a_6206() {
    let scratch = Scratch::new();
    let case = scratch.0.join("6206.ron");
    run(&[&"new", &"6206", &"--shaft-fit", &"k5", &"--housing-fit", &"J6", &"-o", &case]);
    let answer = run(&[&"check", &case, &"--json"]).json();
    let microns = |seat: usize| -> Vec<f64> {
        numbers(&answer["fits"]["seats"][seat]["interference_m"]).iter().map(|i| (i * 1e8).round() / 100.0).collect()
    };
    let [shaft, housing] = [microns(0), microns(1)];
    assert_eq!([shaft[0], shaft[2], shaft[4]], [2.0, 11.5, 21.0]);
    assert_eq!([housing[0], housing[2], housing[4]], [-26.0, -10.0, 6.0]);
    // ½ √(9² + 10²) on the shaft.
    assert!((shaft[3] - 11.5 - 0.5 * 181f64.sqrt()).abs() < 0.01, "{shaft:?}");
    let effective = number(&answer["fits"]["seats"][0]["effective_interference_m"]);
    assert!((effective - 9.9e-6).abs() < 1e-11, "{effective}");
    // The housing is loose: the clearance falls by the growth of the inner race alone.
    let growth = &answer["growth"];
    let lost = number(&growth["radial_clearance_drawn_m"]) - number(&growth["radial_clearance_mounted_m"]);
    let race = 46.0 - 9.525;
    assert!((lost / (effective * 30.0 / race) - 1.0).abs() < 0.01, "{lost}");
    let over = numbers(&answer["fits"]["radial_clearance_mounted_m"]);
    assert!(over.windows(2).all(|pair| pair[0] > pair[1]), "{over:?}");
    assert!((over[2] - number(&growth["radial_clearance_mounted_m"])).abs() < 1e-12);
    // The table for people has the same.
    let printed = run(&[&"check", &case]);
    let printed = printed.table();
    assert!(printed.contains("k5 Normal") && printed.contains("interference on the shaft"), "{printed}");
    // The sheet of the same bearing rests on the same clearance.
    let sheet = run_words("sheet 6206 --radial 1000 --speed 0 --shaft-fit k5 --housing-fit J6 --json").json();
    let (a, b) = (number(&sheet["radial_clearance_m"]), number(&growth["radial_clearance_mounted_m"]));
    assert!((a - b).abs() < 1e-12, "{a} {b}");
    assert!(run_words("sheet 6206 --radial 1000 --speed 0 --json").json()["fits"].is_null());
}

/// With a lubricant the sheet has a life modified for it, and the torques of `torque`.
#[test]
fn identity_a_sheet_in_oil() {
    let scratch = Scratch::new();
    let case = scratch.0.join("6206.ron");
    let operation: [&dyn AsRef<std::ffi::OsStr>; 6] = [&"--radial", &"2000", &"--axial", &"300", &"--speed", &"3000"];
    let with = |words: &[&dyn AsRef<std::ffi::OsStr>]| run(&[words, &operation].concat());
    with(&[&"new", &"6206", &"--lubricant", &"vg68", &"-o", &case]);
    let sheet = with(&[&"sheet", &"6206", &"--oil", &"vg68", &"--json"]).json();
    let rating = run(&[&"rating", &case, &"--model", &"jones-harris", &"--json"]).json();
    for name in ["viscosity_ratio", "life_modification_factor"] {
        let (a, b) = (number(&sheet["rating"][name]), number(&rating[name]));
        assert!((a / b - 1.0).abs() < 1e-9, "{name}: {a} {b}");
    }
    let torque = run(&[&"torque", &case, &"--json"]).json();
    for name in ["skf_torque_nm", "palmgren_torque_nm"] {
        let (a, b) = (number(&sheet[name]), number(&torque[name]));
        assert!((a / b - 1.0).abs() < 1e-4, "{name}: {a} {b}");
    }
    assert!(run_words("sheet 6206 --radial 1000 --speed 100 --json").json()["skf_torque_nm"].is_null());
    run_words("sheet 6206 --radial 1000 --speed 100 --oil honey").fails(2, &["honey", "vg68"]);
    with(&[&"sheet", &case, &"--oil", &"vg68"]).fails(2, &["lubricant", "case file"]);
}

#[test]
fn limit_classes_that_fit_nothing_are_refused() {
    let sheet = "sheet 6206 --radial 1000 --speed 100";
    run_words(&format!("{sheet} --shaft-fit K5")).fails(2, &["--shaft-fit", "small letters"]);
    run_words(&format!("{sheet} --shaft-fit k55")).fails(2, &["k55", "such as k5", "such as H7"]);
    run_words(&format!("{sheet} --housing-fit h7")).fails(2, &["--housing-fit", "capitals", "such as H7"]);
    run_words(&format!("{sheet} --shaft-fit k5\"")).fails(2, &["tolerance class"]);
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/angular-7210.ron");
    run(&[&"sheet", &case, &"--radial", &"1000", &"--speed", &"100", &"--shaft-fit", &"k5"]).fails(2, &["mounting"]);
}

/// The gearbox shaft has its fits by class; the section under the bearing is the seat.
#[test]
fn limit_fits_of_shafts() {
    let scratch = Scratch::new();
    let text = std::fs::read_to_string(shafts().join("gearbox.ron")).unwrap();
    let answer = run(&[&"shaft", &shafts().join("gearbox.ron"), &"--json"]).json();
    let bearing = &answer["duties"][1]["shaft"]["bearings"][0];
    assert_eq!(bearing["fits"]["seats"][0]["seat_class"], "k5");
    let running = numbers(&bearing["fits"]["radial_clearance_running_m"]);
    assert!((running[2] - number(&bearing["radial_clearance_m"])).abs() < 1e-12);
    let bad = |name: &str, from: &str, to: &str, parts: &[&str]| {
        assert!(text.contains(from), "{from}");
        run(&[&"shaft", &scratch.file(name, text.replacen(from, to, 1))]).fails(2, parts);
    };
    bad("class.ron", "shaft: \"k5\"", "shaft: \"q5\"", &["bearings[0].fits.shaft", "`q5`", "such as k5"]);
    bad("side.ron", "shaft: \"k5\"", "shaft: \"K5\"", &["bearings[0].fits.shaft", "small letters"]);
    bad("thick.ron", "outer: mm(30)", "outer: mm(31)", &["bearings[0].at", "31 mm", "30 mm"]);
    bad("twice.ron", "carries: Both", "clearance: um(10), carries: Both", &["bearings[0]", "give one of them"]);
    bad("thin.ron", "housing_outside: mm(110)", "housing_outside: mm(60)", &["bearings[0].fits.housing_outside"]);
}

/// Two spindle pairs of a maker's table: preload and unloading force in N.
#[test]
fn paper_unloading_forces_of_spindle_pairs() {
    for (designation, preload, unloading) in [("B7012-C", 211, 658.0), ("B7014-C", 278, 866.0)] {
        let answer = run_words(&format!("set {designation} --arrangement DB --preload {preload} --json")).json();
        let found = numbers(&answer["conditions"][0]["unloading_force_n"]);
        for force in found {
            assert!((force / unloading - 1.0).abs() < 0.02, "{designation}: {force} N, printed {unloading} N");
        }
    }
}

/// 2^1.5 preloads unload a pair in the limit of small ones: at rest, and turning slowly.
#[test]
fn limit_unloading_force_at_rest_and_turning() {
    for turning in ["", " --set speed.inner=Constant(rpm(0.01))"] {
        let mut before = f64::INFINITY;
        for (preload, within) in [(100.0, 0.1), (1.0, 0.01), (0.01, 1e-3)] {
            let words = format!("set 7012C --arrangement DB --preload {preload} --given running{turning} --json");
            let answer = run_words(&words).json();
            let condition = answer["conditions"].as_array().unwrap().last().unwrap();
            let over = number(&condition["unloading_over_preload"][0]) / 8f64.sqrt() - 1.0;
            assert!(over > 0.0 && over < within && over < before, "{preload} N{turning}: {over}");
            before = over;
        }
    }
}

/// Balls that turn press outwards: at speed the other side of a pair stays loaded, and nothing unloads it. Slow ones
/// solve at any speed.
#[test]
fn limit_centrifugal_force_keeps_a_pair_loaded() {
    let at = |rpm: f64| {
        let words = format!("set 7210B --arrangement DB --preload 200 --set speed.inner=Constant(rpm({rpm})) --json");
        run_words(&words).json()
    };
    let fast = at(20_000.0);
    let running = fast["conditions"].as_array().unwrap().last().unwrap();
    assert!(running["unloading_force_n"][0].is_null() && number(&running["preload_n"]) > 1000.0, "{running}");
    let kept = fast["states"].as_array().unwrap().last().unwrap();
    assert!(number(&kept["bearing_force_n"][1]) > 1000.0, "{kept}");
    for rpm in [0.001, 0.1, 1.0, 10.0, 20.0, 50.0] {
        let slow = at(rpm);
        let ratio = number(&slow["conditions"][1]["unloading_over_preload"][0]);
        assert!((ratio / number(&slow["conditions"][0]["unloading_over_preload"][0]) - 1.0).abs() < 2e-3, "{rpm}");
    }
}

/// Sets of three and four, and a tandem, which has no preload of its own.
#[test]
fn identity_sets_of_three_and_four() {
    for (arrangement, shares) in
        [("TBT", vec![150.0, 150.0, 300.0]), ("QBC", vec![150.0; 4]), ("QBT", vec![100.0, 100.0, 100.0, 300.0])]
    {
        let words = format!("set 7012C --arrangement {arrangement} --preload 300 --loads 0 --json");
        let answer = run_words(&words).json();
        let forces = numbers(&answer["states"][0]["bearing_force_n"]);
        assert!(forces.iter().zip(&shares).all(|(a, b)| (a - b).abs() < 1e-6), "{arrangement}: {forces:?}");
    }
    let tandem = run_words("set 7012C --arrangement DT --offset 0 --loads 1000 --json").json();
    assert_eq!(number(&tandem["conditions"][0]["preload_n"]), 0.0);
    assert!(tandem["conditions"][0]["unloading_force_n"][0].is_null());
    let forces = numbers(&tandem["states"][0]["bearing_force_n"]);
    assert!(forces.iter().all(|force| (force - 500.0).abs() < 1e-6), "{forces:?}");
}

/// A map over speed and temperature holds the conditions of the set, and preload rises with the heat of the shaft.
#[test]
fn identity_preload_over_speed_and_temperature() {
    let scratch = Scratch::new();
    let set = "set 7012C/P4 --arrangement DB --preload 300 --shaft-fit js4 --set speed.inner=Constant(rpm(12000))";
    let plots = scratch.0.join("plots");
    let words = format!("{set} --speeds 0,12000 --warmer 0,10 --loads 0 --json --plot {}", plots.display());
    let answer = run_words(&words).json();
    let map = answer["map"].as_array().unwrap();
    let preload = |at: usize| number(&map[at]["preload_n"]);
    let conditions = answer["conditions"].as_array().unwrap();
    assert_eq!((conditions.len(), map.len()), (3, 4));
    assert!((preload(0) / number(&conditions[1]["preload_n"]) - 1.0).abs() < 1e-9);
    assert!((preload(1) / number(&conditions[2]["preload_n"]) - 1.0).abs() < 1e-9);
    assert!(preload(2) > 1.2 * preload(0) && preload(3) > 1.2 * preload(1), "{map:?}");
    // Rings that turn press the balls outwards.
    assert!(preload(1) > preload(0), "{map:?}");
    assert!(plots.join("set-map.svg").exists());
    run_words("set 7012C --arrangement DB --preload 300 --warmer 10").fails(2, &["warmer", "fits"]);
    run_words("set 7012C --arrangement DB --preload 300 --speeds 10,-5").fails(2, &["speeds", "0 r/min"]);
}
