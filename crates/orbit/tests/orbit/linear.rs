//! Stiffness and modes against differences of solutions and closed forms.

use crate::support::fixture;
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint, Races, RingFreedom, Support, Supports, TiltingRing};
use tribodyn_orbit::{
    Bodies, OrbitSettings, orbit_modes, orbit_slopes, orbit_stiffness, steady_orbit, steady_orbit_from,
};
use tribodyn_quasistatic::{Model, PatchRule, jones_harris_stiffness, solve, solve_from, traction_stiffness};

const MICROMETRE: f64 = 1e-6;
/// Displacement (m) and tilt (rad) of differences of fourth order: small against approaches of 20 µm, large against
/// rounding.
const STEPS: [f64; 5] = [1e-7, 1e-7, 1e-7, 1e-6, 1e-6];

/// The paper's bearing with a rule of fixed nodes: the derivative of its sum is then just that of its integral, which
/// strips that move with the slip meet to their own error only.
fn paper() -> (Bearing, OperatingPoint, CageBody) {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    point.patch = Some(PatchRule::GaussJacobi { radial: 6, angles: 12 }.into());
    (bearing, point, cage)
}

fn held(point: &OperatingPoint, ring: [f64; 5]) -> OperatingPoint {
    OperatingPoint { ring: ring.map(RingFreedom::Held), ..point.clone() }
}

/// Forces and moments over displacements and tilts against central differences: largest deviation over √(K_ii K_jj).
fn deviation(k: &[[f64; 5]; 5], at: [f64; 5], mut force: impl FnMut([f64; 5]) -> [f64; 5]) -> f64 {
    let mut worst = 0f64;
    for column in 0..5 {
        let mut moved = |sign: f64| {
            let mut ring = at;
            ring[column] += sign * STEPS[column];
            force(ring)
        };
        let [far_down, down, up, far_up] = [-2.0, -1.0, 1.0, 2.0].map(&mut moved);
        for row in 0..5 {
            let (near, far) = (up[row] - down[row], far_up[row] - far_down[row]);
            let difference = (8.0 * near - far) / (12.0 * STEPS[column]);
            worst = worst.max((difference - k[row][column]).abs() / (k[row][row] * k[column][column]).abs().sqrt());
        }
    }
    worst
}

#[test]
fn identity_quasi_static_stiffness_is_that_of_differences() {
    let (bearing, point, _) = paper();
    let solved = solve(&bearing, &point, Model::Traction).unwrap();
    let start = solved.warm_start.unwrap();
    let k = traction_stiffness(&bearing, &point, &start).unwrap();
    let worst = deviation(&k, start.ring(), |ring| {
        let s = solve_from(&bearing, &held(&point, ring), &start).unwrap().solution;
        let ([x, y, z], [mx, my]) = (s.ring_load_n, s.ring_moment_nm);
        [x, y, z, mx, my]
    });
    assert!(worst < 1e-6, "{worst:e}");
}

#[test]
fn identity_jones_harris_stiffness_is_that_of_differences() {
    let (bearing, point, _) = paper();
    let s = solve(&bearing, &point, Model::JonesHarris).unwrap().solution;
    let ([x, y, z], [tx, ty]) = (s.ring_displacement_m, s.ring_tilt_rad);
    let k = jones_harris_stiffness(&bearing, &point).unwrap();
    let worst = deviation(&k, [x, y, z, tx, ty], |ring| {
        let s = solve(&bearing, &held(&point, ring), Model::JonesHarris).unwrap().solution;
        let ([x, y, z], [mx, my]) = (s.ring_load_n, s.ring_moment_nm);
        [x, y, z, mx, my]
    });
    assert!(worst < 1e-6, "{worst:e}");
}

#[test]
fn identity_stiffness_of_the_orbit_is_that_of_differences() {
    let (bearing, point, mut cage) = paper();
    // No ball touches its pocket: where one just does, differences straddle the kink of its force.
    cage.pocket.clearance *= 10.0;
    let settings = OrbitSettings::default();
    let solved = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    let start = solved.start.unwrap();
    let k = orbit_slopes(&bearing, &point, &cage, &settings, &start).unwrap();
    let ([x, y, z], [tx, ty]) = (solved.solution.ring_displacement_m, solved.solution.ring_tilt_rad);
    let mut force = |ring| {
        let held = held(&point, ring);
        let s = steady_orbit_from(&bearing, &held, &cage, &settings, &start).unwrap().solution;
        let ([x, y, z], [mx, my]) = (s.ring_load_n, s.ring_moment_nm);
        [x, y, z, mx, my]
    };
    let at = [x, y, z, tx, ty];
    // On the mesh of the orbit both are the same; what the mesh leaves undecided, the finer one tells.
    let worst = deviation(&k, at, &mut force);
    assert!(worst < 1e-6, "{worst:e}");
    let checked = orbit_stiffness(&bearing, &point, &cage, &settings, &start).unwrap();
    let worst = deviation(&checked.stiffness, at, &mut force);
    assert!(worst < 2.0 * checked.error_estimate && checked.error_estimate < 1e-3, "{worst:e} {checked:?}");
    assert!(checked.warnings.is_empty(), "{:?}", checked.warnings);
}

