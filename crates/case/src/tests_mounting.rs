//! Fits, temperatures, shoulders and ratings of a case: what they do, and what is refused.

use crate::{Case, Growths, set_value};
use tribodyn_bearing::Side;
use tribodyn_bearing::fits::Within;

const AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");

/// The paper's bearing on a hollow shaft, 60 K warmer within than without.
const MOUNTING: &str = "(
    inner: (
        seat_diameter: mm(120), expansion: per_K(10.4e-6), temperature_rise: K(60),
        seat: (
            interference: um(20), far_diameter: mm(40), expansion: per_K(10.4e-6), temperature_rise: K(60),
            material: (young: GPa(208), poisson: 0.28, density: kg_per_m3(7800)),
        ),
    ),
    outer: (seat_diameter: mm(215), expansion: per_K(10.4e-6), temperature_rise: K(0)),
    ball: (expansion: per_K(10.4e-6), temperature_rise: K(30)),
)";

fn text(changes: &[(&str, &str)]) -> String {
    changes.iter().fold(AG.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap())
}

fn case(changes: &[(&str, &str)]) -> Case {
    Case::from_ron(&text(changes)).unwrap()
}

#[track_caller]
fn refused(changes: &[(&str, &str)]) -> String {
    let error = Case::from_ron(&text(changes)).unwrap_err();
    format!("{}: {}", error.path, error.message)
}

#[test]
fn limit_without_mounting_the_bearing_runs_as_drawn() {
    let plain = case(&[]);
    assert_eq!(plain.growths().unwrap(), None);
    assert_eq!(plain.running_geometry().unwrap(), plain.geometry.resolve().unwrap());
    assert_eq!(plain.bearing().unwrap().geometry, plain.geometry.resolve().unwrap());
}

/// The fit closes the mounted bearing, speed and heat the running one further; both solvers get the running one.
#[test]
fn identity_growth_reaches_the_bearing() {
    let hot = case(&[("mounting", MOUNTING)]);
    let Growths { mounted, running } = hot.growths().unwrap().unwrap();
    let drawn = hot.geometry.resolve().unwrap();
    let angles = [drawn, mounted.geometry, running.geometry].map(|g| g.contact_angle().to_degrees());
    assert!(angles[0] > angles[1] && angles[1] > angles[2], "{angles:?}");
    assert!(mounted.seat_pressure.inner.unwrap() > 0.0 && mounted.seat_pressure.outer.is_none());
    assert_eq!(hot.bearing().unwrap().geometry, running.geometry);
    // At rest and cold only the fit is left.
    let still = case(&[
        ("mounting", MOUNTING),
        ("mounting.inner.temperature_rise", "K(0)"),
        ("mounting.inner.seat.temperature_rise", "K(0)"),
        ("mounting.ball.temperature_rise", "K(0)"),
        ("speed.inner", "Constant(rpm(0))"),
    ]);
    let growths = still.growths().unwrap().unwrap();
    assert_eq!(growths.mounted, growths.running);
    assert_eq!(growths.mounted, mounted);
}

const K5: &str = "(class: \"k5\", ring: Normal, within: Mean, roughness: um(5))";

/// A shaft 120 k5 is 3 to 18 µm too large, a bore of the Normal class up to 20 µm too small: 20.5 µm in the middle, of
/// which 0.4 R_z are smoothed away. The case is that of an interference of 18.5 µm.
#[test]
fn identity_a_fit_by_class_is_its_interference() {
    let seat = MOUNTING.replace("interference: um(20)", &format!("fit: {K5}"));
    let by_class = case(&[("mounting", &seat)]);
    let by_length = case(&[("mounting", MOUNTING), ("mounting.inner.seat.interference", "um(18.5)")]);
    let inner = |case: &Case| case.mounting.unwrap().inner;
    assert!((inner(&by_class).seat.unwrap().effective_interference(0.12) - 18.5e-6).abs() < 1e-12);
    let [a, b] = [&by_class, &by_length].map(|case| case.growths().unwrap().unwrap());
    assert!((a.running.raceway_growth.inner / b.running.raceway_growth.inner - 1.0).abs() < 1e-9);
    // Tighter seats leave less clearance.
    let clearance = |within: Within| by_class.with_fits(within).growths().unwrap().unwrap().mounted.geometry;
    let [loose, mean, tight] = [Within::Loosest, Within::Mean, Within::Tightest].map(clearance);
    assert!(loose.radial_clearance() > mean.radial_clearance() && mean.radial_clearance() > tight.radial_clearance());
    assert_eq!(clearance(Within::Mean), a.mounted.geometry);
}

