//! A free cage by itself: numbers that were evaluated apart from this program, limits, balances.

use super::*;
use crate::frame::AzimuthFrame;
use crate::modelling::PocketForce;
use crate::pocket::{Pocket, PocketMotion};
use crate::state::RingState;
use crate::vectors::{add, cross, dot, scaled};
use std::f64::consts::TAU;
use tribodyn_fluid::FilmExtent;

pub(super) const INERTIA: f64 = 3e-5;

pub(super) fn cage(lands: Vec<CageLand>) -> FreeCage {
    FreeCage {
        mass: 0.03,
        transverse_inertia: 1.7e-5,
        unbalance: 0.0,
        gravity: [0.0; 3],
        displacement: [0.0; 2],
        pockets: PocketShape::Cylinder,
        lands,
    }
}

pub(super) fn film(extent: FilmExtent) -> LandFilm {
    LandFilm { viscosity: 0.02, density: 900.0, fill: 1.0, extent, roughness: 1e-6 }
}

pub(super) fn land(side: Side, film: Option<LandFilm>) -> CageLand {
    CageLand {
        side,
        axial: 0.0,
        radius: 0.0325,
        width: 4e-3,
        gap: 1.5e-4,
        stiffness: 1e7,
        damping: 0.2,
        friction: 0.15,
        film,
    }
}

/// The angular velocity across a tilted axis with these parts about X and Y.
fn turning_across(tilt: [f64; 2], [x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, -(x * tilt[1] - y * tilt[0])]
}

/// A pose from a centre of mass, a velocity, an angular velocity across the axis and a vector of tilt.
pub(super) fn pose(
    cage: &FreeCage,
    turn: [f64; 2],
    x: [f64; 3],
    v: [f64; 3],
    omega: [f64; 2],
    tilt: [f64; 2],
) -> CagePose {
    let [a, b] = tilt.map(|t| 0.5 * t);
    let w = (1.0 - a * a - b * b).sqrt();
    CagePose::new(cage, turn, &[x[0], x[1], x[2], v[0], v[1], v[2], omega[0], omega[1], a, b, 0.0, w])
}

/// A pose at an angle about Z a short time later.
fn moved(cage: &FreeCage, pose: &CagePose, angle: f64, t: f64) -> CagePose {
    let [x, y, z] = add(pose.mass_centre, scaled(pose.velocity, t));
    let rate = quaternion_rate(pose.omega, pose.quaternion);
    let [a, b, c, d] = std::array::from_fn(|k| pose.quaternion[k] + t * rate[k]);
    let ([v_x, v_y, v_z], [w_x, w_y, speed]) = (pose.velocity, pose.omega);
    CagePose::new(cage, [angle + speed * t, speed], &[x, y, z, v_x, v_y, v_z, w_x, w_y, a, b, c, d])
}

