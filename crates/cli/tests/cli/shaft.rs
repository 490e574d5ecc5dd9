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
    // Four nodes a bearing: tilts are displacements of nodes of their own.
    assert!(springs.contains("\n5, 3, 4\n*SPRING, ELSET=BEARING1_5\n2, 2\n"), "{springs}");
    assert!(plots.join("campbell.svg").exists() && plots.join("shaft-deflection.png").exists());
    run(&[&"shaft", &shaft("motor.ron"), &"--springs", &"springs.txt"]).fails(2, &["springs", ".inp"]);
}

/// Cards of Nastran's large format: a name in 8 columns, then fields of 16, and the continuation of each card. K of
/// CELAS2 is the diagonal of the stiffness.
#[test]
fn identity_columns_of_nastran_cards() {
    let scratch = Scratch::new();
    let springs = scratch.0.join("springs.bdf");
    let answer = run(&[&"shaft", &shaft("motor.ron"), &"--springs", &springs, &"--json"]).json();
    let text = std::fs::read_to_string(springs).unwrap();
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with('$')).collect();
    let field = |line: &str, k: usize| line[8 + 16 * k..(24 + 16 * k).min(line.len())].trim().to_owned();
    let mut stiffness = Vec::new();
    for pair in lines.chunks(2) {
        let [first, second] = pair else { panic!("{pair:?}") };
        assert!(first.len() == 73 && first.ends_with('*') && second.starts_with("*       "), "{first}\n{second}");
        match first[..8].trim() {
            // Identifier, coordinate system, x, y; z.
            "GRID*" => {
                assert_eq!((field(first, 2).as_str(), field(first, 3).as_str()), ("0.", "0."));
                assert!(field(second, 0).parse::<f64>().unwrap() > 0.0);
            }
            // Identifier, K, node, freedom; node, freedom.
            "CELAS2*" => {
                let whole = |text: String| text.parse::<usize>().unwrap();
                let freedom = whole(field(first, 3));
                assert_eq!((freedom, whole(field(first, 2)) + 1), (whole(field(second, 1)), whole(field(second, 0))));
                assert_eq!(freedom, stiffness.len() % 5 + 1);
                stiffness.push(field(first, 1).parse::<f64>().unwrap());
            }
            other => panic!("{other}"),
        }
    }
    assert_eq!((stiffness.len(), lines.len()), (10, 2 * (4 + 10)));
    for (k, found) in stiffness.into_iter().enumerate() {
        let expected = number(&answer["duties"][0]["shaft"]["bearings"][k / 5]["stiffness"][k % 5][k % 5]);
        assert!((found - expected).abs() <= 1e-8 * expected.abs(), "{k}: {found} {expected}");
    }
}

