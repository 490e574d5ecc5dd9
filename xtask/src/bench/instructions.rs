//! Instructions per point of a patch, which no other work on the machine changes: counted by valgrind where there is
//! one.

use super::row::Row;
use crate::built;
use crate::error::Failure;
use std::path::Path;
use std::process::Command;

const GROUP: &str = "instructions";
const EXAMPLE: &str = "kernel_instructions";
/// Repetitions of the three contacts in the example.
const REPEATS: &str = "100";

pub fn rows() -> Result<Vec<Row>, Failure> {
    if !has_counter() {
        return Ok(vec![Row::skipped(GROUP, "kernel", "not counted: there is no valgrind here")]);
    }
    let example = built::example("tribodyn-traction", EXAMPLE)?;
    let rules =
        [("midpoint", "10 × 40 midpoints"), ("jacobi", "Gauss–Jacobi 4 × 12"), ("strips", "split strips 8 × 3")];
    let kinds = [("generic", "generic"), ("fast", "fast"), ("derivative", "fast with derivatives")];
    let mut rows = Vec::new();
    for (rule, rule_name) in rules {
        for (kind, kind_name) in kinds {
            let quantity = format!("{rule_name}, {kind_name}");
            rows.push(match count(&example, &[kind, rule, REPEATS]) {
                Some(per_point) => Row::new(GROUP, quantity, per_point, "per point"),
                None => Row::skipped(GROUP, quantity, "valgrind gave no count"),
            });
        }
    }
    Ok(rows)
}

/// True where valgrind is there.
pub fn has_counter() -> bool {
    Command::new("valgrind").arg("--version").output().is_ok()
}

/// Instructions in what an example measures, over what it prints before its checksum.
pub fn count(example: &Path, arguments: &[&str]) -> Option<f64> {
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--toggle-collect=*measured*", "--callgrind-out-file=/dev/null"]);
    let output = command.arg(example).args(arguments).output().ok()?;
    per_unit(&String::from_utf8_lossy(&output.stdout), &String::from_utf8_lossy(&output.stderr))
}

/// `… N checksum …` of an example, `… Collected : I` of callgrind.
fn per_unit(printed: &str, counted: &str) -> Option<f64> {
    let units: f64 = printed.split(" checksum").next()?.rsplit(' ').next()?.parse().ok()?;
    let line = counted.lines().find(|line| line.contains("Collected"))?;
    let instructions: f64 = line.rsplit(':').next()?.trim().parse().ok()?;
    (units > 0.0 && instructions > 0.0).then(|| instructions / units)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_a_count_is_read_from_what_is_printed() {
        let counted = "==1== Events    : Ir\n==1== Collected : 30000\n==1==\n";
        assert_eq!(per_unit("nodes 1200 checksum 1e0", counted), Some(25.0));
    }

    #[test]
    fn limit_no_count_is_no_number() {
        assert_eq!(per_unit("nodes 1200 checksum 1e0", "==1== Collected : 0\n"), None);
        assert_eq!(per_unit("usage", "==1== Collected : 10\n"), None);
    }
}