#[test]
fn limit_fits_that_do_not_belong_to_their_ring_are_refused() {
    let with = |fit: &str| refused(&[("mounting", &MOUNTING.replace("interference: um(20)", fit))]);
    let both = with(&format!("interference: um(20), fit: {K5}"));
    assert!(both.contains("mounting.inner.seat: an interference, or a fit by its class"), "{both}");
    let neither = refused(&[("mounting", &MOUNTING.replace("interference: um(20), ", ""))]);
    assert!(neither.contains("give one of them"), "{neither}");
    let capital = with(&format!("fit: {}", K5.replace("k5", "K6")));
    assert!(capital.contains("mounting.inner.seat.fit.class: an inner ring sits on a shaft"), "{capital}");
    let unknown = with(&format!("fit: {}", K5.replace("k5", "zz5")));
    assert!(unknown.contains("`zz5` is no tolerance class") && unknown.contains("such as k5"), "{unknown}");
    assert!(with(&format!("fit: {}", K5.replace("um(5)", "um(500)"))).contains("R_z of both surfaces"));
    let class = with(&format!("fit: {}", K5.replace("Normal", "P7")));
    assert!(class.contains("P7") && class.contains("P4"), "{class}");
    let lacking = with("fit: (ring: Normal)");
    assert!(["class", "within", "roughness"].iter().all(|name| lacking.contains(name)), "{lacking}");
}

/// An inner shoulder of 5 mm height in a groove of 15.718 mm: cos β = 1 − 5/15.718.
#[test]
fn identity_shoulders_by_height_and_by_diameter() {
    let by_height = case(&[("geometry.inner_shoulder", "Height(mm(5))")]).geometry;
    let angle = by_height.shoulder_angles().unwrap();
    assert!((angle.inner.unwrap().cos() - (1.0 - 5.0 / (0.52114 * 30.16))).abs() < 1e-12 && angle.outer.is_none());
    let bottom = by_height.resolve().unwrap().groove_bottom_radius(Side::Inner);
    let diameter = format!("Diameter(m({}))", 2.0 * bottom + 0.01);
    let by_diameter = case(&[("geometry.inner_shoulder", &diameter)]).geometry.shoulder_angles().unwrap();
    assert!((by_diameter.inner.unwrap() - angle.inner.unwrap()).abs() < 1e-9);
}

#[test]
fn limit_impossible_fits_shoulders_and_ratings_are_refused() {
    let mounted = |path: &str, value: &str| refused(&[("mounting", MOUNTING), (path, value)]);
    let wide = mounted("mounting.inner.seat_diameter", "mm(130)");
    assert!(
        wide.contains("mounting.inner.seat_diameter: must be greater than 0 and below the diameter of the groove"),
        "{wide}"
    );
    assert!(mounted("mounting.outer.seat_diameter", "mm(150)").contains("must be greater than"));
    assert!(mounted("mounting.inner.seat.interference", "mm(20)").contains("a hundredth of the seat"));
    assert!(mounted("mounting.inner.seat.far_diameter", "mm(120)").contains("a solid shaft"));
    assert!(mounted("mounting.ball.temperature_rise", "K(3000)").contains("2000 K"));
    assert!(mounted("mounting.inner.expansion", "per_K(11)").contains("per K"));
    let torn = refused(&[
        ("mounting", MOUNTING),
        ("mounting.inner.temperature_rise", "K(1900)"),
        ("mounting.inner.seat.temperature_rise", "K(1900)"),
    ]);
    assert!(torn.contains("mounting: radial clearance"), "{torn}");
    assert!(refused(&[("geometry.inner_shoulder", "Height(mm(40))")]).contains("within the groove"));
    assert!(refused(&[("geometry.outer_shoulder", "Diameter(mm(300))")]).contains("Diameter: must lie between"));
    assert!(refused(&[("rating.viscosity_ratio", "2")]).contains("belong together"));
    assert!(refused(&[("rating.reliability", "50")]).contains("between 90 and 99.95"));
    assert!(refused(&[("rating.contact_angle", "deg(60)")]).contains("between 0° and 45°"));
    assert!(refused(&[("rating.dynamic", "N(0)")]).contains("greater than 0"));
}
