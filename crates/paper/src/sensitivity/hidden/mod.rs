//! Search for the values of cage and supports that the paper does not print: sets spread evenly over ranges, then about
//! the best of them. A set is judged by the dynamic rows that the search may see (`fixtures/identify/split.csv`): how
//! many it meets, and how near it is to all. Rows near a threshold hang on the scheme, so a set counts for what it
//! meets at the worse of two steps. The best without a value at an end of its range are run again with the steps of the
//! validation, and what they meet there decides. The rows that are kept out are counted after that.

mod score;
mod space;

use crate::error::PaperError;
use crate::files;
use crate::progress::{Progress, in_time};
use crate::table::{Row, Table};
use crate::transient::{AUTHORS, CLASSICAL, Change, FAST, Reading, Set, on_all_cores};
use crate::validate::{Counts, counted, declared_dynamic_rows};
use score::Score;
use space::{DIMENSIONS, Place, at_ends, place};
pub use space::{changes, even, root};
use std::fmt::Write;
use std::str::FromStr;

/// Sets that go on to the next round, rounds, sets about each of them, the width of the first round about a set as a
/// part of its range, and that of each round as a part of the one before.
const BEST: usize = 16;
const ROUNDS: usize = 8;
const ABOUT: usize = 16;
const WIDTH: f64 = 0.5;
const NARROWER: f64 = 0.75;
/// Least distance between sets that go on, as a part of the width: children of one set, of which about half of the
/// values move by up to half of the width, lie nearer to each other, and would soon be all that goes on.
const APART: f64 = 0.3;
/// Steps of the fast scheme by which a set is judged.
const STEPS: [&str; 2] = [FAST, "Fast(step: us(10))"];
/// Sets that are run again, and the least distance between them.
const FINALISTS: usize = 20;
const FINALISTS_APART: f64 = 0.05;

/// A reading of the paper's models whose hidden values are searched for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Searched {
    /// The one with the most evidence.
    Authors,
    /// The gyroscopic moment at the outer race.
    Classical,
}

impl Searched {
    fn reading(self) -> &'static Reading {
        match self {
            Self::Authors => &AUTHORS,
            Self::Classical => &CLASSICAL,
        }
    }

    fn result(self) -> &'static str {
        match self {
            Self::Authors => "fixtures/expected/hidden-sets.csv",
            Self::Classical => "fixtures/expected/hidden-sets-classical.csv",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Authors => "authors",
            Self::Classical => "classical",
        }
    }
}

impl FromStr for Searched {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let named = [Self::Authors, Self::Classical].into_iter().find(|searched| searched.name() == text);
        named.ok_or_else(|| "allowed are authors and classical".to_owned())
    }
}

/// A set that was tried.
#[derive(Debug, Clone)]
struct Tried {
    place: Place,
    score: Score,
}

/// A set that was run again.
struct Decided {
    tried: Tried,
    score: Score,
    counts: Counts,
}

/// Searches from so many sets and writes the best.
pub fn run(searched: Searched, sets: usize, progress: Progress) -> Result<(), PaperError> {
    let reading = searched.reading();
    let (tried, count) = search(sets, &before(searched)?, &|place| fast(reading, place), progress)?;
    let within: Vec<Tried> = tried.into_iter().filter(|tried| at_ends(&tried.place).next().is_none()).collect();
    let mut decided = Vec::new();
    for tried in apart(&within, FINALISTS, FINALISTS_APART) {
        let again = in_time("finalist", progress, || counted(reading, &changes(&tried.place)));
        let Ok((counts, rows)) = again else { continue };
        let score = Score::of(&rows)?;
        progress(&format!("{score:?}, {counts:?}"));
        decided.push(Decided { tried: tried.clone(), score, counts });
    }
    decided.sort_by(|a, b| a.score.decide(&b.score).then(a.tried.score.decide(&b.tried.score)));
    files::write(&files::root().join(searched.result()), text(searched, count, &decided).as_bytes())
}

