//! No more lines of warnings than a person reads.

/// Lines of warnings on a terminal or a page, the one that counts the rest included.
pub const MOST_LINES: usize = 12;

/// The lines that are shown: the first ones, and how many more there are.
pub fn shown(all: &[String]) -> Vec<String> {
    if all.len() <= MOST_LINES {
        return all.to_vec();
    }
    let kept = MOST_LINES - 1;
    let rest = format!("… and {} more warnings; --json has all of them", all.len() - kept);
    all[..kept].iter().cloned().chain([rest]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_no_more_lines_than_a_person_reads() {
        let many = |count: usize| (0..count).map(|k| k.to_string()).collect::<Vec<_>>();
        assert_eq!(shown(&many(12)).len(), 12);
        let lines = shown(&many(30));
        assert_eq!((lines.len(), lines[10].as_str()), (12, "10"));
        assert!(lines[11].contains("19 more"), "{lines:?}");
    }
}
