//! A state that is in equilibrium stays where it is.

use crate::{case, run};

/// Axial load only, nothing that could push a ball along its orbit but traction.
const QUIET: [(&str, &str); 9] = [
    ("ring.x", "Force(N(0))"),
    ("fluid.drag_coefficient", "0"),
    ("fluid.churning", "false"),
    ("cage.pocket_stiffness", "N_per_um(0)"),
    ("transient.contact_damping", "0"),
    ("numerics.tolerance", "1e-13"),
    ("recording.state_rate", "Hz(250)"),
    ("recording.ball_rate", "Hz(250)"),
    ("traction.patch", "GaussJacobi(radial: 2, angles: 8)"),
];

fn stays(scheme: &str, changes: &[(&str, &str)], tolerance: f64) {
    let all = [&QUIET[..], changes, &[("transient.scheme", scheme), ("transient.duration", "s(0.108)")]].concat();
    let (_, keep) = run(&case(&all));
    let (first, last) = (&keep.samples[0], keep.samples.last().unwrap());
    assert!(last.balls[0].azimuth_rad - first.balls[0].azimuth_rad > 10.0 * std::f64::consts::TAU);
    for (a, b) in first.balls.iter().zip(&last.balls) {
        let pairs = [
            ("orbital speed", a.orbital_speed_rad_s, b.orbital_speed_rad_s, a.orbital_speed_rad_s),
            ("spin", a.spin_rad_s[0], b.spin_rad_s[0], a.spin_rad_s[0]),
            ("radial spin", a.spin_rad_s[1], b.spin_rad_s[1], a.spin_rad_s[0]),
            ("inner load", a.inner.load_n, b.inner.load_n, a.inner.load_n),
            ("outer load", a.outer.load_n, b.outer.load_n, a.outer.load_n),
            ("inner angle", a.inner.angle_rad, b.inner.angle_rad, a.inner.angle_rad),
        ];
        for (what, a, b, scale) in pairs {
            assert!((a - b).abs() <= tolerance * scale.abs(), "{scheme}, {what}: {a:.15e} became {b:.15e}");
        }
    }
}

/// Slip in m/s, which no steep curve stiffens, so that a long step serves.
const GENTLE: (&str, &str) = ("traction.slip_unit", "MeterPerSecond");

#[test]
fn limit_axial_load_keeps_every_ball_on_its_quasistatic_state_for_ten_orbits() {
    stays("RungeKutta4(step: us(10))", &[GENTLE], 1e-10);
}

/// To the error of its splitting: within a step friction and springs push the rings in turn.
#[test]
fn limit_the_fast_scheme_keeps_an_equilibrium_too() {
    stays("Fast(step: us(20))", &[GENTLE], 1e-4);
}
