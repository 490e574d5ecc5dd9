//! Characteristic frequencies against published ones.

use std::f64::consts::TAU;

use tribodyn_signal::{BearingFrequencies, SignalError};

use crate::assert_near;

/// Case Western Reserve University, Bearing Data Center: SKF 6205-2RS JEM, 9 balls of 0.3126 in on a pitch circle of
/// 1.537 in, in multiples of the shaft frequency: inner 5.4152, outer 3.5848, cage 0.39828, rolling element 4.7135.
#[test]
fn paper_deep_groove_6205() {
    let inch = 0.0254;
    let f = BearingFrequencies::from_geometry(9, 0.3126 * inch, 1.537 * inch, 0.0, TAU, 0.0).unwrap();
    assert_near(f.shaft_hz, 1.0, 1e-12);
    assert_near(f.ball_pass_inner_hz, 5.4152, 5e-5);
    assert_near(f.ball_pass_outer_hz, 3.5848, 5e-5);
    assert_near(f.cage_hz, 0.39828, 4e-5);
    assert_near(f.ball_defect_hz, 4.7135, 1e-4);
}

#[test]
fn identity_only_relative_speed_matters_to_the_rings() {
    let of = |inner, outer| BearingFrequencies::from_geometry(13, 0.03016, 0.1675, 0.31, inner, outer).unwrap();
    let (still, turned) = (of(1400.0, 0.0), of(1700.0, 300.0));
    assert_near(still.ball_pass_inner_hz, turned.ball_pass_inner_hz, 1e-9);
    assert_near(still.ball_pass_outer_hz, turned.ball_pass_outer_hz, 1e-9);
    assert_near(still.ball_spin_hz, turned.ball_spin_hz, 1e-9);
    assert_near(turned.cage_hz - still.cage_hz, 300.0 / TAU, 1e-9);
    // Balls pass the inner and the outer race together as often as the shaft turns, times the balls.
    assert_near(still.ball_pass_inner_hz + still.ball_pass_outer_hz, 13.0 * still.shaft_hz, 1e-9);
}

#[test]
fn identity_frequencies_of_a_run_are_those_of_its_speeds() {
    let f = BearingFrequencies::from_run(607.4, -4050.0, 1466.1, 0.0, 13).unwrap();
    assert_near(f.cage_hz, 96.67, 0.01);
    assert_near(f.ball_pass_outer_hz, 13.0 * f.cage_hz, 1e-9);
    assert_near(f.ball_pass_inner_hz, 13.0 * (f.shaft_hz - f.cage_hz), 1e-9);
    assert_near(f.ball_defect_hz, 4050.0 / std::f64::consts::PI, 1e-9);
}

#[test]
fn limit_impossible_bearings_are_refused() {
    for (count, ball, pitch, angle) in [(0, 1.0, 5.0, 0.0), (9, 5.0, 5.0, 0.0), (9, -1.0, 5.0, 0.0), (9, 1.0, 5.0, 1.6)]
    {
        let refused = BearingFrequencies::from_geometry(count, ball, pitch, angle, 1.0, 0.0).unwrap_err();
        assert!(matches!(refused, SignalError::Geometry { .. }), "{refused}");
    }
    let refused = BearingFrequencies::from_geometry(9, 1.0, 5.0, 0.1, f64::NAN, 0.0).unwrap_err();
    assert!(matches!(refused, SignalError::Setting { .. }), "{refused}");
}
