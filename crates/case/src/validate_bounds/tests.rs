//! Bounds of values: refusals with what is allowed, and that each bound is of a value.

use super::*;

const OIL: &str = include_str!("../../../../fixtures/cases/oil-6206.ron");
const FULL: &str = include_str!("../../../../fixtures/cases/paper-ag-worn.ron");
const UNGUIDED: &str = include_str!("../../../../fixtures/cases/paper-ag.ron");
const FREE_CAGE: &str = "(mass: g(300), transverse_inertia: kg_m2(0.0011), unbalance: um(3), \
    gravity: (m_per_s2(9.81), m_per_s2(0), m_per_s2(0)), displacement: (um(9), um(-9)), \
    pockets: RaceTrack(axial_gap: mm(0.3)), lands: [(land: Outer, axial: mm(3), radius: mm(86), width: mm(6), \
    gap: mm(0.1), stiffness: N_per_um(5), damping: s_per_m(0.3), friction: 0.1, film: (viscosity: mPa_s(1), \
    density: kg_per_m3(770), fill: 0.8, extent: Half, roughness: um(2)))])";

/// With a kind of value in place of another one, so that all that a case can hold stands in one of them.
fn variants() -> Vec<String> {
    let tested = "Tested([(pressure: GPa(2.5), peak_slip: 1.0, peak_coefficient: 0.1, residual_coefficient: 0.08)])";
    let deviations = "(inner: (waves: [(order: 9, amplitude: um(0.2), phase: deg(10))]), \
                      outer: (spectrum: (first: 2, last: 9, amplitude: um(1), exponent: 1.5, seed: 1)), \
                      position: (ball: deg(3), inner: deg(4), outer: deg(5)))";
    let transfer =
        format!("(curve: {tested}, cover: um(0.1), loss: 0.3, wear: (coefficient: 1e-6, hardness: MPa(60)))");
    let changes: [&[(&str, &str)]; 6] = [
        &[],
        &[
            ("ring.x", "Held(um(3))"),
            ("ring.y", "ForceTable([(s(0), N(0)), (s(1), N(5))])"),
            ("ring.tilt_x", "Moment(Nm(1))"),
            ("ring.tilt_y", "MomentTable([(s(0), Nm(0))])"),
            ("speed.inner", "Table([(s(0), rpm(0)), (s(1), rpm(9000))])"),
            ("fluid.medium", "Custom(density: kg_per_m3(800), viscosity: mPa_s(1))"),
            ("transient.scheme", "Fast(step: us(5))"),
            ("deviations", deviations),
            ("spalls", "[(race: Outer, azimuth: deg(3), length: mm(1), width: mm(2), depth: um(50))]"),
        ],
        &[("traction.order", "0"), ("coatings.inner.curve", tested), ("coatings.bare.curve", tested)],
        &[("transient.scheme", "RungeKutta4(step: us(2))"), ("geometry.fit", "RadialClearance(um(40))")],
        &[
            ("ring.y", "Held(um(3))"),
            ("ring.z", "Held(um(3))"),
            ("cage.churning", "(bore: mm(150), outside: mm(180), width: mm(38))"),
        ],
        &[("traction.order", "0"), ("coatings.transfer", &transfer)],
    ];
    let change = |changes: &[(&str, &str)]| {
        changes.iter().fold(FULL.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap())
    };
    changes
        .iter()
        .map(|changes| change(changes))
        .chain([
            set_value(UNGUIDED, "cage.free", FREE_CAGE).unwrap(),
            set_value(OIL, "rating.fatigue_limit", "N(450)").unwrap(),
        ])
        .collect()
}

/// Ranges of the numbers in a value: not those in names and strings.
fn numbers(value: &str) -> Vec<std::ops::Range<usize>> {
    let bytes = value.as_bytes();
    let (mut found, mut at, mut quoted) = (Vec::new(), 0, false);
    while at < bytes.len() {
        let word = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'.' | b'-' | b'+');
        quoted ^= bytes[at] == b'"';
        let end = (at..bytes.len()).find(|&k| !word(bytes[k])).unwrap_or(bytes.len());
        if end > at && !quoted && value[at..end].parse::<f64>().is_ok() {
            found.push(at..end);
        }
        at = end.max(at + 1);
    }
    found
}

#[test]
fn limit_every_number_of_a_case_is_bounded() {
    let mut seen = 0;
    for text in variants() {
        Case::from_ron(&text).unwrap_or_else(|e| panic!("{e}"));
        for (path, range) in values(&text) {
            for number in numbers(&text[range.clone()]) {
                let at = range.start + number.start..range.start + number.end;
                let signed = ["1e300", "-1e300"];
                for absurd in signed {
                    // Whole numbers are written without an exponent.
                    let changed = [&text[..at.start], absurd, &text[at.end..]].concat();
                    let error = Case::from_ron(&changed).map(drop).expect_err(&format!("{path} = {absurd}"));
                    assert!(error.line > 1 && error.column >= 1 && !error.message.is_empty(), "{path}: {error}");
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 400, "{seen}");
}

#[test]
fn limit_an_absurd_value_is_refused_with_what_is_allowed() {
    let refused = |path: &str, value: &str| {
        let error = Case::from_ron(&set_value(FULL, path, value).unwrap()).unwrap_err();
        (error.to_string(), error.line, error.column)
    };
    let (message, line, column) = refused("supports.inner.mass", "kg(1e300)");
    assert!(message.starts_with("supports.inner.mass = kg(1e300): must lie between 1e-9 and 1e8 kg: "), "{message}");
    assert!(line > 50 && column > 10, "{line}:{column}");
    let (message, ..) = refused("fluid.drag_coefficient", "1e300");
    assert!(message.contains("must lie between 0 and 1000: "), "{message}");
    let (message, ..) = refused("supports.outer.damping", "(N_s_per_m(2), N_s_per_m(1e12))");
    assert!(message.contains("damping[1]") && message.contains("1e11 N s/m"), "{message}");
    let (message, ..) = refused("geometry.ball_count", "100000000");
    assert!(message.contains("at most 15 fit"), "{message}");
    let wide = set_value(UNGUIDED, "geometry.pitch_diameter", "m(40)").unwrap();
    let message = Case::from_ron(&set_value(&wide, "geometry.ball_count", "3000").unwrap()).unwrap_err().to_string();
    assert!(message.contains("must lie between 2 and 1000: "), "{message}");
}

#[test]
fn identity_each_bound_is_of_a_value_and_has_room() {
    let mut all = Values::default();
    for text in variants() {
        let case = Case::from_ron(&text).unwrap();
        all.steady(&case);
        all.loads(&case.ring, &case.speed);
        all.transient(&case);
    }
    for bound in BOUNDS {
        assert!(bound.range[0] < bound.range[1] && !bound.reason.is_empty(), "{}", bound.path);
        assert!(all.0.iter().any(|(path, _)| matches(bound.path, path)), "no value has the path {}", bound.path);
    }
    let unbounded: Vec<_> =
        all.0.iter().filter(|(path, _)| !BOUNDS.iter().any(|bound| matches(bound.path, path))).collect();
    // Speeds have their bound where they are checked.
    assert!(unbounded.iter().all(|(path, _)| path.starts_with("speed.")), "{unbounded:?}");
}