/// A housing as springs of each seat, as a matrix of numbers, and as a substructure's lower triangle is one housing.
#[test]
fn identity_housing_read_from_a_file() {
    let scratch = Scratch::new();
    let text = std::fs::read_to_string(shaft("motor.ron")).unwrap();
    let seat = "housing: (radial: N_per_um(80), axial: N_per_um(40), tilt: Nm_per_mrad(20)), ";
    let springs = text.replace("carries: Both,", &format!("carries: Both, {seat}"));
    let diagonal = [8e7, 8e7, 4e7, 2e4, 2e4];
    let entry = |row: usize, column: usize| if row == column { diagonal[row % 5] } else { 0.0 };
    let plain: String = (0..10)
        .map(|row| (0..10).map(|column| entry(row, column).to_string()).collect::<Vec<_>>().join(", ") + "\n")
        .collect();
    scratch.file("plain.csv", plain);
    // As CalculiX writes it, with rows that go on in the next line.
    let mut lower = "**\n*USER ELEMENT,NODES=          2,LINEAR\n*MATRIX,TYPE=STIFFNESS\n".to_owned();
    for row in 0..10 {
        for column in 0..=row {
            lower += &format!(" {:.13E},{}", entry(row, column), if column % 4 == 3 { "\n" } else { "" });
        }
        lower.push('\n');
    }
    scratch.file("lower.mtx", lower);
    let solved = |name: &str, text: String| {
        let answer = run(&[&"shaft", &scratch.file(name, text), &"--json"]).json();
        number(&answer["duties"][0]["shaft"]["stations"][0]["displacement_m"][1])
    };
    let with =
        |file: &str| text.replacen("speed: rpm(2900),", &format!("speed: rpm(2900), housing: Matrix(\"{file}\"),"), 1);
    let expected = solved("springs.ron", springs);
    for file in ["plain.csv", "lower.mtx"] {
        let found = solved(&format!("{file}.ron"), with(file));
        assert!((found / expected - 1.0).abs() < 1e-7, "{file}: {found} {expected}");
    }
    let rigid = solved("rigid.ron", text.clone());
    assert!((rigid / expected - 1.0).abs() > 1e-2);
    scratch.file("short.mtx", "*MATRIX,TYPE=STIFFNESS\n1., 2.,\n");
    run(&[&"shaft", &scratch.file("short.ron", with("short.mtx"))]).fails(2, &["short.mtx", "lower triangle"]);
    scratch.file("word.csv", "1, a\n");
    run(&[&"shaft", &scratch.file("word.ron", with("word.csv"))]).fails(2, &["word.csv", "finite numbers"]);
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
    run_words("set 7012C --arrangement DB").fails(2, &["--preload", "offset", "spring"]);
    run_words("set 7012C --arrangement DB --preload -500").fails(2, &["--preload -500", "0 N or more"]);
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

/// Preload of two 7210B on a stiff shaft that is warmer or colder than its housing, against the formula for axial
/// displacement without radial load: tan α = (A sin α_0 + δ)/(A cos α_0), Q = K (A_1 − A)^1.5, F = Z Q sin α, with K
/// and A as `check` prints them.
#[test]
fn limit_preload_over_heat_is_the_closed_form_of_rigid_supports() {
    let bearing = |name, at, side| {
        format!(
            "(name: \"{name}\", at: mm({at}), bearing: Listed(\"7210B\"), carries: {side}, outer_ring: Fixed, \
             preload: Offset(um(10)))"
        )
    };
    let scratch = Scratch::new();
    let file = scratch.file(
        "pair.ron",
        format!(
            "(name: \"stiff pair\", speed: rpm(0), shaft: (material: (young: GPa(210000), poisson: 0.3, density: \
             kg_per_m3(7850)), sections: [(length: mm(300), outer: mm(50))]), bearings: [{}, {}], heat: \
             (shaft_expansion: per_K(11.5e-6), shaft_temperature_rise: K(0), housing_expansion: per_K(11.5e-6), \
             housing_temperature_rise: K(0)), loads: [])",
            bearing("front", 50, "PlusZ"),
            bearing("rear", 250, "MinusZ")
        ),
    );
    let apart: f64 = 0.635e-3;
    let (sin, cos) = 40f64.to_radians().sin_cos();
    let stiffness = (3.26859e10f64.powf(-2.0 / 3.0) + 2.96818e10f64.powf(-2.0 / 3.0)).powf(-1.5);
    let force = |displacement: f64| {
        let (axial, radial) = (apart * sin + displacement, apart * cos);
        let length = axial.hypot(radial);
        15.0 * stiffness * (length - apart).powf(1.5) * axial / length
    };
    for kelvin in [-10.0, -2.0, 0.0, 5.0] {
        let change = format!("heat.shaft_temperature_rise=K({kelvin})");
        let answer = run(&[&"shaft", &file, &"--set", &change, &"--json"]).json();
        let found = number(&answer["duties"][0]["shaft"]["bearings"][0]["axial_load_n"]);
        // A warm shaft lets go of bearings back to back.
        let expected = force(10e-6 - 0.5 * 0.2 * 11.5e-6 * kelvin);
        assert!((found / expected - 1.0).abs() < 3e-4, "{kelvin} K: {found} {expected}");
    }
}

/// Bearings in tandem have no preload; their displacement counts from where they touch: K (sin α δ)^1.5 Z sin α with
/// the angle of the load.
#[test]
fn limit_set_in_tandem_counts_from_touch() {
    run_words("set 7210B --arrangement DT --preload 500").fails(2, &["--preload 500", "same way"]);
    run_words("set 7210B --sides + --offset 5").fails(2, &["--offset", "same way"]);
    let moved = |line: &str, state: usize| number(&run_words(line).json()["states"][state]["displacement_m"]);
    let tandem = moved("set 7210B --arrangement DT --loads 0,1000 --json", 1);
    let single = moved("set 7210B --sides + --loads 500 --json", 0);
    assert!((tandem / single - 1.0).abs() < 1e-6 && tandem > 1e-6 && tandem < 1e-5, "{tandem} {single}");
    let [none, little] =
        ["0", "1e-6"].map(|n| moved(&format!("set 7210B --arrangement DB --preload {n} --loads 100 --json"), 0));
    assert!((none / little - 1.0).abs() < 1e-4, "{none} {little}");
}

#[test]
fn limit_loads_beyond_elastic_contacts_are_refused() {
    run_words("set 7210B --arrangement DB --preload 500 --loads 1e7").fails(2, &["12 GPa"]);
    run_words("set 7210B --arrangement DB --preload 1e12").fails(2, &["more than the bearings carry"]);
    run(&[&"shaft", &shaft("motor.ron"), &"--set", &"loads[0].pull=kN(3000)"]).fails(2, &["12 GPa"]);
}

#[test]
fn limit_shafts_are_refused_for_what_is_wrong() {
    let motor = shaft("motor.ron");
    let refused = |change: &str, code: i32, parts: &[&str]| {
        run(&[&"shaft", &motor, &"--set", &change]).fails(code, parts);
    };
    refused("bearings[0].clearance=mm(8)", 2, &["bearings[0].clearance", "8000 µm", "allowed"]);
    refused("bearings[0].outer_ring=Slides(N(50))", 1, &["along its axis", "slide"]);
    run(&[&"shaft", &motor, &"--modes", &"-100"]).fails(2, &["--modes -100"]);
    let scratch = Scratch::new();
    let text = std::fs::read_to_string(&motor).unwrap();
    let fine = scratch.file("fine.ron", text.replacen("sections:", "longest_element: um(1), sections:", 1));
    run(&[&"shaft", &fine]).fails(2, &["shaft.longest_element", "elements", "1000"]);
    // No table is written where another one cannot be.
    let (csv, kept) = (scratch.0.join("nodes.csv"), scratch.file("kept.csv", "of others\n"));
    run(&[&"shaft", &motor, &"--csv", &csv, &"--ross", &kept]).fails(2, &["kept.csv"]);
    assert!(!csv.exists());
}