/// A ring at rest under thrust, contact angles frozen by symmetry: each ball is two Hertz springs in a row at the
/// contact angle, and K_zz follows from Q = K_n δ^1.5 and the turning of the line of action.
#[test]
fn limit_axial_stiffness_at_rest_is_that_of_hertz_springs() {
    let (mut bearing, mut point, _) = paper();
    (point.inner_speed, point.outer_speed) = (0.0, 0.0);
    point.ring[0] = RingFreedom::Loaded(0.0);
    bearing.contact_damping = 0.0;
    let s = solve(&bearing, &point, Model::JonesHarris).unwrap().solution;
    let k = jones_harris_stiffness(&bearing, &point).unwrap();
    let ball = &s.balls[0];
    let (load, angle) = (ball.contacts.inner.load_n, ball.contacts.inner.angle_rad);
    let spring = |approach: f64| 1.5 * load / approach;
    let (inner, outer) = (spring(ball.contacts.inner.approach_m), spring(ball.contacts.outer.approach_m));
    let in_row = 1.0 / (1.0 / inner + 1.0 / outer);
    // The groove centres stand this far apart under load.
    let apart = bearing.geometry.centre_distance() + ball.contacts.inner.approach_m + ball.contacts.outer.approach_m;
    let one = in_row * angle.sin().powi(2) + load / apart * angle.cos().powi(2);
    let expected = one * s.balls.len() as f64;
    assert!((k[2][2] / expected - 1.0).abs() < 1e-9, "{} {expected}", k[2][2]);
}

/// Balls that the inner ring does not touch leave it to its supports: λ = −c/2M ± i √(K/M − (c/2M)²). An inner ring
/// that tilts and turns on a spring that is alike about both axes precesses, I_t λ² ∓ i I_p Ω λ + k = 0.
#[test]
fn limit_free_ring_swings_on_its_supports() {
    let (bearing, mut point, cage) = paper();
    point.ring = [0.0, 0.0, -200.0 * MICROMETRE, 0.0, 0.0].map(RingFreedom::Held);
    // The outer ring carries balls and cage along.
    point.outer_speed = 0.5 * point.inner_speed;
    let free = OperatingPoint { ring: [RingFreedom::Loaded(0.0); 5], ..point.clone() };
    // How fast such balls roll hardly matters here.
    let settings = OrbitSettings { tolerance: 1e-4, ..OrbitSettings::default() };
    let solved = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    assert!(solved.solution.points.iter().all(|p| p.contacts.inner.load_n == 0.0));
    let (mass, stiffness, damping) = (3.0, [4e7, 5e7, 9e7], [200.0, 300.0, 400.0]);
    let (polar_inertia, transverse_inertia, seat) = (0.05, 0.03, 4e5);
    let of_inner =
        TiltingRing { polar_inertia, transverse_inertia, stiffness: [seat; 2], damping: [0.0; 2], askew: [0.0; 2] };
    let of_outer = TiltingRing { stiffness: [9e5; 2], ..of_inner };
    let bodies = Bodies {
        cage,
        contact_damping: 0.02,
        supports: Supports {
            inner: Support { mass, stiffness, damping },
            outer: Support { mass: 5.0, stiffness: [5e8; 2], damping: [5e3; 2] },
        },
        tilting: Races { inner: Some(of_inner), outer: Some(of_outer) },
    };
    let modes = orbit_modes(&bearing, &free, &bodies, &settings, &solved.start.unwrap()).unwrap().modes;
    for k in 0..3 {
        let decay: f64 = damping[k] / (2.0 * mass);
        let frequency = (stiffness[k] / mass - decay * decay).sqrt() / std::f64::consts::TAU;
        let near = |m: &&tribodyn_orbit::Mode| (m.frequency_hz / frequency - 1.0).abs() < 1e-10;
        let mode = modes.iter().find(near).unwrap_or_else(|| panic!("no mode at {frequency} Hz"));
        assert!((mode.growth_rate_per_s / -decay - 1.0).abs() < 1e-8, "{mode:?}");
        assert!(mode.energy_shares.inner_ring > 0.999 && mode.inner_ring[k] > 0.999);
    }
    let half = 0.5 * polar_inertia * point.inner_speed / transverse_inertia;
    let middle = (half * half + seat / transverse_inertia).sqrt();
    for rate in [middle - half, middle + half] {
        let frequency = rate / std::f64::consts::TAU;
        let near = |m: &&tribodyn_orbit::Mode| (m.frequency_hz / frequency - 1.0).abs() < 1e-8;
        let mode = modes.iter().find(near).unwrap_or_else(|| panic!("no mode at {frequency} Hz"));
        let [x, y] = mode.inner_tilt.unwrap();
        assert!(mode.energy_shares.inner_ring > 0.999 && (x - y).abs() < 1e-6 && x > 0.999, "{mode:?}");
    }
}

