//! A bearing in oil: films, torque, life, and what is refused.

use super::{assert_close, fixture, run_words};
use serde_json::Value;

fn oil(command: &str, options: &str) -> Value {
    run_words(&format!("{command} {} {options} --json", fixture("oil-6206.ron").to_str().unwrap())).json()
}

fn number(value: &Value, field: &str) -> f64 {
    value[field].as_f64().unwrap_or_else(|| panic!("no number `{field}` in {value}"))
}

/// Values worked out beside this program: ν at 70 °C, ν_1 of ISO 281, SKF's torque.
#[test]
fn code_oil_and_torque_of_a_6206() {
    let film = oil("film case", "");
    assert_close(number(&film["oil"], "kinematic_viscosity_mm2_s"), 20.2794, 1e-5);
    assert_close(number(&film, "reference_viscosity_mm2_s"), 12.1136, 1e-5);
    assert_close(number(&film, "viscosity_ratio"), 20.2794 / 12.1136, 2e-5);
    for (rpm, expected) in [(500, 20.709), (3000, 26.146), (10_000, 38.562)] {
        let torque = oil("torque", &format!("--set speed.inner=Constant(rpm({rpm}))"));
        assert_close(number(&torque, "skf_torque_nm") * 1e3, expected, 1e-4);
        let parts: f64 = ["rolling_nm", "sliding_inner_nm", "sliding_outer_nm", "fluid_nm", "cage_nm"]
            .iter()
            .map(|part| number(&torque, part))
            .sum();
        assert_close(parts, number(&torque, "torque_nm"), 1e-9);
        // Nothing but rolling and sliding brakes it: the power of the contacts is that of the shaft, to what an
        // equilibrium leaves that takes the ring's offset to first order.
        assert!(number(&torque, "cage_nm").abs() < 1e-4 * number(&torque, "torque_nm"), "{torque}");
    }
}

/// Every loaded contact has a film of some tenths of a micrometre; what is unloaded has none, and neither has silver.
#[test]
fn limit_films_of_an_engineer_and_none_where_there_is_none() {
    let solved = oil("solve", "--model traction");
    let mut loaded = 0;
    for ball in solved["balls"].as_array().unwrap() {
        for race in ["inner", "outer"] {
            let film = ball.get(format!("film_central_{race}_m")).and_then(Value::as_f64);
            let rolls = number(ball, &format!("rolling_speed_{race}_m_s")) > 1e-3;
            assert_eq!(film.is_some(), rolls && number(ball, &format!("load_{race}_n")) > 0.0);
            let Some(film) = film else { continue };
            loaded += 1;
            assert!((0.05e-6..1e-6).contains(&film), "{film:e} m");
            assert!(film > number(ball, &format!("film_minimum_{race}_m")));
            assert!((0.3..8.0).contains(&number(ball, &format!("lambda_ratio_{race}"))), "{ball}");
            assert!((0.0..50.0).contains(&number(ball, &format!("film_temperature_rise_{race}_k"))), "{ball}");
        }
    }
    assert!(loaded >= 6, "{loaded} loaded contacts");
    let dry = run_words(&format!("solve {} --model traction --json", fixture("paper-ag.ron").to_str().unwrap())).json();
    assert!(dry["balls"][0].get("film_central_inner_m").is_none());
}

/// The viscosity ratio comes from the oil, the contamination factor from the class.
#[test]
fn identity_modified_life_from_the_oil() {
    let rated = oil("rating", "--model traction");
    assert_close(number(&rated, "viscosity_ratio"), 20.2794 / 12.1136, 2e-5);
    assert_close(number(&rated, "contamination_factor"), 0.55, 1e-12);
    let given = oil("rating", "--model traction --set rating.viscosity_ratio=1.6741 --set rating.cleanliness=Normal");
    assert_close(number(&given, "life_modification_factor"), number(&rated, "life_modification_factor"), 1e-3);
    let slow = oil("rating", "--model traction --set speed.inner=Constant(rpm(5))");
    assert!(slow["life_modification_factor"].is_null());
    assert!(slow["lubrication_note"].as_str().unwrap().contains("from 0.1 on"), "{slow}");
}

/// 555 N on the inner contact of a 6206: hours of no table, but the powers of the formulas.
#[test]
fn identity_one_contact_follows_the_formulas() {
    let line = "film contact --oil mineral-vg68 --temperature 70 --load 555 --radius 3.78 --across 120 --json";
    let at = |speed: f64| run_words(&format!("{line} --speed {speed}")).json();
    let (slow, slower) = (at(0.02), at(0.01));
    let power = (number(&slow, "film_central_m") / number(&slower, "film_central_m")).log2();
    assert!((power - 0.67).abs() < 2e-3, "{power}");
    assert!((2.0..5.0).contains(&number(&at(3.46), "lambda_ratio")));
}

#[test]
fn limit_bad_oils_and_contacts_are_refused() {
    let contact = |options: &str| run_words(&format!("film contact --load 555 --speed 3 --radius 4 {options}"));
    contact("--oil mineral-vg70 --temperature 70").fails(2, &["VG 70", "46, 68, 100"]);
    contact("--oil mineral-vg68 --temperature 700").fails(2, &["temperature is 700", "-60 to 300 °C"]);
    contact("--oil mineral-vg68 --temperature 70 --across 1").fails(2, &["ellipticity", "1 or more"]);
    contact("--oil mineral-vg68 --temperature 70 --starvation 2").fails(2, &["starvation"]);
    let case = fixture("oil-6206.ron");
    let set = |change: &str| run_words(&format!("solve {} --set {change}", case.to_str().unwrap()));
    set("lubricant.temperature=K(70)").fails(2, &["lubricant.temperature", "-60 to 300 °C"]);
    set("lubricant.oil=Library(\"whale-vg68\")").fails(2, &["lubricant.oil", "as in mineral-vg68"]);
    let dry = fixture("paper-ag.ron");
    run_words(&format!("film case {}", dry.to_str().unwrap())).fails(2, &["no `lubricant`"]);
}
