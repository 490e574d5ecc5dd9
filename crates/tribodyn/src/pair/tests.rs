//! Pairs against symmetry, single bearings and differences.

use super::*;
use tribodyn_case::Case;

const ANGULAR: &str = include_str!("../../../../fixtures/cases/angular-7210.ron");
const OFFSET: f64 = 40e-6;
const DISTANCE: f64 = 0.06;

/// A bearing at 6000 r/min with loads x and z on the shaft, which may tilt.
fn problem(x: f64, z: f64) -> (Bearing, OperatingPoint) {
    let case = Case::from_ron(ANGULAR).unwrap();
    let mut point = case.operating_point();
    point.ring = [x, 0.0, z, 0.0, 0.0].map(RingFreedom::Loaded);
    (case.bearing().unwrap(), point)
}

fn solved((bearing, point): &(Bearing, OperatingPoint), arrangement: Arrangement, preload: Preload) -> PairSolution {
    let model = PairModel::QuasiStatic(Model::JonesHarris);
    solve_pair(&Pair { bearing, point, model, arrangement, distance: DISTANCE, preload }).unwrap()
}

fn close(a: f64, b: f64, relative: f64) -> bool {
    (a - b).abs() <= relative * a.abs().max(b.abs())
}

#[test]
fn identity_back_to_back_bearings_share_a_radial_load_evenly() {
    for arrangement in [Arrangement::BackToBack, Arrangement::FaceToFace] {
        let [a, b] = solved(&problem(1000.0, 0.0), arrangement, Preload::OffsetM(OFFSET)).bearings;
        assert!(close(a.load_n[0], 500.0, 1e-6) && close(b.load_n[0], 500.0, 1e-6), "{a:?} {b:?}");
        assert!(close(a.load_n[2], -b.load_n[2], 1e-6) && a.load_n[2].abs() > 100.0);
        assert!(close(a.moment_nm[1], -b.moment_nm[1], 1e-6));
    }
}

#[test]
fn identity_bearings_in_tandem_share_an_axial_load_evenly() {
    let s = solved(&problem(0.0, 3000.0), Arrangement::Tandem, Preload::OffsetM(0.0));
    assert!(s.bearings.iter().all(|b| close(b.load_n[2], 1500.0, 1e-6)));
    assert_eq!(s.preload_n, 0.0);
}

/// The shaft stands where the load–deflection curves of the two bearings, each by itself, differ by the load.
#[test]
fn identity_offset_preload_is_where_the_load_deflection_curves_meet() {
    let (load, problem) = (400.0, problem(0.0, 400.0));
    let (bearing, point) = &problem;
    let axial = |z: f64| {
        let ring = [0.0, 0.0, z, 0.0, 0.0].map(RingFreedom::Held);
        solve(bearing, &OperatingPoint { ring, ..point.clone() }, Model::JonesHarris).unwrap().solution.ring_load_n[2]
    };
    let (mut low, mut high) = (0.0, 0.5 * OFFSET);
    for _ in 0..50 {
        let z = 0.5 * (low + high);
        let beyond = axial(0.5 * OFFSET + z) - axial(0.5 * OFFSET - z) > load;
        *(if beyond { &mut high } else { &mut low }) = z;
    }
    let s = solved(&problem, Arrangement::BackToBack, Preload::OffsetM(OFFSET));
    assert!(close(s.shaft_displacement_m[2], low, 1e-6), "{} {low}", s.shaft_displacement_m[2]);
    assert!(close(s.preload_n, axial(0.5 * OFFSET - low), 1e-6));
    assert!(close(s.bearings[0].load_n[2] + s.bearings[1].load_n[2], load, 1e-7));
}