/// The cage alone under its lands over a time, by the classical Runge–Kutta method.
fn run(cage: &FreeCage, rings: [&RingState; 2], y: &mut [f64; FREE_CAGE + 2], (h, steps): (f64, u64)) {
    let rate = |y: &[f64; FREE_CAGE + 2]| {
        let (turn, unknowns) = ([y[FREE_CAGE], y[FREE_CAGE + 1]], y.first_chunk().unwrap());
        let pose = CagePose::new(cage, turn, unknowns);
        let mut wrench = Wrench::default();
        for land in &cage.lands {
            let load = land.load(&pose, (rings[land.side as usize], 0.0));
            wrench.add_at([0.0; 3], load.on_cage.force, load.on_cage.moment);
        }
        let (rates, about_z) = cage.rates(&pose, &wrench, INERTIA);
        let mut dy = [0.0; FREE_CAGE + 2];
        dy[..FREE_CAGE].copy_from_slice(&rates);
        (dy[FREE_CAGE], dy[FREE_CAGE + 1]) = (turn[1], about_z);
        dy
    };
    let ahead = |y: &[f64; FREE_CAGE + 2], k: &[f64; FREE_CAGE + 2], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
    for _ in 0..steps {
        let a = rate(y);
        let b = rate(&ahead(y, &a, 0.5 * h));
        let c = rate(&ahead(y, &b, 0.5 * h));
        let d = rate(&ahead(y, &c, h));
        (0..FREE_CAGE + 2).for_each(|i| y[i] += h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
    }
}

fn started(cage: &FreeCage, speed: f64) -> [f64; FREE_CAGE + 2] {
    let mut y = [0.0; FREE_CAGE + 2];
    y[..FREE_CAGE].copy_from_slice(&cage.at_start(speed, 0.0));
    y[FREE_CAGE + 1] = speed;
    y
}

/// Petroff's torque at a difference of 1000 1/s, and its reaction.
#[test]
fn paper_petroff_torque_of_the_centred_land() {
    let cage = cage(vec![land(Side::Outer, Some(film(FilmExtent::Half)))]);
    let still = pose(&cage, [0.0, 200.0], [0.0; 3], [0.0; 3], [0.0; 2], [0.0; 2]);
    let load = cage.lands[0].load(&still, (&RingState::centred(1200.0), 0.0));
    assert!((load.on_cage.moment[2] - 0.115035).abs() < 5e-7, "{}", load.on_cage.moment[2]);
    assert!((load.drive - load.on_cage.moment[2]).abs() < 1e-15);
    assert!((load.film_power - 1000.0 * load.drive).abs() < 1e-9);
}

/// A weightless cage in a full film: m s² + D s − i D W = 0 has the root 124.2398 + 419.2854 i, a growing whirl.
#[test]
fn paper_whirl_of_a_weightless_cage_in_a_full_film() {
    let cage = cage(vec![CageLand { film: Some(film(FilmExtent::Full)), ..land(Side::Outer, None) }]);
    let (real, imaginary, size) = (124.2398, 419.2854, 1e-9);
    let v = [real * size, imaginary * size, 0.0];
    let now = pose(&cage, [0.0, 400.0], [size, 0.0, 0.0], v, [0.0; 2], [0.0; 2]);
    let load = cage.lands[0].load(&now, (&RingState::centred(600.0), 0.0));
    let (rates, _) = cage.rates(&now, &load.on_cage, INERTIA);
    let [x, y] = [real * real - imaginary * imaginary, 2.0 * real * imaginary].map(|a| a * size);
    let error = (rates[3] - x).hypot(rates[4] - y) / x.hypot(y);
    // The root has seven digits.
    assert!(error < 1e-6, "{error:e}");
    // And it grows at that rate when the cage is let go there.
    let mut y = started(&cage, 400.0);
    (y[0], y[3], y[4]) = (size, v[0], v[1]);
    let rings = RingState::centred(600.0);
    run(&FreeCage { lands: cage.lands.clone(), ..cage }, [&rings, &rings], &mut y, (1e-6, 20_000));
    let grown = (y[0].hypot(y[1]) / size).ln() / 0.02;
    // Friction of the film brakes the cage a little on the way.
    assert!((grown / real - 1.0).abs() < 0.02, "{grown}");
}

/// r = (K c + m e ω²)/(K − m ω²) against a linear land without friction: 0.200198 mm and 3.963567 N, forward at ω.
#[test]
fn paper_circle_of_an_unbalanced_cage_on_an_elastic_land() {
    let dry = CageLand { gap: 2e-4, stiffness: 1e7, friction: 0.0, damping: 0.0, ..land(Side::Outer, None) };
    let cage = FreeCage { mass: 0.05, unbalance: 2e-5, ..cage(vec![dry]) };
    let (omega, ring) = (600.0, RingState::centred(0.0));
    let radius = 0.200198e-3;
    let mut y = started(&cage, omega);
    (y[0], y[4]) = (radius + 2e-5, omega * (radius + 2e-5));
    let now =
        |y: &[f64; FREE_CAGE + 2]| CagePose::new(&cage, [y[FREE_CAGE], y[FREE_CAGE + 1]], y.first_chunk().unwrap());
    let force = dry.load(&now(&y), (&ring, 0.0)).on_cage.force[0];
    assert!((force + 3.963567).abs() < 0.02, "{force}");
    let exact = (2e7 * 2e-4 + 0.05 * 2e-5 * omega * omega) / (2e7 - 0.05 * omega * omega);
    assert!((exact - radius).abs() < 5e-10);
    let (steps, h) = (100_000, TAU / omega / 10_000.0);
    let mut turned = 0.0;
    for _ in 0..steps / 1000 {
        let before = now(&y).centre;
        run(&cage, [&ring, &ring], &mut y, (h, 1000));
        let after = now(&y).centre;
        turned += cross(before, after)[2].atan2(dot(before, after));
        assert!((after[0].hypot(after[1]) - radius).abs() < 1e-8, "{after:?}");
    }
    assert!((turned / (omega * h * f64::from(steps)) - 1.0).abs() < 1e-3, "{turned}");
}

/// Without forces: momentum and energy stay, and the axis goes round the angular momentum at I_a ω/I_t, that is at
/// (I_a/I_t − 1) ω seen from the cage.
#[test]
fn identity_a_cage_that_nothing_touches_keeps_momentum_and_energy() {
    let cage = FreeCage { unbalance: 1e-5, ..cage(Vec::new()) };
    let omega = 600.0;
    let mut y = started(&cage, omega);
    (y[5], y[6], y[7]) = (0.3, 12.0, -5.0);
    let ring = RingState::centred(0.0);
    let now =
        |y: &[f64; FREE_CAGE + 2]| CagePose::new(&cage, [y[FREE_CAGE], y[FREE_CAGE + 1]], y.first_chunk().unwrap());
    let of = |pose: &CagePose| {
        let mut turning = cage.angular_momentum(pose, INERTIA);
        turning = add(turning, scaled(cross(pose.mass_centre, pose.velocity), -cage.mass));
        (turning, cage.energy(pose, INERTIA))
    };
    let (before, energy) = of(&now(&y));
    let steps = 1500;
    run(&cage, [&ring, &ring], &mut y, (TAU / omega / f64::from(steps), 1000 * u64::from(steps as u32)));
    let end = now(&y);
    let (after, energy_after) = of(&end);
    let size = dot(before, before).sqrt();
    (0..3).for_each(|k| assert!((after[k] - before[k]).abs() < 1e-12 * size, "{k}: {before:?} {after:?}"));
    assert!((energy_after / energy - 1.0).abs() < 1e-12, "{energy} {energy_after}");
    let norm = end.quaternion.iter().map(|q| q * q).sum::<f64>();
    assert!((norm - 1.0).abs() < 1e-11, "{norm}");
    // Where the axis is after a whole number of turns, from L: n precesses about L at |L|/I_t.
    let unit = scaled(before, 1.0 / size);
    let rate = size / cage.transverse_inertia;
    let time = 1000.0 * TAU / omega;
    let first = [0.0, 0.0, 1.0];
    let about = cross(unit, first);
    let (sin, cos) = (rate * time).sin_cos();
    let turned: [f64; 3] =
        std::array::from_fn(|k| first[k] * cos + about[k] * sin + unit[k] * dot(unit, first) * (1.0 - cos));
    (0..3).for_each(|k| assert!((turned[k] - end.axes[2][k]).abs() < 1e-8, "{turned:?} {:?}", end.axes[2]));
    // Seen from the cage the momentum turns at (I_a/I_t − 1) ω_n, with the speed about the axis.
    let spin = dot(end.omega, end.axes[2]);
    let cone = (INERTIA / cage.transverse_inertia - 1.0) * spin;
    let rate_seen = {
        let h = 1e-7;
        let seen = |pose: &CagePose| {
            let l = cage.angular_momentum(pose, INERTIA);
            let l = add(l, scaled(cross(pose.mass_centre, pose.velocity), -cage.mass));
            dot(l, pose.axes[1]).atan2(dot(l, pose.axes[0]))
        };
        let a = seen(&end);
        run(&cage, [&ring, &ring], &mut y, (h, 1));
        (seen(&now(&y)) - a) / h
    };
    // In the cage's axes the momentum turns against that sense.
    assert!((rate_seen.abs() / cone - 1.0).abs() < 1e-5, "{rate_seen} {cone}");
}

fn pocket(friction: f64) -> Pocket {
    Pocket {
        radius: 0.023,
        clearance: 1e-4 / 0.023,
        stiffness: 5e6,
        damping: 0.5,
        friction,
        ball_radius: 4.7625e-3,
        force: PocketForce::FromWall,
        film: None,
    }
}

/// How far a cage can be shifted along X with its balls on the pitch circle: c_p/max |sin φ|.
#[test]
fn paper_balls_guide_a_cage_within_their_pockets() {
    for (balls, published) in [(3, 1.154701), (4, 1.0), (7, 1.025717), (13, 1.007345)] {
        let (cage, pocket, gap) = (cage(Vec::new()), pocket(0.1), 1e-4);
        let wall = pocket.wall(PocketShape::Cylinder);
        let touches = |shift: f64| {
            let pose = pose(&cage, [0.0; 2], [shift, 0.0, 0.0], [0.0; 3], [0.0; 2], [0.0; 2]);
            (0..balls).any(|ball| {
                let azimuth = TAU * f64::from(ball) / f64::from(balls);
                let at = (AzimuthFrame::at(azimuth), [0.0, pocket.radius, 0.0]);
                pocket.place(&wall, (&pose, at.0), at).depth > 0.0
            })
        };
        let (mut low, mut high) = (0.0, 2.0 * gap);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if touches(middle) { high = middle } else { low = middle }
        }
        assert!((low / gap - published).abs() < 1e-6, "{balls}: {}", low / gap);
    }
}

