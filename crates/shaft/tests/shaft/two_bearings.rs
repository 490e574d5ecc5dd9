//! Two bearings 7210 on a shaft, at rest.

use tribodyn_bearing::{Bearing, BearingSpec, Dimensions, Fit, Geometry, Modelling, RaceControl, RingCentre};
use tribodyn_contact::ElasticBody;
use tribodyn_shaft::{
    Element, Equilibrium, Material, RestingBearing, RingForce, Seat, Section, Shaft, Support, System, Vector, resultant,
};

/// A 7210 of 40°: 15 balls of 12.7 mm on 70 mm, f 0.52 and 0.53, contact constants at the free angle.
pub fn bearing() -> Bearing {
    let geometry = Geometry::new(Dimensions {
        ball_count: 15,
        ball_diameter: 12.7e-3,
        pitch_diameter: 70e-3,
        inner_coefficient: 0.52,
        outer_coefficient: 0.53,
        fit: Fit::ContactAngle(40f64.to_radians()),
    });
    let steel = ElasticBody { young: 208e9, poisson: 0.3 };
    let modelling = Modelling {
        race_control: Some(RaceControl::Outer),
        centrifugal_at_free_pitch: Some(true),
        ..Modelling::with_traction(false, RingCentre::Displaced)
    };
    Bearing::new(BearingSpec::new(geometry.unwrap(), (steel, 7800.0), modelling)).unwrap()
}

/// Back to back at nodes 2 and 6 of eight elements of 40 mm, 2000 N along y at node 8; the first ball in its direction.
pub fn system(bearing: &Bearing, young: f64) -> System<'_> {
    let material = Material { young, shear: young * 81.2 / 211.0, density: 7810.0 };
    let section = Section::solid(0.05);
    let element = Element { length: 0.04, start: section, end: section, material };
    let shaft = Shaft::new(vec![element; 8], Vec::new()).unwrap();
    let mut loads = vec![[0.0; 5]; 9];
    loads[8][1] = 2000.0;
    let support = |node, carries_plus_z| Support {
        node,
        carries_plus_z,
        offset: 5e-6,
        ring: Box::new(RestingBearing { bearing, first_ball: std::f64::consts::FRAC_PI_2 }) as _,
        seat: Seat::default(),
    };
    System { shaft, supports: vec![support(2, true), support(6, false)], housing: None, loads }
}

fn hardest_ball(bearing: &Bearing, found: &Equilibrium, index: usize) -> f64 {
    let resting = RestingBearing { bearing, first_ball: std::f64::consts::FRAC_PI_2 };
    (0..15).map(|ball| resting.ball(resting.azimuth(ball), found.rings[index]).load).fold(0.0, f64::max)
}

fn close(found: f64, printed: f64, digits: f64, name: &str) {
    assert!((found - printed).abs() <= 0.51 * digits, "{name}: {found} where {printed} is printed");
}

/// An independent program's numbers with the same equations, to the last printed digit.
#[test]
fn code_independent_two_7210_on_a_flexible_shaft() {
    let bearing = bearing();
    let mut reference = system(&bearing, 211e9);
    // A shaft that stretches carries less preload; the independent program has one axial freedom for all of it.
    let stretched = reference.equilibrium().unwrap();
    assert!(stretched.reactions[0][2].abs() < 2403.0);
    reference.shaft = reference.shaft.inextensible();
    let found = reference.equilibrium().unwrap();
    let [first, second] = [found.reactions[0], found.reactions[1]];
    close(first[1], 466.077, 1e-3, "F_y of the first");
    close(second[1], -2466.077, 1e-3, "F_y of the second");
    close(first[2].abs(), 2422.084, 1e-3, "F_z of the first");
    close(second[2], -first[2], 4e-6, "F_z of the second");
    // Moments in the sense of the slope dy/dz, which is −θ_x.
    close(-first[3], -14.4952, 1e-4, "M of the first");
    close(-second[3], -70.9325, 1e-4, "M of the second");
    close(hardest_ball(&bearing, &found, 0), 330.115, 1e-3, "Q_max of the first");
    close(hardest_ball(&bearing, &found, 1), 949.828, 1e-3, "Q_max of the second");
    close(found.nodes[8][1] * 1e6, 44.3670, 1e-4, "y of node 8");
    close(found.nodes[2][3].abs() * 1e3, 0.084446, 1e-6, "slope at the first");
    close(found.nodes[6][3].abs() * 1e3, 0.212431, 1e-6, "slope at the second");
    assert!(found.residual < 1e-9 && found.unbalanced < 1e-9, "{} {}", found.residual, found.unbalanced);
    assert!(found.loose.is_empty());
}

