//! Shafts, sets and sheets as the commands give them.

use super::{Scratch, run, run_words};
use std::path::{Path, PathBuf};

fn shaft(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/shafts").join(name)
}

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn identity_shafts_of_the_fixtures_are_in_balance() {
    for (name, bearings) in [("motor.ron", 2), ("gearbox.ron", 2), ("spindle.ron", 4)] {
        let answer = run(&[&"shaft", &shaft(name), &"--json"]).json();
        for duty in answer["duties"].as_array().unwrap() {
            let shaft = &duty["shaft"];
            assert_eq!(shaft["bearings"].as_array().unwrap().len(), bearings);
            assert!(number(&shaft["unbalanced"]) < 1e-9 && number(&shaft["residual"]) < 1e-9, "{name}");
            for bearing in shaft["bearings"].as_array().unwrap() {
                assert!(
                    number(&bearing["ball_load_max_n"]) > 0.0 && bearing["rating"].is_object(),
                    "{name}: {bearing}"
                );
            }
        }
        let lives: Vec<f64> = answer["life_h"].as_array().unwrap().iter().map(number).collect();
        let all = lives.iter().map(|h| h.powf(-10.0 / 9.0)).sum::<f64>().powf(-0.9);
        assert!((number(&answer["system_life_h"]) / all - 1.0).abs() < 1e-9);
    }
}

/// The reactions of the motor shaft carry belt, weight and spring.
#[test]
fn identity_motor_shaft_by_statics() {
    let answer = run(&[&"shaft", &shaft("motor.ron"), &"--json"]).json();
    let shaft = &answer["duties"][0]["shaft"];
    let reaction = |bearing: usize, axis: usize| number(&shaft["bearings"][bearing]["reaction_n"][axis]);
    let weight = number(&shaft["mass_kg"]) * 9.80665;
    assert!((reaction(0, 1) + reaction(1, 1) + 600.0 - weight).abs() < 1e-6);
    // The outer ring that slides carries its spring.
    assert!((reaction(1, 2).abs() - 120.0).abs() < 1e-6 && (reaction(0, 2).abs() - 120.0).abs() < 1e-6);
}

#[test]
fn limit_files_of_shafts_are_refused_with_their_place() {
    let scratch = Scratch::new();
    let text = std::fs::read_to_string(shaft("motor.ron")).unwrap();
    let bad = |name: &str, from: &str, to: &str, parts: &[&str]| {
        assert!(text.contains(from), "{from}");
        let path = scratch.file(name, text.replace(from, to));
        run(&[&"shaft", &path]).fails(2, parts);
    };
    bad("unit.ron", "rpm(2900)", "mm(2900)", &["unit.ron:5:", "speed", "rotational speed"]);
    bad("field.ron", "clearance: um(8)", "clearence: um(8)", &["clearence", "allowed", "clearance"]);
    bad("off.ron", "at: mm(282)", "at: mm(482)", &["bearings[1].at", "295"]);
    bad("size.ron", "Listed(\"6206\")", "Listed(\"9999\")", &["bearings[0].bearing", "9999", "6"]);
    bad("side.ron", "outer: mm(28)", "outer: mm(0)", &["shaft.sections[0].outer"]);
    let left = scratch.names();
    assert!(left.iter().all(|name| name.ends_with(".ron")), "{left:?}");
}

#[test]
fn identity_modes_and_tables_of_a_shaft() {
    let scratch = Scratch::new();
    let [csv, ross, springs] = ["nodes.csv", "ross.csv", "springs.inp"].map(|name| scratch.0.join(name));
    let plots = scratch.0.join("plots");
    let words: [&dyn AsRef<std::ffi::OsStr>; 14] = [
        &"shaft",
        &shaft("motor.ron"),
        &"--modes",
        &"0,30000",
        &"--json",
        &"--csv",
        &csv,
        &"--ross",
        &ross,
        &"--springs",
        &springs,
        &"--plot",
        &plots,
        &"--up-to=3000",
    ];
    let answer = run(&words).json();
    let speeds = answer["whirl"]["speeds"].as_array().unwrap();
    let first = |k: usize| number(&speeds[k]["modes"][0]["frequency_hz"]);
    assert!(first(0) > 50.0 && first(1) > 0.0, "{}", answer["whirl"]);
    // The rotor crosses its first modes on the way up.
    assert!(!answer["whirl"]["critical"].as_array().unwrap().is_empty());
    assert!(number(&speeds[1]["amplitude_max_m"]) > 0.0);
    let nodes = std::fs::read_to_string(csv).unwrap();
    assert!(nodes.lines().count() > 20 && nodes.starts_with("load_case,position_m"));
    assert_eq!(std::fs::read_to_string(ross).unwrap().lines().count(), 1 + 2 * 2);
    let springs = std::fs::read_to_string(springs).unwrap();
    assert_eq!(springs.matches("TYPE=SPRING2").count(), 10);
    assert!(plots.join("campbell.svg").exists() && plots.join("shaft-deflection.png").exists());
    run(&[&"shaft", &shaft("motor.ron"), &"--springs", &"springs.txt"]).fails(2, &["springs", ".inp"]);
}

/// The unloading force of a pair is 2.83 times its preload and a little more.
#[test]
fn limit_set_of_a_listed_bearing() {
    let answer = run_words("set 7012C --arrangement DB --preload 211 --json").json();
    let condition = &answer["conditions"][0];
    assert!((number(&condition["preload_n"]) - 211.0).abs() < 1e-6);
    let ratio = number(&condition["unloading_over_preload"][0]);
    assert!(ratio > 2.83 && ratio < 3.4, "{ratio}");
    let last = answer["states"].as_array().unwrap().last().unwrap();
    assert_eq!(number(&last["bearing_force_n"][1]), 0.0);
    run_words("set 7012C --arrangement XX --preload 211").fails(2, &["arrangement", "QBC"]);
    run_words("set 7012C --arrangement DB").fails(2, &["--preload"]);
    run_words("set 7012Q --arrangement DB --preload 1").fails(2, &["7012Q"]);
}

#[test]
fn identity_a_sheet_agrees_with_the_commands_it_stands_for() {
    let scratch = Scratch::new();
    let html = scratch.0.join("sheet.html");
    let words: [&dyn AsRef<std::ffi::OsStr>; 11] =
        [&"sheet", &"6206", &"--radial", &"2000", &"--axial", &"300", &"--speed", &"3000", &"--html", &html, &"--json"];
    let sheet = run(&words).json();
    let case = scratch.0.join("6206.ron");
    run(&[&"new", &"6206", &"--radial", &"2000", &"--axial", &"300", &"--speed", &"3000", &"-o", &case]);
    let rating = run(&[&"rating", &case, &"--model", &"jones-harris", &"--json"]).json();
    for name in ["dynamic_rating_n", "equivalent_load_n", "rating_life_l10r_mrev", "static_safety"] {
        let (a, b) = (number(&sheet["rating"][name]), number(&rating[name]));
        assert!((a / b - 1.0).abs() < 1e-9, "{name}: {a} {b}");
    }
    let stiffness = run(&[&"stiffness", &case, &"--model", &"jones-harris", &"--json"]).json();
    let (a, b) = (number(&sheet["stiffness"][0][0]), number(&stiffness[0]["stiffness"][0][0]));
    assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
    let page = std::fs::read_to_string(html).unwrap();
    assert!(page.contains("rating life") && page.contains("defect of the outer race"));
    run_words("sheet 7210 --radial 100 --speed 10").fails(2, &["contact angle"]);
}
