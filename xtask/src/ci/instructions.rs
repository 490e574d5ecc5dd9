//! Instructions of the vector loops, so that a change or a compiler that makes scalar ones of them is noticed. Counts
//! are those of valgrind, which no other work on the machine changes, in the profile of the tests.

use super::{Outcome, finish};
use crate::bench::instructions::{count, has_counter};
use crate::built;
use crate::error::Failure;

/// Example, its arguments, what one of its units is, and instructions for it with rustc 1.95.
type Counted = (&'static str, &'static [&'static str], &'static str, f64);

const KERNEL: &str = "kernel_instructions";
const COUNTED: [Counted; 7] = [
    (KERNEL, &["fast", "jacobi", "100"], "point of a patch, Gauss–Jacobi", 46.7),
    (KERNEL, &["fast", "strips", "100"], "point of a patch, split strips", 77.1),
    (KERNEL, &["derivative", "jacobi", "100"], "point with derivatives, Gauss–Jacobi", 182.9),
    (KERNEL, &["derivative", "strips", "100"], "point with derivatives, split strips", 195.5),
    (KERNEL, &["own", "jacobi", "100"], "point of a law of one's own, Gauss–Jacobi", 46.7),
    (KERNEL, &["own-derivative", "jacobi", "100"], "the same with derivatives", 218.0),
    ("step_instructions", &["10", "5"], "ball and step of the fast scheme", 7_090.0),
];
/// More of them than that is a failure.
const ALLOWANCE: f64 = 1.25;

pub fn check() -> Result<Outcome, Failure> {
    if !has_counter() {
        return Ok(Outcome::Skipped("there is no valgrind here".to_owned()));
    }
    if !has_wide_vectors() {
        return Ok(Outcome::Skipped("the counts are of vectors of AVX2".to_owned()));
    }
    let mut findings = Vec::new();
    let folder = built::programs()?.join("examples");
    for (example, arguments, unit, usual) in COUNTED {
        match count(&folder.join(example), arguments) {
            Some(found) if found <= ALLOWANCE * usual => println!("{found:.1} a {unit}, usual {usual}"),
            Some(found) => findings.push(format!("{found:.1} instructions a {unit}, usual {usual}")),
            None => findings.push(format!("valgrind gave no count for {example} {}", arguments.join(" "))),
        }
    }
    finish("instructions of vector loops", findings)
}

#[cfg(target_arch = "x86_64")]
fn has_wide_vectors() -> bool {
    std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
}

#[cfg(not(target_arch = "x86_64"))]
fn has_wide_vectors() -> bool {
    false
}
