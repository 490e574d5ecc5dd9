//! Claims of the paper of which only one can hold: one row for both, which nothing decides.

use super::row::{Row, Stated, Verdict};

/// A pair, its text, and what ours is said of in the note.
const PAIRS: [(&str, [&str; 2], &str); 2] = [
    (
        "F22.1",
        ["F22.1.text", "F22.1.conclusion"],
        "ring acceleration rises with axial load (section 5.2.2) and falls with it (conclusion 3)",
    ),
    (
        "F23.2",
        ["F23.2.text", "F23.2.fig24"],
        "peak ball–cage force grows with axial load (text on Fig. 23d) and falls with it (text on Fig. 24)",
    ),
];

/// The printed range of the orbital speed, which the printed mean lies outside, and the row of that contradiction.
const RANGE: [&str; 2] = ["F13.3.low", "F13.3.high"];
const RANGE_AND_MEAN: &str = "F13.3/T4.dyn";

/// The rows with each pair as one.
pub fn joined(mut rows: Vec<Row>) -> Vec<Row> {
    for (id, pair, text) in PAIRS {
        let Some((place, first, second)) = taken(&mut rows, pair) else { continue };
        let note = format!(
            "only one of the two can hold; ours: {} {} and {} {}; {}",
            first.quantity,
            first.computed_text(),
            second.quantity,
            second.computed_text(),
            first.note
        );
        let published = Stated::Text(text);
        let row = Row { id: id.to_owned(), published, verdict: Verdict::Contradictory, note, ..first };
        rows.insert(place, row);
    }
    let beside = rows.iter().any(|row| row.id == RANGE_AND_MEAN);
    if beside && let Some((_, low, high)) = taken(&mut rows, RANGE) {
        for row in rows.iter_mut().filter(|row| row.id == RANGE_AND_MEAN) {
            let off = format!("; from the range {} and {} r/min away", low.deviation_text(), high.deviation_text());
            row.note.push_str(&off);
        }
    }
    rows
}

/// Takes two rows out, where both were decided, and says where the first of them stood.
fn taken(rows: &mut Vec<Row>, ids: [&str; 2]) -> Option<(usize, Row, Row)> {
    let decided = |id: &str| {
        let open = [Verdict::Met, Verdict::Missed];
        rows.iter().position(|row| row.id == id && open.contains(&row.verdict))
    };
    let [Some(first), Some(second)] = ids.map(decided) else { return None };
    // The later one first, so that the other place stays.
    let (early, late) = (first.min(second), first.max(second));
    let (b, a) = (rows.remove(late), rows.remove(early));
    Some(if first < second { (early, a, b) } else { (early, b, a) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_a_pair_becomes_one_row_that_nothing_decides() {
        let row = |id: &str, computed: f64| Row::number(id.into(), "ratio".into(), [1.0, computed, 0.1]);
        let rows =
            vec![row("F22.1.text", 0.5), row("F22.1.conclusion", 1.7), row("F22.2", 1.0), row("F23.2.text", 1.0)];
        let found = joined(rows);
        let ids: Vec<_> = found.iter().map(|row| row.id.as_str()).collect();
        assert_eq!(ids, ["F22.1", "F22.2", "F23.2.text"]);
        assert_eq!(found[0].verdict, Verdict::Contradictory);
        assert!(found[0].note.contains("ratio 0.500 and ratio 1.700"), "{}", found[0].note);
        // The range goes into the row of its contradiction, where there is one.
        let range = |more: Vec<Row>| joined([vec![row("F13.3.low", 2.0), row("F13.3.high", 3.0)], more].concat());
        assert_eq!(range(Vec::new()).len(), 2);
        let found = range(vec![row("F13.3/T4.dyn", 1.0)]);
        assert!(found.len() == 1 && found[0].note.contains("+1.000 and +2.000"), "{}", found[0].note);
    }
}
