//! The list of bearings, and the balls that their ratings tell.

use tribodyn_catalogue::{CatalogueError, ClearanceGroup, Envelope, KnownBalls, Origin, Ratings, find, listed, search};

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
    let (mut all, mut near, mut close, mut largest) = (0, 0, 0, 0.0f64);
    for bearing in listed() {
        let set = bearing.envelope.ball_set(KnownBalls::default(), bearing.ratings).unwrap();
        let Origin::Ratings { dynamic, at_rest, .. } = set.origin else { panic!("{}: {set:?}", bearing.designation) };
        let worst = dynamic.abs().max(at_rest.abs());
        assert!(worst < 0.05, "{}: {dynamic} {at_rest} {set:?}", bearing.designation);
        largest = largest.max(worst);
        all += 1;
        near += usize::from(worst < 0.02);
        close += usize::from(worst < 0.006);
    }
    println!("{close} and {near} of {all}, at most {largest}");
    assert!(all == 585 && near >= 550 && close >= 480, "{close} and {near} of {all}, at most {largest}");
}

/// Bearings grow with their bore within a series, and their dimensions are those of one series for all contact angles.
#[test]
fn identity_the_list_rises_within_each_series() {
    let all: Vec<_> = listed().collect();
    for (series, digits) in
        [("618", 5), ("619", 5), ("160", 5), ("60", 4), ("62", 4), ("63", 4), ("64", 4), ("60", 3), ("62", 3)]
            .into_iter()
            .chain([("70", 4), ("72", 4), ("73", 4), ("718", 5), ("719", 5)])
    {
        for letter in ["", "A", "AC", "B", "C"] {
            let size = |d: &str| d.find(char::is_alphabetic).unwrap_or(d.len());
            let of = |d: &str| d.starts_with(series) && size(d) == digits && &d[size(d)..] == letter;
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
        if let Some(same) = b.designation.strip_prefix('7').filter(|same| !same.starts_with("18")) {
            let deep = find(&format!("6{}", same.trim_end_matches(char::is_alphabetic)), None).unwrap().envelope;
            assert_eq!((deep.bore, deep.outside, deep.width), (bore, outside, width), "{}", b.designation);
        }
    }
}

#[test]
fn limit_designations_that_say_too_little_or_too_much_are_refused() {
    let message = |designation: &str, angle| find(designation, angle).unwrap_err().to_string();
    assert!(message("7210", None).contains("listed are 15°, 25°, 30°, 40°"), "{}", message("7210", None));
    assert!(message("7210B", Some(15.0)).contains("has 40°"));
    assert!(message("6206", Some(15.0)).contains("deep-groove"));
    assert!(message("6299", None).contains("6200 to 6240"));
    assert!(message("", None).contains("series 60"));
    // Another angle: the size without ratings.
    let other = find("7310", Some(25.0)).unwrap();
    assert_eq!((other.designation.as_str(), other.ratings), ("7310", None));
    assert!((other.envelope.contact_angle - 25f64.to_radians()).abs() < 1e-15);
    let letter = find("72 10-b", None).unwrap();
    let given = find("7210", Some(40.0)).unwrap();
    assert_eq!((letter.designation, letter.envelope), (given.designation, given.envelope));
}

#[test]
fn limit_balls_by_a_rule_of_thumb_where_there_are_no_ratings() {
    let angular = Envelope { bore: 0.05, outside: 0.09, width: 0.02, contact_angle: 40f64.to_radians() };
    let set = angular.ball_set(KnownBalls::default(), None).unwrap();
    assert_eq!((set.ball_count, set.origin), (16, Origin::Thumb));
    assert!((set.ball_diameter - 12e-3).abs() < 0.2e-3, "{set:?}");
    let deep = Envelope { contact_angle: 0.0, ..angular };
    let known = KnownBalls { ball_diameter: Some(12.7e-3), ..KnownBalls::default() };
    assert_eq!(deep.ball_set(known, None).unwrap().ball_count, 10);
    let both = KnownBalls { ball_diameter: Some(11e-3), ball_count: Some(12), published: None };
    assert_eq!(deep.ball_set(both, None).unwrap().origin, Origin::Given);
    let few = KnownBalls { ball_count: Some(14), ..KnownBalls::default() };
    let ratings = Some(Ratings { dynamic: 36_000.0, at_rest: 26_700.0 });
    assert_eq!(angular.ball_set(few, ratings).unwrap().ball_count, 14);
    let thin = Envelope { outside: 0.0501, ..angular };
    assert!(matches!(thin.ball_set(KnownBalls::default(), None), Err(CatalogueError::NoBalls { .. })));
}

#[test]
fn paper_clearances_of_iso_5753() {
    use ClearanceGroup::{C2, C3, C4, C5, Normal};
    for (group, bore, clearance) in [
        (Normal, 0.030, [5, 20]),
        (Normal, 0.035, [6, 20]),
        (Normal, 0.010, [2, 13]),
        (Normal, 0.050, [6, 23]),
        (C2, 0.020, [0, 10]),
        (C3, 0.030, [13, 28]),
        (C4, 0.100, [53, 84]),
        (C5, 0.060, [55, 90]),
        (C3, 0.008, [8, 23]),
        (C3, 0.200, [63, 117]),
    ] {
        assert_eq!(group.of_bore(bore).map(|c| (c * 1e6).round() as i32), clearance, "{group:?} {bore} m");
    }
}

/// Forty designations as catalogues, boxes and drawings have them: size of the list, contact angle (degrees), clearance
/// group, and whether the balls are ceramic.
#[test]
fn identity_designations_as_people_write_them() {
    for (written, size, angle, clearance, ceramic) in [
        ("6206-2RS C3", "6206", 0, Some("C3"), false),
        ("6206 2RS1/C3", "6206", 0, Some("C3"), false),
        ("62062RSC3", "6206", 0, Some("C3"), false),
        ("6205-2RSH/C3", "6205", 0, Some("C3"), false),
        ("6205ZZC3", "6205", 0, Some("C3"), false),
        ("6205-2Z/C3GJN", "6205", 0, Some("C3"), false),
        ("6203 DDU C3", "6203", 0, Some("C3"), false),
        ("6203LLUC3/2AS", "6203", 0, Some("C3"), false),
        ("SKF 6308", "6308", 0, None, false),
        ("FAG 6308-2RSR-C3", "6308", 0, Some("C3"), false),
        ("6310/C4S1", "6310", 0, Some("C4"), false),
        ("6312 M/C3", "6312", 0, Some("C3"), false),
        ("6208-2Z-C4-S1", "6208", 0, Some("C4"), false),
        ("6207 NR", "6207", 0, None, false),
        ("6305-C-2HRS-C3", "6305", 0, Some("C3"), false),
        ("6004 P5 C2", "6004", 0, Some("C2"), false),
        ("6010/P63", "6010", 0, Some("C3"), false),
        ("6204 TN9/HC5C3WT", "6204", 0, Some("C3"), true),
        ("6206 CN", "6206", 0, Some("CN"), false),
        ("608-2RS", "608", 0, None, false),
        ("608 ZZ", "608", 0, None, false),
        ("625-2Z", "625", 0, None, false),
        ("16008", "16008", 0, None, false),
        ("61804-2RZ", "61804", 0, None, false),
        ("6804ZZ", "61804", 0, None, false),
        ("6905 VV", "61905", 0, None, false),
        ("6407", "6407", 0, None, false),
        ("W 6204-2RS1", "6204", 0, None, false),
        ("7014CDGA/P4A", "7014C", 15, None, false),
        ("7006 ACD/P4ADGA", "7006AC", 25, None, false),
        ("71912 ACD/HCP4A", "71912AC", 25, None, true),
        ("B7014-C-T-P4S", "7014C", 15, None, false),
        ("B7014-E-T-P4S-UL", "7014AC", 25, None, false),
        ("HCB71908-C-TPA-P4-UL", "71908C", 15, None, true),
        ("7210 BECBP", "7210B", 40, None, false),
        ("7210BEP", "7210B", 40, None, false),
        ("7206-B-XL-JP", "7206B", 40, None, false),
        ("7204BW", "7204B", 40, None, false),
        ("7207CTYNDULP4", "7207C", 15, None, false),
        ("7920A5TYNSULP4", "71920AC", 25, None, false),
        ("7808C", "71808C", 15, None, false),
        ("72 10-b", "7210B", 40, None, false),
    ] {
        let found = find(written, None).unwrap_or_else(|error| panic!("{written}: {error}"));
        assert_eq!(found.designation, size, "{written}");
        assert_eq!(found.envelope.contact_angle.to_degrees().round() as i32, angle, "{written}");
        assert_eq!(
            (found.clearance.map(ClearanceGroup::symbol), found.ceramic_balls),
            (clearance, ceramic),
            "{written}"
        );
        assert!(found.ratings.is_some() && found.parts.iter().all(|part| !part.meaning.is_empty()), "{written}");
    }
}

/// Designations that are not understood, and bearings that the models do not hold for, are refused with what is allowed
/// or why.
#[test]
fn limit_designations_that_are_not_understood_are_refused() {
    for (written, parts) in [
        ("6206 garbage", ["`GARBAGE` after", "clearance (C2, CN, C3, C4, C5)"]),
        ("6206 C3 C4", ["`C4` after", "seals and shields"]),
        ("6206 C9", ["`9` after", "C5"]),
        ("6206/VA201", ["`201` after", "grease"]),
        ("7210 B C3", ["`C3` after", "the contact angle (C and CD 15°"]),
        ("XYZ 6206", ["`XYZ` before", "HCB"]),
        ("1206", ["self-aligning", "sphere"]),
        ("2308 K", ["self-aligning", "sphere"]),
        ("51104", ["thrust", "90°"]),
        ("51206", ["thrust", "45°"]),
        ("QJ 206", ["four-point", "two arcs"]),
        ("QJ306-N2-MPA", ["four-point", "four points"]),
        ("NU206", ["roller", "balls"]),
        ("30206", ["roller", "balls"]),
        ("3206 A", ["two rows", "tribodyn pair"]),
        ("7206 BDB", ["a set of bearings", "tribodyn pair"]),
        ("6241", ["6200", "6240"]),
        ("6299", ["no bearing `6299`", "6200 to 6240"]),
    ] {
        let message = find(written, None).unwrap_err().to_string();
        assert!(parts.iter().all(|part| message.contains(part)), "{written}: {message}");
    }
}

/// The ratios of the bearing data centre of Case Western Reserve University for 6205 and 6203, to the digits printed:
/// defects of outer and inner race, and both sides of a ball. Two of the eight contradict the others: the cage turns at
/// 1/Z of what the outer race sees, so that 3.5848 and 3.0530 make 0.39831 and 0.38163, where 0.39828 and 0.3817 are
/// printed; and outer and inner race add up to Z, so that with 4.9469 the outer one of 6203 is 3.0531.
#[test]
fn paper_the_defect_frequencies_of_the_cwru_bearings() {
    let ratios = |designation: &str| {
        let bearing = find(designation, None).unwrap();
        let known = KnownBalls { published: bearing.balls, ..KnownBalls::default() };
        let set = bearing.envelope.ball_set(known, bearing.ratings).unwrap();
        assert!(matches!(set.origin, Origin::Published { .. }));
        let (x, z) = (set.ball_diameter / set.pitch_diameter, set.ball_count as f64);
        [0.5 * (1.0 - x), 0.5 * z * (1.0 - x), 0.5 * z * (1.0 + x), (1.0 - x * x) / x]
    };
    let printed = |value: f64, digits: i32| (value * 10f64.powi(digits)).round() / 10f64.powi(digits);
    let [cage, outer, inner, ball] = ratios("6205");
    assert_eq!([printed(outer, 4), printed(inner, 4), printed(ball, 4)], [3.5848, 5.4152, 4.7135]);
    assert!((cage - 3.5848 / 9.0).abs() < 1e-5 && (cage - 0.39828).abs() < 4e-5, "{cage}");
    let [cage, outer, inner, ball] = ratios("6203");
    assert_eq!([printed(inner, 4), printed(ball, 4)], [4.9469, 3.9874]);
    assert!((outer - 3.0530).abs() < 1e-4 && (cage - 0.3817).abs() < 1e-4, "{outer} {cage}");
}

/// The published sets are those of the catalogue's ratings within a few percent.
#[test]
fn paper_published_balls_give_the_ratings_of_the_catalogue() {
    for designation in ["608", "6203", "6205", "6206"] {
        let bearing = find(designation, None).unwrap();
        let known = KnownBalls { published: bearing.balls, ..KnownBalls::default() };
        let rated = bearing.envelope.rated(&bearing.envelope.ball_set(known, bearing.ratings).unwrap());
        let listed = bearing.ratings.unwrap();
        let off = [rated.dynamic_rating().unwrap() / listed.dynamic, rated.static_rating().unwrap() / listed.at_rest];
        assert!(off.iter().all(|ratio| (ratio - 1.0).abs() < 0.03), "{designation}: {off:?}");
    }
}

#[test]
fn identity_the_list_is_searched_by_parts_and_patterns() {
    let names = |pattern: &str| search(pattern).into_iter().map(|b| b.designation).collect::<Vec<_>>();
    assert_eq!(names("7210"), ["7210C", "7210AC", "7210A", "7210B"]);
    assert_eq!(names("62*6"), ["626", "6206", "6216", "6226", "6236"]);
    assert_eq!(names("*b").len(), 64);
    assert_eq!(names("").len(), listed().count());
    assert!(names("99999").is_empty());
}

/// Fits of a new case: the class of the ring is that of the designation, and what is no class is refused.
#[test]
fn identity_fits_of_a_new_case() {
    use tribodyn_catalogue::{Fits, NewCase};
    let of = |written: &str, shaft: Option<&str>, housing: Option<&str>| {
        let fits = Fits { shaft: shaft.map(str::to_owned), housing: housing.map(str::to_owned) };
        NewCase { fits, ..NewCase::of_listed(find(written, None).unwrap(), written) }.text()
    };
    let text = of("7014CDGA/P4A", Some("js4"), None).unwrap();
    assert!(text.contains("class: \"js4\", ring: P4, within: Mean") && text.matches("seat: (").count() == 1, "{text}");
    let text = of("6206 C3", Some("k5"), Some("J6")).unwrap();
    assert!(text.contains("class: \"J6\", ring: Normal") && text.matches("seat: (").count() == 2);
    assert!(!of("6206", None, None).unwrap().contains("mounting: ("));
    for word in ["k5\"", "k 5", "", "k5,"] {
        let error = of("6206", Some(word), None).unwrap_err();
        assert!(matches!(error, CatalogueError::Fit { .. }) && error.to_string().contains("k5"), "{error}");
    }
}