/// The sets of the result as it stands, which the search goes on from too.
fn before(searched: Searched) -> Result<Vec<Place>, PaperError> {
    let path = files::root().join(searched.result());
    let table = Table::read(searched.result(), &files::read(&path)?)?;
    let given = |row: &Row<'_>, path: &str| row.text(path).ok().map(str::to_owned);
    Ok(table.rows().filter_map(|row| place(|path| given(&row, path))).collect())
}

/// The worse score of both steps; none where a run fails.
fn fast(reading: &Reading, place: &Place) -> Result<Option<Score>, PaperError> {
    let mut worst: Option<Score> = None;
    for step in STEPS {
        let change = Change { values: changes(place).to_vec(), ..Change::none("hidden") };
        let Ok(set) = Set::changed(reading, &change.with("transient.scheme", step)) else { return Ok(None) };
        let score = Score::of(&declared_dynamic_rows(&set)?)?;
        worst = Some(worst.map_or(score, |other| other.worse(&score)));
    }
    Ok(worst)
}

/// The sets whose runs do not fail, the leading one first, and how many were tried.
fn search(
    sets: usize,
    before: &[Place],
    score: &(impl Fn(&Place) -> Result<Option<Score>, PaperError> + Sync),
    progress: Progress,
) -> Result<(Vec<Tried>, usize), PaperError> {
    let mut tried: Vec<Tried> = Vec::new();
    let mut count = 0;
    let mut attempt = |places: &[Place], tried: &mut Vec<Tried>| {
        for part in places.chunks(50) {
            for (place, score) in part.iter().zip(on_all_cores(part.len(), |k| score(&part[k]))) {
                tried.extend(score?.map(|score| Tried { place: *place, score }));
            }
            tried.sort_by(|a, b| a.score.lead(&b.score));
            count += part.len();
            progress(&format!("{count} sets, best {:?}", tried.first().map(|best| best.score)));
        }
        Ok::<(), PaperError>(())
    };
    attempt(&before.iter().copied().chain((0..sets).map(even)).collect::<Vec<_>>(), &mut tried)?;
    let mut next = sets;
    for round in 0..ROUNDS {
        let width = WIDTH * NARROWER.powi(round as i32);
        let about = |(k, best): (usize, &Tried)| {
            let from = next + k * ABOUT;
            (from..from + ABOUT).map(|n| beside(&best.place, n, width)).collect::<Vec<_>>()
        };
        let leading = apart(&tried, BEST, APART * width);
        let places: Vec<Place> = leading.into_iter().enumerate().flat_map(about).collect();
        next += places.len();
        attempt(&places, &mut tried)?;
    }
    Ok((tried, count))
}

/// The first of sets with at least a distance from each other, so many or fewer.
fn apart(tried: &[Tried], most: usize, distance: f64) -> Vec<&Tried> {
    let between =
        |a: &Place, b: &Place| (a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / DIMENSIONS as f64).sqrt();
    let mut out: Vec<&Tried> = Vec::new();
    for next in tried {
        if out.len() < most && out.iter().all(|taken| between(&taken.place, &next.place) >= distance) {
            out.push(next);
        }
    }
    out
}

