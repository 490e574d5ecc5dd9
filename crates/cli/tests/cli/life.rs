//! `life`: strides of wear between quasi-static solutions, with a cheap patch rule so that they take seconds in a debug
//! build.

use super::{Outcome, Scratch, assert_close, command, fixture, run};
use serde_json::Value;
use std::ffi::OsStr;

const CHEAP: &str = "traction.patch=SplitStrip(across: 5, along: 3)";

fn life(changes: &[&str], options: &[&str]) -> Outcome {
    let case = fixture("paper-handset.ron");
    let mut words: Vec<&dyn AsRef<OsStr>> = vec![&"life", &case, &"--set", &CHEAP];
    for change in changes {
        words.push(&"--set");
        words.push(change);
    }
    words.extend(options.iter().map(|word| word as &dyn AsRef<OsStr>));
    run(&words)
}

fn number(value: &Value, field: &str) -> f64 {
    value[field].as_f64().unwrap_or_else(|| panic!("{field} is not in {value}"))
}

/// End of the life in h.
fn end(changes: &[&str], strides: &str) -> f64 {
    let answer = life(changes, &["--strides", strides, "--json"]).json();
    assert_ne!(answer["worn_through"].as_array().unwrap().len(), 0, "{answer}");
    number(&answer, "end_h")
}

/// Euler's method: the error halves with the stride.
#[test]
fn limit_halving_the_loss_per_stride_converges_in_the_first_order() {
    let [two, four, eight] = ["2", "4", "8"].map(|strides| end(&[], strides));
    let ratio = (two - four) / (four - eight);
    assert!((1.6..2.5).contains(&ratio), "{two}, {four}, {eight}: {ratio}");
    assert_close(four, eight, 0.05);
}

/// A stride is a depth: the coefficient only says how long it takes.
#[test]
fn identity_life_is_in_inverse_proportion_to_the_wear_coefficient() {
    let doubled = ["wear.inner.coefficient=2e-6", "wear.outer.coefficient=2e-6"];
    assert_close(2.0 * end(&doubled, "3"), end(&[], "3"), 1e-9);
}

#[test]
fn identity_the_first_stride_starts_from_the_solution_and_wears_its_rates() {
    let answer = life(&[], &["--strides", "4", "--json"]).json();
    let strides = answer["strides"].as_array().unwrap();
    let case = fixture("paper-handset.ron");
    let solved = run(&[&"solve", &case, &"--set", &CHEAP, &"--json"]).json();
    assert_close(number(&strides[0], "cage_speed_rpm"), number(&solved, "cage_speed_rpm"), 1e-9);
    let balls = solved["balls"].as_array().unwrap();
    let sum: f64 = balls.iter().map(|ball| number(ball, "wear_rate_inner_m3_s")).sum();
    assert_close(number(&strides[0], "wear_rate_inner_um3_s"), sum * 1e18, 1e-9);
    // Wear is clearance: the free contact angle rises from stride to stride, and the coatings only get thinner.
    for pair in strides.windows(2) {
        assert!(number(&pair[1], "contact_angle_free_deg") > number(&pair[0], "contact_angle_free_deg"));
        for coating in ["coating_inner_min_um", "coating_outer_min_um"] {
            assert!(number(&pair[1], coating) < number(&pair[0], coating));
        }
    }
    let last = &strides[strides.len() - 1];
    assert_eq!(number(last, "time_h"), number(&answer, "end_h"));
    assert_eq!(number(last, "coating_inner_min_um").min(number(last, "coating_outer_min_um")), 0.0);
    assert!(number(&answer, "steel_shows_h") < number(&answer, "end_h"));
    // 14000 r/min.
    assert_close(number(&answer, "end_revolutions"), number(&answer, "end_h") * 60.0 * 14_000.0, 1e-12);
    assert!(answer["warnings"].to_string().contains("wear coefficients"), "{answer}");
}

/// A race that is half worn starts with the clearance of its depth: cos α0 falls by it over the distance of the
/// centres.
#[test]
fn identity_what_is_worn_at_the_start_is_clearance() {
    let half = ["coatings.inner.worn=0.5", "coatings.outer.worn=0.5"];
    let case = fixture("paper-ag-worn.ron");
    let answer = run(&[&"life", &case, &"--set", &CHEAP, &"--until", &"1e-3", &"--json"]).json();
    let first = &answer["strides"][0];
    let checked = run(&[&"check", &case, &"--json"]).json();
    let expected = (number(&checked, "contact_angle_deg").to_radians().cos()
        - 10e-6 / number(&checked, "groove_centre_distance_m"))
    .acos();
    assert_close(number(first, "contact_angle_free_deg"), expected.to_degrees(), 1e-9);
    assert_eq!(number(first, "coating_inner_min_um"), 5.0);
    assert_eq!(answer["worn_through"].as_array().unwrap().len(), 0);
    assert_close(number(&answer, "end_h"), 1e-3, 1e-9);
    assert!(answer["warnings"].to_string().contains("defects"), "{answer}");
    // The fixture without these fields refuses to be given them.
    assert_eq!(life(&half, &[]).code, 2);
}

