//! The list of bearings, and the balls that their ratings tell.

use tribodyn_catalogue::{CatalogueError, Envelope, KnownBalls, Origin, Ratings, find, listed, normal_clearance};

/// Number and diameter, µm.
fn balls(designation: &str, angle: Option<f64>) -> (usize, u32) {
    let bearing = find(designation, angle).unwrap();
    let set = bearing.envelope.ball_set(KnownBalls::default(), bearing.ratings).unwrap();
    (set.ball_count, (set.ball_diameter * 1e6).round() as u32)
}

/// Ball sets that are published: 6203, 6205 (bearing data centre of Case Western Reserve University: 8 of 6.746 mm
/// and 9 of 7.94 mm); 6204, 6206, 7210 B as usually given.
#[test]
fn paper_ratings_tell_the_balls_of_known_bearings() {
    assert_eq!(balls("6203", None), (8, 6747));
    assert_eq!(balls("6204", None), (8, 7938));
    assert_eq!(balls("6205", None), (9, 7938));
    assert_eq!(balls("6206", None), (9, 9525));
    assert_eq!(balls("7210 B", None), (15, 12_700));
    assert_eq!(balls("7210", Some(40.0)), (15, 12_700));
}

/// Every bearing of the list has balls whose ratings by ISO 281 and ISO 76 are the catalogue's.
#[test]
fn paper_ratings_of_the_whole_list_come_out_of_standard_balls() {
    let (mut all, mut close, mut largest) = (0, 0, 0.0f64);
    for bearing in listed() {
        let set = bearing.envelope.ball_set(KnownBalls::default(), bearing.ratings).unwrap();
        let Origin::Ratings { dynamic, at_rest } = set.origin else { panic!("{}: {set:?}", bearing.designation) };
        let worst = dynamic.abs().max(at_rest.abs());
        assert!(worst < 0.02, "{}: {dynamic} {at_rest} {set:?}", bearing.designation);
        largest = largest.max(worst);
        all += 1;
        close += usize::from(worst < 0.006);
    }
    assert!(all == 161 && close >= 147, "{close} of {all}, at most {largest}");
}

/// Bearings grow with their bore within a series, and their dimensions are those of one series for all contact angles.
#[test]
fn identity_the_list_rises_within_each_series() {
    let all: Vec<_> = listed().collect();
    for series in ["60", "62", "63", "70", "72", "73"] {
        for letter in ["", "A", "B", "C"] {
            let of = |d: &str| d.starts_with(series) && d.trim_start_matches(char::is_numeric) == letter;
            let rows: Vec<_> = all.iter().filter(|b| of(&b.designation)).collect();
            for pair in rows.windows(2) {
                let (small, large) = (&pair[0].envelope, &pair[1].envelope);
                assert!(small.bore < large.bore && small.outside < large.outside && small.width <= large.width);
            }
        }
    }
    for b in &all {
        let Envelope { bore, outside, width, .. } = b.envelope;
        assert!(bore < outside && width < outside - bore, "{}", b.designation);
        if let Some(same) = b.designation.strip_prefix('7') {
            let deep = find(&format!("6{}", same.trim_end_matches(char::is_alphabetic)), None).unwrap().envelope;
            assert_eq!((deep.bore, deep.outside, deep.width), (bore, outside, width), "{}", b.designation);
        }
    }
}

#[test]
fn limit_designations_that_say_too_little_or_too_much_are_refused() {
    let message = |designation: &str, angle| find(designation, angle).unwrap_err().to_string();
    assert!(message("7210", None).contains("listed are 15°, 30°, 40°"), "{}", message("7210", None));
    assert!(message("7210B", Some(15.0)).contains("has 40°"));
    assert!(message("6206", Some(15.0)).contains("deep-groove"));
    assert!(message("6299", None).contains("6200 to 6220"));
    assert!(message("NU206", None).contains("series 60"));
    assert!(message("", None).contains("series 60"));
    // Another angle: the size without ratings.
    let other = find("7210", Some(25.0)).unwrap();
    assert_eq!((other.designation.as_str(), other.ratings), ("7210", None));
    assert!((other.envelope.contact_angle - 25f64.to_radians()).abs() < 1e-15);
    assert_eq!(find("72 10-b", None).unwrap(), find("7210", Some(40.0)).unwrap());
}

#[test]
fn limit_balls_by_a_rule_of_thumb_where_there_are_no_ratings() {
    let angular = Envelope { bore: 0.05, outside: 0.09, width: 0.02, contact_angle: 40f64.to_radians() };
    let set = angular.ball_set(KnownBalls::default(), None).unwrap();
    assert_eq!((set.ball_count, set.origin), (16, Origin::Thumb));
    assert!((set.ball_diameter - 12e-3).abs() < 0.2e-3, "{set:?}");
    let deep = Envelope { contact_angle: 0.0, ..angular };
    let known = KnownBalls { ball_diameter: Some(12.7e-3), ball_count: None };
    assert_eq!(deep.ball_set(known, None).unwrap().ball_count, 10);
    let both = KnownBalls { ball_diameter: Some(11e-3), ball_count: Some(12) };
    assert_eq!(deep.ball_set(both, None).unwrap().origin, Origin::Given);
    let few = KnownBalls { ball_count: Some(14), ball_diameter: None };
    let ratings = Some(Ratings { dynamic: 36_000.0, at_rest: 26_700.0 });
    assert_eq!(angular.ball_set(few, ratings).unwrap().ball_count, 14);
    let thin = Envelope { outside: 0.0501, ..angular };
    assert!(matches!(thin.ball_set(KnownBalls::default(), None), Err(CatalogueError::NoBalls { .. })));
}

#[test]
fn paper_normal_clearances_of_iso_5753() {
    for (bore, clearance) in [(0.030, [5, 20]), (0.035, [6, 20]), (0.010, [2, 13]), (0.050, [6, 23])] {
        assert_eq!(normal_clearance(bore).map(|c| (c * 1e6).round() as i32), clearance, "{bore} m");
    }
}
