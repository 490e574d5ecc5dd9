//! Search for the values of cage and supports that the paper does not print: sets spread evenly over ranges, then about
//! the best of them. A set is judged by the rows that the search may see (`fixtures/identify/split.csv`): how many it
//! meets, then by how far off their numbers are. The best are run again by the Runge–Kutta method, and what they meet
//! there decides, as rows near a threshold hang on the scheme.

use crate::error::PaperError;
use crate::files;
use crate::progress::Progress;
use crate::transient::{AUTHORS, Change, Set};
use crate::validate::{Evidence, Verdict, declared_dynamic_rows};
use std::fmt::Write;

const RESULT: &str = "fixtures/expected/hidden-sets.csv";
/// The steps of the scheme that decides, those of the validation's runs with part of the load.
const DECIDING: &str = "RungeKutta4(step: us(5))";
/// Sets that go on to the next round, rounds, sets about each of them, and the width of the first round about a set as
/// a part of its range; each round is half as wide.
const BEST: usize = 12;
const ROUNDS: usize = 3;
const ABOUT: usize = 20;
const WIDTH: f64 = 0.25;
/// Sets that are run again.
const FINALISTS: usize = 20;
/// Largest square that a number's deviation over its tolerance counts with.
const CAP: f64 = 100.0;

/// A value that the paper hides: its path, how it is written, and its range, searched on a logarithmic scale.
struct Hidden {
    path: &'static str,
    text: fn(f64) -> String,
    range: [f64; 2],
}

const HIDDEN: [Hidden; 10] = [
    Hidden { path: "cage.pocket_gap", text: |v| format!("mm({v:.3})"), range: [0.05, 1.5] },
    Hidden { path: "cage.pocket_stiffness", text: |v| format!("N_per_um({v:.3})"), range: [0.5, 20.0] },
    Hidden { path: "cage.pocket_friction", text: |v| format!("{v:.3}"), range: [0.03, 0.3] },
    Hidden { path: "cage.pocket_damping", text: |v| format!("s_per_m({v:.3})"), range: [0.03, 3.0] },
    Hidden { path: "cage.inertia", text: |v| format!("kg_m2({v:.5})"), range: [0.001, 0.004] },
    Hidden { path: "supports.inner.mass", text: |v| format!("kg({v:.3})"), range: [2.0, 50.0] },
    Hidden { path: "supports.outer.mass", text: |v| format!("kg({v:.3})"), range: [2.0, 20.0] },
    Hidden {
        path: "supports.outer.stiffness",
        text: |v| format!("(N_per_um({v:.3}), N_per_um({v:.3}))"),
        range: [50.0, 5000.0],
    },
    Hidden {
        path: "supports.outer.damping",
        text: |v| format!("(N_s_per_m({v:.3}), N_s_per_m({v:.3}))"),
        range: [500.0, 50_000.0],
    },
    Hidden { path: "transient.contact_damping", text: |v| format!("{v:.4}"), range: [0.005, 0.1] },
];

/// Places in all ranges, from 0 to 1.
type Place = [f64; HIDDEN.len()];

/// A place of an evenly spread sequence (M. Roberts's, on powers of the root of x^(d+1) = x + 1).
fn even(n: usize) -> Place {
    let dimensions = HIDDEN.len() as i32;
    let root = (0..60).fold(1.5f64, |x, _| (1.0 + x).powf(1.0 / f64::from(dimensions + 1)));
    std::array::from_fn(|k| (0.5 + (n + 1) as f64 * root.powi(-(k as i32 + 1))).fract())
}

fn values(place: &Place) -> [String; HIDDEN.len()] {
    std::array::from_fn(|k| {
        let Hidden { text, range: [low, high], .. } = &HIDDEN[k];
        text(low * (high / low).powf(place[k]))
    })
}

/// A set that was tried.
#[derive(Debug, Clone)]
struct Tried {
    place: Place,
    score: Score,
}

/// Rows met, and the squares of the numbers' deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Score {
    met: usize,
    squares: f64,
}

