//! The figures.

use super::runs::Cases;
use super::spec::{Draw, Spec, spec};
use super::{curves, loads, over_time, steady};

const CURVES: &str = "Traction curves";
const VALIDATION: &str = "Transient: start and passing frequency";
const STEADY: &str = "Quasi-static cases";
const COATING: &str = "Transient: coatings";
const PRELOAD: &str = "Transient: axial loads";

/// All figures in the order of the page.
pub static SPECS: [Spec; 31] = [
    spec(CURVES, Cases::Curves, ["fig09-curves", "Fig. 9", "Traction curves at the tested pressures"], curves::curves)
        .noted(
            "The paper fits them to its tests to within 18.6 % (Ag) and 1.8 % (PTFE); it prints no test. The unit of \
         slip is not printed.",
        ),
    spec(
        CURVES,
        Cases::Curves,
        ["fig15-parameters", "Fig. 15", "Traction parameters over pressure"],
        curves::parameters,
    )
    .noted("S_m, K_m and K: parabolas through the tests, drawn where they are used."),
    spec(
        VALIDATION,
        Cases::Ag,
        ["fig13-history", "Fig. 13a, b", "Outer-ring acceleration and orbital speed from the quasi-static start"],
        over_time::start,
    ),
    spec(
        VALIDATION,
        Cases::Ag,
        ["fig13-spectrum", "Fig. 13c", "Spectrum of the outer ring's acceleration"],
        over_time::spectrum,
    ),
    spec(
        VALIDATION,
        Cases::Defect,
        ["fig13-defect", "Beside Fig. 13c", "Envelope spectrum with a defect of the outer race"],
        over_time::defect,
    )
    .noted(
        "The published frequency is that of a defect seen after the test. Band of the envelope: 3 to 10 kHz; lines \
         below 50 Hz are left out.",
    ),
    case("table4-speed", "Table 4", "Orbital speed of the balls", steady::speeds),
    case("fig14-angles", "Fig. 14a", "Contact angles", |s, m| steady::plain("contact-angles", s, m)),
    case("fig14-loads", "Fig. 14b", "Contact loads", steady::loads),
    case("fig14-pressures", "Fig. 14c", "Peak contact pressures", |s, m| steady::plain("peak-pressures", s, m)),
    case("fig14-approaches", "Fig. 14, contact deformation", "Elastic approaches", |s, m| {
        steady::plain("elastic-approaches", s, m)
    }),
    case("fig16-traction", "Fig. 16", "Longitudinal traction on the balls", |s, m| {
        steady::with_zone("longitudinal-traction", s, m)
    }),
    case("fig17-slip", "Fig. 17", "Longitudinal slide-to-roll ratios", |s, m| steady::with_zone("slide-to-roll", s, m)),
    case("fig18-wear", "Fig. 18", "Wear rates", |s, m| steady::with_zone("wear-rates", s, m)),
    case("fig18-pocket", "Behind Fig. 18b", "Pocket force on the balls", |s, m| steady::with_zone("cage-force", s, m)),
    coating(
        "fig19-history",
        "Fig. 19a, b",
        "Outer-ring acceleration, and orbital speed in the last orbits",
        over_time::coatings,
    ),
    coating("fig19-orbit", "Fig. 19b over the azimuth", "Orbital speed of the balls", over_time::impacts),
    coating("fig19-spectra", "Fig. 19c, d", "Spectra of the outer ring's acceleration", over_time::spectra),
    coating("fig20-angles", "Fig. 20a", "Contact angles by coating", |s, m| loads::by_coating(&loads::ANGLES, s, m)),
    coating("fig20-loads", "Fig. 20b", "Contact loads by coating", loads::loads_by_coating),
    coating("fig20-slip", "Fig. 20c", "Slide-to-roll ratios by coating", |s, m| loads::by_coating(&loads::SLIPS, s, m)),
    coating("fig20-spin", "Fig. 20d", "Spin ratios by coating", |s, m| loads::by_coating(&loads::SPINS, s, m)),
    coating("fig21-race", "Fig. 21a", "Wear of both races by a ball", loads::race_wear_by_coating)
        .noted("Each coating on a scale of its own."),
    coating("fig21-cage", "Fig. 21b", "Wear of a pocket, its force and the traction", |s, m| {
        loads::by_coating(&loads::POCKET, s, m)
    }),
    load("fig22-vibration", "Fig. 22a", "Vibration of the inner ring by axial load", loads::vibration),
    load("fig22-orbit", "Fig. 22b", "Orbital speed of the balls by axial load", loads::speeds_by_load),
    load("fig23-angles", "Fig. 23a", "Contact angles by axial load", |s, m| loads::by_load(&loads::ANGLES, s, m)),
    load("fig23-loads", "Fig. 23b", "Contact loads by axial load", |s, m| loads::by_load(&loads::LOADS, s, m)),
    load("fig23-slip", "Fig. 23c", "Slide-to-roll ratios by axial load", |s, m| loads::by_load(&loads::SLIPS, s, m)),
    load("fig23-pocket", "Fig. 23d", "Force of the pocket on a ball by axial load", |s, m| {
        loads::by_load(&loads::FORCES, s, m)
    }),
    load("fig24-race", "Fig. 24a", "Wear of both races by axial load", |s, m| loads::by_load(&loads::RACE_WEAR, s, m)),
    load("fig24-cage", "Fig. 24b", "Wear of a pocket by axial load", |s, m| loads::by_load(&loads::CAGE_WEAR, s, m)),
];

const fn case(name: &'static str, of: &'static str, title: &'static str, draw: Draw) -> Spec {
    spec(STEADY, Cases::Steady, [name, of, title], draw)
}

const fn coating(name: &'static str, of: &'static str, title: &'static str, draw: Draw) -> Spec {
    spec(COATING, Cases::Coatings, [name, of, title], draw)
}

const fn load(name: &'static str, of: &'static str, title: &'static str, draw: Draw) -> Spec {
    spec(PRELOAD, Cases::Loads, [name, of, title], draw)
}
