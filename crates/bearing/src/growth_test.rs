//! Growth of rings against closed forms and against the geometry of the drawing.

use super::*;
use crate::cylinder::Solid;
use tribodyn_contact::ElasticBody;

const STEEL: Solid = Solid { elastic: ElasticBody { young: 208e9, poisson: 0.3 }, density: 7800.0, expansion: 11.5e-6 };

/// The deep-groove bearing 6206 with 13 µm of clearance.
fn drawn() -> Geometry {
    Geometry::new(Dimensions {
        ball_count: 9,
        ball_diameter: 9.525e-3,
        pitch_diameter: 46e-3,
        inner_coefficient: 0.52,
        outer_coefficient: 0.53,
        fit: Fit::RadialClearance(13e-6),
    })
    .unwrap()
}

fn cylinder(inner_radius: f64, outer_radius: f64) -> Cylinder {
    Cylinder { solid: STEEL, inner_radius, outer_radius, speed: 0.0, temperature_rise: 0.0 }
}

fn unmounted() -> Growth {
    let g = drawn();
    Growth {
        rings: Races {
            inner: MountedRing { ring: cylinder(15e-3, g.groove_bottom_radius(Side::Inner)), seat: None },
            outer: MountedRing { ring: cylinder(g.groove_bottom_radius(Side::Outer), 31e-3), seat: None },
        },
        ball_strain: 0.0,
    }
}

fn clearance(growth: &Growth) -> f64 {
    growth.apply(&drawn()).unwrap().geometry.radial_clearance()
}

#[track_caller]
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} is not {expected} to {tolerance:e}");
}

#[test]
fn limit_without_fit_speed_and_heat_nothing_changes() {
    let grown = unmounted().apply(&drawn()).unwrap();
    assert_close(grown.geometry.radial_clearance(), 13e-6, 1e-9);
    assert_close(grown.geometry.pitch_diameter, 46e-3, 1e-12);
    assert_close(grown.geometry.contact_angle(), drawn().contact_angle(), 1e-9);
    assert_eq!(grown.seat_pressure, Races { inner: None, outer: None });
}

/// Harris: a ring on a solid shaft of its own material grows by I d/d_race at the race, under p = E I/(2 d) (1 −
/// d²/d_race²).
#[test]
fn identity_an_interference_fit_on_a_solid_shaft_in_closed_form() {
    let mut growth = unmounted();
    growth.rings.inner.seat = Some(Seat { interference: 10e-6, partner: cylinder(0.0, 15e-3) });
    let race = growth.rings.inner.ring.outer_radius;
    let grown = growth.apply(&drawn()).unwrap();
    assert_close(grown.raceway_growth.inner, 5e-6 * 15e-3 / race, 1e-12);
    let pressure = 208e9 * 10e-6 / (2.0 * 30e-3) * (1.0 - (15e-3 / race).powi(2));
    assert_close(grown.seat_pressure.inner.unwrap(), pressure, 1e-12);
    assert_close(grown.geometry.radial_clearance(), 13e-6 - 10e-6 * 15e-3 / race, 1e-9);
    assert!(grown.geometry.contact_angle() < drawn().contact_angle());
    assert!(grown.geometry.pitch_diameter > 46e-3);
}

/// A tight housing closes the clearance, by less the thinner its wall is; a loose one leaves the ring alone.
#[test]
fn limit_housings_press_and_loose_rings_are_free() {
    let with = |interference, outside| {
        let mut growth = unmounted();
        growth.rings.outer.seat = Some(Seat { interference, partner: cylinder(31e-3, outside) });
        growth
    };
    let (thick, thin) = (clearance(&with(10e-6, 60e-3)), clearance(&with(10e-6, 33e-3)));
    assert!(thick < thin && thin < 13e-6, "{thick} {thin}");
    let loose = with(-5e-6, 60e-3).apply(&drawn()).unwrap();
    assert_eq!(loose.seat_pressure.outer, Some(0.0));
    assert_close(loose.geometry.radial_clearance(), 13e-6, 1e-9);
}

/// One temperature for all parts scales the bearing: clearance and pitch diameter grow alike, the angle stays.
#[test]
fn identity_uniform_heat_scales_the_bearing() {
    let mut growth = unmounted();
    growth.rings = growth.rings.map(|m| MountedRing { ring: Cylinder { temperature_rise: 100.0, ..m.ring }, ..m });
    growth.ball_strain = 100.0 * STEEL.expansion;
    let grown = growth.apply(&drawn()).unwrap().geometry;
    let scale = 1.0 + 100.0 * STEEL.expansion;
    assert_close(grown.radial_clearance(), 13e-6 * scale, 1e-9);
    assert_close(grown.pitch_diameter, 46e-3 * scale, 1e-12);
    assert_close(grown.contact_angle(), drawn().contact_angle(), 1e-9);
}

/// A warm inner ring takes clearance away, 2 α_th ΔT of its race radius; speed too; until the balls are pressed.
#[test]
fn limit_a_warm_fast_inner_ring_ends_in_preload() {
    let heated = |temperature_rise: f64, speed: f64| {
        let mut growth = unmounted();
        let ring = growth.rings.inner.ring;
        growth.rings.inner.ring = Cylinder { temperature_rise, speed, ..ring };
        growth
    };
    let race = unmounted().rings.inner.ring.outer_radius;
    // The groove's own radius grows too and does not change the bottom of the race.
    assert_close(clearance(&heated(10.0, 0.0)), 13e-6 - 2.0 * 10.0 * 11.5e-6 * race, 1e-9);
    assert!(clearance(&heated(0.0, 3000.0)) < 13e-6);
    let hot = heated(60.0, 0.0);
    let pressed = hot.apply(&drawn()).unwrap().geometry;
    assert_close(pressed.radial_clearance(), 13e-6 - 2.0 * 60.0 * 11.5e-6 * race, 1e-9);
    assert!(pressed.radial_clearance() < 0.0 && pressed.contact_angle() == 0.0);
    let radial = pressed.groove_centre_radius(Side::Inner) - pressed.groove_centre_radius(Side::Outer);
    assert_close(radial - pressed.centre_distance(), -0.5 * pressed.radial_clearance(), 1e-6);
    assert_eq!(clearance(&hot.mounted()), clearance(&unmounted()));
    assert!(matches!(heated(2000.0, 0.0).apply(&drawn()), Err(BearingError::Clearance { .. })));
}
