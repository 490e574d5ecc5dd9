//! Findings on an operating point stand in every answer that rests on it: overload, curves beyond their tests, nothing
//! that loads the bearing, a limit on the time of a search.

use super::{Scratch, fixture, run};
use serde_json::Value;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// A 7210 at 24 times its dynamic load rating.
const OVERLOAD: [&str; 4] = ["--set", "ring.x.Force=kN(0)", "--set", "ring.z.Force=kN(900)"];
const PAIR: [&str; 6] = ["--arrangement", "db", "--distance", "20", "--offset", "10"];

fn ask(command: &str, case: &Path, words: &[&str]) -> super::Outcome {
    let mut all: Vec<&dyn AsRef<OsStr>> = vec![&command, &case];
    words.iter().for_each(|word| all.push(word));
    run(&all)
}

fn texts(value: &Value, field: &str) -> Vec<String> {
    let found = value[field].as_array().unwrap_or_else(|| panic!("no list `{field}` in {value}"));
    found.iter().map(|text| text.as_str().unwrap().to_owned()).collect()
}

fn says(value: &Value, words: &str) -> bool {
    texts(value, "warnings").iter().any(|warning| warning.contains(words))
}

/// A case of the catalogue.
fn catalogue(scratch: &Scratch, designation: &str) -> PathBuf {
    let path = scratch.0.join(format!("{designation}.ron"));
    run(&[&"new", &designation, &"-o", &path]).table();
    path
}

#[test]
fn regress_an_overload_is_named_by_every_answer() {
    let case = fixture("angular-7210.ron");
    let scratch = Scratch::new();
    let [csv, ross, modes] = ["k.csv", "ross.csv", "modes.csv"].map(|name| scratch.0.join(name));
    let [csv_name, ross_name, modes_name] = [&csv, &ross, &modes].map(|path| path.to_str().unwrap());
    let asked: [(&str, &[&str]); 6] = [
        ("solve", &["--model", "jones-harris"]),
        ("solve", &[]),
        ("stiffness", &["--csv", csv_name, "--ross", ross_name]),
        ("modes", &["--csv", modes_name]),
        ("rating", &[]),
        ("pair", &PAIR),
    ];
    for (command, words) in asked {
        let answer = ask(command, &case, &[&OVERLOAD[..], words, &["--json"]].concat()).json();
        let answer = if command == "stiffness" { &answer[0] } else { &answer };
        assert!(texts(answer, "implausible").contains(&"pressure".to_owned()), "{command}: {}", answer["implausible"]);
        assert!(says(answer, "static safety s_0 of"), "{command}: {}", answer["warnings"]);
        assert!(answer["lubrication"].as_str().is_some_and(|words| !words.is_empty()), "{command}");
    }
    for table in [csv, ross, modes] {
        let text = std::fs::read_to_string(&table).unwrap();
        let (head, rows) = text.split_once('\n').unwrap();
        assert!(head.ends_with(",implausible,warnings"), "{head}");
        assert!(rows.lines().all(|row| row.contains("\"pressure")), "{rows}");
    }
}

#[test]
fn regress_curves_beyond_their_tests_are_named_by_every_answer() {
    let case = fixture("angular-7210.ron");
    let asked: [(&str, &[&str]); 7] = [
        ("solve", &[]),
        ("solve", &["--model", "traction"]),
        ("stiffness", &[]),
        ("stiffness", &["--model", "traction"]),
        ("modes", &[]),
        ("rating", &[]),
        ("pair", &PAIR),
    ];
    for (command, words) in asked {
        let answer = ask(command, &case, &[words, &["--json"]].concat()).json();
        let answer = if command == "stiffness" { &answer[0] } else { &answer };
        assert!(says(answer, "traction curve was tested at 2.5 to 3.5 GPa"), "{command} {words:?}: {answer}");
        assert_eq!(answer["lubrication"], "solid film `ag` on both races, dry", "{command}");
        let shown = ask(command, &case, words);
        assert!(shown.table().lines().nth(1).unwrap().starts_with("lubrication: solid film `ag`"), "{}", shown.out);
        assert!(shown.out.contains("pressures on the inner race are"), "{}", shown.out);
    }
}

#[test]
fn regress_a_slip_of_the_unit_costs_no_search() {
    let case = fixture("angular-7210.ron");
    let slip = ["--set", "ring.x.Force=kN(-57212)"];
    let checked = ask("check", &case, &slip);
    assert!(checked.table().contains("N(-57212) would be: a slip of the unit?"), "{}", checked.out);
    for command in ["solve", "stiffness", "modes"] {
        let began = Instant::now();
        ask(command, &case, &slip).fails(2, &["static safety s_0 of", "a slip of the unit?", "nothing is solved"]);
        assert!(began.elapsed().as_secs_f64() < 5.0, "{command}");
    }
    // The standards need no load distribution.
    let rated = ask("rating", &case, &[&slip[..], &["--json"]].concat()).json();
    assert!(rated["static_safety"].as_f64().unwrap() < 1e-3 && rated["rating_life_l10r_mrev"].is_null(), "{rated}");
    assert!(says(&rated, "no load distribution"), "{rated}");
}