/// Wear at the start counts once: the first stride is the equilibrium of a bearing with new coatings and the free
/// contact angle that the worn ones leave. Counted again as a depth of the grooves, the loads would be others.
#[test]
fn identity_what_is_worn_at_the_start_counts_once() {
    let case = fixture("paper-ag-worn.ron");
    let answer =
        run(&[&"life", &case, &"--model", &"traction", &"--set", &CHEAP, &"--until", &"1e-3", &"--json"]).json();
    let first = &answer["strides"][0];
    let angle = format!("geometry.fit=ContactAngle(deg({}))", number(first, "contact_angle_free_deg"));
    let solved = |changes: &[&str]| {
        let mut words: Vec<&dyn AsRef<OsStr>> =
            vec![&"solve", &case, &"--model", &"traction", &"--set", &CHEAP, &"--json"];
        for change in changes {
            words.push(&"--set");
            words.push(change);
        }
        run(&words).json()
    };
    let largest = |solution: &Value, field: &str| {
        let balls = solution["balls"].as_array().unwrap().iter();
        balls.map(|ball| number(ball, field)).fold(f64::NEG_INFINITY, f64::max)
    };
    let angles = |solution: &Value| ["inner", "outer"].map(|r| largest(solution, &format!("contact_angle_{r}_deg")));
    let once = solved(&[&angle, "coatings.inner.worn=0", "coatings.outer.worn=0"]);
    let found = ["inner", "outer"].map(|race| number(first, &format!("contact_angle_{race}_max_deg")));
    for (found, expected) in found.into_iter().zip(angles(&once)) {
        assert_close(found, expected, 1e-9);
    }
    assert_close(number(first, "cage_speed_rpm"), number(&once, "cage_speed_rpm"), 1e-9);
    assert_close(number(first, "peak_pressure_inner_max_gpa"), 1e-9 * largest(&once, "peak_pressure_inner_pa"), 1e-9);
    // The difference that counting twice makes, so that the comparison above can tell.
    let twice = solved(&[&angle]);
    let apart = (angles(&twice)[1] - angles(&once)[1]).abs();
    assert!(apart > 1e-3, "counted twice {apart}° from counted once");
}

#[test]
fn limit_what_lasts_for_ever_needs_an_end() {
    let none = ["wear.inner.coefficient=0", "wear.outer.coefficient=0"];
    life(&none, &[]).fails(2, &["--until is missing", "no coating wears through"]);
    let answer = life(&none, &["--until", "100"]);
    assert!(answer.table().contains("after 100.00 h") && answer.table().contains("no coating is through"));
    life(&[], &["--until", "-1"]).fails(2, &["number of hours above 0"]);
    life(&[], &["--strides", "0"]).fails(2, &["--strides"]);
}

const BARE: [&str; 2] = ["coatings.inner.thickness=um(0)", "coatings.outer.thickness=um(0)"];

/// A bare bearing has nothing to wear through; a limit of clearance is reached in proportion to the wear coefficients,
/// and is the sum of both depths on the diameter.
#[test]
fn limit_races_without_coating_wear_to_a_clearance() {
    life(&BARE, &[]).fails(2, &["neither race has a coating", "--clearance-limit", "--until"]);
    let to = |limit: &str, changes: &[&str]| {
        life(&[&BARE[..], changes].concat(), &["--clearance-limit", limit, "--strides", "3", "--json"]).json()
    };
    let answer = to("12", &[]);
    assert_eq!(answer["ended_by"], "clearance-limit");
    assert_eq!(answer["worn_through"], serde_json::json!([]));
    let strides = answer["strides"].as_array().unwrap();
    assert_eq!(strides.len(), 4);
    for (k, stride) in strides.iter().enumerate() {
        assert_close(1.0 + number(stride, "clearance_growth_um"), 1.0 + 4.0 * k as f64, 1e-9);
        let depths = ["inner", "outer"].map(|race| number(stride, &format!("wear_depth_{race}_mean_um")));
        assert_close(1.0 + number(stride, "clearance_growth_um"), 1.0 + 2.0 * (depths[0] + depths[1]), 1e-9);
    }
    let slow = to("12", &["wear.inner.coefficient=1e-8", "wear.outer.coefficient=1e-8"]);
    assert_close(number(&slow, "end_h"), 100.0 * number(&answer, "end_h"), 1e-9);
    // A time ends it too, and where nothing else does, the grooves: never a clearance that no bearing has.
    let timed = life(&BARE, &["--until", "1e-3", "--json"]).json();
    assert_eq!((&timed["ended_by"], number(&timed, "end_h")), (&"time".into(), 1e-3));
    let endless = life(&BARE, &["--until", "1e6", "--strides", "2", "--json"]).json();
    assert_eq!(endless["ended_by"], "grooves");
    assert!(endless["warnings"].to_string().contains("clearance limit"), "{}", endless["warnings"]);
}

