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
            ("angular velocity", a.angular_velocity_rad_s[0], b.angular_velocity_rad_s[0], a.angular_velocity_rad_s[0]),
            (
                "radial angular velocity",
                a.angular_velocity_rad_s[1],
                b.angular_velocity_rad_s[1],
                a.angular_velocity_rad_s[0],
            ),
            ("inner load", a.contacts.inner.load_n, b.contacts.inner.load_n, a.contacts.inner.load_n),
            ("outer load", a.contacts.outer.load_n, b.contacts.outer.load_n, a.contacts.outer.load_n),
            ("inner angle", a.contacts.inner.angle_rad, b.contacts.inner.angle_rad, a.contacts.inner.angle_rad),
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

/// A shaft that starts from a standstill takes the balls along, and the power that goes in comes out.
#[test]
fn limit_a_run_up_from_rest_ends_near_the_quasistatic_cage_speed() {
    let changes = [
        ("ring.x", "Force(N(0))"),
        ("fluid.drag_coefficient", "0"),
        ("fluid.churning", "false"),
        ("speed.inner", "Table([(s(0), rpm(0)), (s(0.03), rpm(3000))])"),
        ("transient.start", "Rest"),
        ("transient.duration", "s(0.04)"),
        ("transient.scheme", "RungeKutta4(step: us(10))"),
        ("traction.slip_unit", "MeterPerSecond"),
        ("traction.patch", "GaussJacobi(radial: 2, angles: 8)"),
    ];
    let (_, keep) = run(&case(&changes));
    let (first, last) = (&keep.samples[0], keep.samples.last().unwrap());
    assert!(first.balls.iter().all(|b| b.orbital_speed_rad_s.abs() < 1e-9) && first.inner.speed_rad_s == 0.0);
    let mean = last.balls.iter().map(|b| b.orbital_speed_rad_s).sum::<f64>() / 13.0;
    // Rolling at a contact angle of some 25°, (1 − D cos α/d_m)/2 of the shaft's speed.
    let rolling = 0.41 * last.inner.speed_rad_s;
    assert!((mean / rolling - 1.0).abs() < 0.05, "{mean} {rolling}");
    let power = last.power;
    assert!((power.imbalance_j / power.throughput_j).abs() < 1e-6, "{:e}", power.imbalance_j / power.throughput_j);
}
