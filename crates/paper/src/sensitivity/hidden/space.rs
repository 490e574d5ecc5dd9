//! Values of cage and supports that the paper does not print, their ranges, and places in these; and the axis about
//! which it lets its rings turn, which it does not say either.

/// A value that the paper hides: its path, how it is written, and its range, searched on a logarithmic scale.
struct Hidden {
    path: &'static str,
    text: fn(f64) -> String,
    range: [f64; 2],
}

/// The least torque on the cage and the least stiffness under the inner ring are as good as none.
const HIDDEN: [Hidden; DIMENSIONS] = [
    Hidden { path: "cage.pocket_gap", text: |v| format!("mm({v:.3})"), range: [0.05, 1.5] },
    Hidden { path: "cage.pocket_stiffness", text: |v| format!("N_per_um({v:.3})"), range: [0.5, 20.0] },
    Hidden { path: "cage.pocket_friction", text: |v| format!("{v:.3}"), range: [0.03, 0.3] },
    Hidden { path: "cage.pocket_damping", text: |v| format!("s_per_m({v:.3})"), range: [0.03, 3.0] },
    Hidden { path: "cage.inertia", text: |v| format!("kg_m2({v:.5})"), range: [0.001, 0.006] },
    Hidden { path: "cage.drag_torque", text: |v| format!("Nm({v:.3})"), range: [0.05, 10.0] },
    Hidden { path: "supports.inner.mass", text: |v| format!("kg({v:.3})"), range: [2.0, 50.0] },
    Hidden { path: "supports.inner.stiffness", text: |v| each("N_per_um", v, 3), range: [1.0, 500.0] },
    Hidden { path: "supports.inner.damping", text: |v| each("N_s_per_m", v, 3), range: [200.0, 20_000.0] },
    Hidden { path: "supports.outer.mass", text: |v| format!("kg({v:.3})"), range: [2.0, 20.0] },
    Hidden { path: "supports.outer.stiffness", text: |v| each("N_per_um", v, 2), range: [50.0, 5000.0] },
    Hidden { path: "supports.outer.damping", text: |v| each("N_s_per_m", v, 2), range: [500.0, 50_000.0] },
    Hidden { path: "transient.contact_damping", text: |v| format!("{v:.4}"), range: [0.005, 0.1] },
    Hidden { path: "modelling.ring_centre", text: ring_centre, range: [1.0, 4.0] },
];

pub const DIMENSIONS: usize = 14;

/// A place in all ranges, from 0 to 1 in each.
pub type Place = [f64; DIMENSIONS];

/// One reading in either half of the range.
fn ring_centre(value: f64) -> String {
    if value < 2.0 { "Displaced" } else { "Inertial" }.to_owned()
}

/// A value along each of so many axes.
fn each(unit: &str, value: f64, axes: usize) -> String {
    format!("({})", vec![format!("{unit}({value:.3})"); axes].join(", "))
}

/// Their square roots are far from all simple fractions; powers of one number, as M. Roberts has them, are not in so
/// many dimensions.
const PRIMES: [u8; DIMENSIONS] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43];

/// A place of an evenly spread sequence: multiples of the square roots of prime numbers (R. D. Richtmyer's).
pub fn even(n: usize) -> Place {
    PRIMES.map(|prime| root(n, prime))
}

/// One number of the sequence.
pub fn root(n: usize, prime: u8) -> f64 {
    (0.5 + (n + 1) as f64 * f64::from(prime).sqrt()).fract()
}

/// Paths, and the values at a place.
pub fn changes(place: &Place) -> [(String, String); DIMENSIONS] {
    std::array::from_fn(|k| {
        let Hidden { path, text, range: [low, high] } = &HIDDEN[k];
        ((*path).to_owned(), text(low * (high / low).powf(place[k])))
    })
}

/// The place of values as [`changes`] writes them, those that are not given in the middle of the first half: the first
/// of two readings. None where a value is no number of its range.
pub fn place(value: impl Fn(&str) -> Option<String>) -> Option<Place> {
    let mut place = [0.25; DIMENSIONS];
    for (at, Hidden { path, range: [low, high], .. }) in place.iter_mut().zip(&HIDDEN) {
        let Some(text) = value(path) else { continue };
        if text == ring_centre(*low) || text == ring_centre(*high) {
            *at = if text == ring_centre(*low) { 0.25 } else { 0.75 };
            continue;
        }
        let number: f64 = text.rsplit('(').next()?.trim_end_matches(')').parse().ok()?;
        *at = (number / low).ln() / (high / low).ln();
        if !(0.0..=1.0).contains(at) {
            return None;
        }
    }
    Some(place)
}

/// Nearer to an end of its range than this part of it, a value is at its bound.
const AT_END: f64 = 0.05;

/// Paths of values that lie at an end of their ranges; a reading has none.
pub fn at_ends(place: &Place) -> impl Iterator<Item = &'static str> {
    let values = HIDDEN.iter().zip(place).filter(|(hidden, _)| hidden.path != "modelling.ring_centre");
    values.filter(|(_, at)| **at < AT_END || **at > 1.0 - AT_END).map(|(hidden, _)| hidden.path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files;
    use crate::transient::{AUTHORS, CLASSICAL};
    use tribodyn_case::{Case, set_value};

    #[test]
    fn identity_places_are_spread_evenly() {
        for k in 0..DIMENSIONS {
            let mut tenths = [0; 10];
            (0..800).for_each(|n| tenths[(10.0 * even(n)[k]) as usize] += 1);
            // Places by chance differ from 80 by 8 on the average, one of a hundred tenths by more than 20.
            assert!(tenths.iter().all(|count| (70..=90).contains(count)), "{k}: {tenths:?}");
        }
    }

    #[test]
    fn identity_every_place_is_a_case_of_each_reading() {
        for reading in [AUTHORS, CLASSICAL] {
            let text = files::read(&files::root().join(reading.ag)).unwrap();
            for place in [[0.0; DIMENSIONS], [1.0; DIMENSIONS], even(7)] {
                let set = |text: String, (path, value): (String, String)| set_value(&text, &path, &value).unwrap();
                Case::from_ron(&changes(&place).into_iter().fold(text.clone(), set)).unwrap();
            }
        }
    }

    #[test]
    fn identity_a_place_comes_back_from_its_values() {
        for n in 0..20 {
            let at = even(n);
            let written = changes(&at);
            let value = |path: &str| written.iter().find(|(p, _)| p == path).map(|(_, value)| value.replace(", ", " "));
            let back = super::place(value).unwrap();
            assert_eq!(changes(&back), written);
        }
        assert_eq!(super::place(|_| None), Some([0.25; DIMENSIONS]));
        assert_eq!(super::place(|path| (path == "cage.pocket_gap").then(|| "mm(9)".to_owned())), None);
    }

    #[test]
    fn limit_only_ends_of_ranges_are_told() {
        let mut place = [0.5; DIMENSIONS];
        assert_eq!(at_ends(&place).count(), 0);
        (place[0], place[1], place[12], place[13]) = (0.0, 0.06, 0.97, 1.0);
        assert_eq!(at_ends(&place).collect::<Vec<_>>(), ["cage.pocket_gap", "transient.contact_damping"]);
    }
}
