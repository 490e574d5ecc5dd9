//! `new`: cases that check, solve and run as they are; and what is refused.

use super::{Outcome, Scratch, command, fixture, run_words};
use std::ffi::OsStr;
use std::path::Path;

pub(crate) fn run_in(folder: &Path, line: &str) -> Outcome {
    let words: Vec<&str> = line.split_whitespace().collect();
    let words: Vec<&dyn AsRef<OsStr>> = words.iter().map(|word| word as _).collect();
    let output = command(&words).current_dir(folder).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Outcome { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
}

/// From the smallest to the largest of each class: no warning in `check`, and an equilibrium with traction.
#[test]
fn limit_new_cases_check_without_warnings_and_solve() {
    let scratch = Scratch::new();
    for (options, file) in [
        ("6000", "6000.ron"),
        ("6206", "6206.ron"),
        ("6320", "6320.ron"),
        ("7000 --angle 15", "7000C.ron"),
        ("7210 --angle 40", "7210B.ron"),
        ("7210 --angle 25", "7210AC.ron"),
        ("608-2RS", "608-2RS.ron"),
        ("61808", "61808.ron"),
        ("71912ACD/HCP4A", "71912ACD-HCP4A.ron"),
        ("7313A", "7313A.ron"),
        ("--bearing angular --bore 50 --outside 90 --width 20 --angle 40 --balls 15 --ball 12.7 -o own.ron", "own.ron"),
        ("--bore 30 --outside 62 --width 16 --dynamic-rating 19500 --static-rating 11300", "bearing-30x62x16.ron"),
    ] {
        let made = run_in(&scratch.0, &format!("new {options}"));
        assert!(made.table().contains(file), "{}", made.out);
        let checked = run_in(&scratch.0, &format!("check {file} --json")).json();
        assert_eq!(checked["warnings"], serde_json::json!([]), "{options}");
        let solved = run_in(&scratch.0, &format!("solve {file} --json")).json();
        assert_eq!(solved["converged"], true, "{options}");
        let safety = solved["static_safety"].as_f64().unwrap();
        assert!(safety > 1.5, "{options}: s_0 {safety}");
        assert!(solved["rating_life_l10r_mrev"].as_f64().unwrap() > 50.0, "{options}");
    }
}

/// A step that the run chose itself is no ground for a warning.
#[test]
fn limit_runs_of_new_cases_are_stable() {
    let scratch = Scratch::new();
    for name in ["608", "6206", "7210B"] {
        run_in(&scratch.0, &format!("new {name}")).table();
        let ran = run_in(&scratch.0, &format!("run {name}.ron -o {name}.mcap --duration 0.01 --quiet --json")).json();
        let warnings: Vec<&str> = ran["warnings"].as_array().unwrap().iter().map(|w| w.as_str().unwrap()).collect();
        assert!(!warnings.iter().any(|warning| warning.contains("stability")), "{name}: {warnings:?}");
    }
}

/// A scene of 38 balls is longer than any message that a report reads, which such a recording was refused for.
#[test]
fn regress_a_recording_of_many_balls_is_reported() {
    let scratch = Scratch::new();
    run_in(&scratch.0, "new 71821C").table();
    run_in(&scratch.0, "run 71821C.ron -o run.mcap --duration 0.002 --set transient.start=QuasiStatic --quiet").table();
    let report = run_in(&scratch.0, "report run.mcap -o report --json").json();
    assert_eq!(report["bearing"].as_str().map(|name| &name[..6]), Some("71821C"), "{report}");
}

/// The nine balls of the 6206 are found, and every assumption has its reason.
#[test]
fn identity_a_new_case_says_where_its_values_come_from() {
    let scratch = Scratch::new();
    run_in(&scratch.0, "new 6206 --radial 2000 --axial 300 --speed 3600").table();
    let text = std::fs::read_to_string(scratch.0.join("6206.ron")).unwrap();
    for part in [
        "ball_count: 9,",
        "ball_diameter: mm(9.525),",
        "x: Force(N(2000)),",
        "z: Force(N(300)),",
        "inner: Constant(rpm(3600)),",
        "scheme: FastTo(accuracy: 0.001),",
        "\"rating\": Catalogue(\"NSK",
        "\"geometry.fit\": Assumed(\"middle of clearance group CN, 5 to 20 um",
    ] {
        assert!(text.contains(part), "`{part}` is not in\n{text}");
    }
    let sources = tribodyn_case::Case::from_ron(&text).unwrap().sources;
    for (path, _) in tribodyn_case::values(&text) {
        let of = |key: &String| {
            path.strip_prefix(key.as_str()).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        assert!(path == "name" || sources.keys().any(of), "`{path}` has no source");
    }
}

#[test]
fn limit_what_new_cannot_make_is_refused() {
    let scratch = Scratch::new();
    let refused = |line: &str, parts: &[&str]| {
        run_in(&scratch.0, &format!("new {line}")).fails(2, parts);
    };
    refused("7210", &["needs a contact angle", "15°, 25°, 30°, 40°"]);
    refused("6299", &["no bearing `6299`", "6200 to 6240"]);
    refused("6206garbage", &["`GARBAGE` after", "clearance (C2, CN, C3, C4, C5)"]);
    refused("1206", &["self-aligning"]);
    refused("", &["required"]);
    refused("--bore 50", &["--outside"]);
    refused("--bearing angular --bore 50 --outside 90 --width 20", &["--angle"]);
    refused("--bore 50 --outside 40 --width 20", &["outside diameter is 40 mm", "greater than the bore"]);
    refused("--bore 50 --outside 90 --width 20 --balls 30 --ball 12.7", &["30 balls of 12.7 mm"]);
    refused("6206 --radial nan", &["--radial"]);
    refused("--ask", &["no terminal to ask on"]);
    assert_eq!(scratch.names(), [""; 0], "nothing half-written");
    // A file that is there stays.
    scratch.file("6206.ron", "mine");
    run_in(&scratch.0, "new 6206").fails(1, &["6206.ron exists already", "-o", "--force"]);
    assert_eq!(std::fs::read_to_string(scratch.0.join("6206.ron")).unwrap(), "mine");
    run_in(&scratch.0, "new 6206 --force").table();
    assert!(std::fs::read_to_string(scratch.0.join("6206.ron")).unwrap().contains("ball_count: 9,"));
}

/// Warnings of slips that once passed in silence: a modulus in MPa, a density with a digit too few; and a note on an
/// axial position that is held.
#[test]
fn limit_check_and_solve_warn_of_slips() {
    let ag = fixture("paper-ag.ron");
    let case = ag.to_str().unwrap();
    let checked = run_words(&format!("check {case} --json")).json();
    // What the paper's case leaves out or cannot have is named; no value of it looks like a slip.
    let warnings = checked["warnings"].as_array().unwrap();
    for (warning, part) in warnings.iter().zip(["no bubbles", "grows by", "contact constants"]) {
        assert!(warning.as_str().unwrap().contains(part), "{warning}");
    }
    assert_eq!(warnings.len(), 3, "{warnings:?}");
    assert!(checked["notes"][0].as_str().unwrap().contains("middle of the axial play"));
    let slips = "--set materials.ball.young=MPa(208) --set materials.ball.density=kg_per_m3(780) --json";
    let warnings = run_words(&format!("check {case} {slips}")).json()["warnings"].to_string();
    for part in ["GPa(208) would be", "780 kg/m³: usual is 3000 to 16000 kg/m³", "ten times too small"] {
        assert!(warnings.contains(part), "{warnings}");
    }
    let held = run_words(&format!("check {case} --set ring.z=Held(um(0)) --json")).json();
    assert!(held["notes"][1].as_str().unwrap().contains("take the middle"), "{}", held["notes"]);
    let harris = fixture("bearing-218.ron");
    let solve = |options: &str| {
        let line = format!("solve {} --model jones-harris {options} --json", harris.to_str().unwrap());
        run_words(&line).json()["warnings"].to_string()
    };
    assert_eq!(solve(""), "[]");
    let pressed = solve("--set ring.z.Force=kN(900)");
    assert!(pressed.contains("4.2 GPa at rest (ISO 76)"), "{pressed}");
    let cut = solve("--set geometry.inner_shoulder=Height(mm(4))");
    assert!(cut.contains("beyond the shoulder") || cut.contains("cut by the shoulder of the inner race"), "{cut}");
}

/// Ring growth in `check`: the paper's bearing tight on its shaft and warm within.
#[test]
fn identity_check_prints_the_drawn_mounted_and_running_bearing() {
    let ag = fixture("paper-ag.ron");
    let ring = |diameter: &str, heat: &str| {
        format!("(seat_diameter:{diameter},expansion:per_K(10.4e-6),temperature_rise:K({heat}))")
    };
    let (inner, outer) = (ring("mm(120)", "0"), ring("mm(215)", "0"));
    let ball = "(expansion:per_K(10.4e-6),temperature_rise:K(0))";
    let mounting = format!("--set mounting=(inner:{inner},outer:{outer},ball:{ball})");
    let checked = run_words(&format!("check {} {mounting} --json", ag.to_str().unwrap())).json();
    let growth = |field: &str| checked["growth"][field].as_f64().unwrap();
    // Free ring: ρ ω² r³/E with the mean radius of bore and groove, about 60.4 mm: 17.8 µm at 14 000 r/min.
    assert!((growth("raceway_growth_inner_m") - 17.8e-6).abs() < 0.5e-6, "{}", checked["growth"]);
    assert!((growth("contact_angle_drawn_deg") - growth("contact_angle_mounted_deg")).abs() < 1e-9);
    assert!(growth("contact_angle_running_deg") < 17.7);
    assert_eq!(checked["contact_angle_deg"].as_f64().unwrap(), growth("contact_angle_running_deg"));
}

/// A suffix does what it says: clearance and ceramic balls are in the case, and every part is explained in it. Loads
/// may be negative.
#[test]
fn identity_suffixes_are_in_the_new_case() {
    let scratch = Scratch::new();
    let text = |options: &str| {
        run_in(&scratch.0, &format!("new {options} -o case.ron --force")).table();
        std::fs::read_to_string(scratch.0.join("case.ron")).unwrap()
    };
    let plain = text("6206");
    assert!(plain.contains("RadialClearance(um(12.5))"), "{plain}");
    // 13 to 28 µm.
    let loose = text("6206-2RS/C3");
    for part in ["RadialClearance(um(20.5))", "clearance group C3", "// 2RS: contact seal", "// C3: radial internal"] {
        assert!(loose.contains(part), "`{part}` is not in\n{loose}");
    }
    let hybrid = text("7014ACD/HCP4A --axial -500 --radial -100");
    for part in ["ball: (young: GPa(310)", "ContactAngle(deg(25))", "z: Force(N(-500))", "x: Force(N(-100))"] {
        assert!(hybrid.contains(part), "`{part}` is not in\n{hybrid}");
    }
}

#[test]
fn identity_the_catalogue_lists_what_new_makes() {
    let all = run_words("catalogue --json").json();
    assert!(all.as_array().unwrap().len() > 500);
    let found = run_words("catalogue 6205 --json").json();
    let six = &found.as_array().unwrap()[0];
    assert_eq!((&six["bore_mm"], &six["dynamic_rating_n"]), (&25.0.into(), &14_000.0.into()));
    assert_eq!((&six["ball_count"], &six["pitch_diameter_mm"]), (&9.into(), &39.04.into()));
    let listed = run_words("catalogue 7210*");
    let table = listed.table();
    assert!(table.contains("7210AC") && !table.contains("7310"), "{table}");
    run_words("catalogue 99999").fails(2, &["no bearing of the list"]);
}