#[test]
fn code_independent_two_7210_on_a_rigid_shaft() {
    let bearing = bearing();
    // A shaft ten thousand times as stiff, whose end still bends by 1 nm.
    let found = system(&bearing, 211e13).equilibrium().unwrap();
    close(found.reactions[0][1], 467.723, 1e-3, "F_y of the first");
    close(found.reactions[1][1], -2467.723, 1e-3, "F_y of the second");
    close(found.nodes[8][1] * 1e6, 33.795, 1e-3, "y of node 8");
}

/// Loads and reactions have no sum, however the shaft is loaded.
#[test]
fn identity_forces_and_moments_balance() {
    let bearing = bearing();
    for (k, node) in [(0, 0), (1, 4), (2, 8), (3, 1), (4, 7)] {
        let mut system = system(&bearing, 211e9);
        system.loads[node][k] = if k < 3 { 1500.0 } else { 40.0 };
        let found = system.equilibrium().unwrap();
        let mut all = system.loads.clone();
        for (support, reaction) in system.supports.iter().zip(&found.reactions) {
            (0..5).for_each(|k| all[support.node][k] += reaction[k]);
        }
        let left = resultant(&system.shaft.positions(), &all);
        assert!(left.iter().all(|part| part.abs() < 1e-9 * 2466.0), "{left:?}");
    }
}

/// Stiffness by differences of forces, and symmetric: the balls' forces have a potential.
#[test]
fn identity_tangent_of_a_resting_bearing() {
    let bearing = bearing();
    let mut ring = RestingBearing { bearing: &bearing, first_ball: 0.3 };
    let at: Vector = [12e-6, -7e-6, 9e-6, 1e-4, -2e-4];
    let held = ring.at(&at).unwrap();
    for c in 0..5 {
        let step = if c < 3 { 1e-9 } else { 1e-8 };
        let mut side = |sign: f64| {
            let mut moved = at;
            moved[c] += sign * step;
            ring.at(&moved).unwrap().force
        };
        let (above, below) = (side(1.0), side(-1.0));
        for k in 0..5 {
            let difference = (above[k] - below[k]) / (2.0 * step);
            let scale = (held.stiffness[k][k] * held.stiffness[c][c]).sqrt();
            assert!((difference - held.stiffness[k][c]).abs() < 1e-6 * scale, "{k} {c}");
            assert!((held.stiffness[k][c] - held.stiffness[c][k]).abs() < 1e-12 * scale, "{k} {c}");
        }
    }
}

/// At rest the balls of Jones and Harris stand on the line of the groove centres: at 1e-3 r/min the solver gives the
/// same, ball by ball.
#[test]
fn limit_slow_jones_harris_is_the_resting_bearing() {
    use tribodyn_quasistatic::{Model, OperatingPoint, RingFreedom, SolverSettings, solve};
    let bearing = bearing();
    let at: Vector = [4e-6, 2e-6, 15e-6, 1e-5, -2e-5];
    let held = RestingBearing { bearing: &bearing, first_ball: 0.0 }.at(&at).unwrap();
    let point = OperatingPoint {
        ring: at.map(RingFreedom::Held),
        inner_speed: 1e-4,
        outer_speed: 0.0,
        patch: None,
        cage: None,
        numerics: SolverSettings::default(),
        watch: tribodyn_bearing::SearchWatch::default(),
    };
    let solved = solve(&bearing, &point, Model::JonesHarris).unwrap().solution;
    let ([x, y, z], [mx, my]) = (solved.ring_load_n, solved.ring_moment_nm);
    for (found, expected) in [x, y, z, mx, my].into_iter().zip(held.force) {
        assert!((found - expected).abs() < 1e-7 * held.force[2].abs(), "{found} {expected}");
    }
}