/// In a cage that is centred, turns only and slides on a ball that does not, a cylinder is the pocket of one freedom,
/// but for the chord of the pitch circle in the place of its arc.
#[test]
fn limit_a_centred_cage_has_the_pocket_of_one_freedom() {
    let (cage, pocket) = (cage(Vec::new()), pocket(0.1));
    for lead in [5e-3, -4.6e-3] {
        let frame = AzimuthFrame::at(0.7 + lead);
        let pose = pose(&cage, [0.7, 300.0], [0.0; 3], [0.0; 3], [0.0; 2], [0.0; 2]);
        let at = [0.0, pocket.radius, 0.0];
        let place = pocket.place(&pocket.wall(PocketShape::Cylinder), (&pose, AzimuthFrame::at(0.0)), (frame, at));
        let (velocity, omega) = ([0.02, -0.01, 0.023 * 301.0], [-900.0, 200.0, 0.0]);
        let free = pocket.load_of_free(&pose, &place, (frame, velocity, omega), f64::INFINITY);
        let held = pocket.load(&PocketMotion {
            lead,
            rate: 1.0,
            velocity: [velocity[0], velocity[1]],
            angular_velocity: [omega[0], omega[1]],
            cage_speed: 300.0,
        });
        assert!((place.lead() - lead).abs() < 1e-15);
        assert!((free.force / held.force - 1.0).abs() < 1e-2, "{} {}", free.force, held.force);
        assert!((free.cage_torque / held.cage_torque - 1.0).abs() < 1e-2);
        // The wall is square to the pocket's radius, not to the ball's: a part N sin(lead) of 0.1 N.
        assert!((free.friction[1] / held.friction[1] - 1.0).abs() < 6e-2);
    }
}

