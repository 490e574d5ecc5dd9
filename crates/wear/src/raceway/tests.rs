//! Raceways against limits and conservation of volume.

use super::*;
use proptest::prelude::*;

const COATING: f64 = 10e-6;
const RADIUS: f64 = 0.068;
const PIT: Defect = Defect { azimuth: 1.0, width: 0.2, depth: 3e-5, bare: 0.7 };
const SPOT: Defect = Defect { azimuth: 6.25, width: 0.5, depth: 0.0, bare: 1.0 };

fn coated(worn: f64, defects: &[Defect]) -> Raceway {
    Raceway::new(COATING, worn, RADIUS, defects).unwrap()
}

/// A raceway worn all over, most between 2 and 3 rad, with a pit and a bare spot.
fn worn() -> Raceway {
    let mut raceway = coated(0.1, &[PIT, SPOT]);
    for i in 0..5000u32 {
        let azimuth = 0.0137 * f64::from(i);
        let volume = if (2.0..3.0).contains(&azimuth.rem_euclid(TAU)) { 6e-13 } else { 1e-13 };
        raceway.remove(azimuth, volume, 2e-3);
    }
    raceway
}

#[test]
fn limit_new_raceway_is_pristine_everywhere() {
    let raceway = coated(0.0, &[]);
    assert!(raceway.is_pristine() && raceway.worn_through().is_none());
    assert_eq!(raceway.at(-17.0), LocalSurface::NEW);
    assert_eq!((raceway.thinnest(), raceway.volume(), raceway.mean_depth()), (COATING, 0.0, 0.0));
    assert!(!coated(0.1, &[]).is_pristine() && !coated(0.0, &[PIT]).is_pristine());
    // What is not pristine, but worn by next to nothing, is as good as new.
    let mut touched = coated(0.0, &[]);
    touched.remove(2.0, 1e-30, 2e-3);
    assert!(!touched.is_pristine() && touched.at(2.0).depth < 1e-20 && touched.at(2.0).bare == 0.0);
}

#[test]
fn limit_even_wear_has_no_slope_and_bares_the_steel_from_two_thirds_on() {
    for (part, bare) in [(0.0, 0.0), (0.5, 0.0), (2.0 / 3.0, 0.0), (5.0 / 6.0, 0.5), (1.0, 1.0)] {
        let raceway = coated(part, &[]);
        let here = raceway.at(0.3);
        assert!((here.depth - part * COATING).abs() < 1e-20 && here.slope == 0.0);
        assert!((here.bare - bare).abs() < 1e-12, "{part}: {}", here.bare);
        assert!((raceway.thinnest() - (1.0 - part) * COATING).abs() < 1e-20);
        assert_eq!(raceway.worn_through().is_some(), part == 1.0);
    }
}

#[test]
fn limit_race_without_coating_gets_deeper_and_never_bare() {
    let mut raceway = Raceway::new(0.0, 0.0, RADIUS, &[]).unwrap();
    raceway.remove(1.0, 1e-9, 1e-3);
    assert!(raceway.at(1.0).depth > 1e-6 && raceway.at(1.0).bare == 0.0);
    assert_eq!((raceway.worn_through(), raceway.thinnest()), (None, 0.0));
}

#[test]
fn limit_wear_goes_on_in_steel() {
    let mut raceway = coated(0.99, &[]);
    raceway.remove(3.0, 1e-9, 2e-3);
    let here = raceway.at(3.0);
    assert!(here.depth > COATING && here.bare == 1.0);
    assert_eq!((raceway.thickness_at(3.0), raceway.thinnest()), (0.0, 0.0));
    let through = raceway.worn_through().unwrap();
    assert!((through - 3.0).abs() < TAU / BINS as f64, "{through}");
    assert!(raceway.at(0.0).bare < 1.0 && raceway.thickness_at(0.0) > 0.0);
}

/// The volume of the trough, 2a R ∫ d dφ by many points, is what was removed.
#[test]
fn identity_volume_removed_is_the_volume_of_the_trough() {
    let mut raceway = coated(0.0, &[]);
    let mut total = 0.0;
    for i in 0..20_000u32 {
        let volume = 1e-15 * (1.0 + f64::from(i % 7));
        raceway.remove(-0.31 * f64::from(i), volume, 1.7e-3);
        total += volume;
    }
    assert!((raceway.volume() / total - 1.0).abs() < 1e-12);
    let track = 2.0 * 1.7e-3 * RADIUS * TAU;
    assert!((raceway.mean_depth() * track / total - 1.0).abs() < 1e-12);
    // Two-point Gauss in each bin is exact for the spline's parabolas.
    let gauss = 0.5 / 3f64.sqrt();
    let depths = (0..BINS).flat_map(|k| [0.5 - gauss, 0.5 + gauss].map(|t| (k as f64 + t) * TAU / BINS as f64));
    let mean = depths.map(|azimuth| raceway.at(azimuth).depth).sum::<f64>() / (2 * BINS) as f64;
    assert!((mean * track / total - 1.0).abs() < 1e-12);
}

#[test]
fn identity_depth_of_one_removal_is_volume_over_track_and_arc() {
    let mut raceway = coated(0.0, &[]);
    let middle = 40.5 * TAU / BINS as f64;
    raceway.remove(middle, 1e-12, 2e-3);
    // In the middle of a bin the spline has 6/8 of it and 1/8 of its neighbours, at both ends: (6² + 1 + 1)/8².
    let depth = 1e-12 / (4e-3 * RADIUS * TAU / BINS as f64);
    assert!((raceway.at(middle).depth / depth - 38.0 / 64.0).abs() < 1e-12);
    assert_eq!(raceway.deepest(), middle);
    for nothing in [0.0, -1.0, f64::NAN] {
        let before = raceway.clone();
        raceway.remove(1.0, nothing, 2e-3);
        raceway.remove(1.0, 1e-12, nothing);
        assert_eq!(raceway, before);
    }
}

