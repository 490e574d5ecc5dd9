//! A bearing in oil: films, torque, life, and what is refused.

use super::{Scratch, assert_close, fixture, run_words};
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
        let torque = oil("torque", &format!("--model traction --set speed.inner=Constant(rpm({rpm}))"));
        assert_close(number(&torque, "skf_torque_nm") * 1e3, expected, 1e-4);
        let parts: f64 = ["rolling_nm", "hysteresis_nm", "sliding_inner_nm", "sliding_outer_nm", "fluid_nm", "cage_nm"]
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
    run_words("film contact --oil mineral-vg68 --temperature 70 --load 5e9 --speed 3 --radius 4 --across 120")
        .fails(2, &["--load 5000000000", "no contact is elastic beyond 12 GPa"]);
    let case = fixture("oil-6206.ron");
    let set = |change: &str| run_words(&format!("solve {} --set {change}", case.to_str().unwrap()));
    set("lubricant.temperature=K(70)").fails(2, &["lubricant.temperature", "-60 to 300 °C"]);
    set("lubricant.oil=Library(\"whale-vg68\")").fails(2, &["lubricant.oil", "as in mineral-vg68"]);
    let dry = fixture("paper-ag.ron");
    run_words(&format!("film case {}", dry.to_str().unwrap())).fails(2, &["no `lubricant`"]);
}

/// A sealed 6206 at 3000 r/min under a twentieth of its rating is hand-warm; all friction arrives at the surroundings.
#[test]
fn identity_a_greased_bearing_is_hand_warm_and_its_heat_leaves() {
    let scratch = Scratch::new();
    let case = scratch.0.join("case.ron");
    let case = case.to_str().unwrap();
    run_words(&format!("new 6206-2RS --radial 975 --axial 0 --speed 3000 -o {case}")).table();
    let heat = |options: &str| run_words(&format!("heat {case} {options} --json")).json();
    let usual = heat("");
    let outer = number(&usual, "outer_temperature_deg_c");
    assert!((25.0..60.0).contains(&outer), "{usual}");
    assert!(number(&usual, "ball_temperature_deg_c") > outer && outer > number(&usual, "housing_temperature_deg_c"));
    for found in [&usual, &heat("--cooling 0.3"), &heat("--oil-flow 0.5")] {
        let left: f64 = ["heat_shaft_w", "heat_housing_w", "heat_oil_w"].iter().map(|way| number(found, way)).sum();
        assert_close(left, number(found, "friction_power_w"), 1e-9);
        // The power is that of the torque at this speed.
        let shaft = number(found, "torque_nm") * 3000.0 * std::f64::consts::PI / 30.0;
        assert_close(number(found, "friction_power_w"), shaft, 1e-3);
    }
    // Less cooling, warmer and thinner oil; the other way with a flow of oil.
    let [closed, flooded] = ["--cooling 0.3", "--oil-flow 0.5"].map(heat);
    assert!(number(&closed, "outer_temperature_deg_c") > outer + 5.0, "{closed}");
    assert!(number(&closed, "kinematic_viscosity_mm2_s") < number(&usual, "kinematic_viscosity_mm2_s"));
    assert!(number(&flooded, "outer_temperature_deg_c") < outer, "{flooded}");
}

#[test]
fn limit_heat_that_cannot_leave_and_bad_surroundings_are_refused() {
    let case = fixture("oil-6206.ron");
    let heat = |options: &str| run_words(&format!("heat {} {options}", case.to_str().unwrap()));
    heat("--cooling 0.005 --set speed.inner=Constant(rpm(12000))").fails(1, &["run away", "W of friction"]);
    heat("--cooling -1").fails(2, &["--cooling", "a factor above 0"]);
    heat("--cooling 0").fails(2, &["--cooling", "a factor above 0"]);
    heat("--surroundings 400").fails(2, &["--surroundings", "-60 to 150 °C"]);
    heat("--oil-flow nan").fails(2, &["--oil-flow"]);
    // What heat and speed leave of the clearance is no value of the case.
    let scratch = Scratch::new();
    let fast = scratch.0.join("fast.ron");
    let fast = fast.to_str().unwrap();
    run_words(&format!("new 7014C -o {fast}")).table();
    run_words(&format!("heat {fast} --set speed.inner.Constant=rpm(60000)"))
        .fails(1, &["clamps", "would be -107 µm", "least allowed is -60 µm", "less speed"]);
    let dry = fixture("paper-ag.ron");
    run_words(&format!("heat {}", dry.to_str().unwrap()))
        .fails(2, &["paper-ag.ron: it has no `lubricant`, which temperatures need"]);
}

