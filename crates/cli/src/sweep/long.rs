//! Sweeps that take longer than most people mean: they are begun when they are asked for twice.

use crate::failure::Failure;
use crate::table::number;

/// Rows beyond which a sweep is begun with `--yes` only.
const MANY: usize = 10_000_000;
/// Estimated time from which on it is, s.
const LONG_S: f64 = 86_400.0;
/// Rows from which on the time is estimated: a few rows are solved for it.
const WORTH_ESTIMATING: usize = 1000;

/// Refuses a sweep of so many rows, or of a time (s) that is estimated where they are not few.
pub fn check(rows: usize, estimate: impl FnOnce() -> f64) -> Result<(), Failure> {
    let refused = |why: String| {
        let message = format!("{why}: --plan says more, and --yes begins it");
        Err(Failure::Option { option: "set", value: format!("for {rows} rows"), message })
    };
    if rows > MANY {
        return refused(format!("this sweep has more than {MANY} rows"));
    }
    if rows < WORTH_ESTIMATING {
        return Ok(());
    }
    let seconds = estimate();
    if seconds >= LONG_S {
        return refused(format!("this sweep takes an estimated {} days", number(seconds / LONG_S, 1)));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::check;

    #[test]
    fn limit_long_sweeps_are_asked_for_twice() {
        assert!(check(999, || panic!("few rows are not estimated")).is_ok());
        assert!(check(1000, || 86_399.0).is_ok());
        let message = check(1000, || 2.5 * 86_400.0).unwrap_err().to_string();
        assert!(message.contains("2.5 days") && message.contains("--yes"), "{message}");
        let message = check(10_000_001, || panic!("the number alone is enough")).unwrap_err().to_string();
        assert!(message.contains("10000001 rows") && message.contains("--yes"), "{message}");
    }
}