/// Ball and cage receive together the power that spring, damping and friction take, in every pocket, with the cage off
/// centre and tilted.
#[test]
fn identity_power_and_momentum_of_ball_and_pocket() {
    let (cage, pocket) = (FreeCage { unbalance: 3e-5, ..cage(Vec::new()) }, pocket(0.1));
    let frame = AzimuthFrame::at(2.1);
    for shape in [PocketShape::Cylinder, PocketShape::Sphere, PocketShape::RaceTrack { axial_gap: 5e-5 }] {
        let (x, v, omega, tilt) = ([4e-5, -7e-5, 2e-5], [0.3, -0.2, 0.1], [20.0, -30.0], [2e-3, -1e-3]);
        let (at, velocity, turning) = ([1.2e-4, 0.02295, 0.0], [0.4, 0.2, 7.3], [-900.0, 200.0, 70.0]);
        let start = pose(&cage, [2.1 - 9e-3, 300.0], x, v, omega, tilt);
        let of = |t: f64| {
            let inertial = add(frame.to_inertial(at), scaled(frame.to_inertial(velocity), t));
            (moved(&cage, &start, 2.1 - 9e-3, t), frame.from_inertial(inertial))
        };
        let (pose, place) = of(0.0);
        let (wall, first) = (pocket.wall(shape), AzimuthFrame::at(0.0));
        let seen = pocket.place(&wall, (&pose, first), (frame, place));
        assert_eq!(pocket.depth_in(&wall, (&pose, first), (frame, place)), seen.depth);
        let load = pocket.load_of_free(&pose, &seen, (frame, velocity, turning), f64::INFINITY);
        assert!(load.normal > 1.0, "{shape:?}: {load:?}");
        let mut on_cage = Wrench::default();
        on_cage.react(&pose, &load, (frame, place));
        let on_ball = [load.friction[0], load.friction[1], load.force];
        let ball = dot(on_ball, velocity) + dot(load.moment, turning);
        let given = ball + dot(on_cage.force, pose.velocity) + dot(on_cage.moment, pose.omega);
        // ½ K δ² changes by K δ δ'.
        let stored = pocket.stiffness * seen.depth * pocket.closing(&pose, &seen, (frame, velocity));
        let lost = load.damping_power + load.friction_power;
        assert!((given + stored + lost).abs() < 1e-12 * (stored.abs() + lost), "{shape:?}: {given} {stored} {lost}");
        // Angular momentum about the origin.
        let centre = frame.to_inertial(place);
        let of_ball = add(cross(centre, frame.to_inertial(on_ball)), frame.to_inertial(load.moment));
        let of_cage = add(cross(pose.mass_centre, on_cage.force), on_cage.moment);
        let rest = add(of_ball, of_cage);
        assert!(dot(rest, rest).sqrt() < 1e-13 * dot(of_ball, of_ball).sqrt(), "{rest:?}");
        let depth = |t: f64| {
            let (pose, place) = of(t);
            pocket.depth_in(&wall, (&pose, first), (frame, place))
        };
        let slope = (depth(1e-8) - depth(-1e-8)) / 2e-8;
        let closing = pocket.closing(&pose, &seen, (frame, velocity));
        assert!((slope / closing - 1.0).abs() < 1e-5, "{shape:?}: {slope} {closing}");
    }
}

