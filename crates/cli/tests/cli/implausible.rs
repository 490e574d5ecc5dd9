//! Answers that no bearing gives are named as such, in tables and by `solve`; the steady orbit has hardly any.

use super::sweep::{read, value};
use super::{Scratch, fixture, run};
use std::collections::HashMap;
use std::path::Path;

/// Radial loads beside 3 kN of axial load: from one that all balls carry to one that half of them do.
const RADIAL: &str = "ring.x.Force=kN(0.5..7.5 by 0.5)";

fn sweep(table: &Path, model: &str) -> serde_json::Value {
    let case = fixture("angular-7210.ron");
    run(&[&"sweep", &case, &"--set", &RADIAL, &"--model", &model, &"-o", &table, &"--json"]).json()
}

/// True if a row holds a number that no bearing gives.
fn nonsense(row: &HashMap<String, String>) -> bool {
    let load = value(row, "ring_load_x_n").hypot(value(row, "ring_load_z_n"));
    let angles = ["inner_max", "outer_max"].map(|of| value(row, &format!("contact_angle_{of}_deg")));
    let cage = value(row, "cage_speed_rpm");
    angles.iter().any(|angle| *angle > 75.0)
        || value(row, "pocket_force_max_n") > load
        || !(0.0..=6000.0).contains(&cage)
}

#[test]
fn limit_rows_that_no_bearing_gives_are_named_and_the_orbit_has_sound_forces() {
    let scratch = Scratch::new();
    let [equilibria, orbits] = ["equilibria.csv", "orbits.csv"].map(|name| scratch.0.join(name));
    let summary = sweep(&equilibria, "traction");
    let rows = read(&equilibria).1;
    let named = rows.iter().filter(|row| !row["implausible"].is_empty()).count();
    assert_eq!((rows.len(), &summary["implausible_rows"]), (15, &named.into()));
    assert!(named >= 6, "{named}");
    for row in &rows {
        assert!(!nonsense(row) || !row["implausible"].is_empty(), "{row:?}");
    }
    assert_eq!(sweep(&orbits, "steady-orbit")["failed_rows"], 0);
    let rows = read(&orbits).1;
    for row in &rows {
        // Balls that hardly carry touch the inner groove beyond its end: there are no shoulders in the model.
        assert!(["", "contact angle"].contains(&row["implausible"].as_str()), "{row:?}");
        assert_eq!(nonsense(row), !row["implausible"].is_empty(), "{row:?}");
        assert!(value(row, "residual") <= 1e-10 && value(row, "pocket_force_max_n") < 150.0, "{row:?}");
        // Power at the shaft is what friction in contacts and pockets takes; the pockets, a sixth, have no column.
        let power = value(row, "shaft_torque_nm") * 6000.0 * std::f64::consts::PI / 30.0;
        let losses: f64 = ["inner", "outer"].map(|at| value(row, &format!("power_loss_{at}_w"))).iter().sum();
        assert!(losses < 1.001 * power && losses > 0.7 * power, "{losses} {power}");
    }
}

#[test]
fn limit_an_implausible_equilibrium_says_so_with_advice() {
    let case = fixture("angular-7210.ron");
    let warnings = |model: &str| {
        let answer = run(&[&"solve", &case, &"--model", &model, &"--json"]).json();
        answer["warnings"].as_array().unwrap().iter().map(|w| w.as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    let last = warnings("traction").pop().unwrap();
    assert!(last.starts_with("implausible: ") && last.contains("pocket force"), "{last}");
    assert!(last.ends_with("`--model steady-orbit` gives what a run settles to"), "{last}");
    let of_pockets = |warning: &String| warning.starts_with("implausible") && warning.contains("pocket force");
    assert!(!warnings("steady-orbit").iter().any(of_pockets));
    let scratch = Scratch::new();
    let table = scratch.0.join("table.csv");
    let outcome = run(&[&"sweep", &case, &"--set", &"ring.x.Force=kN(4)", &"--model", &"traction", &"-o", &table]);
    assert_eq!(outcome.code, 0, "{}", outcome.err);
    assert!(outcome.out.contains("warning: 1 of 1 rows are implausible"), "{}", outcome.out);
}

#[test]
fn identity_orbits_are_the_same_bytes_for_any_threads_and_shards() {
    let scratch = Scratch::new();
    let case = fixture("paper-handset.ron");
    let go = |name: &str, rest: [&str; 2]| {
        let table = scratch.0.join(name);
        let set = "ring.x.Force=kN(10..20 in 9)";
        let words: [&dyn AsRef<std::ffi::OsStr>; 10] =
            [&"sweep", &case, &"--set", &set, &"--model", &"steady-orbit", &"-o", &table, &rest[0], &rest[1]];
        run(&words).table();
        std::fs::read_to_string(table).unwrap()
    };
    let whole = go("one.csv", ["--threads", "1"]);
    assert_eq!(go("two.csv", ["--threads", "2"]), whole);
    let parts = [go("first.csv", ["--shard", "0/2"]), go("second.csv", ["--shard", "1/2"])];
    let rows: String = parts.iter().map(|part| part.split_once('\n').unwrap().1).collect();
    assert_eq!(rows, whole.split_once('\n').unwrap().1);
    // A row is what `solve` answers.
    let row = &read(&scratch.0.join("one.csv")).1[8];
    let alone = run(&[&"solve", &case, &"--set", &"ring.x.Force=kN(20)", &"--model", &"steady-orbit", &"--json"]);
    let alone = alone.json();
    for name in ["cage_speed_rpm", "shaft_torque_nm"] {
        assert_eq!(Some(value(row, name)), alone[name].as_f64(), "{name}");
    }
}
