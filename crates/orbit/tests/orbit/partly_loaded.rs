//! Bearings whose balls lose contacts, meet their pockets, or are driven from either ring: the set that is held against
//! runs by `examples/against_run`.

#[path = "../../examples/against_run/bearings.rs"]
mod bearings;

use bearings::bearings;
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint, RingFreedom};
use tribodyn_case::{Case, set_value};
use tribodyn_orbit::{OrbitSettings, SteadyOrbit, steady_orbit};

fn problem(text: &str) -> (Bearing, OperatingPoint, CageBody) {
    let case = Case::from_ron(text).unwrap();
    let inputs = case.run_inputs().unwrap();
    let cage = CageBody::new(&inputs.cage, &inputs.bearing);
    let bearing = Bearing { contact_damping: inputs.options.contact_damping, ..inputs.bearing };
    (bearing, case.operating_point(), cage)
}

/// Checks that an orbit does nothing that no bearing does, whatever its loads.
fn check(name: &str, orbit: &SteadyOrbit, point: &OperatingPoint) {
    assert!(orbit.residual <= 1e-10, "{name}: {:e}", orbit.residual);
    assert_eq!(orbit.swing_damping, None, "{name}");
    let rpm = |speed: f64| speed * 30.0 / std::f64::consts::PI;
    let (a, b) = (rpm(point.inner_speed), rpm(point.outer_speed));
    let speed = orbit.cage_speed_rpm;
    assert!(a.min(b) < speed && speed < a.max(b), "{name}: {speed} r/min");
    for (k, freedom) in point.ring.iter().take(3).enumerate() {
        if let RingFreedom::Loaded(load) = freedom {
            assert!((orbit.ring_load_n[k] - load).abs() < 1e-6 * load.abs() + 1e-3, "{name}: {:?}", orbit.ring_load_n);
        }
    }
    let [x, y, z] = orbit.ring_load_n;
    let load = x.hypot(y).hypot(z);
    assert!(orbit.pocket_force_max_n < load, "{name}: {} N", orbit.pocket_force_max_n);
    let peak = orbit.points.iter().map(|p| p.contacts.inner.load_n).fold(0.0, f64::max);
    for p in &orbit.points {
        // A ball that hardly touches any more may stand on the edge of its groove.
        let angle = p.contacts.inner.angle_rad.to_degrees();
        let fits = p.contacts.inner.load_n < 0.1 * peak || (-1.0..75.0).contains(&angle);
        assert!(fits, "{name}: {angle}° at {}", p.azimuth_rad.to_degrees());
        assert!(p.contacts.inner.load_n < 2.0 * load, "{name}: {} N", p.contacts.inner.load_n);
    }
    let lost = orbit.friction_w[0] + orbit.friction_w[1] + orbit.fluid_w + orbit.pocket_w;
    assert!(lost > 0.0, "{name}: {lost} W");
}

#[test]
fn limit_every_bearing_of_the_set_has_an_orbit_that_a_bearing_can_have() {
    for bearing in bearings() {
        let (b, point, cage) = problem(&bearing.text().unwrap());
        let solved = steady_orbit(&b, &point, &cage, &OrbitSettings::default());
        let orbit = solved.unwrap_or_else(|why| panic!("{}: {why}", bearing.name)).solution;
        check(bearing.name, &orbit, &point);
        // As it is: no heavier balls, no softer pockets.
        let regularized = (orbit.ball_mass_factor, orbit.pocket_stiffness_share);
        assert_eq!(regularized, (None, None), "{}", bearing.name);
    }
}

/// Held along its axis, a deep groove at 1000 r/min: balls leave and meet both races, and no turn closes at once.
#[test]
fn limit_a_slow_deep_groove_that_is_held_along_its_axis_has_an_orbit() {
    let bearing = bearings().into_iter().find(|b| b.name.starts_with("6206, 2 kN radial")).unwrap();
    let mut text = bearing.text().unwrap();
    for (path, value) in [("ring.z", "Held(um(0))"), ("speed.inner", "Constant(rpm(1000))")] {
        text = set_value(&text, path, value).unwrap();
    }
    let (b, point, cage) = problem(&text);
    let orbit = steady_orbit(&b, &point, &cage, &OrbitSettings::default()).unwrap().solution;
    assert!(orbit.residual <= 1e-10 && (orbit.ring_load_n[0] - 2000.0).abs() < 1e-3, "{:?}", orbit.ring_load_n);
    // Rolling at contact angles from 0 to 20°, the balls' swing damped no more than by the least that there is.
    assert!((396.0..403.0).contains(&orbit.cage_speed_rpm), "{}", orbit.cage_speed_rpm);
    assert!(orbit.swing_damping.is_none_or(|rate| rate < 4.0), "{:?}", orbit.swing_damping);
}

/// A mesh ten times as accurate moves nothing that matters.
#[test]
fn identity_a_finer_mesh_gives_the_same_orbit_where_balls_lose_contacts() {
    for name in ["7210, 3 kN axial, 4 kN radial, 6000 r/min", "6206, 2 kN radial, clearance 13 µm, 6000 r/min"] {
        let bearing = bearings().into_iter().find(|b| b.name == name).unwrap();
        let (b, point, cage) = problem(&bearing.text().unwrap());
        let settings = OrbitSettings::default();
        let of =
            |mesh_error| steady_orbit(&b, &point, &cage, &OrbitSettings { mesh_error, ..settings }).unwrap().solution;
        let (coarse, fine) = (of(settings.mesh_error), of(0.1 * settings.mesh_error));
        assert!(fine.intervals > coarse.intervals);
        let values = |s: &SteadyOrbit| [s.cage_speed_rpm, s.shaft_torque_nm, s.pocket_force_max_n];
        for ((coarse, fine), limit) in values(&coarse).into_iter().zip(values(&fine)).zip([1e-5, 5e-4, 2e-2]) {
            assert!((coarse - fine).abs() <= limit * fine.abs(), "{name}: {coarse}, {fine}, allowed {limit:e}");
        }
    }
}

/// Solver statistics of the paper's bearing: a wrong Jacobian converges too, only slower.
#[test]
fn regress_few_turns_and_jacobians_lead_to_the_paper_s_orbit() {
    let (b, point, cage) = problem(&bearings()[0].text().unwrap());
    let s = steady_orbit(&b, &point, &cage, &OrbitSettings::default()).unwrap().statistics;
    assert!(s.turns <= 10 && s.intervals <= 300 && s.jacobians <= 10 && s.residuals <= 30, "{s:?}");
}
