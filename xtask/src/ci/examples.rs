//! The examples of the crates, run: each prints the number that its readers are promised.

use super::{Outcome, finish};
use crate::built;
use crate::error::Failure;
use std::process::Command;
use tribodyn_paper::files;

/// An example with a number that it prints.
struct Example {
    package: &'static str,
    name: &'static str,
    /// Beginning of the line that holds the number; the number follows.
    label: &'static str,
    expected: f64,
    /// Half a unit of the last digit printed, or a little more.
    tolerance: f64,
}

const EXAMPLES: [Example; 7] = [
    Example { package: "tribodyn-contact", name: "ball_on_race", label: "10000 N:", expected: 2.244, tolerance: 6e-4 },
    // NSK prints 19 500 N for the bearing 6206.
    Example { package: "tribodyn-rating", name: "deep_groove", label: "C_r", expected: 19456.0, tolerance: 0.6 },
    Example {
        package: "tribodyn-traction",
        name: "coating_patch",
        label: "slip 1 m/s:",
        expected: -753.0,
        tolerance: 0.6,
    },
    // Published: 5802 r/min (Zhang et al. 2025, Table 4); ours then: 5804.4.
    Example {
        package: "tribodyn-quasistatic",
        name: "paper_case",
        label: "cage speed",
        expected: 5804.4,
        tolerance: 0.6,
    },
    // The run starts from that equilibrium.
    Example {
        package: "tribodyn-dynamics",
        name: "short_run",
        label: "0.000000 s: cage",
        expected: 607.8,
        tolerance: 0.6,
    },
    // Our own: nothing is published of this bearing.
    Example { package: "tribodyn-dynamics", name: "without_case", label: "cage", expected: 616.9, tolerance: 0.06 },
    // Likewise.
    Example { package: "tribodyn", name: "angular_7210", label: "cage speed", expected: 4339.1, tolerance: 0.06 },
];

pub fn check() -> Result<Outcome, Failure> {
    let folder = built::programs()?.join("examples");
    let mut findings = Vec::new();
    for example in &EXAMPLES {
        let program = folder.join(example.name);
        let output = Command::new(&program)
            .current_dir(files::root())
            .output()
            .map_err(|source| Failure::Start { program: program.display().to_string(), source })?;
        if !output.status.success() {
            eprint!("{}", String::from_utf8_lossy(&output.stderr));
            findings.push(format!("{} of {}: {}", example.name, example.package, output.status));
            continue;
        }
        findings.extend(flaw(example, &String::from_utf8_lossy(&output.stdout)));
    }
    finish("examples", findings)
}

/// The difference between an example's printed number and the expected one, where there is any.
fn flaw(example: &Example, printed: &str) -> Option<String> {
    let Example { package, name, label, expected, tolerance } = example;
    let rest = printed.lines().find_map(|line| line.trim_start().strip_prefix(label));
    let number = rest.and_then(|rest| rest.split_whitespace().next()?.parse::<f64>().ok());
    match number {
        Some(number) if (number - expected).abs() <= *tolerance => None,
        Some(number) => Some(format!("{name} of {package}: {label} {number}, expected {expected} ± {tolerance}")),
        None => Some(format!("{name} of {package}: no line with `{label}` and a number")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_wrong_or_missing_number_is_found() {
        let example = &EXAMPLES[0];
        assert_eq!(flaw(example, "  5000 N: 1.8 GPa\n 10000 N: 2.2441 GPa\n"), None);
        assert!(flaw(example, " 10000 N: 2.246 GPa\n").unwrap().contains("2.246"));
        assert!(flaw(example, "  1000 N: 2.244 GPa\n").unwrap().contains("no line"));
    }
}
