//! Preloaded pairs as the command gives them.

use super::{fixture, run, run_words};

#[test]
fn identity_a_preloaded_pair_carries_the_load_of_the_shaft() {
    let case = fixture("angular-7210.ron");
    let words = ["--arrangement", "db", "--distance", "60", "--offset", "60", "--set", "ring.x=Force(kN(1))", "--json"];
    let mut all: Vec<&dyn AsRef<std::ffi::OsStr>> = vec![&"pair", &case];
    words.iter().for_each(|word| all.push(word));
    let answer = run(&all).json();
    let load = |bearing: usize, axis: usize| answer["bearings"][bearing]["load_n"][axis].as_f64().unwrap();
    assert!((load(0, 0) + load(1, 0) - 1000.0).abs() < 1e-3);
    assert!((load(0, 2) + load(1, 2) - 3000.0).abs() < 1e-3);
    assert!(load(0, 2) > 3000.0 && load(1, 2) < 0.0, "{answer}");
    assert!(answer["stiffness"][3][3].as_f64().unwrap() > 0.0);
}

#[test]
fn limit_a_pair_needs_one_preload() {
    run_words("pair nowhere.ron --arrangement DB --distance 60").fails(2, &["--offset", "--spring"]);
    let case = fixture("angular-7210.ron");
    run(&[&"pair", &case, &"--arrangement", &"dt", &"--distance", &"60", &"--spring", &"100"]).fails(2, &["tandem"]);
    run(&[&"pair", &case, &"--arrangement", &"db", &"--distance", &"-60", &"--offset", &"1"])
        .fails(2, &["0 mm or more"]);
    let far = "--offset=3000";
    let words = [&"--distance", &"60", &far, &"--model", &"jones-harris"];
    run(&[&"pair", &case, &"--arrangement", &"DB", words[0], words[1], words[2], words[3], words[4]])
        .fails(2, &["12 GPa"]);
}

/// Bearings in tandem without offset share their load at rest as they do in slow turning.
#[test]
fn limit_a_pair_at_rest_is_solved() {
    let case = fixture("angular-7210.ron");
    for arrangement in ["db", "df", "dt"] {
        let words = ["--arrangement", arrangement, "--distance", "60", "--offset", "0"];
        let at_rest = ["--set", "speed.inner=Constant(rpm(0))", "--json"];
        let mut all: Vec<&dyn AsRef<std::ffi::OsStr>> = vec![&"pair", &case];
        words.iter().chain(&at_rest).for_each(|word| all.push(word));
        let answer = run(&all).json();
        let load = |bearing: usize, axis: usize| answer["bearings"][bearing]["load_n"][axis].as_f64().unwrap();
        assert!((load(0, 0) + load(1, 0) - 4000.0).abs() < 1e-3 && (load(0, 2) + load(1, 2) - 3000.0).abs() < 1e-3);
    }
}