proptest! {
    #[test]
    fn identity_slope_is_the_derivative_of_depth(azimuth in -20.0..20.0f64) {
        let (raceway, step) = (worn(), 1e-6);
        let [before, here, after] = [-step, 0.0, step].map(|d| raceway.at(azimuth + d));
        let difference = (after.depth - before.depth) / (2.0 * step);
        // The second derivative jumps at the edges of bins and defects: half a jump times the step is left there.
        prop_assert!((difference - here.slope).abs() < 1e-7, "{} {}", difference, here.slope);
        prop_assert!((after.bare - before.bare).abs() < 1e-3);
        prop_assert!((0.0..=1.0).contains(&here.bare) && here.depth > 0.0);
    }

    #[test]
    fn identity_turns_do_not_matter(azimuth in 0.0..TAU, turns in -1000i32..1000) {
        let raceway = worn();
        let (here, there) = (raceway.at(azimuth), raceway.at(azimuth + f64::from(turns) * TAU));
        prop_assert!((here.depth - there.depth).abs() < 1e-14);
        prop_assert!((here.slope - there.slope).abs() < 1e-13 && (here.bare - there.bare).abs() < 1e-9);
    }
}

#[test]
fn identity_depth_and_slope_have_no_step_at_edges_of_bins_and_at_the_full_turn() {
    let raceway = worn();
    for k in 0..=BINS {
        let edge = k as f64 * TAU / BINS as f64;
        let (below, above) = (raceway.at(edge - 1e-12), raceway.at(edge + 1e-12));
        assert!((below.depth - above.depth).abs() < 1e-15 && (below.slope - above.slope).abs() < 1e-12, "{k}");
    }
}

#[test]
fn identity_defects_add_depth_and_take_their_part_of_what_wear_left() {
    let mut plain = coated(0.8, &[]);
    let mut pitted = coated(0.8, &[PIT, SPOT]);
    for raceway in [&mut plain, &mut pitted] {
        raceway.remove(1.0, 1e-13, 2e-3);
    }
    let (a, b) = (plain.at(1.0), pitted.at(1.0));
    assert!((b.depth - a.depth - PIT.depth).abs() < 1e-18 && a.bare > 0.0);
    assert!((1.0 - b.bare - (1.0 - a.bare) * 0.3).abs() < 1e-12);
    assert_eq!((pitted.at(6.25).bare, pitted.at(3.0)), (1.0, plain.at(3.0)));
    // The bare spot reaches over the full turn.
    assert!((pitted.at(0.0).bare - 1.0).abs() < 1e-12 && pitted.thinnest() == plain.thinnest());
}

#[test]
fn identity_profile_is_the_raceway_at_its_bins() {
    let raceway = worn();
    let points: Vec<ProfilePoint> = raceway.profile().collect();
    assert_eq!(points.len(), BINS);
    let thinnest = points.iter().map(|p| p.thickness).fold(f64::INFINITY, f64::min);
    assert_eq!(thinnest, raceway.thinnest());
    assert!(points.iter().all(|p| p.bare == raceway.at(p.azimuth).bare && p.depth == raceway.at(p.azimuth).depth));
}

#[test]
fn identity_stored_raceway_is_the_same_and_damaged_ones_are_refused() {
    let raceway = worn();
    let text = serde_json::to_string(&raceway).unwrap();
    let back: Raceway = serde_json::from_str(&text).unwrap();
    // Decimal numbers may lose the last bit, according to how the reader was built.
    assert!((0..700).map(f64::from).all(|k| (back.at(0.009 * k).depth - raceway.at(0.009 * k).depth).abs() < 1e-19));
    assert_eq!(back.defects, raceway.defects);
    type Damage = fn(&mut serde_json::Value);
    let damages: [Damage; 6] = [
        |stored| stored["thickness"] = (-1e-5).into(),
        |stored| stored["radius"] = 0.0.into(),
        |stored| stored["depth"][7] = (-1.0).into(),
        |stored| stored["depth"] = vec![0.0; BINS + 1].into(),
        |stored| stored["volume"] = (-1.0).into(),
        |stored| stored["defects"][0]["width"] = 7.0.into(),
    ];
    let stored: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(serde_json::from_value::<Raceway>(stored.clone()).is_ok());
    for (i, damage) in damages.iter().enumerate() {
        let mut damaged = stored.clone();
        damage(&mut damaged);
        assert!(serde_json::from_value::<Raceway>(damaged).is_err(), "{i}");
    }
}

#[test]
fn limit_values_that_no_raceway_has_are_refused() {
    let make = |thickness, worn, radius| Raceway::new(thickness, worn, radius, &[]).unwrap_err();
    assert!(matches!(make(-1e-6, 0.0, RADIUS), WearError::Thickness { .. }));
    assert!(matches!(make(f64::NAN, 0.0, RADIUS), WearError::Thickness { .. }));
    assert!(matches!(make(COATING, 1.01, RADIUS), WearError::Fraction { .. }));
    assert!(matches!(make(COATING, 0.0, 0.0), WearError::Length { .. }));
    let error = Raceway::new(COATING, 0.0, RADIUS, &[PIT, Defect { bare: 2.0, ..PIT }]).unwrap_err();
    assert_eq!(error.to_string(), "bare of a defect is 2: allowed is 0 to 1");
}