/// A land gives cage, ring and drive the power that edges and film take, and all moments about the ring's axis balance.
#[test]
fn identity_power_and_momentum_of_a_land() {
    for side in Side::BOTH {
        for film in [None, Some(film(FilmExtent::Half)), Some(film(FilmExtent::Full))] {
            let land = CageLand { axial: 2e-3, ..land(side, film) };
            let cage = FreeCage { unbalance: 3e-5, ..cage(vec![land]) };
            let ring = RingState {
                displacement: [2e-5, -1e-5, 3e-5],
                tilt: [3e-4, -2e-4],
                velocity: [0.05, -0.02, 0.01],
                speed: 900.0,
                turning: Some(turning_across([3e-4, -2e-4], [20.0, 35.0])),
            };
            let place = [1.7e-4, 1.3e-4, 1e-5];
            let pose = pose(&cage, [0.4, 380.0], place, [0.6, 0.3, -0.1], [5.0, -9.0], [4e-3, 1e-3]);
            let load = land.load(&pose, (&ring, 7e-4));
            assert!(load.gap < 0.0, "{load:?}");
            let tilted = [ring.tilt[1], -ring.tilt[0], 1.0];
            let axis = scaled(tilted, 1.0 / dot(tilted, tilted).sqrt());
            let Wrench { force, moment } = load.on_cage;
            let cage_power = dot(force, pose.velocity) + dot(moment, pose.omega);
            let turning = ring.turning.unwrap();
            let ring_power = -dot(force, ring.velocity) - load.drive * ring.speed + dot(load.on_ring, turning);
            let lost = load.friction_power + load.damping_power + load.film_power;
            assert!(load.friction_power > 0.0 && lost > 0.0);
            // The springs' energy, with the pose moved on by its velocities, and the axis by ω × axis.
            let axis_rate = cross(turning, axis);
            let rates = [0, 1].map(|k| {
                let row = [1, 0][k];
                let of_slope = (axis_rate[row] - axis[row] / axis[2] * axis_rate[2]) / axis[2];
                if k == 0 { -of_slope } else { of_slope }
            });
            let energy = |t: f64| {
                let displacement = add(ring.displacement, scaled(ring.velocity, t));
                let tilt = [0, 1].map(|k| ring.tilt[k] + t * rates[k]);
                let ring = RingState { displacement, tilt, ..ring };
                land.load(&moved(&cage, &pose, 0.4, t), (&ring, 7e-4)).energy
            };
            let stored = (energy(1e-9) - energy(-1e-9)) / 2e-9;
            let sum = cage_power + ring_power + stored + lost;
            assert!(sum.abs() < 1e-6 * (lost + stored.abs()), "{side:?} {film:?}: {sum} of {lost}, {stored}");
            // Angular momentum about the ring's centre: cage and ring, whose part along the axis the drive holds.
            let arm = crate::vectors::along(add(ring.displacement, [0.0, 0.0, 7e-4]), pose.mass_centre);
            let of_cage = add(moment, cross(arm, force));
            let left = add(of_cage, load.on_ring);
            assert!(dot(left, left) < 1e-24 * dot(of_cage, of_cage), "{side:?} {film:?}: {of_cage:?} {load:?}");
            let about = dot(axis, of_cage);
            assert!((about - load.drive).abs() < 1e-12 * load.drive.abs().max(1e-6), "{about} {}", load.drive);
        }
    }
}

/// With a film the edges begin at the roughness, smoothly, and end as a spring of full stiffness.
#[test]
fn identity_an_edge_begins_smoothly_under_a_film() {
    let cage = cage(vec![land(Side::Inner, Some(film(FilmExtent::Half)))]);
    let force = |depth: f64| {
        let pose = pose(&cage, [0.0; 2], [1.5e-4 + depth, 0.0, 0.0], [0.0; 3], [0.0; 2], [0.0; 2]);
        -cage.lands[0].load(&pose, (&RingState::centred(0.0), 0.0)).on_cage.force[0]
    };
    assert!(force(-1e-6).abs() < 1e-20, "{}", force(-1e-6));
    for edge in [-1e-6, 1e-6] {
        let slope = |at: f64| (force(at + 1e-10) - force(at - 1e-10)) / 2e-10;
        assert!((slope(edge - 1e-9) - slope(edge + 1e-9)).abs() < 2e-3 * 2e7, "{edge}");
    }
    assert!((force(1e-5) - 2e7 * 1e-5).abs() < 1e-9 * 200.0, "{}", force(1e-5));
}
