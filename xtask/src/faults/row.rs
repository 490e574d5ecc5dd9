//! Outcome of a fault: how often it was tried, how often it went as it should, and the worst that was measured.

use serde::Serialize;

/// Failures of a kind that are told one by one.
const TOLD: usize = 3;

/// A fault, tried many times.
#[derive(Debug, Clone, Serialize)]
pub struct Row {
    pub fault: &'static str,
    pub tried: usize,
    pub passed: usize,
    /// The worst that was measured, in words; empty where nothing was.
    pub worst: String,
    /// The reason where it could not be tried here.
    pub skipped: Option<String>,
    /// The first failures.
    pub failures: Vec<String>,
}

pub const HEAD: [&str; 5] = ["fault", "tried", "as it should be", "worst", "verdict"];

impl Row {
    pub fn new(fault: &'static str) -> Self {
        Self { fault, tried: 0, passed: 0, worst: String::new(), skipped: None, failures: Vec::new() }
    }

    pub fn skipped(fault: &'static str, reason: impl Into<String>) -> Self {
        Self { skipped: Some(reason.into()), ..Self::new(fault) }
    }

    /// Counts a trial and what it came to.
    pub fn count(&mut self, outcome: Result<(), String>) {
        self.tried += 1;
        match outcome {
            Ok(()) => self.passed += 1,
            Err(failure) if self.failures.len() < TOLD => self.failures.push(failure),
            Err(_) => {}
        }
    }

    pub fn failed(&self) -> bool {
        self.passed < self.tried
    }

    pub fn cells(&self) -> Vec<String> {
        let verdict = match &self.skipped {
            Some(reason) => format!("not tried: {reason}"),
            None if self.failed() => format!("FAILED {} times", self.tried - self.passed),
            None => "passed".to_owned(),
        };
        vec![self.fault.to_owned(), self.tried.to_string(), self.passed.to_string(), self.worst.clone(), verdict]
    }
}

/// Fails with a text unless something holds.
pub fn ensure(holds: bool, text: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(text()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_a_failure_is_counted_and_told() {
        let mut row = Row::new("kill");
        row.count(Ok(()));
        assert!(!row.failed());
        (0..5).for_each(|k| row.count(ensure(false, || format!("number {k}"))));
        assert!(row.failed() && row.failures.len() == TOLD && row.failures[0] == "number 0");
        assert_eq!(row.cells()[1..], ["6", "1", "", "FAILED 5 times"].map(str::to_owned));
        assert!(Row::skipped("clock", "no library").cells()[4].contains("no library"));
    }
}