/// Deep-groove bearings as `new` writes them: nobody has to ask for equations that have an answer with idle balls, and
/// what the shaft gives is lost in contacts and cage.
#[test]
fn identity_friction_and_films_are_by_the_steady_orbit_unless_others_are_asked_for() {
    let scratch = Scratch::new();
    let case = scratch.0.join("case.ron");
    let case = case.to_str().unwrap();
    run_words(&format!("new 608 --axial 0 -o {case}")).table();
    for command in ["torque", "film case", "heat"] {
        let answer = run_words(&format!("{command} {case} --json")).json();
        assert_eq!(answer["model"], "steady-orbit");
        assert_eq!(answer["implausible"], serde_json::json!([]), "{command}");
    }
    let torque = run_words(&format!("torque {case} --json")).json();
    let solved = run_words(&format!("solve {case} --json")).json();
    assert_close(number(&torque, "torque_nm"), number(&solved, "shaft_torque_nm"), 1e-9);
    let lost = number(&torque, "sliding_inner_nm") + number(&torque, "sliding_outer_nm");
    let lost = lost + number(&torque, "rolling_nm") + number(&torque, "hysteresis_nm") + number(&torque, "fluid_nm");
    assert_close(lost, number(&torque, "torque_nm"), 2e-3);
}

/// Jones–Harris has no friction, and rings that turn together none to ask for; neither is offered or sought.
#[test]
fn limit_answers_about_friction_need_a_model_and_speeds_that_have_it() {
    let case = fixture("oil-6206.ron");
    let case = case.to_str().unwrap();
    for command in ["torque", "film case", "heat"] {
        run_words(&format!("{command} {case} --model jones-harris"))
            .fails(2, &["--model jones-harris", "without friction", "traction, steady-orbit"]);
        let help = run_words(&format!("{command} --help")).out;
        assert!(help.contains("steady-orbit") && !help.contains("jones-harris"), "{help}");
    }
    let together = "--set speed.outer=Constant(rpm(3000))";
    for command in ["torque", "heat"] {
        run_words(&format!("{command} {case} {together}")).fails(2, &["do not turn against each other"]);
    }
    run_words(&format!("solve {case} {together}")).fails(2, &["as one body", "jones-harris"]);
}

/// Rows of docs/torque.md, from the speed at which films are thin to the fastest, come out again.
#[test]
fn regress_the_table_of_torques() {
    let page = std::fs::read_to_string(fixture("../../docs/torque.md")).unwrap();
    let rows: Vec<Vec<&str>> = page
        .lines()
        .filter(|line| line.contains(" | vg"))
        .map(|line| line.split('|').map(str::trim).filter(|cell| !cell.is_empty()).collect())
        .collect();
    assert_eq!(rows.len(), 30);
    let scratch = Scratch::new();
    let case = scratch.0.join("case.ron");
    let case = case.to_str().unwrap();
    for (bearing, rating, speeds) in [("6204", 12_800.0, ["500", "15000"]), ("6206", 19_500.0, ["2000", "10000"])] {
        let radial = rating / 20.0;
        run_words(&format!("new {bearing} --lubricant vg68 --radial {radial} --axial 0 -o {case} --force")).table();
        for rpm in speeds {
            let row = rows.iter().find(|row| row[..4] == [bearing, "vg68", "C/20", rpm]).unwrap();
            let line = format!("torque {case} --model traction --set speed.inner=Constant(rpm({rpm})) --json");
            let torque = run_words(&line).json();
            for (column, field) in [(5, "rolling"), (6, "sliding"), (7, "torque_nm"), (10, "skf_torque_nm")] {
                let found = match field {
                    "rolling" => number(&torque, "rolling_nm") + number(&torque, "hysteresis_nm"),
                    "sliding" => number(&torque, "sliding_inner_nm") + number(&torque, "sliding_outer_nm"),
                    field => number(&torque, field),
                };
                let printed: f64 = row[column].parse().unwrap();
                assert!((1e3 * found - printed).abs() < 0.01 * printed + 0.006, "{row:?} {field}: {found}");
            }
        }
    }
}