impl Score {
    /// None where a run fails.
    fn of(place: &Place, scheme: Option<&str>) -> Option<Self> {
        let mut change = Change::none("hidden");
        for (hidden, value) in HIDDEN.iter().zip(values(place)) {
            change = change.with(hidden.path, &value);
        }
        if let Some(scheme) = scheme {
            change = change.with("transient.scheme", scheme);
        }
        let rows = declared_dynamic_rows(&Set::changed(&AUTHORS, &change).ok()?).ok()?;
        let seen = rows.iter().filter(|row| row.evidence == Evidence::Calibration);
        let square = |deviation: f64, tolerance: f64| (deviation / tolerance).powi(2).min(CAP);
        let mut score = Self { met: 0, squares: 0.0 };
        for row in seen {
            score.met += usize::from(row.verdict == Verdict::Met);
            score.squares += row.deviation.zip(row.tolerance).map_or(0.0, |(d, t)| square(d, t));
        }
        Some(score)
    }

    /// The better one first.
    fn order(&self, other: &Self) -> std::cmp::Ordering {
        other.met.cmp(&self.met).then(self.squares.total_cmp(&other.squares))
    }
}

/// Searches from so many sets and writes the best.
pub fn run(sets: usize, progress: Progress) -> Result<(), PaperError> {
    let mut tried = Vec::new();
    let mut count = 0;
    let mut attempt = |place: Place, tried: &mut Vec<Tried>| {
        tried.extend(Score::of(&place, None).map(|score| Tried { place, score }));
        tried.sort_by(|a, b| a.score.order(&b.score));
        count += 1;
        if count % 50 == 0 {
            progress(&format!("{count} sets, best {:?}", tried.first().map(|best| best.score)));
        }
    };
    (0..sets).for_each(|n| attempt(even(n), &mut tried));
    let mut next = sets;
    for round in 0..ROUNDS {
        let width = WIDTH * 0.5f64.powi(round as i32);
        for best in tried.iter().take(BEST).map(|best| best.place).collect::<Vec<_>>() {
            for n in next..next + ABOUT {
                let step = even(n);
                attempt(std::array::from_fn(|k| (best[k] + width * (step[k] - 0.5)).clamp(0.0, 1.0)), &mut tried);
            }
            next += ABOUT;
        }
    }
    let again = |best: &Tried| Some((best.clone(), Score::of(&best.place, Some(DECIDING))?));
    let mut decided: Vec<(Tried, Score)> = tried.iter().take(FINALISTS).filter_map(again).collect();
    decided.sort_by(|(a, first), (b, second)| first.order(second).then(a.score.order(&b.score)));
    let mut text = format!(
        "# our own output; rewritten by `cargo xtask sensitivity --part hidden`\n# the {FINALISTS} best of {count} \
        sets of what the paper hides: rows met of those that the search may see, and squares of the numbers among \
        them, by the scheme that decides and by the fast one\nmet,squares,met_fast,squares_fast"
    );
    HIDDEN.iter().for_each(|hidden| text.extend([",", hidden.path]));
    text.push('\n');
    for (Tried { place, score }, decided) in &decided {
        let _ = write!(text, "{},{:.2},{},{:.2}", decided.met, decided.squares, score.met, score.squares);
        values(place).iter().for_each(|value| text.extend([",", &value.replace(", ", " ")]));
        text.push('\n');
    }
    files::write(&files::root().join(RESULT), text.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_case::{Case, set_value};

    #[test]
    fn identity_places_are_spread_evenly() {
        for k in 0..HIDDEN.len() {
            let mut tenths = [0; 10];
            (0..800).for_each(|n| tenths[(10.0 * even(n)[k]) as usize] += 1);
            // Places by chance differ from 80 by 8 on the average, one of a hundred tenths by more than 20.
            assert!(tenths.iter().all(|count| (70..=90).contains(count)), "{k}: {tenths:?}");
        }
    }

    #[test]
    fn identity_every_place_is_a_case() {
        let text = files::read(&files::root().join(AUTHORS.ag)).unwrap();
        for place in [[0.0; HIDDEN.len()], [1.0; HIDDEN.len()], even(7)] {
            let pairs = HIDDEN.iter().zip(values(&place));
            let case = pairs.fold(text.clone(), |text, (hidden, value)| set_value(&text, hidden.path, &value).unwrap());
            Case::from_ron(&case).unwrap();
        }
    }
}
