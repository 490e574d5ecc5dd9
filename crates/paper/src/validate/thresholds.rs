//! Words of the paper that have no number there: what turns when ours is another.

use super::row::{Row, Verdict};
use crate::table;

/// A limit of ours, and others that the word allows as well.
struct Limit {
    word: &'static str,
    ids: &'static [&'static str],
    /// Ours first.
    values: [f64; 3],
    kind: Kind,
}

/// Value that a limit applies to, and the side on which it has to be.
#[derive(Clone, Copy)]
enum Kind {
    /// The computed value, above it.
    Above,
    /// The computed value, below it.
    Below,
    /// The deviation from a published number, within this part of it.
    Share,
    /// The deviation from a published number, within this much.
    Within,
}

const LIMITS: [Limit; 5] = [
    Limit {
        word: "identical, %",
        ids: &["F14.1.load", "F14.1.angle", "F20.1.load", "F20.1.angle"],
        values: [1.0, 0.5, 2.0],
        kind: Kind::Below,
    },
    Limit {
        word: "clearly, well above, times",
        ids: &["F17.1", "F18.2", "F20.2.sides", "F21.1"],
        values: [1.5, 1.25, 2.0],
        kind: Kind::Above,
    },
    Limit {
        word: "mostly, share",
        ids: &["F18.3.cage", "F19.3.ag", "F19.3.ptfe"],
        values: [0.5, 0.4, 0.667],
        kind: Kind::Above,
    },
    Limit {
        word: "about, of an acceleration, share",
        ids: &["F13.2.amplitude", "F19.1.ag", "F19.1.ptfe"],
        values: [0.25, 0.15, 0.4],
        kind: Kind::Share,
    },
    Limit {
        word: "about, of an azimuth, degrees",
        ids: &["F22.3.25", "F22.3.50", "F22.3.75", "F22.3.100"],
        values: [10.0, 5.0, 15.0],
        kind: Kind::Within,
    },
];

/// A table of the limits and the rows that turn.
pub fn text(rows: &[Row]) -> String {
    let line = |limit: &Limit| {
        let [ours, strict_or_lax, other] = limit.values;
        vec![
            limit.word.to_owned(),
            ours.to_string(),
            format!("{strict_or_lax}: {}", turned(rows, limit, strict_or_lax)),
            format!("{other}: {}", turned(rows, limit, other)),
        ]
    };
    let lines: Vec<_> = LIMITS.iter().map(line).collect();
    table::markdown(&["word", "ours", "with", "with"], &lines)
}

fn turned(rows: &[Row], limit: &Limit, value: f64) -> String {
    let found = rows.iter().filter(|row| limit.ids.contains(&row.id.as_str())).filter_map(|row| {
        let met = met(row, limit.kind, value)?;
        (met != (row.verdict == Verdict::Met)).then(|| format!("{} {}", row.id, if met { "met" } else { "missed" }))
    });
    let found: Vec<String> = found.collect();
    if found.is_empty() { "no row turns".to_owned() } else { found.join(", ") }
}

fn met(row: &Row, kind: Kind, limit: f64) -> Option<bool> {
    let computed = row.computed?;
    Some(match kind {
        Kind::Above => computed > limit,
        Kind::Below => computed < limit,
        Kind::Share => row.deviation?.abs() <= limit * (computed - row.deviation?).abs(),
        Kind::Within => row.deviation?.abs() <= limit,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_only_rows_between_two_limits_turn() {
        let row = |computed| Row::number("F22.3.50".into(), String::new(), [290.0, computed, 10.0]);
        let azimuths = &LIMITS[4];
        assert_eq!(turned(&[row(283.0)], azimuths, 5.0), "F22.3.50 missed");
        assert_eq!(turned(&[row(283.0)], azimuths, 15.0), "no row turns");
        assert_eq!(turned(&[row(302.0)], azimuths, 15.0), "F22.3.50 met");
        let row = Row::number("F19.1.ag".into(), String::new(), [10.0, 12.0, 2.5]);
        assert_eq!(turned(&[row], &LIMITS[3], 0.15), "F19.1.ag missed");
    }
}
