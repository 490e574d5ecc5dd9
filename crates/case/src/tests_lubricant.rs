//! A lubricant in the place of coatings: what it makes of a bearing, and what is refused.

use super::*;
use tribodyn_bearing::Side;
use tribodyn_traction::TractionLaw;

const OIL: &str = include_str!("../../../fixtures/cases/oil-6206.ron");
const AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");

fn refused(path: &str, value: &str) -> String {
    let text = set_value(OIL, path, value).unwrap();
    Case::from_ron(&text).map(drop).unwrap_err().to_string()
}

#[test]
fn identity_an_oil_reaches_the_contacts() {
    let case = Case::from_ron(OIL).unwrap();
    for purpose in [Purpose::Traction, Purpose::Transient] {
        assert_eq!(case.require(purpose), Ok(()));
    }
    let bearing = case.bearing().unwrap();
    let film = |side| bearing.film_law(side).unwrap();
    // ½ D (1 ∓ γ).
    let gamma = 9.525 / 46.0;
    for (side, sign) in [(Side::Inner, -1.0), (Side::Outer, 1.0)] {
        assert!((film(side).rolling_radius / (4.7625e-3 * (1.0 + sign * gamma)) - 1.0).abs() < 1e-9);
        assert!((film(side).effective_modulus / (208e9 / 0.91) - 1.0).abs() < 1e-12);
    }
    let oil = &film(Side::Inner).oil;
    assert!((oil.kinematic_mm2_s(343.15) - 20.2794).abs() < 1e-4);
    assert!((film(Side::Inner).inlet.roughness - 0.02e-6f64.hypot(0.06e-6)).abs() < 1e-18);
    assert!(bearing.tribology.as_ref().unwrap().laws.inner.film().is_some() && bearing.elastic.is_none());
    assert!(case.run_inputs().unwrap().coatings.inner.thickness == 0.0);
    let grease = Case::from_ron(&set_value(OIL, "lubricant.supply", "Grease").unwrap()).unwrap();
    assert_eq!(grease.lubricant.unwrap().inlet(Side::Outer).unwrap().starvation, 0.7);
}

#[test]
fn limit_oils_that_are_none_are_refused() {
    assert!(refused("lubricant.oil", "Library(\"mineral-vg70\")").contains("ISO 3448 has 2, 3, 5"));
    assert!(refused("lubricant.oil", "Library(\"whale\")").contains("as in mineral-vg68"));
    assert!(refused("lubricant.oil", "Grade(stock: Pao, vg: 68, viscosity_index: 4000)").contains("0 to 400"));
    let viscosities =
        |at_40: &str, at_100: &str| format!("Viscosities(stock: Mineral, at_40: {at_40}, at_100: {at_100})");
    let rising = refused("lubricant.oil", &viscosities("mm2_per_s(8.8)", "mm2_per_s(68)"));
    assert!(rising.contains("falls with temperature"), "{rising}");
    // Dynamic for kinematic, and a number of mm²/s in m²/s.
    let unit = refused("lubricant.oil", &viscosities("Pa_s(68)", "mm2_per_s(8.8)"));
    assert!(unit.contains("expected a kinematic viscosity"), "{unit}");
    assert!(
        refused("lubricant.oil", &viscosities("m2_per_s(68)", "m2_per_s(8.8)")).contains("oils have 0.5 to 100000")
    );
    let stiff = "Viscosities(stock: Mineral, at_40: cSt(68), at_100: cSt(8.8), pressure: At40(per_Pa(20)))";
    assert!(refused("lubricant.oil", stiff).contains("oils have 3 to 60 1/GPa"));
    assert!(refused("lubricant.temperature", "K(70)").contains("oils have -60 to 300 °C"));
}

#[test]
fn limit_oil_in_pockets_that_cannot_be_is_refused() {
    let roughness = refused("cage.pocket_film.roughness", "um(26)");
    assert!(roughness.contains("at most a quarter of the pocket's gap, 25 um"), "{roughness}");
    assert!(refused("cage.pocket_film.fill", "1.2").contains("at most 1; leave pocket_film out of dry pockets"));
    assert!(refused("cage.pocket_film.roughness", "1").contains("expected a length with its unit"));
    let dry = set_value(AG, "cage.pocket_film", "(fill: 1, roughness: um(1))").unwrap();
    let message = Case::from_ron(&dry).map(drop).unwrap_err().to_string();
    assert!(message.contains("leave it out of a dry bearing"), "{message}");
}

#[test]
fn limit_values_of_no_bearing_are_refused() {
    assert!(refused("lubricant.roughness.ball", "mm(0.02)").contains("at most 5 um"));
    assert!(refused("lubricant.roughness.inner", "um(0)").contains("greater than 0"));
    assert!(refused("lubricant.starvation", "1.5").contains("at most 1"));
    assert!(refused("lubricant.shear", "Eyring(GPa(5))").contains("oils have 3 to 10"));
    assert!(refused("lubricant.boundary_friction", "12").contains("0.08 to 0.15"));
    assert!(refused("lubricant.hysteresis", "0.7").contains("bearing steel has 0.003 to 0.01"));
    assert!(refused("lubricant.hysteresis", "-0.01").contains("between 0 and"));
    assert!(refused("lubricant.patch", "TargetError(relative: 2)").contains("lubricant.patch.TargetError.relative"));
    assert!(refused("rating.contamination", "0.5").contains("say the same"));
    let both = set_value(AG, "lubricant", &OIL[locate(OIL, "lubricant").unwrap()]).unwrap();
    assert!(Case::from_ron(&both).unwrap_err().to_string().contains("leave out one of both"));
}

/// So and Klaus where α is not known, and what is given instead of the stock's.
#[test]
fn limit_oils_by_their_data_sheet() {
    let oil = |more: &str| {
        let text = format!("Viscosities(stock: Mineral, at_40: cSt(68), at_100: cSt(8.8){more})");
        let case = Case::from_ron(&set_value(OIL, "lubricant.oil", &text).unwrap()).unwrap();
        case.lubricant.unwrap().oil.oil().unwrap()
    };
    let alpha = |more: &str| -> f64 { oil(more).pressure_coefficient(313.15) * 1e9 };
    assert!((alpha(", pressure: At40(per_GPa(20))") - 20.0).abs() < 1e-9);
    assert!((20.0..28.0).contains(&alpha(", pressure: SoKlaus")), "{}", alpha(", pressure: SoKlaus"));
    // The stock's: a mean of 9.904 · 68^0.139 = 17.8 1/GPa up to 0.2 GPa.
    let usual = oil("");
    let rise: f64 = usual.pressure.viscosity(usual.dynamic(313.15), 0.2e9) / usual.dynamic(313.15);
    assert!((rise.ln() / 0.2 - 9.904 * 68f64.powf(0.139)).abs() < 1e-9 && alpha("") > 20.0);
    assert_eq!(oil(", density_15: g_per_cm3(0.9), limiting_shear: 0.06").density_15, 900.0);
}
