//! `rating`: against another program, and against hand calculations in the standards' own numbers.

use super::new::run_in;
use super::{Scratch, assert_close, fixture, run_words};
use serde_json::Value;

/// The bearing of another program's two values: Z 7, D 11.5, d_m 43.5 mm, f 0.52 and 0.53, 210 GPa, 0.3, no clearance.
fn check_bearing(command: &str, load: &str) -> Value {
    let case = fixture("bearing-218.ron");
    let steel = "(young:GPa(210),poisson:0.3,density:kg_per_m3(7800))";
    let mut line = format!("{command} {} --json", case.to_str().unwrap());
    for change in [
        "geometry.ball_count=7",
        "geometry.ball_diameter=mm(11.5)",
        "geometry.pitch_diameter=mm(43.5)",
        "geometry.inner_groove=Coefficient(0.52)",
        "geometry.outer_groove=Coefficient(0.53)",
        "geometry.fit=RadialClearance(mm(0))",
        &format!("materials.ball={steel}"),
        &format!("materials.inner={steel}"),
        &format!("materials.outer={steel}"),
        "modelling.contact_at_actual_angle=false",
        "speed.inner=Constant(rpm(0))",
        "rating.dynamic=N(23400)",
    ] {
        line += &format!(" --set {change}");
    }
    run_words(&format!("{line} {load}")).json()
}

fn number(value: &Value, field: &str) -> f64 {
    value[field].as_f64().unwrap_or_else(|| panic!("no number `{field}` in {value}"))
}

const RADIAL: &str = "--set ring.x=Force(N(1000)) --set ring.z=Held(um(0))";
const AXIAL: &str = "--set ring.x=Held(um(0)) --set ring.y=Held(um(0)) --set ring.z=Force(N(1000))";

#[test]
fn code_reference_life_and_displacement_under_radial_load_at_rest() {
    let solved = check_bearing("solve --model jones-harris", RADIAL);
    assert_close(number(&solved, "ring_displacement_x_m"), 15.1101e-6, 2e-4);
    assert_close(number(&solved, "rating_life_l10r_mrev"), 13_163.019, 2e-4);
    assert_close(number(&check_bearing("rating", RADIAL), "rating_life_l10r_mrev"), 13_163.019, 2e-4);
    // By hand: L_10 = (23 400/1000)³.
    assert_close(number(&solved, "rating_life_l10_mrev"), 23.4f64.powi(3), 1e-6);
    assert!(solved.get("rating_life_hours").is_none(), "hours at rest");
}

#[test]
fn code_reference_life_and_displacement_under_axial_load_at_rest() {
    let solved = check_bearing("solve --model jones-harris", AXIAL);
    assert_close(number(&solved, "ring_displacement_z_m"), 133.5381e-6, 2e-4);
    assert_close(number(&solved, "rating_life_l10r_mrev"), 2222.7318, 2e-4);
}

/// a_ISO and reliability multiply the reference life, and hours follow from the speed of the rings against each other.
#[test]
fn identity_modified_life_and_hours() {
    let case = fixture("bearing-218.ron");
    let rated = |options: &str| run_words(&format!("rating {} {options} --json", case.to_str().unwrap())).json();
    let plain = rated("");
    assert_eq!(plain["dynamic_rating_source"], "computed");
    assert!(plain["life_modification_factor"].is_null() && plain["rating_life_lnmr_mrev"].is_null());
    let life = number(&plain, "rating_life_l10r_mrev");
    // 10000 r/min are 0.6 million turns an hour.
    assert_close(number(&plain, "rating_life_hours"), life / 0.6, 1e-9);
    let film = rated("--set rating.viscosity_ratio=2 --set rating.contamination=0.6 --set rating.reliability=99");
    let modified = 0.95 * (100f64 / 99.0).ln().powf(2.0 / 3.0) / (100f64 / 90.0).ln().powf(2.0 / 3.0) + 0.05;
    assert_close(number(&film, "reliability_factor"), modified, 1e-9);
    let product = modified * number(&film, "life_modification_factor") * life;
    assert_close(number(&film, "rating_life_lnmr_mrev"), product, 1e-9);
    assert_close(number(&film, "rating_life_hours"), product / 0.6, 1e-9);
    // 40°, pure axial load: P = 0.57 F_a, P_0 = 0.26 F_a (ISO 281, ISO 76).
    assert_close(number(&plain, "equivalent_load_n"), 0.57 * 22_250.0, 1e-6);
    assert_close(number(&plain, "static_equivalent_load_n"), 0.26 * 22_250.0, 1e-6);
    let fails = run_words(&format!("rating {} --set geometry.fit=ContactAngle(deg(50))", case.to_str().unwrap()));
    fails.fails(2, &["nominal contact angle 50", "0° to 45°"]);
}

/// The ratios that Case Western Reserve University gives of its 6205, at the nominal angle; under load the contact
/// angle grows, and balls go round faster.
#[test]
fn paper_frequencies_of_a_known_bearing_in_check_and_rating() {
    let scratch = Scratch::new();
    run_in(&scratch.0, "new 6205 --lubricant ag -o case.ron").table();
    let ratios = |command: &str| {
        let f = run_in(&scratch.0, &format!("{command} case.ron --json")).json()["frequencies"].clone();
        ["cage_hz", "ball_pass_outer_hz", "ball_pass_inner_hz", "ball_defect_hz"]
            .map(|name| number(&f, name) / number(&f, "shaft_hz"))
    };
    let free = ratios("check");
    for (found, published) in free.into_iter().zip([0.39828, 3.5848, 5.4152, 4.7135]) {
        assert_close(found, published, 3e-4);
    }
    let loaded = ratios("rating --model jones-harris");
    assert!(loaded[1] > free[1] && loaded[1] < 1.05 * free[1], "{loaded:?} {free:?}");
    assert_close(loaded[1] + loaded[2], 9.0, 1e-12);
}
