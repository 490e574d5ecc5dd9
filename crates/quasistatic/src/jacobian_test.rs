//! The exact Jacobian of ball and ring balances against central differences.

use crate::block::{BALL, BlockSystem, RING};
use crate::jones_harris::{JonesHarris, Typical};
use crate::with_traction::WithTraction;
use nalgebra::SVector;
use num_dual::{Derivative, DualSVec64};
use tribodyn_bearing::{Bearing, Races, RingFreedom, SearchWatch, Side};
use tribodyn_case::{Case, set_value};
use tribodyn_traction::{FastPatch, PatchRule};

const ALL: usize = BALL + RING;
type Dual = DualSVec64<ALL>;

fn bearing(changes: &[(&str, &str)]) -> Bearing {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let pinned = [("geometry.pitch_diameter", "mm(165)"), ("traction.slip_unit", "Scaled(per_m_s: 22.0)")];
    let pinned = pinned
        .iter()
        .chain([&("geometry.inner_groove", "Coefficient(0.527)"), &("geometry.outer_groove", "Coefficient(0.527)")]);
    let text = pinned.chain(changes).fold(text, |text, (path, value)| set_value(&text, path, value).unwrap());
    Case::from_ron(&text).unwrap().bearing().unwrap()
}

/// Numbers in [−1, 1] from a linear congruential generator (constants: Knuth, MMIX).
fn noise(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

/// Unknowns of one ball and the ring, in loaded contact and sliding at both races, with a step for differences each.
fn random_state(bearing: &Bearing, seed: &mut u64) -> [(f64, f64); ALL] {
    let g = &bearing.geometry;
    let offset = g.groove_offset(Side::Outer);
    let along = [g.sin_contact_angle(), g.cos_contact_angle()];
    let mut near = |value: f64, spread: f64, step: f64| (value + spread * noise(seed), step);
    [
        near((offset + 3e-5) * along[0], 5e-6, 1e-9),
        near((offset + 3e-5) * along[1], 5e-6, 1e-9),
        near(-3600.0, 200.0, 1e-2),
        near(1100.0, 200.0, 1e-2),
        near(0.0, 100.0, 1e-2),
        near(610.0, 40.0, 1e-2),
        near(7e-5 * along[1], 5e-6, 1e-9),
        near(0.0, 5e-6, 1e-9),
        near(7e-5 * along[0], 5e-6, 1e-9),
        near(0.0, 1e-5, 1e-8),
        near(0.0, 1e-5, 1e-8),
    ]
}

/// All forces on one ball, then those it puts on the ring.
fn forces<D: tribodyn_bearing::Scalar, S: BlockSystem>(system: &S, index: usize, u: [D; ALL]) -> [D; ALL] {
    let balance = system.ball(index, std::array::from_fn(|k| u[k]), std::array::from_fn(|k| u[BALL + k]));
    std::array::from_fn(|k| if k < BALL { balance.residual[k] } else { balance.ring[k - BALL] })
}

fn check<S: BlockSystem>(what: &str, system: &S, index: usize, state: [(f64, f64); ALL], relative: f64) {
    let duals: [Dual; ALL] = std::array::from_fn(|k| {
        let mut direction = SVector::<f64, ALL>::zeros();
        direction[k] = 1.0;
        Dual::new(state[k].0, Derivative::some(direction))
    });
    let exact =
        forces(system, index, duals).map(|f| f.eps.unwrap_generic(nalgebra::Const::<ALL>, nalgebra::Const::<1>));
    for (column, &(_, step)) in state.iter().enumerate() {
        let shifted = |share: f64| {
            let at = std::array::from_fn(|k| state[k].0 + if k == column { share * step } else { 0.0 });
            forces(system, index, at)
        };
        // Fourth order: the traction curve bends sharply at steep slip scales.
        let (near, back, far, far_back) = (shifted(1.0), shifted(-1.0), shifted(2.0), shifted(-2.0));
        for row in 0..ALL {
            let difference = (8.0 * (near[row] - back[row]) - (far[row] - far_back[row])) / (12.0 * step);
            let size = exact[row].amax().max(1e-6);
            let column_size = exact.iter().fold(0.0f64, |m, row| m.max(row[column].abs()));
            let error = (difference - exact[row][column]).abs();
            let allowed = relative * (exact[row][column].abs() + 1e-3 * column_size.min(size)).max(1e-9 * column_size);
            assert!(error <= allowed, "{what}, ({row}, {column}): {difference:e} and {:e}", exact[row][column]);
        }
    }
}

/// Largest error of a slope, relative, with a thousandth of the row's or column's largest added.
const RELATIVE: f64 = 2e-6;
/// The same where the shape of the contact ellipse follows the contact angle. The closed form holds that shape:
/// derivatives of friction with respect to position, small beside those of the normal force, are then wrong by up to 14
/// %.
const ELLIPSE: f64 = 0.15;

const RING_AT_REST: [RingFreedom; RING] = [RingFreedom::Held(0.0); RING];

#[test]
fn identity_jacobian_with_traction_is_that_of_differences() {
    let mut seed = 7;
    for (relative, changes) in [
        (RELATIVE, &[][..]),
        (RELATIVE, &[("traction.differential_slip", "false"), ("traction.varying", "false")]),
        (RELATIVE, &[("traction.slip_unit", "PercentOfRolling")]),
        (RELATIVE, &[("traction.pressure", "Local"), ("traction.slip_unit", "PercentOfRolling")]),
        (ELLIPSE, &[("modelling.contact_at_actual_angle", "true")]),
        (RELATIVE, &[("modelling.ring_centre", "Inertial")]),
    ] {
        let bearing = bearing(changes);
        let speeds = Races::from([1466.0, -50.0]);
        for index in [0, 3, 8] {
            let system = WithTraction {
                bearing: &bearing,
                ring: RING_AT_REST,
                speeds,
                kernel: FastPatch::new(PatchRule::GaussJacobi { radial: 6, angles: 16 }).unwrap(),
                typical: Typical::new(&bearing, &RING_AT_REST, speeds),
                watch: SearchWatch::default(),
            };
            check(&format!("{changes:?}, ball {index}"), &system, index, facing(&bearing, index, &mut seed), relative);
        }
    }
}

#[test]
fn identity_jacobian_of_jones_harris_is_that_of_differences() {
    let mut seed = 11;
    for inner in [false, true] {
        let bearing = bearing(&[]);
        let speeds = Races::from([1466.0, -50.0]);
        for index in [0, 3, 8] {
            let system = JonesHarris {
                bearing: &bearing,
                ring: RING_AT_REST,
                speeds,
                inner_control: vec![inner; 13],
                centrifugal_at_free_pitch: index == 3,
                bounded: true,
                frozen: None,
                typical: Typical::new(&bearing, &RING_AT_REST, speeds),
            };
            check(
                &format!("inner control {inner}, ball {index}"),
                &system,
                index,
                facing(&bearing, index, &mut seed),
                RELATIVE,
            );
        }
    }
}

/// A random state with the ring's radial displacement turned towards the ball, so that the ball is loaded.
fn facing(bearing: &Bearing, index: usize, seed: &mut u64) -> [(f64, f64); ALL] {
    let mut state = random_state(bearing, seed);
    let (sin, cos) = bearing.azimuth(index).sin_cos();
    let (x, y) = (state[6].0, state[7].0);
    (state[6].0, state[7].0) = (x * cos - y * sin, x * sin + y * cos);
    state
}