#[test]
fn limit_a_search_ends_at_its_time_limit() {
    let case = fixture("angular-7210.ron");
    let asked: [(&str, &[&str]); 4] = [("solve", &[]), ("stiffness", &[]), ("modes", &[]), ("pair", &PAIR)];
    for (command, words) in asked {
        let outcome = ask(command, &case, &[words, &["--time-limit", "0.001"]].concat());
        outcome.fails(1, &["no answer after 0.001 s of processor time, while trying", "--time-limit"]);
    }
    ask("solve", &case, &["--time-limit", "0"]).fails(2, &["--time-limit", "seconds above 0"]);
    let rated = ask("rating", &case, &["--time-limit", "0.001", "--json"]).json();
    assert!(rated["static_safety"].as_f64().is_some() && says(&rated, "was stopped"), "{rated}");
    let scratch = Scratch::new();
    let table = scratch.0.join("table.csv");
    let table = table.to_str().unwrap();
    let swept = ask("sweep", &case, &["--set", "ring.x.Force=kN(3)", "--time-limit", "0.001", "-o", table]);
    assert_eq!(swept.code, 1, "{}", swept.err);
    assert!(std::fs::read_to_string(table).unwrap().contains("was stopped before it found one"));
}

#[test]
fn regress_no_load_is_a_state_of_every_answer() {
    let case = fixture("angular-7210.ron");
    let still = ["--set", "ring.x.Force=kN(0)", "--set", "ring.z.Force=kN(0)", "--model", "jones-harris", "--json"];
    for command in ["solve", "rating"] {
        let answer = ask(command, &case, &still).json();
        assert_eq!(answer["loaded"], false, "{answer}");
        assert!(says(&answer, "no load: rating lives"), "{answer}");
        for field in ["rating_life_l10_mrev", "rating_life_l10r_mrev", "rating_life_hours", "static_safety"] {
            assert!(answer.get(field).is_none_or(Value::is_null), "{command}: {field} is {}", answer[field]);
        }
    }
    let checked = ask("check", &case, &[&still[..4], &["--json"]].concat()).json();
    assert!(says(&checked, "no load") && checked["static_safety"].is_null(), "{checked}");
    let rest = ask("modes", &case, &["--set", "speed.inner=Constant(rpm(0))"]);
    rest.fails(2, &["at rest", "speed.inner"]);
    assert!(!rest.err.contains("--set"), "{}", rest.err);
    let flat = ["--set", "geometry.fit=RadialClearance(um(0))", "--json"];
    let checked = ask("check", &case, &flat).json();
    assert!(!says(&checked, "contact angle"), "{checked}");
}

#[test]
fn regress_loads_speeds_and_tilts_are_held_against_the_type() {
    let scratch = Scratch::new();
    let case = catalogue(&scratch, "6204");
    let rated = ask("check", &case, &["--json"]).json();
    let [dynamic, static_rating] = ["dynamic_rating_n", "static_rating_n"].map(|field| rated[field].as_f64().unwrap());
    assert!(dynamic > 1.2e4 && static_rating > 6e3, "{rated}");
    assert!(texts(&rated, "warnings").is_empty(), "{rated}");
    let radial = format!("ring.x.Force=N({})", 4.0 * dynamic);
    let overload = ["--set", &radial, "--json"];
    let checked = ask("check", &case, &overload).json();
    assert!(checked["static_safety"].as_f64().unwrap() < 0.2 && says(&checked, "static safety"), "{checked}");
    let rated = ask("rating", &case, &overload).json();
    assert!((rated["static_safety"].as_f64().unwrap() - checked["static_safety"].as_f64().unwrap()).abs() < 1e-3);
    let fast = ask("check", &case, &["--set", "speed.inner.Constant=rpm(60000)", "--json"]).json();
    assert!(says(&fast, "deep-groove bearings in oil"), "{fast}");
    let tilted = ask("check", &case, &["--set", "ring.tilt_x=Held(deg(1))", "--json"]).json();
    assert!(says(&tilted, "tilted by 17.5 mrad"), "{tilted}");
}

#[test]
fn regress_one_case_has_one_life() {
    let (paper, dry) = (fixture("angular-7210.ron"), fixture("bearing-218.ron"));
    let [solved, rated] = ["solve", "rating"].map(|command| ask(command, &paper, &["--json"]).json());
    assert_eq!((&solved["model"], &rated["model"]), (&"steady-orbit".into(), &"steady-orbit".into()));
    assert_eq!(solved["rating_life_l10r_mrev"], rated["rating_life_l10r_mrev"]);
    assert!(ask("rating", &paper, &[]).table().contains("steady-orbit"));
    // Without coatings and cage there is no orbit: said, not guessed.
    assert_eq!(ask("rating", &dry, &["--json"]).json()["model"], "jones-harris");
    let pair = ask("pair", &paper, &[&PAIR[..], &["--json"]].concat()).json();
    assert_eq!(pair["model"], "steady-orbit");
}

#[test]
fn regress_an_orbit_says_what_rests_on_the_assumed_pocket_gap() {
    let case = fixture("angular-7210.ron");
    let answer = ask("solve", &case, &["--json"]).json();
    let all = answer["sensitivities"].as_array().unwrap();
    let gap = all.iter().find(|found| found["path"] == "cage.pocket_gap").unwrap();
    assert!(
        all.len() >= 3 && says(&answer, "rests on the assumed `cage.pocket_friction`"),
        "{all:?} {}",
        answer["warnings"]
    );
    // The same gap by the same command.
    for (factor, torque) in gap["factors"].as_array().unwrap().iter().zip(gap["shaft_torque_nm"].as_array().unwrap()) {
        let (Some(factor), Some(torque)) = (factor.as_f64(), torque.as_f64()) else { continue };
        let change = format!("cage.pocket_gap=mm({})", 0.2 * factor);
        let solved = ask("solve", &case, &["--set", &change, "--json"]).json();
        super::assert_close(torque, solved["shaft_torque_nm"].as_f64().unwrap(), 5e-3);
    }
}
