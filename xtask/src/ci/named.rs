//! Tests that documents name: each has to be there, so that a table of promises does not outlive what holds them.

use super::listed::listed;
use crate::error::Failure;
use std::collections::BTreeSet;
use tribodyn_paper::files;

/// Beginnings of the names of tests, by the kind of evidence.
const KINDS: [&str; 5] = ["limit_", "identity_", "paper_", "code_", "regress_"];

/// Names of tests in the pages of `docs` that no test has, each with its page and line.
pub fn missing() -> Result<Vec<String>, Failure> {
    let names = listed()?;
    let with_end = |end: &'static str| names.iter().filter(move |name| name.ends_with(end));
    let mut tests = BTreeSet::new();
    for name in with_end(".rs") {
        // A file that is deleted but not yet committed is listed too.
        let text = files::read(&files::root().join(name)).unwrap_or_default();
        tests.extend(defined(&text).map(str::to_owned));
    }
    let mut findings = Vec::new();
    for name in with_end(".md").filter(|name| name.starts_with("docs/")) {
        let text = files::read(&files::root().join(name)).unwrap_or_default();
        for (line, test) in named(&text).filter(|(_, test)| !tests.contains(*test)) {
            findings.push(format!("{name}:{line}: no test is called `{test}`"));
        }
    }
    Ok(findings)
}

/// Names of the functions of a text that are called as tests are.
fn defined(text: &str) -> impl Iterator<Item = &str> {
    let functions = text.lines().filter_map(|line| line.trim_start().strip_prefix("fn ")?.split('(').next());
    functions.filter(|name| is_test(name))
}

/// Lines, from 1, and names of tests in backticks.
fn named(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let quoted = |line| str::split(line, '`').skip(1).step_by(2).filter(|word| is_test(word));
    text.lines().enumerate().flat_map(move |(number, line)| quoted(line).map(move |word| (number + 1, word)))
}

fn is_test(word: &str) -> bool {
    let plain = |byte: u8| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_';
    word.bytes().all(plain) && KINDS.iter().any(|kind| word.starts_with(kind)) && word.matches('_').count() > 2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_every_test_that_a_page_names_is_there() {
        assert_eq!(missing().unwrap(), Vec::<String>::new());
    }

    #[test]
    fn limit_a_test_that_is_not_there_is_told_by_its_line() {
        let page = "text\n| `a` | `limit_no_such_test_at_all`, `limit_short` |\n";
        assert_eq!(named(page).collect::<Vec<_>>(), [(2, "limit_no_such_test_at_all")]);
        let code = "    #[test]\n    fn limit_one_of_the_tests() {\n    fn helper(x: u8) {\n";
        assert_eq!(defined(code).collect::<Vec<_>>(), ["limit_one_of_the_tests"]);
    }
}