/// A spring's force is on its bearing whatever the shaft does; the other carries the load besides.
#[test]
fn identity_a_spring_keeps_its_force() {
    let s = solved(&problem(300.0, 200.0), Arrangement::BackToBack, Preload::SpringN(800.0));
    let [a, b] = &s.bearings;
    assert!(close(b.load_n[2], -800.0, 1e-9) && close(a.load_n[2], 1000.0, 1e-6), "{a:?} {b:?}");
    let model = PairModel::QuasiStatic(Model::JonesHarris);
    let (bearing, point) = problem(300.0, 0.0);
    let tandem = Arrangement::Tandem;
    let pair = Pair {
        bearing: &bearing,
        point: &point,
        model,
        arrangement: tandem,
        distance: 0.1,
        preload: Preload::SpringN(1.0),
    };
    assert_eq!(solve_pair(&pair).unwrap_err(), PairError::SpringInTandem);
}

/// Lines of contact that meet outside the pair give the longer lever.
#[test]
fn limit_back_to_back_is_stiffer_against_tilting_and_alike_along_the_axes() {
    let free = problem(0.0, 0.0);
    let of = |arrangement| solved(&free, arrangement, Preload::OffsetM(OFFSET)).stiffness;
    let (db, df) = (of(Arrangement::BackToBack), of(Arrangement::FaceToFace));
    assert!(db[3][3] > 2.0 * df[3][3] && df[3][3] > 0.0, "{} {}", db[3][3], df[3][3]);
    assert!((0..3).all(|k| close(db[k][k], df[k][k], 1e-6)));
}

#[test]
fn identity_stiffness_is_that_of_differences() {
    let at = |x: f64, z: f64| solved(&problem(x, z), Arrangement::BackToBack, Preload::OffsetM(OFFSET));
    let middle = at(600.0, 100.0);
    for (column, [x, z]) in [(0, [1.0, 0.0]), (2, [0.0, 1.0])] {
        let (up, down) = (at(600.0 + x, 100.0 + z), at(600.0 - x, 100.0 - z));
        let moved = |s: &PairSolution| {
            let ([x, y, z], [tx, ty]) = (s.shaft_displacement_m, s.shaft_tilt_rad);
            [x, y, z, tx, ty]
        };
        let (up, down) = (moved(&up), moved(&down));
        let difference: Vector = std::array::from_fn(|k| 0.5 * (up[k] - down[k]));
        let load = times(&middle.stiffness, &difference);
        assert!((load[column] - 1.0).abs() < 1e-4, "{column} {load:?}");
    }
}

/// At rest as in slow turning: preloaded, loose, on a spring and in tandem, balls without load in most of them.
#[test]
fn limit_a_pair_at_rest_is_the_limit_of_slow_turning() {
    let cases = [
        (800.0, 300.0, Arrangement::BackToBack, Preload::OffsetM(OFFSET)),
        (800.0, 300.0, Arrangement::BackToBack, Preload::OffsetM(-OFFSET)),
        (300.0, -900.0, Arrangement::FaceToFace, Preload::OffsetM(0.0)),
        (900.0, 200.0, Arrangement::FaceToFace, Preload::SpringN(300.0)),
        (500.0, 1500.0, Arrangement::Tandem, Preload::OffsetM(0.0)),
    ];
    for (radial, axial, arrangement, preload) in cases {
        let at_speed = |speed: f64| {
            let (bearing, mut point) = problem(radial, axial);
            point.inner_speed = speed;
            solved(&(bearing, point), arrangement, preload)
        };
        let (still, turning) = (at_speed(0.0), at_speed(0.01));
        for (a, b) in still.bearings.iter().zip(&turning.bearings) {
            for k in 0..3 {
                let difference = (a.load_n[k] - b.load_n[k]).abs();
                assert!(difference < 1e-4 * (radial + axial.abs()), "{arrangement:?} {:?} {:?}", a.load_n, b.load_n);
            }
        }
        let carried = |k: usize| still.bearings.iter().map(|b| b.load_n[k]).sum::<f64>();
        assert!((carried(0) - radial).abs() < 1e-6 * radial && (carried(2) - axial).abs() < 1e-6 * axial.abs());
        for k in 0..5 {
            assert!(close(still.stiffness[k][k], turning.stiffness[k][k], 1e-2), "{arrangement:?} {k}");
        }
    }
}