/// Wear adds to the drawn clearance, and mounting happens once: the first stride of a mounted bearing is its solution.
#[test]
fn identity_a_mounted_bearing_wears_from_its_running_geometry() {
    let ring = |diameter: &str| format!("(seat_diameter:{diameter},expansion:per_K(10.4e-6),temperature_rise:K(0))");
    let (inner, outer) = (ring("mm(120)"), ring("mm(215)"));
    let ball = "(expansion:per_K(10.4e-6),temperature_rise:K(0))";
    let mounting = format!("mounting=(inner:{inner},outer:{outer},ball:{ball})");
    let answer = life(&[&mounting], &["--strides", "1", "--model", "traction", "--json"]).json();
    let case = fixture("paper-handset.ron");
    let checked = run(&[&"check", &case, &"--set", &CHEAP, &"--set", &mounting, &"--json"]).json();
    let (first, last) = (&answer["strides"][0], &answer["strides"][1]);
    let running = checked["growth"]["contact_angle_running_deg"].as_f64().unwrap();
    assert_close(number(first, "contact_angle_free_deg"), running, 1e-9);
    // cos α0 falls by half of the added diametral clearance over the distance of the centres.
    let half = 0.5e-6 * number(last, "clearance_growth_um") / number(&checked, "groove_centre_distance_m");
    let worn = (running.to_radians().cos() - half).acos().to_degrees();
    assert_close(number(last, "contact_angle_free_deg"), worn, 1e-3);
}

/// Killed in the middle and taken up again: the table of one that was not, byte for byte, by both equations.
#[cfg(unix)]
#[test]
fn identity_a_killed_life_goes_on_to_the_same_table() {
    let case = fixture("paper-handset.ron");
    for model in ["traction", "steady-orbit"] {
        let scratch = Scratch::new();
        let [whole, table] = ["whole.csv", "table.csv"].map(|name| scratch.0.join(name));
        let words = |table| -> [&dyn AsRef<OsStr>; 10] {
            [&"life", &"--model", &model, &case, &"--set", &CHEAP, &"--strides", &"8", &"-o", table]
        };
        run(&words(&whole)).table();
        super::kill_after_rows(command(&words(&table)), &scratch.0.join("table.csv.rows"), 3);
        assert!(!table.exists());
        let other = [&words(&table)[..], &[&"--until", &"1"]].concat();
        run(&other).fails(2, &["table.csv.rows", "--until", "--restart"]);
        run(&words(&table)).table();
        assert_eq!(std::fs::read(&table).unwrap(), std::fs::read(&whole).unwrap());
        assert_eq!(scratch.names(), ["table.csv", "whole.csv"]);
    }
}

/// With everything acting the balance of the film closes in every stride, tables are written, and the map holds the
/// depths of both races.
#[test]
fn identity_wear_that_acts_is_accounted_for_and_written() {
    let scratch = Scratch::new();
    let (strides, map, mission) =
        (scratch.0.join("life.csv"), scratch.0.join("map.csv"), scratch.0.join("mission.csv"));
    std::fs::write(&mission, "s, ring.z.Force\n4, kN(30)\n6, kN(40)\n").unwrap();
    let transfer = "coatings.transfer=(curve: Library(\"ptfe\"), cover: um(0.1), loss: 0.3, \
                    wear: (coefficient: 1e-6, hardness: MPa(60)))";
    let changes = ["coatings.bare=(curve: Library(\"bare-440c\"))", transfer];
    let text = |path: &std::path::Path| path.display().to_string();
    let (strides_path, map_path, mission_path) = (text(&strides), text(&map), text(&mission));
    let options = [
        "--model",
        "traction",
        "--acting",
        "clearance,curvature,traction,transfer",
        "--until",
        "0.005",
        "--strides",
        "4",
        "--mission",
        &mission_path,
        "-o",
        &strides_path,
        "--map",
        &map_path,
        "--json",
    ];
    let answer = life(&changes, &options).json();
    let rows = answer["strides"].as_array().unwrap();
    assert!(rows.len() > 2 && answer["ended_by"] == "time", "{answer}");
    for row in rows {
        let gap = number(row, "scraped_mm3") - number(row, "film_mm3") - number(row, "lost_mm3");
        assert!(gap.abs() <= 1e-10 * number(row, "scraped_mm3").max(1e-12), "{row}");
    }
    let lines = |path: &std::path::Path| std::fs::read_to_string(path).unwrap().lines().count();
    assert_eq!(lines(&strides), rows.len() + 1);
    let cells = std::fs::read_to_string(&map).unwrap();
    assert!(cells.starts_with("cell,race,azimuth_deg,angle_deg,depth_um") && cells.contains("outer"), "{cells:.200}");
    // The same command replaces its own tables; what is asked for wrongly is refused.
    assert_eq!(life(&changes, &options).code, 0);
    life(&[], &["--acting", "traction", "--until", "1"]).fails(2, &["coatings.bare"]);
    life(&[], &["--acting", "friction", "--until", "1"]).fails(2, &["allowed are clearance"]);
    life(&[], &["--mission", "m.csv"]).fails(2, &["--acting"]);
}
