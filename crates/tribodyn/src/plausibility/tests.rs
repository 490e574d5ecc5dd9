//! Unusual values are named, with the slip that they look like; usual ones are not.

use super::*;
use tribodyn_case::set_value;

const AG: &str = include_str!("../../../../fixtures/cases/paper-ag.ron");
const WORN: &str = include_str!("../../../../fixtures/cases/paper-ag-worn.ron");
const PTFE: &str = include_str!("../../../../fixtures/cases/paper-ptfe.ron");
const HARRIS: &str = include_str!("../../../../fixtures/cases/bearing-218.ron");

#[track_caller]
fn finding(path: &str, value: &str) -> String {
    let found = unusual_values(&set_value(AG, path, value).unwrap());
    assert_eq!(found.len(), 1, "{found:?}");
    found[0].clone()
}

#[test]
fn limit_the_fixtures_have_usual_values() {
    for text in [AG, WORN, PTFE, HARRIS] {
        assert_eq!(unusual_values(text), [""; 0]);
    }
}

#[test]
fn limit_a_slip_of_the_unit_is_named() {
    let steel = finding("materials.ball.young", "MPa(208)");
    assert!(steel.contains("`materials.ball.young` is MPa(208), 0.208 GPa: usual is 100 to 700 GPa"), "{steel}");
    assert!(steel.contains("GPa(208) would be: a slip of the unit?") && steel.contains("handbook"), "{steel}");
    let soft = finding("wear.inner.hardness", "Pa(250)");
    assert!(soft.contains("MPa(250) or ksi(250) would be"), "{soft}");
    let heavy = finding("materials.ball.density", "g_per_cm3(7850)");
    assert!(heavy.contains("kg_per_m3(7850) would be"), "{heavy}");
}

#[test]
fn limit_a_slip_of_the_decimal_point_is_named() {
    let ten = finding("materials.inner.young", "GPa(20.8)");
    assert!(ten.contains("ten times too small"), "{ten}");
    let thousand = finding("cage.pocket_friction", "100");
    assert!(thousand.contains("a thousand times too large"), "{thousand}");
    let neither = finding("materials.outer.poisson", "0.45");
    assert!(neither.contains("usual is 0.14 to 0.36") && !neither.contains("slip"), "{neither}");
}

/// Every row of the table has a range, a source, and no other row before it that takes its values.
#[test]
fn identity_each_row_of_the_table_is_reached() {
    for range in USUAL_RANGES {
        assert!(range.least < range.most && !range.source.is_empty(), "{}", range.path);
        let example = range.path.replace('*', "inner");
        assert_eq!(usual_range(&example).map(|found| found.path), Some(range.path));
    }
    assert_eq!(usual_range("ring.z"), None);
}

#[test]
fn limit_springs_alike_about_two_axes_are_said_once() {
    let path = "supports.outer.stiffness";
    let found = unusual_values(&set_value(AG, path, "(N_per_um(0.02), N_per_um(0.02))").unwrap());
    assert!(found.len() == 1 && found[0].contains(path), "{found:?}");
    let tilt = "(inertia: Given(polar: kg_m2(0.02), transverse: kg_m2(0.02)),
        stiffness: (Nm_per_mrad(20), Nm_per_mrad(20)), damping: (Nm_s_per_rad(1), Nm_s_per_rad(1)))";
    assert_eq!(unusual_values(&set_value(AG, "supports.tilt", tilt).unwrap()), [""; 0]);
}
