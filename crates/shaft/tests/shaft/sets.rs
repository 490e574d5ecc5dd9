//! Sets of bearings under axial load.

use crate::two_bearings::{bearing, system};
use tribodyn_bearing::Bearing;
use tribodyn_shaft::{AxialSet, Member, RestingBearing, ShaftError, offset_for};

fn set<'a>(bearing: &'a Bearing, sides: &[bool]) -> AxialSet<'a> {
    let member = |&carries_plus_z: &bool| Member {
        carries_plus_z,
        ring: Box::new(RestingBearing { bearing, first_ball: 0.0 }) as _,
    };
    AxialSet { members: sides.iter().map(member).collect(), offsets: vec![0.0; sides.len()], spring: None }
}

/// F ~ z^1.5 as long as the contact angle does not change: the unloading force tends to 2^1.5 = 2.828 times the
/// preload from above as the preload falls.
#[test]
fn limit_unloading_force_is_2_83_times_a_small_preload() {
    let bearing = bearing();
    let mut before = f64::INFINITY;
    for (preload, within) in [(1000.0, 0.1), (10.0, 0.01), (0.1, 1e-3), (1e-3, 1e-4)] {
        let mut set = set(&bearing, &[true, false]);
        set.preload(preload).unwrap();
        assert!((set.preload_force().unwrap() / preload - 1.0).abs() < 1e-9);
        let [along, against] = set.unloading_forces().unwrap().map(Option::unwrap);
        assert!((along - against).abs() < 1e-9 * along);
        let ratio = along / preload / 8f64.sqrt() - 1.0;
        assert!(ratio > 0.0 && ratio < within && ratio < before, "{preload} N: {ratio}");
        before = ratio;
    }
}

/// At the unloading force one side carries nothing, and the other all.
#[test]
fn identity_state_at_the_unloading_force() {
    let bearing = bearing();
    let mut set = set(&bearing, &[true, true, false]);
    set.preload(400.0).unwrap();
    let [along, _] = set.unloading_forces().unwrap().map(Option::unwrap);
    let state = set.under(along).unwrap();
    assert!(state.forces[2] < 1e-6 * along && (state.forces[0] + state.forces[1] - along).abs() < 1e-9 * along);
    assert!((state.forces[0] - state.forces[1]).abs() < 1e-9 * along);
    let (more, less) = (set.under(along * 0.5 + 0.01).unwrap(), set.under(along * 0.5 - 0.01).unwrap());
    let between = set.under(along * 0.5).unwrap();
    let difference = 0.02 / (more.displacement - less.displacement);
    assert!((difference / between.stiffness - 1.0).abs() < 1e-5);
}

/// A shaft ten thousand times as stiff is a set: the same axial force on each bearing, and the same displacement.
#[test]
fn limit_stiff_shaft_is_a_set() {
    let bearing = bearing();
    for load in [0.0, 400.0, -1500.0] {
        let mut pair = set(&bearing, &[true, false]);
        pair.offsets.fill(5e-6);
        let expected = pair.under(load).unwrap();
        let mut system = system(&bearing, 211e13);
        system.loads = vec![[0.0; 5]; 9];
        system.loads[4][2] = load;
        let found = system.equilibrium().unwrap();
        let forces = found.reactions.iter().map(|reaction| reaction[2].abs());
        for (force, expected) in forces.zip(&expected.forces) {
            assert!((force - expected).abs() < 0.05, "{load} N: {force} {expected}");
        }
        assert!((found.nodes[4][2] - expected.displacement).abs() < 1e-9, "{load} N: {found:?}");
    }
}

/// A bearing pressed by the offset of a force carries it.
#[test]
fn identity_offset_of_a_force() {
    let bearing = bearing();
    let mut ring = RestingBearing { bearing: &bearing, first_ball: 0.7 };
    let offset = offset_for(&mut ring, 321.0).unwrap();
    let held = tribodyn_shaft::RingForce::at(&mut ring, &[0.0, 0.0, offset, 0.0, 0.0]).unwrap();
    assert!((held.force[2] - 321.0).abs() < 1e-8);
}

/// Tandem carries one direction only.
#[test]
fn limit_tandem_gives_no_resistance_the_other_way() {
    let bearing = bearing();
    let mut set = set(&bearing, &[true, true]);
    assert!(set.under(-100.0).is_err());
    assert!((set.under(100.0).unwrap().forces[0] - 50.0).abs() < 1e-8);
}

/// Bearings that are not preloaded just touch, and those in tandem count from there wherever their rings stand.
#[test]
fn limit_unloaded_bearings_just_touch() {
    let bearing = bearing();
    let mut pair = set(&bearing, &[true, false]);
    pair.preload(0.0).unwrap();
    assert!(pair.offsets.iter().all(|offset| offset.abs() < 1e-15), "{:?}", pair.offsets);
    let touching = set(&bearing, &[true, true]).under(1000.0).unwrap().displacement;
    for (offset, side) in [(0.0, true), (3e-6, true), (-3e-6, true), (3e-6, false), (-3e-6, false)] {
        let mut tandem = set(&bearing, &[side, side]);
        tandem.offsets.fill(offset);
        let sign = if side { 1.0 } else { -1.0 };
        let rest = tandem.unloaded().unwrap();
        assert!((rest.displacement + sign * offset).abs() < 1e-15, "{offset} {side}: {rest:?}");
        let moved = tandem.under(sign * 1000.0).unwrap().displacement - rest.displacement;
        assert!((moved - sign * touching).abs() < 1e-12, "{offset} {side}: {moved}");
    }
}

/// A force beyond all bearings is not taken for one that no bearing carries.
#[test]
fn limit_forces_that_are_too_large_are_named() {
    let bearing = bearing();
    let mut pair = set(&bearing, &[true, false]);
    assert!(matches!(pair.preload(1e12), Err(ShaftError::TooLarge { force: 1e12, .. })));
    assert!(matches!(pair.under(-1e12), Err(ShaftError::TooLarge { force: -1e12, .. })));
    assert!(matches!(set(&bearing, &[true, true]).under(-1.0), Err(ShaftError::Loose { .. })));
}