/// A place about another, with about half of its values as they were: some rows hang on few of them.
fn beside(place: &Place, n: usize, width: f64) -> Place {
    let step = even(n);
    // Multiplied by 2^64 over the golden ratio, the upper bits of neighbouring numbers differ.
    let kept = (n as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> (64 - DIMENSIONS);
    std::array::from_fn(|k| match kept >> k & 1 {
        1 => place[k],
        _ => (place[k] + width * (step[k] - 0.5)).clamp(0.0, 1.0),
    })
}

/// The result: a set on each line.
fn text(searched: Searched, count: usize, decided: &[Decided]) -> String {
    let mut text = format!(
        "# our own output; rewritten by `cargo xtask sensitivity --part hidden --reading {}`\n# the {} best of \
        {count} sets of what the paper hides, none with a value at an end of its range: dynamic rows met of the 17 \
        that the search may see, and how near all of them are, by the steps of the validation and at the worse of two \
        steps of the fast scheme\n# counted after the order was made: rows met of the 27 and the 28 of Figures 13 to \
        24 that the search may and may not see, of all 55, and of the 20 of Tables 4 and 5\n\
        met,near,met_fast,near_fast,calibration,validation,figures,tables",
        searched.name(),
        decided.len()
    );
    changes(&even(0)).iter().for_each(|(path, _)| text.extend([",", path.as_str()]));
    text.push('\n');
    for Decided { tried, score, counts } in decided {
        let fast = tried.score;
        let _ = write!(text, "{},{:.2},{},{:.2}", score.met, score.near, fast.met, fast.near);
        let Counts { calibration, validation, tables } = counts;
        let _ = write!(text, ",{calibration},{validation},{},{tables}", calibration + validation);
        changes(&tried.place).iter().for_each(|(_, value)| text.extend([",", &value.replace(", ", " ")]));
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_the_search_comes_near_a_place_that_it_does_not_know() {
        let goal = even(100_003);
        let score = |place: &Place| {
            let squares: f64 = place.iter().zip(goal).map(|(a, b)| (a - b).powi(2)).sum();
            // Sets of a corner fail.
            Ok((place[0] < 0.9).then_some(Score { met: 0, near: -squares }))
        };
        let first = (0..300).map(even).filter_map(|place| score(&place).unwrap()).map(|s| s.near).fold(-9.0, f64::max);
        let (tried, count) = search(300, &[], &score, &|_| ()).unwrap();
        assert_eq!(count, 300 + ROUNDS * BEST * ABOUT);
        assert!(tried.len() < count && tried.iter().all(|tried| tried.place[0] < 0.9));
        assert!(tried[0].score.near > 0.2 * first, "{first} to {}", tried[0].score.near);
    }

    #[test]
    fn limit_sets_that_go_on_are_apart() {
        let set = |near: f64, at: f64| Tried { place: [at; DIMENSIONS], score: Score { met: 0, near } };
        let tried = [set(4.0, 0.5), set(3.0, 0.54), set(2.0, 0.6), set(1.0, 0.9)];
        let near = |most, distance| apart(&tried, most, distance).iter().map(|t| t.score.near).collect::<Vec<_>>();
        assert_eq!(near(4, 0.05), [4.0, 2.0, 1.0]);
        assert_eq!(near(2, 0.05), [4.0, 2.0]);
        assert_eq!(near(4, 0.0).len(), 4);
    }

    #[test]
    fn identity_about_half_of_the_values_stay() {
        let place = even(3);
        let kept = |n| beside(&place, n, 0.2).iter().zip(place).filter(|(a, b)| **a == *b).count();
        let mean = (0..1000).map(kept).sum::<usize>() as f64 / 1000.0;
        assert!((mean / DIMENSIONS as f64 - 0.5).abs() < 0.05, "{mean}");
    }
    #[test]
    fn identity_the_result_has_a_line_for_each_set() {
        let set = |n: usize| Decided {
            tried: Tried { place: even(n), score: Score { met: 10, near: 8.5 } },
            score: Score { met: 9, near: 8.0 },
            counts: Counts { calibration: 15, validation: 20, tables: 20 },
        };
        let text = text(Searched::Classical, 500, &[set(1), set(2)]);
        let table = Table::read("result", &text).unwrap();
        assert_eq!((table.columns().len(), table.rows().count()), (8 + DIMENSIONS, 2));
        assert!(table.rows().all(|row| row.text("figures").unwrap() == "35"));
        assert!(text.contains("--reading classical") && text.contains("best of 500 sets"));
    }
}
