//! Sheets at the ends of their range: no load, thin films, thrust, overload and speed.

use super::new::run_in;
use super::{Scratch, assert_close, run_words};
use serde_json::Value;

fn sheet(words: &str) -> Value {
    run_words(&format!("sheet {words} --json")).json()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn says(sheet: &Value, words: &str) -> bool {
    let warnings = sheet["warnings"].as_array().unwrap();
    warnings.iter().any(|warning| warning.as_str().unwrap().contains(words))
}

#[test]
fn limit_a_bearing_without_load_has_no_life() {
    for bearing in ["6206", "7210B"] {
        let still = format!("{bearing} --radial 0 --axial 0 --speed 3000");
        let answer = sheet(&still);
        for field in ["rating_life_l10_mrev", "rating_life_l10r_mrev", "rating_life_hours", "static_safety"] {
            assert!(answer["rating"][field].is_null(), "{field} is {}", answer["rating"][field]);
        }
        assert!(says(&answer, "no load: rating lives") && answer["friction_torque_estimate_nm"].is_null(), "{answer}");
        assert!(answer["loaded_balls"] == 0 && answer["contact_angle_rad"].is_null(), "{answer}");
        let printed = run_words(&format!("sheet {still}"));
        assert!(!printed.table().contains("million turns"), "{}", printed.out);
    }
}

#[test]
fn limit_a_thin_film_is_told_with_the_life() {
    let answer = sheet("6206 --radial 2000 --speed 10 --lubricant vg68");
    assert!(answer["rating"]["life_modification_factor"].is_null());
    assert!(says(&answer, "a_ISO from 0.1 on"), "{answer}");
    let printed = run_words("sheet 6206 --radial 2000 --speed 10 --lubricant vg68");
    assert!(printed.table().contains("warning: the viscosity ratio"), "{}", printed.out);
}

/// One limit of speed for each lubricant, in `sheet` and in `check`.
#[test]
fn identity_speed_is_judged_by_the_lubricant() {
    let scratch = Scratch::new();
    let of_both = |lubricant: &str, speed: f64| {
        let given = format!("6206 --lubricant {lubricant} --radial 2000 --speed {speed}");
        run_in(&scratch.0, &format!("new {given} -o case.ron --force")).table();
        let checked = run_in(&scratch.0, "check case.ron --json").json();
        [says(&sheet(&given), "pitch diameter times speed"), says(&checked, "pitch diameter times speed")]
    };
    assert_eq!(of_both("vg68", 15_000.0), [false; 2]);
    assert_eq!(of_both("vg68", 25_000.0), [true; 2]);
    assert_eq!(of_both("grease", 15_000.0), [true; 2]);
}

/// M = ½ µ P d, with µ = 0.0015 and the bore of 30 mm of a 6206.
#[test]
fn limit_the_rule_of_thumb_takes_the_bore() {
    let answer = sheet("6206 --radial 2000 --speed 10");
    assert_close(number(&answer["friction_torque_estimate_nm"]), 0.045, 1e-6);
    assert_eq!(answer["bore_source"], "catalogue");
}

/// The table of ISO 281 ends at F_a/(Z D²) = 6.89 N/mm².
#[test]
fn limit_thrust_beyond_the_table_is_told() {
    assert!(says(&sheet("6206 --radial 0 --axial 9000 --speed 1000"), "table ends at 6.89"));
    assert!(!says(&sheet("6206 --radial 0 --axial 5000 --speed 1000"), "table ends at 6.89"));
    let scratch = Scratch::new();
    run_in(&scratch.0, "new 6206 --radial 0 --axial 9000 -o case.ron").table();
    let rated = run_in(&scratch.0, "rating case.ron --model jones-harris --json").json();
    assert!(says(&rated, "table ends at 6.89"), "{rated}");
}

/// A deep-groove bearing carries thrust both ways alike, an angular-contact one does not.
#[test]
fn identity_thrust_of_either_sign() {
    let [plus, minus] = ["500", "-500"].map(|axial| sheet(&format!("6206 --radial 1000 --axial {axial} --speed 3000")));
    for field in ["rating_life_l10r_mrev", "static_safety", "equivalent_load_n"] {
        assert_close(number(&minus["rating"][field]), number(&plus["rating"][field]), 1e-6);
    }
    let z = |answer: &Value| number(&answer["ring_displacement_m"][2]);
    assert_close(-z(&minus), z(&plus), 1e-6);
    run_words("sheet 7210B --radial 1000 --axial -500 --speed 3000").fails(2, &["turn its sign"]);
    run_words("sheet 6206 --radial -5 --speed 3000").fails(2, &["--radial -5: allowed is 0 N or more"]);
}

#[test]
fn limit_too_little_thrust_is_named() {
    let answer = run_words("sheet 7210B --radial 3000 --axial 1 --speed 3000");
    answer.fails(2, &["axial load of 1 N is too little", "about 2517 N"]);
}

#[test]
fn limit_overload_and_speeds_of_no_bearing_are_refused() {
    run_words("sheet 6206 --radial 1e6 --speed 3000").fails(2, &["no contact is elastic beyond 12 GPa"]);
    run_words("sheet 6206 --radial 1000 --speed 1e7").fails(2, &["--speed 10000000: allowed is up to 954930 r/min"]);
}

/// Errors name the option that brought a value in where no file holds it.
#[test]
fn limit_errors_name_the_option() {
    let scratch = Scratch::new();
    for (line, option) in [
        ("new 6206 --lubricant vg68cst -o x.ron", "--lubricant"),
        ("new 6206 --shaft-fit k55 -o x.ron", "--shaft-fit"),
        ("sheet 6206 --radial 1000 --speed 10 --lubricant vg69", "--lubricant"),
    ] {
        let answer = run_in(&scratch.0, line);
        answer.fails(2, &[option]);
        assert!(!answer.err.contains(".ron:") && !answer.err.contains("6206:"), "{}", answer.err);
    }
    let unknown = run_words("catalogue 9999");
    unknown.fails(2, &["9999: no bearing of the list"]);
    assert!(!unknown.err.contains("--catalogue"), "{}", unknown.err);
    run_in(&scratch.0, "new 6206 -o oil.ron").table();
    run_in(&scratch.0, "solve oil.ron --varying true").fails(2, &["--varying true: the case is lubricated and has no"]);
    let cold = run_in(&scratch.0, "check oil.ron --set lubricant.temperature=K(70)");
    cold.fails(2, &["temperature is -203.15 °C"]);
}