/// One bearing on a short stiff shaft, its ring held by the load alone, is the bearing itself: displacement under an
/// axial load, and stiffness against the shaft's.
#[test]
fn limit_one_bearing_on_a_stiff_stub() {
    let bearing = bearing();
    let material = Material { young: 211e13, shear: 81.2e13, density: 7810.0 };
    let section = Section::solid(0.05);
    let element = Element { length: 0.01, start: section, end: section, material };
    let shaft = Shaft::new(vec![element; 2], Vec::new()).unwrap();
    let mut loads = vec![[0.0; 5]; 3];
    loads[1] = [300.0, 0.0, 1500.0, 0.0, 5.0];
    let ring = Box::new(RestingBearing { bearing: &bearing, first_ball: 0.0 });
    let support = Support { node: 1, carries_plus_z: true, offset: 0.0, ring, seat: Seat::default() };
    let found = System { shaft, supports: vec![support], housing: None, loads }.equilibrium().unwrap();
    let held = RestingBearing { bearing: &bearing, first_ball: 0.0 }.at(&found.nodes[1]).unwrap();
    for (force, load) in held.force.into_iter().zip([300.0, 0.0, 1500.0, 0.0, 5.0]) {
        assert!((force - load).abs() < 1e-5, "{force} {load}");
    }
    assert_eq!(held.stiffness, found.stiffnesses[0]);
}

/// A shaft that turns end for end has mirrored answers: bearings the other way round, loads and places too.
#[test]
fn identity_mirror_image() {
    let bearing = bearing();
    let one = system(&bearing, 211e9).equilibrium().unwrap();
    let mut mirrored = system(&bearing, 211e9);
    mirrored.loads.reverse();
    let other = mirrored.equilibrium().unwrap();
    for (a, b) in one.nodes.iter().zip(other.nodes.iter().rev()) {
        assert!((a[1] - b[1]).abs() < 1e-12 && (a[2] + b[2]).abs() < 1e-12 && (a[3] + b[3]).abs() < 1e-11);
    }
}

/// A housing that gives way takes its share: springs in series.
#[test]
fn limit_soft_housing_and_sliding_ring() {
    let bearing = bearing();
    let mut stiff = system(&bearing, 211e9);
    stiff.loads = vec![[0.0; 5]; 9];
    stiff.loads[4][2] = 100.0;
    // Both seats on springs that are far softer than the bearings, along z only.
    let mut soft = system(&bearing, 211e9);
    soft.loads = vec![[0.0; 5]; 9];
    soft.loads[4][2] = 20.0;
    let k = [1e10, 1e10, 1e6, 1e7, 1e7];
    for support in &mut soft.supports {
        let stiffness = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { k[i] } else { 0.0 }));
        support.offset = 1e-4;
        support.seat = Seat { stiffness: Some(stiffness), ..Seat::default() };
    }
    let found = soft.equilibrium().unwrap();
    assert!((found.nodes[4][2] / (20.0 / 2e6) - 1.0).abs() < 0.05, "{}", found.nodes[4][2]);
    // A ring that slides under 150 N carries just that.
    let mut sliding = stiff;
    sliding.supports[1].seat.slides = Some(150.0);
    let found = sliding.equilibrium().unwrap();
    assert!((found.reactions[1][2].abs() - 150.0).abs() < 1e-6, "{:?}", found.reactions);
}