/// A ring that is held but for its tilts swings about x and y at √(K/I_t), I_t far above what the balls have: on both
/// rings' own springs in a row, where the outer ring tilts too.
#[test]
fn limit_a_ring_tilts_on_its_balls_as_a_body_on_a_spring() {
    let (supports, bearing, point, cage) = fixture("angular-7210");
    let settings = OrbitSettings::default();
    let mut point = OperatingPoint { inner_speed: 10.0, ..point.clone() };
    point.ring = [RingFreedom::Held(0.0); 5];
    point.ring[2] = RingFreedom::Loaded(3000.0);
    let held = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    point.ring[2] = RingFreedom::Held(held.solution.ring_displacement_m[2]);
    point.ring[3..].fill(RingFreedom::Loaded(0.0));
    let start = steady_orbit(&bearing, &point, &cage, &settings).unwrap().start.unwrap();
    let k = orbit_stiffness(&bearing, &point, &cage, &settings, &start).unwrap().stiffness[3][3];
    // An outer ring that gives way across would take part.
    let outer = Support { mass: 1e3, stiffness: [1e12; 2], damping: [0.0; 2] };
    let supports = Supports { outer, ..supports };
    let body = |inertia: f64, stiffness: f64| TiltingRing {
        polar_inertia: 1e-9,
        transverse_inertia: inertia,
        stiffness: [stiffness; 2],
        damping: [0.0; 2],
        askew: [0.0; 2],
    };
    // An outer ring with next to no inertia on a spring like the balls halves the stiffness.
    for (outer, stiffness) in [(None, k), (Some(body(1e-4, k)), 0.5 * k)] {
        let tilting = Races { inner: Some(body(1.0, 0.0)), outer };
        let bodies = Bodies { cage, contact_damping: 0.02, supports, tilting };
        let modes = orbit_modes(&bearing, &point, &bodies, &settings, &start).unwrap().modes;
        let frequency = stiffness.sqrt() / std::f64::consts::TAU;
        let of_tilt = |m: &&tribodyn_orbit::Mode| m.energy_shares.inner_ring > 0.9;
        let found: Vec<f64> = modes.iter().filter(of_tilt).map(|mode| mode.frequency_hz).collect();
        assert!(found.len() == 2, "{found:?} {frequency}");
        assert!(found.iter().all(|hz| (hz / frequency - 1.0).abs() < 0.01), "{found:?} {frequency}");
    }
}

/// A ring on its balls under thrust alone swings along the axis at √(k/M), at a crawl as at 3000 r/min: balls are as
/// heavy as they are. A quarter of their mass goes along, as each is between two contacts. At 14 000 r/min, where
/// centrifugal forces unload the inner contacts, balls swing on their own and damp it.
#[test]
fn limit_a_ring_swings_on_its_balls_as_a_mass_on_a_spring() {
    let (supports, bearing, point, cage) = fixture("angular-7210");
    let settings = OrbitSettings::default();
    let supports =
        Supports { inner: Support { stiffness: [0.0; 3], damping: [0.0; 3], ..supports.inner }, outer: supports.outer };
    for rpm in [1.0, 10.0, 100.0, 3000.0] {
        let mut point = OperatingPoint { inner_speed: rpm * std::f64::consts::PI / 30.0, ..point.clone() };
        point.ring = [RingFreedom::Loaded(0.0); 5];
        point.ring[2] = RingFreedom::Loaded(3000.0);
        for tilt in &mut point.ring[3..] {
            *tilt = RingFreedom::Held(0.0);
        }
        let start = steady_orbit(&bearing, &point, &cage, &settings).unwrap().start.unwrap();
        let k = orbit_stiffness(&bearing, &point, &cage, &settings, &start).unwrap().stiffness[2][2];
        let mass = supports.inner.mass + 0.25 * bearing.geometry.ball_count as f64 * bearing.ball_mass;
        let frequency = (k / mass).sqrt() / std::f64::consts::TAU;
        let bodies = Bodies { cage, contact_damping: 0.02, supports, tilting: Races::default() };
        let modes = orbit_modes(&bearing, &point, &bodies, &settings, &start).unwrap().modes;
        let axial = |m: &tribodyn_orbit::Mode| m.inner_ring[2] * m.energy_shares.inner_ring;
        let mode = modes.iter().max_by(|a, b| axial(a).total_cmp(&axial(b))).unwrap();
        assert!((mode.frequency_hz / frequency - 1.0).abs() < 0.01, "{rpm} r/min: {frequency} {mode:?}");
    }
}
